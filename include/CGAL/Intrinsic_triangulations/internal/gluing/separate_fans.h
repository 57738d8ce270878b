// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A vertex for each fan of glued triangles.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GLUING_SEPARATE_FANS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GLUING_SEPARATE_FANS_H

#include <CGAL/Intrinsic_triangulations/internal/system/Large_vector.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// The first fan at each vertex keeps the number of the vertex; the others are numbered behind all vertices.
// \param corners for each side 3f + i, which runs from corner i of face f to corner i + 1, the vertex where it begins
// \param glued_to for each side its partner, which runs the other way, or the largest number
// \return for each fan the vertex that it was at, and for each corner its fan
inline std::pair<std::vector<std::uint32_t>, Large_vector<std::uint32_t>>
separate_fans(std::size_t number_of_vertices, const Large_vector<std::uint32_t>& corners,
              const Large_vector<std::uint32_t>& glued_to)
{
  using Index = std::uint32_t;
  constexpr Index none = (std::numeric_limits<Index>::max)();
  const auto next = [](Index s) { return s % 3 == 2 ? s - 2 : s + 1; };
  const auto previous = [](Index s) { return s % 3 == 0 ? s + 2 : s - 1; };

  std::vector<Index> vertex_of;
  vertex_of.reserve(2 * number_of_vertices);
  for (Index v = 0; v < number_of_vertices; ++v)
    vertex_of.push_back(v);
  Large_vector<Index> fan_of_corner(corners.size(), none);
  std::vector<bool> is_named(number_of_vertices, false);
  for (Index first = 0; first < corners.size(); ++first) {
    if (fan_of_corner[first] != none)
      continue;
    Index fan = corners[first];
    if (is_named[fan]) {
      vertex_of.push_back(fan);
      fan = Index(vertex_of.size() - 1);
    } else {
      is_named[fan] = true;
    }
    Index s = first;
    do { // clockwise
      fan_of_corner[s] = fan;
      s = glued_to[s] == none ? none : next(glued_to[s]);
    } while (s != none && s != first);
    if (s == none) // the rest, counterclockwise
      for (s = glued_to[previous(first)]; s != none; s = glued_to[previous(s)])
        fan_of_corner[s] = fan;
  }
  return {std::move(vertex_of), std::move(fan_of_corner)};
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GLUING_SEPARATE_FANS_H
