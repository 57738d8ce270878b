// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/Triangulation_result.h"

#include "system/Long_text.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace idt {

void write_edges(std::ostream& os, const Triangulation_result& result)
{
  namespace IT = CGAL::Intrinsic_triangulations;
  const Outcome& outcome = result.outcome;
  os << "source,target,length,cotan_weight,crossings,original\n";
  write_elements(os, outcome.connectivity.number_of_edges(), [&outcome](Long_text& text, std::size_t e) {
    const IT::Edge_index edge(static_cast<std::uint32_t>(e));
    const IT::Halfedge_index h = outcome.connectivity.halfedge(edge);
    text << outcome.connectivity.source(h).idx() << ',' << outcome.connectivity.target(h).idx() << ','
         << outcome.numbers.lengths[e] << ',';
    if (std::isfinite(outcome.numbers.cotangent_weights[e])) // beside a face of zero area there is no cotangent
      text << outcome.numbers.cotangent_weights[e];
    text << ',';
    if (outcome.original_crossings) {
      const auto& crossings = *outcome.original_crossings;
      text << crossings.number_of_crossings(edge).str() << ',' << (crossings.is_original(edge) ? '1' : '0') << '\n';
    } else if (e < outcome.crossings.size()) {
      const std::int64_t crossings = outcome.crossings[e];
      text << (crossings < 0 ? 0 : crossings) << ',' << (crossings < 0 ? '1' : '0') << '\n';
    } else {
      text << ",\n"; // more crossings than can be counted
    }
  });
}

} // namespace idt
