// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each kind of repair on a small example, and random polygons: the result is a surface, and each of its elements lies
// where the map says.

#include <CGAL/Intrinsic_triangulations/repair_polygons.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Kind = IT::Repair_kind;
using Points = std::vector<std::array<double, 3>>;
using Polygons = std::vector<std::vector<std::size_t>>;
using Indices = std::vector<std::size_t>;

struct Expected
{
  Kind kind;
  Indices elements;
};

// Vertices have the coordinates of the input vertices that they come from.
void expect_true_corners(const Points& points, const IT::Repaired_polygons& repaired)
{
  for (std::size_t v = 0; v < repaired.points.size(); ++v)
    EXPECT_EQ(repaired.points[v], points[repaired.input_vertices[v]]) << v;
}

// Likewise, and the corners of a triangle are at corners of its input face.
void expect_true_map(const Points& points, const Polygons& polygons, const IT::Repaired_polygons& repaired)
{
  ASSERT_EQ(repaired.input_vertices.size(), repaired.points.size());
  ASSERT_EQ(repaired.input_faces.size(), repaired.triangles.size());
  expect_true_corners(points, repaired);
  for (std::size_t f = 0; f < repaired.triangles.size(); ++f) {
    const Indices& face = polygons[repaired.input_faces[f]];
    for (std::size_t v : repaired.triangles[f])
      EXPECT_TRUE(std::any_of(face.begin(), face.end(), [&](std::size_t w) { return points[w] == repaired.points[v]; }))
        << f;
  }
  EXPECT_TRUE(std::is_sorted(repaired.input_faces.begin(), repaired.input_faces.end()));
}

// Repairs, and expects a surface with exactly these repairs.
IT::Repaired_polygons expect_repaired(const Points& points, const Polygons& polygons,
                                      const std::vector<Expected>& expected)
{
  const IT::Repaired_polygons repaired = IT::repair_polygons(points, polygons);
  EXPECT_EQ(repaired.repairs.size(), expected.size());
  for (std::size_t i = 0; i < (std::min)(repaired.repairs.size(), expected.size()); ++i) {
    const IT::Repair& repair = repaired.repairs[i];
    EXPECT_EQ(static_cast<int>(repair.kind), static_cast<int>(expected[i].kind)) << IT::message(repair);
    EXPECT_EQ(repair.elements, expected[i].elements) << IT::message(repair);
    EXPECT_EQ(repair.count, expected[i].elements.size()) << IT::message(repair);
  }
  const IT::Surface_report report = IT::examine_polygons(repaired.points, repaired.triangles);
  EXPECT_EQ(report.first_fatal(), nullptr) << IT::message(report);
  EXPECT_EQ(report.find(IT::Invalid_surface_error::Defect::UNREFERENCED_VERTEX), nullptr);
  expect_true_map(points, polygons, repaired);
  return repaired;
}

IT::Surface_report examine(const IT::Repaired_polygons& repaired)
{
  return IT::examine_polygons(repaired.points, repaired.triangles);
}

const Points cube_points = {{{0, 0, 0}}, {{1, 0, 0}}, {{1, 1, 0}}, {{0, 1, 0}},
                            {{0, 0, 1}}, {{1, 0, 1}}, {{1, 1, 1}}, {{0, 1, 1}}};
const Polygons cube_faces = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
const Points tetrahedron_points = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}};
const Polygons tetrahedron_faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

TEST(Repair_polygons, leaves_a_surface_as_it_is)
{
  const IT::Repaired_polygons repaired = expect_repaired(tetrahedron_points, tetrahedron_faces, {});
  EXPECT_EQ(repaired.points, tetrahedron_points);
  ASSERT_EQ(repaired.triangles.size(), 4u);
  for (std::size_t f = 0; f < 4; ++f)
    EXPECT_EQ(Indices(repaired.triangles[f].begin(), repaired.triangles[f].end()), tetrahedron_faces[f]);
  EXPECT_EQ(repaired.input_faces, (Indices{0, 1, 2, 3}));
}

TEST(Repair_polygons, triangulates)
{
  const IT::Repaired_polygons repaired =
    expect_repaired(cube_points, cube_faces, {{Kind::TRIANGULATED_FACE, {0, 1, 2, 3, 4, 5}}});
  EXPECT_EQ(repaired.input_faces, (Indices{0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5}));
  EXPECT_EQ(examine(repaired).number_of_border_edges, 0u);
  EXPECT_EQ(IT::message(repaired.repairs[0]), "face 0 (4 corners) was cut into triangles, and 5 more faces like it");

  // An L: the corner at (1, 1) is reflex, so that a fan from vertex 0 would leave the polygon.
  const Points l = {{{2, 0, 0}}, {{2, 1, 0}}, {{1, 1, 0}}, {{1, 2, 0}}, {{0, 2, 0}}, {{0, 0, 0}}};
  const IT::Repaired_polygons planar = expect_repaired(l, {{0, 1, 2, 3, 4, 5}}, {{Kind::TRIANGULATED_FACE, {0}}});
  double area = 0;
  for (const auto& [a, b, c] : planar.triangles) {
    const auto &p = planar.points[a], &q = planar.points[b], &r = planar.points[c];
    const double twice = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
    EXPECT_GE(twice, 0);
    area += twice / 2;
  }
  EXPECT_EQ(area, 3);
}

double area(const IT::Repaired_polygons& repaired)
{
  double sum = 0;
  for (const auto& [a, b, c] : repaired.triangles) {
    std::array<double, 3> u, v;
    for (std::size_t i = 0; i < 3; ++i) {
      u[i] = repaired.points[b][i] - repaired.points[a][i];
      v[i] = repaired.points[c][i] - repaired.points[a][i];
    }
    sum += std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2;
  }
  return sum;
}

TEST(Repair_polygons, keeps_holes_and_pinches)
{
  // A square hole behind a slit, in the middle and at a corner; two squares that touch there.
  const Points points = {{{0, 0, 0}}, {{4, 0, 0}}, {{4, 4, 0}}, {{0, 4, 0}}, {{1, 1, 0}}, {{1, 3, 0}}, {{3, 3, 0}},
                         {{3, 1, 0}}, {{0, 1, 0}}, {{1, 0, 0}}, {{5, 4, 0}}, {{5, 5, 0}}, {{4, 5, 0}}};
  const auto repaired = [&](const Indices& polygon) { return IT::repair_polygons(points, Polygons{polygon}); };
  const IT::Repaired_polygons keyhole = repaired({0, 1, 2, 3, 0, 4, 5, 6, 7, 4});
  EXPECT_EQ(area(keyhole), 12);
  EXPECT_EQ(examine(keyhole).number_of_border_edges, 8u);
  EXPECT_EQ(area(repaired({2, 3, 0, 1, 2, 6, 7, 4, 5, 6})), 12);
  EXPECT_EQ(area(repaired({0, 1, 2, 3, 0, 8, 4, 9})), 15); // no hole: the ring runs back along its sides
  EXPECT_EQ(area(repaired({0, 1, 2, 10, 11, 12, 2, 3})), 17);
  EXPECT_EQ(area(repaired({0, 1, 2, 6, 7, 4, 5, 6, 2, 3})), 12);
  // The same with each visit of a place as a vertex of its own.
  Points corners;
  Indices all;
  for (std::size_t v : {0, 1, 2, 3, 0, 4, 5, 6, 7, 4}) {
    all.push_back(corners.size());
    corners.push_back(points[v]);
  }
  const IT::Repaired_polygons doubled = IT::repair_polygons(corners, Polygons{all});
  EXPECT_EQ(area(doubled), 12);
  EXPECT_EQ(examine(doubled).number_of_border_edges, 8u);
}

TEST(Repair_polygons, says_what_became_a_fan)
{
  for (const std::size_t n : {100, 500}) {
    Points points;
    Indices polygon;
    for (std::size_t i = 0; i < n; ++i) { // twice around
      const double t = static_cast<double>(i) * 2 * 3.14159265358979 / static_cast<double>(n), r = 2 + std::cos(3 * t);
      polygon.push_back(i);
      points.push_back({{r * std::cos(2 * t), r * std::sin(2 * t), std::sin(3 * t)}});
    }
    const IT::Repaired_polygons repaired = IT::repair_polygons(points, Polygons{polygon});
    EXPECT_EQ(repaired.triangles.size(), n - 2);
    ASSERT_EQ(repaired.repairs.size(), n == 100 ? 1u : 2u);
    if (n == 500) {
      EXPECT_EQ(IT::message(repaired.repairs[1]).substr(0, 26), "face 0 (500 corners) is 1 ");
    }
  }
}

TEST(Repair_polygons, triangulates_polygons_of_any_size_and_shape)
{
  // So small and so large that squares of coordinates are no doubles, and on a line.
  for (const double scale : {1e-300, 1e-160, 1., 1e160, 1e308, -1.7e308}) {
    Points points = cube_points;
    for (auto& p : points)
      for (double& x : p)
        x *= scale;
    EXPECT_EQ(IT::repair_polygons(points, cube_faces).triangles.size(), 12u) << scale;
  }
  Points line;
  Indices all;
  for (std::size_t i = 0; i < 7; ++i) {
    line.push_back({{1. * static_cast<double>(i), 0, 0}});
    all.push_back(i);
  }
  EXPECT_EQ(IT::repair_polygons(line, Polygons{all}).triangles.size(), 5u);
  // Many corners, not in a plane.
  Points curve;
  Indices round;
  for (std::size_t i = 0; i < 3000; ++i) {
    const double t = static_cast<double>(i) * 2 * 3.14159265358979 / 3000;
    curve.push_back({{std::cos(t), std::sin(t), std::sin(7 * t)}});
    round.push_back(i);
  }
  EXPECT_EQ(IT::repair_polygons(curve, Polygons{round}).triangles.size(), 2998u);
}

TEST(Repair_polygons, orients)
{
  Polygons faces = tetrahedron_faces;
  std::reverse(faces[1].begin(), faces[1].end());
  std::reverse(faces[3].begin(), faces[3].end());
  expect_repaired(tetrahedron_points, faces, {{Kind::REVERSED_FACE, {1, 3}}});
}

TEST(Repair_polygons, cuts_where_three_faces_meet)
{
  const Points points = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}, {{0, -1, 0}}};
  const IT::Repaired_polygons repaired = expect_repaired(
    points, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}, {{Kind::SPLIT_VERTEX, {0, 1}}, {Kind::OPENED_EDGE, {0, 1, 2}}});
  EXPECT_EQ(repaired.points.size(), 9u);
  EXPECT_EQ(examine(repaired).number_of_components, 3u);
  EXPECT_EQ(
    IT::message(repaired.repairs[1]),
    "edge 0-1 of face 0 became border: of its 3 faces, no other one was left that fits, and 2 more edges like it");
}

TEST(Repair_polygons, separates_fans_that_touch_at_a_vertex)
{
  const Points points = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{-1, 0, 0}}, {{0, -1, 0}}};
  const IT::Repaired_polygons repaired = expect_repaired(points, {{0, 1, 2}, {0, 3, 4}}, {{Kind::SPLIT_VERTEX, {0}}});
  EXPECT_EQ(repaired.input_vertices, (Indices{0, 1, 2, 3, 4, 0}));
}

TEST(Repair_polygons, keeps_two_solids_that_share_an_edge_whole)
{
  // Four faces at the edge from (0,0,0) to (0,0,1).
  Points points = {{{0, 0, 0}}, {{0, 0, 1}}, {{1, 0, 0}}, {{0, 1, 0}}, {{-1, 0, 0}}, {{0, -1, 0}}};
  const Polygons faces = {{0, 3, 2}, {0, 2, 1}, {2, 3, 1}, {3, 0, 1}, {0, 5, 4}, {0, 4, 1}, {4, 5, 1}, {5, 0, 1}};
  const IT::Repaired_polygons repaired = expect_repaired(points, faces, {{Kind::SPLIT_VERTEX, {0, 1}}});
  EXPECT_EQ(examine(repaired).number_of_border_edges, 0u);
  EXPECT_EQ(examine(repaired).number_of_components, 2u);
}

TEST(Repair_polygons, cuts_a_Moebius_strip_open)
{
  Points points;
  Polygons faces;
  const std::size_t n = 7;
  for (std::size_t i = 0; i < n; ++i) {
    const double t = 2 * 3.14159265358979 * static_cast<double>(i) / static_cast<double>(n);
    for (const double s : {-0.3, 0.3})
      points.push_back(
        {{(1 + s * std::cos(t / 2)) * std::cos(t), (1 + s * std::cos(t / 2)) * std::sin(t), s * std::sin(t / 2)}});
    const std::size_t a = 2 * i, b = 2 * i + 1;
    const std::size_t c = i + 1 < n ? a + 2 : 1, d = i + 1 < n ? b + 2 : 0;
    faces.push_back({a, c, b});
    faces.push_back({b, c, d});
  }
  ASSERT_FALSE(IT::examine_polygons(points, faces).is_orientable);
  const IT::Repaired_polygons repaired = IT::repair_polygons(points, faces);
  EXPECT_EQ(examine(repaired).first_fatal(), nullptr);
  EXPECT_EQ(examine(repaired).number_of_components, 1u);
  EXPECT_EQ(repaired.points.size(), points.size() + 2);
  EXPECT_EQ(static_cast<int>(repaired.repairs.back().kind), static_cast<int>(Kind::OPENED_EDGE));
  EXPECT_EQ(repaired.repairs.back().count, 2u);
  expect_true_map(points, faces, repaired);
}

// Each face with corners of its own, as STL has them.
void take_apart(Points& points, Polygons& faces)
{
  Points corners;
  for (Indices& face : faces)
    for (std::size_t& v : face) {
      corners.push_back(points[v]);
      v = corners.size() - 1;
    }
  points = corners;
}

TEST(Repair_polygons, closes_seams)
{
  Points points = tetrahedron_points;
  Polygons faces = tetrahedron_faces;
  std::reverse(faces[2].begin(), faces[2].end());
  take_apart(points, faces);
  const IT::Repaired_polygons repaired =
    expect_repaired(points, faces, {{Kind::MERGED_VERTEX, {3, 4, 6, 7, 8, 9, 10, 11}}, {Kind::REVERSED_FACE, {2}}});
  EXPECT_EQ(repaired.points.size(), 4u);
  EXPECT_EQ(examine(repaired).number_of_border_edges, 0u);
  EXPECT_EQ(IT::message(repaired.repairs[0]),
            "vertex 3 was merged with vertex 0 at the same place, and 7 more vertices like it");
}

TEST(Repair_polygons, glues_no_sheets_that_lie_on_each_other)
{
  Points points = tetrahedron_points;
  Polygons faces = tetrahedron_faces;
  points.insert(points.end(), tetrahedron_points.begin(), tetrahedron_points.end());
  for (const Indices& face : tetrahedron_faces)
    faces.push_back({face[0] + 4, face[1] + 4, face[2] + 4});
  EXPECT_EQ(examine(expect_repaired(points, faces, {})).number_of_components, 2u);

  // Two disks that touch at a vertex of their borders, which each has for itself.
  const Points bow = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 0}}, {{-1, 0, 0}}, {{0, -1, 0}}};
  const IT::Repaired_polygons two = expect_repaired(bow, {{0, 1, 2}, {3, 4, 5}}, {});
  EXPECT_EQ(std::set<std::size_t>(two.input_vertices.begin(), two.input_vertices.end()).size(), 6u);
}

TEST(Repair_polygons, merges_the_ends_of_an_edge_without_length)
{
  // Vertices 1 and 4 coincide; the two faces at the edge between them collapse.
  const Points points = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}, {{1, 0, 0}}};
  const Polygons faces = {{0, 2, 4}, {0, 4, 1}, {0, 1, 3}, {4, 2, 1}, {1, 2, 3}, {2, 0, 3}};
  const IT::Repaired_polygons repaired =
    expect_repaired(points, faces, {{Kind::MERGED_VERTEX, {4}}, {Kind::COLLAPSED_FACE, {1, 3}}});
  EXPECT_EQ(repaired.triangles.size(), 4u);
  EXPECT_EQ(repaired.input_faces, (Indices{0, 2, 4, 5}));
}

double area(const Points& points, const std::vector<std::array<std::size_t, 3>>& triangles)
{
  double result = 0;
  for (const auto& [a, b, c] : triangles) {
    std::array<double, 3> p, q;
    for (std::size_t i = 0; i < 3; ++i) {
      p[i] = points[b][i] - points[a][i];
      q[i] = points[c][i] - points[a][i];
    }
    result += std::hypot(p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]) / 2;
  }
  return result;
}

// The unit square from x = 0 to 1 and another one beside it, which meet at x = 1 but have other vertices there.
struct Two_squares
{
  Points points;
  Polygons faces;
};
Two_squares two_squares(const std::vector<double>& left, const std::vector<double>& right, double angle = 0)
{
  Two_squares result;
  for (const auto& [places, x] : {std::make_pair(left, -1.), std::make_pair(right, 1.)}) {
    const std::size_t first = result.points.size();
    for (const double y : places)
      result.points.push_back({{0, y, 0}});
    result.points.push_back({{x, 0, 0}});
    result.points.push_back({{x, 1, 0}});
    const std::size_t n = places.size(), below = first + n, above = below + 1;
    for (std::size_t i = 0; i + 1 < n; ++i)
      result.faces.push_back(x < 0 ? Indices{first + i, first + i + 1, below}
                                   : Indices{first + i + 1, first + i, below});
    result.faces.push_back(x < 0 ? Indices{first + n - 1, above, below} : Indices{above, first + n - 1, below});
  }
  for (auto& p : result.points)
    p = {{p[0] * std::cos(angle) - p[1] * std::sin(angle), p[0] * std::sin(angle) + p[1] * std::cos(angle), p[0] / 3}};
  return result;
}

TEST(Repair_polygons, stitches_T_junctions)
{
  // One on each side, several, and chains; the ends of the sides are merged.
  const std::vector<std::array<std::vector<double>, 2>> sides = {
    {{{0, 1}, {0, 0.5, 1}}},
    {{{0, 1}, {0, 0.125, 0.25, 0.5, 0.875, 1}}},
    {{{0, 0.25, 0.75, 1}, {0, 0.5, 1}}},
    {{{0, 0.25, 0.5, 1}, {0, 0.375, 0.5, 0.625, 0.75, 1}}}};
  for (const auto& [left, right] : sides)
    for (const bool is_exact : {true, false}) {
      const auto [points, faces] = two_squares(left, right, is_exact ? 0 : 0.3);
      const double tolerance = is_exact ? 0 : 1e-15;
      const IT::Surface_report before = IT::examine_polygons(points, faces);
      ASSERT_EQ(before.gaps.size(), 1u);
      EXPECT_LE(before.stitching_tolerance, tolerance);
      EXPECT_EQ(IT::find_gaps(points, faces).gaps[0].description, before.gaps[0].description);
      const IT::Repaired_polygons apart = IT::repair_polygons(points, faces);
      EXPECT_EQ(examine(apart).gaps.size(), 1u);
      const IT::Repaired_polygons repaired =
        IT::repair_polygons(points, faces, CGAL::parameters::stitching_tolerance(tolerance));
      const IT::Surface_report report = examine(repaired);
      EXPECT_EQ(report.first_fatal(), nullptr) << IT::message(report);
      EXPECT_TRUE(report.gaps.empty());
      EXPECT_EQ(report.number_of_components, 1u);
      EXPECT_EQ(report.number_of_border_edges, 6u);
      EXPECT_NEAR(area(repaired.points, repaired.triangles), area(apart.points, apart.triangles), 1e-14);
      expect_true_corners(points, repaired);
      for (const IT::Repair& repair : repaired.repairs)
        EXPECT_NE(static_cast<int>(repair.kind), static_cast<int>(Kind::OPENED_EDGE));
    }
  const auto [points, faces] = two_squares({0, 1}, {0, 0.5, 1});
  const IT::Repaired_polygons one = IT::repair_polygons(points, faces, CGAL::parameters::stitching_tolerance(0));
  EXPECT_EQ(IT::message(one.repairs.back()), "edge 0-1 of face 0 was split at vertex 5, which lies within it");
  EXPECT_THROW(IT::repair_polygons(points, faces, CGAL::parameters::stitching_tolerance(-1)),
               IT::Invalid_argument_error);
}

// An edge from v = 0 to w = 1 with faces on both sides, and others whose edges end within it or within which it ends.
TEST(Repair_polygons, stitches_edges_of_two_faces)
{
  const Points points = {{{0, 0, 0}}, {{2, 0, 0}}, {{1, 1, 0}},  {{1, -1, 0}}, {{1, 0, 0}},
                         {{1, 0, 1}}, {{1, 1, 1}}, {{1, -1, 1}}, {{1, 1, -1}}, {{1, -1, -1}}};
  struct Case
  {
    Polygons faces;
    std::string gap;
    std::size_t components, border_edges; // after the repair
  };
  const Polygons wall = {{0, 1, 2}, {1, 0, 3}}, finer_wall = {{0, 4, 2}, {4, 1, 2}, {4, 0, 3}, {1, 4, 3}};
  const Polygons solid = {{0, 1, 8}, {1, 0, 9}, {0, 8, 9}, {1, 9, 8}};
  const Polygons finer_solid = {{0, 6, 4}, {4, 6, 1}, {4, 7, 0}, {1, 7, 4}, {0, 7, 6}, {1, 6, 7}};
  const auto both = [](Polygons a, const Polygons& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  };
  const std::string gap = "vertex 4 lies within edge 0-1 of face ";
  for (const Case& c : {Case{both(wall, {{0, 4, 5}, {4, 1, 5}}), gap + "0", 3, 12}, // a finer fin
                        Case{both(finer_wall, {{0, 1, 5}}), gap + "4", 3, 12},      // a finer wall
                        Case{both(wall, {{4, 5, 6}}), gap + "0", 2, 7},             // a corner that touches it
                        Case{both(solid, finer_solid), gap + "0", 2, 0}}) {
    const IT::Surface_report before = IT::find_gaps(points, c.faces);
    ASSERT_EQ(before.gaps.size(), 1u);
    EXPECT_EQ(before.gaps[0].description, c.gap + ", which does not end there");
    EXPECT_EQ(before.stitching_tolerance, 0);
    const IT::Repaired_polygons apart = IT::repair_polygons(points, c.faces),
                                repaired =
                                  IT::repair_polygons(points, c.faces, CGAL::parameters::stitching_tolerance(0));
    const IT::Surface_report report = examine(repaired);
    EXPECT_EQ(report.first_fatal(), nullptr) << IT::message(report);
    EXPECT_EQ(report.number_of_components, c.components) << c.gap;
    EXPECT_EQ(report.number_of_border_edges, c.border_edges) << c.gap;
    EXPECT_NEAR(area(repaired.points, repaired.triangles), area(apart.points, apart.triangles), 1e-14);
    expect_true_corners(points, repaired);
  }
  // Solids that touch are none of this.
  Points apart = points;
  apart.insert(apart.end(), {{{1, 0, 0}}, {{1, 1, -1}}, {{0, -1, 1}}, {{2, -1, 1}}});
  EXPECT_TRUE(IT::find_gaps(apart, both(solid, {{10, 11, 12}, {10, 12, 13}, {10, 13, 11}, {11, 13, 12}})).gaps.empty());
}

// Two rooms whose wall, which is there twice, has vertices within the edges of the outer walls.
TEST(Repair_polygons, stitches_a_wall_between_two_rooms)
{
  Points points;
  for (const double x : {0, 1, 2})
    for (const auto& [y, z] : {std::pair{0., 0.}, std::pair{1., 0.}, std::pair{1., 1.}, std::pair{0., 1.}})
      points.push_back({{x, y, z}});
  Polygons faces = {{0, 3, 2, 1}, {8, 9, 10, 11}};
  for (const std::size_t x : {0, 4})
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t j = (i + 1) % 4;
      faces.push_back({x + i, x + j, x + 4 + j, x + 4 + i});
    }
  points.insert(points.end(), {{{1, 0.5, 0}}, {{1, 1, 0.5}}, {{1, 0.5, 1}}, {{1, 0, 0.5}}}); // 12 to 15
  faces.push_back({4, 12, 5, 13, 6, 14, 7, 15});
  faces.push_back({15, 7, 14, 6, 13, 5, 12, 4});
  EXPECT_EQ(IT::find_gaps(points, faces).gaps[0].count, 4u);
  const IT::Surface_report apart = examine(IT::repair_polygons(points, faces)),
                           joined =
                             examine(IT::repair_polygons(points, faces, CGAL::parameters::stitching_tolerance(0)));
  EXPECT_EQ(joined.first_fatal(), nullptr) << IT::message(joined);
  EXPECT_EQ(joined.number_of_border_edges, 0u);
  EXPECT_EQ(joined.number_of_components, 2u);
  EXPECT_NE(apart.number_of_border_edges, 0u);
}

TEST(Repair_polygons, merges_what_is_nearer_than_the_tolerance)
{
  Points points = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{1 + 4e-13, 0, 0}}, {{1e-13, 1, 0}}, {{1, 1, 0}}};
  const Polygons faces = {{0, 1, 2}, {3, 5, 4}};
  const IT::Surface_report report = IT::examine_polygons(points, faces);
  ASSERT_EQ(report.gaps.size(), 1u);
  EXPECT_EQ(report.gaps[0].count, 2u);
  EXPECT_EQ(report.stitching_tolerance, 5e-13);
  EXPECT_EQ(
    IT::message(report.gaps[0], "so"),
    "vertices 1 and 3 at (1, 0, 0) are only 4e-13 apart, beside an edge 1.41 long, and 1 more pair like it; so");
  EXPECT_EQ(examine(IT::repair_polygons(points, faces, CGAL::parameters::stitching_tolerance(2e-13))).gaps.size(), 1u);
  const IT::Repaired_polygons repaired =
    IT::repair_polygons(points, faces, CGAL::parameters::stitching_tolerance(report.stitching_tolerance));
  EXPECT_EQ(repaired.points.size(), 4u);
  EXPECT_TRUE(examine(repaired).gaps.empty());
  points[3][0] = 1.001; // far enough to be intended
  points[4][0] = 0.001;
  EXPECT_TRUE(IT::examine_polygons(points, faces).gaps.empty());
}

// A closed sheet of zero area along an edge with four vertices, as CAD programs write it.
TEST(Repair_polygons, removes_flat_pieces_that_it_cuts_off)
{
  const Points points = {{{0, 0, 0}}, {{1, 0, 0}}, {{2, 0, 0}}, {{3, 0, 0}}, {{1, 1, 0}}, {{1, 0, 1}}};
  Polygons faces = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 4, 5}, {3, 5, 4}};
  const double before = area(IT::repair_polygons(points, faces));
  for (const Indices& flat : Polygons{{0, 3, 2}, {0, 2, 1}, {2, 3, 0}, {1, 2, 0}})
    faces.push_back(flat);
  const IT::Repaired_polygons repaired = IT::repair_polygons(points, faces);
  std::size_t removed = 0;
  for (const IT::Repair& repair : repaired.repairs) {
    EXPECT_TRUE(repair.kind == Kind::COLLAPSED_FACE || repair.kind == Kind::DUPLICATE_FACE) << IT::message(repair);
    removed += repair.count;
  }
  EXPECT_EQ(removed, 4u);
  EXPECT_EQ(repaired.triangles.size(), 8u);
  EXPECT_EQ(examine(repaired).number_of_border_edges, 0u);
  EXPECT_EQ(area(repaired), before);
  // Nothing else is there: it stays.
  const IT::Repaired_polygons alone = IT::repair_polygons(points, Polygons{{0, 3, 2}, {0, 2, 1}, {1, 2, 3}});
  EXPECT_FALSE(alone.triangles.empty());
}

TEST(Repair_polygons, removes_flat_spikes)
{
  // The tip of a spike, or of one on a spike, whose faces lie on the x-axis.
  Points points = {{{0, 0, 0}}, {{2, 0, 0}}, {{1, 0, 0}}, {{-1, 0, 0}}, {{1, 1, 1}}};
  Polygons faces = {{0, 2, 3}, {2, 1, 3}, {1, 0, 3}, {0, 1, 4}, {2, 0, 4}, {1, 2, 4}};
  const IT::Surface_report report = IT::examine_polygons(points, faces);
  ASSERT_NE(report.first_fatal(), nullptr);
  EXPECT_EQ(report.first_fatal()->description,
            "all faces around vertex 3 (faces 0, 1, 2) have zero area and an angle of zero there");
  EXPECT_TRUE(IT::is_repairable(report.first_fatal()->defect));
  for (const bool has_second_tip : {false, true}) {
    if (has_second_tip) {
      points.push_back({{-2, 0, 0}});
      faces[0] = {0, 2, 5};
      faces.push_back({2, 3, 5});
      faces.push_back({3, 0, 5});
    }
    const IT::Repaired_polygons repaired = IT::repair_polygons(points, faces);
    const IT::Surface_report after = examine(repaired);
    EXPECT_EQ(after.first_fatal(), nullptr) << IT::message(after);
    EXPECT_EQ(after.number_of_border_edges, 0u);
    EXPECT_EQ(repaired.points.size(), 4u);
    EXPECT_NEAR(area(repaired.points, repaired.triangles), 2 * std::sqrt(2.), 1e-14);
    const auto spikes = std::find_if(repaired.repairs.begin(), repaired.repairs.end(),
                                     [](const IT::Repair& repair) { return repair.kind == Kind::FLAT_SPIKE; });
    ASSERT_NE(spikes, repaired.repairs.end());
    EXPECT_EQ(spikes->elements, has_second_tip ? (Indices{3, 5}) : Indices{3});
  }
  // At the border there is room, and faces without area stay.
  const Polygons open = {{0, 2, 3}, {0, 1, 4}};
  EXPECT_EQ(IT::examine_polygons(points, open).first_fatal()->defect,
            IT::Invalid_surface_error::Defect::NON_MANIFOLD_VERTEX);
  EXPECT_EQ(IT::repair_polygons(points, open).triangles.size(), 2u);
}

TEST(Repair_polygons, removes_duplicate_and_collapsed_faces_and_unused_vertices)
{
  Points points = tetrahedron_points;
  points.insert(points.begin(), {{9, 9, 9}});
  Polygons faces;
  for (const Indices& face : tetrahedron_faces)
    faces.push_back({face[0] + 1, face[1] + 1, face[2] + 1});
  faces.insert(faces.begin() + 1, {1, 2, 3}); // face 0, turned over
  faces.push_back({1, 1, 2});
  faces.push_back({});
  faces.push_back({2, 4});
  const IT::Repaired_polygons repaired = expect_repaired(
    points, faces, {{Kind::COLLAPSED_FACE, {5, 6, 7}}, {Kind::DUPLICATE_FACE, {1}}, {Kind::DROPPED_VERTEX, {0}}});
  EXPECT_EQ(repaired.input_vertices, (Indices{1, 2, 3, 4}));
  EXPECT_EQ(repaired.input_faces, (Indices{0, 2, 3, 4}));
}

TEST(Repair_polygons, cuts_polygons_at_vertices_that_they_name_twice)
{
  // A square with a spike, and two triangles in one polygon.
  const Points points = {{{0, 0, 0}}, {{1, 0, 0}}, {{1, 1, 0}}, {{0, 1, 0}}, {{-1, 0, 0}}, {{-1, -1, 0}}, {{0, -1, 0}}};
  const IT::Repaired_polygons spike =
    expect_repaired(points, {{0, 1, 2, 3, 0, 4}}, {{Kind::TRIANGULATED_FACE, {0}}, {Kind::DROPPED_VERTEX, {4, 5, 6}}});
  EXPECT_EQ(spike.triangles.size(), 2u);
  const IT::Repaired_polygons eight =
    expect_repaired(points, {{0, 1, 2, 0, 4, 5}},
                    {{Kind::TRIANGULATED_FACE, {0}}, {Kind::SPLIT_VERTEX, {0}}, {Kind::DROPPED_VERTEX, {3, 6}}});
  EXPECT_EQ(eight.triangles.size(), 2u);
}

TEST(Repair_polygons, says_which_parts_of_faces_it_removes)
{
  const Points square = {{{0, 0, 0}}, {{1, 0, 0}}, {{1, 1, 0}}, {{0, 1, 0}}};
  // Wherever the square is cut, one of the triangles already exists.
  const Polygons both_cuts[] = {{{1, 2, 3}, {0, 1, 2, 3}}, {{0, 1, 2}, {0, 1, 2, 3}}};
  std::size_t losses = 0;
  for (const Polygons& polygons : both_cuts) {
    const IT::Repaired_polygons repaired = IT::repair_polygons(square, polygons);
    for (const IT::Repair& repair : repaired.repairs)
      if (repair.kind == Kind::DUPLICATE_PART) {
        ++losses;
        EXPECT_EQ(repair.elements, Indices{1});
        EXPECT_EQ(IT::message(repair),
                  "face 1 was removed in part after it was cut, as other faces have the same corners");
        EXPECT_EQ(repaired.triangles.size(), 2u);
      }
  }
  EXPECT_EQ(losses, 1u);
  // A square whose triangles all exist already, and a loop that is cut off and exists as well.
  expect_repaired(square, {{0, 1, 2}, {1, 2, 3}, {0, 1, 3}, {0, 2, 3}, {0, 1, 2, 3}},
                  {{Kind::DUPLICATE_PART, {4}}, {Kind::REVERSED_FACE, {1, 2}}});
  const Points bow = {{{0, 0, 0}}, {{1, 0, 0}}, {{1, 1, 0}}, {{-1, 0, 0}}, {{-1, -1, 0}}};
  const IT::Repaired_polygons loop = IT::repair_polygons(bow, Polygons{{0, 1, 2}, {0, 1, 2, 0, 3, 4}});
  ASSERT_FALSE(loop.repairs.empty());
  EXPECT_EQ(static_cast<int>(loop.repairs[0].kind), static_cast<int>(Kind::DUPLICATE_PART));
}

TEST(Repair_polygons, says_why_a_vertex_is_dropped)
{
  const Points points = {{{0, 0, 0}}, {{1, 0, 0}}, {{1, 1, 0}}, {{0, 1, 0}}, {{5, 5, 5}}};
  const IT::Repaired_polygons spur = IT::repair_polygons(points, Polygons{{0, 1, 2, 3, 2}});
  EXPECT_EQ(IT::message(spur.repairs.back()),
            "vertex 3 was dropped, as no triangle of the result has it, and 1 more vertex like it");
  const IT::Repaired_polygons unused = IT::repair_polygons(points, Polygons{{0, 1, 2, 3}});
  EXPECT_EQ(IT::message(unused.repairs.back()), "vertex 4 was dropped, as no face names it");
}

TEST(Repair_polygons, asks_before_each_polygon_whether_to_go_on)
{
  // Thirty crowns of a thousand corners each.
  Points points;
  Polygons crowns;
  for (std::size_t crown = 0; crown < 30; ++crown) {
    crowns.emplace_back();
    for (std::size_t i = 0; i < 1000; ++i) {
      const double t = static_cast<double>(i) * 2 * 3.14159265358979 / 1000;
      crowns.back().push_back(points.size());
      points.push_back({{std::cos(t), std::sin(t), static_cast<double>(3 * crown + i % 2)}});
    }
  }
  std::vector<double> fractions;
  const IT::Progress_function note = [&](double fraction) {
    fractions.push_back(fraction);
    return true;
  };
  EXPECT_EQ(IT::repair_polygons(points, crowns, CGAL::parameters::visitor(note)).triangles.size(), 30u * 998);
  ASSERT_GE(fractions.size(), 32u);
  EXPECT_EQ(fractions.front(), 0);
  EXPECT_EQ(fractions.back(), 1);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  std::size_t asked = 0;
  const IT::Progress_function end = [&](double) { return ++asked < 7; };
  EXPECT_THROW(IT::repair_polygons(points, crowns, CGAL::parameters::visitor(end)), IT::Cancelled_error);
  EXPECT_EQ(asked, 7u);
}

TEST(Repair_polygons, refuses_what_is_damaged)
{
  using Defect = IT::Invalid_surface_error::Defect;
  const auto refused = [](const Points& points, const Polygons& polygons, Defect defect) {
    try {
      IT::repair_polygons(points, polygons);
      ADD_FAILURE() << "it was repaired";
    } catch (const IT::Invalid_surface_error& error) {
      EXPECT_EQ(static_cast<int>(error.defect()), static_cast<int>(defect)) << error.what();
    }
  };
  refused(tetrahedron_points, {}, Defect::EMPTY);
  refused(tetrahedron_points, {{0, 1, 4}}, Defect::BAD_INDEX);
  Points points = tetrahedron_points;
  points[2][1] = std::numeric_limits<double>::quiet_NaN();
  refused(points, tetrahedron_faces, Defect::NOT_FINITE);
  EXPECT_TRUE(IT::is_repairable(IT::Invalid_surface_error::Defect::NOT_A_TRIANGLE));
  EXPECT_FALSE(IT::is_repairable(IT::Invalid_surface_error::Defect::BAD_INDEX));
}

TEST(Repair_polygons, random_polygons_become_surfaces)
{
  std::mt19937 random(5);
  const auto number = [&](int n) { return std::uniform_int_distribution<int>(0, n - 1)(random); };
  int refused = 0;
  for (int round = 0; round < 400; ++round) {
    SCOPED_TRACE(round);
    Points points;
    for (int i = 3 + number(10); i > 0; --i)
      points.push_back({{1. * number(3), 1. * number(3), 1. * number(3)}});
    Polygons polygons;
    for (int i = 1 + number(12); i > 0; --i) {
      polygons.emplace_back();
      for (int k = number(10) == 0 ? number(9) : 3 + number(2); k > 0; --k)
        polygons.back().push_back(static_cast<std::size_t>(number(static_cast<int>(points.size()))));
    }
    IT::Repaired_polygons repaired;
    try {
      repaired = IT::repair_polygons(points, polygons);
    } catch (const IT::Invalid_surface_error& error) {
      EXPECT_EQ(error.defect(), IT::Invalid_surface_error::Defect::WRONG_TOPOLOGY) << error.what();
      ++refused;
      continue;
    }
    expect_true_map(points, polygons, repaired);
    const IT::Surface_report report = examine(repaired);
    EXPECT_TRUE(report.first_fatal() == nullptr || repaired.triangles.empty()) << IT::message(report);
  }
  EXPECT_GT(refused, 0);
  EXPECT_LT(refused, 300);
}

} // namespace
