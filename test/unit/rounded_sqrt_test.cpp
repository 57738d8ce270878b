// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Square roots against integers. Compiled without optimization, so that the C library's function would be called, which
// rounds twice on Windows: one in 4000 is wrong.

#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/rounded_sqrt.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/triangle_formulas_3.h>

#include <CGAL/Interval_nt.h>

#include <boost/config.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Interval = CGAL::Interval_nt<>;
using Integer = boost::uint128_type;

// In [1, 4): neighbours of squares, and random numbers.
std::vector<double> numbers()
{
  std::vector<double> result{1, 2, 3, 2.25, 4 * (1 - 0x1p-53), 4 * (1 - 0x1p-52), 1 + 0x1p-52, 1 + 0x1p-51};
  std::mt19937_64 random(7);
  for (int i = 0; i < 100000; ++i)
    result.push_back(std::uniform_real_distribution<double>(1, 4)(random));
  return result;
}

// in units of 2^-52
Integer integer(double x) { return Integer(std::uint64_t(x * 0x1p52)); }
Integer square(Integer x) { return x * x; }
Integer squared(double x) { return integer(x) << 52; }

bool is_nearest(double root, double x)
{
  const Integer twice = 2 * integer(root);
  return square(twice - 1) <= 4 * squared(x) && 4 * squared(x) <= square(twice + 1);
}
bool is_next_below(double root, double x)
{
  return square(integer(root)) <= squared(x) && squared(x) < square(integer(root) + 1);
}
bool is_next_above(double root, double x)
{
  return square(integer(root) - 1) < squared(x) && squared(x) <= square(integer(root));
}

template <class Root>
int number_of_wrong_roots(const Root& root)
{
  int result = 0;
  for (double x : numbers())
    for (int scale : {-500, 0, 500})
      result += !is_nearest(std::ldexp(root(std::ldexp(x, 2 * scale)), -scale), x);
  return result;
}

TEST(rounded_sqrt, is_the_nearest_double)
{
  EXPECT_EQ(number_of_wrong_roots([](double x) { return IT::internal::rounded_sqrt(x); }), 0);
  EXPECT_EQ(IT::internal::rounded_sqrt(0x1p-1074), 0x1p-537);
  EXPECT_EQ(IT::internal::rounded_sqrt(0.), 0);
  EXPECT_TRUE(std::isnan(IT::internal::rounded_sqrt(-1.)));
}

TEST(rounded_sqrt, is_that_of_traits)
{
  EXPECT_EQ(number_of_wrong_roots([](double x) { return IT::internal::sqrt_of_non_negative(x); }), 0);
  EXPECT_EQ(number_of_wrong_roots(IT::Edge_length_traits<double>().compute_length_object()), 0);
  EXPECT_EQ(number_of_wrong_roots(IT::Filtered_edge_length_traits().compute_length_object()), 0);
}

TEST(rounded_sqrt, encloses_with_intervals)
{
  int wrong = 0;
  const IT::Edge_length_traits<Interval>::Compute_length length =
    IT::Edge_length_traits<Interval>().compute_length_object();
  for (double x : numbers()) {
    const double y = (x + 4) / 2;
    for (const Interval& root : {IT::internal::rounded_sqrt(Interval(x, y)), length(Interval(x, y)),
                                 IT::internal::sqrt_of_non_negative(Interval(x, y))})
      wrong += !is_next_below(root.inf(), x) || !is_next_above(root.sup(), y);
  }
  EXPECT_EQ(wrong, 0);
  const Interval root = IT::internal::rounded_sqrt(Interval(-1, 4));
  EXPECT_EQ(root.inf(), 0);
  EXPECT_EQ(root.sup(), 2);
}

} // namespace
