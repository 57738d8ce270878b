// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Where input edges begin around a vertex, and which of them crosses an edge at a place.

#include <CGAL/Intrinsic_triangulations/internal/engine/history/Input_edge_walk.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <cstdint>

namespace CGAL::Intrinsic_triangulations::internal {

Input_edge_start start_of_input_edge(const Delta_complex& complex, const Correspondence& correspondence, Vertex_index v,
                                     Halfedge_index input_halfedge)
{
  const Normal_coordinates& coordinates = correspondence.coordinates();
  const Halfedge_index first = complex.opposite(complex.halfedge(v));
  for (Halfedge_index ki = first;;) {
    // Counterclockwise from ki: ki itself if it coincides with an input halfedge, then those that cross the opposite
    // side.
    Halfedge_index start = correspondence.input_halfedge(ki);
    if (coordinates.is_original(complex.edge(ki))) {
      if (start == input_halfedge)
        return {ki, -1};
      if (start.is_valid() && !complex.is_border(ki))
        start = next_input_halfedge(correspondence, v, start);
    }
    if (!complex.is_border(ki)) {
      const Halfedge_index ij = complex.next(ki);
      const Triangle_crossings t = coordinates.triangle_crossings(complex, ij);
      for (std::int64_t i = 0; i < t.e_k; ++i) {
        if (start == input_halfedge)
          return {ij, t.c_i + i};
        start = next_input_halfedge(correspondence, v, start);
      }
    }
    ki = complex.next_around_source(ki);
    CGAL_assertion(ki != first);
  }
}

Face_index uncrossed_input_face(const Delta_complex& complex, const Correspondence& correspondence, Halfedge_index h)
{
  const Delta_complex& input = correspondence.input();
  const Halfedge_index roundabout = correspondence.input_halfedge(h);
  if (!roundabout.is_valid())
    return input.face(correspondence.location(complex.source(h)).halfedge);
  return input.face(correspondence.coordinates().is_original(complex.edge(h)) ? roundabout
                                                                              : input.opposite(roundabout));
}

Halfedge_index crossed_input_halfedge(const Delta_complex& complex, const Correspondence& correspondence,
                                      Halfedge_index h, std::int64_t position, const Interruption& interruption)
{
  const std::int64_t n = correspondence.coordinates().number_of_crossings(complex.edge(h));
  CGAL_precondition(position < n);
  Input_edge_walk to_left(complex, correspondence, h, position),
    to_right(complex, correspondence, complex.opposite(h), n - 1 - position);
  for (std::size_t step = 0;; ++step) {
    if (step % 1024 == 1023)
      interruption.check();
    if (to_left.step())
      return to_left.end();
    if (to_right.step())
      return correspondence.input().opposite(to_right.end());
  }
}

} // namespace CGAL::Intrinsic_triangulations::internal
