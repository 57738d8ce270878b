// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Lengths of ways to the points of a face: the distance is the smallest of them.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_WAVE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_WAVE_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The ways to the points of a face that come from a corner or from a source in the face, or that enter through a part
// of a side: straight, or beside the bundle over its nearest end. The face lies in the plane as relative to its first
// side.
//
// A wave gives the length of some way. It is convex in the face, and changes no faster than the point moves.
struct Wave
{
  enum Kind : std::uint16_t {
    ALL_AROUND, // from a point
    BUNDLE,     // from a point through a window
    FRONT,      // a parallel front through a window
    SEGMENT     // from both sides of a segment
  };
  using Vector = std::array<double, 2>;

  std::uint32_t face = 0, source = 0;
  Kind kind = ALL_AROUND;
  Vector from{0, 0};               // the point, or the direction of the front
  double sigma = 0;                // the distance at that point, or of the front at the origin
  std::array<Vector, 2> ends{};    // of the window, the right one first, seen along the ways; or of the segment
  std::array<double, 2> at_ends{}; // the distances there
};

// The waves of all faces, by the number of the face; distances are in the unit of the faces.
struct Waves
{
  std::vector<Wave> waves;
  std::vector<std::size_t> first; // of each face, and the end of the last one
  std::uint64_t number_of_steps = 0;
  bool is_complete = true;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_WAVE_H
