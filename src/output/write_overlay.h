// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef IDT_WRITE_OVERLAY_H
#define IDT_WRITE_OVERLAY_H

#include "input/mesh_file.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>

#include <array>
#include <ostream>
#include <vector>

namespace idt {

// The overlay as a mesh of polygons, or of triangles into which they are cut.
// \param points those of the input
// \param values of the vertices of the overlay, which PLY and VTP hold
// \pre the format holds polygons, or they are cut
void write_overlay(std::ostream& os, const CGAL::Intrinsic_triangulations::Common_subdivision& subdivision,
                   const std::vector<std::array<double, 3>>& points, Mesh_format format, bool are_triangles,
                   const std::vector<Named_values>& values = {});

} // namespace idt

#endif // IDT_WRITE_OVERLAY_H
