// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A function that two sources compile with different options: their program has one copy of it.

#ifndef TEST_UNIT_FUNCTION_COPIES_H
#define TEST_UNIT_FUNCTION_COPIES_H

#include <boost/config.hpp>

#include <cstdint>

template <class T>
T median(T a, T b, T c)
{
  return a < b ? (b < c ? b : c) : (a < c ? a : c);
}
// Without optimization, it calls the function above, whose three arguments overwrite those of the caller.
template <class T>
BOOST_NOINLINE T clamped(T x)
{
  return median(T(0), x, T(9));
}

std::int64_t optimized_number(std::int64_t hundreds, std::int64_t tens, std::int64_t ones);

#endif // TEST_UNIT_FUNCTION_COPIES_H
