// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/Triangulation_result.h"

#include "system/text.h"

namespace idt {

void write_crossings(std::ostream& os, const Triangulation_result& result)
{
  namespace IT = CGAL::Intrinsic_triangulations;
  const IT::Delta_complex &intrinsic = result.outcome.connectivity,
                          &input = result.surface.connectivity;
  const IT::Overlay& overlay = result.outcome.subdivision->overlay();
  const IT::Overlay_positions& positions = result.outcome.subdivision->positions();
  os << "source,target,edge,position,input_source,input_target,t,u\n";
  for (IT::Edge_index e : intrinsic.edges()) {
    const IT::Halfedge_index h = intrinsic.halfedge(e);
    for (IT::Overlay::Vertex x : overlay.intrinsic_crossings(e)) {
      const IT::Halfedge_index g = input.halfedge(overlay.input_edge(x));
      os << intrinsic.source(h).idx() << ',' << intrinsic.target(h).idx() << ',' << e.idx() << ','
         << overlay.intrinsic_position(x) << ',' << input.source(g).idx() << ','
         << input.target(g).idx() << ',' << in_full(positions.on_intrinsic_edge(x)) << ','
         << in_full(positions.on_input_edge(x)) << '\n';
    }
    if (!os)
      return; // the disk is full: the caller finds out
  }
}

} // namespace idt
