// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "kernels/find_overlay.h"

#include <CGAL/Intrinsic_triangulations/errors.h>

#include <string>

namespace idt {

void find_overlay(const CGAL::Intrinsic_triangulations::Delta_complex& complex,
                  const CGAL::Intrinsic_triangulations::Exact_geometry& geometry,
                  const CGAL::Intrinsic_triangulations::Progress_function& progress,
                  Outcome& outcome)
{
  namespace IT = CGAL::Intrinsic_triangulations;
  try {
    outcome.subdivision.emplace(complex, geometry, progress);
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
