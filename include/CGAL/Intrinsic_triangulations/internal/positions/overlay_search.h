// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Finds the face of the overlay that contains a point of one of the triangulations.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_OVERLAY_SEARCH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_OVERLAY_SEARCH_H

#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/internal/positions/overlay_layers.h>

#include <CGAL/assertions.h>
#include <CGAL/enum.h>

#include <boost/container/static_vector.hpp>

#include <cstdint>
#include <limits>
#include <optional>
#include <unordered_set>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The edges of the other triangulation cut a face into slices by chords that do not meet. The numbers of crossings
// alone determine how many chords join which sides, as for normal coordinates. The chords that cross one side are
// ordered along it, and a point lies to the right of all of them up to some position, so bisection needs no stored
// data.
template <class Layer>
class Chord_search
{
public:
  // The location of a point: the face of the overlay to the left of `part`, a part of a side of the face, or the chord
  // after it.
  struct Result
  {
    Overlay::Halfedge part;
    bool is_on_chord;
  };

  Chord_search(const Layer& layer, const Surface_point& point) : layer_(layer), point_(point) {}

  Result operator()() const
  {
    Halfedge_index ij = most_crossed_side();
    Overlay::Halfedge middle;
    for (int side = 0; side < 3; ++side, ij = layer_.complex.next(ij)) {
      // These chords cut off corner i, or run to corner k, which the chords of only one side do.
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
    const auto [p_0, p_1, p_2] = coordinates_from(layer_.complex, point_, ij);
    const double a = layer_.on_side(part);
    const Coordinates y = corner_coordinates(layer_, layer_.overlay.next(part), ij);
    // The determinant of the ends (1 − a, a, 0) and y of the chord and of the point.
    const double sum = p_0 * (a * y[2]) - p_1 * ((1 - a) * y[2]) + p_2 * ((1 - a) * y[1] - a * y[0]);
    // Positions are accurate to 2^-52 of their edge, and so are their distances from 1. An error of 2^-52 in one factor
    // is multiplied by the other one; as much again covers the rounding here.
    const double error = 0x1p-50 * (p_0 * (a + y[2]) + p_1 * (1 - a + y[2]) + p_2 * (1 + y[0] + y[1])) +
                         (std::numeric_limits<double>::min)();
    if (sum > error)
      return POSITIVE;
    if (sum < -error)
      return NEGATIVE;
    const std::optional<Sign> exact = layer_.side_of_chord(part, point_);
    return exact ? *exact : sum >= 0 ? POSITIVE : NEGATIVE;
  }

  const Layer& layer_;
  const Surface_point& point_;
};

// In an input face with inserted vertices, chords begin and end anywhere, so there is no order for a search. The walk
// goes from piece to piece across chords with the point on their other side, and visits each piece once: where it would
// run in circles, it becomes a search through all pieces.
class Piece_walk
{
public:
  struct Result
  {
    Overlay::Face face;
    // The sides before chords that contain the point: none, one, or two that meet at an inserted vertex.
    boost::container::static_vector<Overlay::Halfedge, 6> before_chords;
  };

  explicit Piece_walk(const Input_layer& layer) : layer_(layer) {}

  Result operator()(const Surface_point& point) const;

private:
  // On which side of the chord after `side` a point lies. In a face without area all points are on the left.
  Sign side_of_chord(Overlay::Halfedge before, const Surface_point& point) const;

  const Input_layer& layer_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_OVERLAY_SEARCH_H
