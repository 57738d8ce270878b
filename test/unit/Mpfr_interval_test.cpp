// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Intervals with MPFR end points: their products, for all signs of the ends.

#include "library/arithmetic/Mpfr_disk.h"
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Rational.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
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
  const Rational twice_the_center = Rational(high) + Rational(low);
  return ldexp(Mpfr_interval(twice_the_center.backend().data(), precision) + Mpfr_interval::symmetric(high - low, 0),
               -1);
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

Mpfr_interval exactly(const Rational& x) { return Mpfr_interval(x.backend().data(), precision); }

bool contains(const Mpfr_interval& i, const Rational& exact)
{
  return mpfr_cmp_q(i.lower(), exact.backend().data()) <= 0 && mpfr_cmp_q(i.upper(), exact.backend().data()) >= 0;
}

// One rounding each, of up to half a unit in the last place.
TEST(Mpfr_disk, contains_products_and_sums)
{
  std::uint64_t bits = 1;
  const auto next = [&] { return Rational(bits = bits * 6364136223846793005u + 1442695040888963407u); };
  for (int i = 0; i < 200; ++i) {
    const Rational a = next(), b = next(), c = next(), d = next();
    const IT::internal::Mpfr_disk u(exactly(a), exactly(b)), v(exactly(c), exactly(d));
    ASSERT_TRUE(contains((u * v).x(), a * c - b * d) && contains((u * v).y(), a * d + b * c)) << i;
    ASSERT_TRUE(contains(times_conjugate(u, v).x(), a * c + b * d) &&
                contains(times_conjugate(u, v).y(), b * c - a * d))
      << i;
    ASSERT_TRUE(contains((u + v).x(), a + c) && contains((u - v).y(), b - d)) << i;
    ASSERT_TRUE(contains(squared_norm(u), a * a + b * b)) << i;
    ASSERT_LT((u * v).x().width().upper_double(), 0x1p68);
  }
}

// (3 + 4 i) / 5 is no root of unity, so neither do its powers repeat nor do their roundings.
TEST(Mpfr_disk, contains_exact_powers)
{
  const Rational re(3, 5), im(4, 5);
  const IT::internal::Mpfr_disk factor(exactly(re), exactly(im));
  IT::internal::Mpfr_disk power = factor;
  Rational x = re, y = im;
  for (int n = 1; n < 200; ++n) {
    ASSERT_TRUE(contains(power.x(), x) && contains(power.y(), y)) << n;
    ASSERT_LT(power.x().width().upper_double(), n * 0x1p-60);
    ASSERT_TRUE(contains(squared_norm(power), 1)) << n;
    power = power * factor;
    const Rational next = x * re - y * im;
    y = x * im + y * re;
    x = next;
  }
}

TEST(Mpfr_disk, has_no_limits_of_double)
{
  IT::internal::Mpfr_disk small(ldexp(interval(1, 1.5), -900), ldexp(interval(2, 2.5), -900));
  for (int i = 0; i < 4; ++i)
    small = small * small;
  EXPECT_TRUE(mpfr_regular_p(small.x().lower()));
  EXPECT_LT(mpfr_get_exp(small.x().lower()), -14000);
  EXPECT_GT(mpfr_get_exp(small.x().width().upper()), -14500);
  EXPECT_GT(mpfr_sgn((small - small).x().width().upper()), 0);
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
