// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Error-free transformations of products, where the compiler may fuse. Compiled for a processor with fused
// multiply-adds.

#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Double_double.h>
#include "library/arithmetic/Split_double_double.h"
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Two_doubles.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>

namespace {

using namespace CGAL::Intrinsic_triangulations::internal;

// A product as it is rounded, whatever the compiler does elsewhere.
double product(double a, double b)
{
  volatile double result = a * b;
  return result;
}

// The error of a sum (Knuth), each operation of which is rounded.
double error_of_sum(double a, double b)
{
  volatile double s = a + b, bb = s - a, rest = s - bb, x = a - rest, y = b - bb, e = x + y;
  return e;
}

// The error of a product: not by std::fma(), which rounds more than once in some C libraries.
double error_of_product(double a, double b)
{
  using Quadruple = boost::multiprecision::cpp_bin_float_quad;
  return (Quadruple(a) * Quadruple(b) - Quadruple(product(a, b))).convert_to<double>();
}

class Fused_products : public testing::Test
{
protected:
  double number() { return std::ldexp(double(std::int64_t(random_() >> 10)), -54) - 0.25; }

  template <class Check>
  void for_random_numbers(const Check& check)
  {
#if defined(__FMA__) && defined(__GNUC__)
    if (!__builtin_cpu_supports("fma"))
      GTEST_SKIP() << "this processor has no fused multiply-add";
#endif
    for (int i = 0; i < 10000; ++i)
      check(number(), number(), number(), number());
  }

private:
  std::mt19937_64 random_{1};
};

TEST_F(Fused_products, sums_of_products_are_error_free)
{
  for_random_numbers([](double a, double b, double c, double d) {
    double s, e;
    two_sum(a * b, c * d, s, e);
    const double p = product(a, b), q = product(c, d);
    ASSERT_EQ(s, p + q);
    ASSERT_EQ(e, error_of_sum(p, q));
    fast_two_sum(a * b, 0x1p-30 * c * d * a * b, s, e);
    const double small = product(product(product(0x1p-30 * c, d), a), b);
    ASSERT_EQ(s, p + small);
    ASSERT_EQ(e, error_of_sum(p, small));
  });
}

TEST_F(Fused_products, products_of_parts_are_exact)
{
  for_random_numbers([](double a, double b, double c, double d) {
    double first, first_tail, second, second_tail;
    split(a * b, first, first_tail);
    split(c * d, second, second_tail);
    ASSERT_EQ(first + first_tail, product(a, b));
    for (double x : {first, first_tail})
      for (double y : {second, second_tail})
        ASSERT_EQ(error_of_product(x, y), 0);
  });
}

// GCC makes fused operations of the differences from a multiple that nothing else needs: the head would be the whole
// number.
TEST_F(Fused_products, parts_have_half_of_the_digits)
{
  for_random_numbers([](double a, double, double, double) {
    double head, tail;
    split(a, head, tail);
    ASSERT_EQ(head + tail, a);
    for (double x : {head, tail})
      ASSERT_EQ(error_of_product(head, x), 0);
  });
}

TEST_F(Fused_products, products_of_products_are_error_free)
{
  for_random_numbers([](double a, double b, double c, double d) {
    double p, e;
    two_product(a * b, c * d, p, e);
    ASSERT_EQ(p, product(product(a, b), product(c, d)));
    ASSERT_EQ(e, error_of_product(product(a, b), product(c, d)));
  });
}

// A sum of products is exact up to 2^-102, for one number and for two.
template <class Number>
Number sum_of_products(const Number& a, const Number& b, const Number& c, const Number& d, Number& low)
{
  using Real = Split_double_double<Number>;
  const Real x(a * b, Number(0.)), y(c * d, Number(0.));
  const Real result = sum(x * x, -(y * y));
  low = result.lo;
  return result.hi;
}

TEST_F(Fused_products, split_numbers_are_accurate)
{
  for_random_numbers([](double a, double b, double c, double d) {
    const double x = product(a, b), y = product(c, d);
    const long double exact = (static_cast<long double>(x) - y) * (static_cast<long double>(x) + y); // to 2^-62
    double low;
    const double high = sum_of_products(a, b, c, d, low);
    ASSERT_LE(std::abs(static_cast<long double>(high) + low - exact), 0x1p-60L * (x * x + y * y));
    Two_doubles two_low;
    const Two_doubles two = sum_of_products<Two_doubles>({a, c}, {b, d}, {c, a}, {d, b}, two_low);
    ASSERT_EQ(two.first(), high);
    ASSERT_EQ(two_low.first(), low);
    ASSERT_EQ(two.second(), -high);
    ASSERT_EQ(two_low.second(), -low);
  });
}

} // namespace
