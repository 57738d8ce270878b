// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef IDT_TRIANGULATE_H
#define IDT_TRIANGULATE_H

#include "Triangulation_result.h"

#include <optional>
#include <string>

namespace idt {

// Reads a surface and makes it Delaunay, with a progress line; what the subcommands
// that need an intrinsic triangulation begin with.
Triangulation_result triangulate(const std::string& path, const Kernel_options& options,
                                 const std::optional<Mollification_options>& mollification);

// The same for a surface that was read.
Triangulation_result triangulate(Surface surface, const Kernel_options& options);

} // namespace idt

#endif // IDT_TRIANGULATE_H
