// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// In a triangulation of a convex region of the plane, intrinsic edges are straight lines between integer points:
// integers decide here what a point lies on, and Point_location must agree, on edges and a hair beside them.

#include "overlay_surfaces.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Intrinsic_triangulations/Point_location.h>
#include <CGAL/Intrinsic_triangulations/squared_lengths.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Triangulation_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using test_surfaces::Overlaid;
using test_surfaces::Triangulation;

__extension__ typedef __int128 Integer;
using Integer_point = std::array<std::int64_t, 2>;

// A triangulation of the convex hull as inserting points one by one leaves it.
struct Planar_mesh
{
  std::vector<Integer_point> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

Planar_mesh random_mesh(int number_of_points, std::uint32_t seed)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
  using Data = CGAL::Triangulation_data_structure_2<Vertex_base, CGAL::Triangulation_face_base_2<Kernel>>;
  CGAL::Triangulation_2<Kernel, Data> triangulation;
  Planar_mesh mesh;
  std::mt19937 random(seed);
  std::set<Integer_point> used;
  while (mesh.points.size() < std::size_t(number_of_points)) {
    const Integer_point p{std::int64_t(random() % 1000), std::int64_t(random() % 1000)};
    if (!used.insert(p).second)
      continue;
    triangulation.insert({double(p[0]), double(p[1])})->info() = std::uint32_t(mesh.points.size());
    mesh.points.push_back(p);
  }
  for (auto f : triangulation.finite_face_handles())
    mesh.triangles.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  return mesh;
}

// A point by homogeneous coordinates.
struct Point
{
  std::int64_t x, y, w;
};

int side(const Planar_mesh& mesh, const IT::Delta_complex& complex, IT::Halfedge_index h, const Point& p)
{
  const Integer_point &a = mesh.points[complex.source(h).idx()], &b = mesh.points[complex.target(h).idx()];
  const Integer d =
    Integer(b[0] - a[0]) * (p.y - Integer(a[1]) * p.w) - Integer(b[1] - a[1]) * (p.x - Integer(a[0]) * p.w);
  return d > 0 ? 1 : d < 0 ? -1 : 0;
}

class Planar_location
{
public:
  Planar_location(const Planar_mesh& mesh, const Overlaid& s) : mesh_(mesh), s_(s), location_(s.subdivision) {}

  void check_random_points(int number)
  {
    std::mt19937 random(1);
    for (bool is_input : {true, false}) {
      const IT::Delta_complex& from = is_input ? s_.input() : s_.intrinsic();
      for (int i = 0; i < number; ++i) {
        const IT::Face_index f(random() % from.number_of_faces());
        std::array<double, 3> b;
        for (double& x : b)
          x = random() % 2 ? random() % 1024 : random() % 3;
        if (b[0] + b[1] + b[2] > 0)
          check({from.halfedge(f), b}, is_input);
      }
    }
  }

  // Points that lie exactly on edges of the other triangulation, and points beside them by
  // 2^-25 of an edge or so.
  void check_points_on_edges()
  {
    for (bool is_input : {true, false}) {
      const IT::Delta_complex &from = is_input ? s_.input() : s_.intrinsic(),
                              &to = is_input ? s_.intrinsic() : s_.input();
      for (IT::Edge_index e : to.edges()) {
        const IT::Halfedge_index h = to.halfedge(e);
        const Integer_point &a = mesh_.points[to.source(h).idx()], &b = mesh_.points[to.target(h).idx()];
        for (std::int64_t m = 1; m < 8; ++m)
          check_around(from, {(8 - m) * a[0] + m * b[0], (8 - m) * a[1] + m * b[1], 8}, is_input);
      }
    }
    EXPECT_GT(on_edges_, 1000);
    EXPECT_GT(beside_edges_, 1000);
  }

  // Points beside crossings, so near that only multiple precision tells on which side.
  void check_points_next_to_crossings()
  {
    for (IT::Overlay::Vertex x : s_.overlay().crossings()) {
      const IT::Halfedge_index o = s_.input().halfedge(s_.overlay().input_edge(x)),
                               c = s_.intrinsic().halfedge(s_.overlay().intrinsic_edge(x));
      for (int i = 0; i < 2; ++i) {
        check_next_to(s_.input(), i == 0 ? o : s_.input().opposite(o), s_.intrinsic(), c, true);
        check_next_to(s_.intrinsic(), i == 0 ? c : s_.intrinsic().opposite(c), s_.input(), o, false);
      }
    }
  }

private:
  // From where h of `from` crosses g of `to`, a 10^40th of the way to the third corner beside h.
  void check_next_to(const IT::Delta_complex& from, IT::Halfedge_index h, const IT::Delta_complex& to,
                     IT::Halfedge_index g, bool is_input)
  {
    const auto corner = [&](IT::Vertex_index v) {
      return Point{mesh_.points[v.idx()][0], mesh_.points[v.idx()][1], 1};
    };
    const Point third = corner(from.target(from.next(h)));
    if (side(mesh_, to, g, third) == 0)
      return;
    const std::array<double, 3> b{std::abs(area(to, g, corner(from.target(h)))),
                                  std::abs(area(to, g, corner(from.source(h)))), 1e-40};
    const Point crossing = combination(from, h, {b[0], b[1], 0});
    const IT::Surface_point q = is_input ? location_.input_to_intrinsic({h, b}) : location_.intrinsic_to_input({h, b});
    EXPECT_EQ(q.dimension(), 2);
    for (IT::Halfedge_index e : {q.halfedge, to.next(q.halfedge), to.prev(q.halfedge)}) {
      const int at_crossing = side(mesh_, to, e, crossing);
      EXPECT_EQ(at_crossing == 0 ? side(mesh_, to, e, third) : at_crossing, 1);
    }
  }

  void check_around(const IT::Delta_complex& from, const Point& p, bool is_input)
  {
    for (IT::Face_index f : from.faces()) {
      const IT::Halfedge_index h = from.halfedge(f);
      if (side(mesh_, from, h, p) < 0 || side(mesh_, from, from.next(h), p) < 0 ||
          side(mesh_, from, from.prev(h), p) < 0)
        continue;
      const std::array<double, 3> b{area(from, from.next(h), p), area(from, from.prev(h), p), area(from, h, p)};
      on_edges_ += check({h, b}, is_input) == 1 ? 1 : 0;
      for (int k = 0; k < 3; ++k)
        for (double d : {-1., 1.}) {
          IT::Surface_point beside{h, {b[0] * 0x1p25, b[1] * 0x1p25, b[2] * 0x1p25}};
          beside.coordinates[k] += d;
          if (beside.coordinates[k] >= 0)
            beside_edges_ += check(beside, is_input) == 2 ? 1 : 0;
        }
    }
  }

  double area(const IT::Delta_complex& c, IT::Halfedge_index h, const Point& p) const
  {
    const Integer_point &a = mesh_.points[c.source(h).idx()], &b = mesh_.points[c.target(h).idx()];
    return double((b[0] - a[0]) * (p.y - a[1] * p.w) - (b[1] - a[1]) * (p.x - a[0] * p.w));
  }

  // The coordinates are integers.
  Point combination(const IT::Delta_complex& complex, IT::Halfedge_index h,
                    const std::array<double, 3>& coordinates) const
  {
    Point p{0, 0, 0};
    for (double b : coordinates) {
      const Integer_point& corner = mesh_.points[complex.source(h).idx()];
      p.x += std::int64_t(b) * corner[0];
      p.y += std::int64_t(b) * corner[1];
      p.w += std::int64_t(b);
      h = complex.next(h);
    }
    return p;
  }

  // Returns 0, 1 or 2: the point lies on a vertex, on an edge, or inside a face.
  int check(const IT::Surface_point& point, bool is_input)
  {
    const IT::Delta_complex &from = is_input ? s_.input() : s_.intrinsic(),
                            &to = is_input ? s_.intrinsic() : s_.input();
    const Point p = combination(from, point.halfedge, point.coordinates);
    const IT::Surface_point q = is_input ? location_.input_to_intrinsic(point) : location_.intrinsic_to_input(point);
    const int left = side(mesh_, to, q.halfedge, p), ahead = side(mesh_, to, to.next(q.halfedge), p),
              behind = side(mesh_, to, to.prev(q.halfedge), p);
    const int dimension = q.dimension();
    EXPECT_EQ(left, dimension == 2 ? 1 : 0);
    EXPECT_EQ(behind, dimension == 0 ? 0 : 1);
    EXPECT_EQ(ahead, 1);
    double x = 0, y = 0;
    IT::Halfedge_index h = q.halfedge;
    for (double b : q.coordinates) {
      x += b * double(mesh_.points[to.source(h).idx()][0]);
      y += b * double(mesh_.points[to.source(h).idx()][1]);
      h = to.next(h);
    }
    EXPECT_NEAR(x, double(p.x) / double(p.w), 1e-12);
    EXPECT_NEAR(y, double(p.y) / double(p.w), 1e-12);
    return dimension;
  }

  const Planar_mesh& mesh_;
  const Overlaid& s_;
  IT::Point_location location_;
  int on_edges_ = 0, beside_edges_ = 0;
};

void check(const Planar_mesh& mesh, Triangulation t)
{
  const Overlaid s(std::move(t));
  EXPECT_GT(s.overlay().number_of_crossings(), mesh.points.size());
  Planar_location location(mesh, s);
  location.check_random_points(5000);
  location.check_points_on_edges();
  location.check_points_next_to_crossings();
}

Triangulation in_space(const Planar_mesh& mesh, double slope)
{
  std::vector<std::array<double, 3>> points;
  for (const Integer_point& p : mesh.points)
    points.push_back({double(p[0]), double(p[1]), slope * double(p[0] + 2 * p[1])});
  return Triangulation(IT::make_Delta_complex_from_triangles(points.size(), mesh.triangles), points);
}

TEST(Planar_point_location, in_the_plane)
{
  for (std::uint32_t seed : {1, 2, 3}) {
    const Planar_mesh mesh = random_mesh(60, seed);
    check(mesh, in_space(mesh, 0));
  }
}

TEST(Planar_point_location, in_a_tilted_plane)
{
  const Planar_mesh mesh = random_mesh(60, 4);
  check(mesh, in_space(mesh, 1)); // all areas are rational multiples of one root
}

// The plane stretched by √2: squared lengths are integers, lengths are not.
TEST(Planar_point_location, by_squared_lengths_alone)
{
  const Planar_mesh mesh = random_mesh(60, 5);
  IT::Delta_complex complex = IT::make_Delta_complex_from_triangles(mesh.points.size(), mesh.triangles);
  std::vector<IT::Rational> squared_lengths;
  for (IT::Edge_index e : complex.edges()) {
    const IT::Halfedge_index h = complex.halfedge(e);
    const Integer_point &a = mesh.points[complex.source(h).idx()], &b = mesh.points[complex.target(h).idx()];
    squared_lengths.emplace_back((b[0] - a[0]) * (b[0] - a[0]) + 2 * (b[1] - a[1]) * (b[1] - a[1]));
  }
  check(mesh,
        Triangulation::from_metric(std::move(complex), IT::metric_from_squared_lengths(std::move(squared_lengths))));
}

} // namespace
