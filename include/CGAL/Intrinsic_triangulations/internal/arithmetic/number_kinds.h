// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// What kind of number a type is: machine number, interval, narrow exponent range, exact with roots.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_NUMBER_KINDS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_NUMBER_KINDS_H

#include <CGAL/Intrinsic_triangulations/internal/arithmetic/quadruple_precision.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Real_embeddable_traits.h>
#include <CGAL/number_type_basic.h>
#include <CGAL/tags.h>

#include <limits>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations::internal {

template <class FT>
struct Is_interval : std::false_type
{};
template <bool b>
struct Is_interval<Interval_nt<b>> : std::true_type
{};

// Not `std::is_floating_point`, which in the GNU dialects is also true for `__float128`.
template <class T>
constexpr bool is_machine_number =
  std::is_same<T, float>::value || std::is_same<T, double>::value || std::is_same<T, long double>::value;

// The number type whose exponent range FT has, or FT itself.
template <class FT>
struct Machine_type
{
  using type = FT;
};
template <bool b>
struct Machine_type<Interval_nt<b>>
{
  using type = double;
};

// Whether products of squared lengths may leave the range of FT although the lengths are doubles. Boost's floats may
// have any range, from that of `float` to one that no double leaves.
template <class FT>
constexpr bool
  has_small_exponent_range = is_machine_number<typename Machine_type<FT>::type> ||
                             (std::numeric_limits<FT>::is_specialized && !std::numeric_limits<FT>::is_exact &&
                              std::numeric_limits<FT>::max_exponent / 10 < std::numeric_limits<double>::max_exponent);

// Roots of numbers beyond 2^150 come out of CORE with few correct digits, and beyond 2^160 it ends the process with a
// division by zero. Small numbers are harmless down to 2^-1075, below which they become zero as `double`.
template <class FT>
constexpr bool has_exact_roots =
  std::is_convertible<typename Algebraic_structure_traits<FT>::Is_exact, Tag_true>::value&&
    std::is_convertible<typename Algebraic_structure_traits<FT>::Algebraic_category, Field_with_sqrt_tag>::value;

// Whether FT is known to CGAL as a type of real numbers with division and square root.
template <class FT, class = void>
struct Has_roots
  : std::integral_constant<bool, std::is_convertible<typename Algebraic_structure_traits<FT>::Algebraic_category,
                                                     Field_with_sqrt_tag>::value &&
                                   Real_embeddable_traits<FT>::Is_real_embeddable::value>
{};

template <class T>
struct Type
{
  using type = T;
};

// In a function, not in the traits: there the error would leave the class incomplete, and each use would be a further
// error.
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

} // namespace CGAL::Intrinsic_triangulations::internal

#if defined(BOOST_MP_NUMBER_HPP) || defined(BOOST_MATH_EXTENDED_REAL_HPP) // since Boost 1.76, and before
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/boost_multiprecision_floats.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_NUMBER_KINDS_H
