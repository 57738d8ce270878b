// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shortest paths, picked points, and surfaces that are cut open.

#include "evaluation_data.h"
#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Geodesic_path_network.h>
#include <CGAL/Intrinsic_triangulations/Point_location.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/geodesic_distance_matrix.h>
#include <CGAL/Intrinsic_triangulations/geodesic_distances.h>
#include <CGAL/Intrinsic_triangulations/geodesic_path.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/nearest_source_point.h>
#include <CGAL/Intrinsic_triangulations/polygon_soup.h>
#include <CGAL/Intrinsic_triangulations/refine_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/cut_along_path.h>
#include <CGAL/Intrinsic_triangulations/shortest_path.h>
#include <CGAL/Intrinsic_triangulations/shortest_path_on_triangles.h>
#include <CGAL/Intrinsic_triangulations/trace_geodesic.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Delta_complex;
using IT::Halfedge_index;
using IT::Surface_point;
using IT::Vertex_index;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;
using Network = IT::Geodesic_path_network<IT::Filtered_edge_length_traits>;
using Points = std::vector<std::array<double, 3>>;

Triangulation Delaunay(const samples::Indexed_triangles& surface)
{
  Triangulation result(IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles), surface.points);
  IT::flip_to_Delaunay(result);
  return result;
}

// The relative excess of the path over the distance; and the path on the input.
double excess(Triangulation& triangulation, Vertex_index s, Vertex_index t,
              std::vector<Surface_point>* points = nullptr)
{
  const IT::Shortest_path start = IT::shortest_path(triangulation, s, t);
  EXPECT_TRUE(start.is_complete);
  Network network(triangulation);
  const std::size_t p = network.add_path(start.halfedges);
  network.shorten();
  EXPECT_TRUE(network.is_geodesic(p));
  if (points != nullptr)
    *points = IT::geodesic_points(triangulation, network.halfedges(p));
  return network.length(p) / start.distance - 1;
}

TEST(Shortest_path, is_as_long_as_the_distance)
{
  std::mt19937 random(3);
  for (const samples::Indexed_triangles& surface :
       {samples::bumpy_sphere(24, 16), samples::bad_torus(16, 12), samples::Schwarz_lantern(8, 24), samples::pillow(30),
        samples::random_diagonal_grid(20, 20), samples::strip(60, 12, 1), samples::sheared_grid(15, 15, 5)}) {
    const Triangulation triangulation = Delaunay(surface);
    for (int i = 0; i < 15; ++i) {
      const Vertex_index s(random() % std::uint32_t(surface.points.size())),
        t(random() % std::uint32_t(surface.points.size()));
      if (s == t)
        continue;
      Triangulation copy = triangulation;
      EXPECT_LT(std::abs(excess(copy, s, t)), 1e-9) << s.idx() << ' ' << t.idx();
    }
  }
}

// A ridge between two vertices: the shortest path along edges runs over the wrong side of it.
TEST(Shortest_path, is_found_where_edges_lead_elsewhere)
{
  samples::Indexed_triangles surface;
  // Seen from above, a square of side 10 with a peak that stands nearer to the front; edges lead along the back.
  surface.points = {{-5, 0, 0}, {5, 0, 0}, {0, 1, 6}, {0, -4, 0}, {0, 4.5, 0}};
  surface.triangles = {{0, 2, 4}, {2, 1, 4}, {0, 3, 2}, {3, 1, 2}};
  Triangulation triangulation = Delaunay(surface);
  EXPECT_LT(std::abs(excess(triangulation, Vertex_index(0), Vertex_index(1))), 1e-12);
}

// Squares of lengths are beyond the range of double.
TEST(Shortest_path, of_very_large_and_small_surfaces)
{
  const Triangulation triangulation = Delaunay(samples::pillow(30));
  Triangulation first = triangulation;
  const double distance = IT::shortest_path(first, Vertex_index(0), Vertex_index(17)).distance;
  for (int exponent : {-990, 990}) {
    samples::Indexed_triangles surface = samples::pillow(30);
    for (auto& p : surface.points)
      for (double& x : p)
        x = std::ldexp(x, exponent);
    Triangulation scaled = Delaunay(surface);
    EXPECT_EQ(IT::shortest_edge_path(scaled, Vertex_index(0), Vertex_index(17)),
              IT::shortest_edge_path(triangulation, Vertex_index(0), Vertex_index(17)));
    EXPECT_LT(std::abs(excess(scaled, Vertex_index(0), Vertex_index(17))), 1e-9);
    Triangulation again = Delaunay(surface);
    EXPECT_EQ(IT::shortest_path(again, Vertex_index(0), Vertex_index(17)).distance, std::ldexp(distance, exponent));
  }
}

// Bellman and Ford's algorithm.
template <class T>
std::vector<double> lengths_of_edge_paths(const T& triangulation, Vertex_index source)
{
  const Delta_complex& complex = triangulation.connectivity();
  std::vector<double> result(complex.number_of_vertices(), std::numeric_limits<double>::infinity());
  result[source.idx()] = 0;
  for (bool has_changed = true; has_changed;) {
    has_changed = false;
    for (IT::Edge_index e : complex.edges()) {
      double &a = result[complex.source(complex.halfedge(e)).idx()],
             &b = result[complex.target(complex.halfedge(e)).idx()];
      const double length = CGAL::to_double(triangulation.length(e));
      has_changed = has_changed || a > b + length || b > a + length;
      a = std::min(a, b + length);
      b = std::min(b, a + length);
    }
  }
  return result;
}

// Also without the positions of a kept input, which would show the way.
TEST(Shortest_edge_path, is_not_longer_than_another)
{
  const samples::Indexed_triangles surface = samples::bumpy_dome();
  const auto check = [](const auto& triangulation) {
    const auto expected = lengths_of_edge_paths(triangulation, Vertex_index(5));
    for (std::uint32_t target = 0; target < expected.size(); target += 7) {
      double length = 0;
      for (Halfedge_index h : IT::shortest_edge_path(triangulation, Vertex_index(5), Vertex_index(target)))
        length += CGAL::to_double(triangulation.length(triangulation.connectivity().edge(h)));
      EXPECT_NEAR(length, expected[target], 1e-13 * expected[target]) << target;
    }
  };
  Triangulation refined = Delaunay(surface);
  check(refined);
  IT::refine_Delaunay(refined);
  check(refined);
  const auto complex = IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles);
  const IT::Intrinsic_triangulation<IT::Edge_length_traits<double>> rounded(complex, surface.points);
  ASSERT_FALSE(rounded.keeps_input());
  check(rounded);
}

TEST(Shortest_path, to_a_near_vertex_does_not_look_further)
{
  Triangulation triangulation = Delaunay(samples::random_diagonal_grid(40, 40));
  const Vertex_index s(800), t(805);
  EXPECT_TRUE(IT::shortest_path(triangulation, s, t, CGAL::parameters::maximum_number(500)).is_complete);
  EXPECT_GT(IT::geodesic_distances(triangulation, {s}, CGAL::parameters::tolerance(0.)).number_of_ways, 5000u);
}

samples::Indexed_triangles rough_terrain(std::size_t n)
{
  samples::Indexed_triangles result = samples::random_diagonal_grid(n, n, 3);
  std::mt19937 random(9);
  for (auto& p : result.points)
    p[2] = 0.3 * double(random() % 1024) / 1024;
  return result;
}

// Whatever the shape, no way is lost that is shorter than the others.
TEST(Shortest_path, equals_the_distance_that_is_found_without_a_goal)
{
  std::mt19937 random(4);
  for (const samples::Indexed_triangles& surface :
       {rough_terrain(20), samples::bumpy_sphere(24, 16), samples::bad_torus(16, 12), samples::Schwarz_lantern(8, 24),
        samples::disk_with_spike(), samples::sheared_grid(15, 15, 5)}) {
    Triangulation triangulation = Delaunay(surface);
    for (int i = 0; i < 4; ++i) {
      const Vertex_index s(random() % std::uint32_t(surface.points.size()));
      const std::vector<double> all =
        IT::geodesic_distances(triangulation, {s}, CGAL::parameters::tolerance(0.)).distances;
      for (int k = 0; k < 25; ++k) {
        const Vertex_index t(random() % std::uint32_t(surface.points.size()));
        Triangulation copy = triangulation;
        EXPECT_NEAR(IT::shortest_path(copy, s, t).distance, all[t.idx()], 1e-12 * all[t.idx()]);
      }
    }
  }
}

TEST(Shortest_path, is_looked_for_along_the_way)
{
  Triangulation triangulation = Delaunay(rough_terrain(60));
  const Vertex_index s(0), t(61 * 61 - 1);
  const std::uint64_t all =
    IT::geodesic_distance_matrix(triangulation, {s}, {t}, CGAL::parameters::tolerance(0.)).number_of_ways;
  EXPECT_TRUE(IT::shortest_path(triangulation, s, t, CGAL::parameters::maximum_number(all / 4)).is_complete);
}

TEST(Nearest_source_point, is_where_the_path_meets_the_curve_at_a_right_angle)
{
  const samples::Indexed_triangles surface = samples::random_diagonal_grid(9, 9, 2);
  Triangulation triangulation = Delaunay(surface);
  const auto at = [&](double x, double y) {
    return IT::locate(triangulation.input(), surface.points, std::array<double, 3>{x, y, 0});
  };
  Triangulation copy = triangulation;
  const Vertex_index s = IT::vertex_at_point(copy, at(1.25, 0.75)), t = IT::vertex_at_point(copy, at(7.5, 5.25));
  const IT::Geodesic_source curve{{IT::geodesic_points(copy, IT::shortest_path(copy, s, t).halfedges)}, 0};
  for (const auto& [from, to] : {std::pair<std::array<double, 2>, std::array<double, 2>>{{4, 8}, {0, 0}},
                                 {{0, 0}, {1.25, 0.75}},
                                 {{9, 9}, {7.5, 5.25}},
                                 {{5, 0}, {0, 0}}}) {
    const Vertex_index v(std::uint32_t(from[0] + 10 * from[1]));
    const IT::Nearest_source_point found = IT::nearest_source_point(triangulation, v, curve);
    std::array<double, 2> foot = to;
    if (foot[0] == 0) { // inside of the segment
      const double dx = 6.25, dy = 4.5, part = ((from[0] - 1.25) * dx + (from[1] - 0.75) * dy) / (dx * dx + dy * dy);
      foot = {1.25 + part * dx, 0.75 + part * dy};
    }
    const auto p = IT::point_in_space(triangulation.input(), surface.points, found.point);
    EXPECT_NEAR(p[0], foot[0], 1e-9);
    EXPECT_NEAR(p[1], foot[1], 1e-9);
    EXPECT_NEAR(found.distance, std::hypot(from[0] - foot[0], from[1] - foot[1]), 1e-12);
  }
  EXPECT_THROW(IT::nearest_source_point(triangulation, Vertex_index(100), curve), IT::Invalid_argument_error);
  EXPECT_THROW(IT::nearest_source_point(triangulation, Vertex_index(0), {}), IT::Invalid_argument_error);
}

TEST(Shortest_path, to_itself_is_empty)
{
  Triangulation triangulation = Delaunay(samples::pillow(12));
  const IT::Shortest_path path = IT::shortest_path(triangulation, Vertex_index(3), Vertex_index(3));
  EXPECT_TRUE(path.halfedges.empty() && path.is_complete);
  EXPECT_EQ(path.distance, 0);
}

TEST(Shortest_path, needs_vertices_that_are_connected)
{
  samples::Indexed_triangles surface = samples::pillow(12);
  const std::uint32_t n = std::uint32_t(surface.points.size());
  surface.points.insert(surface.points.end(), {{9, 0, 0}, {10, 0, 0}, {9, 1, 0}});
  surface.triangles.push_back({n, n + 1, n + 2});
  Triangulation triangulation = Delaunay(surface);
  EXPECT_THROW(IT::shortest_path(triangulation, Vertex_index(0), Vertex_index(n)), IT::Invalid_argument_error);
  EXPECT_THROW(IT::shortest_path(triangulation, Vertex_index(0), Vertex_index(n + 3)), IT::Invalid_argument_error);
}

Surface_point located(const samples::Indexed_triangles& surface, const std::array<double, 3>& p)
{
  return IT::locate(IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles), surface.points, p);
}

TEST(Locate, finds_faces_edges_and_vertices)
{
  samples::Indexed_triangles surface;
  surface.points = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0}};
  surface.triangles = {{0, 1, 2}, {2, 1, 3}};
  const Delta_complex complex = IT::make_Delta_complex_from_triangles(4, surface.triangles);
  for (double scale : {1., 1e-300, 1e300}) {
    samples::Indexed_triangles scaled = surface;
    for (auto& p : scaled.points)
      for (double& x : p)
        x *= scale;
    const auto at = [&](double x, double y, double z) { return located(scaled, {x * scale, y * scale, z * scale}); };
    const auto expect_at = [&](const Surface_point& p, double x, double y, int dimension) {
      EXPECT_EQ(p.dimension(), dimension);
      const auto q = IT::point_in_space(complex, surface.points, p);
      EXPECT_NEAR(q[0], x, dimension < 2 ? 1e-12 : 1e-15);
      EXPECT_NEAR(q[1], y, dimension < 2 ? 1e-12 : 1e-15);
    };
    expect_at(at(1, 1, 7), 1, 1, 2);
    expect_at(at(3, 2, -1), 3, 2, 2);
    expect_at(at(1, -5, 1), 1, 0, 1);
    expect_at(at(2, 2, 3), 2, 2, 1);
    expect_at(at(-3, -4, 2), 0, 0, 0);
    expect_at(at(5, 5, 0), 4, 4, 0);
    // Within rounding of them.
    expect_at(at(2 - 0x1p-43, 2 - 0x1p-43, 0), 2, 2, 1);
    expect_at(at(1, 0x1p-43, 0), 1, 0, 1);
    expect_at(at(0x1p-45, 0x1p-43, 0), 0, 0, 0);
    expect_at(at(1, 0x1p-30, 0), 1, 0x1p-30, 2);
  }
}

TEST(Locate, refuses_what_is_no_point)
{
  const samples::Indexed_triangles surface = samples::pillow(12);
  EXPECT_THROW(located(surface, {0, std::nan(""), 0}), IT::Invalid_point_error);
  EXPECT_THROW(located(surface, {INFINITY, 0, 0}), IT::Invalid_point_error);
  EXPECT_THROW(located({{}, {}}, {0, 0, 0}), IT::Invalid_point_error);
}

double area(const IT::Cut_surface& surface)
{
  double sum = 0;
  for (const auto& [a, b, c] : surface.triangles) {
    std::array<double, 3> u, v;
    for (std::size_t k = 0; k < 3; ++k) {
      u[k] = surface.points[b][k] - surface.points[a][k];
      v[k] = surface.points[c][k] - surface.points[a][k];
    }
    sum += std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2;
  }
  return sum;
}

// The edges with one side, summed up; of an oriented manifold, as is checked.
double border_length(const IT::Cut_surface& surface)
{
  const Delta_complex complex = IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles);
  double sum = 0;
  for (Halfedge_index h : complex.halfedges())
    if (complex.is_border(h)) {
      const auto &p = surface.points[complex.source(h).idx()], &q = surface.points[complex.target(h).idx()];
      sum += std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    }
  return sum;
}

IT::Cut_surface cut(const samples::Indexed_triangles& surface, const std::vector<Surface_point>& path)
{
  return IT::cut_along_path(IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles),
                            surface.points, path);
}

TEST(Cut_along_path, opens_the_surface_on_both_sides)
{
  for (const samples::Indexed_triangles& surface :
       {samples::bumpy_sphere(24, 16), samples::pillow(30), samples::bad_torus(16, 12)}) {
    Triangulation triangulation = Delaunay(surface);
    std::vector<Surface_point> path;
    const Vertex_index s(1), t(std::uint32_t(surface.points.size() / 2));
    EXPECT_LT(excess(triangulation, s, t, &path), 1e-9);
    double length = 0;
    const Delta_complex input = IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles);
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      const auto p = IT::point_in_space(input, surface.points, path[i]),
                 q = IT::point_in_space(input, surface.points, path[i + 1]);
      length += std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    }
    const IT::Cut_surface whole = cut(surface, {}), opened = cut(surface, path);
    EXPECT_EQ(whole.triangles.size(), surface.triangles.size());
    EXPECT_EQ(border_length(whole), 0);
    EXPECT_NEAR(border_length(opened), 2 * length, 1e-9 * length);
    EXPECT_NEAR(area(opened), area(whole), 1e-9 * area(whole));
    EXPECT_EQ(opened.points.size(), surface.points.size() + opened.locations.size());
    EXPECT_EQ(opened.input_faces.size(), opened.triangles.size());
    for (std::size_t v = surface.points.size(); v < opened.points.size(); ++v)
      EXPECT_EQ(opened.points[v],
                IT::point_in_space(input, surface.points, opened.locations[v - surface.points.size()]));
  }
}

TEST(Cut_along_path, with_many_points_in_a_face)
{
  const samples::Indexed_triangles surface{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}};
  const Delta_complex input = IT::make_Delta_complex_from_triangles(3, surface.triangles);
  const Halfedge_index h = input.halfedge(IT::Face_index(0));
  std::vector<Surface_point> spiral;
  double length = 0;
  for (int i = 0; i <= 200; ++i) {
    const double angle = 0.2 * i, radius = 0.004 * i;
    spiral.push_back({h, {0, (1.1 + radius * std::cos(angle)) / 4, (1.1 + radius * std::sin(angle)) / 4}});
    spiral.back().coordinates[0] = 1 - spiral.back().coordinates[1] - spiral.back().coordinates[2];
    if (i > 0) {
      const auto p = IT::point_in_space(input, surface.points, spiral[std::size_t(i) - 1]),
                 q = IT::point_in_space(input, surface.points, spiral[std::size_t(i)]);
      length += std::hypot(p[0] - q[0], p[1] - q[1]);
    }
  }
  const IT::Cut_surface opened = cut(surface, spiral);
  EXPECT_EQ(opened.points.size(), 3u + 201 + 199);
  EXPECT_NEAR(border_length(opened), 8 + 4 * std::sqrt(2.) + 2 * length, 1e-12);
  EXPECT_NEAR(area(opened), 8, 1e-12);
  // Along a side, over a point where the path has been.
  const auto at = [&](double x, double y) { return Surface_point{h, {1 - (x + y) / 4, x / 4, y / 4}}; };
  const IT::Cut_surface cut_off = cut(surface, {at(1, 0), at(1, 1), at(0, 0), at(2, 0), at(2, 1)});
  EXPECT_EQ(cut_off.points.size(), 3u + 4 + 4);
  EXPECT_NEAR(border_length(cut_off), 8 + 4 * std::sqrt(2.) + 2 * (1 + std::sqrt(2.) + 1), 1e-12);
  EXPECT_NEAR(area(cut_off), 8, 1e-12);
  std::swap(spiral[100], spiral[130]);
  EXPECT_THROW(cut(surface, spiral), IT::Invalid_point_error);
}

// A torus of two triangles: all edges join its vertex with itself.
TEST(Cut_along_path, refuses_edges_with_the_same_ends)
{
  const Delta_complex torus =
    IT::make_Delta_complex_from_gluing(2, std::vector<std::array<int, 2>>{{0, 3}, {1, 4}, {2, 5}});
  const std::vector<std::array<double, 3>> points{{0, 0, 0}};
  const Halfedge_index h = torus.halfedge(IT::Face_index(0));
  EXPECT_THROW(IT::cut_along_path(torus, points, {{h, {1, 1, 2}}, {h, {1, 2, 1}}}), IT::Invalid_surface_error);
}

TEST(Cut_along_path, divides_a_sheet_in_two)
{
  const samples::Indexed_triangles surface = samples::random_diagonal_grid(6, 6);
  Triangulation triangulation = Delaunay(surface);
  std::vector<Surface_point> path;
  excess(triangulation, Vertex_index(2), Vertex_index(std::uint32_t(surface.points.size() - 2)), &path);
  const IT::Cut_surface opened = cut(surface, path);
  const Delta_complex complex = IT::make_Delta_complex_from_triangles(opened.points.size(), opened.triangles);
  std::set<std::uint32_t> reached{0};
  std::vector<std::uint32_t> open{0};
  while (!open.empty()) {
    const IT::Face_index f(open.back());
    open.pop_back();
    Halfedge_index h = complex.halfedge(f);
    for (int i = 0; i < 3; ++i, h = complex.next(h))
      if (!complex.is_border(complex.opposite(h)) && reached.insert(complex.face(complex.opposite(h)).idx()).second)
        open.push_back(complex.face(complex.opposite(h)).idx());
  }
  EXPECT_GT(reached.size(), 1u);
  EXPECT_LT(reached.size(), opened.triangles.size());
}

TEST(Cut_along_path, leaves_a_slit_within_a_face_and_along_an_edge)
{
  const samples::Indexed_triangles surface = samples::random_diagonal_grid(3, 3);
  const Delta_complex complex = IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles);
  const double border = border_length(cut(surface, {}));
  const Halfedge_index h = [&] {
    for (Halfedge_index g : complex.halfedges())
      if (!complex.is_border(complex.halfedge(complex.source(g))) &&
          !complex.is_border(complex.halfedge(complex.target(g))))
        return g;
    return Halfedge_index();
  }();
  ASSERT_TRUE(h.is_valid());
  for (const std::vector<Surface_point>& path :
       {std::vector<Surface_point>{{h, {0.5, 0.25, 0.25}}, {h, {0.125, 0.5, 0.375}}},
        std::vector<Surface_point>{{h, {1, 0, 0}}, {h, {0, 1, 0}}},
        std::vector<Surface_point>{{h, {0.5, 0.5, 0}}, {h, {0.25, 0.25, 0.5}}}}) {
    const IT::Cut_surface opened = cut(surface, path);
    const auto p = IT::point_in_space(complex, surface.points, path[0]),
               q = IT::point_in_space(complex, surface.points, path[1]);
    EXPECT_NEAR(border_length(opened), border + 2 * std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]), 1e-12);
    EXPECT_NEAR(area(opened), area(cut(surface, {})), 1e-12);
  }
}

TEST(Cut_along_path, refuses_what_is_no_path)
{
  const samples::Indexed_triangles surface = samples::random_diagonal_grid(3, 3);
  const Delta_complex complex = IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles);
  const Halfedge_index h = complex.halfedge(IT::Face_index(0)), g = complex.halfedge(IT::Face_index(17));
  EXPECT_THROW(cut(surface, {{h, {1, 0, 0}}, {g, {0.2, 0.3, 0.5}}}), IT::Invalid_point_error);
  EXPECT_THROW(cut(surface, {{h, {1, 0, 0}}, {h, {0, -1, 0}}}), IT::Invalid_point_error);
  EXPECT_THROW(cut(surface, {{Halfedge_index(), {1, 0, 0}}, {h, {0, 1, 0}}}), IT::Invalid_point_error);
  // Across each other.
  EXPECT_THROW(cut(surface, {{h, {0.5, 0.5, 0}},
                             {h, {0.2, 0, 0.8}},
                             {h, {0.8, 0, 0.2}},
                             {h, {0, 0.5, 0.5}},
                             {h, {0.9, 0.1, 0}},
                             {h, {0.6, 0, 0.4}}}),
               IT::Invalid_point_error);
}

// A thousand pairs of vertices of surfaces of all kinds.
TEST(Shortest_path, between_vertices_of_scans_and_parts)
{
  const std::filesystem::path folder = evaluation_data();
  if (folder.empty())
    GTEST_SKIP() << "no evaluation data";
  std::mt19937 random(5);
  std::size_t number_of_pairs = 0;
  for (const char* name : {"table1/cathead.off", "table1/bunnyhead.off", "table1/beautiful_freak.off",
                           "good/cgal_rotor.off", "good/cgal_pipe.off"}) {
    samples::Indexed_triangles surface;
    IT::read_triangles((folder / name).string(), surface.points, surface.triangles);
    const Triangulation triangulation = Delaunay(surface);
    for (int i = 0; i < 200; ++i) {
      const Vertex_index s(random() % std::uint32_t(surface.points.size())),
        t(random() % std::uint32_t(surface.points.size()));
      if (s == t || triangulation.connectivity().halfedge(s) == Halfedge_index() ||
          triangulation.connectivity().halfedge(t) == Halfedge_index())
        continue;
      Triangulation copy = triangulation;
      EXPECT_LT(std::abs(excess(copy, s, t)), 1e-9) << name << ' ' << s.idx() << ' ' << t.idx();
      ++number_of_pairs;
    }
  }
  EXPECT_GT(number_of_pairs, 950u);
}

// The path consists of lines in the triangles that it names, and is as long as it says and as the distance.
void expect_shortest(const IT::Path_on_triangles& path, const Points& points,
                     const std::vector<std::array<std::uint32_t, 3>>& triangles, double distance)
{
  const auto length = [](const std::array<double, 3>& p, const std::array<double, 3>& q) {
    return std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
  };
  const auto area = [&](const auto& p, const auto& q, const auto& r) { // by Heron
    const double a = length(p, q), b = length(q, r), c = length(r, p), s = (a + b + c) / 2;
    return std::sqrt((std::max)(0., s * (s - a) * (s - b) * (s - c)));
  };
  EXPECT_TRUE(path.is_complete);
  EXPECT_NEAR(path.distance, distance, 1e-12 * distance);
  EXPECT_NEAR(path.length, distance, 1e-12 * distance);
  ASSERT_EQ(path.positions.size(), path.points.size());
  double sum = 0;
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    const auto& t = triangles.at(path.points[i].triangle);
    std::array<double, 3> place{0, 0, 0};
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t x = 0; x < 3; ++x)
        place[x] += path.points[i].coordinates[k] * points[t[k]][x];
    EXPECT_LT(length(place, path.positions[i]), 1e-14 * (1 + distance));
    if (i == 0)
      continue;
    sum += length(path.positions[i - 1], path.positions[i]);
    const auto& [a, b, c] = triangles.at(path.points[i - 1].triangle);
    for (const auto& p : {path.positions[i - 1], path.positions[i]})
      EXPECT_NEAR(area(p, points[a], points[b]) + area(p, points[b], points[c]) + area(p, points[c], points[a]),
                  area(points[a], points[b], points[c]), 1e-6);
  }
  EXPECT_NEAR(sum, distance, 1e-12 * distance);
}

// Any two pages are one plane.
TEST(Shortest_path_on_triangles, from_page_to_page)
{
  std::mt19937 random(3);
  for (std::uint32_t pages = 2; pages <= 7; ++pages) {
    Points points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    constexpr std::uint32_t n = 5;
    for (std::uint32_t z = 0; z <= n; ++z)
      points.push_back({0, 0, z / double(n)});
    for (std::uint32_t page = 0; page < pages; ++page) {
      const double angle = page * 6.28 / pages;
      const auto at = [&](std::uint32_t r, std::uint32_t z) { return r == 0 ? z : (page * n + r) * (n + 1) + z; };
      for (std::uint32_t r = 1; r <= n; ++r)
        for (std::uint32_t z = 0; z <= n; ++z)
          points.push_back({r * std::cos(angle), r * std::sin(angle), z / double(n)});
      for (std::uint32_t r = 0; r < n; ++r)
        for (std::uint32_t z = 0; z < n; ++z)
          for (std::array<std::uint32_t, 3> t : {std::array{at(r, z), at(r + 1, z), at(r + 1, z + 1)},
                                                 std::array{at(r, z), at(r + 1, z + 1), at(r, z + 1)}}) {
            if (random() % 2 == 0)
              std::swap(t[0], t[1]);
            triangles.push_back(t);
          }
    }
    for (int i = 0; i < 20; ++i) {
      const std::size_t v = n + 1 + random() % (points.size() - n - 1), w = random() % points.size();
      if (v == w)
        continue;
      const auto radius = [&](std::size_t u) { return std::hypot(points[u][0], points[u][1]); };
      const bool is_same_page = w <= n || (v - n - 1) / (n * (n + 1)) == (w - n - 1) / (n * (n + 1));
      expect_shortest(
        IT::shortest_path_on_triangles(points, triangles, v, w), points, triangles,
        std::hypot(is_same_page ? radius(v) - radius(w) : radius(v) + radius(w), points[v][2] - points[w][2]));
    }
  }
}

// The distance, by both ways to find it.
void expect_distance(const Points& points, const std::vector<std::array<std::uint32_t, 3>>& triangles,
                     std::uint32_t from, std::uint32_t to, double distance)
{
  expect_shortest(IT::shortest_path_on_triangles(points, triangles, from, to), points, triangles, distance);
  IT::Tufted_cover cover =
    IT::make_tufted_cover(points, triangles, CGAL::parameters::surface_cover(IT::Surface_cover::SHEETS));
  IT::flip_to_Delaunay(cover.triangulation);
  for (double tolerance : {0., 0.001})
    EXPECT_NEAR(
      IT::geodesic_distances(cover, {Vertex_index(from)}, CGAL::parameters::tolerance(tolerance)).distances[to],
      distance, tolerance + 1e-12);
}

TEST(Shortest_path_on_triangles, faces_of_zero_area_are_segments)
{
  struct Case
  {
    const char* what;
    Points points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::uint32_t from, to;
    double distance;
  };
  const std::vector<Case> cases{{"a segment ends at a face",
                                 {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {2, 1, 0}},
                                 {{2, 0, 1}, {1, 3, 4}},
                                 0,
                                 4,
                                 1 + std::sqrt(2.)},
                                {"straight across, at an edge of four faces",
                                 {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {.5, 1, 0}, {1.5, -1, 0}, {1.5, 3, 0}},
                                 {{0, 2, 1}, {0, 2, 3}, {1, 2, 4}, {0, 2, 5}},
                                 3,
                                 4,
                                 std::sqrt(5.)},
                                {"shorter than over the faces",
                                 {{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 5, 0}, {1, 9, 0}},
                                 {{0, 1, 2}, {0, 3, 4}, {3, 1, 4}},
                                 0,
                                 1,
                                 2},
                                {"a face at the middle of three parts of an edge",
                                 {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1.5, -2, 0}, {1.5, 2, 0}},
                                 {{0, 3, 1}, {1, 3, 2}, {0, 3, 4}, {1, 2, 5}},
                                 4,
                                 5,
                                 4},
                                {"the same, where both vertices lie on the whole edge",
                                 {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1.5, -2, 0}, {1.5, 2, 0}},
                                 {{0, 3, 1}, {2, 3, 0}, {0, 3, 4}, {2, 1, 5}},
                                 4,
                                 5,
                                 4},
                                {"a face with an edge of length zero",
                                 {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}},
                                 {{0, 1, 2}, {1, 3, 4}},
                                 0,
                                 3,
                                 2},
                                {"two vertices at one place of an edge",
                                 {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, -1, 0}},
                                 {{0, 3, 1}, {0, 3, 2}, {0, 1, 4}, {2, 3, 5}},
                                 4,
                                 5,
                                 2},
                                {"where a face is cut, it has no edge",
                                 {{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 2, 0}, {1, 1, 1}},
                                 {{0, 1, 2}, {0, 1, 3}, {2, 3, 4}},
                                 4,
                                 0,
                                 1 + std::sqrt(2.)}};
  for (const Case& c : cases) {
    SCOPED_TRACE(c.what);
    expect_distance(c.points, c.triangles, c.from, c.to, c.distance);
    expect_distance(c.points, c.triangles, c.to, c.from, c.distance);
  }
  EXPECT_THROW(IT::shortest_path_on_triangles(Points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {3, 1, 0}, {4, 0, 0}},
                                              std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {3, 4, 5}}, 0, 3),
               IT::Invalid_argument_error);
}

// Most of them have faces of zero area, and edges of three and more faces.
TEST(Shortest_path_on_triangles, are_as_long_as_distances)
{
  std::mt19937 random(11);
  std::size_t number_of_pairs = 0;
  for (int mesh = 0; mesh < 150; ++mesh) {
    const std::uint32_t n = 5 + random() % 5;
    Points points;
    for (std::uint32_t v = 0; v < n; ++v)
      points.push_back({double(random() % 4), double(random() % (mesh % 2 == 0 ? 1 + random() % 2 : 3)),
                        double(mesh % 3 == 0 ? random() % 2 : 0)});
    std::vector<std::array<std::uint32_t, 3>> triangles(3 + random() % 8);
    for (auto& t : triangles)
      for (std::uint32_t& v : t)
        v = random() % n;
    IT::Tufted_cover cover =
      IT::make_tufted_cover(points, triangles, CGAL::parameters::surface_cover(IT::Surface_cover::SHEETS));
    IT::flip_to_Delaunay(cover.triangulation);
    const std::vector<double> distances =
      IT::geodesic_distances(cover, {Vertex_index(0)}, CGAL::parameters::tolerance(0.)).distances;
    for (std::uint32_t v = 1; v < n; ++v) {
      if (!std::isfinite(distances[v])) {
        EXPECT_THROW(IT::shortest_path_on_triangles(points, triangles, v, 0), IT::Invalid_argument_error);
      } else if (distances[v] > 0 && ++number_of_pairs)
        expect_shortest(IT::shortest_path_on_triangles(points, triangles, v, 0), points, triangles, distances[v]);
    }
  }
  EXPECT_GT(number_of_pairs, 400u);
}

// On the double cover, which is oriented, the shortest path leads to one of the copies.
TEST(Shortest_path_on_triangles, of_a_band_with_one_side)
{
  for (std::uint32_t n : {7, 16, 31}) {
    Points points;
    std::vector<std::array<std::uint32_t, 3>> triangles, doubled;
    for (std::uint32_t i = 0; i < n; ++i)
      for (double s : {-0.2, 0.3}) {
        const double angle = 2 * 3.14159265358979 * i / n, r = 1 + s * std::cos(angle / 2);
        points.push_back({r * std::cos(angle), r * std::sin(angle), s * std::sin(angle / 2)});
      }
    // Twice around, vertices 2 i and 2 i + 1 change sides.
    const auto copy = [&](std::uint32_t i, std::uint32_t side) {
      i %= 2 * n;
      return i < n ? 2 * i + side : 2 * n + 2 * (i - n) + (1 - side);
    };
    for (std::uint32_t i = 0; i < 2 * n; ++i) { // with the diagonal from vertex 2 i
      const std::uint32_t a = copy(i, 0), b = copy(i, 1), c = copy(i + 1, 0), d = copy(i + 1, 1);
      doubled.push_back({a, c, i < n ? d : b});
      doubled.push_back({b, i < n ? a : c, d});
    }
    triangles.assign(doubled.begin(), doubled.begin() + 2 * n);
    for (auto& t : triangles)
      for (std::uint32_t& v : t)
        v %= 2 * n;
    Points twice = points;
    twice.insert(twice.end(), points.begin(), points.end());
    samples::Indexed_triangles cover{twice, doubled};
    for (std::uint32_t target : {1u, n, 2 * n - 1}) {
      double distance = std::numeric_limits<double>::infinity();
      for (std::uint32_t t : {target, target + 2 * n}) {
        Triangulation triangulation = Delaunay(cover);
        distance = (std::min)(distance, IT::shortest_path(triangulation, Vertex_index(0), Vertex_index(t)).distance);
      }
      expect_shortest(IT::shortest_path_on_triangles(points, triangles, 0, target), points, triangles, distance);
    }
  }
}

// Straight lines cross many walls, and at each of them there are three other faces.
TEST(Shortest_path_on_triangles, through_cells)
{
  constexpr std::uint32_t n = 3;
  std::mt19937 random(8);
  std::uniform_real_distribution<double> move(-0.2, 0.2);
  const auto at = [](std::uint32_t x, std::uint32_t y, std::uint32_t z) { return (x * (n + 1) + y) * (n + 1) + z; };
  Points points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::uint32_t x = 0; x <= n; ++x)
    for (std::uint32_t y = 0; y <= n; ++y)
      for (std::uint32_t z = 0; z <= n; ++z) {
        points.push_back({x + move(random), y + move(random), z + move(random)});
        for (const auto& [p, q] :
             {std::pair{std::array{1, 0, 0}, std::array{0, 1, 0}}, std::pair{std::array{0, 1, 0}, std::array{0, 0, 1}},
              std::pair{std::array{0, 0, 1}, std::array{1, 0, 0}}})
          if (x + p[0] + q[0] <= n && y + p[1] + q[1] <= n && z + p[2] + q[2] <= n) {
            const std::uint32_t a = at(x, y, z), b = at(x + p[0], y + p[1], z + p[2]),
                                c = at(x + p[0] + q[0], y + p[1] + q[1], z + p[2] + q[2]),
                                d = at(x + q[0], y + q[1], z + q[2]);
            triangles.push_back({a, b, c});
            triangles.push_back({a, c, d});
          }
      }
  IT::Tufted_cover cover =
    IT::make_tufted_cover(points, triangles, CGAL::parameters::surface_cover(IT::Surface_cover::SHEETS));
  IT::flip_to_Delaunay(cover.triangulation);
  const std::vector<double> distances =
    IT::geodesic_distances(cover, {Vertex_index(0)}, CGAL::parameters::tolerance(0)).distances;
  for (std::uint32_t v = 1; v < points.size(); v += 5)
    expect_shortest(IT::shortest_path_on_triangles(points, triangles, 0, v), points, triangles, distances[v]);
}

TEST(Shortest_path_on_triangles, refuses_what_has_no_path)
{
  const Points points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {3, 0, 0}, {4, 0, 0}, {3, 1, 0}, {9, 9, 9}};
  const std::vector<std::array<std::uint32_t, 3>> triangles{{0, 1, 2}, {3, 4, 5}};
  for (std::size_t target : {std::size_t(4), std::size_t(6), std::size_t(7), std::size_t(1) << 32})
    EXPECT_THROW(IT::shortest_path_on_triangles(points, triangles, 0, target), IT::Invalid_argument_error) << target;
  const IT::Path_on_triangles none = IT::shortest_path_on_triangles(points, triangles, 2, 2);
  EXPECT_EQ(none.positions.size(), 1u);
  EXPECT_TRUE(none.points.size() == 1 && none.length == 0 && none.is_complete);
  EXPECT_THROW(IT::shortest_path_on_triangles(points, triangles, 0, 1, CGAL::parameters::visitor([] { return false; })),
               IT::Cancelled_error);
}

} // namespace
