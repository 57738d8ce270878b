// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Exact comparisons of barycentric coordinates, whatever they sum to.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONNECTIVITY_COMPARE_POINTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONNECTIVITY_COMPARE_POINTS_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Double_double.h>

#include <CGAL/enum.h>
#include <CGAL/number_type_basic.h>

#include <array>
#include <cmath>

namespace CGAL::Intrinsic_triangulations::internal {

// The sign of a b − c d for finite numbers that are not negative; nothing over- or underflows.
inline Sign compare_products(double a, double b, double c, double d)
{
  struct Product
  {
    Product(double x, double y)
    {
      int of_x = 0, of_y = 0;
      x = std::frexp(x, &of_x);
      y = std::frexp(y, &of_y);
      two_product(x, y, high, low); // std::fma() is not exact everywhere
      exponent = of_x + of_y;
    }
    double high, low;
    int exponent;
  };
  Product p(a, b);
  const Product q(c, d);
  if (p.high == 0 || q.high == 0)
    return CGAL::sign(p.high - q.high);
  const int shift = p.exponent - q.exponent;
  if (shift < -4 || shift > 4)
    return shift < 0 ? NEGATIVE : POSITIVE;
  p.high = std::ldexp(p.high, shift);
  p.low = std::ldexp(p.low, shift);
  // The high parts are the rounded products: where they differ, so do these, in the same way.
  return p.high != q.high ? CGAL::sign(p.high - q.high) : CGAL::sign(p.low - q.low);
}

// Whether two points of the same face are the same.
inline bool are_same_points(const Delta_complex& complex, const Surface_point& p, const Surface_point& q)
{
  const std::array<double, 3>& a = p.coordinates;
  const std::array<double, 3> b = coordinates_from(complex, q, p.halfedge);
  return compare_products(a[0], b[1], a[1], b[0]) == ZERO && compare_products(a[1], b[2], a[2], b[1]) == ZERO &&
         compare_products(a[2], b[0], a[0], b[2]) == ZERO;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONNECTIVITY_COMPARE_POINTS_H
