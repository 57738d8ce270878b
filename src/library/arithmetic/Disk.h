// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Complex numbers in double-double arithmetic, or in doubles, with one error radius.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_DISK_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_DISK_H

#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Double_double.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Two_doubles.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/With_error.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/rounded_sqrt.h>

#include <cmath>
#include <limits>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations::internal {

// What `Two_doubles` offers, for two sums of two doubles.
using Two_double_doubles = Basic_double_double<Two_doubles>;
inline Two_double_doubles two(const Double_double& a, const Double_double& b) { return {{a.hi, b.hi}, {a.lo, b.lo}}; }
inline Two_double_doubles firsts(const Two_double_doubles& a, const Two_double_doubles& b)
{
  return {firsts(a.hi, b.hi), firsts(a.lo, b.lo)};
}
inline Two_double_doubles seconds(const Two_double_doubles& a, const Two_double_doubles& b)
{
  return {seconds(a.hi, b.hi), seconds(a.lo, b.lo)};
}
inline Two_double_doubles swapped(const Two_double_doubles& a) { return {swapped(a.hi), swapped(a.lo)}; }
inline Two_double_doubles operator*(Two_doubles signs, const Two_double_doubles& a)
{
  return {signs * a.hi, signs * a.lo};
}
inline Double_double first(const Two_double_doubles& a) { return {a.hi.first(), a.lo.first()}; }
inline Double_double second(const Two_double_doubles& a) { return {a.hi.second(), a.lo.second()}; }
inline double first(Two_doubles a) { return a.first(); }
inline double second(Two_doubles a) { return a.second(); }
inline Two_doubles high(Two_doubles a) { return a; }

// A complex number known to lie within a disk. A strip of a thousand triangles is a product of a thousand corner
// ratios: with a radius, relative errors add up; with a bound for each coordinate they would grow by up to √2 with each
// factor, since a rotated square does not fit into the same square.
//
// \tparam Number `Bounded_double_double` or `Double_with_bound`: the coordinates are its parts without the bound
template <class Number>
class Disk
{
  using Part = typename Number::Part;
  // Both coordinates, on which the processor operates at once.
  using Parts = std::conditional_t<std::is_same<Part, double>::value, Two_doubles, Two_double_doubles>;

public:
  using Real = Number;

  Disk() = default;
  Disk(const Real& x, const Real& y)
    : Disk(x.part(), y.part(),
           x.error() + y.error() == 0
             ? 0
             : rounded_sqrt(x.error() * x.error() + y.error() * y.error()) * slightly_more + underflow)
  {}
  Disk(const Part& x, const Part& y, double radius) : z_(two(x, y)), radius_(radius) {}

  double radius() const { return radius_; }
  // An upper bound. Where squares underflow it is far too large, which is safe.
  double modulus() const
  {
    const Two_doubles squares = high(z_) * high(z_);
    return rounded_sqrt(squares.first() + squares.second()) * slightly_more + underflow;
  }

  Real x() const { return Real(first(z_), radius_); }
  Real y() const { return Real(second(z_), radius_); }

  friend Disk operator+(const Disk& a, const Disk& b)
  {
    Disk r;
    r.z_ = a.z_ + b.z_;
    r.radius_ = (a.radius_ + b.radius_) * slightly_more + unit * r.modulus() + tiny;
    return r;
  }
  friend Disk operator-(const Disk& a, const Disk& b)
  {
    Disk minus_b(b);
    minus_b.z_ = -b.z_;
    return a + minus_b;
  }
  // The difference of the centers, each coordinate rounded once: accurate to a relative 2^-52.99 in double-doubles.
  friend Two_doubles rounded_difference(const Disk& a, const Disk& b) { return high(a.z_ - b.z_); }
  friend Disk operator*(const Disk& a, const Disk& b) { return product(a, b, Two_doubles(-1, 1)); }
  friend Disk times_conjugate(const Disk& a, const Disk& b) { return product(b, a, Two_doubles(1, -1)); }
  // Like the division of real numbers.
  friend Disk operator/(const Disk& a, const Real& b)
  {
    if (!(std::abs(b.hi()) > 2 * b.error()))
      return {Part{}, Part{}, std::numeric_limits<double>::infinity()};
    const Two_doubles divisor(b.hi()), q = high(a.z_) / divisor;
    Disk r;
    fast_two_sum(q, high(a.z_ - Parts{q, 0.} * Parts{divisor, b.lo()}) / divisor, r.z_.hi, r.z_.lo);
    const double m = r.modulus();
    r.radius_ = ((a.radius_ + m * b.error()) * 2 / std::abs(b.hi()) + unit * m) * slightly_more + tiny;
    return r;
  }
  friend Real squared_norm(const Disk& a)
  {
    const double m = a.modulus();
    const Parts squares = a.z_ * a.z_;
    return Real(first(squares) + second(squares),
                ((2 * m + a.radius_) * a.radius_ + unit * m * m) * slightly_more + tiny);
  }

private:
  // A sum of two products has an error of at most a quarter of this times the sum of their absolute values.
  static constexpr double unit = Real::unit;
  static constexpr double slightly_more = 1 + 0x1p-45;
  static constexpr double tiny = 1e-300;
  static constexpr double underflow = 1e-150; // more than the root of the loss when squares underflow

  // The product of b and a, or of b and the conjugate of a.
  static Disk product(const Disk& a, const Disk& b, Two_doubles signs)
  {
    const double m = a.modulus(), n = b.modulus();
    Disk r;
    r.z_ = firsts(a.z_, a.z_) * b.z_ + signs * (seconds(a.z_, a.z_) * swapped(b.z_));
    r.radius_ = (m * b.radius_ + (n + b.radius_) * a.radius_ + unit * m * n) * slightly_more + tiny;
    return r;
  }

  Parts z_{};
  double radius_ = 0;
};

using Double_double_disk = Disk<Bounded_double_double>;
using Double_disk = Disk<Double_with_bound>;

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_DISK_H
