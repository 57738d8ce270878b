// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The options of the package's target: an optimized function must not depend on which registers the copy of an inline
// function uses that its compiler saw. Compiled without optimization, and linked first, so that this copy is taken. The
// numbers of function_copies_optimized.cpp were wrong on Windows (see CMakeLists.txt for -fno-ipa-ra).

#include "function_copies.h"

#include <gtest/gtest.h>

namespace {

TEST(Function_copies, of_other_options_leave_the_numbers_of_their_callers_alone)
{
  EXPECT_EQ(clamped<std::int64_t>(7), 7);
  EXPECT_EQ(optimized_number(1, 2, 3), 123);
}

} // namespace
