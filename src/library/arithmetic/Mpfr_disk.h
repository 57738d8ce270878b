// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Complex numbers of MPFR with one error radius.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_MPFR_DISK_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_MPFR_DISK_H

#include "Mpfr_interval.h"
#include "Mpfr_pair.h"

#include <algorithm>
#include <cmath>

namespace CGAL::Intrinsic_triangulations::internal {

// A number that is not negative, rounded up by each operation, with an exponent of any size. Infinite or NaN if nothing
// is known.
class Rounded_up
{
public:
  Rounded_up() = default;
  // 2^(exponent - 1)
  static Rounded_up half_of_power(long exponent) { return {0.5, exponent}; }
  static Rounded_up size(mpfr_srcptr x)
  {
    long exponent = 0;
    const double mantissa = mpfr_get_d_2exp(&exponent, x, MPFR_RNDA);
    return normalized(std::abs(mantissa), exponent);
  }
  static Rounded_up modulus(mpfr_srcptr x, mpfr_srcptr y)
  {
    const auto [a, b, exponent] = aligned(size(x), size(y));
    return normalized(std::sqrt(a * a + b * b) * slightly_more, exponent);
  }

  friend Rounded_up operator+(const Rounded_up& x, const Rounded_up& y)
  {
    const auto [a, b, exponent] = aligned(x, y);
    return normalized((a + b) * slightly_more, exponent);
  }
  friend Rounded_up operator*(const Rounded_up& x, const Rounded_up& y)
  {
    return normalized(x.mantissa_ * y.mantissa_ * slightly_more, x.exponent_ + y.exponent_);
  }

  // x with this as the error
  Mpfr_interval around(const Mpfr_interval& x) const
  {
    return std::isfinite(mantissa_) ? x + Mpfr_interval::symmetric(mantissa_, exponent_)
                                    : Mpfr_interval::symmetric(HUGE_VAL, 0);
  }

private:
  static constexpr double slightly_more = 1 + 0x1p-45;

  struct Aligned
  {
    double a, b;
    long exponent;
  };

  Rounded_up(double mantissa, long exponent) : mantissa_(mantissa), exponent_(exponent) {}
  static Rounded_up normalized(double x, long exponent)
  {
    if (x == 0 || !std::isfinite(x))
      return {x, 0};
    int shift = 0;
    const double mantissa = std::frexp(x, &shift);
    return {mantissa, exponent + shift};
  }
  // With the larger exponent. A much smaller number becomes larger.
  static Aligned aligned(const Rounded_up& x, const Rounded_up& y)
  {
    if (x.mantissa_ == 0 || y.mantissa_ == 0)
      return {x.mantissa_, y.mantissa_, x.mantissa_ == 0 ? y.exponent_ : x.exponent_};
    const long exponent = (std::max)(x.exponent_, y.exponent_);
    const auto part = [&](const Rounded_up& z) {
      return std::ldexp(z.mantissa_, int((std::max)(z.exponent_ - exponent, -100l)));
    };
    return {part(x), part(y), exponent};
  }

  double mantissa_ = 0; // zero or at least 1/2
  long exponent_ = 0;
};

// A complex number known to lie within a disk (see Disk for why a disk). The centre is rounded to nearest, and half a
// unit in the last place of each coordinate goes into the radius.
class Mpfr_disk
{
public:
  using Real = Mpfr_interval;

  Mpfr_disk(const Real& x, const Real& y)
    : centre_((std::max)(x.precision(), y.precision())),
      radius_(Rounded_up::size(x.width().upper()) + Rounded_up::size(y.width().upper()))
  {
    mpfr_set(centre_.first, x.lower(), MPFR_RNDN);
    mpfr_set(centre_.second, y.lower(), MPFR_RNDN);
  }

  Real x() const { return radius_.around(Real(centre_.first)); }
  Real y() const { return radius_.around(Real(centre_.second)); }

  friend Mpfr_disk operator+(const Mpfr_disk& a, const Mpfr_disk& b)
  {
    Mpfr_disk r(a, b, a.radius_ + b.radius_);
    mpfr_add(r.centre_.first, a.centre_.first, b.centre_.first, MPFR_RNDN);
    mpfr_add(r.centre_.second, a.centre_.second, b.centre_.second, MPFR_RNDN);
    return r.add_rounding(), r;
  }
  friend Mpfr_disk operator-(const Mpfr_disk& a, const Mpfr_disk& b)
  {
    Mpfr_disk r(a, b, a.radius_ + b.radius_);
    mpfr_sub(r.centre_.first, a.centre_.first, b.centre_.first, MPFR_RNDN);
    mpfr_sub(r.centre_.second, a.centre_.second, b.centre_.second, MPFR_RNDN);
    return r.add_rounding(), r;
  }
  friend Mpfr_disk operator*(const Mpfr_disk& a, const Mpfr_disk& b)
  {
    const Mpfr_pair &u = a.centre_, &v = b.centre_;
    Mpfr_disk r(a, b, radius_of_product(a, b));
    mpfr_fmms(r.centre_.first, u.first, v.first, u.second, v.second, MPFR_RNDN);
    mpfr_fmma(r.centre_.second, u.first, v.second, u.second, v.first, MPFR_RNDN);
    return r.add_rounding(), r;
  }
  friend Mpfr_disk times_conjugate(const Mpfr_disk& a, const Mpfr_disk& b)
  {
    const Mpfr_pair &u = a.centre_, &v = b.centre_;
    Mpfr_disk r(a, b, radius_of_product(a, b));
    mpfr_fmma(r.centre_.first, u.first, v.first, u.second, v.second, MPFR_RNDN);
    mpfr_fmms(r.centre_.second, u.second, v.first, u.first, v.second, MPFR_RNDN);
    return r.add_rounding(), r;
  }
  friend Real squared_norm(const Mpfr_disk& a)
  {
    // |a| <= |centre| + radius, and the same from below.
    const Rounded_up modulus = a.modulus(), error = (modulus + modulus + a.radius_) * a.radius_;
    const Real x(a.centre_.first), y(a.centre_.second);
    return error.around(x * x + y * y);
  }

private:
  Mpfr_disk(const Mpfr_disk& a, const Mpfr_disk& b, const Rounded_up& radius)
    : centre_((std::max)(a.centre_.precision(), b.centre_.precision())), radius_(radius)
  {}

  Rounded_up modulus() const { return Rounded_up::modulus(centre_.first, centre_.second); }
  static Rounded_up radius_of_product(const Mpfr_disk& a, const Mpfr_disk& b)
  {
    return a.modulus() * b.radius_ + (b.modulus() + b.radius_) * a.radius_;
  }
  void add_rounding()
  {
    for (mpfr_srcptr x : {centre_.first, centre_.second})
      if (mpfr_regular_p(x))
        radius_ = radius_ + Rounded_up::half_of_power(mpfr_get_exp(x) - centre_.precision());
  }

  Mpfr_pair centre_;
  Rounded_up radius_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_MPFR_DISK_H
