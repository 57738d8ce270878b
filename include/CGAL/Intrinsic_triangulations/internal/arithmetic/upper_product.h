// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The upper half of a product of integers, with and without integers of 128 bits.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_UPPER_PRODUCT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_UPPER_PRODUCT_H

#include <cstdint>

#if defined(_MSC_VER) && (defined(_M_X64) || defined(_M_ARM64))
#include <intrin.h>
#endif

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// a b / 2^64, rounded down. For any compiler.
constexpr std::uint64_t upper_product_by_halves(std::uint64_t a, std::uint64_t b)
{
  const std::uint64_t half = 0xffffffffu;
  const std::uint64_t low = (a & half) * (b & half), middle = (a >> 32) * (b & half) + (low >> 32),
                      other_middle = (a & half) * (b >> 32) + (middle & half);
  return (a >> 32) * (b >> 32) + (middle >> 32) + (other_middle >> 32);
}

// The same, in one or two instructions where the compiler offers them.
inline std::uint64_t upper_product(std::uint64_t a, std::uint64_t b)
{
#if defined(__SIZEOF_INT128__)
  __extension__ using Wide = unsigned __int128;
  return std::uint64_t(Wide(a) * b >> 64);
#elif defined(_MSC_VER) && (defined(_M_X64) || defined(_M_ARM64))
  return __umulh(a, b);
#else
  return upper_product_by_halves(a, b);
#endif
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_UPPER_PRODUCT_H
