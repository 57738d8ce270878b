// SPDX-License-Identifier: GPL-3.0-or-later

#include "find_overlay.h"

#include <CGAL/Intrinsic_triangulations/errors.h>

#include <string>
#include <utility>

namespace idt {

void find_overlay(const CGAL::Intrinsic_triangulations::Delta_complex& complex,
                  const CGAL::Intrinsic_triangulations::Exact_geometry& geometry, Outcome& outcome)
{
  namespace IT = CGAL::Intrinsic_triangulations;
  try {
    IT::Overlay graph(complex, geometry.correspondence());
    IT::Overlay_positions positions(complex, geometry, graph);
    outcome.overlay.emplace(Overlay_result{std::move(graph), std::move(positions)});
  } catch (const IT::Error& error) {
    if (outcome.failure.empty())
      outcome.failure = std::string("there is no overlay: ") + error.what();
  }
}

} // namespace idt
