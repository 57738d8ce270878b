// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of isolines.h.

#include <CGAL/Intrinsic_triangulations/isolines.h>

#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/sides_of_curve.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

std::vector<double> checked_levels(std::vector<double> distances, bool are_signed)
{
  for (double& d : distances) {
    if (!std::isfinite(d) || d == 0 || (d < 0 && !are_signed))
      throw Invalid_argument_error(are_signed ? "the distance of an offset curve is a number other than 0"
                                              : "the distance of an isoline is a positive number");
    d = std::abs(d);
  }
  std::sort(distances.begin(), distances.end());
  distances.erase(std::unique(distances.begin(), distances.end()), distances.end());
  return distances;
}

Surface_lines lines_of_waves(const Common_subdivision& subdivision, const Laid_out_faces& faces, const Waves& waves,
                             Wanted_lines wanted, const Interruption& interruption)
{
  Surface_lines result;
  if (!(wanted.chord_tolerance > 0))
    throw Invalid_argument_error("the maximum deviation of lines is a positive number");
  if (std::isinf(wanted.chord_tolerance)) {
    double largest = wanted.levels.empty() ? 0 : wanted.levels.back();
    if (wanted.levels.empty())
      for (const Wave& wave : waves.waves)
        if (wave.kind == Wave::ALL_AROUND)
          largest = (std::max)(largest, std::ldexp(wave.sigma, faces.exponent()));
    if (largest == 0) // every corner of a face is a source
      for (const Laid_out_faces::Side& side : faces.sides())
        largest = (std::max)(largest, std::ldexp(side.length, faces.exponent()));
    wanted.chord_tolerance = 1e-4 * largest;
  }
  result.maximum_deviation = wanted.chord_tolerance;
  result.number_of_ways = waves.number_of_steps;
  result.is_complete = waves.is_complete;
  const std::vector<double> levels = wanted.levels;
  for (double& level : wanted.levels)
    level = std::ldexp(level, -faces.exponent());
  wanted.chord_tolerance = std::ldexp(wanted.chord_tolerance, -faces.exponent());
  for (Traced_line& line : trace_lines(subdivision, faces, waves, wanted, interruption))
    result.lines.push_back({std::move(line.points), levels.empty() ? 0 : levels[line.level], line.cells});
  std::stable_sort(result.lines.begin(), result.lines.end(),
                   [](const Surface_line& a, const Surface_line& b) { return a.distance < b.distance; });
  return result;
}

void keep_sides(const Delta_complex& input, const std::vector<std::vector<Surface_point>>& parts,
                const std::vector<double>& distances, std::vector<Surface_line>& lines)
{
  std::vector<Surface_point> points;
  for (const Surface_line& line : lines)
    points.push_back(line.points.front());
  const std::vector<Sign> signs = sides_of_curve(input, parts, points);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    lines[i].distance *= signs[i] == NEGATIVE ? -1 : 1;
    if (std::find(distances.begin(), distances.end(), lines[i].distance) == distances.end())
      continue;
    if (kept != i)
      lines[kept] = std::move(lines[i]);
    ++kept;
  }
  lines.resize(kept);
}

} // namespace CGAL::Intrinsic_triangulations::internal
