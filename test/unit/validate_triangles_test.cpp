// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every defect by a small example, with the element and the number that are
// reported; surfaces without a defect; the texts.

#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/validate_triangles.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
typedef IT::Invalid_surface_error::Defect Defect;
typedef std::array<double, 3> Point;
typedef std::vector<Point> Points;
typedef std::vector<std::vector<std::size_t>> Polygons;
typedef std::vector<std::size_t> Indices;

// n points in general position, on a curve.
Points curve(const int n)
{
  Points points;
  for (int i = 0; i < n; ++i)
    points.push_back({{1.0 * i, 1.0 * i * i, 1.0 * i * i * i}});
  return points;
}

Polygons tetrahedron() { return {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}; }

// Expects one fatal finding, of this defect, and returns it.
IT::Finding only_fatal(const IT::Surface_report& report, const Defect defect, const Indices& elements,
                       const std::size_t count)
{
  std::size_t fatal = 0;
  for (const IT::Finding& finding : report.findings)
    fatal += finding.is_fatal;
  EXPECT_EQ(fatal, 1u) << IT::message(report);
  const IT::Finding* const finding = report.find(defect);
  if (finding == nullptr) {
    ADD_FAILURE() << "not found: " << IT::message(report);
    return IT::Finding();
  }
  EXPECT_TRUE(finding->is_fatal);
  EXPECT_EQ(finding->defect, defect);
  EXPECT_EQ(finding->elements, elements);
  EXPECT_EQ(finding->count, count);
  try {
    IT::throw_if_fatal(report, "name");
    ADD_FAILURE() << "nothing was thrown";
  } catch (const IT::Invalid_surface_error& error) {
    EXPECT_EQ(error.defect(), defect);
    EXPECT_EQ(error.element(), elements.empty() ? 0 : elements.front());
    EXPECT_EQ(error.count(), count);
    EXPECT_EQ(std::string(error.what()), "name: " + IT::message(*finding));
  }
  return *finding;
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// A grid of n by n squares, each cut into two triangles, on a paraboloid.
void grid(const std::size_t n, Points& points, Polygons& triangles)
{
  for (std::size_t i = 0; i <= n; ++i)
    for (std::size_t j = 0; j <= n; ++j) {
      const double x = static_cast<double>(i), y = static_cast<double>(j);
      points.push_back({{x, y, x * x + y * y}});
    }
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const std::size_t a = i * (n + 1) + j, b = a + n + 1;
      triangles.push_back({a, b, b + 1});
      triangles.push_back({a, b + 1, a + 1});
    }
}

TEST(Validate_triangles, clean_surfaces_have_no_finding)
{
  const IT::Surface_report closed = IT::examine_polygons(curve(4), tetrahedron());
  EXPECT_TRUE(closed.findings.empty()) << IT::message(closed);
  EXPECT_EQ(closed.number_of_vertices, 4u);
  EXPECT_EQ(closed.number_of_faces, 4u);
  EXPECT_EQ(closed.number_of_edges, 6u);
  EXPECT_EQ(closed.number_of_border_edges, 0u);
  EXPECT_EQ(closed.number_of_components, 1u);
  EXPECT_TRUE(closed.is_orientable);
  EXPECT_EQ(closed.first_fatal(), nullptr);
  EXPECT_EQ(IT::message(closed, "name"), "");
  EXPECT_NO_THROW(IT::throw_if_fatal(closed));
  EXPECT_EQ(closed.exponent_of_longest_edge, 5);  // from x = 0 to x = 3: 27 < 32
  EXPECT_EQ(closed.exponent_of_shortest_edge, 1); // from x = 0 to x = 1: 1 < 2

  Points points;
  Polygons triangles;
  grid(7, points, triangles);
  const IT::Surface_report open = IT::examine_polygons(points, triangles);
  EXPECT_TRUE(open.findings.empty()) << IT::message(open);
  EXPECT_EQ(open.number_of_border_edges, 28u);
  EXPECT_EQ(open.number_of_edges, (3 * 98u + 28u) / 2);
}

TEST(Validate_triangles, any_ranges_of_points_and_indices)
{
  typedef CGAL::Simple_cartesian<double>::Point_3 Point_3;
  const std::vector<Point_3> points = {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0)};
  const std::vector<std::array<int, 3>> triangles = {{{0, 1, 2}}};
  EXPECT_TRUE(IT::examine_polygons(points, triangles).findings.empty());
  const std::vector<std::array<int, 3>> negative = {{{0, 1, -1}}};
  only_fatal(IT::examine_polygons(points, negative), Defect::BAD_INDEX, {0}, 1);
}

TEST(Validate_triangles, empty)
{
  only_fatal(IT::examine_polygons(Points(), Polygons()), Defect::EMPTY, {}, 1);
  const IT::Finding finding = only_fatal(IT::examine_polygons(curve(4), Polygons()), Defect::EMPTY, {}, 1);
  EXPECT_TRUE(contains(finding.description, "4 vertices but no face"));
}

TEST(Validate_triangles, bad_index)
{
  Polygons triangles = tetrahedron();
  triangles.push_back({0, 1, 4});
  triangles.push_back({0, static_cast<std::size_t>(-1), 2});
  const IT::Finding finding = only_fatal(IT::examine_polygons(curve(4), triangles), Defect::BAD_INDEX, {4, 5}, 2);
  EXPECT_EQ(finding.description, "face 4 names vertex 4, but there are 4 vertices");
  EXPECT_TRUE(contains(IT::message(finding), "and 1 more face like it; "));
  // Faces, but no vertex at all.
  only_fatal(IT::examine_polygons(Points(), tetrahedron()), Defect::BAD_INDEX, {0, 1, 2, 3}, 4);
}

TEST(Validate_triangles, polygons)
{
  const Polygons faces = {{0, 1, 2}, {0, 2, 3, 4}, {}, {5}, {5, 6}};
  const IT::Surface_report report = IT::examine_polygons(curve(7), faces);
  const IT::Finding finding = only_fatal(report, Defect::NOT_A_TRIANGLE, {1, 2, 3, 4}, 4);
  EXPECT_EQ(finding.description, "face 1 (corners 0, 2, 3, 4) has 4 corners instead of 3");
  EXPECT_TRUE(contains(IT::message(finding), "triangulate"));
  EXPECT_EQ(report.number_of_edges, 6u);
  // At most ten elements are named.
  const IT::Surface_report many = IT::examine_polygons(curve(48), Polygons(12, {0, 1, 2, 3}));
  ASSERT_NE(many.find(Defect::NOT_A_TRIANGLE), nullptr);
  EXPECT_EQ(many.find(Defect::NOT_A_TRIANGLE)->elements.size(), 10u);
  EXPECT_EQ(many.find(Defect::NOT_A_TRIANGLE)->count, 12u);
}

TEST(Validate_triangles, repeated_corner)
{
  const Polygons faces = {{0, 1, 2}, {3, 4, 3}};
  IT::Finding finding = only_fatal(IT::examine_polygons(curve(5), faces), Defect::REPEATED_CORNER, {1}, 1);
  EXPECT_EQ(finding.description, "face 1 (corners 3, 4, 3) names a vertex twice");
  const IT::Surface_report polygon = IT::examine_polygons(curve(5), Polygons{{0, 1, 2, 3, 0, 4}});
  ASSERT_NE(polygon.find(Defect::REPEATED_CORNER), nullptr);
  EXPECT_EQ(polygon.find(Defect::REPEATED_CORNER)->count, 1u);
  // One vertex three times.
  const IT::Surface_report point = IT::examine_polygons(curve(1), Polygons{{0, 0, 0}});
  EXPECT_EQ(point.find(Defect::REPEATED_CORNER)->elements, Indices{0});
}

TEST(Validate_triangles, not_finite)
{
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity()})
    for (int i = 0; i < 3; ++i) {
      Points points = curve(4);
      points[2][static_cast<std::size_t>(i)] = bad;
      const IT::Finding finding = only_fatal(IT::examine_polygons(points, tetrahedron()), Defect::NOT_FINITE, {2}, 1);
      EXPECT_TRUE(contains(finding.description, "vertex 2 has the coordinates ("));
    }
}

TEST(Validate_triangles, duplicate_faces)
{
  // A triangle and its back side: closed, but the same three corners.
  IT::Finding finding =
    only_fatal(IT::examine_polygons(curve(3), Polygons{{0, 1, 2}, {2, 1, 0}}), Defect::DUPLICATE_FACE, {1}, 1);
  EXPECT_EQ(finding.description, "face 1 (corners 2, 1, 0) has the same corners as face 0");
  // At edges with more than two faces.
  Polygons faces = tetrahedron();
  faces.push_back({2, 3, 0});
  faces.push_back({3, 2, 0});
  faces.push_back({0, 1, 2});
  const IT::Surface_report report = IT::examine_polygons(curve(4), faces);
  ASSERT_NE(report.find(Defect::DUPLICATE_FACE), nullptr);
  EXPECT_EQ(report.find(Defect::DUPLICATE_FACE)->elements, (Indices{4, 5, 6}));
  EXPECT_EQ(report.find(Defect::DUPLICATE_FACE)->count, 3u);
}

TEST(Validate_triangles, non_manifold_edge)
{
  const Polygons fan = {{0, 2, 4}, {3, 4, 2}, {2, 4, 1}};
  const IT::Surface_report report = IT::examine_polygons(curve(5), fan);
  const IT::Finding finding = only_fatal(report, Defect::NON_MANIFOLD_EDGE, {0}, 1);
  EXPECT_EQ(finding.edges, (std::vector<std::array<std::size_t, 2>>{{{2, 4}}}));
  EXPECT_EQ(finding.description, "edge 2-4 has 3 faces (faces 0, 1, 2)");
  EXPECT_EQ(report.number_of_edges, 7u);
  EXPECT_EQ(report.number_of_border_edges, 6u);
  // More edges, and more faces than are named.
  Polygons book;
  for (std::size_t i = 0; i < 12; ++i)
    book.push_back({0, 1, i + 2});
  book.push_back({14, 1, 2});
  book.push_back({15, 1, 2});
  const IT::Surface_report pages = IT::examine_polygons(curve(16), book);
  ASSERT_NE(pages.find(Defect::NON_MANIFOLD_EDGE), nullptr);
  EXPECT_TRUE(contains(IT::message(*pages.find(Defect::NON_MANIFOLD_EDGE)),
                       "edge 0-1 has 12 faces (faces 0, 1, 2, 3, 4, 5, 6, 7, ...), and 1 more edge like it"));
}

TEST(Validate_triangles, inconsistent_orientation)
{
  Polygons faces = tetrahedron();
  std::swap(faces[2][0], faces[2][1]);
  const IT::Surface_report report = IT::examine_polygons(curve(4), faces);
  const IT::Finding finding = only_fatal(report, Defect::INCONSISTENT_ORIENTATION, {0, 1, 2}, 3);
  EXPECT_TRUE(report.is_orientable);
  EXPECT_TRUE(contains(finding.description, "edge 0-1 ")) << finding.description;
  EXPECT_TRUE(contains(finding.description, "(faces 0, 2)")) << finding.description;
  EXPECT_TRUE(contains(IT::message(finding), "orient the faces"));

  // A Moebius strip of five triangles.
  Polygons strip;
  for (std::size_t i = 0; i < 5; ++i)
    strip.push_back({i, (i + 1) % 5, (i + 2) % 5});
  const IT::Surface_report moebius = IT::examine_polygons(curve(5), strip);
  EXPECT_FALSE(moebius.is_orientable);
  ASSERT_NE(moebius.first_fatal(), nullptr);
  EXPECT_EQ(moebius.first_fatal()->defect, Defect::INCONSISTENT_ORIENTATION);
  EXPECT_TRUE(contains(IT::message(moebius), "one-sided"));
}

TEST(Validate_triangles, non_manifold_vertex)
{
  // Two triangles that touch, two tetrahedra that touch, a triangle on top of a tetrahedron.
  IT::Finding finding =
    only_fatal(IT::examine_polygons(curve(5), Polygons{{1, 0, 2}, {3, 4, 2}}), Defect::NON_MANIFOLD_VERTEX, {2}, 1);
  EXPECT_EQ(finding.description, "the faces around vertex 2 form 2 fans that touch only there"
                                 " (one with face 0, another with face 1)");
  Polygons pair = tetrahedron();
  for (const std::vector<std::size_t>& face : tetrahedron())
    pair.push_back({face[0] + 3, face[1] + 3, face[2] + 3});
  only_fatal(IT::examine_polygons(curve(7), pair), Defect::NON_MANIFOLD_VERTEX, {3}, 1);
  Polygons hat = tetrahedron();
  hat.push_back({1, 4, 5});
  hat.push_back({2, 6, 7});
  only_fatal(IT::examine_polygons(curve(8), hat), Defect::NON_MANIFOLD_VERTEX, {1, 2}, 2);
}

TEST(Validate_triangles, zero_length_edge)
{
  Points points = curve(4);
  points[2] = points[1];
  const IT::Finding finding = only_fatal(IT::examine_polygons(points, tetrahedron()), Defect::ZERO_LENGTH_EDGE, {0}, 1);
  EXPECT_EQ(finding.edges, (std::vector<std::array<std::size_t, 2>>{{{1, 2}}}));
  EXPECT_TRUE(contains(finding.description, "edge 1-2 of faces 0, 3 has zero length"));
  // Coincident vertices without an edge between them do no harm; the smallest difference is a length.
  const Points apart = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 0}}, {{-1, 0, 0}}, {{0, -1, 0}}};
  EXPECT_EQ(IT::examine_polygons(apart, Polygons{{0, 1, 2}, {3, 4, 5}}).first_fatal(), nullptr);
  const double least = 0x1p-1074;
  const Points tiny = {{{0, 0, 0}}, {{least, 0, 0}}, {{0, least, 0}}};
  const IT::Surface_report report = IT::examine_polygons(tiny, Polygons{{0, 1, 2}});
  EXPECT_TRUE(report.findings.empty()) << IT::message(report);
  EXPECT_EQ(report.exponent_of_longest_edge, -1073);
}

TEST(Validate_triangles, range_of_lengths)
{
  const auto triangles = [](const double tiny, const double large) {
    const Points points = {{{0, 0, 0}}, {{tiny, 0, 0}}, {{0, large, 0}}};
    return IT::examine_polygons(points, Polygons{{0, 1, 2}});
  };
  // Any uniform scale is fine, and so is every ratio that products of squares leave room for.
  EXPECT_TRUE(triangles(1e-300, 1e-300).findings.empty());
  EXPECT_TRUE(triangles(1e308, 1e308).findings.empty());
  EXPECT_TRUE(triangles(1e-150, 1e20).findings.empty());
  EXPECT_TRUE(triangles(1e-70, 1e110).findings.empty());
  const IT::Finding finding = only_fatal(triangles(1e-150, 1e150), Defect::OUT_OF_RANGE, {0}, 1);
  EXPECT_EQ(finding.edges, (std::vector<std::array<std::size_t, 2>>{{{0, 1}}}));
  EXPECT_TRUE(contains(finding.description, "edge 0-1 (length about 1e-150) and edge 0-2 (length about 1e+150)"))
    << finding.description;
  // A difference that overflows is not an infinite coordinate.
  const Points wide = {{{-1.5e308, 0, 0}}, {{1.5e308, 0, 0}}, {{0, 1e308, 0}}};
  const IT::Surface_report report = IT::examine_polygons(wide, Polygons{{0, 1, 2}});
  EXPECT_TRUE(report.findings.empty()) << IT::message(report);
  EXPECT_EQ(report.exponent_of_longest_edge, 1025);
}

TEST(Validate_triangles, not_fatal)
{
  // A cap, exactly flat; and one that is not, by a unit in the last place.
  const Points flat = {{{0, 0, 0}}, {{0.1, 0.3, 0.7}}, {{0.2, 0.6, 1.4}}, {{5, 0, 0}}};
  IT::Surface_report report = IT::examine_polygons(flat, Polygons{{0, 1, 2}});
  EXPECT_EQ(report.first_fatal(), nullptr);
  ASSERT_EQ(report.findings.size(), 2u);
  EXPECT_EQ(report.findings[0].defect, Defect::DEGENERATE_FACE);
  EXPECT_EQ(report.findings[0].elements, Indices{0});
  EXPECT_EQ(report.findings[1].defect, Defect::UNREFERENCED_VERTEX);
  EXPECT_EQ(report.findings[1].elements, Indices{3});
  EXPECT_EQ(IT::message(report, "name"),
            "name: face 0 (corners 0, 1, 2) has zero area; vertex 3 is not referenced by any face");
  EXPECT_NO_THROW(IT::throw_if_fatal(report));
  Points nearly = flat;
  nearly.pop_back();
  nearly[2][1] = std::nextafter(nearly[2][1], 1);
  EXPECT_TRUE(IT::examine_polygons(nearly, Polygons{{0, 1, 2}}).findings.empty());
  // The same where products under- and overflow.
  for (const double scale : {0x1p-900, 0x1p900})
    for (Points points : {flat, nearly}) {
      for (Point& p : points)
        for (double& x : p)
          x *= scale;
      const IT::Surface_report scaled = IT::examine_polygons(points, Polygons{{0, 1, 2}});
      EXPECT_EQ(scaled.find(Defect::DEGENERATE_FACE) != nullptr, points.size() == 4);
      EXPECT_EQ(scaled.first_fatal(), nullptr);
    }

  Polygons pieces = tetrahedron();
  pieces.push_back({4, 5, 6});
  report = IT::examine_polygons(curve(7), pieces);
  EXPECT_EQ(report.number_of_components, 2u);
  EXPECT_EQ(IT::message(report), "the surface has 2 components");
  EXPECT_FALSE(report.findings.front().is_fatal);
}

TEST(Validate_triangles, several_defects)
{
  Polygons faces = {{0, 1, 2}, {0, 1, 3}, {4, 4, 5}, {5, 6, 7, 8}};
  const IT::Surface_report report = IT::examine_polygons(curve(9), faces);
  EXPECT_EQ(report.first_fatal()->defect, Defect::NOT_A_TRIANGLE);
  EXPECT_TRUE(contains(IT::message(report), "(also: 1 face with a repeated corner, 1 edge with faces of opposite"
                                            " orientation"))
    << IT::message(report);
}

// Random lists of faces of random length: nothing crashes, and the numbers equal the results of a slow and simple
// count.
TEST(Validate_triangles, random_polygons)
{
  std::mt19937 random(5);
  for (int round = 0; round < 2000; ++round) {
    const std::size_t n = 1 + random() % 8;
    Polygons faces(1 + random() % 12);
    const bool only_triangles = random() % 2 == 0, only_good = random() % 4 != 0;
    for (std::vector<std::size_t>& face : faces)
      for (std::size_t i = only_triangles ? 3 : random() % 6; i > 0; --i)
        face.push_back(random() % (only_good ? n : n + 1));
    const IT::Surface_report report = IT::examine_polygons(curve(static_cast<int>(n)), faces);

    std::size_t bad = 0, crowded = 0, turned = 0, edges = 0, repeated = 0;
    std::vector<std::vector<int>> sides(n * n);
    for (const std::vector<std::size_t>& face : faces) {
      bool is_bad = false, is_repeated = false;
      for (std::size_t i = 0; i < face.size(); ++i) {
        is_bad = is_bad || face[i] >= n;
        for (std::size_t j = 0; j < i; ++j)
          is_repeated = is_repeated || face[i] == face[j];
      }
      bad += is_bad;
      repeated += is_repeated && !is_bad;
      if (is_bad || face.size() < 3)
        continue;
      for (std::size_t i = 0; i < face.size(); ++i) {
        const std::size_t u = face[i], v = face[(i + 1) % face.size()];
        if (u != v)
          sides[(std::min)(u, v) * n + (std::max)(u, v)].push_back(u < v ? 1 : 0);
      }
    }
    for (const std::vector<int>& side : sides) {
      edges += !side.empty();
      crowded += side.size() > 2;
      turned += side.size() == 2 && side[0] == side[1];
    }
    const auto count = [&](const Defect defect) {
      return report.find(defect) == nullptr ? 0 : report.find(defect)->count;
    };
    ASSERT_EQ(count(Defect::BAD_INDEX), bad);
    ASSERT_EQ(count(Defect::REPEATED_CORNER), repeated);
    ASSERT_EQ(count(Defect::NON_MANIFOLD_EDGE), crowded);
    ASSERT_EQ(count(Defect::INCONSISTENT_ORIENTATION), turned);
    ASSERT_EQ(report.number_of_edges, edges);
    for (const IT::Finding& finding : report.findings)
      ASSERT_FALSE(IT::message(finding).empty());
  }
}

// The complex that a surface has, if it is one.
bool is_complex(const Points& points, const Polygons& polygons, IT::Delta_complex& complex)
{
  try {
    for (const Indices& polygon : polygons)
      if (polygon.size() != 3)
        return false;
    complex = IT::make_Delta_complex_from_triangles(points.size(), polygons);
    return true;
  } catch (const IT::Invalid_surface_error&) {
    return false;
  }
}

TEST(Validate_triangles, the_quick_question_has_the_same_answer)
{
  std::mt19937 random(3);
  const auto number = [&](int n) { return std::uniform_int_distribution<int>(0, n - 1)(random); };
  std::size_t plain = 0, ugly = 0;
  const auto compare = [&](const Points& points, const Polygons& polygons) {
    const IT::Surface_report report = IT::examine_polygons(points, polygons);
    std::size_t findings = report.gaps.size();
    for (const IT::Finding& finding : report.findings)
      findings += finding.defect != Defect::SEVERAL_COMPONENTS;
    IT::Delta_complex complex;
    const bool is_plain = is_complex(points, polygons, complex) && IT::is_clean(complex, points);
    EXPECT_EQ(is_plain, findings == 0) << IT::message(report);
    ++(is_plain ? plain : ugly);
  };
  for (int round = 0; round < 3000; ++round) {
    Points points;
    for (int i = 3 + number(4); i > 0; --i)
      points.push_back({{1. * number(4), 1. * number(4), 1. * number(4)}});
    Polygons polygons;
    for (int i = 1 + number(4); i > 0; --i) {
      polygons.emplace_back();
      while (polygons.back().size() < 3)
        polygons.back().push_back(static_cast<std::size_t>(number(static_cast<int>(points.size()))));
    }
    compare(points, polygons);
  }
  Points points;
  Polygons triangles;
  grid(7, points, triangles);
  compare(points, triangles);
  for (const double x :
       {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN(), 1e300, 1.7e308}) {
    Points spoilt = points;
    spoilt[11][2] = x;
    compare(spoilt, triangles);
    spoilt[12] = spoilt[11];
    spoilt[12][0] += 1e-300;
    compare(spoilt, triangles);
  }
  points.push_back({{0, 0, 0}});
  compare(points, triangles);
  EXPECT_GT(plain, 30u);
  EXPECT_GT(ugly, 1000u);
}

TEST(Turned_triangles, make_neighbors_agree)
{
  const std::vector<std::array<double, 3>> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                                  {2, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}};
  // The second triangle runs against the first, the third with it; the last is a part of its own.
  std::vector<std::array<std::uint32_t, 3>> triangles{{0, 1, 2}, {0, 3, 2}, {1, 4, 2}, {5, 7, 6}};
  EXPECT_EQ(IT::turned_triangles(points, triangles), (std::vector<std::size_t>{1}));
  std::swap(triangles[1][0], triangles[1][2]);
  EXPECT_TRUE(IT::turned_triangles(points, triangles).empty());
}

} // namespace
