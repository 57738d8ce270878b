// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points of the input mapped to the intrinsic triangulation and back, on surfaces of all kinds.
// Where the answer has to be exact, planar_point_location_test.cpp compares with integers.

#include "overlay_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Point_location.h>
#include <CGAL/Intrinsic_triangulations/errors.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using test_surfaces::Overlaid;
using test_surfaces::Point_2;

double longest_side(const IT::Delta_complex& complex, IT::Halfedge_index h,
                    const std::function<double(IT::Halfedge_index)>& length)
{
  return (std::max)({length(h), length(complex.next(h)), length(complex.prev(h))});
}

// The distance of two points of one face of the input.
double input_distance(const Overlaid& s, const IT::Surface_point& p, const IT::Surface_point& q)
{
  const auto corners = test_surfaces::laid_out(
    s.input(), p.halfedge, [&](IT::Halfedge_index h) { return s.input_length(h); },
    s.input_area(s.input().face(p.halfedge)));
  const auto b = test_surfaces::coordinates_from(s.input(), q, p.halfedge);
  return test_surfaces::distance(
    {0, 0},
    test_surfaces::combination(corners, {b[0] - p.coordinates[0], b[1] - p.coordinates[1], b[2] - p.coordinates[2]}));
}

// In the unit of the metric, which all surfaces here have left as it was.
std::array<double, 3> in_space(const Overlaid& s, const IT::Surface_point& p)
{
  const IT::Input_metric::Point_vector& points = IT::internal::engine(s.triangulation).metric().points();
  const auto coordinate = [&](IT::Vertex_index v, int i) { return points[v.idx()][i]; };
  std::array<double, 3> result{};
  for (int i = 0; i < 3; ++i)
    result[i] = p.coordinates[0] * coordinate(s.input().source(p.halfedge), i) +
                p.coordinates[1] * coordinate(s.input().target(p.halfedge), i) +
                p.coordinates[2] * coordinate(s.input().target(s.input().next(p.halfedge)), i);
  return result;
}

TEST(Point_location, points_return)
{
  test_surfaces::for_each_overlaid_surface([](const std::string& name, const Overlaid& s) {
    SCOPED_TRACE(name);
    const IT::Point_location location(s.subdivision);
    const auto input_length = [&](IT::Halfedge_index h) { return s.input_length(h); };
    std::vector<double> lengths;
    for (IT::Edge_index e : s.intrinsic().edges())
      lengths.push_back(s.triangulation.length(e));
    const auto intrinsic_length = [&](IT::Halfedge_index h) { return lengths[h.idx() / 2]; };
    std::mt19937_64 random(1);
    for (int i = 0; i < 10000; ++i) {
      const IT::Surface_point p = test_surfaces::random_point(s.input(), random);
      const IT::Surface_point q = location.input_to_intrinsic(p);
      ASSERT_EQ(q.dimension(), 2);
      ASSERT_NEAR(q.coordinates[0] + q.coordinates[1] + q.coordinates[2], 1, 1e-15);
      const IT::Surface_point r = location.intrinsic_to_input(q);
      if (s.input().face(r.halfedge) == s.input().face(p.halfedge)) {
        ASSERT_LE(input_distance(s, p, r),
                  1e-14 * (std::max)(longest_side(s.input(), p.halfedge, input_length),
                                     longest_side(s.intrinsic(), q.halfedge, intrinsic_length)));
      } else { // where a face is no higher than rounding errors
        ASSERT_TRUE(name == "cap" || name == "exact cap");
        const auto a = in_space(s, p), b = in_space(s, r);
        ASSERT_LE(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), 1e-15);
      }
    }
  });
}

TEST(Point_location, vertices_are_vertices)
{
  test_surfaces::for_each_overlaid_surface([](const std::string& name, const Overlaid& s) {
    SCOPED_TRACE(name);
    const IT::Point_location location(s.subdivision);
    const auto check = [&](const IT::Delta_complex& from, const IT::Delta_complex& to, auto map) {
      for (IT::Halfedge_index h : from.halfedges()) {
        if (from.is_border(h))
          continue;
        const std::array<IT::Vertex_index, 3> corners{from.source(h), from.target(h), from.target(from.next(h))};
        for (std::size_t i = 0; i < 3; ++i) {
          IT::Surface_point p{h, {0, 0, 0}};
          p.coordinates[i] = 0.3;
          const IT::Surface_point q = map(p);
          ASSERT_EQ(q.coordinates, (std::array<double, 3>{1, 0, 0}));
          ASSERT_EQ(to.source(q.halfedge), corners[i]);
          ASSERT_FALSE(to.is_border(q.halfedge));
        }
      }
    };
    check(s.input(), s.intrinsic(), [&](const auto& p) { return location.input_to_intrinsic(p); });
    check(s.intrinsic(), s.input(), [&](const auto& p) { return location.intrinsic_to_input(p); });
  });
}

TEST(Point_location, points_of_common_edges_stay_on_them)
{
  test_surfaces::for_each_overlaid_surface([](const std::string& name, const Overlaid& s) {
    SCOPED_TRACE(name);
    const IT::Point_location location(s.subdivision);
    for (IT::Overlay::Halfedge part : s.overlay().halfedges()) {
      const IT::Halfedge_index h = s.overlay().input_halfedge(part), g = s.overlay().intrinsic_halfedge(part);
      if (!h.is_valid() || !g.is_valid() || s.overlay().is_border(part))
        continue;
      for (const IT::Surface_point& p :
           {IT::Surface_point{h, {3, 1, 0}}, IT::Surface_point{s.input().next(h), {1, 0, 3}},
            IT::Surface_point{s.input().prev(h), {0, 3, 1}}}) {
        const IT::Surface_point q = location.input_to_intrinsic(p);
        ASSERT_EQ(q.halfedge, g);
        ASSERT_EQ(q.coordinates, (std::array<double, 3>{0.75, 0.25, 0}));
        ASSERT_EQ(location.intrinsic_to_input(q).halfedge, h);
      }
    }
  });
}

// Of a torus with sides 3, 4 and 6, the diagonal of length 6 is flipped; both cross in the middle.
TEST(Point_location, the_diagonals_of_a_parallelogram_meet_in_the_middle)
{
  const samples::Glued_triangles torus = samples::one_vertex_torus(3, 4, 6);
  const Overlaid s(
    test_surfaces::triangulation<IT::Filtered_edge_length_traits>(test_surfaces::from_gluing("torus", torus)));
  ASSERT_EQ(s.overlay().number_of_crossings(), 1u);
  const IT::Point_location location(s.subdivision);
  const IT::Overlay::Vertex x = *s.overlay().crossings().begin();
  const IT::Halfedge_index h = s.input().halfedge(s.overlay().input_edge(x));
  const IT::Surface_point q = location.input_to_intrinsic({h, {1, 1, 0}});
  EXPECT_EQ(s.intrinsic().edge(q.halfedge), s.overlay().intrinsic_edge(x));
  EXPECT_EQ(q.coordinates, (std::array<double, 3>{0.5, 0.5, 0}));
  const IT::Surface_point r = location.intrinsic_to_input(q);
  EXPECT_EQ(s.input().edge(r.halfedge), s.overlay().input_edge(x));
  EXPECT_EQ(r.coordinates, (std::array<double, 3>{0.5, 0.5, 0}));
  // An ulp beside it, the point is in a face.
  EXPECT_EQ(location.input_to_intrinsic({h, {1, 1 - 0x1p-53, 0}}).dimension(), 2);
  EXPECT_EQ(location.intrinsic_to_input({q.halfedge, {1, 1 - 0x1p-53, 0}}).dimension(), 2);
}

TEST(Point_location, coordinates_of_any_magnitude)
{
  const Overlaid s(samples::bumpy_sphere(8, 6));
  const IT::Point_location location(s.subdivision);
  std::mt19937_64 random(1);
  for (int i = 0; i < 1000; ++i) {
    IT::Surface_point p = test_surfaces::random_point(s.input(), random);
    const IT::Surface_point expected = location.input_to_intrinsic(p);
    for (double scale : {0x1p1000, 0x1p-1000}) {
      IT::Surface_point scaled = p;
      for (double& x : scaled.coordinates)
        x *= scale;
      const IT::Surface_point q = location.input_to_intrinsic(scaled);
      ASSERT_EQ(q.halfedge, expected.halfedge);
      for (int k = 0; k < 3; ++k)
        ASSERT_NEAR(q.coordinates[k], expected.coordinates[k], 1e-15);
    }
    // Next to a vertex, but inside of the face.
    p.coordinates = {1, (std::numeric_limits<double>::min)(), 1e-300};
    ASSERT_EQ(location.input_to_intrinsic(p).dimension(), 2);
  }
}

TEST(Point_location, says_what_is_wrong_with_a_point)
{
  const Overlaid s(samples::sheared_grid(3, 3));
  const IT::Point_location location(s.subdivision);
  IT::Halfedge_index inner, border;
  for (IT::Halfedge_index h : s.input().halfedges())
    (s.input().is_border(h) ? border : inner) = h;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const IT::Surface_point& p :
       {IT::Surface_point{border, {1, 1, 1}}, IT::Surface_point{IT::Halfedge_index(), {1, 1, 1}},
        IT::Surface_point{inner, {1, 1, nan}}, IT::Surface_point{inner, {1, infinity, 1}},
        IT::Surface_point{inner, {1, -1e-300, 1}}, IT::Surface_point{inner, {0, 0, 0}}}) {
    EXPECT_THROW(location.input_to_intrinsic(p), IT::Invalid_point_error);
    EXPECT_THROW(location.intrinsic_to_input(p), IT::Invalid_point_error);
  }
}

} // namespace
