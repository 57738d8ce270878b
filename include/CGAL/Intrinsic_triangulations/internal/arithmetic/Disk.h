// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Complex numbers in double-double arithmetic, or in doubles, with one error radius.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_DISK_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_DISK_H

#include <CGAL/Intrinsic_triangulations/internal/arithmetic/With_error.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/rounded_sqrt.h>

#include <cmath>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// A complex number known to lie within a disk. A strip of a thousand triangles is a product
// of a thousand corner ratios: with a radius, relative errors add up; with a bound for each
// coordinate they would grow by up to √2 with each factor, since a square that is turned
// does not fit into a square.
//
// \tparam Number `Bounded_double_double` or `Double_with_bound`: the coordinates are its parts without the bound
template <class Number>
class Disk
{
  using Part = typename Number::Part;

public:
  using Real = Number;

  Disk() = default;
  Disk(const Real& x, const Real& y)
    : x_(x.part()), y_(y.part()),
      radius_(x.error() + y.error() == 0
                ? 0
                : rounded_sqrt(x.error() * x.error() + y.error() * y.error()) * slightly_more + underflow)
  {}
  Disk(const Part& x, const Part& y, double radius) : x_(x), y_(y), radius_(radius) {}

  double radius() const { return radius_; }
  // An upper bound. Where squares underflow it is far too large, which is safe.
  double modulus() const
  {
    const double x = high(x_), y = high(y_);
    return rounded_sqrt(x * x + y * y) * slightly_more + underflow;
  }

  Real x() const { return Real(x_, radius_); }
  Real y() const { return Real(y_, radius_); }

  friend Disk operator+(const Disk& a, const Disk& b)
  {
    Disk r;
    r.x_ = a.x_ + b.x_;
    r.y_ = a.y_ + b.y_;
    r.radius_ = (a.radius_ + b.radius_) * slightly_more + unit * r.modulus() + tiny;
    return r;
  }
  friend Disk operator-(const Disk& a, const Disk& b)
  {
    Disk minus_b(b);
    minus_b.x_ = -b.x_;
    minus_b.y_ = -b.y_;
    return a + minus_b;
  }
  friend Disk operator*(const Disk& a, const Disk& b)
  {
    Disk r;
    r.x_ = a.x_ * b.x_ - a.y_ * b.y_;
    r.y_ = a.x_ * b.y_ + a.y_ * b.x_;
    r.set_radius_of_product(a, b);
    return r;
  }
  friend Disk times_conjugate(const Disk& a, const Disk& b)
  {
    Disk r;
    r.x_ = a.x_ * b.x_ + a.y_ * b.y_;
    r.y_ = a.y_ * b.x_ - a.x_ * b.y_;
    r.set_radius_of_product(a, b);
    return r;
  }
  friend Real squared_norm(const Disk& a)
  {
    const double m = a.modulus();
    return Real(a.x_ * a.x_ + a.y_ * a.y_, ((2 * m + a.radius_) * a.radius_ + unit * m * m) * slightly_more + tiny);
  }

private:
  // A sum of two products is good to a quarter of this times the sum of their absolute values.
  static constexpr double unit = Real::unit;
  static constexpr double slightly_more = 1 + 0x1p-45;
  static constexpr double tiny = 1e-300;
  static constexpr double underflow = 1e-150; // more than the root of what squares that underflow have lost

  void set_radius_of_product(const Disk& a, const Disk& b)
  {
    const double m = a.modulus(), n = b.modulus();
    radius_ = (m * b.radius_ + (n + b.radius_) * a.radius_ + unit * m * n) * slightly_more + tiny;
  }

  Part x_{}, y_{};
  double radius_ = 0;
};

using Double_double_disk = Disk<Bounded_double_double>;
using Double_disk = Disk<Double_with_bound>;

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_DISK_H
