// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Flips after an insertion or a removal.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_SETTLE_AROUND_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_SETTLE_AROUND_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/flips/Whole_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Standard_arithmetic.h>

#include <CGAL/Uncertain.h>
#include <CGAL/property_map.h>

#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Makes a triangulation Delaunay again, in which all edges except those on the stack are Delaunay: Lawson's algorithm.
// The work is local.
// \param after_flip is called with each edge that was flipped
// \pre the triangulation keeps its input
template <class Traits, class ConstraintMap, class AfterFlip>
void settle(Intrinsic_triangulation<Traits>& triangulation, const ConstraintMap& is_constrained,
            std::vector<Edge_index>& stack, const AfterFlip& after_flip)
{
  using Flip_outcome = typename Intrinsic_triangulation<Traits>::Flip_outcome;
  const Standard_arithmetic arithmetic;
  Whole_triangulation<Traits> whole(triangulation);
  const Delta_complex& complex = triangulation.connectivity();
  std::uint64_t steps = 0;
  while (!stack.empty()) {
    if (++steps % 1024 == 0)
      engine(triangulation).decisions().interruption.check();
    const Edge_index e = stack.back();
    stack.pop_back();
    if (!complex.is_flippable(e) || whole.is_known_Delaunay(e) || get(is_constrained, e) ||
        possibly(whole.test_and_recompute(e)))
      continue;
    const Hinge_halfedges around = complex.hinge(e);
    if (whole.flip_not_Delaunay(around) != Flip_outcome::FLIPPED)
      continue;
    after_flip(e);
    for (Halfedge_index side : {around.jk, around.ki, around.il, around.lj})
      stack.push_back(complex.edge(side));
  }
}

// As above, if only faces around a vertex have changed.
template <class Traits, class ConstraintMap, class AfterFlip>
void settle_around(Intrinsic_triangulation<Traits>& triangulation, Vertex_index v, const ConstraintMap& is_constrained,
                   std::vector<Edge_index>& stack, const AfterFlip& after_flip)
{
  const Delta_complex& complex = triangulation.connectivity();
  stack.clear();
  for (Halfedge_index h : Halfedges_around(complex, v)) { // the edges that lead to v, and the sides opposite to it
    stack.push_back(complex.edge(h));
    if (!complex.is_border(h))
      stack.push_back(complex.edge(complex.prev(h)));
  }
  settle(triangulation, is_constrained, stack, after_flip);
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_SETTLE_AROUND_H
