// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Keeps the compiler from fusing a product with a sum.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_UNFUSED_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_UNFUSED_H

#include <CGAL/Intrinsic_triangulations/internal/config.h>

#include <boost/config.hpp>

namespace CGAL::Intrinsic_triangulations::internal {

// Returns x in a way that hides its origin from the optimizer.
//
// Where the processor has fused multiply-adds, a compiler may round a b + c once instead of twice, in one place of a
// function and not in another. That harms no error bound, but an error-free transformation needs one value of a b. The
// option -ffp-contract=off does not suffice: users of headers do not set it, and the vectorizer of GCC 12 forms
// vfmaddsub in spite of it.
#if (defined(__x86_64__) || defined(__i386__)) && !defined(__FMA__) && !defined(__FMA4__)
template <class Number>
BOOST_FORCEINLINE Number unfused(const Number& x)
{
  return x; // the processor has no such instruction
}
#else
template <class Number>
BOOST_FORCEINLINE Number unfused(Number x)
{
#if defined(__GNUC__) && defined(__SSE2_MATH__)
  asm("" : "+x"(x));
#elif defined(__GNUC__) && defined(__aarch64__)
  asm("" : "+w"(x));
#elif defined(__GNUC__)
  asm("" : "+m"(x));
#else
  volatile Number opaque = x;
  x = opaque;
#endif
  return x;
}
#endif

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_UNFUSED_H
