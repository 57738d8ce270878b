// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points, curves and edges of a surface from tables.

#ifndef IDT_PLACE_FILES_H
#define IDT_PLACE_FILES_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace idt {

// A line of a table.
struct Place
{
  enum Kind {
    IN_SPACE,        // numbers are coordinates
    IN_FACE,         // numbers are barycentric coordinates in `face`, of its corners in their order
    BETWEEN_VERTICES // likewise, of the given corners
  };
  Kind kind;
  std::array<double, 3> numbers;
  std::uint64_t face = 0;
  std::array<std::uint64_t, 3> corners{};
  std::size_t line = 0;
};

// Reads a table of points, whose first line is x,y,z; or input_face,b0,b1,b2; or begins as that of `idt geodesic`, or
// with the number of the line as one of `idt distance --lines`. Where the first line is repeated, or with another
// number, another curve begins.
// \exception Invalid_surface_error if the file cannot be read; the message names file and line
std::vector<std::vector<Place>> read_places(const std::string& path);

// Reads pairs of vertices, one pair a line.
// \exception Invalid_surface_error likewise
std::vector<std::pair<std::uint64_t, std::uint64_t>> read_vertex_pairs(const std::string& path);

// Reads vertices, one a line.
// \exception Invalid_surface_error likewise
std::vector<std::uint64_t> read_vertices(const std::string& path);

} // namespace idt

#endif // IDT_PLACE_FILES_H
