// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances and paths that do not cross barriers.

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Heat_method.h>
#include <CGAL/Intrinsic_triangulations/Point_location.h>
#include <CGAL/Intrinsic_triangulations/Surface_with_barriers.h>
#include <CGAL/Intrinsic_triangulations/geodesic_path.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/shortest_path.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Surface_point;
using IT::Vertex_index;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;
using Point = std::array<double, 3>;
using Curve = std::vector<Surface_point>;

constexpr double infinity = std::numeric_limits<double>::infinity();

// A square of 8 by 8 in the plane.
class Barriers : public testing::Test
{
protected:
  Surface_point at(double x, double y) const { return IT::locate(complex_, surface_.points, Point{x, y, 0}); }
  // A straight line, with all edges that it crosses.
  Curve line(const Point& from, const Point& to) const
  {
    Triangulation t(complex_, surface_.points);
    const Vertex_index s = IT::vertex_at_point(t, at(from[0], from[1])), e = IT::vertex_at_point(t, at(to[0], to[1]));
    return IT::geodesic_points(t, IT::shortest_path(t, s, e).halfedges);
  }
  IT::Surface_with_barriers with(const std::vector<Curve>& barriers) const
  {
    return IT::Surface_with_barriers(complex_, surface_.points, barriers);
  }
  std::vector<double> distances(const std::vector<Curve>& barriers, const std::vector<Curve>& source,
                                double tolerance = 0) const
  {
    return IT::geodesic_distances_from(with(barriers), {{source, 0}}, CGAL::parameters::tolerance(tolerance)).distances;
  }
  static double length(const Point& p, const Point& q) { return std::hypot(p[0] - q[0], p[1] - q[1]); }
  // Whether the straight line between two points crosses x = 3.5 at y < end.
  static bool is_blocked(const Point& p, const Point& q, double end)
  {
    return (p[0] - 3.5) * (q[0] - 3.5) < 0 && p[1] + (q[1] - p[1]) * (3.5 - p[0]) / (q[0] - p[0]) < end;
  }

  samples::Indexed_triangles surface_ = samples::random_diagonal_grid(8, 8, 5);
  IT::Delta_complex complex_ = IT::make_Delta_complex_from_triangles(surface_.points.size(), surface_.triangles);
};

// A wall from the border to (3.5, 5.25).
TEST_F(Barriers, are_walked_around)
{
  const Point end{3.5, 5.25, 0}, source{1, 1, 0};
  const std::vector<Curve> wall{line({3.5, 0, 0}, end)};
  for (double tolerance : {0., 0.001}) {
    const std::vector<double> found = distances(wall, {{at(1, 1)}}, tolerance);
    ASSERT_EQ(found.size(), surface_.points.size());
    for (std::size_t v = 0; v < found.size(); ++v) {
      const Point& p = surface_.points[v];
      const double expected = is_blocked(p, source, end[1]) ? length(source, end) + length(end, p) : length(source, p);
      EXPECT_NEAR(found[v], expected, tolerance > 0 ? 5e-3 : 1e-12) << p[0] << ' ' << p[1];
    }
  }
}

TEST_F(Barriers, end_where_they_end)
{
  // A slit from (3.5, 2.5) to (3.5, 5.5): the way round the nearer end.
  const Point low{3.5, 2.5, 0}, high{3.5, 5.5, 0}, source{1, 4, 0}, target{6, 4, 0};
  const std::vector<double> found = distances({line(low, high)}, {{at(1, 4)}});
  EXPECT_NEAR(found[4 * 9 + 6], length(source, low) + length(low, target), 1e-12);
  EXPECT_NEAR(found[2 * 9 + 6], length(source, {6, 2, 0}), 0.2);
}

// Points that rounding keeps from an edge are points of it.
TEST_F(Barriers, may_end_within_rounding_of_an_edge)
{
  for (Point& p : surface_.points) // so that lengths are rounded
    p = {0.3 * p[0] - 0.2 * p[1], 0.2 * p[0] + 0.3 * p[1], 0};
  for (IT::Edge_index e : complex_.edges()) {
    const IT::Halfedge_index h = complex_.halfedge(e);
    if (complex_.is_border(e))
      continue;
    for (double height : {1e-300, 1e-17, 1e-14}) {
      // From one side of the edge to the other, as a curve that begins there does.
      const IT::Halfedge_index beyond = complex_.opposite(h);
      const Surface_point end{beyond, {0.2, 0.3, 0.5}};
      const Curve wall{{h, {0.3, 0.7, height}}, {beyond, {0.7, 0.3 + 1e-15, 0}}, end},
        on_edge{{beyond, {0.7, 0.3, 0}}, end};
      const Curve source = IT::source_at_vertex(complex_, complex_.source(h)).parts.front();
      const std::vector<double> found = distances({wall}, {source}), expected = distances({on_edge}, {source});
      for (std::size_t v = 0; v < found.size(); ++v)
        ASSERT_NEAR(found[v], expected[v], 1e-11) << e.idx() << ' ' << v << ' ' << height;
    }
  }
}

TEST_F(Barriers, may_be_edges_and_have_a_distance_on_each_side)
{
  // Along edges, from the border to (4, 4).
  const IT::Surface_with_barriers cut = with({line({4, 0, 0}, {4, 4, 0})});
  EXPECT_EQ(cut.copies(Vertex_index(4)).size(), 2u);
  EXPECT_EQ(cut.copies(Vertex_index(4 * 9 + 4)).size(), 1u);
  EXPECT_EQ(cut.copies(Vertex_index(0)).size(), 1u);
  const IT::Geodesic_distances found =
    IT::geodesic_distances_from(cut, {{{{at(2, 0)}}, 0}, {{{at(8, 0)}}, 0}}, CGAL::parameters::tolerance(0.));
  EXPECT_NEAR(found.distances[4], 2, 1e-12);
  EXPECT_EQ(found.nearest_sources[4], 0u);
  EXPECT_NEAR(found.distances[5], 3, 1e-12);
  EXPECT_EQ(found.nearest_sources[5], 1u);
  // A single edge is a barrier, too.
  const std::vector<double> beside_edge = distances({line({4, 2, 0}, {4, 3, 0})}, {{at(3.5, 2.5)}});
  EXPECT_NEAR(beside_edge[2 * 9 + 5], std::hypot(0.5, 0.5) + 1, 1e-12);
}

TEST_F(Barriers, may_be_closed_and_meet)
{
  const Point a{2.5, 2.5, 0}, b{5.5, 2.5, 0}, c{4, 5.5, 0};
  for (const Curve& first : {line(a, b), line(b, a)}) {
    const std::vector<double> found = distances({first, line(b, c), line(c, a)}, {{at(0, 0)}});
    EXPECT_EQ(found[3 * 9 + 4], infinity);
    EXPECT_EQ(found[5 * 9 + 4], infinity);
    EXPECT_NEAR(found[9], 1, 1e-12);
    EXPECT_LT(found[8 * 9 + 8], 16);
  }
}

// Everything is visible from a wall, from its own side.
TEST_F(Barriers, may_be_sources)
{
  const Curve wall = line({3.5, 0, 0}, {3.5, 5.25, 0});
  const std::vector<double> found = distances({wall}, {wall});
  for (std::size_t v = 0; v < found.size(); ++v) {
    const Point& p = surface_.points[v];
    EXPECT_NEAR(found[v], std::hypot(p[0] - 3.5, (std::max)(0., p[1] - 5.25)), 1e-12) << v;
  }
}

TEST_F(Barriers, are_crossed_by_sources)
{
  const Curve wall = line({3.5, 0, 0}, {3.5, 5.25, 0}), across = line({2, 1, 0}, {6, 3, 0});
  const std::vector<double> found = distances({wall}, {across}), free = distances({}, {across});
  for (std::size_t v = 0; v < found.size(); ++v)
    EXPECT_GE(found[v], free[v] - 1e-12) << v;
  for (int v : {0, 8, 9 * 8, 9 * 8 + 8, 9 + 2, 3 * 9 + 6, 9 + 4})
    EXPECT_NEAR(found[v], free[v], 1e-12) << v;
}

TEST_F(Barriers, hold_heat_back)
{
  const IT::Surface_with_barriers cut = with({line({3.5, 0, 0}, {3.5, 7.25, 0})});
  Triangulation t(cut.connectivity(), cut.points());
  IT::flip_to_Delaunay(t);
  IT::Heat_method<> heat(t);
  for (Vertex_index v : cut.copies(Vertex_index(0)))
    heat.add_source(v);
  const IT::Geodesic_distances found = cut.of_nearer_sides({heat.distances(), 0, true, {}});
  EXPECT_EQ(found.distances.size(), surface_.points.size());
  EXPECT_NEAR(found.distances[8], std::hypot(3.5, 7.25) + std::hypot(4.5, 7.25), 1);
}

TEST_F(Barriers, are_no_obstacle_for_the_shortest_path_beside_them)
{
  const Point end{3.5, 5.25, 0};
  const IT::Surface_with_barriers cut = with({line({3.5, 0, 0}, end)});
  Triangulation t(cut.connectivity(), cut.points());
  IT::flip_to_Delaunay(t);
  const IT::Shortest_path path = IT::shortest_path(t, Vertex_index(0), Vertex_index(8));
  EXPECT_NEAR(path.distance, length({0, 0, 0}, end) + length({8, 0, 0}, end), 1e-12);
  const Curve points = cut.on_input(IT::geodesic_points(t, path.halfedges));
  double sum = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    sum += length(IT::point_in_space(complex_, surface_.points, points[i]),
                  IT::point_in_space(complex_, surface_.points, points[i + 1]));
  EXPECT_NEAR(sum, path.distance, 1e-12);
  EXPECT_EQ(points.front().dimension(), 0);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) // each point and its successor lie in the face of the first
    EXPECT_NO_THROW(IT::cut_along_path(complex_, surface_.points, {points[i], points[i + 1]}));
}

TEST_F(Barriers, are_refused_where_they_make_no_sense)
{
  EXPECT_THROW(with({line({1.5, 1.5, 0}, {5.5, 5.25, 0}), line({1.5, 5.5, 0}, {5.5, 1.75, 0})}),
               IT::Invalid_point_error);
  EXPECT_THROW(with({{at(0.25, 0.5), at(7.25, 7.5)}}), IT::Invalid_point_error);
  EXPECT_THROW(distances({}, {{at(0.25, 0.5), at(7.25, 7.5)}}), IT::Invalid_point_error);
  EXPECT_THROW(distances({}, {{{IT::Halfedge_index(), {1, 0, 0}}}}), IT::Invalid_point_error);
  EXPECT_THROW(distances({}, {{{complex_.halfedge(IT::Face_index(0)), {1, -1, 1}}}}), IT::Invalid_point_error);
}

} // namespace
