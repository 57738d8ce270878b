// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A mesh with a distance at each vertex, and vectors.

#ifndef IDT_WRITE_DISTANCES_H
#define IDT_WRITE_DISTANCES_H

#include "input/mesh_file.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <vector>

namespace idt {

struct Surface_with_distances
{
  std::size_t number_of_vertices = 0;
  std::vector<std::array<double, 3>> points; // empty if the surface is given by lengths
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<double> distances;     // infinite where no source is connected
  std::vector<Named_values> vectors; // what else there is at each vertex
};

// A row `vertex,distance` for each vertex, and a column for each coordinate of the vectors: `NAME_x` and so on; `inf`
// where a number is infinite.
void write_distances_csv(std::ostream& os, const Surface_with_distances& surface);

// Bytes, with a vertex property `distance`, and one for each coordinate of the vectors.
void write_distances_ply(std::ostream& os, const Surface_with_distances& surface);

// Text, with a point array `distance`, and one for each kind of vectors; finite() says what stands for infinite
// numbers.
void write_distances_vtp(std::ostream& os, const Surface_with_distances& surface);

} // namespace idt

#endif // IDT_WRITE_DISTANCES_H
