// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Complex numbers in multiple precision with one error radius.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_MPFR_DISK_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_MPFR_DISK_H

#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Mpfr_interval.h>

#include <algorithm>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// A complex number known to lie within a disk (see Disk for why a disk). The
// centre is a pair of intervals of one point each, so that the rounding of each operation
// shows as their width, which goes into the radius.
class Mpfr_disk
{
public:
  using Real = Mpfr_interval;

  Mpfr_disk(const Real& x, const Real& y) : x_(x), y_(y), radius_(radius_precision) { shrink(); }

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
    return Mpfr_disk(a.x_ * b.x_ - a.y_ * b.y_, a.x_ * b.y_ + a.y_ * b.x_,
                     radius_of_product(a, b));
  }
  friend Mpfr_disk times_conjugate(const Mpfr_disk& a, const Mpfr_disk& b)
  {
    return Mpfr_disk(a.x_ * b.x_ + a.y_ * b.y_, a.y_ * b.x_ - a.x_ * b.y_,
                     radius_of_product(a, b));
  }
  friend Real squared_norm(const Mpfr_disk& a)
  {
    // |a| <= |centre| + radius, and the same from below.
    const Real error = (a.modulus() + a.modulus() + a.radius_) * a.radius_;
    return widened(a.x_ * a.x_ + a.y_ * a.y_, error);
  }

private:
  static constexpr mpfr_prec_t radius_precision = 64;

  Mpfr_disk(const Real& x, const Real& y, const Real& radius) : x_(x), y_(y), radius_(radius)
  {
    shrink();
  }

  // Non-negative numbers are kept as intervals of which only the upper end matters.
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
  void shrink()
  {
    radius_ = rounded(radius_ + rounded(x_.collapse_to_lower()) + rounded(y_.collapse_to_lower()));
  }

  Real widened(const Real& x) const { return widened(x, radius_); }
  static Real widened(const Real& x, const Real& error)
  {
    Real e = rounded(error);
    e.make_symmetric();
    return x + e;
  }

  Real x_, y_, radius_;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_MPFR_DISK_H
