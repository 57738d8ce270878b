// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The arithmetic behind the positions of crossings keeps its promised bounds.

#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Rational.h>
#include "library/arithmetic/Split_double_double.h"
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Two_doubles.h>
#include <CGAL/Intrinsic_triangulations/squared_lengths.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>

namespace {

namespace IT = CGAL::Intrinsic_triangulations::internal;
using IT::Two_doubles;
using Rational = IT::Rational;
using Number = IT::Split_double_double<double>;
using Pair = IT::Split_double_double<Two_doubles>;

Rational exact(const Number& x) { return Rational(x.hi) + Rational(x.lo); }
// Numbers of many sizes, with a low part that differs from zero.
Number random_number(std::mt19937& generator)
{
  std::uniform_real_distribution<double> mantissa(-1, 1);
  std::uniform_int_distribution<int> exponent(-20, 20);
  const double hi = std::ldexp(mantissa(generator), exponent(generator));
  return Number(hi, std::ldexp(mantissa(generator), std::ilogb(hi) - 54));
}

void expect_near(const Rational& x, const Rational& y, const Rational& scale)
{
  EXPECT_LE(abs(x - y), scale * Rational(0x1p-102)) << x.convert_to<double>() << " " << y.convert_to<double>();
}

TEST(Split_double_double, sums_quotients_and_roots_are_good_to_102_bits)
{
  std::mt19937 generator(1);
  for (int round = 0; round < 2000; ++round) {
    const Number a = random_number(generator), b = random_number(generator), c = random_number(generator),
                 d = random_number(generator);
    // The last two products cancel, up to c times what d is changed by.
    const Number near_d(d.hi * (1 + 0x1p-40), d.lo);
    const Rational x = exact(a) * exact(b), y = exact(c) * exact(d), z = -exact(c) * exact(near_d);
    expect_near(exact(sum(a * b, c * d)), x + y, abs(x) + abs(y));
    expect_near(exact(sum(a * b, c * d, -(c * near_d))), x + y + z, abs(x) + abs(y) + abs(z));
    expect_near(exact(a - b), exact(a) - exact(b), abs(exact(a)) + abs(exact(b)));
    const Rational q = exact(a) / exact(b);
    expect_near(exact(quotient(a, b, 1 / b.hi)), q, abs(q));
    const Number square = sum(a * a, b * b);
    const Rational root = exact(square_root(square));
    // |r - √s| = |r² - s| / (r + √s)
    expect_near(root * root, exact(square), 2 * exact(square));
  }
}

TEST(Split_complex, computes_both_coordinates_as_numbers)
{
  std::mt19937 generator(2);
  for (int round = 0; round < 2000; ++round) {
    std::array<Number, 2> x, y;
    for (std::size_t k : {0, 1}) {
      x[k] = random_number(generator);
      y[k] = random_number(generator);
    }
    const auto pair = [](const Number& a, const Number& b) {
      return Pair(Two_doubles(a.hi, b.hi), Two_doubles(a.lo, b.lo));
    };
    const auto [a, b] = IT::Split_complex::two_points(pair(x[0], x[1]), pair(y[0], y[1]));
    const Rational ax = exact(x[0]), ay = exact(y[0]), bx = exact(x[1]), by = exact(y[1]);
    const IT::Split_complex one(1, 0), i(0, 1);
    // Coordinates, as cross products with the unit vectors.
    const auto expect = [&](const IT::Split_complex& z, const Rational& zx, const Rational& zy, const Rational& scale) {
      expect_near(exact(area_between(z, i)), zx, 2 * scale);
      expect_near(exact(area_between(one, z)), zy, 2 * scale);
    };
    const Rational size_a = abs(ax) + abs(ay), size_b = abs(bx) + abs(by);
    expect(a, ax, ay, size_a);
    expect(-a, -ax, -ay, size_a);
    expect(a + b, ax + bx, ay + by, size_a + size_b);
    expect(a - b, ax - bx, ay - by, size_a + size_b);
    expect(a * b, ax * bx - ay * by, ax * by + ay * bx, size_a * size_b);
    expect_near(exact(area_between(a, b)), ax * by - ay * bx, size_a * size_b);
    EXPECT_GE(Rational(modulus(a)) * Rational(modulus(a)), ax * ax + ay * ay);
  }
}

} // namespace
