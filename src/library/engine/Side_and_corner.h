// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The corner of a face from which its numbers are computed.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_SIDE_AND_CORNER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_SIDE_AND_CORNER_H

#include <CGAL/Intrinsic_triangulations/internal/engine/Engine_numbers.h>
#include "Exact_engine_memory.h"
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Correspondence.h>

#include <array>
#include <cstddef>

namespace CGAL::Intrinsic_triangulations::internal {

// A corner of a face, and the opposite side.
template <class Real>
struct Engine_numbers::Side_and_corner
{
  Halfedge_index side;
  Triangle_corner<Real> corner;

  // The cotangents of the angles opposite to the side and the next ones. The errors are infinite if the area is not
  // known to be positive.
  std::array<Real, 3> cotangents() const
  {
    if (!certainly(corner.four_areas.sign() == POSITIVE))
      return {Real() / Real(), Real() / Real(), Real() / Real()};
    const Real inverse = Real(1) / corner.four_areas;
    return {corner.p * inverse, (corner.s_first.scaled(2) - corner.p) * inverse,
            (corner.s_second.scaled(2) - corner.p) * inverse};
  }
  // The cotangents opposite to the first halfedge of a face and the next ones.
  void get_cotangents(const Delta_complex& complex, Face_index f, std::array<Real, 3>& result) const
  {
    const std::array<Real, 3> from_side = cotangents();
    const Halfedge_index first = complex.halfedge(f);
    const std::size_t turns = side == first ? 0 : side == complex.next(first) ? 1 : 2;
    for (std::size_t i = 0; i < 3; ++i)
      result[(i + turns) % 3] = from_side[i];
  }
};

// The corner of a face that takes the least time.
template <class Unfolding_>
Engine_numbers::Side_and_corner<Bounded_double_double>
Engine_numbers::quickest_corner(Face_index f, const Unfolding_& unfolding) const
{
  if (engine_.is_straight(f))
    return {complex_.halfedge(f), engine_.straight_corner(complex_.halfedge(f))};
  if (const auto c = engine_.memory_->corner_by_flips(
        complex_, metric_, [&] { engine_.prepare(); }, f, 0x1p-70))
    return {complex_.halfedge(f), *c};
  const Halfedge_index h = correspondence_.coordinates().side_with_most_crossings(complex_, f);
  return {h, unfolding.opposite_corner(h)};
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_SIDE_AND_CORNER_H
