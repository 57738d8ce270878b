// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef IDT_TRIANGULATE_H
#define IDT_TRIANGULATE_H

#include "output/Triangulation_result.h"
#include "system/Exit_status.h"

namespace idt {

// Makes a surface Delaunay, with a progress line: the first step of subcommands that need an intrinsic triangulation.
Triangulation_result triangulate(Surface surface, const Run_options& options);

// Prints the report, and the status unless everything is done: the last step of these subcommands.
Exit_status report(const Triangulation_result& result, bool is_verbose);

} // namespace idt

#endif // IDT_TRIANGULATE_H
