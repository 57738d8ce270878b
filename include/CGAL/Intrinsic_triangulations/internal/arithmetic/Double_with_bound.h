// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Doubles with a bound on their error.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_DOUBLE_WITH_BOUND_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_DOUBLE_WITH_BOUND_H

#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Bounded_double_double.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <cmath>
#include <limits>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// As Bounded_double_double in all respects, with one double in place of two, in a fraction of its time: for numbers of which
// half of the digits are asked for. Each operation adds 2^-51 of its result to the bound. It errs by a quarter of that,
// and the generosity covers the rounding of the bounds.
class Double_with_bound
{
public:
  using Part = double;
  static constexpr double unit = 0x1p-51;

  Double_with_bound(double x = 0, double error = 0) : value_(x), error_(error) {}
  explicit Double_with_bound(const Bounded_double_double& x)
    : value_(x.hi()), error_(2 * (std::abs(x.lo()) + x.error()))
  {}

  double hi() const { return value_; }
  double error() const { return error_; }
  double part() const { return value_; }

  friend Double_with_bound operator-(const Double_with_bound& a) { return {-a.value_, a.error_}; }
  friend Double_with_bound operator+(const Double_with_bound& a, const Double_with_bound& b)
  {
    const double sum = a.value_ + b.value_;
    return {sum, a.error_ + b.error_ + unit * std::abs(sum)};
  }
  friend Double_with_bound operator-(const Double_with_bound& a, const Double_with_bound& b) { return a + -b; }
  friend Double_with_bound operator*(const Double_with_bound& a, const Double_with_bound& b)
  {
    const double product = a.value_ * b.value_;
    return {product, std::abs(a.value_) * b.error_ + (std::abs(b.value_) + b.error_) * a.error_ + unit * std::abs(product) + tiny};
  }
  // Where the divisor may be zero, the error becomes infinite.
  friend Double_with_bound operator/(const Double_with_bound& a, const Double_with_bound& b)
  {
    if (!(std::abs(b.value_) > 2 * b.error_))
      return {0, std::numeric_limits<double>::infinity()};
    const double quotient = a.value_ / b.value_;
    // |a/b - a'/b'| <= (|a - a'| + |a'/b'| |b - b'|) / |b|
    return {quotient, (a.error_ + std::abs(quotient) * b.error_) * 2 / std::abs(b.value_) + unit * std::abs(quotient) + tiny};
  }

  // Multiplication by a power of two: exact.
  Double_with_bound scaled(double power_of_two) const { return {value_ * power_of_two, error_ * power_of_two}; }

  // Whether the number is known to be zero.
  bool is_zero() const { return value_ == 0 && error_ == 0; }

  // The sign, if the error leaves one.
  Uncertain<Sign> sign() const
  {
    if (is_zero())
      return ZERO;
    if (!(std::abs(value_) > error_ * slightly_more))
      return Uncertain<Sign>::indeterminate();
    return value_ > 0 ? POSITIVE : NEGATIVE;
  }

private:
  static constexpr double slightly_more = 1 + 0x1p-30;
  static constexpr double tiny = 1e-300; // covers underflow

  double value_, error_;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_DOUBLE_WITH_BOUND_H
