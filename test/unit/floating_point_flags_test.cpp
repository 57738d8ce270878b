// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The flags of the package's target: no contraction to fused multiply-adds, and an optimizer that respects the rounding
// mode.

#include <CGAL/Interval_nt.h>

#include <gtest/gtest.h>

#if defined(__x86_64__) && (defined(__GNUC__) || defined(__clang__))

// Lets the compiler fuse in this function, as -march=native would.
__attribute__((target("fma"))) static double square_minus(double x, double y) { return x * x - y; }

TEST(Floating_point_flags, products_are_not_fused)
{
  if (!__builtin_cpu_supports("fma"))
    GTEST_SKIP() << "this processor has no fused multiply-add";
  volatile double third = 1. / 3.;
  volatile double square = third * third;
  EXPECT_EQ(square_minus(third, square), 0.);
}

#endif

TEST(Floating_point_flags, interval_of_constants_has_width)
{
  const CGAL::Interval_nt<true> third = CGAL::Interval_nt<true>(1) / CGAL::Interval_nt<true>(3);
  EXPECT_LT(third.inf(), third.sup());
}
