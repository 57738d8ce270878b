// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lengths of shortest paths against known lengths.

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Tufted_cover.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/shortest_path.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Vertex_index;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;
using Points = std::vector<std::array<double, 3>>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

constexpr double pi = 3.14159265358979323846;

Triangulation Delaunay(const Points& points, const Triangles& triangles)
{
  Triangulation result(IT::make_Delta_complex_from_triangles(points.size(), triangles), points);
  IT::flip_to_Delaunay(result);
  return result;
}

IT::Tufted_cover Delaunay_cover(const Points& points, const Triangles& triangles,
                                IT::Surface_cover kind = IT::Surface_cover::TUFTED)
{
  IT::Tufted_cover result = IT::make_tufted_cover(points, triangles, CGAL::parameters::surface_cover(kind));
  IT::flip_to_Delaunay(result.triangulation);
  return result;
}

auto with_tolerance(double tolerance) { return CGAL::parameters::tolerance(tolerance); }

double straight(const Points& points, std::size_t v, std::size_t w)
{
  const auto &p = points[v], &q = points[w];
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

// A plane regular polygon, cut from its first corner.
void make_polygon(std::uint32_t n, Points& points, Triangles& triangles)
{
  for (std::uint32_t i = 0; i < n; ++i)
    points.push_back({10 * std::cos(2 * pi * i / n), 10 * std::sin(2 * pi * i / n), 0});
  for (std::uint32_t i = 1; i + 1 < n; ++i)
    triangles.push_back({0, i, i + 1});
}

// Random heights on a grid: cones of positive and negative curvature, and a border.
void make_hills(std::uint32_t n, double height, Points& points, Triangles& triangles)
{
  std::mt19937 random(7);
  for (std::uint32_t y = 0; y <= n; ++y)
    for (std::uint32_t x = 0; x <= n; ++x)
      points.push_back({double(x), double(y), height * double(random() % 1024) / 1024});
  for (std::uint32_t y = 0; y < n; ++y)
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t v = y * (n + 1) + x;
      triangles.push_back({v, v + 1, v + n + 2});
      triangles.push_back({v, v + n + 2, v + n + 1});
    }
}

// The inner half has negative curvature.
void make_torus(std::uint32_t n, Points& points, Triangles& triangles)
{
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < n; ++j) {
      const double u = 2 * pi * i / n, v = 2 * pi * j / n, r = 2 + 0.8 * std::cos(v);
      points.push_back({r * std::cos(u), r * std::sin(u), 0.8 * std::sin(v)});
      const std::uint32_t a = i * n + j, b = i * n + (j + 1) % n, c = (i + 1) % n * n + j, d = c - j + (j + 1) % n;
      triangles.push_back({a, c, d});
      triangles.push_back({a, d, b});
    }
}

std::vector<double> exact_distances(const Points& points, const Triangles& triangles, std::uint32_t source)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  Mesh mesh;
  for (const auto& [x, y, z] : points)
    mesh.add_vertex({x, y, z});
  for (const auto& [a, b, c] : triangles)
    mesh.add_face(Mesh::Vertex_index(a), Mesh::Vertex_index(b), Mesh::Vertex_index(c));
  CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>> paths(mesh);
  paths.add_source_point(Mesh::Vertex_index(source));
  std::vector<double> result;
  for (Mesh::Vertex_index v : mesh.vertices())
    result.push_back(paths.shortest_distance_to_source_points(v).first);
  return result;
}

TEST(Geodesic_distances, in_a_polygon_without_inner_vertices)
{
  for (std::uint32_t n : {16, 64, 200}) {
    Points points;
    Triangles triangles;
    make_polygon(n, points, triangles);
    for (double tolerance : {0., 0.001}) {
      const auto on_triangulation =
        IT::geodesic_distances(Delaunay(points, triangles), {Vertex_index(3)}, with_tolerance(tolerance));
      const auto on_cover =
        IT::geodesic_distances(Delaunay_cover(points, triangles), {Vertex_index(3)}, with_tolerance(tolerance));
      EXPECT_TRUE(on_triangulation.is_complete);
      for (std::size_t v = 0; v < n; ++v)
        for (const auto* found : {&on_triangulation, &on_cover})
          EXPECT_NEAR(found->distances[v], straight(points, 3, v), tolerance > 0 ? 0.02 : 1e-11) << n << ' ' << v;
    }
  }
}

TEST(Geodesic_distances, are_those_of_Surface_mesh_shortest_path)
{
  for (double height : {0., 0.3, 3.}) {
    Points points;
    Triangles triangles;
    make_hills(12, height, points, triangles);
    for (std::uint32_t source : {0u, 80u}) {
      const std::vector<double> exact = exact_distances(points, triangles, source);
      const Triangulation triangulation = Delaunay(points, triangles);
      const auto found = IT::geodesic_distances(triangulation, {Vertex_index(source)}, with_tolerance(0));
      const auto on_cover =
        IT::geodesic_distances(Delaunay_cover(points, triangles), {Vertex_index(source)}, with_tolerance(0));
      const auto near = IT::geodesic_distances(triangulation, {Vertex_index(source)});
      EXPECT_LE(near.number_of_ways, found.number_of_ways);
      for (std::size_t v = 0; v < exact.size(); ++v) {
        EXPECT_NEAR(found.distances[v], exact[v], 1e-10 * exact[v]) << height << ' ' << source << ' ' << v;
        EXPECT_NEAR(on_cover.distances[v], exact[v], 1e-10 * exact[v]);
        EXPECT_NEAR(near.distances[v], exact[v], 0.01 * exact[v]);
      }
    }
  }
}

TEST(Geodesic_distances, need_fewer_ways_for_each_face_if_faces_are_finer)
{
  double before = 0;
  for (std::uint32_t n : {50, 200}) {
    Points points;
    Triangles triangles;
    make_torus(n, points, triangles);
    const Triangulation triangulation = Delaunay(points, triangles);
    const auto found = IT::geodesic_distances(triangulation, {Vertex_index(0)});
    EXPECT_TRUE(found.is_complete);
    const double ways = double(found.number_of_ways) / double(triangles.size());
    if (n == 50) {
      const auto exact = IT::geodesic_distances(triangulation, {Vertex_index(0)}, with_tolerance(0));
      EXPECT_LT(2 * found.number_of_ways, exact.number_of_ways);
      for (std::size_t v = 0; v < points.size(); ++v)
        EXPECT_NEAR(found.distances[v], exact.distances[v], 0.003 * exact.distances[v]) << v;
      before = ways;
    } else {
      EXPECT_LT(ways, 6); // windows that do not wait for each other: 11
      EXPECT_LT(ways, before);
    }
  }
}

// Behind each vertex of a bowl, ways that passed it on the left and on the right cover the same points.
TEST(Geodesic_distances, need_few_ways_in_a_bowl_also_if_they_are_exact)
{
  Points points;
  Triangles triangles;
  make_hills(30, 0, points, triangles);
  for (auto& [x, y, z] : points)
    z = ((x - 15) * (x - 15) + (y - 15) * (y - 15)) / 30;
  const std::vector<double> exact = exact_distances(points, triangles, 0);
  const auto found = IT::geodesic_distances(Delaunay(points, triangles), {Vertex_index(0)}, with_tolerance(0));
  for (std::size_t v = 0; v < exact.size(); ++v)
    EXPECT_NEAR(found.distances[v], exact[v], 1e-13 * exact[v]) << v;
  EXPECT_LT(found.number_of_ways, 18 * triangles.size()); // if all of them go on: 20.7
}

// A hub in the middle of a border that waves: paths bend at it again and again.
void make_fan(std::uint32_t n, Points& points, Triangles& triangles)
{
  points = {{0, 0, 0.5}};
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * pi * i / n;
    points.push_back({std::cos(angle), std::sin(angle), 0.1 * std::sin(7 * angle)});
    triangles.push_back({0, 1 + i, 1 + (i + 1) % n});
  }
}

TEST(Geodesic_distances, need_few_ways_in_a_fan)
{
  Points points;
  Triangles triangles;
  make_fan(90, points, triangles);
  const std::vector<double> exact = exact_distances(points, triangles, 5);
  const auto found = IT::geodesic_distances(Delaunay(points, triangles), {Vertex_index(5)}, with_tolerance(0));
  for (std::size_t v = 0; v < exact.size(); ++v)
    EXPECT_NEAR(found.distances[v], exact[v], 1e-10 * exact[v]) << v;
  for (std::uint32_t n : {1000, 4000}) {
    triangles.clear();
    make_fan(n, points, triangles);
    const auto large = IT::geodesic_distances(Delaunay(points, triangles), {Vertex_index(5)}, with_tolerance(0));
    EXPECT_TRUE(large.is_complete);
    EXPECT_LT(large.number_of_ways, 20 * n); // going on before the shortest way is known: 150 n
  }
}

// Ways into the shadow of a straight border would be as wide as rounding errors, and run through the whole strip.
TEST(Geodesic_distances, need_few_ways_along_a_straight_border)
{
  std::mt19937 random(1);
  Points points{{0, 0, 0}, {0, 1, 0}};
  Triangles triangles;
  for (std::uint32_t i = 0; i < 500; ++i) {
    points.push_back({points[2 * i][0] + 0x1p-32 * random() / 500, 0, 0});
    points.push_back({points[2 * i + 1][0] + 0x1p-32 * random() / 500, 1, 0});
    triangles.push_back({2 * i, 2 * i + 2, 2 * i + 1});
    triangles.push_back({2 * i + 1, 2 * i + 2, 2 * i + 3});
  }
  const auto found = IT::geodesic_distances(Delaunay(points, triangles), {Vertex_index(4)}, with_tolerance(0));
  for (std::size_t v = 0; v < points.size(); ++v)
    EXPECT_NEAR(found.distances[v], straight(points, 4, v), 1e-11) << v;
  EXPECT_LT(found.number_of_ways, 3 * triangles.size()); // with these ways: 133 for each
}

TEST(Geodesic_distances, depend_on_nothing_elsewhere)
{
  Points points;
  Triangles triangles;
  make_hills(6, 1, points, triangles);
  const auto alone = IT::geodesic_distances(Delaunay(points, triangles), {Vertex_index(0), Vertex_index(5)});
  const std::size_t n = points.size();
  for (const auto& p : Points{{1000, 0, 0}, {3000, 0, 0}, {1000, 2000, 0}})
    points.push_back(p);
  triangles.push_back({std::uint32_t(n), std::uint32_t(n + 1), std::uint32_t(n + 2)});
  const auto together = IT::geodesic_distances(Delaunay(points, triangles), {Vertex_index(0), Vertex_index(5)});
  for (std::size_t v = 0; v < n; ++v) {
    EXPECT_EQ(together.distances[v], alone.distances[v]);
    EXPECT_EQ(alone.distances[v] == 0, v == 0 || v == 5);
  }
  for (std::size_t v = n; v < n + 3; ++v)
    EXPECT_EQ(together.distances[v], std::numeric_limits<double>::infinity());
}

// The same surface with other numbers of vertices and faces. \return the new number of each vertex
std::vector<std::uint32_t> renumber(unsigned seed, Points& points, Triangles& triangles)
{
  std::mt19937 random(seed);
  std::vector<std::uint32_t> number(points.size());
  std::iota(number.begin(), number.end(), 0);
  std::shuffle(number.begin(), number.end(), random);
  const Points before = points;
  for (std::size_t v = 0; v < before.size(); ++v)
    points[number[v]] = before[v];
  std::shuffle(triangles.begin(), triangles.end(), random);
  for (auto& t : triangles) {
    for (std::uint32_t& v : t)
      v = number[v];
    std::rotate(t.begin(), t.begin() + random() % 3, t.end());
  }
  return number;
}

// Many ways are equally long, many windows equally far, and not all ties between Delaunay edges are in the input.
TEST(Geodesic_distances, depend_on_no_numbers)
{
  std::vector<samples::Indexed_triangles> surfaces{samples::latitude_longitude_sphere(48, 24),
                                                   samples::sheared_grid(30, 20, 3), samples::bad_torus(24, 24),
                                                   samples::random_diagonal_grid(16, 16), samples::pillow(20)};
  samples::Indexed_triangles& hills = surfaces.emplace_back();
  make_hills(12, 1, hills.points, hills.triangles);
  for (const samples::Indexed_triangles& surface : surfaces)
    for (unsigned seed : {1, 2, 3}) {
      const Points& points = surface.points;
      const Triangles& triangles = surface.triangles;
      Points other_points = points;
      Triangles other_triangles = triangles;
      const std::vector<std::uint32_t> number = renumber(seed, other_points, other_triangles);
      const std::vector<Vertex_index> sources{Vertex_index(7), Vertex_index(11)},
        others{Vertex_index(number[7]), Vertex_index(number[11])};
      const auto expect_same = [&](const auto& one, const auto& other) {
        const std::vector<double> distances = IT::geodesic_distances(one, sources).distances,
                                  found = IT::geodesic_distances(other, others).distances;
        const double largest = *std::max_element(distances.begin(), distances.end());
        for (std::size_t v = 0; v < points.size(); ++v)
          EXPECT_NEAR(found[number[v]], distances[v], 1e-12 * largest) << seed << ' ' << v;
      };
      expect_same(Delaunay(points, triangles), Delaunay(other_points, other_triangles));
      expect_same(Delaunay_cover(points, triangles), Delaunay_cover(other_points, other_triangles));
    }
}

// Pages of n × n squares at a spine, which turn to either side by chance. \return the distance from the spine of each
// vertex, and its height along the spine
std::vector<std::array<double, 2>> make_book(std::uint32_t pages, std::uint32_t n, double width, Points& points,
                                             Triangles& triangles, std::vector<std::uint32_t>& page_of)
{
  std::mt19937 random(3);
  std::vector<std::array<double, 2>> flat;
  const auto add = [&](std::uint32_t page, double r, double z) {
    const double angle = 2 * pi * page / pages;
    points.push_back({r * std::cos(angle), r * std::sin(angle), z});
    flat.push_back({r, z});
    page_of.push_back(page);
  };
  for (std::uint32_t j = 0; j <= n; ++j)
    add(0, 0, double(j) / n);
  for (std::uint32_t page = 0; page < pages; ++page) {
    for (std::uint32_t i = 1; i <= n; ++i)
      for (std::uint32_t j = 0; j <= n; ++j)
        add(page, width * (i + (i < n ? double(random() % 64) / 128 : 0)) / n, double(j) / n);
    const auto at = [&](std::uint32_t i, std::uint32_t j) { return i == 0 ? j : (page * n + i) * (n + 1) + j; };
    for (std::uint32_t i = 0; i < n; ++i)
      for (std::uint32_t j = 0; j < n; ++j) {
        triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        for (std::size_t k = triangles.size() - 2; k < triangles.size(); ++k)
          if (random() % 2 == 0)
            std::swap(triangles[k][0], triangles[k][1]);
      }
  }
  return flat;
}

TEST(Geodesic_distances, cross_a_spine_to_all_pages)
{
  for (std::uint32_t pages : {3, 4, 5, 8})
    for (double width : {1., 0.01}) {
      Points points;
      Triangles triangles;
      std::vector<std::uint32_t> page_of;
      const auto flat = make_book(pages, 4, width, points, triangles, page_of);
      const IT::Tufted_cover cover = Delaunay_cover(points, triangles, IT::Surface_cover::SHEETS);
      EXPECT_TRUE(cover.is_cut);
      for (double tolerance : {0., 0.001})
        for (std::uint32_t source = 0; source < points.size(); ++source) {
          const auto found = IT::geodesic_distances(cover, {Vertex_index(source)}, with_tolerance(tolerance));
          EXPECT_TRUE(found.is_complete);
          for (std::size_t v = 0; v < points.size(); ++v) {
            const double sign = page_of[v] == page_of[source] ? -1 : 1,
                         exact = std::hypot(flat[v][0] + sign * flat[source][0], flat[v][1] - flat[source][1]);
            EXPECT_NEAR(found.distances[v], exact, (tolerance > 0 ? 1e-3 : 1e-12) * exact)
              << pages << ' ' << source << ' ' << v;
          }
        }
    }
}

// Unit squares of a grid, by chance, cut along either diagonal and turned to either side: up to four meet at an edge.
void make_soup(std::uint32_t seed, Points& points, Triangles& triangles)
{
  constexpr std::uint32_t n = 3;
  std::mt19937 random(seed);
  for (std::uint32_t i = 0; i < n * n * n; ++i)
    points.push_back({double(i % n), double(i / n % n), double(i / n / n)});
  const std::array<std::uint32_t, 3> step{1, n, n * n};
  for (std::uint32_t v = 0; v < points.size(); ++v)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::uint32_t a = step[(axis + 1) % 3], b = step[(axis + 2) % 3];
      if (points[v][(axis + 1) % 3] == n - 1 || points[v][(axis + 2) % 3] == n - 1 || random() % 8 < 3)
        continue;
      std::array<std::uint32_t, 4> corners{v, v + a, v + a + b, v + b};
      std::rotate(corners.begin(), corners.begin() + random() % 2, corners.end());
      if (random() % 2 == 0)
        std::reverse(corners.begin(), corners.end());
      triangles.push_back({corners[0], corners[1], corners[2]});
      triangles.push_back({corners[0], corners[2], corners[3]});
    }
}

// The lengths of the shortest ways over some points on the edges, straight within the faces.
std::vector<double> lengths_over_edge_points(const Points& points, const Triangles& triangles, std::uint32_t source)
{
  constexpr int parts = 12;
  std::map<std::array<std::uint32_t, 3>, std::uint32_t> number; // ends of an edge, and the place on it
  Points places = points;
  std::vector<std::vector<std::uint32_t>> faces;
  for (const auto& t : triangles) {
    faces.emplace_back(t.begin(), t.end());
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [v, w] = std::minmax(t[i], t[(i + 1) % 3]);
      for (std::uint32_t k = 1; k < parts; ++k) {
        const auto [found, is_new] = number.insert({{v, w, k}, std::uint32_t(places.size())});
        if (is_new) {
          std::array<double, 3> p;
          for (std::size_t c = 0; c < 3; ++c)
            p[c] = points[v][c] + (points[w][c] - points[v][c]) * k / parts;
          places.push_back(p);
        }
        faces.back().push_back(found->second);
      }
    }
  }
  std::vector<std::vector<std::size_t>> faces_at(places.size());
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (std::uint32_t v : faces[f])
      faces_at[v].push_back(f);
  std::vector<double> result(places.size(), std::numeric_limits<double>::infinity());
  std::set<std::pair<double, std::uint32_t>> queue{{0, source}};
  result[source] = 0;
  while (!queue.empty()) {
    const auto [length, v] = *queue.begin();
    queue.erase(queue.begin());
    for (std::size_t f : faces_at[v])
      for (std::uint32_t w : faces[f])
        if (const double other = length + straight(places, v, w); other < result[w]) {
          queue.erase({result[w], w});
          result[w] = other;
          queue.insert({other, w});
        }
  }
  result.resize(points.size());
  return result;
}

// Ways may reach an edge from several faces, and there is always a way over points on the edges.
TEST(Geodesic_distances, exceed_no_way_where_many_faces_meet)
{
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    Points points;
    Triangles triangles;
    make_soup(seed, points, triangles);
    const IT::Tufted_cover cover = Delaunay_cover(points, triangles, IT::Surface_cover::SHEETS);
    for (std::uint32_t source : {triangles[0][0], triangles.back()[2]}) {
      const std::vector<double> longer = lengths_over_edge_points(points, triangles, source);
      for (double tolerance : {0., 0.001}) {
        const auto found = IT::geodesic_distances(cover, {Vertex_index(source)}, with_tolerance(tolerance));
        EXPECT_TRUE(found.is_complete);
        for (std::size_t v = 0; v < points.size(); ++v)
          if (longer[v] < std::numeric_limits<double>::infinity()) {
            EXPECT_LE(found.distances[v], longer[v] * (1 + (tolerance > 0 ? 1e-3 : 1e-12))) << seed << ' ' << v;
          }
      }
    }
  }
}

// Its double cover has the same distances.
TEST(Geodesic_distances, on_a_band_with_one_side)
{
  Points points;
  Triangles triangles;
  constexpr std::uint32_t n = 15;
  for (std::uint32_t i = 0; i < n; ++i)
    for (double s : {-0.2, 0.3}) {
      const double angle = 2 * pi * i / n, r = 1 + s * std::cos(angle / 2);
      points.push_back({r * std::cos(angle), r * std::sin(angle), s * std::sin(angle / 2)});
    }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t a = 2 * i, b = a + 1, c = i + 1 < n ? a + 2 : 1, d = i + 1 < n ? a + 3 : 0;
    triangles.push_back({a, c, d});
    triangles.push_back({b, a, d});
  }
  const auto distances = [&](IT::Surface_cover kind) {
    const auto found =
      IT::geodesic_distances(Delaunay_cover(points, triangles, kind), {Vertex_index(9)}, with_tolerance(0));
    EXPECT_TRUE(found.is_complete);
    return found.distances;
  };
  const std::vector<double> on_sheets = distances(IT::Surface_cover::SHEETS),
                            on_cover = distances(IT::Surface_cover::TUFTED);
  for (std::size_t v = 0; v < points.size(); ++v)
    EXPECT_NEAR(on_sheets[v], on_cover[v], 1e-12) << v;
}

// Ways would wind around a tube as often as it is thinner than long.
TEST(Geodesic_distances, do_not_wind_around_slivers)
{
  for (int e = 1; e <= 12; ++e) {
    const double h = std::pow(10., -e);
    const Points points{{0, 0, 0}, {2, 0, 0}, {1, h, 0}, {1, 0, h}, {0.5, -h, 0}, {1.5, h, h}};
    // One at the border, two, a closed one, five at an edge, and a closed one with a wall in it.
    for (const Triangles& triangles :
         {Triangles{{0, 1, 2}}, Triangles{{0, 1, 2}, {1, 0, 3}}, Triangles{{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}},
          Triangles{{0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {0, 1, 5}},
          Triangles{{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}, {0, 4, 2}, {4, 1, 2}, {0, 5, 4}, {5, 1, 4}, {0, 3, 4}}})
      for (IT::Surface_cover kind : {IT::Surface_cover::SHEETS, IT::Surface_cover::TUFTED})
        for (double tolerance : {0., 0.001}) {
          const auto found = IT::geodesic_distances(Delaunay_cover(points, triangles, kind), {Vertex_index(0)},
                                                    with_tolerance(tolerance));
          EXPECT_TRUE(found.is_complete);
          EXPECT_LT(found.number_of_ways, 100 * triangles.size()) << e << ' ' << triangles.size();
          EXPECT_NEAR(found.distances[1], 2, 1e-14);
          EXPECT_NEAR(found.distances[2], straight(points, 0, 2), 1e-14);
        }
  }
}

TEST(Geodesic_distances, do_not_climb_needles)
{
  constexpr std::uint32_t n = 5; // squares in a row, each with a needle in its middle
  for (int e = 2; e <= 10; ++e) {
    const double width = std::pow(10., -e);
    Points points;
    Triangles triangles;
    for (std::uint32_t y = 0; y <= n; ++y)
      for (std::uint32_t x = 0; x <= n; ++x)
        points.push_back({double(x), double(y), 0});
    for (std::uint32_t y = 0; y < n; ++y)
      for (std::uint32_t x = 0; x < n; ++x) {
        const std::uint32_t v = y * (n + 1) + x, first = std::uint32_t(points.size());
        const std::array<std::uint32_t, 4> square{v, v + 1, v + n + 2, v + n + 1};
        for (int i = 0; i < 4; ++i) {
          const double angle = pi / 2 * i + 0.1 * x - 2;
          points.push_back({x + 0.5 + width * std::cos(angle), y + 0.5 + width * std::sin(angle), 0});
        }
        points.push_back({x + 0.5, y + 0.5, 1});
        for (std::uint32_t i = 0; i < 4; ++i) {
          const std::uint32_t j = (i + 1) % 4, p = first + i, q = first + j;
          triangles.push_back({square[i], square[j], p});
          triangles.push_back({square[j], q, p});
          triangles.push_back({p, q, first + 4});
        }
      }
    const Triangulation triangulation = Delaunay(points, triangles);
    for (double tolerance : {0., 0.001}) {
      const auto found = IT::geodesic_distances(triangulation, {Vertex_index(1)}, with_tolerance(tolerance));
      EXPECT_TRUE(found.is_complete);
      EXPECT_LT(found.number_of_ways, 30 * triangles.size()) << e;
      for (std::size_t v = 0; v < points.size(); ++v) { // around each needle, or along it
        const double up = points[v][2], exact = std::hypot(points[v][0] - 1, points[v][1]) + up;
        EXPECT_GE(found.distances[v], exact - 2 * width - 1e-12) << e << ' ' << v;
        EXPECT_LE(found.distances[v], exact + (2 * n + 2) * width + tolerance * exact + 1e-12) << e << ' ' << v;
      }
    }
  }
}

// Its square has two bits.
TEST(Geodesic_distances, over_an_edge_that_is_nearly_nothing)
{
  const Points points{{0, 0, 0}, {2e-162, 0, 0}, {0, 1, 0}, {-1, -1, 0.5}};
  const Triangles triangles{{0, 1, 2}, {1, 0, 3}};
  EXPECT_DOUBLE_EQ(IT::geodesic_distances(Delaunay(points, triangles), {Vertex_index(0)}).distances[1], 2e-162);
}

// Two faces on an edge, from both sides, whose third corners are at one place beside it: there the surface has an edge
// shorter than rounding. Distances are those with one vertex there.
TEST(Geodesic_distances, beside_needles_thinner_than_rounding)
{
  const Points points{{0, 0, 0.76812043597273227},
                      {1, 0, 0.25402713049860204},
                      {2, 0, 0.1865818574574763},
                      {0, 1, 0.1170165956704997},
                      {0.85733458288936415, 0.99740622552767322, 0.46498334740505948},
                      {2, 1, 0.75716847757482297},
                      {0, 2, 0.58830421500402641},
                      {1, 2, 0.38438685565570818},
                      {2, 2, 0.29835897649965609},
                      {0.305809211076149, 0.99907480680130911, 0.24113551021381741},
                      {0.305809211076149, 0.99907480680130911, 0.24113551021381741}};
  Triangles triangles{{0, 1, 4}, {1, 2, 4}, {2, 5, 4},  {3, 7, 6},  {4, 5, 7}, {3, 0, 9},
                      {0, 4, 9}, {7, 5, 8}, {4, 7, 10}, {7, 3, 10}, {4, 3, 9}, {3, 4, 10}};
  const Triangulation needles = Delaunay(points, triangles);
  triangles.resize(10);
  for (auto& t : triangles)
    std::replace(t.begin(), t.end(), std::uint32_t(10), std::uint32_t(9));
  const Triangulation without = Delaunay(Points(points.begin(), points.end() - 1), triangles);
  for (std::uint32_t v = 0; v < 10; ++v) {
    const auto np = CGAL::parameters::tolerance(0.);
    const std::vector<double> found = IT::geodesic_distances(needles, {Vertex_index(v)}, np).distances,
                              expected = IT::geodesic_distances(without, {Vertex_index(v)}, np).distances;
    for (std::size_t w = 0; w < 10; ++w)
      EXPECT_NEAR(found[w], expected[w], 1e-14) << v << ' ' << w;
  }
}

TEST(Geodesic_distances, stay_between_line_and_edges_if_the_budget_ends)
{
  Points points;
  Triangles triangles;
  make_polygon(64, points, triangles);
  const auto found =
    IT::geodesic_distances(Delaunay(points, triangles), {Vertex_index(20)}, CGAL::parameters::maximum_number(100));
  EXPECT_FALSE(found.is_complete);
  for (std::size_t v = 0; v < points.size(); ++v) {
    EXPECT_GE(found.distances[v], straight(points, 20, v) * (1 - 1e-15));
    EXPECT_LE(found.distances[v], (straight(points, 20, 0) + straight(points, 0, v)) * (1 + 1e-15));
  }
}

TEST(Geodesic_distances, bad_input)
{
  Points points;
  Triangles triangles;
  make_polygon(5, points, triangles);
  const Triangulation triangulation = Delaunay(points, triangles);
  EXPECT_THROW(IT::geodesic_distances(triangulation, {Vertex_index(5)}), IT::Invalid_argument_error);
  EXPECT_THROW(IT::geodesic_distances(triangulation, {Vertex_index(0)}, with_tolerance(-1)),
               IT::Invalid_argument_error);
  EXPECT_THROW(IT::geodesic_distances(triangulation, {Vertex_index(0)}, with_tolerance(std::nan(""))),
               IT::Invalid_argument_error);
  for (double d : IT::geodesic_distances(triangulation, {}).distances)
    EXPECT_EQ(d, std::numeric_limits<double>::infinity());
}

} // namespace
