// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The walk through the pieces of an input face with inserted vertices.

#include <CGAL/Intrinsic_triangulations/internal/positions/overlay_search.h>

#include <CGAL/assertions.h>
#include <CGAL/enum.h>

#include <unordered_set>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

Piece_walk::Result Piece_walk::operator()(const Surface_point& point) const
{
  const Overlay& overlay = layer_.overlay;
  std::vector<Overlay::Face> next{overlay.face(layer_.part(point.halfedge, 0))}, others;
  std::unordered_set<Overlay::Face> seen;
  for (;;) {
    std::vector<Overlay::Face>& candidates = next.empty() ? others : next;
    CGAL_assertion(!candidates.empty());
    Result here{candidates.back(), {}};
    candidates.pop_back();
    if (!seen.insert(here.face).second)
      continue;
    bool is_here = true;
    const Overlay::Halfedge first = overlay.halfedge(here.face);
    Overlay::Halfedge before = first;
    do {
      const Overlay::Halfedge side = overlay.next(before);
      if (!overlay.input_halfedge(side).is_valid()) {
        const Sign sign = side_of_chord(before, point);
        (sign == NEGATIVE ? next : others).push_back(overlay.face(overlay.opposite(side)));
        is_here = is_here && sign != NEGATIVE;
        if (sign == ZERO)
          here.before_chords.push_back(before);
      }
      before = side;
    } while (before != first);
    if (is_here)
      return here;
  }
}

Sign Piece_walk::side_of_chord(Overlay::Halfedge before, const Surface_point& point) const
{
  const Coordinates x = corner_coordinates(layer_, before, point.halfedge),
                    y = corner_coordinates(layer_, layer_.overlay.next(before), point.halfedge);
  const Coordinates& p = point.coordinates;
  const double sum =
    p[0] * (x[1] * y[2] - x[2] * y[1]) + p[1] * (x[2] * y[0] - x[0] * y[2]) + p[2] * (x[0] * y[1] - x[1] * y[0]);
  // Coordinates are accurate to 2^-51, so each product of two is accurate to 2^-50 and their difference to 2^-49.
  const double error = 0x1p-48 * (p[0] + p[1] + p[2]);
  if (sum > error)
    return POSITIVE;
  if (sum < -error)
    return NEGATIVE;
  return layer_.side_of_chord(before, point).value_or(POSITIVE);
}

} // namespace CGAL::Intrinsic_triangulations::internal
