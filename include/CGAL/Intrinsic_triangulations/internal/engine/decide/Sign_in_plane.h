// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The Delaunay test of two triangles in one plane in space, where corners were inserted.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_DECIDE_SIGN_IN_PLANE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_DECIDE_SIGN_IN_PLANE_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/With_error.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/layout/Vertex_positions.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/decide/corner_signs.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/Flat_geometry.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>

namespace CGAL::Intrinsic_triangulations::internal {

// As `Coplanar_hinge`: with p_k the scalar product of the sides of the corner k and n_k one component of their cross
// product,
//
//     sign(cot k + cot l) = sign(p_k n_l + p_l n_k) sign(n_k + n_l).
//
// The positions of inserted vertices are rounded themselves, so that no error is known before: it is carried along.
//
// Vectors may be replaced by positive multiples of them, which multiplies p and n of a corner alike: so weighted means
// of points need no division.
class Sign_in_plane
{
public:
  // The hinge of ij, whose two faces lie in one plane.
  Sign_in_plane(const Delta_complex& complex, const Vertex_positions& positions, Halfedge_index ij)
    : positions_(positions), i_(complex.source(ij)), j_(complex.target(ij)), k_(complex.target(complex.next(ij))),
      l_(complex.target(complex.next(complex.opposite(ij))))
  {}

  Sign operator()() const
  {
    const auto k = corner<Bounded_double_double>(k_, i_, j_), l = corner<Bounded_double_double>(l_, j_, i_);
    const int axis = longest(k.n, l.n);
    const Number p_k = k.p, p_l = l.p, n_k = k.n[axis], n_l = l.n[axis];
    const Uncertain<Sign> sign = (p_k * n_l + p_l * n_k).sign(), side = (n_k + n_l).sign();
    if (is_certain(side) && get_certain(side) != ZERO) {
      if (is_certain(sign))
        return get_certain(sign) * get_certain(side);
      if (is_exact(p_k) && is_exact(p_l) && is_exact(n_k) && is_exact(n_l)) // only their products are too long
        return CGAL::sign(Exact_ring(exact(p_k) * exact(n_l) + exact(p_l) * exact(n_k))) * get_certain(side);
    }
    return exact_sign();
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

  static int longest(const Vector_3<Number>& a, const Vector_3<Number>& b)
  {
    const auto length = [&](std::size_t c) { return std::abs(a[c].hi()) + std::abs(b[c].hi()); };
    const int axis = length(0) > length(1) ? 0 : 1;
    return length(2) > length(std::size_t(axis)) ? 2 : axis;
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

  const Vertex_positions& positions_;
  Vertex_index i_, j_, k_, l_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_DECIDE_SIGN_IN_PLANE_H
