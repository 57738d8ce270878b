// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The exact integers and rationals of the last stages.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_RATIONAL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_RATIONAL_H

#include <boost/multiprecision/gmp.hpp>

namespace CGAL::Intrinsic_triangulations::internal {

// Without expression templates, so that every expression is a number.
using Integer = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;
using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;

inline mpq_srcptr data(const Rational& x) { return x.backend().data(); }
inline mpz_srcptr data(const Integer& x) { return x.backend().data(); }

inline bool is_square(const Rational& x)
{
  const Integer square = boost::multiprecision::numerator(x) * boost::multiprecision::denominator(x);
  return mpz_perfect_square_p(data(square)) != 0;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_RATIONAL_H
