// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Straight triangles as files for solvers, with regions and lines by which conditions are set.

#ifndef IDT_WRITE_STRAIGHT_MESH_H
#define IDT_WRITE_STRAIGHT_MESH_H

#include <CGAL/Intrinsic_triangulations/straight_mesh.h>

#include <ostream>
#include <string>

namespace idt {

// ".msh, .inp, .vtp ... or .ts": the extensions that write_straight_mesh() knows.
std::string straight_mesh_extensions();

// Whether the name of a file ends in one of them.
bool is_straight_mesh_name(const std::string& path);

// Writes a file in the format that its extension selects: Gmsh's format 2.2 (.msh) and Abaqus' (.inp) name regions and
// lines, VTP has them as numbers of cells, and other mesh files have triangles alone.
void write_straight_mesh(std::ostream& os, const CGAL::Intrinsic_triangulations::Straight_mesh& mesh,
                         const std::string& path);

} // namespace idt

#endif // IDT_WRITE_STRAIGHT_MESH_H
