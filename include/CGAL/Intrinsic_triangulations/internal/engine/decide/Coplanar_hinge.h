// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The Delaunay test of two triangles in one plane in space: the in-circle test of four points.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_DECIDE_COPLANAR_HINGE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_DECIDE_COPLANAR_HINGE_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/With_error.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Double_double.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/Flat_geometry.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL::Intrinsic_triangulations::internal {

// With p_k the scalar product of the sides of the corner k and n_k their cross product,
// cot k = p_k / |n_k|. In one plane n_k and n_l are positive multiples of one normal, so that
// a single component of them, one that is not zero, takes the place of the areas:
//
//     sign(cot k + cot l) = sign(p_k n_l + p_l n_k) sign(n_k),
//
// a polynomial in the coordinates. It is evaluated in double, in double-doubles, and in
// exact numbers, each with one error bound that is known before: p, n and their products
// add up at most a few units in the last place of P_k N_l + P_l N_k, where P and N are p and
// n with absolute values.
class Coplanar_hinge
{
public:
  // The hinge of ij, of which it is known that is_flat().
  Coplanar_hinge(const Delta_complex& complex, const Points& points, Halfedge_index ij)
    : points_(points), i_(complex.source(ij)), j_(complex.target(ij)), k_(complex.target(complex.next(ij))),
      l_(complex.target(complex.next(complex.opposite(ij))))
  {}

  Sign sign_of_cotangents()
  {
    const Sides<double> k = sides<double>(k_, i_, j_), l = sides<double>(l_, j_, i_);
    if (is_right_along_axes(k) && is_right_along_axes(l))
      return ZERO;
    const auto normal = cross_product(k.u, k.v);
    axis_ = std::abs(normal[0]) > std::abs(normal[1]) ? 0 : 1;
    axis_ = std::abs(normal[2]) > std::abs(normal[axis_]) ? 2 : axis_;
    const Corner<double> K = magnitudes(k), L = magnitudes(l);
    magnitude_of_n_ = K.n;
    magnitude_ = K.p * L.n + L.p * K.n;
    Uncertain<Sign> sign = approximate_sign(corner(k, axis_), corner(l, axis_), 0x1p-49);
    if (!is_certain(sign) && has_short_integers(largest(k, l)))
      sign = exact_sign<double>();
    if (!is_certain(sign))
      sign = approximate_sign(corner(sides<Double_double>(k_, i_, j_), axis_),
                              corner(sides<Double_double>(l_, j_, i_), axis_), 0x1p-97);
    return is_certain(sign) ? get_certain(sign) : exact_sign<Exact_ring>();
  }

private:
  template <class FT>
  struct Corner
  {
    FT p, n;
  };

  // From a corner to the start and to the end of the edge ij or ji.
  template <class FT>
  struct Sides
  {
    Vector_3<FT> u, v;
  };

  template <class FT>
  Sides<FT> sides(Vertex_index apex, Vertex_index from, Vertex_index to) const
  {
    return {difference<FT>(points_, apex, from), difference<FT>(points_, apex, to)};
  }

  template <class FT>
  static Corner<FT> corner(const Sides<FT>& s, int axis)
  {
    const int x = (axis + 1) % 3, y = (axis + 2) % 3;
    return {scalar_product(s.u, s.v), s.u[x] * s.v[y] - s.u[y] * s.v[x]};
  }

  Corner<double> magnitudes(const Sides<double>& s) const
  {
    const int x = (axis_ + 1) % 3, y = (axis_ + 2) % 3;
    return {std::abs(s.u[0] * s.v[0]) + std::abs(s.u[1] * s.v[1]) + std::abs(s.u[2] * s.v[2]),
            std::abs(s.u[x] * s.v[y]) + std::abs(s.u[y] * s.v[x])};
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

  static double rounded(double x) { return x; }
  static double rounded(const Double_double& x) { return x.hi; }

  template <class FT>
  Uncertain<Sign> approximate_sign(const Corner<FT>& k, const Corner<FT>& l, double unit) const
  {
    const double value = rounded(k.p * l.n + l.p * k.n), n = rounded(k.n);
    if (std::abs(value) > unit * magnitude_ + tiny && std::abs(n) > unit * magnitude_of_n_ + tiny)
      return (value > 0) == (n > 0) ? POSITIVE : NEGATIVE;
    return Uncertain<Sign>::indeterminate();
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
    for (int c = 0; c < 3; ++c) {
      const std::array<double, 4> x{points_[i_.idx()][c], points_[j_.idx()][c], points_[k_.idx()][c],
                                    points_[l_.idx()][c]};
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

  static Bounded_double_double exact_product(double a, double b)
  {
    return Bounded_double_double(a) * Bounded_double_double(b);
  }
  static Exact_ring exact_product(const Exact_ring& a, const Exact_ring& b) { return a * b; }
  static Sign exact_sign_of(const Bounded_double_double& x) { return get_certain(x.sign()); }
  static Sign exact_sign_of(const Exact_ring& x) { return CGAL::sign(x); }

  // For numbers in which p and n are exact.
  template <class FT>
  Sign exact_sign() const
  {
    const Sides<FT> of_k = sides<FT>(k_, i_, j_), of_l = sides<FT>(l_, j_, i_);
    for (int n = 0; n < 3; ++n) { // the axis was found with rounding, which may have missed a zero
      const int axis = (axis_ + n) % 3;
      const Corner<FT> k = corner(of_k, axis), l = corner(of_l, axis);
      if (!CGAL::is_zero(k.n))
        return exact_sign_of(exact_product(k.p, l.n) + exact_product(l.p, k.n)) * CGAL::sign(k.n);
    }
    return ZERO; // only if an edge was flipped though its hinge was not convex
  }

  // Covers underflow; ordinary values are far above.
  static constexpr double tiny = 1e-200;

  const Points& points_;
  Vertex_index i_, j_, k_, l_;
  int axis_ = 0; // of the component of the normals
  double magnitude_of_n_ = 0, magnitude_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_DECIDE_COPLANAR_HINGE_H
