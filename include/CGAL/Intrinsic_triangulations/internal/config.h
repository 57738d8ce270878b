// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Settings that the library and all parts of a program must share.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONFIG_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONFIG_H

// Decisions are exact only if each operation on doubles is rounded as IEEE 754 says.
#if defined(__FAST_MATH__) || defined(_M_FP_FAST) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) ||  \
  defined(__NO_SIGNED_ZEROS__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error                                                                                                                 \
  "Intrinsic_triangulations needs IEEE 754 arithmetic: compile without -Ofast, -ffast-math and the options that it implies"
#endif
#if defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ != 0 && __FLT_EVAL_METHOD__ != 16
#error "Intrinsic_triangulations needs doubles without excess precision: compile with -msse2 -mfpmath=sse"
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONFIG_H
