// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The in-circle test of points of one plane, some of them weighted means of others, against the determinant in rational
// numbers.

#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Rational.h>
#include "library/engine/decide/Coplanar_hinge.h"
#include "library/engine/layout/Vertex_positions.h"
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/squared_lengths.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::internal::Rational;
using Weights = std::array<double, 3>;
using Vector = std::array<Rational, 3>;

Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
CGAL::Sign sign_of(const Rational& x) { return x > 0 ? CGAL::POSITIVE : x < 0 ? CGAL::NEGATIVE : CGAL::ZERO; }
Rational product(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// A triangle (0, 1, 2) in space, and points of it after its corners.
struct Points_of_a_triangle
{
  explicit Points_of_a_triangle(const IT::internal::Points& corners)
    : points(corners),
      input(IT::make_Delta_complex_from_triangles(3, std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}}))
  {
    while (input.source(base).idx() != 0 || input.is_border(base))
      base = IT::Halfedge_index(base.idx() + 1);
  }

  std::uint32_t add(const Weights& w)
  {
    locations.push_back({base, w});
    inserted.push_back(positions().rounded(locations.back()));
    return std::uint32_t(2 + locations.size());
  }
  IT::internal::Vertex_positions positions() const { return {input, points, locations, inserted}; }

  // Relative to the corners: the first two of these are affine coordinates in the plane.
  std::array<Rational, 2> coordinates(std::uint32_t v) const
  {
    if (v < 3)
      return {Rational(v == 1 ? 1 : 0), Rational(v == 2 ? 1 : 0)};
    const Weights& w = locations[v - 3].coordinates;
    const Rational sum = Rational(w[0]) + Rational(w[1]) + Rational(w[2]);
    return {Rational(w[1]) / sum, Rational(w[2]) / sum};
  }
  Vector position(std::uint32_t v) const
  {
    const auto [a, b] = coordinates(v);
    Vector result;
    for (std::size_t c = 0; c < 3; ++c)
      result[c] = Rational(points[0][c]) * (1 - a - b) + Rational(points[1][c]) * a + Rational(points[2][c]) * b;
    return result;
  }
  // The sign of the area of three points.
  CGAL::Sign turn(std::uint32_t u, std::uint32_t v, std::uint32_t w) const
  {
    const auto a = coordinates(u), b = coordinates(v), c = coordinates(w);
    return sign_of((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
  }
  // As the sign of cotangents of the edge from v[0] to v[1], with v[2] on its left and v[3] on its right.
  CGAL::Sign by_determinant(const std::array<std::uint32_t, 4>& v) const
  {
    std::array<std::array<Rational, 3>, 3> m;
    const auto origin = coordinates(v[3]);
    for (std::size_t n = 0; n < 3; ++n) {
      const Vector d = minus(position(v[n]), position(v[3]));
      const auto [a, b] = coordinates(v[n]);
      m[n] = {a - origin[0], b - origin[1], product(d, d)};
    }
    const Rational determinant = m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]) +
                                 m[1][2] * (m[2][0] * m[0][1] - m[2][1] * m[0][0]) +
                                 m[2][2] * (m[0][0] * m[1][1] - m[0][1] * m[1][0]);
    return -sign_of(determinant);
  }
  CGAL::Sign by_the_library(const std::array<std::uint32_t, 4>& v) const
  {
    const IT::Delta_complex hinge = IT::make_Delta_complex_from_triangles(
      3 + locations.size(), std::vector<std::array<std::uint32_t, 3>>{{v[0], v[1], v[2]}, {v[1], v[0], v[3]}});
    const IT::internal::Vertex_positions all = positions();
    for (IT::Halfedge_index h : hinge.halfedges())
      if (hinge.source(h).idx() == v[0] && hinge.target(h).idx() == v[1])
        return IT::internal::Coplanar_hinge(hinge, all, h).sign_of_cotangents();
    ADD_FAILURE() << "no such edge";
    return CGAL::ZERO;
  }

  IT::internal::Points points;
  IT::Delta_complex input;
  IT::Halfedge_index base{0};
  std::vector<IT::Surface_point> locations;
  IT::internal::Vertex_positions::Inserted inserted;
};

// A right isosceles triangle in a plane that is parallel to no axis: rows of an integral rotation matrix.
IT::internal::Points turned_right_triangle(std::mt19937& random, int bits)
{
  const auto number = [&] { return double(random() % (1u << bits)) + 1; };
  const double a = number(), b = number(), c = number(), d = number(), x = number(), y = number(), z = number();
  return {{x, y, z},
          {x + a * a + b * b - c * c - d * d, y + 2 * (b * c + a * d), z + 2 * (b * d - a * c)},
          {x + 2 * (b * c - a * d), y + a * a - b * b + c * c - d * d, z + 2 * (c * d + a * b)}};
}

// Corners of rectangles and points close to them, with weights that are short or long, sum to 1 or not.
TEST(Coplanar_hinge_inserted, TiesAndNearTies)
{
  std::mt19937 random(1);
  std::array<int, 3> signs{};
  for (int n = 0; n < 6000; ++n) {
    Points_of_a_triangle plane(turned_right_triangle(random, n % 2 == 0 ? 10 : 24));
    const int bits = n % 3 == 0 ? 6 : n % 3 == 1 ? 26 : 50;
    const auto coordinate = [&](double from) {
      return from + std::ldexp(double(random() % (1u << (std::min)(bits - 4, 30)) + 1), -bits) +
             std::ldexp(double(random() % 15), -6);
    };
    const double x = coordinate(0), y = coordinate(0), x2 = coordinate(0.25), y2 = coordinate(0.25);
    const double factor = n % 4 == 0 ? double(random() % 1000 + 1) : n % 4 == 1 ? 0x1p-30 : 1;
    const auto add = [&](double s, double t) { return plane.add({(1 - s - t) * factor, s * factor, t * factor}); };
    const double off = n % 5 == 0 ? std::ldexp(double(random() % 3) - 1, -int(random() % 52)) : 0;
    const std::array<std::uint32_t, 4> v{add(x, y), add(x2, y2), add(x, y2), add(x2 + off, y)};
    if (plane.turn(v[0], v[1], v[2]) != CGAL::POSITIVE || plane.turn(v[1], v[0], v[3]) != CGAL::POSITIVE)
      continue;
    const CGAL::Sign sign = plane.by_the_library(v);
    ASSERT_EQ(sign, plane.by_determinant(v)) << n;
    ++signs[std::size_t(sign + 1)];
  }
  EXPECT_GT(signs[0], 100);
  EXPECT_GT(signs[1], 2000);
  EXPECT_GT(signs[2], 100);
}

// Weights of very different size, also so small that their products underflow.
TEST(Coplanar_hinge_inserted, AnyWeights)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> exponent(-60, 0), far_exponent(-1060, 0);
  int number = 0;
  for (int n = 0; n < 3000; ++n) {
    Points_of_a_triangle plane(turned_right_triangle(random, 20));
    const auto weight = [&] {
      return std::ldexp(double(random()) + 1, int(n % 10 == 0 ? far_exponent(random) : exponent(random)));
    };
    std::array<std::uint32_t, 4> v{0, 1, 2, 0};
    for (std::uint32_t& each : v)
      if (&each == &v[3] || random() % 2 == 0)
        each = plane.add({weight(), weight(), random() % 8 == 0 ? 0 : weight()});
    if (plane.turn(v[0], v[1], v[2]) != CGAL::POSITIVE)
      continue;
    if (plane.turn(v[1], v[0], v[3]) != CGAL::POSITIVE)
      continue;
    ASSERT_EQ(plane.by_the_library(v), plane.by_determinant(v)) << n;
    ++number;
  }
  EXPECT_GT(number, 300);
}

// A vertex on the edge: the face beside it has no area. The edge is Delaunay unless the vertex lies between its ends.
TEST(Coplanar_hinge_inserted, VertexOnTheEdge)
{
  std::mt19937 random(3);
  Points_of_a_triangle plane(turned_right_triangle(random, 24));
  const std::uint32_t third = plane.add({2, 1, 0}), middle = plane.add({3, 3, 0}), last = plane.add({1, 5, 0});
  EXPECT_EQ(plane.by_the_library({third, last, 2, middle}), CGAL::NEGATIVE);
  EXPECT_EQ(plane.by_the_library({middle, last, 2, third}), CGAL::POSITIVE);
  EXPECT_EQ(plane.by_the_library({1, 0, middle, third}), CGAL::NEGATIVE); // both faces have no area
  EXPECT_EQ(plane.by_the_library({middle, 1, third, last}), CGAL::ZERO);
  // So close to an end that only exact numbers tell on which side of that it lies.
  const std::uint32_t close = plane.add({1, 0x1p-150, 0});
  EXPECT_EQ(plane.by_the_library({0, last, 2, close}), CGAL::NEGATIVE);
  EXPECT_EQ(plane.by_the_library({last, 0, close, 2}), CGAL::NEGATIVE);
}

} // namespace
