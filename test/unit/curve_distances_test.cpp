// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances from points, curves and regions, and between sets of vertices.

#include "curve_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Tufted_cover.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/geodesic_distance_matrix.h>
#include <CGAL/Intrinsic_triangulations/geodesic_distances.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/sides_of_curve.h>
#include <CGAL/Intrinsic_triangulations/Surface_with_barriers.h>
#include <CGAL/Intrinsic_triangulations/shortest_path_on_triangles.h>
#include <CGAL/Intrinsic_triangulations/trace_geodesic.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace curve_surfaces;
namespace IT = CGAL::Intrinsic_triangulations;
using IT::Face_index;
using IT::Halfedge_index;
using IT::Surface_point;
using IT::Vertex_index;
constexpr double pi = 3.14159265358979323846;

auto with_tolerance(double tolerance) { return CGAL::parameters::tolerance(tolerance); }

IT::Geodesic_source from(const std::vector<Curve>& parts, double offset = 0) { return {parts, offset}; }

double to_segment(const Point& p, const Point& a, const Point& b)
{
  double square = 0, product = 0;
  for (int i = 0; i < 3; ++i) {
    square += (b[i] - a[i]) * (b[i] - a[i]);
    product += (p[i] - a[i]) * (b[i] - a[i]);
  }
  const double at = square > 0 ? (std::min)((std::max)(product / square, 0.), 1.) : 0;
  double result = 0;
  for (int i = 0; i < 3; ++i)
    result += std::pow(p[i] - a[i] - at * (b[i] - a[i]), 2);
  return std::sqrt(result);
}

// The straight distance in space.
double to_source(const Mesh& mesh, const Triangulation& triangulation, const Point& p,
                 const IT::Geodesic_source& source)
{
  double result = std::numeric_limits<double>::infinity();
  for (const Curve& part : source.parts)
    for (std::size_t i = 0; i < part.size(); ++i) {
      const Point a = IT::point_in_space(triangulation.input(), mesh.points, part[i]),
                  b = IT::point_in_space(triangulation.input(), mesh.points, part[(std::min)(i + 1, part.size() - 1)]);
      result = (std::min)(result, source.offset + to_segment(p, a, b));
    }
  return result;
}

void expect_plane_distances(const Mesh& mesh, const std::vector<IT::Geodesic_source>& sources, const std::string& name)
{
  const Triangulation triangulation = mesh.Delaunay();
  for (double tolerance : {0., 0.001}) {
    const auto found = IT::geodesic_distances_from(triangulation, sources, with_tolerance(tolerance));
    EXPECT_TRUE(found.is_complete);
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      std::vector<double> distances;
      for (const IT::Geodesic_source& source : sources)
        distances.push_back(to_source(mesh, triangulation, mesh.points[v], source));
      const double nearest = *std::min_element(distances.begin(), distances.end());
      EXPECT_NEAR(found.distances[v], nearest, tolerance == 0 ? 1e-13 * 30 : 1e-3 * 30) << name << ' ' << v;
      EXPECT_NEAR(distances.at(found.nearest_sources[v]), nearest, 0.02) << name << ' ' << v;
    }
  }
}

TEST(Curve_distances, in_a_plane)
{
  const Mesh mesh = shaken_plane(20, 20);
  const Triangulation triangulation = mesh.Delaunay();
  const IT::Delta_complex& input = triangulation.input();
  const Halfedge_index h = input.halfedge(Face_index(300)), across = input.opposite(h), k = input.next(h),
                       beyond = input.opposite(k), g = input.halfedge(Face_index(511));
  const Curve zigzag{{h, {0.2, 0.3, 0.5}}, {h, {0.6, 0.3, 0.1}}, {h, {0.1, 0.8, 0.1}}};
  expect_plane_distances(mesh, {from({{{h, {0.2, 0.3, 0.5}}}})}, "point");
  expect_plane_distances(mesh, {from({{{h, {0.5, 0.5, 0}}}})}, "point on an edge");
  expect_plane_distances(mesh, {from({{{h, {0, 1, 0}}}})}, "vertex");
  expect_plane_distances(mesh, {from({zigzag})}, "turns in a face");
  expect_plane_distances(mesh, {from({{zigzag[0], zigzag[1], zigzag[2], zigzag[0]}})}, "closed");
  expect_plane_distances(mesh, {from({{zigzag[0], zigzag[1], zigzag[0]}})}, "there and back");
  expect_plane_distances(mesh, {from({{zigzag[0], {across, {0.5, 0.5, 0}}, {across, {0.1, 0.1, 0.8}}}})},
                         "bends at an edge");
  expect_plane_distances(mesh, {from({{{h, {1, 0, 0}}, {h, {0, 1, 0}}}})}, "edge");
  expect_plane_distances(mesh, {from({{{h, {0.5, 0.5, 0}}, {h, {0.2, 0.2, 0.6}}}})}, "begins on an edge");
  expect_plane_distances(mesh, {from({{{h, {1, 0, 0}}, {beyond, {0.3, 0.7, 0}}, {beyond, {0, 0.3, 0.7}}}})},
                         "from a vertex to an edge");
  expect_plane_distances(mesh, {from({line(triangulation, Vertex_index(110), 1, 5.3)})}, "straight over many faces");
  expect_plane_distances(
    mesh, {from({line(triangulation, Vertex_index(110), 1, 9), line(triangulation, Vertex_index(300), 4, 11)})},
    "two that cross");
  expect_plane_distances(mesh, {from({zigzag}), from({{{g, {0.1, 0.1, 0.8}}}}, 2.5), from({{{g, {1, 0, 0}}}}, 0.125)},
                         "offsets");
  // A chain of edges.
  Curve chain;
  Halfedge_index along = h;
  for (int i = 0; i < 6; ++i, along = input.next(input.opposite(input.next(along))))
    chain.push_back({along, {1, 0, 0}});
  expect_plane_distances(mesh, {from({chain})}, "edges");
}

// The distance from the border of a region is that from its edges, also where vertices are far apart.
// Fronts of a farther source cover nothing of a nearer one at the vertex where both begin.
TEST(Curve_distances, from_two_curves_at_a_vertex_with_different_offsets)
{
  const Mesh mesh = shaken_plane(6, 6);
  const Triangulation triangulation = mesh.Delaunay();
  const Vertex_index v(24); // in the middle
  const IT::Geodesic_source near = from({line(triangulation, v, 0.3, 1.5)}),
                            far = from({line(triangulation, v, 2.5, 1.5)}, 1);
  const auto exact = [&](const std::vector<IT::Geodesic_source>& sources) {
    return IT::geodesic_distances_from(triangulation, sources, with_tolerance(0)).distances;
  };
  const std::vector<double> from_near = exact({near}), from_far = exact({far});
  for (const auto& sources :
       {std::vector<IT::Geodesic_source>{near, far}, std::vector<IT::Geodesic_source>{far, near}}) {
    const std::vector<double> found = exact(sources);
    for (std::size_t w = 0; w < found.size(); ++w)
      EXPECT_NEAR(found[w], (std::min)(from_near[w], from_far[w]), 1e-12) << w;
  }
}

TEST(Curve_distances, from_a_side_and_from_a_region)
{
  const Mesh strip = grid(1, 4, [](double x, double y) -> Point { return {10 * x, y / 4, 0}; });
  const Triangulation triangulation = strip.Delaunay();
  const IT::Delta_complex& input = triangulation.input();
  for (double tolerance : {0., 0.001}) {
    const auto found = IT::geodesic_distances_from(
      triangulation, {IT::source_of_region(input, {Face_index(0), Face_index(1)})}, with_tolerance(tolerance));
    for (std::size_t v = 0; v < strip.points.size(); ++v)
      EXPECT_NEAR(found.distances[v], (std::max)(0., strip.points[v][1] - 0.25), 1e-14);
  }
  const auto from_vertex =
    IT::geodesic_distances_from(triangulation, {IT::source_at_vertex(input, Vertex_index(0))}, with_tolerance(0));
  EXPECT_EQ(from_vertex.distances,
            IT::geodesic_distances(triangulation, {Vertex_index(0)}, with_tolerance(0)).distances);
}

TEST(Curve_distances, on_a_folded_strip_and_a_cylinder)
{
  // Sharp folds along the columns do not change distances.
  const Mesh flat = shaken_plane(12, 5);
  Mesh folded = flat;
  folded.points.clear();
  std::mt19937 random(5);
  folded = grid(12, 5, [](double x, double y) -> Point {
    return {x / 2, y, std::fmod(x, 2) < 0.5 ? 0 : std::sqrt(0.75)};
  });
  const Triangulation triangulation = folded.Delaunay();
  const IT::Delta_complex& input = triangulation.input();
  const auto found = IT::geodesic_distances_from(
    triangulation, {IT::source_at_edge(input, input.edge(input.next(input.halfedge(Face_index(0)))))},
    with_tolerance(0));
  const Halfedge_index e = input.next(input.halfedge(Face_index(0))); // from (1, 0) to (1, 1)
  ASSERT_EQ(input.source(e), Vertex_index(1));
  for (std::uint32_t v = 0; v < folded.points.size(); ++v)
    EXPECT_NEAR(found.distances[v], to_segment({double(v % 13), double(v / 13), 0}, {1, 0, 0}, {1, 1, 0}), 1e-13) << v;
  // A prism of 9 sides, from a circle and from a line along it.
  const std::uint32_t n = 9, rows = 6;
  Mesh prism;
  for (std::uint32_t y = 0; y <= rows; ++y)
    for (std::uint32_t i = 0; i < n; ++i)
      prism.points.push_back({std::cos(2 * pi * i / n), std::sin(2 * pi * i / n), double(y)});
  for (std::uint32_t y = 0; y < rows; ++y)
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = y * n + i, b = y * n + (i + 1) % n;
      prism.triangles.push_back({a, b, b + n});
      prism.triangles.push_back({a, b + n, a + n});
    }
  const Triangulation around = prism.Delaunay();
  const IT::Delta_complex& complex = around.input();
  IT::Geodesic_source circle, upright;
  for (IT::Edge_index edge : complex.edges()) {
    const std::uint32_t v = complex.source(complex.halfedge(edge)).idx(),
                        w = complex.target(complex.halfedge(edge)).idx();
    if (v / n == 2 && w / n == 2)
      circle.parts.push_back(IT::source_at_edge(complex, edge).parts.front());
    if (v % n == 0 && w % n == 0)
      upright.parts.push_back(IT::source_at_edge(complex, edge).parts.front());
  }
  const auto from_circle = IT::geodesic_distances_from(around, {circle}, with_tolerance(0)),
             from_line = IT::geodesic_distances_from(around, {upright}, with_tolerance(0));
  for (std::uint32_t v = 0; v < prism.points.size(); ++v) {
    EXPECT_NEAR(from_circle.distances[v], std::abs(double(v / n) - 2), 1e-13);
    EXPECT_NEAR(from_line.distances[v], (std::min)(v % n, n - v % n) * 2 * std::sin(pi / n), 1e-13);
  }
}

TEST(Curve_distances, on_a_cube)
{
  Mesh cube;
  for (std::uint32_t i = 0; i < 8; ++i)
    cube.points.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2)});
  for (const auto& q : std::vector<std::array<std::uint32_t, 4>>{
         {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    cube.triangles.push_back({q[0], q[1], q[2]});
    cube.triangles.push_back({q[0], q[2], q[3]});
  }
  const Triangulation triangulation = cube.Delaunay();
  const IT::Delta_complex& input = triangulation.input();
  for (IT::Edge_index e : input.edges()) {
    const Halfedge_index h = input.halfedge(e);
    if (input.source(h).idx() + input.target(h).idx() != 1)
      continue;
    const auto found = IT::geodesic_distances_from(triangulation, {IT::source_at_edge(input, e)}, with_tolerance(0));
    const std::array<double, 8> expected{0, 0, 1, 1, 1, 1, std::sqrt(2.), std::sqrt(2.)};
    for (std::size_t v = 0; v < 8; ++v)
      EXPECT_NEAR(found.distances[v], expected[v], 1e-15);
  }
}

// Cones of n faces with the given angle at the tip. From a piece of a ray, which may end at the tip.
TEST(Curve_distances, on_cones)
{
  const double angle = 0.7;
  for (std::uint32_t n : {3, 5, 8, 9, 12, 40}) {
    for (double start : {0., 0.5, 1.}) {
      // By lengths: the tip, and rays with vertices at 1 and 2.
      const std::uint32_t tip = 2 * n;
      Triangles triangles;
      std::vector<double> lengths;
      const double at_1 = 2 * std::sin(angle / 2), across = std::sqrt(5 - 4 * std::cos(angle));
      for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t j = (i + 1) % n;
        triangles.push_back({tip, i, j});
        triangles.push_back({i, n + i, n + j});
        triangles.push_back({i, n + j, j});
      }
      const IT::Delta_complex complex = IT::make_Delta_complex_from_triangles(2 * n + 1, triangles);
      lengths.resize(complex.number_of_edges());
      for (IT::Edge_index e : complex.edges()) {
        const auto h = complex.halfedge(e);
        const auto [v, w] = std::minmax({complex.source(h).idx(), complex.target(h).idx()});
        lengths[e.idx()] = w == tip || v + n == w ? 1 : w < n ? at_1 : v >= n ? 2 * at_1 : across;
      }
      auto triangulation = Triangulation::from_lengths(complex, lengths);
      IT::flip_to_Delaunay(triangulation);
      // On the ray of vertex 0, from `start` to 2.
      IT::Geodesic_source source;
      for (Halfedge_index h : complex.halfedges())
        if (!complex.is_border(h) && complex.source(h).idx() == tip && complex.target(h).idx() == 0 && start < 1)
          source.parts.push_back({{h, {1 - start, start, 0}}, {h, {0, 1, 0}}});
        else if (!complex.is_border(h) && complex.source(h).idx() == 0 && complex.target(h).idx() == n)
          source.parts.push_back({{h, {1, 0, 0}}, {h, {0, 1, 0}}});
      const auto found = IT::geodesic_distances_from(triangulation, {source}, with_tolerance(0));
      const auto near = IT::geodesic_distances_from(triangulation, {source});
      for (std::uint32_t v = 0; v <= tip; ++v) {
        const double r = v == tip ? 0 : v < n ? 1 : 2, turn = angle * (std::min)(v % n, n - v % n);
        const double expected = v == tip || turn >= pi
                                  ? start + r
                                  : to_segment({r * std::cos(turn), r * std::sin(turn), 0}, {start, 0, 0}, {2, 0, 0});
        // Beyond the border of a cone the way may not be straight: only those that stay inside are compared.
        if (v == tip || v < n || turn == 0) {
          EXPECT_NEAR(found.distances[v], expected, 1e-14) << n << ' ' << start << ' ' << v;
          EXPECT_NEAR(near.distances[v], expected, 2e-3) << n << ' ' << start << ' ' << v;
        }
      }
    }
  }
}

// A curve that shrinks gives the distances of a point. Points nearer than 10⁻¹¹ of their distance count as one.
TEST(Curve_distances, of_a_very_short_curve)
{
  const Mesh mesh = hills(10, 2);
  const Triangulation triangulation = mesh.Delaunay();
  const Halfedge_index h = triangulation.input().halfedge(Face_index(77));
  const Surface_point p{h, {0.25, 0.25, 0.5}};
  const auto point = IT::geodesic_distances_from(triangulation, {from({{p}})}, with_tolerance(0)),
             twice = IT::geodesic_distances_from(triangulation, {from({{p, p}})}, with_tolerance(0));
  EXPECT_EQ(point.distances, twice.distances);
  for (double size : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15}) {
    const auto curve = IT::geodesic_distances_from(triangulation, {from({{p, {h, {0.25 + size, 0.25 - size, 0.5}}}})},
                                                   with_tolerance(0));
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      EXPECT_LE(curve.distances[v], point.distances[v] + 1e-12) << size;
      EXPECT_GE(curve.distances[v], point.distances[v] - 4 * size - 1e-12) << size;
    }
  }
}

// Random lines over hills: points on them, ever more, have distances that fall to those of the line; distances grow by
// no more than the length of an edge along it, and are not shorter than the straight line.
TEST(Curve_distances, are_the_limit_of_those_from_ever_more_points)
{
  std::mt19937 random(11);
  for (double height : {0., 1., 3.}) {
    const Mesh mesh = hills(12, height);
    const Triangulation triangulation = mesh.Delaunay();
    const IT::Delta_complex& input = triangulation.input();
    for (int round = 0; round < 4; ++round) {
      const Curve curve = line(triangulation, Vertex_index(14 + 13 * (random() % 11) + random() % 11),
                               double(random() % 628) / 100, 5 + round);
      const IT::Geodesic_source source = from({curve});
      const auto found = IT::geodesic_distances_from(triangulation, {source}, with_tolerance(0)),
                 near = IT::geodesic_distances_from(triangulation, {source});
      EXPECT_TRUE(found.is_complete && near.is_complete);
      double largest = std::numeric_limits<double>::infinity();
      for (int n : {1, 8, 64}) {
        IT::Geodesic_source points;
        for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
          const Halfedge_index h = curve[i].halfedge;
          std::array<double, 3> a = curve[i].coordinates, b{0, 0, 0};
          // The next point in the same face.
          const Surface_point& q = curve[i + 1];
          const std::array<Halfedge_index, 3> sides{h, input.next(h), input.prev(h)};
          for (int c = 0; c < 3; ++c)
            for (int d = 0; d < 3; ++d) {
              const std::array<Vertex_index, 3> corners{input.source(q.halfedge), input.target(q.halfedge),
                                                        input.target(input.next(q.halfedge))};
              if (q.coordinates[std::size_t(d)] > 0 && corners[std::size_t(d)] == input.source(sides[std::size_t(c)]))
                b[std::size_t(c)] = q.coordinates[std::size_t(d)];
            }
          for (int j = 0; j <= n; ++j) {
            const double t = double(j) / n;
            points.parts.push_back(
              {{h, {(1 - t) * a[0] + t * b[0], (1 - t) * a[1] + t * b[1], (1 - t) * a[2] + t * b[2]}}});
          }
        }
        const auto sampled = IT::geodesic_distances_from(triangulation, {points}, with_tolerance(0));
        double difference = 0;
        for (std::size_t v = 0; v < mesh.points.size(); ++v) {
          EXPECT_GE(sampled.distances[v], found.distances[v] - 1e-12) << height << ' ' << round << ' ' << n << ' ' << v;
          difference = (std::max)(difference, sampled.distances[v] - found.distances[v]);
        }
        EXPECT_LT(difference, largest);
        largest = difference;
      }
      EXPECT_LT(largest, 0.03);
      for (IT::Edge_index e : input.edges()) {
        const auto v = input.source(input.halfedge(e)).idx(), w = input.target(input.halfedge(e)).idx();
        const Point &p = mesh.points[v], &q = mesh.points[w];
        EXPECT_LE(std::abs(found.distances[v] - found.distances[w]),
                  std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) + 1e-12);
      }
      for (std::size_t v = 0; v < mesh.points.size(); ++v) {
        const double straight = to_source(mesh, triangulation, mesh.points[v], source);
        EXPECT_GE(found.distances[v], straight - 1e-12);
        EXPECT_NEAR(near.distances[v], found.distances[v], 0.005 * found.distances[v] + 1e-12);
        EXPECT_EQ(found.distances[v] < 1e-12, straight < 1e-12) << v;
      }
    }
  }
}

// Three pages at a spine: a curve on one of them, and one that ends on the spine.
TEST(Curve_distances, cross_a_spine_to_all_pages)
{
  Points points;
  Triangles triangles;
  const std::uint32_t n = 6;
  for (std::uint32_t i = 0; i <= n; ++i)
    points.push_back({0, 0, double(i)});
  for (std::uint32_t page = 0; page < 3; ++page)
    for (std::uint32_t i = 0; i <= n; ++i)
      points.push_back({std::cos(2 * page), std::sin(2 * page), double(i)});
  for (std::uint32_t page = 1; page <= 3; ++page)
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = i, b = page * (n + 1) + i;
      triangles.push_back({a, b, b + 1});
      triangles.push_back({a, b + 1, a + 1});
    }
  IT::Tufted_cover cover =
    IT::make_tufted_cover(points, triangles, CGAL::parameters::surface_cover(IT::Surface_cover::SHEETS));
  IT::flip_to_Delaunay(cover.triangulation);
  const auto at = [&](std::size_t triangle, const std::array<double, 3>& coordinates) {
    return IT::sources_on_cover(cover, triangles, {{{triangle, coordinates}}}).front().parts.front().front();
  };
  // Triangle 5 lies between 2 and 3 on the spine: from the middle of that edge outward.
  const auto found =
    IT::geodesic_distances_from(cover, {from({{at(5, {0.5, 0, 0.5}), at(5, {0.25, 0.5, 0.25})}})}, with_tolerance(0));
  for (std::uint32_t v = 0; v < points.size(); ++v) {
    const double z = points[v][2], x = v <= n ? 0 : v <= 2 * n + 1 ? 1 : -1; // page 0, or another one
    EXPECT_NEAR(found.distances[v], to_segment({x, 0, z}, {0, 0, 2.5}, {0.5, 0, 2.75}), 1e-14) << v;
  }
  EXPECT_THROW(at(1000, {1, 0, 0}), IT::Invalid_point_error);
}

// A straight line over the first two pages, which are one plane, as is each of them with the third one.
TEST(Curve_distances, lead_from_page_to_page)
{
  const std::uint32_t n = 6;
  Points points;
  Triangles triangles;
  for (std::uint32_t z = 0; z <= n; ++z)
    points.push_back({0, 0, double(z)});
  for (std::uint32_t page = 0; page < 3; ++page)
    for (std::uint32_t r = 1; r <= n; ++r)
      for (std::uint32_t z = 0; z <= n; ++z)
        points.push_back({r * std::cos(2 * page), r * std::sin(2 * page), double(z)});
  const auto at = [](std::uint32_t page, std::uint32_t r, std::uint32_t z) {
    return r == 0 ? z : (page * n + r) * (n + 1) + z;
  };
  std::mt19937 random(5);
  for (std::uint32_t page = 0; page < 3; ++page)
    for (std::uint32_t r = 0; r < n; ++r)
      for (std::uint32_t z = 0; z < n; ++z)
        for (std::array<std::uint32_t, 3> t :
             {std::array{at(page, r, z), at(page, r + 1, z), at(page, r + 1, z + 1)},
              std::array{at(page, r, z), at(page, r + 1, z + 1), at(page, r, z + 1)}}) {
          if (random() % 2 == 0)
            std::swap(t[0], t[1]);
          triangles.push_back(t);
        }
  const auto in_plane = [&](const IT::Point_in_triangle& p) -> Point {
    double r = 0, z = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point& corner = points[triangles[p.triangle][k]];
      r += p.coordinates[k] * std::hypot(corner[0], corner[1]);
      z += p.coordinates[k] * corner[2];
    }
    return {r, 0, z};
  };
  IT::Tufted_cover cover =
    IT::make_tufted_cover(points, triangles, CGAL::parameters::surface_cover(IT::Surface_cover::SHEETS));
  IT::flip_to_Delaunay(cover.triangulation);
  for (int i = 0; i < 20; ++i) {
    // The last two begin at a vertex, and on the spine.
    const IT::Point_in_triangle from_page{std::size_t(random() % (2 * n * n)),
                                          i == 18 ? Point{1, 0, 0} : Point{0.2, 0.3, 0.5}},
      to_page{std::size_t(2 * n * n + random() % (2 * n * n)), {0.1, 0.1, 0.8}};
    const IT::Path_on_triangles path =
      IT::shortest_path_on_triangles(points, triangles, std::vector<IT::Point_in_triangle>{from_page, to_page});
    const Point a = in_plane(from_page), b = in_plane(to_page);
    EXPECT_TRUE(path.is_complete);
    EXPECT_NEAR(path.length, std::hypot(a[0] + b[0], a[2] - b[2]), 1e-13);
    const double part = a[0] / (a[0] + b[0]);
    const Point crossing{0, 0, a[2] + part * (b[2] - a[2])};
    const std::vector<IT::Geodesic_source> sources = IT::sources_on_cover(cover, triangles, {path.points});
    const auto found = IT::geodesic_distances_from(cover, sources, with_tolerance(0));
    for (std::uint32_t v = 0; v < points.size(); ++v) {
      const double r = std::hypot(points[v][0], points[v][1]), z = points[v][2];
      const std::uint32_t page = v <= n ? 0 : (v - n - 1) / (n * (n + 1));
      const double to_first = to_segment({page == 0 ? r : -r, 0, z}, a, crossing),
                   to_second = to_segment({page == 1 ? r : -r, 0, z}, b, crossing);
      EXPECT_NEAR(found.distances[v], (std::min)(to_first, to_second), 1e-13) << v;
    }
  }
  // A point that is not in the triangle before.
  try {
    IT::sources_on_cover(cover, triangles, {{{0, {1, 1, 1}}, {2 * n * n + 40, {1, 1, 1}}}});
    FAIL();
  } catch (const IT::Invalid_point_error& error) {
    EXPECT_NE(std::string(error.what()).find("triangle " + std::to_string(2 * n * n + 40)), std::string::npos);
  }
}

TEST(Curve_distances, points_of_triangles_that_were_cut_or_turned)
{
  // The first face has zero area: the next two are cut, one of them on two sides. The last one disagrees.
  const std::vector<std::array<double, 3>> points{{0, 0, 0}, {4, 0, 0}, {1, 0, 0}, {3, 0, 0},
                                                  {2, 2, 0}, {3, 1, 0}, {2, -2, 1}};
  const std::vector<std::array<std::uint32_t, 3>> triangles{{0, 1, 2}, {2, 1, 3}, {1, 4, 5},
                                                            {0, 1, 4}, {1, 0, 6}, {4, 0, 6}};
  const auto position = [&](std::size_t t, const std::array<double, 3>& at) {
    Point result{0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t x = 0; x < 3; ++x)
        result[x] += at[i] * points[triangles[t][i]][x];
    return result;
  };
  const auto apart = [](const Point& p, const Point& q) { return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]); };
  for (const IT::Surface_cover kind : {IT::Surface_cover::SHEETS, IT::Surface_cover::TUFTED}) {
    IT::Tufted_cover cover = IT::make_tufted_cover(points, triangles, CGAL::parameters::surface_cover(kind));
    IT::flip_to_Delaunay(cover.triangulation);
    const IT::Delta_complex& input = cover.triangulation.input();
    std::vector<std::array<double, 3>> of_cover;
    for (const std::uint32_t v : cover.vertex_of)
      of_cover.push_back(points[v]);
    std::vector<std::array<double, 3>> all;
    for (int i = 0; i <= 8; ++i)
      for (int k = 0; i + k <= 8; ++k)
        all.push_back({i / 8., k / 8., (8 - i - k) / 8.});
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (const auto& at : all) {
        const Surface_point p = IT::sources_on_cover(cover, triangles, {{{t, at}}}).front().parts.front().front();
        if (t >= 3) {
          EXPECT_EQ(cover.face_of[input.face(p.halfedge).idx()], t);
        }
        EXPECT_GE(*std::min_element(p.coordinates.begin(), p.coordinates.end()), 0);
        EXPECT_NEAR(apart(IT::point_in_space(input, of_cover, p), position(t, at)), 0, 1e-14);
      }
    // Curves cross the cuts.
    for (std::size_t t = 3; t < triangles.size(); ++t)
      for (std::size_t n = 0; n < 300; ++n) {
        const auto &from_place = all[7 * n % all.size()], &to_place = all[11 * n % all.size()];
        const Curve curve =
          IT::sources_on_cover(cover, triangles, {{{t, from_place}, {t, to_place}}}).front().parts.front();
        double length = 0;
        for (std::size_t i = 0; i + 1 < curve.size(); ++i)
          length +=
            apart(IT::point_in_space(input, of_cover, curve[i]), IT::point_in_space(input, of_cover, curve[i + 1]));
        EXPECT_NEAR(length, apart(position(t, from_place), position(t, to_place)), 1e-14);
        EXPECT_NEAR(apart(IT::point_in_space(input, of_cover, curve.back()), position(t, to_place)), 0, 1e-14);
        EXPECT_NO_THROW(IT::geodesic_distances_from(cover, {from({curve})})) << t << ' ' << n;
      }
  }
  // Faces that name a corner twice, or two at one place, say nothing about others.
  const Points corners{{1, 1, 1}, {2, 2, 1}, {1, 0, 1}, {2, 1, 0}, {1, 2, 1}, {0, 0, 1}, {1, 2, 1}, {2, 2, 1}};
  const Triangles repeating{{1, 7, 6}, {2, 5, 6}, {1, 2, 1}, {3, 7, 3}, {2, 7, 3}, {0, 5, 6}, {3, 7, 0}, {6, 2, 6}};
  IT::Tufted_cover sheets =
    IT::make_tufted_cover(corners, repeating, CGAL::parameters::surface_cover(IT::Surface_cover::SHEETS));
  IT::flip_to_Delaunay(sheets.triangulation);
  EXPECT_EQ(IT::geodesic_distances_from(sheets, IT::sources_on_cover(sheets, repeating, {{{3, {1, 0, 1}}}})).distances,
            IT::geodesic_distances(sheets, {Vertex_index(3)}).distances);
  EXPECT_EQ(IT::geodesic_distances_from(sheets, IT::sources_on_cover(sheets, repeating, {{{0, {0, 1, 0}}}})).distances,
            IT::geodesic_distances(sheets, {Vertex_index(7)}).distances);
  EXPECT_THROW(
    IT::sources_on_cover(IT::make_tufted_cover(points, std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {1, 4, 3}}),
                         {{0, 1, 2}, {1, 4, 3}}, {{{0, {0.5, 0.25, 0.25}}}}),
    IT::Invalid_point_error);
}

// A flip of the two faces of one triangle makes a face that meets itself.
TEST(Curve_distances, across_a_face_that_meets_itself)
{
  const Points points{{0, 0, 0}, {1, 0, 0}, {0.5, 0.25, 0}};
  const Triangles triangles{{2, 0, 1}, {0, 1, 2}};
  IT::Tufted_cover cover =
    IT::make_tufted_cover(points, triangles, CGAL::parameters::surface_cover(IT::Surface_cover::SHEETS));
  IT::flip_to_Delaunay(cover.triangulation);
  std::mt19937 random(2);
  for (int i = 0; i < 200; ++i) {
    std::vector<IT::Point_in_triangle> curve;
    for (int k = 0; k < 3; ++k) {
      const double a = double(random() % 64), b = double(random() % 64), c = double(random() % 64);
      curve.push_back({1, {1 + a, k == 1 ? 1 + b : b, k == i % 3 ? 0 : 1 + c}});
    }
    const auto found =
      IT::geodesic_distances_from(cover, IT::sources_on_cover(cover, triangles, {curve}), with_tolerance(0));
    std::vector<Point> places;
    for (const auto& [t, c] : curve)
      places.push_back({(c[1] + c[2] * 0.5) / (c[0] + c[1] + c[2]), c[2] * 0.25 / (c[0] + c[1] + c[2]), 0});
    for (std::uint32_t v = 0; v < 3; ++v)
      EXPECT_NEAR(found.distances[v],
                  (std::min)(to_segment(points[v], places[0], places[1]), to_segment(points[v], places[1], places[2])),
                  1e-12)
        << i << ' ' << v;
  }
}

// So they may be given in either of the two faces.
TEST(Curve_distances, points_near_edges_lie_on_them)
{
  const Mesh mesh = shaken_plane(8, 8);
  const Triangulation triangulation = mesh.Delaunay();
  const IT::Delta_complex& input = triangulation.input();
  Curve curve = line(triangulation, Vertex_index(20), 1, 4.3);
  const auto expected = IT::geodesic_distances_from(triangulation, {from({curve})}, with_tolerance(0)).distances;
  for (std::size_t i = 0; i < curve.size(); ++i)
    for (double& x : curve[i].coordinates)
      if (x == 0 && curve[i].dimension() == 1) {
        x = 3e-13 / double(i + 1);
        break;
      }
  const auto near = IT::geodesic_distances_from(triangulation, {from({curve})}, with_tolerance(0)).distances;
  const IT::Surface_with_barriers whole(input, mesh.points, {});
  const auto on_cut = IT::geodesic_distances_from(whole, {from({curve})}, with_tolerance(0)).distances;
  for (std::size_t v = 0; v < expected.size(); ++v) {
    EXPECT_NEAR(near[v], expected[v], 1e-11) << v;
    EXPECT_NEAR(on_cut[v], expected[v], 1e-11) << v;
  }
}

TEST(Curve_distances, bad_input)
{
  const Mesh mesh = shaken_plane(4, 4);
  const Triangulation triangulation = mesh.Delaunay();
  const IT::Delta_complex& input = triangulation.input();
  const Halfedge_index h = input.halfedge(Face_index(3)), far = input.halfedge(Face_index(20));
  const auto find = [&](const IT::Geodesic_source& source) { IT::geodesic_distances_from(triangulation, {source}); };
  EXPECT_THROW(find(from({{{h, {1, -1, 1}}}})), IT::Invalid_point_error);
  EXPECT_THROW(find(from({{{h, {0, 0, 0}}}})), IT::Invalid_point_error);
  EXPECT_THROW(find(from({{{h, {std::nan(""), 0, 1}}}})), IT::Invalid_point_error);
  EXPECT_THROW(find(from({{{Halfedge_index(100000), {0, 0, 1}}}})), IT::Invalid_point_error);
  EXPECT_THROW(find(from({{{h, {0.2, 0.3, 0.5}}, {far, {0.2, 0.3, 0.5}}}})), IT::Invalid_point_error);
  EXPECT_THROW(find(from({{{h, {1, 0, 0}}}}, -1)), IT::Invalid_argument_error);
  EXPECT_THROW(find(from({{{h, {1, 0, 0}}}}, std::nan(""))), IT::Invalid_argument_error);
  EXPECT_THROW(IT::source_at_vertex(input, Vertex_index(1000)), IT::Invalid_argument_error);
  EXPECT_THROW(IT::source_of_region(input, {Face_index(1000)}), IT::Invalid_argument_error);
  const auto nowhere = IT::geodesic_distances_from(triangulation, std::vector<IT::Geodesic_source>());
  EXPECT_TRUE(std::isinf(nowhere.distances.front()));
}

TEST(Sides_of_curve, are_those_of_the_plane)
{
  const Mesh mesh = shaken_plane(6, 6);
  const Triangulation triangulation = mesh.Delaunay();
  const IT::Delta_complex& input = triangulation.input();
  // Inside a face, clockwise or counterclockwise.
  const Halfedge_index h = input.halfedge(Face_index(30));
  Curve curve{{h, {0.6, 0.2, 0.2}}, {h, {0.2, 0.6, 0.2}}, {h, {0.2, 0.2, 0.6}}, {h, {0.6, 0.2, 0.2}}};
  for (CGAL::Sign outside : {CGAL::NEGATIVE, CGAL::POSITIVE}) {
    for (CGAL::Sign side : IT::sides_of_curve(input, {curve}))
      EXPECT_EQ(side, outside);
    std::reverse(curve.begin(), curve.end());
  }
  curve.pop_back();
  EXPECT_THROW(IT::sides_of_curve(input, {curve}), IT::Invalid_argument_error);
  // A point, and a curve along the border, cut nothing off.
  EXPECT_THROW(IT::sides_of_curve(input, {{curve[0], curve[0]}}), IT::Invalid_argument_error);
  for (Halfedge_index k : input.halfedges())
    if (!input.is_border(k) && input.is_border(input.opposite(k))) {
      EXPECT_THROW(IT::sides_of_curve(input, {{{k, {1, 0, 0}}, {k, {0, 1, 0}}}}), IT::Invalid_argument_error);
      EXPECT_THROW(IT::sides_of_curve(input, {{{k, {0, 1, 0}}, {k, {1, 0, 0}}}}), IT::Invalid_argument_error);
    }
  // Along edges, from border to border.
  Curve column;
  for (std::uint32_t y = 0; y < 6; ++y)
    for (Halfedge_index k : input.halfedges())
      if (!input.is_border(k) && input.source(k).idx() == 7 * y + 3 && input.target(k).idx() == 7 * y + 10)
        for (double at : {1., 0.})
          if (at == 1 || y == 5)
            column.push_back({k, {at, 1 - at, 0}});
  const auto sides = IT::sides_of_curve(input, {column});
  for (std::uint32_t v = 0; v < sides.size(); ++v)
    EXPECT_EQ(sides[v], v % 7 == 3 ? CGAL::ZERO : v % 7 < 3 ? CGAL::POSITIVE : CGAL::NEGATIVE) << v;
}

TEST(Sides_of_curve, of_two_circles_that_separate_a_torus_together)
{
  const auto vertex = [](std::uint32_t i, std::uint32_t j) { return i % 6 * 4 + j % 4; };
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::uint32_t i = 0; i < 6; ++i)
    for (std::uint32_t j = 0; j < 4; ++j) {
      triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  const IT::Delta_complex input = IT::make_Delta_complex_from_triangles(24, triangles);
  const auto circle = [&](std::uint32_t i, std::uint32_t step) {
    Curve result;
    for (std::uint32_t n = 0, j = 0; n < 4; ++n, j += step)
      for (Halfedge_index h : input.halfedges())
        if (input.source(h).idx() == vertex(i, j) && input.target(h).idx() == vertex(i, j + step)) {
          result.push_back({h, {1, 0, 0}});
          if (n == 3)
            result.push_back({h, {0, 1, 0}});
        }
    return result;
  };
  const auto sides = IT::sides_of_curve(input, {circle(1, 1), circle(4, 3)});
  for (std::uint32_t v = 0; v < 24; ++v)
    EXPECT_EQ(sides[v], v / 4 % 3 == 1 ? CGAL::ZERO : v / 4 == 2 || v / 4 == 3 ? CGAL::NEGATIVE : CGAL::POSITIVE) << v;
  const auto message = [&](const std::vector<Curve>& parts) -> std::string {
    try {
      IT::sides_of_curve(input, parts);
    } catch (const IT::Invalid_argument_error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(message({circle(1, 1)}).find("the curve does not separate"), std::string::npos);
  EXPECT_NE(message({circle(1, 1), circle(4, 1)}).find("reverse one"), std::string::npos);
  // A third one, which is a segment only, is at fault alone.
  const Curve circle_3 = circle(3, 1), segment(circle_3.begin(), circle_3.begin() + 2);
  EXPECT_EQ(message({circle(1, 1), circle(4, 3), segment}).find("curve 2 (counted from 0) does not separate"), 0u);
}

// Two triangles over the unit square, (0, 0, 0) to (1, 1, 0), and points of the lower right and the upper left one.
struct Square
{
  const Mesh mesh = grid(1, 1, [](double x, double y) -> Point { return {x, y, 0}; });
  const IT::Delta_complex input = IT::make_Delta_complex_from_triangles(4, mesh.triangles);

  IT::Surface_point at(double x, double y) const { return at(x, y, x < y); }
  IT::Surface_point at(double x, double y, bool is_in_upper_left) const
  {
    const Halfedge_index h = input.halfedge(Face_index(is_in_upper_left ? 1 : 0));
    std::array<double, 3> result;
    for (std::size_t i = 0; i < 3; ++i) {
      const Halfedge_index k = i == 0 ? h : i == 1 ? input.next(h) : input.prev(h);
      const Point& corner = mesh.points[input.source(k).idx()];
      result[i] = corner[0] == corner[1] ? (corner[0] == 0 ? 1 - (std::max)(x, y) : (std::min)(x, y)) : std::abs(x - y);
    }
    return {h, result};
  }
  Curve curve(const std::vector<std::array<double, 2>>& places) const
  {
    Curve result;
    for (std::size_t i = 0; i < places.size(); ++i) { // a point of the diagonal lies in the face of the next one
      const auto [x, y] = places[i];
      const auto [to_x, to_y] = places[x == y && i + 1 < places.size() ? i + 1 : i];
      result.push_back(at(x, y, to_x < to_y));
    }
    return result;
  }
};

TEST(Sides_of_curve, of_many_points_in_a_face)
{
  const Square square;
  std::mt19937 random(5);
  const auto uniform = [&random](double low, double high) {
    return low + (high - low) * double(random() % 4096) / 4096;
  };
  const double pi = std::acos(-1.);
  for (std::size_t n : {3, 4, 10, 300}) { // a star around (0.7, 0.3)
    std::vector<std::array<double, 2>> corners;
    for (std::size_t i = 0; i < n; ++i) {
      const double angle = 2 * pi * double(i) / double(n), radius = uniform(0.05, 0.18);
      corners.push_back({0.7 + radius * std::cos(angle), 0.3 + radius * std::sin(angle)});
    }
    corners.push_back(corners.front());
    Curve star = square.curve(corners);
    Curve points;
    std::vector<CGAL::Sign> expected;
    for (int i = 0; i < 300; ++i) {
      const double x = uniform(0.5, 0.9), y = uniform(0.1, 0.5);
      double turns = 0;
      for (std::size_t k = 0; k < n; ++k) {
        const auto [ax, ay] = corners[k];
        const auto [bx, by] = corners[k + 1];
        turns += std::atan2((ax - x) * (by - y) - (ay - y) * (bx - x), (ax - x) * (bx - x) + (ay - y) * (by - y));
      }
      points.push_back(square.at(x, y));
      expected.push_back(turns > pi && x > y ? CGAL::POSITIVE : CGAL::NEGATIVE);
    }
    EXPECT_EQ(IT::sides_of_curve(square.input, {star}, points), expected) << n;
    EXPECT_EQ(IT::sides_of_curve(square.input, {star}), std::vector<CGAL::Sign>(4, CGAL::NEGATIVE)) << n;
    std::reverse(star.begin(), star.end());
    for (CGAL::Sign& sign : expected)
      sign = CGAL::opposite(sign);
    EXPECT_EQ(IT::sides_of_curve(square.input, {star}, points), expected) << n;
  }
}

TEST(Sides_of_curve, where_it_touches_itself_sides_and_corners)
{
  const Square square;
  const auto sides = [&](const Curve& curve) { return IT::sides_of_curve(square.input, {curve}); };
  using Signs = std::vector<CGAL::Sign>;
  const auto side_at = [&](const Curve& curve, double x, double y) {
    return IT::sides_of_curve(square.input, {curve}, {square.at(x, y)}).front();
  };
  // From border to border with turns back inside the faces; (0.5, 0.5) is on the edge.
  const Curve wave = square.curve({{1, 0.25},
                                   {0.9, 0.6},
                                   {0.8, 0.1},
                                   {0.7, 0.2},
                                   {0.5, 0.5},
                                   {0.3, 0.6},
                                   {0.1, 0.9},
                                   {0.4, 0.8},
                                   {0.3, 0.9},
                                   {0.35, 1}});
  EXPECT_EQ(sides(wave), (Signs{CGAL::POSITIVE, CGAL::POSITIVE, CGAL::POSITIVE, CGAL::NEGATIVE}));
  EXPECT_EQ(side_at(wave, 0.82, 0.15), CGAL::POSITIVE);
  EXPECT_EQ(side_at(wave, 0.78, 0.3), CGAL::NEGATIVE);
  EXPECT_EQ(side_at(wave, 0.79, 0.05), CGAL::POSITIVE);
  // Two triangles that meet at a corner, one inside of the other.
  const Curve two = square.curve({{0.5, 0.1}, {0.9, 0.1}, {0.9, 0.6}, {0.5, 0.1}, {0.8, 0.15}, {0.8, 0.3}, {0.5, 0.1}});
  EXPECT_THROW(sides(two), IT::Invalid_argument_error);
  const Curve ring =
    square.curve({{0.5, 0.1}, {0.9, 0.1}, {0.9, 0.6}, {0.5, 0.1}, {0.8, 0.3}, {0.8, 0.15}, {0.5, 0.1}});
  EXPECT_EQ(side_at(ring, 0.85, 0.3), CGAL::POSITIVE);
  EXPECT_EQ(side_at(ring, 0.7, 0.18), CGAL::NEGATIVE);
  EXPECT_EQ(side_at(ring, 0.2, 0.1), CGAL::NEGATIVE);
  // Along a side, and through corners.
  EXPECT_EQ(sides(square.curve({{0.25, 0}, {0.25, 0.125}, {0.5, 0}, {1, 0}, {1, 0.5}})),
            (Signs{CGAL::POSITIVE, CGAL::ZERO, CGAL::POSITIVE, CGAL::POSITIVE}));
  EXPECT_EQ(sides(square.curve({{0, 0}, {0.5, 0.25}, {1, 1}})),
            (Signs{CGAL::ZERO, CGAL::NEGATIVE, CGAL::POSITIVE, CGAL::ZERO}));
  // A point exactly on a segment.
  EXPECT_EQ(side_at(square.curve({{0.25, 0}, {0.75, 0.5}, {1, 0.5}}), 0.9, 0.1), CGAL::NEGATIVE);
  const Curve over = square.curve({{0.25, 0}, {0.75, 0.5}, {0.75, 0.25}, {0.5, 0.25}, {0.5, 0}});
  EXPECT_EQ(side_at(over, 0.45, 0.1), CGAL::NEGATIVE);
  EXPECT_THROW(sides(square.curve({{0.5, 0.1}, {0.9, 0.2}, {0.6, 0.3}, {0.7, 0.05}, {0.5, 0.1}})),
               IT::Invalid_point_error);
}

TEST(Sides_of_curve, offset_curves_of_a_comb_in_a_face)
{
  const Square square;
  const Curve comb =
    square.curve({{0.6, 0}, {0.6, 0.3}, {0.7, 0.3}, {0.7, 0.1}, {0.8, 0.1}, {0.8, 0.5}, {0.9, 0.5}, {0.9, 0}});
  const Triangulation triangulation = square.mesh.Delaunay();
  const auto found =
    IT::offset_curves(triangulation, {comb}, {0.02, -0.02}, CGAL::parameters::tolerance(0).maximum_deviation(1e-5));
  ASSERT_EQ(found.lines.size(), 2u);
  for (const IT::Surface_line& line : found.lines)
    for (const IT::Surface_point& p : line.points) {
      const Point q = IT::point_in_space(square.input, square.mesh.points, p);
      const bool is_right = q[0] > 0.6 && q[0] < 0.9 && q[1] < (q[0] < 0.7 ? 0.3 : q[0] < 0.8 ? 0.1 : 0.5);
      EXPECT_EQ(is_right, line.distance < 0) << q[0] << ' ' << q[1];
    }
}

TEST(Geodesic_distance_matrix, has_the_distances_from_each_source)
{
  const Mesh mesh = hills(15, 2);
  const Triangulation triangulation = mesh.Delaunay();
  const std::vector<Vertex_index> sources{Vertex_index(0), Vertex_index(100), Vertex_index(100), Vertex_index(200)},
    targets{Vertex_index(7), Vertex_index(100), Vertex_index(101)};
  IT::Tufted_cover cover = IT::make_tufted_cover(mesh.points, mesh.triangles);
  IT::flip_to_Delaunay(cover.triangulation);
  for (double tolerance : {0., 0.001}) {
    const auto found = IT::geodesic_distance_matrix<CGAL::Parallel_if_available_tag>(triangulation, sources, targets,
                                                                                     with_tolerance(tolerance));
    const auto on_cover = IT::geodesic_distance_matrix(cover, sources, targets, with_tolerance(tolerance));
    EXPECT_TRUE(found.is_complete);
    std::uint64_t ways = 0;
    for (std::size_t i = 0; i < sources.size(); ++i) {
      const auto all = IT::geodesic_distances(triangulation, {sources[i]}, with_tolerance(tolerance));
      const auto all_on_cover = IT::geodesic_distances(cover, {sources[i]}, with_tolerance(tolerance));
      ways += all.number_of_ways;
      for (std::size_t j = 0; j < targets.size(); ++j) {
        EXPECT_EQ(found.distances[i][j], all.distances[targets[j].idx()]) << tolerance << ' ' << i << ' ' << j;
        EXPECT_EQ(on_cover.distances[i][j], all_on_cover.distances[targets[j].idx()]);
      }
    }
    EXPECT_LT(found.number_of_ways, 0.8 * double(ways)); // it stops
  }
  EXPECT_TRUE(IT::geodesic_distance_matrix(triangulation, {}, targets).distances.empty());
  EXPECT_THROW(IT::geodesic_distance_matrix(triangulation, sources, {Vertex_index(10000)}), IT::Invalid_argument_error);
  // The visitor sees the part of the sources that are done, and can cancel.
  std::vector<double> parts;
  const auto visit = [&parts](double part) {
    if (part > 0)
      parts.push_back(part);
    return true;
  };
  IT::geodesic_distance_matrix(triangulation, sources, targets, CGAL::parameters::visitor(visit));
  ASSERT_EQ(parts.size(), sources.size());
  EXPECT_EQ(parts.front(), 1 / double(sources.size()));
  EXPECT_EQ(parts.back(), 1);
  EXPECT_THROW(IT::geodesic_distance_matrix(triangulation, sources, targets,
                                            CGAL::parameters::visitor([](double part) { return part < 0.5; })),
               IT::Cancelled_error);
}

} // namespace
