// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Refuses a number type that cannot serve, in one sentence.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_NUMBER_TYPE_WITH_ROOTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_NUMBER_TYPE_WITH_ROOTS_H

#include <CGAL/Intrinsic_triangulations/internal/arithmetic/number_kinds.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/quadruple_precision.h>

#include <CGAL/number_type_basic.h>

#include <type_traits>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

template <class T>
struct Type
{
  using type = T;
};

// In a function, not in the traits: there the error would leave the class incomplete, and each use would be
// another one.
template <class FT>
auto checked_number_type()
{
  static_assert(
    Has_roots<FT>::value,
    "the number type of Edge_length_traits and Half_angle_traits must be a field with square root that CGAL knows: "
    "take double, a float of Boost.Multiprecision (include its header before those of Intrinsic_triangulations) or the "
    "FT of a kernel with square roots, or, for exact decisions on points with rational coordinates, no traits at all");
  return Type<std::conditional_t<Has_roots<FT>::value, FT, double>>();
}

// FT. After the sentence it is a type that compiles.
template <class FT>
using Number_type_with_roots = typename decltype(checked_number_type<FT>())::type;

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

// Who has included Boost.Multiprecision need not ask for what makes its floats work; others need not parse it.
#if defined(BOOST_MP_NUMBER_HPP) || defined(BOOST_MATH_EXTENDED_REAL_HPP) // since Boost 1.76, and before
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/boost_multiprecision_floats.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_NUMBER_TYPE_WITH_ROOTS_H
