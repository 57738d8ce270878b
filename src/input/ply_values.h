// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers that a PLY file has at its vertices beside their positions.

#ifndef IDT_PLY_VALUES_H
#define IDT_PLY_VALUES_H

#include "input/mesh_file.h"

#include <string>
#include <vector>

namespace idt {

// Reads the real properties of the vertices, as `idt distance -o F.ply` writes them, but neither coordinates nor
// normals, colours and places in a texture. Nothing of a file in another format, or with lists before or at its
// vertices.
// \param path a file that was read as a mesh
std::vector<Named_values> read_ply_values(const std::string& path);

} // namespace idt

#endif // IDT_PLY_VALUES_H
