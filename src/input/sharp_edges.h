// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef IDT_SHARP_EDGES_H
#define IDT_SHARP_EDGES_H

#include "input/Surface.h"

#include <vector>

namespace idt {

// Tells for each edge whether the normals of its two faces differ by more than so many degrees, in doubles. Edges on the border and beside
// faces of zero area are not sharp. \pre the surface has points
std::vector<bool> sharp_edges(const Surface& surface, double degrees);

} // namespace idt

#endif // IDT_SHARP_EDGES_H
