// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef IDT_WRITE_TEXTURED_MESH_H
#define IDT_WRITE_TEXTURED_MESH_H

#include "output/Textured_mesh.h"

#include <string>
#include <vector>

namespace idt {

// The files that go with an OBJ file: itself, its material and the image of that.
std::vector<std::string> textured_mesh_paths(const std::string& obj_path);

// Writes a mesh with texture coordinates, and a checkerboard to put on it. The coordinates are
// moved and scaled into the unit square.
void write_textured_mesh(const std::string& obj_path, const Textured_mesh& mesh);

} // namespace idt

#endif // IDT_WRITE_TEXTURED_MESH_H
