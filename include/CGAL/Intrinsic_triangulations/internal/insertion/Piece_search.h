// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// In which piece of the current triangles a point of the input lies.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_PIECE_SEARCH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_PIECE_SEARCH_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Input_edge_walk.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>

#include <CGAL/enum.h>

#include <cstddef>
#include <optional>

namespace CGAL::Intrinsic_triangulations::internal {

// The piece that contains a point which lies strictly inside an input face; one of two if an edge runs through it.
//
// Intrinsic edges cut an input face into pieces by chords that do not meet. So the search walks from piece to piece,
// each time across a chord that has the point on its other side, and comes to an end: the pieces and their
// chords form a tree.
// \param start a piece of the same input face
inline Triangle_piece piece_of_point(const Exact_engine& engine, Triangle_piece start, const Surface_point& point)
{
  const Delta_complex& complex = engine.connectivity();
  const Normal_coordinates& coordinates = engine.correspondence().coordinates();
  for (std::size_t step = 0;; ++step) {
    if (step % 1024 == 1023)
      engine.decisions().interruption.check();
    std::optional<Triangle_piece> next;
    const auto names = coordinates.names(complex, start);
    for (std::size_t i = step == 0 ? 0 : 1; i < names.size() && !next; ++i) { // not back across the first
      const Triangle_piece& name = names[i];
      // A side that coincides with an input edge has the whole input face on one side.
      if (!name.side.is_valid() || coordinates.is_original(complex.edge(name.side)))
        continue;
      if (engine.side_of(name.side, name.gap, point) == NEGATIVE)
        next = Triangle_piece{complex.opposite(name.side),
                              coordinates.number_of_crossings(complex.edge(name.side)) - name.gap};
    }
    if (!next)
      return start;
    start = *next;
  }
}

// The piece at the source of an input halfedge, to the left of that. O(number of edges around the source).
inline Triangle_piece piece_at_source(const Delta_complex& complex, const Correspondence& correspondence,
                                      Halfedge_index input_halfedge)
{
  const auto [side, position] =
    start_of_input_edge(complex, correspondence, correspondence.input().source(input_halfedge), input_halfedge);
  return {side, position + 1};
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_PIECE_SEARCH_H
