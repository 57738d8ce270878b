// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Edges that a user wants to keep, from a file.

#ifndef IDT_CONSTRAINTS_H
#define IDT_CONSTRAINTS_H

#include "input/Surface.h"

#include <ostream>
#include <string>
#include <vector>

namespace idt {

// Reads which edges are constrained: pairs of vertices, one pair a line, or a line on the surface as `idt geodesic`
// writes it as CSV. Where a line crosses a face, the surface is cut along it: it gets new vertices on its edges, after
// its own and with rounded positions.
// \return a flag for each edge of the surface
// \exception Invalid_surface_error if the file cannot be read, or does not fit the surface; the message names file and
//   line
std::vector<bool> read_constraints(const std::string& path, Surface& surface);

// Writes the flagged edges: to .csv as pairs of vertices that read_constraints() reads, to .vtp as lines in space.
void write_constraints(std::ostream& os, const std::string& path, const Surface& surface,
                       const std::vector<bool>& is_constrained);

} // namespace idt

#endif // IDT_CONSTRAINTS_H
