// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/Triangulation_result.h"

#include "system/text.h"

#include <cmath>
#include <cstdint>
#include <string>

namespace idt {
namespace {

// Beside a face of zero area there is no cotangent.
std::string finite(double x) { return std::isfinite(x) ? in_full(x) : std::string(); }

} // namespace

void write_edges(std::ostream& os, const Triangulation_result& result)
{
  namespace IT = CGAL::Intrinsic_triangulations;
  const Outcome& outcome = result.outcome;
  os << "source,target,length,cotan_weight,crossings,original\n";
  for (IT::Edge_index e : outcome.connectivity.edges()) {
    const IT::Halfedge_index h = outcome.connectivity.halfedge(e);
    os << outcome.connectivity.source(h).idx() << ',' << outcome.connectivity.target(h).idx()
       << ',' << in_full(outcome.numbers.lengths[e.idx()]) << ',' << finite(outcome.numbers.weights[e.idx()]) << ',';
    if (outcome.original_crossings) {
      const auto& crossings = *outcome.original_crossings;
      os << crossings.number_of_crossings(e) << ',' << (crossings.is_original(e) ? '1' : '0') << '\n';
    } else if (e.idx() < outcome.crossings.size()) {
      const std::int64_t crossings = outcome.crossings[e.idx()];
      os << (crossings < 0 ? 0 : crossings) << ',' << (crossings < 0 ? '1' : '0') << '\n';
    } else {
      os << ",\n"; // more crossings than could be counted
    }
    if (!os)
      return; // the disk is full: the caller finds out
  }
}

} // namespace idt
