// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers at the vertices or on the faces of a surface, from a table.

#ifndef IDT_VERTEX_VALUES_H
#define IDT_VERTEX_VALUES_H

#include "input/mesh_file.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace idt {

struct Element_values
{
  bool is_of_faces = false;
  std::vector<Named_values> columns;
};

// Reads comma-separated values `vertex,NAME,...` or `face,NAME,...`, as `idt distance -o F.csv` writes them: a function
// for each column. Missing rows and empty cells give NaN.
// \exception Invalid_surface_error if the file cannot be read; the message names the line
Element_values read_element_values(const std::string& path, std::size_t number_of_vertices,
                                   std::size_t number_of_faces);

// Reads a table of that kind with one name, where each line has a finite number: the vertices with their numbers.
// \exception Invalid_surface_error likewise
std::map<std::uint32_t, double> read_numbers_of_vertices(const std::string& path, std::size_t number_of_vertices);

} // namespace idt

#endif // IDT_VERTEX_VALUES_H
