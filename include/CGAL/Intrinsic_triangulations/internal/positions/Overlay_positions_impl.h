// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Overlay_positions.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_OVERLAY_POSITIONS_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_OVERLAY_POSITIONS_IMPL_H

#include <CGAL/Intrinsic_triangulations/Overlay_positions.h>
#include <CGAL/Intrinsic_triangulations/internal/positions/Crossing_locator.h>

#include <algorithm>

namespace CGAL {
namespace Intrinsic_triangulations {

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
void Overlay_positions::find_crossings(const Delta_complex& intrinsic, const Exact_geometry& geometry, const Overlay& overlay,
                                       std::size_t first, std::size_t last, const internal::Loop_progress& progress)
{
  const Exact_geometry::Surface_lease surface = geometry.input_surface();
  internal::Crossing_locator locate(intrinsic, geometry.correspondence(), *surface, overlay);
  for (std::size_t i = first; i < last; ++i) {
    progress.at(i);
    const Edge_index e{size_type(i)};
    if (overlay.intrinsic_crossings(e).empty())
      continue;
    double before = 0;
    locate(e, [&](Overlay::Vertex x, double on_intrinsic_edge, double on_input_edge) {
      on_intrinsic_edge_[index(x)] = before = (std::max)(before, on_intrinsic_edge);
      on_input_edge_[index(x)] = on_input_edge;
    });
  }
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_OVERLAY_POSITIONS_IMPL_H
