// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers of quadruple precision: Boost's own, and the compiler's with Boost's wrapper, if there are any.

#include <boost/multiprecision/cpp_bin_float.hpp>
#if __has_include(<quadmath.h>)
#include <boost/multiprecision/float128.hpp>
#endif

#include <gtest/gtest.h>

namespace {
using Number_types = testing::Types<
#ifdef __SIZEOF_FLOAT128__
  __float128,
#endif
#if __has_include(<quadmath.h>)
  boost::multiprecision::float128,
#endif
  boost::multiprecision::cpp_bin_float_quad>;
} // namespace

#include "float_type_tests.h"
