// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Distances by windows between their bounds.

#include <CGAL/Intrinsic_triangulations/internal/distances/Distance_search.h>

#include "First_ways.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// Distances within the faces of the sources, in the unit of the faces.
Distances_near_sources known_distances(const Laid_out_faces& faces, const Window_sources& sources)
{
  Distances_near_sources result;
  const auto add = [&](std::uint32_t row, double distance) {
    const auto [known, is_new] = result.of_rows.insert({row, distance});
    known->second = (std::min)(known->second, distance);
  };
  for (const Row_source& source : sources.rows)
    add(source.row, source.offset);
  for (const Face_source& source : sources.in_faces)
    for (const First_ways::To_corner& way : first_ways(faces, source).to_corners)
      add(faces.side(way.side).row, way.distance);
  for (const Face_source& source : sources.in_faces) {
    const Laid_out_faces::Side& base = faces.side(source.side);
    const std::array<std::array<double, 2>, 3> corners{{{0, 0}, {base.length, 0}, {base.apex_x, base.apex_y}}};
    std::uint32_t side = source.side;
    for (std::size_t i = 0; i < 3; ++i, side = Laid_out_faces::next(side))
      for (const auto& end : {source.from, source.to()})
        result.farther = (std::max)(result.farther, length_of(corners[i][0] - end[0], corners[i][1] - end[1]) -
                                                      result.of_rows.at(faces.side(side).row));
  }
  return result;
}

} // namespace

Window_distances bounded_distances(const Laid_out_faces& faces, const Distance_bounds& bounds, double tolerance,
                                   const Window_sources& sources, std::uint64_t most, const Interruption& interruption,
                                   const std::vector<std::uint32_t>& goals)
{
  Window_distances result = propagate_windows(faces, tolerance, sources, most, interruption, goals);
  const Distances_near_sources known = known_distances(faces, sources);
  bounds.apply(result.distances, known.of_rows, known.farther);
  for (double& d : result.distances)
    d = std::ldexp(d, faces.exponent());
  return result;
}

Distances_near_sources distances_near_sources(const Laid_out_faces& faces, const Distance_bounds& bounds,
                                              const Window_sources& sources, std::uint64_t most,
                                              const Interruption& interruption)
{
  Distances_near_sources result = known_distances(faces, sources);
  std::vector<std::uint32_t> rows;
  for (const auto& known : result.of_rows)
    rows.push_back(known.first);
  if (rows.empty())
    return result;
  const Window_distances found = bounded_distances(faces, bounds, 0, sources, most, interruption, rows);
  for (auto& [row, distance] : result.of_rows)
    distance = found.distances[row];
  result.farther = std::ldexp(result.farther, faces.exponent());
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal
