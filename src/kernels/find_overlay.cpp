// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "kernels/find_overlay.h"

#include "system/Stopwatch.h"

#include <CGAL/Intrinsic_triangulations/errors.h>

#include <string>

namespace idt {

void find_overlay(const std::function<CGAL::Intrinsic_triangulations::Common_subdivision(
                    const CGAL::Intrinsic_triangulations::Progress_function&)>& subdivide,
                  const CGAL::Intrinsic_triangulations::Progress_function& progress,
                  Outcome& outcome)
{
  namespace IT = CGAL::Intrinsic_triangulations;
  const Stopwatch stopwatch;
  double graph_seconds = 0;
  const auto note_time = [&](double fraction) {
    if (fraction <= IT::Common_subdivision::part_of_graph)
      graph_seconds = stopwatch.seconds();
    return !progress || progress(fraction);
  };
  try {
    outcome.subdivision.emplace(subdivide(note_time));
    outcome.crossing_summary->position_seconds = stopwatch.seconds() - graph_seconds;
    outcome.crossing_summary->seconds += graph_seconds;
  } catch (const IT::Cancelled_error& error) {
    outcome.is_interrupted = true;
    if (outcome.failure.empty())
      outcome.failure = std::string("there is no overlay: ") + error.what();
  } catch (const IT::Error& error) {
    if (outcome.failure.empty())
      outcome.failure = std::string("there is no overlay: ") + error.what();
  }
  if (!outcome.subdivision)
    outcome.crossing_summary->seconds += stopwatch.seconds();
}

} // namespace idt
