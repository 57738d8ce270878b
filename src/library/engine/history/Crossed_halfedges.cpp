// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The input halfedges that an edge crosses: looked up, or found by the turns of its strip.

#include <CGAL/Intrinsic_triangulations/internal/engine/history/Crossed_halfedges.h>
#include "Crossing_sequence.h"
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Input_edge_walk.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <optional>

namespace CGAL::Intrinsic_triangulations::internal {

Crossed_halfedges::Crossed_halfedges(const Delta_complex& complex, const Correspondence& correspondence,
                                     Halfedge_index h, const Interruption& interruption)
{
  const Delta_complex& input = correspondence.input();
  const auto n = std::size_t(correspondence.coordinates().number_of_crossings(complex.edge(h)));
  CGAL_precondition(n > 0);
  const Kept_crossings& kept = correspondence.kept_crossings();
  if (const std::optional<Crossed_range> range = kept.find(h, n)) {
    crossed_ = *range;
    return;
  }
  const bool leaves_corner = !correspondence.is_inserted(complex.source(h));
  Halfedge_index g = leaves_corner ? input.opposite(input.prev(input.opposite(correspondence.input_halfedge(h))))
                                   : crossed_input_halfedge(complex, correspondence, h, 0, interruption);
  own_.push_back(g);
  if (n > 1) {
    const Crossing_sequence sequence(complex, correspondence, h, interruption);
    own_.reserve(n);
    for (std::size_t i = 0; i + 1 < n; ++i) {
      g = input.opposite(sequence.turns_left(i) ? input.prev(g) : input.next(g));
      own_.push_back(g);
    }
  }
  crossed_ = Crossed_range(own_.data(), n, false);
  // Around inserted vertices, input edges may have to be followed far.
  if (n > few || correspondence.number_of_inserted_vertices() != 0)
    kept.keep(complex.number_of_edges(), h, crossed_);
}

} // namespace CGAL::Intrinsic_triangulations::internal
