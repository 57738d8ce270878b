// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Incremental_overlay.h.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OVERLAY_ARE_SAME_OVERLAY_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OVERLAY_ARE_SAME_OVERLAY_IMPL_H

#include <CGAL/Intrinsic_triangulations/internal/config.h>

#include <cstdint>
#include <iostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

namespace internal {

CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::string difference_of_overlays(const Overlay& overlay,
                                                                        const Incremental_overlay& incremental)
{
  using Halfedge = Overlay::Halfedge;
  using Vertex = Overlay::Vertex;
  if (overlay.number_of_intrinsic_edges() != incremental.intrinsic().number_of_edges())
    return "they are of different surfaces";
  std::vector<Vertex> in_incremental(overlay.number_of_vertices());
  for (Edge_index e : incremental.intrinsic().edges()) {
    const auto edge = [&](const char* what) { return "intrinsic edge " + std::to_string(e.idx()) + what; };
    Halfedge part = incremental.first_part(incremental.intrinsic().halfedge(e));
    if (overlay.input_halfedge(overlay.halfedge(*overlay.intrinsic_segments(e).begin())) !=
        incremental.input_halfedge(part))
      return edge(" does not coincide with the same input halfedge");
    for (Vertex x : overlay.intrinsic_crossings(e)) {
      if (!incremental.is_crossing(incremental.target(part)) ||
          overlay.crossing_input_halfedge(x) != incremental.input_halfedge(incremental.next(part)))
        return edge(" does not cross the same input halfedges");
      in_incremental[x.idx()] = incremental.target(part);
      part = incremental.straight_on(part);
    }
    if (incremental.is_crossing(incremental.target(part)))
      return edge(" does not cross the same number of input edges");
  }
  for (Edge_index e : incremental.input().edges()) {
    const auto edge = [&](const char* what) { return "input edge " + std::to_string(e.idx()) + what; };
    Halfedge part = incremental.first_part_in_input(incremental.input().halfedge(e));
    for (std::uint32_t i = 0; i + 1 < overlay.number_of_input_segments(e); ++i) {
      if (in_incremental[overlay.input_crossing(e, i).idx()] != incremental.target(part))
        return edge(" does not have the same crossings");
      part = incremental.straight_on(part);
    }
    if (incremental.is_crossing(incremental.target(part)))
      return edge(" does not have the same number of crossings");
  }
  return std::string();
}

} // namespace internal

CGAL_INTRINSIC_TRIANGULATIONS_INLINE bool are_same_overlay(const Overlay& overlay,
                                                           const Incremental_overlay& incremental, bool verbose)
{
  const std::string difference = internal::difference_of_overlays(overlay, incremental);
  if (verbose && !difference.empty())
    std::cerr << "are_same_overlay: " << difference << std::endl;
  return difference.empty();
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OVERLAY_ARE_SAME_OVERLAY_IMPL_H
