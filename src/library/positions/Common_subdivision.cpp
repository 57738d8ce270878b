// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The overlay and its positions; and the triangulation of a convex polygon.

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/convex_polygon_triangulation.h>

#include <array>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

Common_subdivision::Common_subdivision(internal::Released_engine released, const Progress_function& progress,
                                       const internal::Block_runner& threads)
  : engine_(std::move(released.engine)), overlay_(build_overlay(released.go_further, progress, threads)),
    positions_(engine_, overlay_, internal::part_of_progress(progress, part_of_graph, 1), threads)
{
  engine_.decisions().interruption.exchange({});
}

Overlay Common_subdivision::build_overlay(const std::function<bool()>& go_further, const Progress_function& progress,
                                          const internal::Block_runner& threads)
{
  engine_.decisions().interruption.exchange(go_further);
  if (threads)
    engine_.prepare(threads);
  engine_.prepare();
  return Overlay(engine_.connectivity(), engine_.correspondence(),
                 internal::part_of_progress(progress, 0, part_of_graph), threads);
}

std::vector<std::array<std::size_t, 3>> triangulate_convex_polygon(const std::vector<std::array<double, 3>>& corners)
{
  std::vector<std::array<std::size_t, 3>> result;
  internal::Convex_polygon_triangulation(corners).for_each_triangle([&](std::size_t a, std::size_t b, std::size_t c) {
    result.push_back({a, b, c});
  });
  return result;
}

} // namespace CGAL::Intrinsic_triangulations
