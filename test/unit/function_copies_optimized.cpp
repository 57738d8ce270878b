// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The half of function_copies_test.cpp that is optimized, as the library is.

#include "function_copies.h"

std::int64_t optimized_number(std::int64_t hundreds, std::int64_t tens, std::int64_t ones)
{
  return 100 * clamped(hundreds) + 10 * tens + ones;
}
