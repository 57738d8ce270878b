// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The intrinsic triangulation as a mesh of straight triangles, which is another surface.

#ifndef IDT_FLATTEN_H
#define IDT_FLATTEN_H

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace idt {

struct Flattened_surface
{
  std::vector<std::array<double, 3>> points;           // of all vertices of the intrinsic triangulation
  std::vector<std::array<std::uint32_t, 3>> triangles; // its faces with three different corners, in order
  std::size_t number_of_other_faces = 0;               // which are omitted
  // The largest distance between a point of the surface and its place in the straight triangle of its face. A vertex of
  // the overlay attains it, because both are linear on each face of the overlay.
  double deviation = 0;
  double minimum_angle = 180;                   // of the straight triangles, in degrees
  std::size_t number_of_non_manifold_edges = 0; // edges at which more than two of them meet
};

// \param points those of the input
Flattened_surface flatten(const CGAL::Intrinsic_triangulations::Common_subdivision& subdivision,
                          const std::vector<std::array<double, 3>>& points);

} // namespace idt

#endif // IDT_FLATTEN_H
