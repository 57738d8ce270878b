// SPDX-License-Identifier: GPL-3.0-or-later

#include "Triangulation_result.h"

#include "text.h"

namespace idt {

void write_edges(std::ostream& os, const Triangulation_result& result)
{
  namespace IT = CGAL::Intrinsic_triangulations;
  const Outcome& outcome = result.outcome;
  os << "source,target,length,cotan_weight,crossings,original\n";
  for (IT::Edge_index e : outcome.connectivity.edges()) {
    const IT::Halfedge_index h = outcome.connectivity.halfedge(e);
    const bool is_original = outcome.is_original[e.idx()] != 0;
    // An input edge crosses no input edge; for the others only the overlay knows.
    os << outcome.connectivity.source(h).idx() << ',' << outcome.connectivity.target(h).idx()
       << ',' << in_full(outcome.lengths[e.idx()]) << ',' << in_full(outcome.weights[e.idx()])
       << ',' << (is_original ? "0" : "") << ',' << (is_original ? '1' : '0') << '\n';
    if (!os)
      return; // the disk is full: the caller finds out
  }
}

} // namespace idt
