// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Refuses a number type that cannot serve, in one sentence.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_NUMBER_TYPE_WITH_ROOTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_NUMBER_TYPE_WITH_ROOTS_H

#include <CGAL/Intrinsic_triangulations/internal/arithmetic/boost_multiprecision_floats.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/quadruple_precision.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Real_embeddable_traits.h>
#include <CGAL/number_type_basic.h>

#include <boost/multiprecision/number.hpp>

#include <type_traits>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// Whether CGAL knows real numbers with division and square root in FT.
template <class FT, class = void>
struct Has_roots
  : std::integral_constant<
      bool, std::is_convertible<typename Algebraic_structure_traits<FT>::Algebraic_category, Field_with_sqrt_tag>::value &&
              Real_embeddable_traits<FT>::Is_real_embeddable::value>
{};
// Of some kinds of number CGAL only says that there are such templates. A comparison of Boost's
// intervals has no third answer.
template <class FT>
struct Has_roots<FT, std::enable_if_t<boost::multiprecision::is_number<FT>::value>>
  : std::integral_constant<bool, boost::multiprecision::number_category<FT>::value ==
                                     boost::multiprecision::number_kind_floating_point &&
                                   !boost::multiprecision::is_interval_number<FT>::value>
{};

template <class T>
struct Type
{
  using type = T;
};

// In a function, not in the traits: a class with such an error is no class any more, and whatever uses it
// is one more error.
template <class FT>
auto checked_number_type()
{
  static_assert(Has_roots<FT>::value,
                "the number type of Edge_length_traits and Half_angle_traits must be a field with square root that CGAL knows: "
                "take double, a float of Boost.Multiprecision or the FT of a kernel with square roots, or, for exact "
                "decisions on points with rational coordinates, no traits at all");
  return Type<std::conditional_t<Has_roots<FT>::value, FT, double>>();
}

// FT. After the sentence it is a type that compiles.
template <class FT>
using Number_type_with_roots = typename decltype(checked_number_type<FT>())::type;

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_NUMBER_TYPE_WITH_ROOTS_H
