// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Complex numbers in double-double arithmetic with one error radius.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_DOUBLE_DOUBLE_DISK_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_DOUBLE_DOUBLE_DISK_H

#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Bounded_double_double.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Double_double.h>

#include <cmath>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// A complex number known to lie within a disk. A strip of a thousand triangles is a product
// of a thousand corner ratios: with a radius, relative errors add up; with a bound for each
// coordinate they would grow by up to √2 with each factor, since a square that is turned
// does not fit into a square.
class Double_double_disk
{
public:
  using Real = Bounded_double_double;

  Double_double_disk() = default;
  Double_double_disk(const Real& x, const Real& y)
    : x_{x.hi(), x.lo()}, y_{y.hi(), y.lo()},
      radius_(x.error() + y.error() == 0 ? 0 : std::sqrt(x.error() * x.error() + y.error() * y.error()) * slightly_more + underflow)
  {}

  double radius() const { return radius_; }
  // An upper bound. Where squares underflow it is far too large, which is safe.
  double modulus() const
  {
    return std::sqrt(x_.hi * x_.hi + y_.hi * y_.hi) * slightly_more + underflow;
  }

  Real x() const { return Real(x_.hi, x_.lo, radius_); }
  Real y() const { return Real(y_.hi, y_.lo, radius_); }

  friend Double_double_disk operator+(const Double_double_disk& a, const Double_double_disk& b)
  {
    Double_double_disk r;
    r.x_ = a.x_ + b.x_;
    r.y_ = a.y_ + b.y_;
    r.radius_ = (a.radius_ + b.radius_) * slightly_more + unit * r.modulus() + tiny;
    return r;
  }
  friend Double_double_disk operator-(const Double_double_disk& a, const Double_double_disk& b)
  {
    Double_double_disk minus_b(b);
    minus_b.x_ = -b.x_;
    minus_b.y_ = -b.y_;
    return a + minus_b;
  }
  friend Double_double_disk operator*(const Double_double_disk& a, const Double_double_disk& b)
  {
    Double_double_disk r;
    r.x_ = a.x_ * b.x_ - a.y_ * b.y_;
    r.y_ = a.x_ * b.y_ + a.y_ * b.x_;
    r.set_radius_of_product(a, b);
    return r;
  }
  friend Double_double_disk times_conjugate(const Double_double_disk& a,
                                            const Double_double_disk& b)
  {
    Double_double_disk r;
    r.x_ = a.x_ * b.x_ + a.y_ * b.y_;
    r.y_ = a.y_ * b.x_ - a.x_ * b.y_;
    r.set_radius_of_product(a, b);
    return r;
  }
  friend Real squared_norm(const Double_double_disk& a)
  {
    const Double_double s = a.x_ * a.x_ + a.y_ * a.y_;
    const double m = a.modulus();
    return Real(s.hi, s.lo, ((2 * m + a.radius_) * a.radius_ + unit * m * m) * slightly_more + tiny);
  }

private:
  // A sum of two products is good to 2^-102 of the sum of their absolute values.
  static constexpr double unit = 0x1p-100;
  static constexpr double slightly_more = 1 + 0x1p-45;
  static constexpr double tiny = 1e-300;
  static constexpr double underflow = 1e-150; // more than the root of what squares that underflow have lost

  void set_radius_of_product(const Double_double_disk& a, const Double_double_disk& b)
  {
    const double m = a.modulus(), n = b.modulus();
    radius_ =
      (m * b.radius_ + (n + b.radius_) * a.radius_ + unit * m * n) * slightly_more + tiny;
  }

  Double_double x_, y_;
  double radius_ = 0;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_DOUBLE_DOUBLE_DISK_H
