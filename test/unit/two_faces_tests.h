// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Results for two faces at once equal those for each, bit for bit.

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/internal/flips/Whole_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/unit_of_length.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::internal::Two_doubles;
using Point = std::array<double, 3>;

// Distinguishes zeros by sign, and treats all NaNs as equal.
template <class T>
bool are_same(T a, T b)
{
  return (std::isnan(a) && std::isnan(b)) || std::memcmp(&a, &b, sizeof(T)) == 0;
}

const std::vector<double>& special_numbers()
{
  using Limits = std::numeric_limits<double>;
  static const std::vector<double> numbers{0.,
                                           -0.,
                                           1.,
                                           -1.,
                                           3.,
                                           1. / 3.,
                                           -1e-160,
                                           1e160,
                                           5e-324,
                                           Limits::max(),
                                           Limits::infinity(),
                                           -Limits::infinity(),
                                           Limits::quiet_NaN()};
  return numbers;
}

TEST(Two_doubles, compute_as_two)
{
  for (double a : special_numbers())
    for (double b : special_numbers()) {
      const double c = 0.7, d = -1.9;
      const Two_doubles x(a, c), y(b, d);
      const auto expect = [&](const Two_doubles& two, double first, double second) {
        EXPECT_TRUE(are_same(two.first(), first)) << a << " " << b << ": " << two.first();
        EXPECT_TRUE(are_same(two.second(), second)) << a << " " << b << ": " << two.second();
      };
      expect(x + y, a + b, c + d);
      expect(y + x, b + a, d + c);
      expect(x - y, a - b, c - d);
      expect(x * y, a * b, c * d);
      expect(x / y, a / b, c / d);
      expect(-x, -a, -c);
      expect(firsts(x, y), a, b);
      expect(seconds(x, y), c, d);
      expect(swapped(x), c, a);
      expect(abs(y), std::abs(b), std::abs(d));
      expect(rounded_sqrt(abs(y)), IT::internal::rounded_sqrt(std::abs(b)), IT::internal::rounded_sqrt(std::abs(d)));
      expect(max_of(x, y), a > b ? a : b, c > d ? c : d);
      expect(min_of(x, y), a < b ? a : b, c < d ? c : d);
      expect(if_greater(x, y, 1., x), a > b ? 1. : a, c > d ? 1. : c);
      expect(Two_doubles(b), b, b);
      const std::array<float, 2> floats = y.floats();
      EXPECT_TRUE(are_same(floats[0], float(b)));
      EXPECT_TRUE(are_same(floats[1], float(d)));
    }
}

// Triangles of all shapes and sizes; every fourth has area zero.
std::vector<std::array<Point, 3>> triangles()
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(-1, 1), exponent(-90, 90);
  std::vector<std::array<Point, 3>> result;
  for (int i = 0; i < 400; ++i) {
    const double size = std::exp2(exponent(random)), thinness = std::exp2(exponent(random) / 3);
    std::array<Point, 3> t;
    for (Point& p : t)
      p = {size * coordinate(random), size * thinness * coordinate(random), size * coordinate(random)};
    if (i % 4 == 0)
      for (int j = 0; j < 3; ++j)
        t[2][j] = t[0][j] / 2 + t[1][j] / 2;
    result.push_back(t);
  }
  return result;
}

double area(double a) { return a; }
double error(double) { return 0; }
double area(const IT::Bounded_area& a) { return a.value; }
double error(const IT::Bounded_area& a) { return a.error; }
double first_of(const Two_doubles& a) { return a.first(); }
double second_of(const Two_doubles& a) { return a.second(); }
template <class Two_faces>
IT::Bounded_area first_of(const Two_faces& a)
{
  return a.first();
}
template <class Two_faces>
IT::Bounded_area second_of(const Two_faces& a)
{
  return a.second();
}

template <class Traits>
struct Two_faces : testing::Test
{};
using All_traits = testing::Types<IT::Edge_length_traits<double>, IT::Filtered_edge_length_traits>;
TYPED_TEST_SUITE(Two_faces, All_traits, );

TYPED_TEST(Two_faces, have_the_numbers_of_each)
{
  const TypeParam traits;
  const auto edge = traits.construct_edge_data_object();
  const auto face = traits.construct_face_data_object();
  const auto bounds = traits.compute_cotangent_bounds_object();
  const auto all = triangles();
  for (std::size_t n = 0; n + 1 < all.size(); ++n) {
    const auto &s = all[n], &t = all[n + 1];
    const auto both = [&](int i) {
      return IT::internal::Two_points{Two_doubles(s[i][0], t[i][0]), Two_doubles(s[i][1], t[i][1]),
                                      Two_doubles(s[i][2], t[i][2])};
    };
    const Two_doubles pq = edge(both(0), both(1)), qr = edge(both(1), both(2)), pr = edge(both(0), both(2));
    const auto areas = face(both(0), both(1), both(2));
    const auto of_corners = bounds(areas, pq, qr, pr);
    int number = 0;
    for (const auto& u : {s, t}) {
      const auto of_face = face(u[0], u[1], u[2]);
      const auto one = number == 0 ? first_of(areas) : second_of(areas);
      EXPECT_TRUE(are_same(area(one), area(of_face)));
      EXPECT_TRUE(are_same(error(one), error(of_face)));
      const std::array<double, 3> lengths{edge(u[0], u[1]), edge(u[1], u[2]), edge(u[0], u[2])};
      EXPECT_TRUE(are_same(number == 0 ? pq.first() : pq.second(), lengths[0]));
      EXPECT_TRUE(are_same(number == 0 ? qr.first() : qr.second(), lengths[1]));
      EXPECT_TRUE(are_same(number == 0 ? pr.first() : pr.second(), lengths[2]));
      const std::array<float, 3> expected = bounds(of_face, lengths[0], lengths[1], lengths[2]);
      for (int i = 0; i < 3; ++i)
        EXPECT_TRUE(are_same(of_corners[i].floats()[number], expected[i])) << n << " " << i;
      ++number;
    }
  }
}

// Whether the bounds of the two corners opposite e, computed from stored numbers, prove it Delaunay.
template <class Triangulation>
bool is_known(const Triangulation& t, IT::Edge_index e)
{
  const auto& complex = t.connectivity();
  float sum = 0;
  for (IT::Halfedge_index h : {complex.halfedge(e), complex.opposite(complex.halfedge(e))}) {
    if (complex.is_border(h))
      return false;
    sum += t.traits().compute_cotangent_bounds_object()(t.face_data(complex.face(h)), t.edge_data(e),
                                                        t.edge_data(complex.edge(complex.next(h))),
                                                        t.edge_data(complex.edge(complex.prev(h))))[0];
  }
  return sum > 0;
}

TYPED_TEST(Two_faces, give_bounds_that_are_kept_through_flips)
{
  for (const samples::Indexed_triangles& surface :
       {samples::bad_torus(20, 20), samples::sheared_grid(9, 7, 3.3), samples::bumpy_dome(12, 12)}) {
    IT::Intrinsic_triangulation<TypeParam> t(
      IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles), surface.points);
    const IT::internal::Whole_triangulation<TypeParam> whole(t);
    const auto expect_bounds = [&] {
      const auto edges = t.connectivity().edges();
      for (IT::Edge_index e : edges)
        EXPECT_EQ(whole.is_known_Delaunay(e), is_known(t, e)) << e;
      for (auto e = edges.begin(); edges.end() - e >= 4; ++e)
        for (int i = 0; i < 4; ++i)
          EXPECT_EQ(whole.are_known_Delaunay(*e) >> i & 1, unsigned(whole.is_known_Delaunay(e[i])));
    };
    expect_bounds();
    EXPECT_GT(IT::flip_to_Delaunay(t).flips, 0u);
    expect_bounds();
  }
}

// Measures the surface from above: of points, only x and y count.
template <class Base>
struct Squashed_traits : Base
{
  struct Construct_edge_data : Base::Construct_edge_data
  {
    double operator()(Point p, Point q) const
    {
      p[2] = q[2] = 0;
      return Base::Construct_edge_data::operator()(p, q);
    }
  };
  struct Construct_face_data : Base::Construct_face_data
  {
    auto operator()(Point p, Point q, Point r) const
    {
      p[2] = q[2] = r[2] = 0;
      return Base::Construct_face_data::operator()(p, q, r);
    }
  };
  Construct_edge_data construct_edge_data_object() const { return {}; }
  Construct_face_data construct_face_data_object() const { return {}; }
};

TYPED_TEST(Two_faces, are_left_to_the_functors_of_derived_traits)
{
  const std::vector<Point> points{{0, 0, 0}, {1, 0, 5}, {1, 1, 0}, {0, 1, 5}, {2, 2, 7}};
  const std::vector<std::array<std::uint32_t, 3>> faces{{0, 1, 2}, {0, 2, 3}, {1, 4, 2}};
  const IT::Intrinsic_triangulation<Squashed_traits<TypeParam>> t(
    IT::make_Delta_complex_from_triangles(points.size(), faces), points);
  EXPECT_EQ(t.squared_length(IT::Edge_index(0)), 1);
  for (IT::Face_index f : t.connectivity().faces())
    EXPECT_EQ(area(t.face_data(f)), 2);
}

// If not all vertices are used, nor an even number of them.
TEST(Two_doubles, find_the_box_of_points)
{
  std::mt19937 random(6);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (std::size_t n = 0; n < 40; ++n) {
    std::vector<Point> points(n);
    for (Point& p : points)
      p = {coordinate(random), coordinate(random), coordinate(random)};
    for (unsigned unused : {0u, 1u, 2u, 3u, 7u}) {
      const auto is_used = [unused](std::size_t v) { return unused == 0 || v % (unused + 1) != unused; };
      const auto box = IT::internal::bounding_box<CGAL::Sequential_tag>(points, is_used);
      std::array<double, 3> low, high;
      low.fill(std::numeric_limits<double>::infinity());
      high.fill(-std::numeric_limits<double>::infinity());
      for (std::size_t v = 0; v < n; ++v)
        for (int i = 0; i < 3 && is_used(v); ++i) {
          low[i] = std::min(low[i], points[v][i]);
          high[i] = std::max(high[i], points[v][i]);
        }
      EXPECT_EQ(box.low, low);
      EXPECT_EQ(box.high, high);
      EXPECT_EQ(box.zero, 0);
    }
    for (Point& p : points)
      for (double& x : p) { // all have to be finite
        const double finite = x;
        x = std::numeric_limits<double>::infinity();
        EXPECT_NE(IT::internal::bounding_box<CGAL::Sequential_tag>(points, [](std::size_t) { return true; }).zero, 0);
        x = finite;
      }
  }
}

} // namespace
