// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Intervals with MPFR end points: their products, for all signs of the ends.

#include "library/arithmetic/Mpfr_interval.h"
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Rational.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::internal::Mpfr_interval;
using IT::internal::Rational;

constexpr long precision = 64;

Mpfr_interval interval(double low, double high)
{
  Mpfr_interval half_width((Rational(high) - Rational(low)).backend().data(), precision);
  half_width.make_symmetric();
  const Rational twice_the_center = Rational(high) + Rational(low);
  return ldexp(Mpfr_interval(twice_the_center.backend().data(), precision) + half_width, -1);
}

TEST(Mpfr_interval, products_are_those_of_the_ends)
{
  std::vector<std::pair<double, double>> ends;
  for (double low : {-5., -2., -1., 0., 1., 3.})
    for (double high : {-5., -2., -1., 0., 1., 3., 7.})
      if (low <= high)
        ends.emplace_back(low, high);
  for (const auto& [a, b] : ends)
    for (const auto& [c, d] : ends) {
      const Mpfr_interval product = interval(a, b) * interval(c, d);
      const auto [low, high] = std::minmax({a * c, a * d, b * c, b * d});
      EXPECT_EQ(product.lower_double(), low) << a << ' ' << b << ' ' << c << ' ' << d;
      EXPECT_EQ(product.upper_double(), high) << a << ' ' << b << ' ' << c << ' ' << d;
    }
}

TEST(Mpfr_interval, products_are_rounded_outward)
{
  const Rational third = Rational(1) / Rational(3);
  for (int sign_of_a : {-1, 1})
    for (int sign_of_b : {-1, 1}) {
      const Rational a = sign_of_a * third, b = sign_of_b * third;
      const Mpfr_interval product =
        Mpfr_interval(a.backend().data(), precision) * Mpfr_interval(b.backend().data(), precision);
      const Rational exact = a * b;
      EXPECT_LT(mpfr_cmp_q(product.lower(), exact.backend().data()), 0);
      EXPECT_GT(mpfr_cmp_q(product.upper(), exact.backend().data()), 0);
      EXPECT_LT(product.upper_double() - product.lower_double(), 0x1p-52);
    }
}

TEST(Mpfr_interval, without_an_end)
{
  const Mpfr_interval line = interval(1, 1) / interval(-1, 1);
  EXPECT_EQ(line.lower_double(), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(line.upper_double(), std::numeric_limits<double>::infinity());
  for (const Mpfr_interval& factor : {interval(-1, 1), interval(2, 3), interval(-3, -2), interval(0, 1)}) {
    EXPECT_FALSE(CGAL::is_certain((line * factor).sign()));
    EXPECT_FALSE(CGAL::is_certain((factor * line).sign()));
  }
  EXPECT_EQ((line * interval(0, 0)).sign(), CGAL::ZERO); // of finite numbers
  const IT::internal::Mpfr_disk unknown(line, interval(1, 1));
  for (const IT::internal::Mpfr_disk& z : {unknown * unknown, unknown + unknown, unknown - unknown}) {
    EXPECT_FALSE(CGAL::is_certain(z.x().sign()));
    EXPECT_FALSE(CGAL::is_certain((z.x() * interval(-2, 1)).sign()));
    EXPECT_FALSE(CGAL::is_certain((z.x() * interval(2, 3) + interval(5, 6)).sign()));
  }
}

TEST(Mpfr_interval, can_be_assigned_to_after_a_move)
{
  Mpfr_interval a = interval(1, 2), b = std::move(a);
  a = interval(3, 4);
  EXPECT_EQ(a.lower_double(), 3);
  EXPECT_EQ(b.upper_double(), 2);
  a = std::move(b);
  EXPECT_EQ(a.upper_double(), 2);
}

} // namespace
