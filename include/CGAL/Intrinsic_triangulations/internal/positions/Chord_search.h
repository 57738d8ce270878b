// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Finds the face of the overlay that contains a point of one of the triangulations.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_CHORD_SEARCH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_CHORD_SEARCH_H

#include <CGAL/Intrinsic_triangulations/internal/engine/history/Normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/positions/overlay_layers.h>

#include <CGAL/enum.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

namespace CGAL::Intrinsic_triangulations::internal {

// The edges of the other triangulation cut a face into slices by chords that do not meet. How many
// chords join which sides follows from the numbers of crossings alone, as for normal
// coordinates; the chords that cross one side are ordered along it, and a point lies to the
// right of all of them up to some place. So nothing needs to be stored to search by bisection.
template <class Layer, class ExactSide>
class Chord_search
{
public:
  // What a point lies on: the face of the overlay to the left of `part`, a part of a side of the
  // face, or the chord after it.
  struct Result
  {
    Overlay::Halfedge part;
    bool is_on_chord;
  };

  // `exact_side(chord, side, point)` gives the side of the point of a chord that begins on `side`,
  // or nothing if the face has no area and there is none.
  Chord_search(const Layer& layer, const ExactSide& exact_side, const Surface_point& point)
    : layer_(layer), exact_side_(exact_side), point_(point)
  {}

  Result operator()() const
  {
    Halfedge_index ij = most_crossed_side();
    Overlay::Halfedge middle;
    for (int side = 0; side < 3; ++side, ij = layer_.complex.next(ij)) {
      // These chords cut corner i off, or run to corner k, which those of only one side do.
      const Triangle_crossings t = crossings(ij);
      const std::int64_t end = t.c_i + t.e_k;
      if (side == 0)
        middle = layer_.part(ij, end);
      std::int64_t first = 0, last = end;
      while (first < last) {
        const std::int64_t position = first + (last - first) / 2;
        const Overlay::Halfedge part = layer_.part(ij, position);
        const Sign sign = side_of_chord(ij, part);
        if (sign == ZERO)
          return {part, true};
        if (sign == POSITIVE)
          last = position;
        else
          first = position + 1;
      }
      if (first < end)
        return {layer_.part(ij, first), false};
    }
    return {middle, false};
  }

private:
  Triangle_crossings crossings(Halfedge_index ij) const
  {
    const Delta_complex& c = layer_.complex;
    return Triangle_crossings(layer_.number_of_crossings(c.edge(ij)), layer_.number_of_crossings(c.edge(c.next(ij))),
                              layer_.number_of_crossings(c.edge(c.prev(ij))));
  }

  Halfedge_index most_crossed_side() const
  {
    const Delta_complex& c = layer_.complex;
    Halfedge_index result = point_.halfedge;
    for (Halfedge_index h : {c.next(point_.halfedge), c.prev(point_.halfedge)})
      if (layer_.number_of_crossings(c.edge(h)) > layer_.number_of_crossings(c.edge(result)))
        result = h;
    return result;
  }

  // The side of the point of the chord that begins where `part` ends, on side ij.
  Sign side_of_chord(Halfedge_index ij, Overlay::Halfedge part) const
  {
    const Overlay::Halfedge chord = layer_.overlay.next(part);
    const std::size_t i = side_number(layer_.complex, point_.halfedge, ij);
    const double p_0 = point_.coordinates[i], p_1 = point_.coordinates[(i + 1) % 3],
                 p_2 = point_.coordinates[(i + 2) % 3];
    const double a = layer_.on_side(part);
    const Coordinates y = corner_coordinates(layer_, chord, ij);
    // The determinant of the ends (1 − a, a, 0) and y of the chord and of the point.
    const double sum = p_0 * (a * y[2]) - p_1 * ((1 - a) * y[2]) + p_2 * ((1 - a) * y[1] - a * y[0]);
    // Positions are good to 2^-52 of their edge, and so are their distances from 1. An error of
    // 2^-52 in one factor counts with the other one; as much again covers the rounding here.
    const double error = 0x1p-50 * (p_0 * (a + y[2]) + p_1 * (1 - a + y[2]) + p_2 * (1 + y[0] + y[1])) +
                         (std::numeric_limits<double>::min)();
    if (sum > error)
      return POSITIVE;
    if (sum < -error)
      return NEGATIVE;
    const std::optional<Sign> exact = exact_side_(chord, ij, point_);
    return exact ? *exact : sum >= 0 ? POSITIVE : NEGATIVE;
  }

  const Layer& layer_;
  const ExactSide& exact_side_;
  const Surface_point& point_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_CHORD_SEARCH_H
