// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Overlay_positions.

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include "Crossing_locator.h"

#include <algorithm>

namespace CGAL::Intrinsic_triangulations {

void Overlay_positions::find_crossings(const internal::Exact_engine& engine, const Overlay& overlay, std::size_t first,
                                       std::size_t last, const internal::Loop_progress& progress)
{
  const Delta_complex& intrinsic = engine.connectivity();
  const internal::Surface_lease surface = engine.input_surface();
  const Delta_complex& input = engine.correspondence().input();
  internal::Crossing_locator locate(intrinsic, engine.correspondence(), *surface);
  internal::Crossed_edges crossed;
  for (std::size_t i = first; i < last; ++i) {
    progress.at(i);
    const Edge_index e{size_type(i)};
    const Overlay::Range<Overlay::Vertex> crossings = overlay.intrinsic_crossings(e);
    if (crossings.empty())
      continue;
    internal::find_crossed_edges(overlay, input, crossings, crossed);
    double before = 0;
    auto x = crossings.begin();
    for (const internal::Position_on_edges& position : locate(e, crossed)) {
      on_intrinsic_edge_[index(*x)] = before = (std::max)(before, position.on_intrinsic_edge);
      on_input_edge_[index(*x)] = position.on_input_edge;
      ++x;
    }
  }
}

} // namespace CGAL::Intrinsic_triangulations
