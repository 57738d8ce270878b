// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The waves of all faces: the windows that enter them, and the ways from their corners and from sources in them.

#include <CGAL/Intrinsic_triangulations/internal/distances/Window_propagation.h>

#include "wave_functions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

Wave wave_of(const Laid_out_faces& surface, const Face_source& source)
{
  const std::array<plane::Vector, 2> side = side_in_plane(surface, source.side);
  const auto place = [&side](const plane::Vector& p) -> plane::Vector {
    return {side[0][0] + p[0] * side[1][0] - p[1] * side[1][1], side[0][1] + p[0] * side[1][1] + p[1] * side[1][0]};
  };
  Wave wave{source.side / 3, source.number, source.is_point() ? Wave::ALL_AROUND : Wave::SEGMENT};
  wave.from = place(source.from);
  wave.sigma = source.offset;
  wave.ends = {wave.from, place(source.to())};
  return wave;
}

} // namespace

Waves find_waves(const Laid_out_faces& surface, double tolerance, const Window_sources& sources, std::uint64_t most,
                 const Interruption& interruption, double farthest)
{
  Waves result;
  const Window_distances found =
    propagate_windows(surface, tolerance, sources, most, interruption, {}, farthest, &result.waves);
  result.number_of_steps = found.number_of_steps;
  result.is_complete = found.is_complete;
  for (const Face_source& source : sources.in_faces)
    result.waves.push_back(wave_of(surface, source));
  for (std::uint32_t side = 0; side < surface.sides().size(); ++side) {
    const std::uint32_t row = surface.side(side).row;
    if (std::isfinite(found.distances[row])) {
      Wave wave{side / 3, found.origins[row], Wave::ALL_AROUND};
      wave.from = side_in_plane(surface, side)[0];
      wave.sigma = found.distances[row];
      result.waves.push_back(wave);
    }
  }
  std::stable_sort(result.waves.begin(), result.waves.end(),
                   [](const Wave& a, const Wave& b) { return a.face < b.face; });
  result.first.assign(surface.sides().size() / 3 + 1, 0);
  for (const Wave& wave : result.waves)
    ++result.first[wave.face + 1];
  for (std::size_t f = 0; f + 1 < result.first.size(); ++f)
    result.first[f + 1] += result.first[f];
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal
