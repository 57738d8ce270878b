// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The two plain forms of the sample surfaces: triangles
// in space, and triangles given by their lengths and a gluing of their sides.

#ifndef IDT_SAMPLES_SAMPLE_SURFACE_TYPES_H
#define IDT_SAMPLES_SAMPLE_SURFACE_TYPES_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace samples {

// Triangles in space that share points by index.
struct Indexed_triangles
{
  // the coordinates of each vertex.
  std::vector<std::array<double, 3>> points;
  // the three vertices of each face, counterclockwise.
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

// A surface given by lengths alone, without an embedding.
//
// Side `3 * f + i` runs from corner `i` to corner `(i + 1) % 3` of face `f`.
// Loops, several edges with the same end vertices and faces that are glued to
// themselves are allowed. The vertices result from the gluing of the corners.
struct Glued_triangles
{
  // the number of triangles.
  std::size_t number_of_faces = 0;
  // the pairs of glued sides, which run in opposite directions, so
  // the surface is oriented; a side in no pair lies on the boundary.
  std::vector<std::array<std::uint32_t, 2>> glued_sides;
  // one length for each side; glued sides have equal lengths.
  std::vector<double> side_lengths;
};

} // namespace samples

#endif // IDT_SAMPLES_SAMPLE_SURFACE_TYPES_H
