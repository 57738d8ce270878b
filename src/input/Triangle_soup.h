// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangles as they are in a file, for operations that accept any triangles.

#ifndef IDT_TRIANGLE_SOUP_H
#define IDT_TRIANGLE_SOUP_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace idt {

struct Surface_input;

struct Triangle_soup
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::size_t number_of_faces = 0;    // of the file
  std::size_t triangulated_faces = 0; // faces with more than three corners
  std::size_t small_faces = 0;        // faces that enclose nothing, which are omitted
  std::vector<std::string> warnings;
};

// Reads a mesh file, and cuts faces with more than three corners into triangles.
// \exception Invalid_surface_error if the file cannot be read; the message begins with `path`
// \exception Cancelled_error if an interruption ends the reading
Triangle_soup read_triangle_soup(const std::string& path);

// The same of a file that was read.
Triangle_soup to_triangle_soup(Surface_input input);

} // namespace idt

#endif // IDT_TRIANGLE_SOUP_H
