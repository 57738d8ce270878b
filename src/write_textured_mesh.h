// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef IDT_WRITE_TEXTURED_MESH_H
#define IDT_WRITE_TEXTURED_MESH_H

#include "Surface.h"

#include <CGAL/Intrinsic_triangulations/disk_boundary.h>

#include <string>
#include <vector>

namespace idt {

// The files that go with an OBJ file: itself, its material and the image of that.
std::vector<std::string> textured_mesh_paths(const std::string& obj_path);

// Writes the triangles of a surface with texture coordinates, and a checkerboard to put on
// them. The coordinates are moved and scaled into the unit square.
// \exception Usage_error if the surface has no place in space
void write_textured_mesh(const std::string& obj_path, const Surface& surface,
                         const CGAL::Intrinsic_triangulations::Planar_points& uv);

} // namespace idt

#endif // IDT_WRITE_TEXTURED_MESH_H
