// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// What CGAL has to know about the floating-point numbers of Boost.Multiprecision.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_BOOST_MULTIPRECISION_FLOATS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_BOOST_MULTIPRECISION_FLOATS_H

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Real_embeddable_traits.h>
#include <CGAL/boost_mp.h>
#include <CGAL/functional.h>
#include <CGAL/tags.h>

#include <boost/math/special_functions/fpclassify.hpp>
#include <boost/mpl/int.hpp>
#include <boost/multiprecision/number.hpp>

#include <type_traits>

namespace CGAL {

// CGAL 5.5 declares these templates for all numbers of Boost.Multiprecision, with and without
// expression templates, and defines them for integers and rationals.
/// \cond SKIP_IN_MANUAL

template <class NT>
struct AST_boost_mp<NT, boost::mpl::int_<boost::multiprecision::number_kind_floating_point>>
  : Algebraic_structure_traits_base<NT, Field_with_sqrt_tag>
{
  using Type = NT;
  using Is_exact = Tag_false;
  using Is_numerical_sensitive = Tag_true;

  struct Is_zero : CGAL::cpp98::unary_function<Type, bool>
  {
    bool operator()(const Type& x) const { return x.is_zero(); }
  };
  struct Sqrt : CGAL::cpp98::unary_function<Type, Type>
  {
    Type operator()(const Type& x) const { return boost::multiprecision::sqrt(x); }
  };
};

template <class NT>
struct RET_boost_mp<NT, boost::mpl::int_<boost::multiprecision::number_kind_floating_point>> : RET_boost_mp_base<NT>
{
  using Type = NT;

  struct Is_finite : CGAL::cpp98::unary_function<Type, bool>
  {
    bool operator()(const Type& x) const { return (boost::math::isfinite)(x); }
  };
};

namespace Intrinsic_triangulations::internal {

template <class FT, class>
struct Has_roots; // number_kinds.h

// For some kinds of numbers CGAL only declares such templates. A comparison of Boost's intervals has no third answer.
template <class FT>
struct Has_roots<FT, std::enable_if_t<boost::multiprecision::is_number<FT>::value>>
  : std::integral_constant<bool, boost::multiprecision::number_category<FT>::value ==
                                     boost::multiprecision::number_kind_floating_point &&
                                   !boost::multiprecision::is_interval_number<FT>::value>
{};

} // namespace Intrinsic_triangulations::internal

/// \endcond
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_BOOST_MULTIPRECISION_FLOATS_H
