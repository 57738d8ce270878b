// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The sign of the sum of two cotangents, from bounds on the two corners.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_DECIDE_CORNER_SIGNS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_DECIDE_CORNER_SIGNS_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include "../../arithmetic/Split_double_double.h"
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/With_error.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/rounded_sqrt.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/layout/Triangle_corner.h>
#include "../layout/Vertex_positions.h"
#include "../layout/metric_images.h"
#include "../../measures/Flat_geometry.h"

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <optional>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations::internal {

// In a tie the angles sum to 0, π or 2π; only in the last case are both obtuse.
inline Sign sign_of_tie(Sign sign_k, Sign sign_l) { return sign_k == NEGATIVE && sign_l == NEGATIVE ? NEGATIVE : ZERO; }

// The sign of cot k + cot l, if it is certain. Zero needs positive areas or the signs of both scalar products.
template <class Corner>
std::optional<Sign> sign_of_cotangents(const Corner& k, const Corner& l)
{
  const Uncertain<Sign> sign = (k.p * l.four_areas + l.p * k.four_areas).sign(), sign_k = k.p.sign(),
                        sign_l = l.p.sign();
  if (is_certain(sign) && get_certain(sign) != ZERO)
    return get_certain(sign);
  if (!is_certain(sign) || !is_certain(sign_k) || !is_certain(sign_l))
    return std::nullopt;
  return sign_of_tie(get_certain(sign_k), get_certain(sign_l));
}

// The side of h on which a point in the plane of h's straight face lies. No answer if the face has no area.
inline std::optional<Sign> side_in_plane(const Delta_complex& complex, const Vertex_positions& positions,
                                         Halfedge_index h, const Surface_point& point)
{
  const auto value = [&](const auto& convert, bool is_of_face) {
    const auto origin = positions.position(complex.source(h), convert);
    const auto from_origin = [&](const auto& p) { return minus(p, origin); };
    const auto u = from_origin(positions.position(complex.target(h), convert));
    const auto normal = cross_product(u, from_origin(positions.position(complex.target(complex.next(h)), convert)));
    return scalar_product(normal,
                          is_of_face ? normal : cross_product(u, from_origin(positions.position(point, convert))));
  };
  const Uncertain<Sign> sign = value([](double x) { return Bounded_double_double(x); }, false).sign();
  if (is_certain(sign) && get_certain(sign) != ZERO)
    return get_certain(sign);
  const auto rational = [](double x) { return Rational(x); };
  if (Rational(value(rational, true)) == 0)
    return std::nullopt;
  return static_cast<Sign>(Rational(value(rational, false)).sign());
}

using Straight_corner = Triangle_corner<Bounded_double_double>;
using Input_point = std::array<double, 3>;

// The same with half of the digits, in a tenth of the time. Faces without area have exact numbers.
inline std::optional<Sign> sign_in_doubles(const Opposite_corners<Bounded_double_double>& corners)
{
  using Real = Double_with_bound;
  const auto& [k, l] = corners;
  if (k.four_areas.is_zero() || l.four_areas.is_zero())
    return sign_of_cotangents(k, l);
  const Uncertain<Sign> sign = (Real(k.p) * Real(l.four_areas) + Real(l.p) * Real(k.four_areas)).sign();
  return is_certain(sign) ? std::make_optional(get_certain(sign)) : std::nullopt;
}

// As straight_corner(), for points of the input: one bound for all errors is faster than a running one. Empty if
// anything could underflow, or an exact zero might be missed.
inline std::optional<Straight_corner> straight_corner(const Input_point& i, const Input_point& j, const Input_point& k)
{
  const Split_vector<double> ki = split_vector(k, i), kj = split_vector(k, j), side = split_vector(i, j);
  const Split_double_double<double> p = split_scalar_product(ki, kj), s_first = split_scalar_product(ki, ki),
                                    s_second = split_scalar_product(kj, kj), s_side = split_scalar_product(side, side),
                                    square = split_squared_area(ki, kj);
  const auto is_usual = [](double s) { return s > 1e-100 && s < 1e100; };
  // Products of two vectors have errors of at most 2^-102 times the product of their lengths, and so the area of
  // 2^-100.
  const double error = 0x1p-97 * rounded_sqrt(s_first.hi * s_second.hi);
  if (!is_usual(s_first.hi) || !is_usual(s_second.hi) || !is_usual(s_side.hi) || !(square.hi > 1e-200) ||
      !(std::abs(p.hi) > error))
    return std::nullopt;
  const auto bounded = [](const Split_double_double<double>& x, double bound) {
    return Bounded_double_double(x.hi, x.lo, bound);
  };
  return Straight_corner{bounded(p, error).scaled(2), bounded(square_root(square), error).scaled(2),
                         bounded(s_first, 0x1p-100 * s_first.hi), bounded(s_second, 0x1p-100 * s_second.hi),
                         bounded(s_side, 0x1p-100 * s_side.hi)};
}

// In doubles; u is 2^-53. Scalar products make up for what the coordinates of sides have lost: they err by their own
// rounding alone, u of each product and sum. For sides of lengths m and n, the cross product, whose components err by
// 4.01 u of both terms, errs by 4.01 √2 u m n, and its length by 2.51 u m n more; squared lengths by 4.01 u of them.
inline std::optional<Straight_corner> straight_corner_in_doubles(const Input_point& i, const Input_point& j,
                                                                 const Input_point& k)
{
  struct Side
  {
    Side(const Input_point& p, const Input_point& q)
    {
      for (int c = 0; c < 3; ++c)
        two_sum(q[c], -p[c], v[c], lost[c]);
      square = scalar_product(v, v) + 2 * scalar_product(v, lost);
    }
    Vector_3<double> v, lost;
    double square;
  };
  const Side ki(k, i), kj(k, j), side(i, j);
  const auto normal = cross_product(ki.v, kj.v);
  const double square = scalar_product(normal, normal), m_n = rounded_sqrt(ki.square * kj.square), u = 0x1p-53,
               x = ki.v[0] * kj.v[0], y = ki.v[1] * kj.v[1], z = ki.v[2] * kj.v[2], xy = x + y, xyz = xy + z,
               p = xyz + (scalar_product(ki.v, kj.lost) + scalar_product(ki.lost, kj.v)),
               rounded = std::abs(x) + std::abs(y) + std::abs(z) + std::abs(xy) + std::abs(xyz) + std::abs(p);
  const auto is_usual = [](double s) { return s > 1e-100 && s < 1e100; };
  if (!is_usual(ki.square) || !is_usual(kj.square) || !is_usual(side.square) || !(square > 1e-200))
    return std::nullopt;
  const auto bounded = [](double value, double bound) { return Bounded_double_double(value, 0, bound); };
  return Straight_corner{bounded(p, 1.01 * u * rounded + 1e-300).scaled(2),
                         bounded(rounded_sqrt(square), 8.5 * u * m_n).scaled(2),
                         bounded(ki.square, 4.1 * u * ki.square), bounded(kj.square, 4.1 * u * kj.square),
                         bounded(side.square, 4.1 * u * side.square)};
}

// Lengths and angles from three points, with half of the digits if that suffices.
inline Straight_corner straight_corner(const Delta_complex& complex, const Vertex_positions& positions,
                                       Halfedge_index ij, bool in_doubles = false)
{
  using Real = Bounded_double_double;
  const Vertex_index i = complex.source(ij), j = complex.target(ij), k = complex.target(complex.next(ij));
  if (!positions.is_inserted(i) && !positions.is_inserted(j) && !positions.is_inserted(k)) {
    const auto &p = positions.points()[i.idx()], &q = positions.points()[j.idx()], &r = positions.points()[k.idx()];
    if (const auto corner = in_doubles ? straight_corner_in_doubles(p, q, r) : straight_corner(p, q, r))
      return *corner;
  }
  const auto ki = positions.direction<Real>(k, i), kj = positions.direction<Real>(k, j),
             side = positions.direction<Real>(i, j);
  const auto normal = cross_product(ki, kj);
  return {scalar_product(ki, kj).scaled(2), sqrt(scalar_product(normal, normal)).scaled(2), scalar_product(ki, ki),
          scalar_product(kj, kj), scalar_product(side, side)};
}

// The same in finite fields.
inline Triangle_corner<Residues> image_of_straight_corner(const Delta_complex& complex,
                                                          const Vertex_positions& positions, Halfedge_index ij,
                                                          Residue_rings& rings)
{
  const Vertex_index i = complex.source(ij), j = complex.target(ij), k = complex.target(complex.next(ij));
  const auto corners = [&](const auto& convert) {
    return std::array{positions.position(i, convert), positions.position(j, convert), positions.position(k, convert)};
  };
  const auto images = corners([&](double x) { return rings.number(x); });
  const Vector_3<Residues> ki = minus(images[0], images[2]), kj = minus(images[1], images[2]),
                           side = minus(images[1], images[0]);
  const Residues p = scalar_product(ki, kj);
  const auto exact = corners([](double x) { return Rational(x); });
  const auto normal = cross_product(minus(exact[0], exact[2]), minus(exact[1], exact[2]));
  const Rational squared_four_areas = 4 * scalar_product(normal, normal);
  return {p + p, rings.root(squared_four_areas), scalar_product(ki, ki), scalar_product(kj, kj),
          scalar_product(side, side)};
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_DECIDE_CORNER_SIGNS_H
