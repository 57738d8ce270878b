// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A saved triangulation as the input of a subcommand.

#ifndef IDT_SAVED_TRIANGULATION_H
#define IDT_SAVED_TRIANGULATION_H

#include "input/Surface.h"

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>

#include <string>
#include <vector>

namespace idt {

struct Saved_triangulation
{
  CGAL::Intrinsic_triangulations::Intrinsic_triangulation<CGAL::Intrinsic_triangulations::Filtered_edge_length_traits>
    triangulation;
  std::vector<bool> is_constrained; // for each input edge, or empty
};

// Whether the name has the extension of saved triangulations.
bool is_saved_triangulation(const std::string& path);

// Reads the triangulation, and makes its input the surface.
// \exception Invalid_surface_error with a message that begins with the path
// \exception Cancelled_error if an interruption ends the reading
void load_saved_triangulation(Surface& surface);

} // namespace idt

#endif // IDT_SAVED_TRIANGULATION_H
