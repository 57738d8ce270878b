// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sums of two doubles, and doubles, against rational numbers: no error exceeds its bound.

#include <CGAL/Intrinsic_triangulations/internal/arithmetic/With_error.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Double_double.h>
#include "library/arithmetic/Disk.h"
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Rational.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <type_traits>

namespace {

using CGAL::Intrinsic_triangulations::internal::Bounded_double_double;
using CGAL::Intrinsic_triangulations::internal::Disk;
using CGAL::Intrinsic_triangulations::internal::Double_double;
using CGAL::Intrinsic_triangulations::internal::Double_with_bound;
using Rational = CGAL::Intrinsic_triangulations::internal::Rational;

// Numbers of few bits and of all bits, whose lower part is next to half a unit in the last place of the upper one as
// often as not: there a sum has to be normalized twice.
class Operands
{
public:
  Double_double operator()()
  {
    const int bits = random_() % 3 == 0 ? 53 : 1 + int(random_() % 53);
    const double odd = double((random_() >> (64 - bits)) | 1), hi = std::ldexp(odd, int(random_() % 7) - bits);
    const double unit = std::ldexp(1., std::ilogb(hi) - 53); // half a unit in the last place
    double lo = 0;
    switch (random_() % 4) {
    case 0:
      break;
    case 1: // an upper part of 53 bits may be odd
      lo = bits < 53 ? unit : std::nextafter(unit, 0);
      break;
    case 2:
      lo = unit * (1 - std::ldexp(1., -1 - int(random_() % 52)));
      break;
    default:
      lo = unit * std::ldexp(double(random_() >> 11), -53 - int(random_() % 30));
    }
    const double sign = random_() % 2 == 0 ? 1 : -1;
    // Below a power of two, half a unit is half as large.
    return {sign * hi, random_() % 2 == 0 || std::ldexp(odd, -bits) == 0.5 ? sign * lo : -sign * lo};
  }

private:
  std::mt19937_64 random_{1};
};

Rational exact(const Double_double& x) { return Rational(x.hi) + Rational(x.lo); }
Rational exact(const Bounded_double_double& x) { return Rational(x.hi()) + Rational(x.lo()); }
Rational exact(const Double_with_bound& x) { return Rational(x.hi()); }
Bounded_double_double bounded(const Double_double& x) { return {x.hi, x.lo, 0}; }

template <class Number>
bool is_within_bound(const Number& computed, const Rational& truth)
{
  return !(Rational(computed.error()) < abs(exact(computed) - truth));
}

TEST(Double_double, is_as_accurate_as_it_says)
{
  Operands operand;
  for (int i = 0; i < 200000; ++i) {
    const Double_double a = operand(), b = operand();
    const Rational sum = exact(a) + exact(b), product = exact(a) * exact(b);
    ASSERT_FALSE(abs(sum) * Rational(0x1p-103) < abs(exact(a + b) - sum)) << i;
    ASSERT_FALSE(abs(product) * Rational(0x1p-103) < abs(exact(a * b) - product)) << i;
  }
}

template <class Number>
void expect_bounds_that_hold(const Double_double& a, const Double_double& b, const Double_double& c)
{
  const Number x(bounded(a)), y(bounded(b)), z(bounded(c));
  ASSERT_TRUE(is_within_bound(x + y, exact(a) + exact(b)));
  ASSERT_TRUE(is_within_bound(x - y, exact(a) - exact(b)));
  ASSERT_TRUE(is_within_bound(x * y, exact(a) * exact(b)));
  ASSERT_TRUE(is_within_bound(x / y, exact(a) / exact(b)));
  ASSERT_TRUE(is_within_bound(x * y - z * y, (exact(a) - exact(c)) * exact(b)));
  ASSERT_TRUE(is_within_bound((x * y + z).scaled(0.5) / y, (exact(a) * exact(b) + exact(c)) / exact(b) / 2));
  const Number difference = x * y - y * x;
  ASSERT_TRUE(!is_certain(difference.sign()) || difference.is_zero());
  ASSERT_TRUE(certainly(x.sign() == (a.hi > 0 ? CGAL::POSITIVE : CGAL::NEGATIVE)));
}

TEST(Double_double, has_bounds_that_hold)
{
  Operands operand;
  for (int i = 0; i < 100000; ++i) {
    const Double_double a = operand(), b = operand(), c = operand();
    SCOPED_TRACE(i);
    expect_bounds_that_hold<Bounded_double_double>(a, b, c);
    expect_bounds_that_hold<Double_with_bound>(a, b, c);
    const Bounded_double_double x = bounded(a);
    if (a.hi > 0) {
      const Bounded_double_double root = sqrt(x);
      const Rational low = exact(root) - Rational(root.error()), high = exact(root) + Rational(root.error());
      ASSERT_FALSE(exact(a) < low * low || high * high < exact(a)) << i;
    }
  }
}

template <class Number>
void expect_disks_that_hold(const Double_double& a, const Double_double& b, const Double_double& c,
                            const Double_double& d)
{
  const Disk<Number> u(Number(bounded(a)), Number(bounded(b))), v(Number(bounded(c)), Number(bounded(d)));
  const auto expect_inside = [&](const Disk<Number>& computed, const Rational& x, const Rational& y) {
    const Rational dx = exact(computed.x()) - x, dy = exact(computed.y()) - y, radius(computed.radius());
    ASSERT_FALSE(radius * radius < dx * dx + dy * dy);
    ASSERT_LE(computed.radius(), 64 * Number::unit * (1 + computed.modulus())); // an infinite one would hold, too
  };
  expect_inside(u, exact(a), exact(b));
  expect_inside(u + v, exact(a) + exact(c), exact(b) + exact(d));
  expect_inside(u - v, exact(a) - exact(c), exact(b) - exact(d));
  expect_inside(u * v, exact(a) * exact(c) - exact(b) * exact(d), exact(a) * exact(d) + exact(b) * exact(c));
  expect_inside(times_conjugate(u, v), exact(a) * exact(c) + exact(b) * exact(d),
                exact(b) * exact(c) - exact(a) * exact(d));
  ASSERT_TRUE(is_within_bound(squared_norm(u), exact(a) * exact(a) + exact(b) * exact(b)));
  if constexpr (std::is_same<Number, Bounded_double_double>::value) {
    expect_inside(u / bounded(c), exact(a) / exact(c), exact(b) / exact(c));
    const double error = 4 * Number::unit * std::abs(c.hi); // of the divisor
    for (int sign : {1, -1}) {
      const Rational divisor = exact(c) + sign * Rational(error);
      expect_inside(u / Number(c.hi, c.lo, error), exact(a) / divisor, exact(b) / divisor);
    }
  }
}

TEST(Double_double, has_disks_that_hold)
{
  Operands operand;
  for (int i = 0; i < 50000; ++i) {
    const Double_double a = operand(), b = operand(), c = operand(), d = operand();
    SCOPED_TRACE(i);
    expect_disks_that_hold<Bounded_double_double>(a, b, c, d);
    expect_disks_that_hold<Double_with_bound>(a, b, c, d);
  }
}

TEST(Double_double, is_rounded_where_the_bound_leaves_one_double)
{
  constexpr double ulp = 0x1p-52, half = ulp / 2, infinity = std::numeric_limits<double>::infinity();
  const auto expect = [](const std::optional<double>& value, double hi, double lo, double error) {
    EXPECT_EQ(rounded(Bounded_double_double(hi, lo, error)), value);
    EXPECT_EQ(rounded(Bounded_double_double(-hi, -lo, error)), value ? std::make_optional(-*value) : std::nullopt);
  };
  expect(0, 0, 0, 0);
  expect(1, 1, ulp / 4, ulp / 8);
  expect(std::nullopt, 1, ulp / 4, ulp / 3);
  expect(std::nullopt, 0, 0, 1e-300);
  expect(std::nullopt, 1, 0, infinity);
  // Halfway, and so little from there that another order of the computation could come to the other side.
  for (double lo : {half, half * (1 - 0x1p-24)})
    expect(1 + ulp, 1, lo, 0x1p-90);
  expect(1 + ulp, 1 + ulp, -half, 0x1p-90);
  expect(1, 1, half * (1 - 0x1p-21), 0x1p-90);
  expect(std::nullopt, 1, half * (1 - 0x1p-22), 0x1p-75);
}

} // namespace
