// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Unevaluated sums of two doubles (about 106 bits) with a bound on their error.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_BOUNDED_DOUBLE_DOUBLE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_BOUNDED_DOUBLE_DOUBLE_H

#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Double_double.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <boost/config.hpp>

#include <cmath>
#include <limits>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// A real number known to lie within error() of hi + lo. The bound is a running error
// analysis in the style of Wilkinson: each operation adds its own rounding error, at most
// 2^-100 of the result (that is generous: the algorithms used are good to 2^-103), or
// nothing where the operation is seen to be exact, so that an exact zero can be proven
// for numbers with few bits. The bounds themselves are rounded; the generosity covers it.
// Needs round-to-nearest, and values between 1e-140 and 1e140: below, the errors of
// underflow exceed the bound, which `tiny` covers.
class Bounded_double_double
{
public:
  using Part = Double_double; // what there is without the bound
  static constexpr double unit = 0x1p-100;

  Bounded_double_double(double x = 0) : hi_(x) {}
  Bounded_double_double(double hi, double lo, double error) : hi_(hi), lo_(lo), error_(error) {}
  Bounded_double_double(const Part& x, double error) : hi_(x.hi), lo_(x.lo), error_(error) {}

  static Bounded_double_double difference(double a, double b)
  {
    Bounded_double_double r;
    two_sum(a, -b, r.hi_, r.lo_);
    return r;
  }

  double hi() const { return hi_; }
  double lo() const { return lo_; }
  double error() const { return error_; }
  Part part() const { return {hi_, lo_}; }

  friend Bounded_double_double operator-(const Bounded_double_double& a)
  {
    return {-a.hi_, -a.lo_, a.error_};
  }

  BOOST_FORCEINLINE friend Bounded_double_double operator+(const Bounded_double_double& a,
                                                           const Bounded_double_double& b)
  {
    double s, e, t, f, hi, lo;
    two_sum(a.hi_, b.hi_, s, e);
    two_sum(a.lo_, b.lo_, t, f);
    double c, dropped, rest;
    two_sum(e, t, c, dropped);
    fast_two_sum(s, c, hi, lo);
    two_sum(lo, f, c, rest);
    fast_two_sum(hi, c, hi, lo);
    double error = a.error_ + b.error_;
    if (dropped != 0 || rest != 0)
      error += unit * std::abs(hi);
    return {hi, lo, error};
  }

  BOOST_FORCEINLINE friend Bounded_double_double operator-(const Bounded_double_double& a,
                                                           const Bounded_double_double& b)
  {
    return a + -b;
  }

  BOOST_FORCEINLINE friend Bounded_double_double operator*(const Bounded_double_double& a,
                                                           const Bounded_double_double& b)
  {
    if (a.is_zero() || b.is_zero())
      return {};
    double p, e, hi, lo;
    two_product(a.hi_, b.hi_, p, e);
    const bool is_exact = a.lo_ == 0 && b.lo_ == 0;
    if (!is_exact)
      e += a.hi_ * b.lo_ + a.lo_ * b.hi_;
    fast_two_sum(p, e, hi, lo);
    const double magnitude_a = std::abs(a.hi_) * slightly_more,
                 magnitude_b = std::abs(b.hi_) * slightly_more;
    double error = magnitude_a * b.error_ + (magnitude_b + b.error_) * a.error_;
    if (!is_exact)
      error += unit * std::abs(hi) + tiny;
    else if (hi != 0)
      error += underflow_error(hi);
    else
      error += tiny;
    return {hi, lo, error};
  }

  // Where the divisor may be zero, the error becomes infinite.
  friend Bounded_double_double operator/(const Bounded_double_double& a,
                                         const Bounded_double_double& b)
  {
    if (!(std::abs(b.hi_) > 2 * b.error_))
      return {0, 0, std::numeric_limits<double>::infinity()};
    const double q = a.hi_ / b.hi_;
    const Bounded_double_double without_error_b(b.hi_, b.lo_, 0);
    const Bounded_double_double r =
      Bounded_double_double(a.hi_, a.lo_, 0) - without_error_b * Bounded_double_double(q);
    double hi, lo;
    fast_two_sum(q, r.hi_ / b.hi_, hi, lo);
    // |a/b - a'/b'| <= (|a - a'| + |a'/b'| |b - b'|) / |b|
    const double error = (a.error_ + r.error_ + std::abs(q) * slightly_more * b.error_) * 2 /
                           std::abs(b.hi_) +
                         unit * std::abs(hi) + tiny;
    return {hi, lo, error};
  }

  // A negative part of the argument is an error of the argument, not of the root.
  friend Bounded_double_double sqrt(const Bounded_double_double& a)
  {
    if (a.is_zero())
      return {};
    if (!(a.hi_ > 2 * a.error_))
      return {0, 0, std::sqrt(3 * a.error_ + (a.hi_ > 0 ? a.hi_ : 0)) * slightly_more + tiny};
    const double root = std::sqrt(a.hi_);
    const Bounded_double_double r(root);
    const Bounded_double_double rest = Bounded_double_double(a.hi_, a.lo_, 0) - r * r;
    double hi, lo;
    fast_two_sum(root, rest.hi_ / (2 * root), hi, lo);
    return {hi, lo, a.error_ / root * slightly_more + unit * hi + tiny};
  }

  // Multiplication by a power of two: exact.
  Bounded_double_double scaled(double power_of_two) const
  {
    return {hi_ * power_of_two, lo_ * power_of_two, error_ * power_of_two};
  }

  // Whether the number is known to be zero.
  bool is_zero() const { return hi_ == 0 && lo_ == 0 && error_ == 0; }

  // The sign, if the error leaves one.
  Uncertain<Sign> sign() const
  {
    if (hi_ > error_ * slightly_more && hi_ > 0)
      return POSITIVE;
    if (hi_ < -error_ * slightly_more && hi_ < 0)
      return NEGATIVE;
    if (is_zero())
      return ZERO;
    return Uncertain<Sign>::indeterminate();
  }

  // The error relative to the value.
  double relative_error() const { return error_ == 0 ? 0 : error_ / std::abs(hi_); }

private:
  static constexpr double slightly_more = 1 + 0x1p-30;
  static constexpr double tiny = 1e-300;

  // two_product is exact unless its low part underflows.
  static double underflow_error(double hi) { return std::abs(hi) > 1e-280 ? 0 : tiny; }

  double hi_ = 0;
  double lo_ = 0;
  double error_ = 0;
};

// Whether the number gives the same double in whatever order it was computed: it is accurate, and not halfway between two doubles.
inline bool is_rounded_alike(const Bounded_double_double& a)
{
  const double margin = 0x1p-75 * std::abs(a.hi());
  return a.relative_error() < 0x1p-80 && a.hi() + (a.lo() + margin) == a.hi() && a.hi() + (a.lo() - margin) == a.hi();
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_BOUNDED_DOUBLE_DOUBLE_H
