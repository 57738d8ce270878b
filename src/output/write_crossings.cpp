// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/Triangulation_result.h"

#include "system/Long_text.h"

#include <cstddef>
#include <cstdint>

namespace idt {

void write_crossings(std::ostream& os, const Triangulation_result& result)
{
  namespace IT = CGAL::Intrinsic_triangulations;
  const IT::Delta_complex &intrinsic = result.outcome.connectivity, &input = result.surface.connectivity;
  const IT::Overlay& overlay = result.outcome.subdivision->overlay();
  const IT::Overlay_positions& positions = result.outcome.subdivision->positions();
  os << "source,target,edge,position,input_source,input_target,t,u\n";
  write_elements(os, intrinsic.number_of_edges(), [&](Long_text& text, std::size_t i) {
    const IT::Edge_index e(static_cast<std::uint32_t>(i));
    const IT::Halfedge_index h = intrinsic.halfedge(e);
    for (IT::Overlay::Vertex x : overlay.intrinsic_crossings(e)) {
      const IT::Halfedge_index g = input.halfedge(overlay.input_edge(x));
      text << intrinsic.source(h).idx() << ',' << intrinsic.target(h).idx() << ',' << e.idx() << ','
           << overlay.intrinsic_position(x) << ',' << input.source(g).idx() << ',' << input.target(g).idx() << ','
           << positions.on_intrinsic_edge(x) << ',' << positions.on_input_edge(x) << '\n';
    }
  });
}

} // namespace idt
