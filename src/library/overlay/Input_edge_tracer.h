// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Input edges followed through the intrinsic triangles.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OVERLAY_INPUT_EDGE_TRACER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OVERLAY_INPUT_EDGE_TRACER_H

#include <CGAL/Intrinsic_triangulations/internal/engine/history/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Input_edge_walk.h>
#include <CGAL/Intrinsic_triangulations/internal/overlay/Overlay_arrays.h>

#include <cstdint>

namespace CGAL::Intrinsic_triangulations::internal {

// Reads the integers only, so any number of threads may trace at once. Crossings are counted by the numbers of
// segments, which lie side by side in memory.
class Input_edge_tracer
{
public:
  // Where an input edge comes from the left of an intrinsic halfedge: `position` counts the
  // crossings of that edge from its halfedge 2e.
  struct Crossing
  {
    Halfedge_index halfedge;
    std::int64_t position;
  };

  // The end of an input edge in the corner opposite to ij, and how many input edges end there within the triangle.
  struct End
  {
    Halfedge_index ij;
    std::int64_t count;
  };

  // \param overlay must have numbered the segments of intrinsic edges before the first edge is traced
  Input_edge_tracer(const Delta_complex& intrinsic, const Correspondence& correspondence, const Overlay_arrays& overlay)
    : intrinsic_(intrinsic), correspondence_(correspondence), input_(correspondence.input()), overlay_(overlay)
  {}

  // The vertex where an input edge ends, or a vertex inserted on it.
  Vertex_index vertex(const End& end) const { return intrinsic_.target(intrinsic_.next(end.ij)); }

  std::int64_t number_of_crossings(Halfedge_index h) const
  {
    const Overlay_arrays::size_type e = intrinsic_.edge(h).idx();
    return std::int64_t(overlay_.intrinsic_segments_end(e)) - overlay_.first_segments[e] - 1;
  }
  // The triangle to the left of ij.
  Triangle_crossings triangle_crossings(Halfedge_index ij) const
  {
    return Triangle_crossings(number_of_crossings(ij), number_of_crossings(intrinsic_.next(ij)),
                              number_of_crossings(intrinsic_.prev(ij)));
  }

  // Calls function(h, source, position) for the input halfedges h, those numbered 2e, that cross the intrinsic edge e
  // next to their source or an inserted vertex on them, at a position counted from the source of `source.ij`.
  template <class Function>
  void for_each_path_across(Edge_index e, const Function& function) const
  {
    const Halfedge_index first = intrinsic_.halfedge(e);
    if (number_of_crossings(first) == 0)
      return;
    for (Halfedge_index ij : {first, intrinsic_.opposite(first)}) {
      const Triangle_crossings t = triangle_crossings(ij);
      std::int64_t position = t.c_i;
      for_each_start(intrinsic_, correspondence_, intrinsic_.prev(ij), t.e_k, [&](Halfedge_index h) {
        if (h == input_.halfedge(input_.edge(h)))
          function(h, End{ij, t.e_k}, position);
        ++position;
      });
    }
  }

  // Visits the crossings of the input halfedge that comes from the corner opposite to ij and crosses
  // it at a position, counted from i. Returns where it ends.
  template <class Function>
  End follow(Halfedge_index ij, std::int64_t position, const Function& visit) const
  {
    while (true) {
      // It leaves the triangle to the left of ij at `position`, counted from i.
      const std::int64_t n = number_of_crossings(ij);
      const bool is_first_halfedge = ij == intrinsic_.halfedge(intrinsic_.edge(ij));
      visit(Crossing{ij, is_first_halfedge ? position : n - 1 - position});
      const Halfedge_index ji = intrinsic_.opposite(ij);
      position = n - 1 - position;
      const Triangle_crossings t = triangle_crossings(ji);
      if (position < t.c_i) { // around the source of ji
        ij = intrinsic_.prev(ji);
        position = number_of_crossings(ij) - 1 - position;
      } else if (position < t.c_i + t.e_k) {
        return {ji, t.e_k};
      } else { // around its target
        ij = intrinsic_.next(ji);
        position = n - 1 - position;
      }
    }
  }

private:
  const Delta_complex& intrinsic_;
  const Correspondence& correspondence_;
  const Delta_complex& input_;
  const Overlay_arrays& overlay_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OVERLAY_INPUT_EDGE_TRACER_H
