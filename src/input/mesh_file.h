// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The files that can hold a mesh, and how points and triangles are written to them.

#ifndef IDT_MESH_FILE_H
#define IDT_MESH_FILE_H

#include <array>
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

// Writes triangles, coordinates with all their digits: PLY is binary, with doubles, and STL
// is text, whose binary form has floats alone.
void write_mesh(std::ostream& os, const std::vector<std::array<double, 3>>& points,
                const std::vector<std::array<std::uint32_t, 3>>& triangles, Mesh_format format);

} // namespace idt

#endif // IDT_MESH_FILE_H
