// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A surface with a map to the plane in the form that drawing programs take: polygons whose corners have texture
// coordinates.

#ifndef IDT_TEXTURED_MESH_H
#define IDT_TEXTURED_MESH_H

#include "input/Surface.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/harmonic_parameterization.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace idt {

struct Textured_mesh
{
  std::vector<std::array<double, 3>> points;
  CGAL::Intrinsic_triangulations::Planar_points uv; // of each point, or those that `uv_of_faces` refers to
  std::vector<std::vector<std::size_t>> faces;
  std::vector<std::vector<std::size_t>> uv_of_faces{}; // of the corners; empty if they are those of the points
  bool is_exact = false;                               // whether the coordinates are only multiplied by a power of two
};

// The map that is linear on each input triangle: the input itself.
// \param uv the image of each vertex
// \pre the surface has points
Textured_mesh make_map_over_input(const Surface& surface, const CGAL::Intrinsic_triangulations::Planar_points& uv);

// The map that is linear on each intrinsic triangle. On the surface in space it is linear only on the faces of the
// overlay (section 2.3 of the paper), which these faces are, in order.
Textured_mesh make_map_over_intrinsic(const Surface& surface,
                                      const CGAL::Intrinsic_triangulations::Common_subdivision& subdivision,
                                      const CGAL::Intrinsic_triangulations::Planar_points& uv);

// The files that belong to an OBJ file: itself, its material and the material's image.
std::vector<std::string> textured_mesh_paths(const std::string& obj_path);

// Writes a mesh with texture coordinates, and a checkerboard for it. The coordinates are moved and scaled into the unit
// square, unless they have to stay exact.
void write_textured_mesh(const std::string& obj_path, const Textured_mesh& mesh);

} // namespace idt

#endif // IDT_TEXTURED_MESH_H
