// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Requirements on every number type.

#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

TEST(Number_type, square_root_of_a_square)
{
  const Number_type three(3);
  const Number_type root = CGAL::sqrt(three * three);
  EXPECT_TRUE(CGAL::possibly(root == three));
}

TEST(Number_type, three_thirds)
{
  const Number_type third = Number_type(1) / Number_type(3);
  const Number_type difference = third * Number_type(3) - Number_type(1);
  EXPECT_TRUE(CGAL::possibly(CGAL::abs(difference) <= Number_type(1. / 1048576.)));
}
