// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// In a plane, the intrinsic Delaunay triangulation is the Delaunay triangulation.

#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Data_structure =
  CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>>;
using Bad_triangulation = CGAL::Triangulation_2<Kernel, Data_structure>;
using Delaunay_triangulation = CGAL::Delaunay_triangulation_2<Kernel, Data_structure>;
using Edge_set = std::set<std::pair<std::uint32_t, std::uint32_t>>;

namespace {

// Inserts the points in the given order; from left to right, each new point is joined to
// all that it sees, which makes long thin triangles.
template <class Triangulation>
Triangulation inserted(const std::vector<Point>& points)
{
  Triangulation t;
  for (std::size_t i = 0; i < points.size(); ++i)
    t.insert(points[i], t.infinite_vertex()->face())->info() = std::uint32_t(i);
  return t;
}

template <class Traits>
IT::Intrinsic_triangulation<Traits> lifted(const std::vector<Point>& points)
{
  const auto bad = inserted<Bad_triangulation>(points);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (auto f : bad.finite_face_handles())
    triangles.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  std::vector<std::array<double, 3>> coordinates;
  for (const Point& p : points)
    coordinates.push_back({p.x(), p.y(), 0});
  return IT::Intrinsic_triangulation<Traits>(IT::make_Delta_complex_from_triangles(points.size(), triangles),
                                             coordinates);
}

Edge_set edge_set(const IT::Delta_complex& c)
{
  Edge_set result;
  for (IT::Edge_index e : c.edges()) {
    const IT::Halfedge_index h = c.halfedge(e);
    result.insert(std::minmax({c.source(h).idx(), c.target(h).idx()}));
  }
  EXPECT_EQ(result.size(), c.number_of_edges());
  return result;
}

Edge_set edge_set(const Delaunay_triangulation& t)
{
  Edge_set result;
  for (const auto& e : t.finite_edges())
    result.insert(std::minmax({e.first->vertex(t.ccw(e.second))->info(), e.first->vertex(t.cw(e.second))->info()}));
  return result;
}

// Sorted from left to right.
std::vector<Point> random_points(std::size_t n, std::uint64_t seed)
{
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<Point> points;
  while (points.size() < n) {
    const double x = uniform(random);
    points.push_back(Point(x, uniform(random)));
  }
  std::sort(points.begin(), points.end());
  return points;
}

// Some points of an n by n grid.
std::vector<Point> grid_points(int n, double density, std::uint64_t seed)
{
  std::mt19937_64 random(seed);
  std::vector<Point> points;
  for (int x = 0; x < n; ++x)
    for (int y = 0; y < n; ++y)
      if (double(random() >> 11) * 0x1p-53 < density)
        points.push_back(Point(x, y));
  return points;
}

template <class Traits>
void expect_the_edges_of_the_plane(const std::vector<Point>& points)
{
  auto t = lifted<Traits>(points);
  const IT::Flip_report report = IT::flip_to_Delaunay(t);
  EXPECT_EQ(report.status, IT::Flip_status::DELAUNAY);
  EXPECT_GT(report.flips, points.size());
  EXPECT_EQ(edge_set(t.connectivity()), edge_set(inserted<Delaunay_triangulation>(points)));
}

} // namespace

TEST(Planar_Delaunay, edges_of_random_points_in_double)
{
  for (std::uint64_t seed : {1, 2, 3})
    expect_the_edges_of_the_plane<IT::Edge_length_traits<double>>(random_points(1000, seed));
}

TEST(Planar_Delaunay, edges_of_random_points_with_exact_decisions)
{
  for (std::uint64_t seed : {4, 5, 6})
    expect_the_edges_of_the_plane<IT::Filtered_edge_length_traits>(random_points(1000, seed));
}

// Among points of a grid, many squares and rectangles are ties, but not all quadrilaterals.
TEST(Planar_Delaunay, edges_of_grid_points_differ_at_exact_ties_alone)
{
  for (double density : {1., 0.7, 0.3})
    for (std::uint64_t seed : {1, 2, 3}) {
      SCOPED_TRACE(density);
      const std::vector<Point> points = grid_points(density == 1 ? 10 : 16, density, seed);
      auto t = lifted<IT::Filtered_edge_length_traits>(points);
      const IT::Flip_report report = IT::flip_to_Delaunay(t);
      EXPECT_EQ(report.status, IT::Flip_status::DELAUNAY);
      const IT::Delta_complex& c = t.connectivity();
      ASSERT_TRUE(c.is_valid(true));
      const Edge_set expected = edge_set(inserted<Delaunay_triangulation>(points));
      EXPECT_EQ(edge_set(c).size(), expected.size());
      std::size_t ties = 0;
      for (IT::Edge_index e : c.edges()) {
        if (c.is_border(e))
          continue;
        const IT::Halfedge_index h = c.halfedge(e), g = c.opposite(h);
        const auto at = [&](IT::Vertex_index v) { return points[v.idx()]; };
        const CGAL::Oriented_side side = CGAL::side_of_oriented_circle(
          at(c.source(h)), at(c.target(h)), at(c.target(c.next(h))), at(c.target(c.next(g))));
        EXPECT_NE(side, CGAL::ON_POSITIVE_SIDE) << e;
        EXPECT_EQ(t.cotangent_weight(e) == 0, side == CGAL::ON_ORIENTED_BOUNDARY) << e;
        ties += side == CGAL::ON_ORIENTED_BOUNDARY;
        if (expected.count(std::minmax({c.source(h).idx(), c.target(h).idx()})) == 0) {
          EXPECT_EQ(side, CGAL::ON_ORIENTED_BOUNDARY) << e;
        }
      }
      EXPECT_GT(ties, 10u);
    }
}
