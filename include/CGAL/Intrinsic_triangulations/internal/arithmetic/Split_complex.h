// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Points and vectors in the plane, with coordinates of about 106 bits.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_SPLIT_COMPLEX_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_SPLIT_COMPLEX_H

#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Split_double_double.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Two_doubles.h>

#include <boost/config.hpp>

#include <array>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// Computes with both coordinates at once.
class Split_complex
{
  using Pair = Split_double_double<Two_doubles>;
  using Real = Split_double_double<double>;

public:
  Split_complex() = default;
  BOOST_FORCEINLINE Split_complex(const Pair& xy) : xy_(xy) {}
  BOOST_FORCEINLINE Split_complex(double x, double y) : xy_(Two_doubles(x, y), Two_doubles(0.)) {}

  // Two points, from their coordinates.
  BOOST_FORCEINLINE static std::array<Split_complex, 2> two_points(const Pair& x, const Pair& y)
  {
    std::array<Split_complex, 2> result;
    const auto transpose = [&](Two_doubles Pair::*part) {
      result[0].xy_.*part = firsts(x.*part, y.*part);
      result[1].xy_.*part = seconds(x.*part, y.*part);
    };
    transpose(&Pair::hi);
    transpose(&Pair::lo);
    transpose(&Pair::head);
    transpose(&Pair::tail);
    return result;
  }

  BOOST_FORCEINLINE friend Split_complex operator+(const Split_complex& a, const Split_complex& b)
  {
    return a.xy_ + b.xy_;
  }
  BOOST_FORCEINLINE friend Split_complex operator-(const Split_complex& a, const Split_complex& b)
  {
    return a.xy_ - b.xy_;
  }
  BOOST_FORCEINLINE friend Split_complex operator-(const Split_complex& a) { return -a.xy_; }
  BOOST_FORCEINLINE friend Split_complex operator*(const Split_complex& a, const Split_complex& b)
  {
    const auto first = Pair(parts(a.xy_, [](Two_doubles t) { return firsts(t, t); })) * b.xy_;
    const auto second = Pair(parts(a.xy_, [](Two_doubles t) { return seconds(t, t); })) * turned(b.xy_);
    const Two_doubles sign(-1, 1);
    return sum(first, Pair::Product{sign * second.hi, sign * second.lo});
  }
  // Twice the area of the triangle (0, a, b): positive if b is to the left of a.
  BOOST_FORCEINLINE friend Real area_between(const Split_complex& a, const Split_complex& b)
  {
    const auto product = a.xy_ * turned(b.xy_);
    return sum(Real::Product{product.hi.first(), product.lo.first()},
               Real::Product{-product.hi.second(), -product.lo.second()});
  }
  // An upper bound.
  BOOST_FORCEINLINE friend double modulus(const Split_complex& z)
  {
    const Two_doubles size = abs(z.xy_.hi);
    return 1.5 * (size.first() + size.second());
  }

private:
  template <class Function>
  BOOST_FORCEINLINE static Pair parts(const Pair& a, const Function& f)
  {
    Pair result;
    result.hi = f(a.hi);
    result.lo = f(a.lo);
    result.head = f(a.head);
    result.tail = f(a.tail);
    return result;
  }
  BOOST_FORCEINLINE static Pair turned(const Pair& a)
  {
    return parts(a, [](Two_doubles t) { return swapped(t); });
  }

  Pair xy_;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_SPLIT_COMPLEX_H
