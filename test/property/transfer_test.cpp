// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Transfer to the overlay preserves shapes and functions: faces of the overlay have the same shape in both
// triangulations, linear functions stay linear, and a textured surface looks the same.

#include "evaluation_data.h"
#include "overlay_surfaces.h"

#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/transfer.h>

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using test_surfaces::Overlaid;
using test_surfaces::Point_2;
using Part = IT::Overlay::Halfedge;

std::vector<Part> around(const IT::Overlay& overlay, IT::Overlay::Face f)
{
  std::vector<Part> parts{overlay.halfedge(f)};
  while (overlay.next(parts.back()) != parts.front())
    parts.push_back(overlay.next(parts.back()));
  return parts;
}

// The position of the target of a part on a side of the input face.
IT::Surface_point in_input(const Overlaid& s, Part h)
{
  const double t = s.positions().on_input_side(s.overlay(), h);
  return {s.overlay().input_side(h), {1 - t, t, 0}};
}
IT::Surface_point in_intrinsic(const Overlaid& s, Part h)
{
  const double t = s.positions().on_intrinsic_side(s.overlay(), h);
  return {s.overlay().intrinsic_side(h), {1 - t, t, 0}};
}

double area(const std::vector<Point_2>& polygon)
{
  double twice = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    twice += (polygon[i][0] - polygon[0][0]) * (polygon[i + 1][1] - polygon[0][1]) -
             (polygon[i][1] - polygon[0][1]) * (polygon[i + 1][0] - polygon[0][0]);
  return twice / 2;
}

// Each face of the overlay, laid out once in its input face and once in its intrinsic face, has
// the same sides and diagonals. Between the wrong ones of several edges with the same ends, or
// along a loop the wrong way, lengths would differ.
void expect_isometric(const Overlaid& s)
{
  std::vector<double> lengths, areas;
  for (IT::Edge_index e : s.intrinsic().edges())
    lengths.push_back(s.triangulation.length(e));
  for (IT::Face_index f : s.intrinsic().faces())
    areas.push_back(s.triangulation.area(f));
  const std::vector<double> overlay_areas = IT::face_areas(s.subdivision);
  std::vector<double> sums_in_input(s.input().number_of_faces(), 0), sums_in_intrinsic(areas.size(), 0);
  for (IT::Overlay::Face f : s.overlay().faces()) {
    const IT::Halfedge_index h = s.input().halfedge(s.overlay().input_face(f)),
                             g = s.intrinsic().halfedge(s.overlay().intrinsic_face(f));
    const auto input_corners = test_surfaces::laid_out(
      s.input(), h, [&](IT::Halfedge_index e) { return s.input_length(e); }, s.input_area(s.overlay().input_face(f)));
    const auto intrinsic_corners = test_surfaces::laid_out(
      s.intrinsic(), g, [&](IT::Halfedge_index e) { return lengths[e.idx() / 2]; },
      areas[s.overlay().intrinsic_face(f).idx()]);
    std::vector<Point_2> a, b;
    for (Part part : around(s.overlay(), f)) {
      a.push_back(
        test_surfaces::combination(input_corners, test_surfaces::coordinates_from(s.input(), in_input(s, part), h)));
      b.push_back(test_surfaces::combination(intrinsic_corners,
                                             test_surfaces::coordinates_from(s.intrinsic(), in_intrinsic(s, part), g)));
    }
    double longest = 0;
    for (int i = 0; i < 3; ++i)
      for (const auto* corners : {&input_corners, &intrinsic_corners})
        longest = (std::max)(longest, test_surfaces::distance((*corners)[i], (*corners)[(i + 1) % 3]));
    for (std::size_t i = 0; i < a.size(); ++i)
      for (std::size_t j = i + 1; j < a.size(); ++j)
        ASSERT_NEAR(test_surfaces::distance(a[i], a[j]), test_surfaces::distance(b[i], b[j]), 1e-13 * longest);
    ASSERT_NEAR(overlay_areas[f.idx()], area(a), 1e-14 * longest * longest);
    ASSERT_NEAR(overlay_areas[f.idx()], area(b), 1e-14 * longest * longest);
    sums_in_input[s.overlay().input_face(f).idx()] += overlay_areas[f.idx()];
    sums_in_intrinsic[s.overlay().intrinsic_face(f).idx()] += overlay_areas[f.idx()];
  }
  for (IT::Face_index f : s.input().faces())
    ASSERT_NEAR(sums_in_input[f.idx()], s.input_area(f), 1e-12 * s.input_area(f));
  for (IT::Face_index f : s.intrinsic().faces())
    ASSERT_NEAR(sums_in_intrinsic[f.idx()], areas[f.idx()], 1e-12 * areas[f.idx()]);
}

TEST(Transfer, faces_of_the_overlay_have_one_shape_in_both_triangulations)
{
  test_surfaces::for_each_overlaid_surface([](const std::string& name, const Overlaid& s) {
    SCOPED_TRACE(name);
    expect_isometric(s);
  });
}

TEST(Transfer, lengths_of_horse_where_several_edges_join_two_vertices)
{
  const std::filesystem::path file = evaluation_data() / "table1" / "horse.off";
  if (!std::filesystem::exists(file))
    GTEST_SKIP() << "no evaluation meshes";
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  std::vector<std::vector<std::size_t>> triangles;
  ASSERT_TRUE(CGAL::IO::read_polygon_soup(file.string(), points, triangles));
  std::vector<std::array<double, 3>> coordinates;
  for (const auto& p : points)
    coordinates.push_back({p.x(), p.y(), p.z()});
  const Overlaid s(
    test_surfaces::Triangulation(IT::make_Delta_complex_from_triangles(points.size(), triangles), coordinates));
  EXPECT_FALSE(IT::is_simplicial(s.intrinsic()));
  expect_isometric(s);
}

TEST(Transfer, constants_stay_constant)
{
  test_surfaces::for_each_overlaid_surface([](const std::string& name, const Overlaid& s) {
    SCOPED_TRACE(name);
    const std::vector<double> ones(s.input().number_of_vertices(), 1);
    for (const std::vector<double>& values :
         {IT::interpolate_input_values(s.subdivision, ones), IT::interpolate_intrinsic_values(s.subdivision, ones)}) {
      ASSERT_EQ(values.size(), s.overlay().number_of_vertices());
      for (double x : values)
        ASSERT_NEAR(x, 1, 1e-15);
    }
  });
}

// A value type of its own: a vector in the plane.
struct Vector_2
{
  double x = 0, y = 0;
  friend Vector_2 operator+(const Vector_2& a, const Vector_2& b) { return {a.x + b.x, a.y + b.y}; }
  friend Vector_2 operator*(double t, const Vector_2& a) { return {t * a.x, t * a.y}; }
};

// In the plane the coordinates are linear functions on either triangulation.
TEST(Transfer, linear_functions_stay_linear_in_the_plane)
{
  for (const samples::Indexed_triangles& surface : {samples::sheared_grid(12, 12, 3.3), samples::strip(100, 20),
                                                    samples::random_diagonal_grid(8, 8, 1, 0), samples::cap(0)}) {
    const Overlaid s(surface);
    std::vector<Vector_2> places;
    for (const std::array<double, 3>& p : surface.points)
      places.push_back({p[0], p[1]});
    const auto from_input = IT::interpolate_input_values(s.subdivision, places),
               from_intrinsic = IT::interpolate_intrinsic_values(s.subdivision, places);
    ASSERT_EQ(from_input.size(), from_intrinsic.size());
    for (IT::Overlay::Vertex v : s.overlay().vertices()) {
      const auto in_space = s.subdivision.point(v, surface.points);
      ASSERT_NEAR(from_input[v.idx()].x, in_space[0], 1e-13 * 100);
      ASSERT_NEAR(from_input[v.idx()].y, in_space[1], 1e-13 * 100);
      ASSERT_NEAR(from_intrinsic[v.idx()].x, in_space[0], 1e-13 * 100);
      ASSERT_NEAR(from_intrinsic[v.idx()].y, in_space[1], 1e-13 * 100);
    }
  }
}

TEST(Transfer, along_a_loop_vertex_data_are_constant)
{
  const Overlaid s(samples::helical_tube());
  std::vector<double> numbers;
  for (IT::Vertex_index v : s.intrinsic().vertices())
    numbers.push_back(v.idx());
  const auto values = IT::interpolate_intrinsic_values(s.subdivision, numbers);
  int on_loops = 0;
  for (IT::Overlay::Vertex x : s.overlay().crossings()) {
    const IT::Edge_index e = s.overlay().intrinsic_edge(x);
    if (!s.intrinsic().is_loop(e))
      continue;
    ++on_loops;
    const double value = s.intrinsic().target(s.intrinsic().halfedge(e)).idx();
    EXPECT_NEAR(values[x.idx()], value, 1e-15 * value);
  }
  EXPECT_GT(on_loops, 50);
}

// Texture coordinates with a seam at some edges, or at all edges.
std::vector<Vector_2> texture_coordinates(const Overlaid& s, bool all_seams)
{
  std::mt19937 random(1);
  const auto number = [&] { return double(random()) / 0x1p32; };
  std::vector<Vector_2> of_vertex(s.input().number_of_vertices());
  for (Vector_2& uv : of_vertex)
    uv = {number(), number()};
  std::vector<Vector_2> result(s.input().number_of_halfedges());
  for (IT::Face_index f : s.input().faces()) {
    IT::Halfedge_index h = s.input().halfedge(f);
    for (int i = 0; i < 3; ++i, h = s.input().next(h))
      result[h.idx()] = all_seams          ? Vector_2{number(), number()}
                        : f.idx() % 7 == 0 ? Vector_2{2, 0} + of_vertex[s.input().target(h).idx()]
                                           : of_vertex[s.input().target(h).idx()];
  }
  return result;
}

double texture(const Vector_2& uv) { return std::sin(40 * uv.x) * std::cos(30 * uv.y); }

// The value at a point of the input, found by trying all triangles of all faces of the overlay in
// its face.
Vector_2 seen_on_overlay(const Overlaid& s, const std::vector<IT::Overlay::Face>& faces,
                         const std::vector<Vector_2>& corners, const IT::Surface_point& p)
{
  double best = -1e300;
  Vector_2 result;
  for (IT::Overlay::Face f : faces) {
    const std::vector<Part> parts = around(s.overlay(), f);
    for (std::size_t i = 1; i + 1 < parts.size(); ++i) {
      const std::array<Part, 3> triangle{parts[0], parts[i], parts[i + 1]};
      std::array<Point_2, 3> places;
      for (int k = 0; k < 3; ++k) {
        const auto b = test_surfaces::coordinates_from(s.input(), in_input(s, triangle[k]), p.halfedge);
        places[k] = {b[1], b[2]};
      }
      const Point_2 place{p.coordinates[1], p.coordinates[2]};
      std::array<double, 3> weights;
      double whole = area({places[0], places[1], places[2]});
      if (whole < 1e-12)
        continue;
      for (int k = 0; k < 3; ++k)
        weights[k] = area({place, places[(k + 1) % 3], places[(k + 2) % 3]}) / whole;
      const double smallest = *std::min_element(weights.begin(), weights.end());
      if (smallest <= best)
        continue;
      best = smallest;
      result = weights[0] * corners[triangle[0].idx()] + weights[1] * corners[triangle[1].idx()] +
               weights[2] * corners[triangle[2].idx()];
    }
  }
  EXPECT_GT(best, -1e-4);
  return result;
}

TEST(Transfer, a_textured_surface_looks_the_same)
{
  for (bool all_seams : {false, true})
    for (const Overlaid& s : {Overlaid(samples::bumpy_sphere(20, 12)), Overlaid(samples::helical_tube()),
                              Overlaid(samples::disk_with_spike(12, 8)),
                              Overlaid(test_surfaces::triangulation<IT::Filtered_edge_length_traits>(
                                test_surfaces::from_gluing("gluing", samples::random_gluing(41, 3, true, true))))}) {
      const std::vector<Vector_2> before = texture_coordinates(s, all_seams);
      const std::vector<Vector_2> after = IT::interpolate_input_corner_values(s.subdivision, before);
      std::vector<std::vector<IT::Overlay::Face>> faces(s.input().number_of_faces());
      for (IT::Overlay::Face f : s.overlay().faces())
        faces[s.overlay().input_face(f).idx()].push_back(f);
      std::mt19937_64 random(2);
      for (int i = 0; i < 12500; ++i) {
        const IT::Surface_point p = test_surfaces::random_point(s.input(), random);
        const IT::Halfedge_index h = p.halfedge;
        const Vector_2 expected = p.coordinates[0] * before[s.input().prev(h).idx()] +
                                  p.coordinates[1] * before[h.idx()] +
                                  p.coordinates[2] * before[s.input().next(h).idx()];
        const Vector_2 seen = seen_on_overlay(s, faces[s.input().face(h).idx()], after, p);
        ASSERT_NEAR(seen.x, expected.x, 1e-11);
        ASSERT_NEAR(seen.y, expected.y, 1e-11);
        ASSERT_NEAR(texture(seen), texture(expected), 1e-9);
      }
    }
}

// No new seam appears: both sides agree along a part whose input edge is not a seam.
TEST(Transfer, seams_stay_where_they_were)
{
  const Overlaid s(samples::bumpy_sphere(20, 12));
  const std::vector<Vector_2> before = texture_coordinates(s, false);
  const std::vector<Vector_2> after = IT::interpolate_input_corner_values(s.subdivision, before);
  int seams = 0;
  for (Part h : s.overlay().halfedges()) {
    Part in_other_face = s.overlay().opposite(h); // the one before it points to the target of h
    while (s.overlay().next(in_other_face) != s.overlay().opposite(h))
      in_other_face = s.overlay().next(in_other_face);
    const double jump = std::abs(after[h.idx()].x - after[in_other_face.idx()].x);
    const IT::Halfedge_index edge = s.overlay().input_halfedge(h);
    const auto is_marked = [&](IT::Halfedge_index g) { return s.input().face(g).idx() % 7 == 0; };
    if (edge.is_valid() && is_marked(edge) != is_marked(s.input().opposite(edge))) {
      ASSERT_NEAR(jump, 2, 1e-14);
      ++seams;
    } else {
      ASSERT_NEAR(jump, 0, 1e-14);
    }
  }
  EXPECT_GT(seams, 100);
}

} // namespace
