// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "kernels/find_overlay.h"

#include <CGAL/Intrinsic_triangulations/errors.h>

#include <string>
#include <utility>

namespace idt {

void find_overlay(const CGAL::Intrinsic_triangulations::Delta_complex& complex,
                  const CGAL::Intrinsic_triangulations::Exact_geometry& geometry,
                  const CGAL::Intrinsic_triangulations::Progress_function& progress,
                  Outcome& outcome)
{
  namespace IT = CGAL::Intrinsic_triangulations;
  // The places take longer than the graph.
  const auto part = [&progress](double begin, double length) {
    return progress ? IT::Progress_function([&progress, begin, length](double fraction) {
      return progress(begin + length * fraction);
    })
                    : IT::Progress_function();
  };
  try {
    IT::Overlay graph(complex, geometry.correspondence(), part(0, 0.3));
    IT::Overlay_positions positions(complex, geometry, graph, part(0.3, 0.7));
    outcome.overlay.emplace(Overlay_result{std::move(graph), std::move(positions)});
  } catch (const IT::Cancelled_error& error) {
    outcome.is_interrupted = true;
    if (outcome.failure.empty())
      outcome.failure = std::string("there is no overlay: ") + error.what();
  } catch (const IT::Error& error) {
    if (outcome.failure.empty())
      outcome.failure = std::string("there is no overlay: ") + error.what();
  }
}

} // namespace idt
