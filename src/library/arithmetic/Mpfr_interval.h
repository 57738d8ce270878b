// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Intervals with MPFR end points, rounded outward.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_MPFR_INTERVAL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_MPFR_INTERVAL_H

#include "Mpfr_pair.h"

#include <CGAL/Intrinsic_triangulations/errors.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <gmp.h>
#include <mpfr.h>

#include <algorithm>
#include <tuple>

namespace CGAL::Intrinsic_triangulations::internal {

// The precision of the next attempt, after this one did not settle a question that enough digits will settle. No known
// input needs a thousandth of the maximum.
inline long doubled(long precision)
{
  if (precision >= (1l << 22))
    throw Arithmetic_error(
      "four million bits do not settle what they must: please report the surface, and how the program was compiled");
  return 2 * precision;
}

// A real number known to lie in [lower, upper]. A result has the larger precision of its
// operands. A division by an interval that contains zero gives the whole line.
class Mpfr_interval
{
public:
  explicit Mpfr_interval(mpfr_prec_t precision = MPFR_PREC_MIN) : ends_(precision) {}
  explicit Mpfr_interval(mpfr_srcptr x) : Mpfr_interval(mpfr_get_prec(x))
  {
    mpfr_set(ends_.first, x, MPFR_RNDD);
    mpfr_set(ends_.second, x, MPFR_RNDU);
  }
  Mpfr_interval(mpq_srcptr x, mpfr_prec_t precision) : Mpfr_interval(precision)
  {
    mpfr_set_q(ends_.first, x, MPFR_RNDD);
    mpfr_set_q(ends_.second, x, MPFR_RNDU);
  }
  Mpfr_interval(double x, mpfr_prec_t precision) : Mpfr_interval(precision)
  {
    mpfr_set_d(ends_.first, x, MPFR_RNDD);
    mpfr_set_d(ends_.second, x, MPFR_RNDU);
  }
  // [-x 2^exponent, x 2^exponent]
  static Mpfr_interval symmetric(double x, long exponent)
  {
    Mpfr_interval r(53);
    mpfr_set_d(r.ends_.second, x, MPFR_RNDU);
    mpfr_mul_2si(r.ends_.second, r.ends_.second, exponent, MPFR_RNDU);
    mpfr_neg(r.ends_.first, r.ends_.second, MPFR_RNDD);
    return r;
  }

  mpfr_prec_t precision() const { return ends_.precision(); }
  double lower_double() const { return mpfr_get_d(ends_.first, MPFR_RNDD); }
  double upper_double() const { return mpfr_get_d(ends_.second, MPFR_RNDU); }
  mpfr_srcptr lower() const { return ends_.first; }
  mpfr_srcptr upper() const { return ends_.second; }

  friend Mpfr_interval operator-(const Mpfr_interval& a)
  {
    Mpfr_interval r(a.precision());
    mpfr_neg(r.ends_.first, a.ends_.second, MPFR_RNDD);
    mpfr_neg(r.ends_.second, a.ends_.first, MPFR_RNDU);
    return r;
  }
  friend Mpfr_interval operator+(const Mpfr_interval& a, const Mpfr_interval& b)
  {
    Mpfr_interval r(common_precision(a, b));
    mpfr_add(r.ends_.first, a.ends_.first, b.ends_.first, MPFR_RNDD);
    mpfr_add(r.ends_.second, a.ends_.second, b.ends_.second, MPFR_RNDU);
    return r;
  }
  friend Mpfr_interval operator-(const Mpfr_interval& a, const Mpfr_interval& b)
  {
    Mpfr_interval r(common_precision(a, b));
    mpfr_sub(r.ends_.first, a.ends_.first, b.ends_.second, MPFR_RNDD);
    mpfr_sub(r.ends_.second, a.ends_.second, b.ends_.first, MPFR_RNDU);
    return r;
  }
  friend Mpfr_interval operator*(const Mpfr_interval& a, const Mpfr_interval& b)
  {
    Mpfr_interval r(common_precision(a, b));
    // The signs tell which ends give the extreme products.
    if (a.has_both_signs() && b.has_both_signs()) {
      Mpfr_interval other(r.precision());
      multiply(r.ends_.first, a.ends_.first, b.ends_.second, MPFR_RNDD);
      multiply(other.ends_.first, a.ends_.second, b.ends_.first, MPFR_RNDD);
      multiply(r.ends_.second, a.ends_.first, b.ends_.first, MPFR_RNDU);
      multiply(other.ends_.second, a.ends_.second, b.ends_.second, MPFR_RNDU);
      mpfr_min(r.ends_.first, r.ends_.first, other.ends_.first, MPFR_RNDD);
      mpfr_max(r.ends_.second, r.ends_.second, other.ends_.second, MPFR_RNDU);
      return r;
    }
    const auto& [x, signed_one] = b.has_both_signs() ? std::tie(b, a) : std::tie(a, b);
    const bool is_negative = mpfr_sgn(signed_one.ends_.first) < 0;
    const mpfr_srcptr low = is_negative ? x.ends_.second : x.ends_.first,
                      high = is_negative ? x.ends_.first : x.ends_.second;
    multiply(r.ends_.first, low, mpfr_sgn(low) >= 0 ? signed_one.ends_.first : signed_one.ends_.second, MPFR_RNDD);
    multiply(r.ends_.second, high, mpfr_sgn(high) >= 0 ? signed_one.ends_.second : signed_one.ends_.first, MPFR_RNDU);
    return r;
  }
  friend Mpfr_interval operator/(const Mpfr_interval& a, const Mpfr_interval& b)
  {
    Mpfr_interval inverse(common_precision(a, b));
    if (mpfr_sgn(b.ends_.first) <= 0 && mpfr_sgn(b.ends_.second) >= 0) {
      mpfr_set_inf(inverse.ends_.first, -1);
      mpfr_set_inf(inverse.ends_.second, 1);
      return inverse;
    }
    mpfr_ui_div(inverse.ends_.first, 1, b.ends_.second, MPFR_RNDD);
    mpfr_ui_div(inverse.ends_.second, 1, b.ends_.first, MPFR_RNDU);
    return a * inverse;
  }
  // The argument is known to be non-negative.
  friend Mpfr_interval sqrt(const Mpfr_interval& a)
  {
    Mpfr_interval r(a.precision());
    if (mpfr_sgn(a.ends_.first) > 0)
      mpfr_sqrt(r.ends_.first, a.ends_.first, MPFR_RNDD);
    if (mpfr_sgn(a.ends_.second) > 0)
      mpfr_sqrt(r.ends_.second, a.ends_.second, MPFR_RNDU);
    return r;
  }

  // a 2^exponent, without rounding
  friend Mpfr_interval ldexp(Mpfr_interval a, long exponent)
  {
    mpfr_mul_2si(a.ends_.first, a.ends_.first, exponent, MPFR_RNDD);
    mpfr_mul_2si(a.ends_.second, a.ends_.second, exponent, MPFR_RNDU);
    return a;
  }

  // From zero to the width of the interval.
  Mpfr_interval width() const
  {
    Mpfr_interval r(precision());
    mpfr_sub(r.ends_.second, ends_.second, ends_.first, MPFR_RNDU);
    return r;
  }

  // NaN, which the centre of a disk becomes if a divisor may be zero, gives no sign.
  Uncertain<Sign> sign() const
  {
    if (mpfr_nan_p(ends_.first) || mpfr_nan_p(ends_.second))
      return Uncertain<Sign>::indeterminate();
    const int low = mpfr_sgn(ends_.first), high = mpfr_sgn(ends_.second);
    if (low > 0)
      return POSITIVE;
    if (high < 0)
      return NEGATIVE;
    if (low == 0 && high == 0)
      return ZERO;
    return Uncertain<Sign>::indeterminate();
  }

private:
  // The end of a product. An infinite end stands for finite numbers, so times zero it is zero.
  static void multiply(mpfr_ptr result, mpfr_srcptr x, mpfr_srcptr y, mpfr_rnd_t rounding)
  {
    if (mpfr_zero_p(x) || mpfr_zero_p(y))
      mpfr_set_zero(result, 1);
    else
      mpfr_mul(result, x, y, rounding);
  }
  bool has_both_signs() const { return mpfr_sgn(ends_.first) < 0 && mpfr_sgn(ends_.second) > 0; }
  static mpfr_prec_t common_precision(const Mpfr_interval& a, const Mpfr_interval& b)
  {
    return (std::max)(a.precision(), b.precision());
  }

  Mpfr_pair ends_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_MPFR_INTERVAL_H
