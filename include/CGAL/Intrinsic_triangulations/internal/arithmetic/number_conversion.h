// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// From the number type of a kernel to the number type of the traits.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_NUMBER_CONVERSION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_NUMBER_CONVERSION_H

#include <CGAL/Intrinsic_triangulations/internal/arithmetic/number_kinds.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Fraction_traits.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <cmath>
#include <sstream>
#include <type_traits>

namespace CGAL {

template <typename ET>
class Lazy_exact_nt;

namespace Intrinsic_triangulations::internal {

template <class T>
const T& without_laziness(const T& x)
{
  return x;
}
template <class ET>
const ET& without_laziness(const Lazy_exact_nt<ET>& x)
{
  return exact(x);
}

// Numerator and denominator by their digits, which every exact number type can read.
template <class To, class Fraction>
To convert_fraction(const Fraction& x)
{
  typename Fraction_traits<Fraction>::Numerator_type numerator;
  typename Fraction_traits<Fraction>::Denominator_type denominator;
  typename Fraction_traits<Fraction>::Decompose()(x, numerator, denominator);
  const auto from_integer = [](const auto& integer) {
    std::ostringstream digits;
    digits << integer;
    return To(digits.str().c_str());
  };
  return from_integer(numerator) / from_integer(denominator);
}

// As a sum of doubles, largest first, each of them the remainder of x rounded to nearest: number types of two libraries
// do not know each other, but all know double.
template <class To, class Number>
To convert_in_parts(const Number& x)
{
  double part = CGAL::to_double(x);
  if (!CGAL::is_finite(x))
    return To(part);
  // Parts of very large and small numbers would leave the range of double.
  if (std::abs(part) > 0x1p+900)
    return convert_in_parts<To>(Number(x * Number(0x1p-500))) * To(0x1p+500);
  if (std::abs(part) < 0x1p-500 && x != Number(0))
    return convert_in_parts<To>(Number(x * Number(0x1p+500))) * To(0x1p-500);
  To sum(part);
  Number rest = x - Number(part);
  for (part = CGAL::to_double(rest); part != 0; part = CGAL::to_double(rest)) {
    const To next = sum + To(part);
    if (next == sum)
      break;
    sum = next;
    rest = rest - Number(part);
  }
  return sum;
}

// Exact if To can hold the value; otherwise rounded to one of the two neighboring numbers, or an enclosure for an
// interval.
template <class To, class From>
To convert_number(const From& x)
{
  if constexpr (std::is_same<To, From>::value)
    return x;
  else if constexpr (Is_interval<To>::value)
    return To(CGAL::to_interval(x));
  else if constexpr (is_machine_number<From>)
    return To(x);
  else if constexpr (std::is_same<To, double>::value || std::is_same<To, float>::value)
    return To(CGAL::to_double(x));
  else {
    const auto& exact = without_laziness(x);
    using Exact = std::decay_t<decltype(exact)>;
    if constexpr (std::is_same<To, Exact>::value)
      return exact;
    else if constexpr (Fraction_traits<Exact>::Is_fraction::value &&
                       std::is_convertible<typename Algebraic_structure_traits<To>::Is_exact, Tag_true>::value)
      return convert_fraction<To>(exact);
    else
      return convert_in_parts<To>(exact);
  }
}

} // namespace Intrinsic_triangulations::internal
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_NUMBER_CONVERSION_H
