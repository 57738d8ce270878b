// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Gluing the pieces of faces again, except along the path.

#include <CGAL/Intrinsic_triangulations/cut_along_path.h>
#include "../gluing/Cut_faces.h"
#include <CGAL/Intrinsic_triangulations/Large_vector.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/Delta_complex_builder.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

Cut_surface cut_along_paths(const Delta_complex& complex, const std::vector<std::array<double, 3>>& points,
                            const std::vector<std::vector<Surface_point>>& paths)
{
  const Cut_faces faces(complex, paths);
  const std::vector<std::array<std::uint32_t, 3>>& triangles = faces.triangles();
  constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();
  std::unordered_map<std::uint64_t, std::uint32_t> sides = faces.sides();
  Large_vector<std::uint32_t> corners;
  for (const auto& triangle : triangles)
    for (std::uint32_t v : triangle)
      corners.push_back(v);
  for (const Cut_faces::Seam_edge& edge : faces.seam()) {
    sides.erase(Cut_faces::key(edge.from, edge.to));
    sides.erase(Cut_faces::key(edge.to, edge.from));
  }
  Large_vector<std::uint32_t> glued_to(corners.size(), none);
  for (const auto& side : sides) {
    const auto other = sides.find((side.first << 32) | (side.first >> 32));
    if (other != sides.end())
      glued_to[side.second] = other->second;
  }
  const auto [vertex_of, fans] = separate_fans(faces.number_of_vertices(), corners, glued_to);

  Cut_surface result;
  const std::size_t n = complex.number_of_vertices();
  result.points = points;
  for (std::size_t i = n; i < vertex_of.size(); ++i) {
    result.locations.push_back(faces.location(vertex_of[i]));
    result.points.push_back(vertex_of[i] < n ? result.points[vertex_of[i]]
                                             : point_in_space(complex, points, result.locations.back()));
  }
  for (std::size_t f = 0; f < triangles.size(); ++f)
    result.triangles.push_back({fans[3 * f], fans[3 * f + 1], fans[3 * f + 2]});
  result.input_faces = faces.input_faces();
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal
