// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Numbers with a bound on their error: doubles, and unevaluated sums of two (about 106 bits).

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_WITH_ERROR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_WITH_ERROR_H

#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Double_double.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/rounded_sqrt.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <boost/config.hpp>

#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations::internal {

// A real number known to lie within error() of part(). The bound is a running error analysis in the style of Wilkinson:
// each operation adds its own rounding error, at most `unit` of the result, or nothing if an operation on
// double-doubles is seen to be exact, so that an exact zero can be proven for numbers with few bits. The unit is
// generous: errors of double-doubles are below 2^-103, and a double errs by a quarter of it. This also covers the
// rounding of the bounds themselves. Needs round-to-nearest, and values between 1e-140 and 1e140: below, the errors of
// underflow exceed the bound, which `tiny` covers.
//
// \tparam Part_ `Double_double`, or `double` for half of the digits in a fraction of the time
template <class Part_>
class With_error
{
  static constexpr bool is_double = std::is_same<Part_, double>::value;

public:
  using Part = Part_; // the number without its bound
  static constexpr double unit = is_double ? 0x1p-51 : 0x1p-100;

  With_error(double x = 0) : part_{x} {}
  With_error(const Part& x, double error) : part_(x), error_(error) {}
  With_error(double hi, double lo, double error) : part_{hi, lo}, error_(error) {}
  template <class Other, class = std::enable_if_t<is_double && std::is_same<Other, Double_double>::value>>
  explicit With_error(const With_error<Other>& x) : part_(x.hi()), error_(1.01 * (std::abs(x.lo()) + x.error()))
  {}

  static With_error difference(double a, double b) { return {Part::difference(a, b), 0}; }

  double hi() const { return high(part_); }
  double lo() const { return part_.lo; }
  double error() const { return error_; }
  const Part& part() const { return part_; }

  friend With_error operator-(const With_error& a) { return {-a.part_, a.error_}; }

  BOOST_FORCEINLINE friend With_error operator+(const With_error& a, const With_error& b)
  {
    if constexpr (is_double) {
      const double sum = a.part_ + b.part_;
      return {sum, a.error_ + b.error_ + unit * std::abs(sum)};
    } else {
      double s, e, t, f, hi, lo;
      two_sum(a.part_.hi, b.part_.hi, s, e);
      two_sum(a.part_.lo, b.part_.lo, t, f);
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
  }

  BOOST_FORCEINLINE friend With_error operator-(const With_error& a, const With_error& b) { return a + -b; }

  BOOST_FORCEINLINE friend With_error operator*(const With_error& a, const With_error& b)
  {
    if constexpr (is_double) {
      const double product = a.part_ * b.part_;
      return {product, std::abs(a.part_) * b.error_ + (std::abs(b.part_) + b.error_) * a.error_ +
                         unit * std::abs(product) + tiny};
    } else {
      if (a.is_zero() || b.is_zero())
        return {};
      double p, e, hi, lo;
      two_product(a.part_.hi, b.part_.hi, p, e);
      const bool is_exact = a.part_.lo == 0 && b.part_.lo == 0;
      if (!is_exact)
        e += a.part_.hi * b.part_.lo + a.part_.lo * b.part_.hi;
      fast_two_sum(p, e, hi, lo);
      const double magnitude_a = std::abs(a.part_.hi) * slightly_more,
                   magnitude_b = std::abs(b.part_.hi) * slightly_more;
      double error = magnitude_a * b.error_ + (magnitude_b + b.error_) * a.error_;
      if (!is_exact)
        error += unit * std::abs(hi) + tiny;
      else if (hi != 0)
        error += underflow_error(hi);
      else
        error += tiny;
      return {hi, lo, error};
    }
  }

  // If the divisor may be zero, the error becomes infinite.
  friend With_error operator/(const With_error& a, const With_error& b)
  {
    if (!(std::abs(b.hi()) > 2 * b.error_))
      return {Part{}, std::numeric_limits<double>::infinity()};
    // |a/b - a'/b'| <= (|a - a'| + |a'/b'| |b - b'|) / |b|
    const double q = a.hi() / b.hi();
    if constexpr (is_double)
      return {q, (a.error_ + std::abs(q) * b.error_) * 2 / std::abs(b.part_) + unit * std::abs(q) + tiny};
    else {
      const With_error r = With_error(a.part_, 0) - With_error(b.part_, 0) * With_error(q);
      double hi, lo;
      fast_two_sum(q, r.hi() / b.hi(), hi, lo);
      const double error = (a.error_ + r.error_ + std::abs(q) * slightly_more * b.error_) * 2 / std::abs(b.hi()) +
                           unit * std::abs(hi) + tiny;
      return {hi, lo, error};
    }
  }

  // A negative part of the argument is an error of the argument, not of the root.
  friend With_error sqrt(const With_error& a)
  {
    if (a.is_zero())
      return {};
    if (!(a.hi() > 2 * a.error_))
      return {Part{}, rounded_sqrt(3 * a.error_ + (a.hi() > 0 ? a.hi() : 0)) * slightly_more + tiny};
    const double root = rounded_sqrt(a.hi());
    const With_error r(root);
    const With_error rest = With_error(a.part_, 0) - r * r;
    double hi, lo;
    fast_two_sum(root, rest.hi() / (2 * root), hi, lo);
    return {hi, lo, a.error_ / root * slightly_more + unit * hi + tiny};
  }

  // Multiplication by a power of two: exact.
  With_error scaled(double power_of_two) const
  {
    if constexpr (is_double)
      return {part_ * power_of_two, error_ * power_of_two};
    else
      return {part_.hi * power_of_two, part_.lo * power_of_two, error_ * power_of_two};
  }

  // Whether the number is known to be zero.
  bool is_zero() const
  {
    if constexpr (!is_double)
      if (part_.lo != 0)
        return false;
    return hi() == 0 && error_ == 0;
  }

  // The sign, if the error leaves one.
  Uncertain<Sign> sign() const
  {
    if (is_zero())
      return ZERO;
    if (!(std::abs(hi()) > error_ * slightly_more))
      return Uncertain<Sign>::indeterminate();
    return hi() > 0 ? POSITIVE : NEGATIVE;
  }

  // The error relative to the value.
  double relative_error() const { return error_ == 0 ? 0 : error_ / std::abs(hi()); }

private:
  static constexpr double slightly_more = 1 + 0x1p-30;
  static constexpr double tiny = 1e-300; // covers underflow

  // two_product is exact unless its low part underflows.
  static double underflow_error(double hi) { return std::abs(hi) > 1e-280 ? 0 : tiny; }

  Part part_;
  double error_ = 0;
};

using Bounded_double_double = With_error<Double_double>;
using Double_with_bound = With_error<double>;

// The double to which a number rounds, if the bound leaves only one; it does not depend on the order of computation.
// Halfway between two doubles, where numbers with few bits often lie, it is the one farther from zero.
inline std::optional<double> rounded(const Bounded_double_double& a)
{
  const double lo = a.lo() + 0x1p-75 * a.hi(), error = a.error() + 0x1p-104 * std::abs(a.hi());
  const double low = a.hi() + (lo - error), high = a.hi() + (lo + error);
  if (low != high)
    return std::nullopt;
  return low;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_WITH_ERROR_H
