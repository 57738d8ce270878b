// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// From the number type of a kernel to the number type of the traits.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_NUMBER_CONVERSION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_NUMBER_CONVERSION_H

#include <CGAL/Fraction_traits.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Lazy_exact_nt.h>
#include <CGAL/number_utils.h>

#include <sstream>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

template <class FT>
struct Is_interval : std::false_type
{};
template <bool b>
struct Is_interval<Interval_nt<b>> : std::true_type
{};

template <class T>
const T& without_laziness(const T& x)
{
  return x;
}
template <class ET>
const ET& without_laziness(const Lazy_exact_nt<ET>& x)
{
  return CGAL::exact(x);
}

// Exact where To can hold the value or any value; else to nearest, or an enclosure for
// an interval.
template <class To, class From>
To convert_number(const From& x)
{
  if constexpr (std::is_same<To, From>::value || std::is_floating_point<From>::value)
    return To(x);
  else if constexpr (Is_interval<To>::value)
    return To(CGAL::to_interval(x));
  else if constexpr (std::is_floating_point<To>::value)
    return To(CGAL::to_double(x));
  else {
    const auto& exact = without_laziness(x);
    using Exact = std::decay_t<decltype(exact)>;
    using Fraction = Fraction_traits<Exact>;
    if constexpr (std::is_same<To, Exact>::value)
      return exact;
    else if constexpr (Fraction::Is_fraction::value) {
      typename Fraction::Numerator_type numerator;
      typename Fraction::Denominator_type denominator;
      typename Fraction::Decompose()(exact, numerator, denominator);
      const auto from_integer = [](const auto& integer) {
        std::ostringstream digits;
        digits << integer;
        return To(digits.str().c_str());
      };
      return from_integer(numerator) / from_integer(denominator);
    } else
      return To(exact);
  }
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_NUMBER_CONVERSION_H
