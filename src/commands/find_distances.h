// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What `idt distance` computes.

#ifndef IDT_FIND_DISTANCES_H
#define IDT_FIND_DISTANCES_H

#include "commands/distance_options.h"
#include "commands/distance_result.h"

namespace idt {

// Reads the surface, and finds all that the options ask for.
// \exception Usage_error if there is no such vertex, or a source or barrier does not fit the surface
Distance_result find_distances(const Distance_options& options);

} // namespace idt

#endif // IDT_FIND_DISTANCES_H
