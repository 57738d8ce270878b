// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Intervals with MPFR end points, rounded outward.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_MPFR_INTERVAL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_MPFR_INTERVAL_H

#include <CGAL/Intrinsic_triangulations/errors.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <gmp.h>
#include <mpfr.h>

#include <algorithm>
#include <tuple>
#include <utility>

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
  explicit Mpfr_interval(mpfr_prec_t precision = MPFR_PREC_MIN)
  {
    mpfr_init2(lower_, precision);
    mpfr_init2(upper_, precision);
    mpfr_set_zero(lower_, 1);
    mpfr_set_zero(upper_, 1);
  }
  Mpfr_interval(mpq_srcptr x, mpfr_prec_t precision) : Mpfr_interval(precision)
  {
    mpfr_set_q(lower_, x, MPFR_RNDD);
    mpfr_set_q(upper_, x, MPFR_RNDU);
  }
  Mpfr_interval(double x, mpfr_prec_t precision) : Mpfr_interval(precision)
  {
    mpfr_set_d(lower_, x, MPFR_RNDD);
    mpfr_set_d(upper_, x, MPFR_RNDU);
  }
  Mpfr_interval(const Mpfr_interval& other) : Mpfr_interval(other.precision())
  {
    mpfr_set(lower_, other.lower_, MPFR_RNDD);
    mpfr_set(upper_, other.upper_, MPFR_RNDU);
  }
  Mpfr_interval(Mpfr_interval&& other) noexcept : lower_{*other.lower_}, upper_{*other.upper_}
  {
    other.lower_->_mpfr_d = nullptr; // it can only be destroyed or assigned to
  }
  Mpfr_interval& operator=(Mpfr_interval other) noexcept
  {
    swap(other);
    return *this;
  }
  ~Mpfr_interval()
  {
    if (lower_->_mpfr_d) {
      mpfr_clear(lower_);
      mpfr_clear(upper_);
    }
  }

  mpfr_prec_t precision() const { return mpfr_get_prec(lower_); }
  double lower_double() const { return mpfr_get_d(lower_, MPFR_RNDD); }
  double upper_double() const { return mpfr_get_d(upper_, MPFR_RNDU); }
  mpfr_srcptr lower() const { return lower_; }
  mpfr_srcptr upper() const { return upper_; }

  friend Mpfr_interval operator-(const Mpfr_interval& a)
  {
    Mpfr_interval r(a.precision());
    mpfr_neg(r.lower_, a.upper_, MPFR_RNDD);
    mpfr_neg(r.upper_, a.lower_, MPFR_RNDU);
    return r;
  }
  friend Mpfr_interval operator+(const Mpfr_interval& a, const Mpfr_interval& b)
  {
    Mpfr_interval r(common_precision(a, b));
    mpfr_add(r.lower_, a.lower_, b.lower_, MPFR_RNDD);
    mpfr_add(r.upper_, a.upper_, b.upper_, MPFR_RNDU);
    return r;
  }
  friend Mpfr_interval operator-(const Mpfr_interval& a, const Mpfr_interval& b)
  {
    Mpfr_interval r(common_precision(a, b));
    mpfr_sub(r.lower_, a.lower_, b.upper_, MPFR_RNDD);
    mpfr_sub(r.upper_, a.upper_, b.lower_, MPFR_RNDU);
    return r;
  }
  friend Mpfr_interval operator*(const Mpfr_interval& a, const Mpfr_interval& b)
  {
    Mpfr_interval r(common_precision(a, b));
    // The signs tell which ends give the extreme products.
    if (a.has_both_signs() && b.has_both_signs()) {
      Mpfr_interval other(r.precision());
      multiply(r.lower_, a.lower_, b.upper_, MPFR_RNDD);
      multiply(other.lower_, a.upper_, b.lower_, MPFR_RNDD);
      multiply(r.upper_, a.lower_, b.lower_, MPFR_RNDU);
      multiply(other.upper_, a.upper_, b.upper_, MPFR_RNDU);
      mpfr_min(r.lower_, r.lower_, other.lower_, MPFR_RNDD);
      mpfr_max(r.upper_, r.upper_, other.upper_, MPFR_RNDU);
      return r;
    }
    const auto& [x, signed_one] = b.has_both_signs() ? std::tie(b, a) : std::tie(a, b);
    const bool is_negative = mpfr_sgn(signed_one.lower_) < 0;
    const mpfr_srcptr low = is_negative ? x.upper_ : x.lower_, high = is_negative ? x.lower_ : x.upper_;
    multiply(r.lower_, low, mpfr_sgn(low) >= 0 ? signed_one.lower_ : signed_one.upper_, MPFR_RNDD);
    multiply(r.upper_, high, mpfr_sgn(high) >= 0 ? signed_one.upper_ : signed_one.lower_, MPFR_RNDU);
    return r;
  }
  friend Mpfr_interval operator/(const Mpfr_interval& a, const Mpfr_interval& b)
  {
    Mpfr_interval inverse(common_precision(a, b));
    if (mpfr_sgn(b.lower_) <= 0 && mpfr_sgn(b.upper_) >= 0) {
      mpfr_set_inf(inverse.lower_, -1);
      mpfr_set_inf(inverse.upper_, 1);
      return inverse;
    }
    mpfr_ui_div(inverse.lower_, 1, b.upper_, MPFR_RNDD);
    mpfr_ui_div(inverse.upper_, 1, b.lower_, MPFR_RNDU);
    return a * inverse;
  }
  // The argument is known to be non-negative.
  friend Mpfr_interval sqrt(const Mpfr_interval& a)
  {
    Mpfr_interval r(a.precision());
    if (mpfr_sgn(a.lower_) > 0)
      mpfr_sqrt(r.lower_, a.lower_, MPFR_RNDD);
    if (mpfr_sgn(a.upper_) > 0)
      mpfr_sqrt(r.upper_, a.upper_, MPFR_RNDU);
    return r;
  }

  // a 2^exponent, without rounding
  friend Mpfr_interval ldexp(Mpfr_interval a, long exponent)
  {
    mpfr_mul_2si(a.lower_, a.lower_, exponent, MPFR_RNDD);
    mpfr_mul_2si(a.upper_, a.upper_, exponent, MPFR_RNDU);
    return a;
  }

  // For types built on this one: sets the interval to [0, upper end of x], ...
  void set_upper(const Mpfr_interval& x)
  {
    mpfr_set_zero(lower_, 1);
    mpfr_set(upper_, x.upper_, MPFR_RNDU);
  }
  // ... to [−upper end, upper end], ...
  void make_symmetric() { mpfr_neg(lower_, upper_, MPFR_RNDD); }
  // ... or to its lower end; returns the part cut off, as [0, width].
  Mpfr_interval collapse_to_lower()
  {
    Mpfr_interval width(precision());
    mpfr_sub(width.upper_, upper_, lower_, MPFR_RNDU);
    mpfr_set(upper_, lower_, MPFR_RNDU);
    return width;
  }

  // NaN, which the centre of a disk becomes if a divisor may be zero, gives no sign.
  Uncertain<Sign> sign() const
  {
    if (mpfr_nan_p(lower_) || mpfr_nan_p(upper_))
      return Uncertain<Sign>::indeterminate();
    const int low = mpfr_sgn(lower_), high = mpfr_sgn(upper_);
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
  bool has_both_signs() const { return mpfr_sgn(lower_) < 0 && mpfr_sgn(upper_) > 0; }
  static mpfr_prec_t common_precision(const Mpfr_interval& a, const Mpfr_interval& b)
  {
    return (std::max)(a.precision(), b.precision());
  }
  void swap(Mpfr_interval& other) noexcept
  {
    mpfr_swap(lower_, other.lower_);
    mpfr_swap(upper_, other.upper_);
  }

  mpfr_t lower_, upper_;
};

// A complex number known to lie within a disk (see Disk for why a disk). The
// centre is a pair of intervals of one point each, so that the rounding of each operation
// shows as their width, which goes into the radius.
class Mpfr_disk
{
public:
  using Real = Mpfr_interval;

  Mpfr_disk(Real x, Real y) : Mpfr_disk(std::move(x), std::move(y), Real(radius_precision)) {}

  Real x() const { return widened(x_); }
  Real y() const { return widened(y_); }

  friend Mpfr_disk operator+(const Mpfr_disk& a, const Mpfr_disk& b)
  {
    return Mpfr_disk(a.x_ + b.x_, a.y_ + b.y_, a.radius_ + b.radius_);
  }
  friend Mpfr_disk operator-(const Mpfr_disk& a, const Mpfr_disk& b)
  {
    return Mpfr_disk(a.x_ - b.x_, a.y_ - b.y_, a.radius_ + b.radius_);
  }
  friend Mpfr_disk operator*(const Mpfr_disk& a, const Mpfr_disk& b)
  {
    return Mpfr_disk(a.x_ * b.x_ - a.y_ * b.y_, a.x_ * b.y_ + a.y_ * b.x_, radius_of_product(a, b));
  }
  friend Mpfr_disk times_conjugate(const Mpfr_disk& a, const Mpfr_disk& b)
  {
    return Mpfr_disk(a.x_ * b.x_ + a.y_ * b.y_, a.y_ * b.x_ - a.x_ * b.y_, radius_of_product(a, b));
  }
  friend Real squared_norm(const Mpfr_disk& a)
  {
    // |a| <= |centre| + radius, and the same from below.
    const Real error = (a.modulus() + a.modulus() + a.radius_) * a.radius_;
    return widened(a.x_ * a.x_ + a.y_ * a.y_, error);
  }

private:
  static constexpr mpfr_prec_t radius_precision = 64;

  Mpfr_disk(Real x, Real y, Real radius) : x_(std::move(x)), y_(std::move(y)), radius_(std::move(radius)) { shrink(); }

  // Nonnegative numbers are kept as intervals, of which only the upper end matters.
  static Real rounded(const Real& x)
  {
    Real r(radius_precision);
    r.set_upper(x);
    return r;
  }

  Real modulus() const { return sqrt(rounded(x_ * x_ + y_ * y_)); }

  static Real radius_of_product(const Mpfr_disk& a, const Mpfr_disk& b)
  {
    return a.modulus() * b.radius_ + (b.modulus() + b.radius_) * a.radius_;
  }

  // Moves the width of the coordinates into the radius.
  void shrink() { radius_ = rounded(radius_ + rounded(x_.collapse_to_lower()) + rounded(y_.collapse_to_lower())); }

  Real widened(const Real& x) const { return widened(x, radius_); }
  static Real widened(const Real& x, const Real& error)
  {
    Real e = rounded(error);
    e.make_symmetric();
    return x + e;
  }

  Real x_, y_, radius_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_MPFR_INTERVAL_H
