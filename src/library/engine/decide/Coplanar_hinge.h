// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The Delaunay test of two triangles in one plane in space: the in-circle test of four points.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_DECIDE_COPLANAR_HINGE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_DECIDE_COPLANAR_HINGE_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Double_double.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/With_error.h>
#include "corner_signs.h"
#include "../layout/Vertex_positions.h"
#include "../../measures/Flat_geometry.h"

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

// With p_k the scalar product of the sides of the corner k and n_k their cross product, cot k = p_k / |n_k|. In one
// plane n_k and n_l are nonnegative multiples of one normal, so that a single nonzero component of them can replace the
// areas:
//
//     sign(cot k + cot l) = sign(p_k n_l + p_l n_k) sign(n_k + n_l),
//
// a polynomial in the coordinates. Between points of the input it is evaluated in double and in double-doubles, each
// with one a priori error bound: p, n and their products add up at most a few units in the last place of P_k N_l + P_l
// N_k, where P and N are p and n with absolute values. Positions of inserted vertices are rounded themselves, so their
// errors are carried along. Exact numbers decide the rest.
//
// Vectors may be replaced by positive multiples, which multiplies p and n of a corner by the same factor, so weighted
// means of points need no division.
class Coplanar_hinge
{
public:
  // The hinge of ij, whose two faces lie in one plane.
  Coplanar_hinge(const Delta_complex& complex, const Vertex_positions& positions, Halfedge_index ij)
    : positions_(positions), i_(complex.source(ij)), j_(complex.target(ij)), k_(complex.target(complex.next(ij))),
      l_(complex.target(complex.next(complex.opposite(ij)))),
      has_inserted_corner_(positions.has_inserted_corner(complex, ij) ||
                           positions.has_inserted_corner(complex, complex.opposite(ij)))
  {}

  Sign sign_of_cotangents() const
  {
    const Uncertain<Sign> sign = has_inserted_corner_ ? sign_with_errors() : sign_of_points();
    return is_certain(sign) ? get_certain(sign) : exact_sign();
  }

private:
  using Number = Bounded_double_double;

  template <class FT>
  struct Corner
  {
    FT p;
    Vector_3<FT> n;
  };

  template <class FT>
  Corner<FT> corner(Vertex_index apex, Vertex_index from, Vertex_index to) const
  {
    const Vector_3<FT> u = positions_.direction<FT>(apex, from), v = positions_.direction<FT>(apex, to);
    return {scalar_product(u, v), cross_product(u, v)};
  }

  static std::size_t longest(const Vector_3<Number>& a, const Vector_3<Number>& b)
  {
    const auto length = [&](std::size_t c) { return std::abs(a[c].hi()) + std::abs(b[c].hi()); };
    const std::size_t axis = length(0) > length(1) ? 0 : 1;
    return length(2) > length(axis) ? 2 : axis;
  }

  Uncertain<Sign> sign_with_errors() const
  {
    const auto k = corner<Number>(k_, i_, j_), l = corner<Number>(l_, j_, i_);
    const std::size_t axis = longest(k.n, l.n);
    const Number p_k = k.p, p_l = l.p, n_k = k.n[axis], n_l = l.n[axis];
    const Uncertain<Sign> sign = (p_k * n_l + p_l * n_k).sign(), side = (n_k + n_l).sign();
    if (!is_certain(side) || get_certain(side) == ZERO)
      return Uncertain<Sign>::indeterminate();
    if (is_certain(sign))
      return get_certain(sign) * get_certain(side);
    if (is_exact(p_k) && is_exact(p_l) && is_exact(n_k) && is_exact(n_l)) // only their products are too long
      return CGAL::sign(Exact_ring(exact(p_k) * exact(n_l) + exact(p_l) * exact(n_k))) * get_certain(side);
    return Uncertain<Sign>::indeterminate();
  }

  static bool is_exact(const Number& x) { return x.error() == 0; }
  static Exact_ring exact(const Number& x) { return Exact_ring(x.hi()) + Exact_ring(x.lo()); }

  Sign exact_sign() const
  {
    const auto k = corner<Exact_ring>(k_, i_, j_), l = corner<Exact_ring>(l_, j_, i_);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Sign side_k = CGAL::sign(k.n[axis]), side_l = CGAL::sign(l.n[axis]);
      if (side_k != ZERO || side_l != ZERO) // a vertex may lie on the edge
        return CGAL::sign(Exact_ring(k.p * l.n[axis] + l.p * k.n[axis])) * (side_k != ZERO ? side_k : side_l);
    }
    return sign_of_tie(CGAL::sign(k.p), CGAL::sign(l.p));
  }

  // The vectors from a corner to the start and to the end of the edge ij or ji.
  template <class FT>
  struct Sides
  {
    Vector_3<FT> u, v;
  };
  // The vectors of k and of l.
  template <class FT>
  std::pair<Sides<FT>, Sides<FT>> sides() const
  {
    const auto side = [this](Vertex_index from, Vertex_index to) {
      return difference<FT>(positions_.points(), from, to);
    };
    return {{side(k_, i_), side(k_, j_)}, {side(l_, j_), side(l_, i_)}};
  }

  // \pre no corner was inserted
  Uncertain<Sign> sign_of_points() const
  {
    const auto [k, l] = sides<double>();
    if (is_right_along_axes(k) && is_right_along_axes(l))
      return ZERO;
    const auto normal = cross_product(k.u, k.v);
    std::size_t axis = std::abs(normal[0]) > std::abs(normal[1]) ? 0 : 1;
    axis = std::abs(normal[2]) > std::abs(normal[axis]) ? 2 : axis;
    const std::size_t x = (axis + 1) % 3, y = (axis + 2) % 3;
    const auto p = [](const auto& s) { return scalar_product(s.u, s.v); };
    const auto n = [&](const auto& s) { return s.u[x] * s.v[y] - s.u[y] * s.v[x]; };
    const auto magnitude_of_p = [](const Sides<double>& s) {
      return std::abs(s.u[0] * s.v[0]) + std::abs(s.u[1] * s.v[1]) + std::abs(s.u[2] * s.v[2]);
    };
    const auto magnitude_of_n = [&](const Sides<double>& s) {
      return std::abs(s.u[x] * s.v[y]) + std::abs(s.u[y] * s.v[x]);
    };
    const double of_n = magnitude_of_n(k), of_sum = magnitude_of_p(k) * magnitude_of_n(l) + magnitude_of_p(l) * of_n;
    const auto approximate_sign = [&](const auto& of_k, const auto& of_l, double unit) -> Uncertain<Sign> {
      constexpr double tiny = 1e-200; // covers underflow; ordinary values are far above
      const double sum = high(p(of_k) * n(of_l) + p(of_l) * n(of_k)), side = high(n(of_k));
      if (std::abs(sum) > unit * of_sum + tiny && std::abs(side) > unit * of_n + tiny)
        return (sum > 0) == (side > 0) ? POSITIVE : NEGATIVE;
      return Uncertain<Sign>::indeterminate();
    };
    if (const Uncertain<Sign> sign = approximate_sign(k, l, 0x1p-49); is_certain(sign))
      return sign;
    if (n(k) != 0 && has_short_integers(largest(k, l)))
      return get_certain((Number(p(k)) * Number(n(l)) + Number(p(l)) * Number(n(k))).sign()) * CGAL::sign(n(k));
    const auto [precise_k, precise_l] = sides<Double_double>();
    return approximate_sign(precise_k, precise_l, 0x1p-97);
  }

  static bool is_right_along_axes(const Sides<double>& s)
  {
    return (s.u[0] == 0 || s.v[0] == 0) && (s.u[1] == 0 || s.v[1] == 0) && (s.u[2] == 0 || s.v[2] == 0);
  }

  static double largest(const Sides<double>& k, const Sides<double>& l)
  {
    double result = 0;
    for (const auto* v : {&k.u, &k.v, &l.u, &l.v})
      for (double x : *v)
        result = (std::max)(result, std::abs(x));
    return result;
  }

  // Whether the differences of coordinates are integers of at most 25 bits in some common unit,
  // as in a grid: then p and n are exact in double.
  bool has_short_integers(double largest_difference) const
  {
    if (!(largest_difference > 1e-50 && largest_difference < 1e50))
      return false;
    int exponent;
    std::frexp(largest_difference, &exponent);
    const double scale = std::ldexp(1., 25 - exponent);
    constexpr double to_integer = 0x1.8p52;
    const Points& points = positions_.points();
    for (int c = 0; c < 3; ++c) {
      const std::array<double, 4> x{points[i_.idx()][c], points[j_.idx()][c], points[k_.idx()][c], points[l_.idx()][c]};
      if (x[0] == x[1] && x[0] == x[2] && x[0] == x[3])
        continue;
      for (double each : x) {
        const double scaled = each * scale;
        const bool is_lost = scaled == 0 && each != 0; // by underflow
        if (is_lost || !(std::abs(scaled) < 0x1p51 && (scaled + to_integer) - to_integer == scaled))
          return false;
      }
    }
    return true;
  }

  const Vertex_positions& positions_;
  Vertex_index i_, j_, k_, l_;
  bool has_inserted_corner_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_DECIDE_COPLANAR_HINGE_H
