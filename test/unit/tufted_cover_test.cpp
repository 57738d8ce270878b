// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The gluing of a tufted cover, its order, and the faces that are dropped first.

#include <CGAL/Intrinsic_triangulations/Tufted_cover.h>
#include "library/gluing/Faces_around_edge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <set>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Coincident_vertices;
using IT::Surface_cover;
using IT::Tufted_cover;
using Faces = IT::internal::Faces_around_edge;
using Point = std::array<double, 3>;
using Points = std::vector<Point>;
using Triangles = std::vector<std::array<int, 3>>;
using Defect = IT::Invalid_surface_error::Defect;

IT::internal::Points large_vector(const Points& points) { return IT::internal::Points(points.begin(), points.end()); }

// The third vertices of the faces at the edge 0-1 in order, beginning with the smallest.
std::vector<std::uint32_t> order_around_edge(const Points& points, const std::vector<std::uint32_t>& third_vertices)
{
  const IT::internal::Points copy = large_vector(points);
  std::vector<Faces::Face> faces;
  for (std::uint32_t w : third_vertices)
    faces.push_back({w, std::uint32_t(faces.size())});
  Faces(copy, 0, 1).sort(faces);
  std::vector<std::uint32_t> order;
  for (const Faces::Face& f : faces)
    order.push_back(f.third_vertex);
  std::rotate(order.begin(), std::min_element(order.begin(), order.end()), order.end());
  return order;
}

// An integer matrix whose rows are orthogonal and equally long: a rotation that rounds nothing.
Point turned(const Point& p)
{
  // of the quaternion (1, 2, -1, 3)
  const double w = 1, x = 2, y = -1, z = 3;
  return {(w * w + x * x - y * y - z * z) * p[0] + 2 * (x * y - w * z) * p[1] + 2 * (x * z + w * y) * p[2],
          2 * (x * y + w * z) * p[0] + (w * w - x * x + y * y - z * z) * p[1] + 2 * (y * z - w * x) * p[2],
          2 * (x * z - w * y) * p[0] + 2 * (y * z + w * x) * p[1] + (w * w - x * x - y * y + z * z) * p[2]};
}

std::size_t number_of_used_vertices(const IT::Delta_complex& complex)
{
  std::size_t n = 0;
  for (IT::Vertex_index v : complex.vertices())
    n += complex.halfedge(v).is_valid();
  return n;
}

long Euler_characteristic(const Tufted_cover& cover)
{
  const IT::Delta_complex& complex = cover.triangulation.connectivity();
  return long(number_of_used_vertices(complex)) - long(complex.number_of_edges()) + long(complex.number_of_faces());
}

// Requirements on each cover: it lies over the input, and glued sides have the same ends.
void check_cover(const Tufted_cover& cover, const Points& points)
{
  const IT::Delta_complex& complex = cover.triangulation.connectivity();
  ASSERT_TRUE(complex.is_valid());
  ASSERT_EQ(cover.vertex_of.size(), complex.number_of_vertices());
  ASSERT_EQ(cover.face_of.size(), complex.number_of_faces());
  ASSERT_EQ(cover.is_back.size(), complex.number_of_faces());
  ASSERT_EQ(cover.is_half.size(), complex.number_of_faces());
  for (std::size_t v = 0; v < points.size(); ++v)
    EXPECT_EQ(cover.vertex_of[v], v);
  for (IT::Edge_index e : complex.edges()) {
    EXPECT_FALSE(complex.is_border(e));
    const IT::Halfedge_index h = complex.halfedge(e);
    const Point &p = points[cover.vertex_of[complex.source(h).idx()]],
                &q = points[cover.vertex_of[complex.target(h).idx()]];
    EXPECT_NEAR(cover.triangulation.length(e), std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]),
                1e-14 * cover.triangulation.length(e));
  }
}

const Points triangle_points = {{0, 0, 0}, {4, 0, 0}, {1, 3, 0}};

TEST(Faces_around_edge, random_faces_are_in_the_order_of_their_angles)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int round = 0; round < 50; ++round) {
    Points points = {{0, 0, 0}, {0, 0, 1}};
    std::vector<std::uint32_t> third;
    for (std::uint32_t w = 2; w < 12; ++w) {
      points.push_back({uniform(random), uniform(random), uniform(random)});
      third.push_back(w);
    }
    std::vector<std::uint32_t> expected = third;
    std::sort(expected.begin(), expected.end(), [&](std::uint32_t v, std::uint32_t w) {
      return std::atan2(points[v][1], points[v][0]) < std::atan2(points[w][1], points[w][0]);
    });
    std::rotate(expected.begin(), std::min_element(expected.begin(), expected.end()), expected.end());
    std::shuffle(third.begin(), third.end(), random);
    EXPECT_EQ(order_around_edge(points, third), expected);
  }
}

TEST(Faces_around_edge, angles_that_rounding_makes_equal_are_told_apart)
{
  // The third vertices differ by one unit in the last place, across the plane through the edge and (1, 1, z).
  const double more = std::nextafter(1., 2.), less = std::nextafter(1., 0.);
  const Points points = {{0, 0, 0}, {0, 0, 1}, {1, 1, 0.5}, {1, more, 0.25}, {1, less, 0.75}, {-1, 0, 0.1}};
  EXPECT_EQ(order_around_edge(points, {2, 3, 4, 5}), (std::vector<std::uint32_t>{2, 3, 5, 4}));
}

TEST(Faces_around_edge, neither_rotation_nor_direction_nor_numbers_matter_in_a_half_plane)
{
  // Three triangles in one half-plane, one without area.
  const Points points = {{0, 0, 0}, {0, 0, 8}, {3, 0, 2}, {5, 0, 5}, {1, 0, 5}, {-7, 1, 3}, {0, 0, 3}, {2, -5, 1}};
  const std::vector<std::uint32_t> third = {2, 3, 4, 5, 6, 7};
  // At 4 and 3, beyond the middle, the nearer one first; 6 joins the half-plane of 5, which reaches farthest, and is
  // behind it, as the place is before the middle.
  const std::vector<std::uint32_t> expected = {2, 4, 3, 5, 6, 7};
  EXPECT_EQ(order_around_edge(points, third), expected);
  std::mt19937 random(2);
  for (int round = 0; round < 100; ++round) {
    std::vector<std::uint32_t> number(points.size());
    std::iota(number.begin(), number.end(), 0u);
    std::shuffle(number.begin() + 2, number.end(), random);
    const bool is_exchanged = round % 2 == 1;
    if (is_exchanged)
      std::swap(number[0], number[1]);
    Points renumbered(points.size());
    for (std::size_t v = 0; v < points.size(); ++v)
      renumbered[number[v]] = round % 3 == 0 ? turned(points[v]) : points[v];
    std::vector<std::uint32_t> shuffled;
    for (std::uint32_t w : third)
      shuffled.push_back(number[w]);
    std::shuffle(shuffled.begin(), shuffled.end(), random);
    std::vector<std::uint32_t> order = order_around_edge(renumbered, shuffled);
    if (is_exchanged)
      std::reverse(order.begin(), order.end());
    for (std::uint32_t& w : order)
      w = std::uint32_t(std::find(number.begin(), number.end(), w) - number.begin());
    std::rotate(order.begin(), std::min_element(order.begin(), order.end()), order.end());
    EXPECT_EQ(order, expected) << round;
  }
}

TEST(Tufted_cover, one_triangle_is_a_sphere_of_two)
{
  const Tufted_cover cover = IT::make_tufted_cover(triangle_points, Triangles{{0, 1, 2}});
  check_cover(cover, triangle_points);
  EXPECT_EQ(cover.triangulation.connectivity().number_of_faces(), 2u);
  EXPECT_EQ(cover.triangulation.connectivity().number_of_vertices(), 3u);
  EXPECT_EQ(cover.face_of, (std::vector<std::uint32_t>{0, 0}));
  EXPECT_EQ(cover.is_back, (std::vector<bool>{false, true}));
  EXPECT_EQ(Euler_characteristic(cover), 2);
  EXPECT_EQ(cover.report.border_edges, 3u);
  EXPECT_EQ(cover.report.nonmanifold_edges, 0u);
  EXPECT_EQ(cover.report.nonmanifold_vertices, 0u);
  EXPECT_TRUE(cover.report.is_orientable);
}

TEST(Tufted_cover, three_triangles_at_an_edge_see_each_other_in_pairs)
{
  const Points points = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 2, 0}, {-1, -2, 0}};
  const Triangles triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
  const Tufted_cover cover = IT::make_tufted_cover(points, triangles);
  check_cover(cover, points);
  EXPECT_EQ(cover.report.nonmanifold_edges, 1u);
  EXPECT_EQ(cover.report.border_edges, 6u);
  EXPECT_EQ(Euler_characteristic(cover), 2);
  // Each wedge between two faces has one edge, to which both belong.
  const IT::Delta_complex& complex = cover.triangulation.connectivity();
  std::set<std::set<std::uint32_t>> wedges;
  for (IT::Edge_index e : complex.edges()) {
    const IT::Halfedge_index h = complex.halfedge(e);
    if (cover.vertex_of[complex.source(h).idx()] + cover.vertex_of[complex.target(h).idx()] == 1)
      wedges.insert({cover.face_of[complex.face(h).idx()], cover.face_of[complex.face(complex.opposite(h)).idx()]});
  }
  EXPECT_EQ(wedges, (std::set<std::set<std::uint32_t>>{{0, 1}, {1, 2}, {0, 2}}));
  // The sides that face each other: that of face 0 with face 1 on its left, seen from vertex 1, is the front of face 0.
  for (IT::Edge_index e : complex.edges()) {
    const IT::Halfedge_index h = complex.halfedge(e);
    for (IT::Halfedge_index g : {h, complex.opposite(h)}) {
      const std::size_t f = complex.face(g).idx(), other = complex.face(complex.opposite(g)).idx();
      if (cover.face_of[f] == 0 && cover.face_of[other] != 0) {
        EXPECT_EQ(cover.is_back[f], cover.face_of[other] == 2);
      }
    }
  }
}

TEST(Tufted_cover, Moebius_strip_has_a_torus)
{
  Points points;
  Triangles triangles;
  const int n = 9;
  for (int i = 0; i < n; ++i) {
    const double a = 2 * 3.14159265358979 * i / n;
    for (int side : {-1, 1})
      points.push_back({(3 + side * std::cos(a / 2)) * std::cos(a), (3 + side * std::cos(a / 2)) * std::sin(a),
                        side * std::sin(a / 2)});
  }
  for (int i = 0; i < n; ++i) {
    const int a = 2 * i, b = 2 * i + 1;
    const int c = i + 1 < n ? a + 2 : 1, d = i + 1 < n ? b + 2 : 0;
    triangles.push_back({a, c, b});
    triangles.push_back({b, c, d});
  }
  const Tufted_cover cover = IT::make_tufted_cover(points, triangles);
  check_cover(cover, points);
  EXPECT_FALSE(cover.report.is_orientable);
  EXPECT_EQ(cover.report.border_edges, std::size_t(2 * n));
  EXPECT_EQ(Euler_characteristic(cover), 0);
  const auto none = CGAL::parameters::surface_cover(Surface_cover::NONE);
  try {
    IT::make_tufted_cover(points, triangles, none);
    FAIL();
  } catch (const IT::Invalid_surface_error& error) {
    EXPECT_EQ(error.defect(), Defect::INCONSISTENT_ORIENTATION);
  }
}

TEST(Tufted_cover, a_closed_surface_is_its_own_cover_however_its_faces_are_turned)
{
  const Points points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {9, 9, 9}};
  for (const Triangles& triangles :
       {Triangles{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}, Triangles{{0, 2, 1}, {1, 0, 3}, {3, 2, 1}, {2, 0, 3}}}) {
    const Tufted_cover cover = IT::make_tufted_cover(points, triangles);
    check_cover(cover, points);
    EXPECT_EQ(cover.triangulation.connectivity().number_of_faces(), 4u);
    EXPECT_EQ(cover.is_half, std::vector<bool>(4, false));
    EXPECT_EQ(Euler_characteristic(cover), 2);
    EXPECT_TRUE(cover.report.is_orientable);
    EXPECT_EQ(cover.report.unreferenced_vertices, 1u);
  }
}

TEST(Tufted_cover, only_what_needs_it_is_doubled)
{
  Points points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const Point& p : triangle_points)
    points.push_back({p[0] + 10, p[1], p[2]});
  const Tufted_cover cover =
    IT::make_tufted_cover(points, Triangles{{0, 2, 1}, {4, 5, 6}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  check_cover(cover, points);
  EXPECT_EQ(cover.face_of, (std::vector<std::uint32_t>{0, 1, 1, 2, 3, 4}));
  EXPECT_EQ(cover.is_half, (std::vector<bool>{false, true, true, false, false, false}));
}

TEST(Tufted_cover, bow_tie_has_two_vertices_at_the_knot)
{
  const Points points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0.5}};
  const Tufted_cover cover = IT::make_tufted_cover(points, Triangles{{0, 1, 2}, {0, 3, 4}});
  check_cover(cover, points);
  EXPECT_EQ(cover.report.nonmanifold_vertices, 1u);
  EXPECT_EQ(cover.triangulation.connectivity().number_of_vertices(), 6u);
  EXPECT_EQ(cover.vertex_of[5], 0u);
}

TEST(Tufted_cover, a_hundred_faces_at_an_edge)
{
  Points points = {{0, 0, 0}, {0, 0, 1}};
  Triangles triangles;
  std::mt19937 random(5);
  std::uniform_int_distribution<int> coordinate(-3, 3);
  for (int i = 0; i < 100; ++i) { // many in the same half-planes, some twice, some without area
    points.push_back({double(coordinate(random)), double(coordinate(random)), coordinate(random) + 0.5});
    triangles.push_back({0, 1, i + 2});
    if (i % 7 == 0)
      triangles.push_back({1, 0, i + 2});
  }
  const Tufted_cover cover = IT::make_tufted_cover(points, triangles);
  EXPECT_EQ(cover.report.nonmanifold_edges, 1u);
  EXPECT_EQ(cover.report.border_edges, 200u - 30u);
  check_cover(cover, points);
}

TEST(Tufted_cover, faces_that_repeat_a_corner_are_dropped)
{
  const Tufted_cover cover = IT::make_tufted_cover(triangle_points, Triangles{{0, 1, 1}, {0, 1, 2}, {2, 2, 2}});
  EXPECT_EQ(cover.report.repeated_corner_faces, 2u);
  EXPECT_EQ(cover.report.dropped_faces(), 2u);
  EXPECT_EQ(cover.face_of, (std::vector<std::uint32_t>{1, 1}));
}

TEST(Tufted_cover, coincident_vertices_have_a_policy)
{
  const Points points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, -0., 0}, {1, 1, 0}};
  const Triangles triangles = {{0, 1, 2}, {1, 3, 2}, {3, 4, 2}};
  const Tufted_cover merged = IT::make_tufted_cover(points, triangles);
  EXPECT_EQ(merged.report.merged_vertices, 1u);
  EXPECT_EQ(merged.report.collapsed_faces, 1u);
  EXPECT_EQ(merged.representative, (std::vector<std::uint32_t>{0, 1, 2, 1, 4}));
  EXPECT_EQ(merged.report.border_edges, 4u);
  const Tufted_cover dropped =
    IT::make_tufted_cover(points, triangles, CGAL::parameters::coincident_vertices(Coincident_vertices::DROP));
  EXPECT_EQ(dropped.report.merged_vertices, 0u);
  EXPECT_EQ(dropped.report.zero_length_faces, 1u);
  EXPECT_EQ(dropped.report.border_edges, 6u);
  try {
    IT::make_tufted_cover(points, triangles, CGAL::parameters::coincident_vertices(Coincident_vertices::ERROR));
    FAIL();
  } catch (const IT::Invalid_surface_error& error) {
    EXPECT_EQ(error.defect(), Defect::ZERO_LENGTH_EDGE);
    EXPECT_STREQ(error.what(), "vertices 1 and 3 of face 1 are at the same place; merge them, or drop the face");
  }
}

TEST(Tufted_cover, soups_are_welded_on_request_only)
{
  const Points points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const Triangles triangles = {{0, 1, 2}, {3, 4, 5}};
  EXPECT_EQ(IT::make_tufted_cover(points, triangles).report.border_edges, 6u);
  const Tufted_cover welded = IT::make_tufted_cover(points, triangles, CGAL::parameters::is_welded(true));
  EXPECT_EQ(welded.report.border_edges, 4u);
  EXPECT_EQ(welded.report.merged_vertices, 2u);
}

TEST(Tufted_cover, parts_without_area_are_dropped)
{
  // A fin that is attached to nothing, and one that is given twice, so that the copies enclose one more part.
  const Points points = {{0, 0, 0}, {4, 0, 0}, {1, 3, 0}, {2, 0, 0}, {7, 0, 0}, {8, 0, 0}, {9, 0, 0}};
  const Tufted_cover cover = IT::make_tufted_cover(points, Triangles{{0, 1, 2}, {4, 5, 6}, {0, 1, 3}, {0, 1, 3}});
  check_cover(cover, points);
  EXPECT_EQ(cover.report.faces_without_area, 1u);
  EXPECT_EQ(cover.report.unreferenced_vertices, 3u);
  EXPECT_EQ(cover.triangulation.connectivity().number_of_faces(), 4u);
}

// Each of these segments contains all of those before it: looking at their parts one by one would take some minutes.
TEST(Tufted_cover, segments_that_lie_on_each_other_take_linear_time)
{
  constexpr int n = 100000, m = 70000; // the numbers of segments, and of the first vertex of a face with area
  Points points;
  for (int i = 0; i <= n; ++i)
    points.push_back({double(i), 0, 0});
  points.push_back({m, 1, 0});
  Triangles triangles;
  for (int i = 1; i < n; ++i)
    triangles.push_back({0, i + 1, i});
  triangles.push_back({m, m + 1, n + 1});
  const Tufted_cover cover = IT::make_tufted_cover(points, triangles);
  EXPECT_EQ(cover.report.faces_without_area, std::size_t(m - 1));
  EXPECT_EQ(cover.flat_edges.size(), std::size_t(n - 1));
  for (const auto& edge : cover.flat_edges)
    ASSERT_EQ(edge.length, 1);
}

TEST(Tufted_cover, nothing_but_faces_without_area_leaves_nothing)
{
  const Points points = {{0, 0, 0}, {1, 1, 1}, {3, 3, 3}};
  const Tufted_cover cover = IT::make_tufted_cover(points, Triangles{{0, 1, 2}});
  EXPECT_EQ(cover.report.faces_without_area, 1u);
  EXPECT_EQ(cover.report.unreferenced_vertices, 3u);
  EXPECT_EQ(cover.triangulation.connectivity().number_of_faces(), 0u);
}

TEST(Tufted_cover, what_cannot_be_covered_is_refused)
{
  const auto defect = [](const Points& points, const Triangles& triangles) {
    try {
      IT::make_tufted_cover(points, triangles);
    } catch (const IT::Invalid_surface_error& error) {
      return error.defect();
    }
    return Defect::WRONG_TOPOLOGY;
  };
  EXPECT_EQ(defect(triangle_points, {}), Defect::EMPTY);
  EXPECT_EQ(defect(triangle_points, {{0, 1, 3}}), Defect::BAD_INDEX);
  EXPECT_EQ(defect(triangle_points, {{0, 1, -1}}), Defect::BAD_INDEX);
  EXPECT_EQ(defect({{0, 0, 0}, {1, 0, 0}, {0, std::numeric_limits<double>::infinity(), 0}}, {{0, 1, 2}}),
            Defect::NOT_FINITE);
  Points points = triangle_points;
  points.push_back({std::nan(""), 0, 0}); // of no face: refused as files with it are
  EXPECT_EQ(defect(points, {{0, 1, 2}}), Defect::NOT_FINITE);
}

TEST(Tufted_cover, without_a_cover_the_border_stays)
{
  const auto none = CGAL::parameters::surface_cover(Surface_cover::NONE);
  const Points points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  const Tufted_cover cover = IT::make_tufted_cover(points, Triangles{{0, 1, 2}, {1, 2, 3}}, none);
  EXPECT_EQ(cover.triangulation.connectivity().number_of_faces(), 2u);
  EXPECT_EQ(cover.is_back, (std::vector<bool>{false, true}));
  EXPECT_EQ(cover.is_half, std::vector<bool>(2, false));
  EXPECT_THROW(IT::make_tufted_cover(points, Triangles{{0, 1, 2}, {0, 1, 3}, {1, 0, 2}}, none),
               IT::Invalid_surface_error);
}

TEST(Tufted_cover, extreme_coordinates_are_ordered_as_well)
{
  for (double scale : {1e-250, 1e-100, 1e100, 1e250}) {
    Points points = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 2, 0}, {-1, -2, 0}, {3, 0, 0.25}};
    const Triangles triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {0, 1, 5}};
    const Tufted_cover expected = IT::make_tufted_cover(points, triangles);
    for (Point& p : points)
      for (double& x : p)
        x *= scale;
    const Tufted_cover cover = IT::make_tufted_cover(points, triangles);
    EXPECT_EQ(cover.triangulation.connectivity(), expected.triangulation.connectivity()) << scale;
  }
}

} // namespace
