// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef IDT_FLAT_VERTICES_H
#define IDT_FLAT_VERTICES_H

#include "input/Surface.h"

#include <optional>
#include <ostream>

namespace idt {

// Removes the vertices in flat sides and on straight edges; with a tolerance, also those that are nearly flat.
// \exception Usage_error if the surface has no points
// \exception Cancelled_error if an interruption ends that
// \return a bound on how far the surface has moved
double remove_flat_vertices(Surface& surface, std::optional<double> tolerance);

// For each vertex its number in the input, as comma-separated values: `vertex,input`. \pre flat vertices were removed
void write_vertex_map(std::ostream& os, const Surface& surface);

} // namespace idt

#endif // IDT_FLAT_VERTICES_H
