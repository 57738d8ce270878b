// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/errors.h>

#include <gtest/gtest.h>

namespace IT = CGAL::Intrinsic_triangulations;

TEST(Errors, invalid_surface_error_says_what_where_and_how_many)
{
  try {
    throw IT::Invalid_surface_error(IT::Invalid_surface_error::Defect::ZERO_LENGTH_EDGE, 7, 3,
                                    "edge 7 has length zero (and 2 more)");
  } catch (const IT::Error& error) {
    const auto* invalid = dynamic_cast<const IT::Invalid_surface_error*>(&error);
    ASSERT_NE(invalid, nullptr);
    EXPECT_EQ(invalid->defect(), IT::Invalid_surface_error::Defect::ZERO_LENGTH_EDGE);
    EXPECT_EQ(invalid->element(), 7u);
    EXPECT_EQ(invalid->count(), 3u);
    EXPECT_STREQ(invalid->what(), "edge 7 has length zero (and 2 more)");
  }
}

TEST(Errors, each_is_an_error_and_a_runtime_error)
{
  EXPECT_THROW(throw IT::Undecided_error("undecided"), IT::Error);
  EXPECT_THROW(throw IT::Integer_overflow_error("overflow"), IT::Error);
  EXPECT_THROW(throw IT::Error("error"), std::runtime_error);
}
