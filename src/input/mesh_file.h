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
  STL, // only triangles, without shared corners
  TS,  // only triangles
  VTP
};

// The format that the extension of a file name selects.
std::optional<Mesh_format> find_mesh_format(const std::string& path);

// Whether faces may have any number of corners.
bool holds_polygons(Mesh_format format);

// ".ply, .off or .obj": the formats that hold polygons, or all formats.
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

// Writes triangles, with all digits of coordinates: PLY is binary, with doubles, and STL is text, because its binary
// form has only floats.
// \param at_points values for PLY and VTP; PLY has a property for each coordinate
void write_mesh(std::ostream& os, const std::vector<std::array<double, 3>>& points,
                const std::vector<std::array<std::uint32_t, 3>>& triangles, Mesh_format format,
                const std::vector<Named_values>& at_points = {});

} // namespace idt

#endif // IDT_MESH_FILE_H
