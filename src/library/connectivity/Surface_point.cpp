// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Surface_point.h.

#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Double_double.h>

#include <CGAL/assertions.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

std::array<double, 3> coordinates_from(const Delta_complex& complex, const Surface_point& point, Halfedge_index first)
{
  const auto& [a, b, c] = point.coordinates;
  if (first == point.halfedge)
    return {a, b, c};
  if (first == complex.next(point.halfedge))
    return {b, c, a};
  CGAL_assertion(first == complex.prev(point.halfedge));
  return {c, a, b};
}

namespace internal {

std::array<double, 3> with_sum_one(const std::array<double, 3>& coordinates)
{
  const auto& [a, b, c] = coordinates;
  const double sum = a + b + c;
  return {a / sum, b / sum, c / sum};
}

std::array<double, 3> on_near_edges(std::array<double, 3> coordinates)
{
  const double sum = coordinates[0] + coordinates[1] + coordinates[2];
  for (double& x : coordinates)
    if (x > 0 && x < 0x1p-40 * sum)
      x = 0;
  return with_sum_one(coordinates);
}

Halfedge_index side_of(const Delta_complex& complex, const Surface_point& point)
{
  const auto& [a, b, c] = point.coordinates;
  return c == 0 ? point.halfedge : a == 0 ? complex.next(point.halfedge) : complex.prev(point.halfedge);
}

std::pair<double, double> coordinates_on_edge(const Delta_complex& complex, const Surface_point& point,
                                              Halfedge_index along)
{
  Halfedge_index h = point.halfedge;
  for (std::size_t i = 0; i < 3; ++i, h = complex.next(h)) {
    const double a = point.coordinates[i], b = point.coordinates[(i + 1) % 3];
    if (point.coordinates[(i + 2) % 3] == 0 && h == along)
      return {a, b};
    if (point.coordinates[(i + 2) % 3] == 0 && h == complex.opposite(along))
      return {b, a};
  }
  CGAL_assertion(false);
  return {};
}

bool find_coordinates(const Delta_complex& complex, Halfedge_index h, const Surface_point& p,
                      std::array<double, 3>& result)
{
  if (complex.face(p.halfedge) == complex.face(h)) {
    result = coordinates_from(complex, p, h);
    return true;
  }
  const Vertex_index v = complex.source(p.coordinates[0] > 0   ? p.halfedge
                                        : p.coordinates[1] > 0 ? complex.next(p.halfedge)
                                                               : complex.prev(p.halfedge));
  for (std::size_t i = 0; i < 3; ++i, h = complex.next(h)) {
    result = {0, 0, 0};
    if (p.dimension() == 0 && complex.source(h) == v)
      result[i] = 1;
    else if (p.dimension() == 1 && complex.edge(h) == complex.edge(side_of(complex, p)))
      std::tie(result[i], result[(i + 1) % 3]) = coordinates_on_edge(complex, p, h);
    else
      continue;
    return true;
  }
  return false;
}

Sign compare_products(double a, double b, double c, double d)
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
  // The high parts are the rounded products: if they differ, the products differ in the same direction.
  return p.high != q.high ? CGAL::sign(p.high - q.high) : CGAL::sign(p.low - q.low);
}

bool are_same_points(const Delta_complex& complex, const Surface_point& p, const Surface_point& q)
{
  const std::array<double, 3>& a = p.coordinates;
  const std::array<double, 3> b = coordinates_from(complex, q, p.halfedge);
  return compare_products(a[0], b[1], a[1], b[0]) == ZERO && compare_products(a[1], b[2], a[2], b[1]) == ZERO &&
         compare_products(a[2], b[0], a[0], b[2]) == ZERO;
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations
