// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The in-circle test of two coplanar faces, against the determinant in rational numbers.

#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Rational.h>
#include "library/engine/decide/Coplanar_hinge.h"
#include "library/engine/layout/Vertex_positions.h"
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/squared_lengths.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::internal::Rational;
using Point_2 = std::array<double, 2>;

// The sign of cot k + cot l for the hinge of the edge from p[0] to p[1] with k = p[2] on its left
// and l = p[3] on its right: l lies outside of the circle of the others if it is positive.
CGAL::Sign by_determinant(const std::array<Point_2, 4>& p)
{
  std::array<std::array<Rational, 3>, 3> m;
  for (int n = 0; n < 3; ++n) {
    const Rational x = Rational(p[n][0]) - Rational(p[3][0]), y = Rational(p[n][1]) - Rational(p[3][1]);
    m[n] = {x, y, x * x + y * y};
  }
  const Rational determinant = m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]) +
                               m[1][2] * (m[2][0] * m[0][1] - m[2][1] * m[0][0]) +
                               m[2][2] * (m[0][0] * m[1][1] - m[0][1] * m[1][0]);
  return determinant > 0 ? CGAL::NEGATIVE : determinant < 0 ? CGAL::POSITIVE : CGAL::ZERO;
}

// In a plane parallel to two of the axes, any two.
IT::internal::Points in_space(const std::array<Point_2, 4>& p, int plane)
{
  IT::internal::Points points;
  for (const Point_2& q : p)
    points.push_back(plane == 0   ? std::array<double, 3>{q[0], q[1], 0.1}
                     : plane == 1 ? std::array<double, 3>{q[1], -7, q[0]}
                                  : std::array<double, 3>{3, q[0], q[1]});
  return points;
}

void expect_the_sign_of_the_determinant(const std::array<Point_2, 4>& p)
{
  const IT::Delta_complex complex =
    IT::make_Delta_complex_from_triangles(4, std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {1, 0, 3}});
  const IT::Edge_index e = [&] {
    for (IT::Edge_index each : complex.edges())
      if (complex.is_flippable(each))
        return each;
    return IT::Edge_index();
  }();
  for (int plane = 0; plane < 3; ++plane) {
    const IT::internal::Points points = in_space(p, plane);
    const IT::Halfedge_index h = complex.halfedge(e);
    ASSERT_TRUE(IT::internal::is_flat(complex, points, h));
    const std::vector<IT::Surface_point> no_locations;
    const IT::internal::Vertex_positions::Inserted none_inserted;
    const IT::internal::Vertex_positions positions(complex, points, no_locations, none_inserted);
    EXPECT_EQ(IT::internal::Coplanar_hinge(complex, positions, h).sign_of_cotangents(), by_determinant(p));
  }
}

// Corners of rectangles in a grid, all of them ties, and those next to them in the grid.
TEST(Coplanar_hinge, Integers)
{
  for (double unit : {1., 0x1p-20, 0x1p30})
    for (double size : {1., 1000., 16777215.})
      for (double step : {-1., 0., 1.})
        expect_the_sign_of_the_determinant({Point_2{0, 0}, Point_2{size * unit, size * unit}, Point_2{0, size * unit},
                                            Point_2{(size + step / 1024) * unit, 0}});
}

// Four points near a circle far from the origin, down to the last place.
TEST(Coplanar_hinge, NearTies)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> jitter(-1, 1);
  std::array<int, 7> hinges{};
  for (int n = 0; n < 20000; ++n) {
    const double center = n % 3 == 0 ? 0 : jitter(random), epsilon = std::pow(2., -(n % 60));
    const auto on_circle = [&](double angle) {
      return Point_2{center + std::cos(angle) * (1 + epsilon * jitter(random)),
                     center + std::sin(angle) * (1 + epsilon * jitter(random))};
    };
    const double width = std::pow(10., -(n % 7)); // needles, too
    const std::array<Point_2, 4> p{on_circle(0.1), on_circle(0.1 + 2 * width), on_circle(3), on_circle(0.1 + width)};
    const auto is_left_turn = [](const Point_2& a, const Point_2& b, const Point_2& c) {
      return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 1e-15;
    };
    if (is_left_turn(p[0], p[1], p[2]) && is_left_turn(p[1], p[0], p[3])) {
      expect_the_sign_of_the_determinant(p);
      ++hinges[std::size_t(n % 7)];
    }
  }
  for (int number : hinges) // of each width
    EXPECT_GT(number, 300);
}

// Points of a tilted plane with 48 bits, whose volume is zero but not in double-doubles, and points next to it, down to
// distances that only exact numbers tell from zero.
TEST(Coplanar_points, AreToldFromPointsThatAreBarelyBent)
{
  std::mt19937 random(4);
  const auto part = [&] { return std::ldexp(double(random()), -32) + std::ldexp(double(random() % 4096), -44); };
  for (int n = 0; n < 1000; ++n) {
    IT::internal::Points points;
    for (int i = 0; i < 3; ++i) {
      const double a = part(), b = part();
      points.push_back({3 * a + b, 4 * b + a, 7 * b - 2 * a});
    }
    const auto are_coplanar = [&](const std::array<double, 3>& last) {
      points.resize(3);
      points.push_back(last);
      using Index = IT::Vertex_index;
      return IT::internal::are_coplanar(points, Index(0), Index(1), Index(2), Index(3));
    };
    EXPECT_TRUE(are_coplanar({0, 0, 0}));
    for (int k = 20; k < 300; k += 8)
      EXPECT_FALSE(are_coplanar({0, 0, std::ldexp(1., -k)})) << k;
  }
}

// Rectangles with sides along two directions that are not axes: exact ties with many bits.
TEST(Coplanar_hinge, TiesOfManyBits)
{
  std::mt19937 random(2);
  for (int n = 0; n < 1000; ++n) {
    const double a = double(random() % (1u << 26)) + 1, b = double(random() % (1u << 26));
    expect_the_sign_of_the_determinant(
      {Point_2{0, 0}, Point_2{3 * a - b, 3 * b + a}, Point_2{-b, a}, Point_2{3 * a, 3 * b}});
  }
}

// Gaussian integers of one norm, 5³ · 13 · 17, times a large one: cocircular, and no rectangle.
TEST(Coplanar_hinge, TiesBeyondDoubleDoubles)
{
  std::mt19937 random(3);
  for (int n = 0; n < 1000; ++n) {
    const double a = double(random() % (1u << 30)) + 1, b = double(random() % (1u << 30));
    const auto turned = [&](double x, double y) { return Point_2{a * x - b * y, a * y + b * x}; };
    expect_the_sign_of_the_determinant({turned(165, 20), turned(-141, 88), turned(27, -164), turned(-20, 165)});
  }
}

} // namespace
