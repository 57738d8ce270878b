// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Vectors between points in space, and exact tests whether two triangles lie in one plane.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_FLAT_GEOMETRY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_FLAT_GEOMETRY_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include "../arithmetic/Split_double_double.h"
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/With_error.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Double_double.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Rational.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/triangle_formulas_3.h>

#include <CGAL/Mpzf.h>
#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <type_traits>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

// Exact sums and products of doubles; no division. Names CGAL's fastest type directly: the header that selects it has
// 50,000 lines.
#ifdef CGAL_HAS_MPZF
using Exact_ring = Mpzf;
inline Rational rational(const Exact_ring& x)
{
  Rational result;
  x.export_to_mpq_t(result.backend().data());
  return result;
}
#else
using Exact_ring = Rational;
inline Rational rational(const Exact_ring& x) { return x; }
#endif

// In double-doubles without rounding.
template <class FT>
FT difference(double a, double b)
{
  if constexpr (std::is_same<FT, Double_double>::value || std::is_same<FT, Bounded_double_double>::value)
    return FT::difference(a, b);
  else
    return FT(a) - FT(b);
}

template <class FT>
Vector_3<FT> difference(const Points& points, Vertex_index from, Vertex_index to)
{
  const std::array<double, 3>&p = points[from.idx()], &q = points[to.idx()];
  return {difference<FT>(q[0], p[0]), difference<FT>(q[1], p[1]), difference<FT>(q[2], p[2])};
}

inline double sum_of_absolute_values(const Vector_3<double>& v)
{
  return std::abs(v[0]) + std::abs(v[1]) + std::abs(v[2]);
}

// Whether a volume is above its rounding errors, with u = 2^-53 at most 8.01 u of each product of three coordinates:
// 3 u for the differences, 2 u for the products and 3 u for the sums.
inline bool is_clearly_bent(const Points& points, Vertex_index i, Vertex_index j, Vertex_index k, Vertex_index l)
{
  const auto a = difference<double>(points, i, j), b = difference<double>(points, i, k),
             c = difference<double>(points, i, l);
  double volume = 0, sum_of_products = 0;
  for (std::size_t x = 0, y = 1, z = 2; x < 3; y = z, z = x++) {
    volume += (a[y] * b[z] - a[z] * b[y]) * c[x];
    sum_of_products += (std::abs(a[y] * b[z]) + std::abs(a[z] * b[y])) * std::abs(c[x]);
  }
  return std::abs(volume) > 0x1.1p-50 * sum_of_products + 1e-290;
}

// Whether four points are seen to be coplanar without a product, as most coplanar points are: in a plane parallel to
// two axes, or as corners k, i, l, j of a parallelogram.
inline bool is_clearly_coplanar(const Points& points, Vertex_index i, Vertex_index j, Vertex_index k, Vertex_index l)
{
  const auto &p = points[i.idx()], &q = points[j.idx()], &r = points[k.idx()], &s = points[l.idx()];
  for (int c = 0; c < 3; ++c)
    if (p[c] == q[c] && p[c] == r[c] && p[c] == s[c])
      return true;
  for (int c = 0; c < 3; ++c) {
    const Double_double one = Double_double::difference(r[c], p[c]), other = Double_double::difference(q[c], s[c]);
    if (one.hi != other.hi || one.lo != other.lo)
      return false;
  }
  return true;
}

// The sign of scalar_product(a × b, c × d) for vectors from one vertex to another.
using Vertex_pair = std::pair<Vertex_index, Vertex_index>;
inline Sign sign_of_normals(const Points& points, Vertex_pair a, Vertex_pair b, Vertex_pair c, Vertex_pair d)
{
  // In double the error is less than 2^-48 times the product of the sums of the absolute values.
  const auto length = [&](Vertex_pair v) {
    return sum_of_absolute_values(difference<double>(points, v.first, v.second));
  };
  const double bound = 0x1p-48 * length(a) * length(b) * length(c) * length(d) + 1e-290;
  const auto evaluate = [&](auto zero) {
    using FT = decltype(zero);
    const auto vector = [&](Vertex_pair v) { return difference<FT>(points, v.first, v.second); };
    return scalar_product(cross_product(vector(a), vector(b)), cross_product(vector(c), vector(d)));
  };
  const double value = evaluate(0.);
  if (std::abs(value) > bound)
    return value > 0 ? POSITIVE : NEGATIVE;
  const Uncertain<Sign> sign = evaluate(Bounded_double_double()).sign();
  return is_certain(sign) ? get_certain(sign) : CGAL::sign(evaluate(Exact_ring()));
}

// The same with twice the digits, and the vectors split once: less than 2^-98 times that product. Nearly coplanar
// points are most often bent by the rounding of their coordinates.
inline bool is_barely_bent(const Points& points, Vertex_index i, Vertex_index j, Vertex_index k, Vertex_index l)
{
  const auto &p = points[i.idx()], &q = points[j.idx()], &r = points[k.idx()], &s = points[l.idx()];
  const auto a = split_vector(p, q), b = split_vector(p, r), c = split_vector(p, s);
  const auto minor = [&](int m, int n) { return sum(a[m] * b[n], -(a[n] * b[m])); };
  const auto size = [](const auto& v) { return std::abs(v[0].hi) + std::abs(v[1].hi) + std::abs(v[2].hi); };
  const double bound = 0x1p-98 * size(a) * size(b) * size(c);
  return std::abs(sum(minor(1, 2) * c[0], minor(2, 0) * c[1], minor(0, 1) * c[2]).hi) > bound && bound > 1e-200;
}

// Whether four points lie in one plane.
inline bool are_coplanar(const Points& points, Vertex_index i, Vertex_index j, Vertex_index k, Vertex_index l)
{
  if (is_clearly_bent(points, i, j, k, l))
    return false;
  if (is_clearly_coplanar(points, i, j, k, l))
    return true;
  if (is_barely_bent(points, i, j, k, l))
    return false;
  const auto volume = [&](auto zero) {
    using FT = decltype(zero);
    return scalar_product(cross_product(difference<FT>(points, i, j), difference<FT>(points, i, k)),
                          difference<FT>(points, i, l));
  };
  const Uncertain<Sign> sign = volume(Bounded_double_double()).sign();
  return is_certain(sign) ? get_certain(sign) == ZERO : CGAL::sign(volume(Exact_ring())) == ZERO;
}

// Whether the faces beside an edge lie in one plane, on different sides of the edge, and
// have positive area.
inline bool is_flat(const Delta_complex& complex, const Points& points, Halfedge_index ij)
{
  const Halfedge_index ji = complex.opposite(ij);
  const Vertex_index i = complex.source(ij), j = complex.target(ij), k = complex.target(complex.next(ij)),
                     l = complex.target(complex.next(ji));
  return are_coplanar(points, i, j, k, l) && sign_of_normals(points, {i, j}, {i, k}, {i, l}, {i, j}) == POSITIVE;
}

// Whether two faces lie in one plane with one normal, and have positive area; g may be f.
inline bool have_one_plane(const Delta_complex& complex, const Points& points, Face_index f, Face_index g)
{
  const auto corners = [&](Face_index face) {
    const Halfedge_index h = complex.halfedge(face);
    return std::array<Vertex_index, 3>{complex.source(h), complex.target(h), complex.target(complex.next(h))};
  };
  const auto [i, j, k] = corners(f);
  const auto [l, m, n] = corners(g);
  for (Vertex_index v : {l, m, n})
    if (v != i && v != j && v != k && !are_coplanar(points, i, j, k, v))
      return false;
  return sign_of_normals(points, {i, j}, {i, k}, {l, m}, {l, n}) == POSITIVE;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_FLAT_GEOMETRY_H
