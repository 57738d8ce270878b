// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Finds the face of the overlay that contains a point of an input face with inserted vertices.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_PIECE_WALK_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_PIECE_WALK_H

#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/positions/Exact_side.h>
#include <CGAL/Intrinsic_triangulations/internal/positions/overlay_layers.h>

#include <CGAL/assertions.h>
#include <CGAL/enum.h>

#include <boost/container/static_vector.hpp>

#include <unordered_set>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// In such a face the chords begin and end anywhere, so that there is no order to search by. The walk goes from piece to
// piece across chords that have the point on their other side, and to each piece once: where such a walk would run in
// circles, it becomes a search through all of them.
class Piece_walk
{
public:
  struct Result
  {
    Overlay::Face face;
    // Its sides before chords that the point lies on: none, one, or two that meet at an inserted vertex.
    boost::container::static_vector<Overlay::Halfedge, 6> before_chords;
  };

  Piece_walk(const Input_layer& layer, const Exact_side& exact_side) : layer_(layer), exact_side_(exact_side) {}

  Result operator()(const Surface_point& point) const
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

private:
  // The side of a point of the chord after a side. In a face without area all points are on the left.
  Sign side_of_chord(Overlay::Halfedge before, const Surface_point& point) const
  {
    const Overlay::Halfedge chord = layer_.overlay.next(before);
    const Coordinates x = corner_coordinates(layer_, before, point.halfedge),
                      y = corner_coordinates(layer_, chord, point.halfedge);
    const Coordinates& p = point.coordinates;
    const double sum =
      p[0] * (x[1] * y[2] - x[2] * y[1]) + p[1] * (x[2] * y[0] - x[0] * y[2]) + p[2] * (x[0] * y[1] - x[1] * y[0]);
    // Coordinates are good to 2^-51, so that each product of two is good to 2^-50 and their difference to 2^-49.
    const double error = 0x1p-48 * (p[0] + p[1] + p[2]);
    if (sum > error)
      return POSITIVE;
    if (sum < -error)
      return NEGATIVE;
    return exact_side_.of_intrinsic_chord(chord, point).value_or(POSITIVE);
  }

  const Input_layer& layer_;
  const Exact_side& exact_side_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_PIECE_WALK_H
