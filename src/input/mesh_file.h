// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The files that can hold a mesh, and how points and triangles are written to them.

#ifndef IDT_MESH_FILE_H
#define IDT_MESH_FILE_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace idt {

enum class Mesh_format {
  PLY,
  OFF,
  OBJ,
  STL, // triangles alone, whose corners do not know each other
  TS,  // triangles alone
  VTP
};

// The format that the end of a file name tells.
std::optional<Mesh_format> find_mesh_format(const std::string& path);

// Whether faces may have any number of corners.
bool holds_polygons(Mesh_format format);

// ".ply, .off or .obj": the formats that hold polygons, or all of them.
std::string mesh_extensions(bool are_polygons);

// A number, or a vector of two or three, for each element of a mesh.
struct Named_values
{
  std::string name;
  std::vector<double> values;
  std::size_t components = 1;
  const char* type = "Float64"; // in VTP; "Int32" for integers
};

// The names of all coordinates: NAME, or NAME_x and so on.
std::vector<std::string> coordinate_names(const std::vector<Named_values>& arrays);

// Calls `visit(x)` for each coordinate that an element has, in the order of their names.
template <class Visit>
void for_each_coordinate(const std::vector<Named_values>& arrays, std::size_t element, const Visit& visit)
{
  for (const Named_values& array : arrays)
    for (std::size_t c = 0; c < array.components; ++c)
      visit(array.values[element * array.components + c]);
}

// Writes triangles, coordinates with all their digits: PLY is binary, with doubles, and STL
// is text, whose binary form has floats alone.
// \param at_points values that PLY and VTP hold; PLY has a property for each of their coordinates
void write_mesh(std::ostream& os, const std::vector<std::array<double, 3>>& points,
                const std::vector<std::array<std::uint32_t, 3>>& triangles, Mesh_format format,
                const std::vector<Named_values>& at_points = {});

} // namespace idt

#endif // IDT_MESH_FILE_H
