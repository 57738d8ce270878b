// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef IDT_REPAIR_H
#define IDT_REPAIR_H

#include "input/Surface.h"
#include "input/read_surface.h"

#include <nlohmann/json_fwd.hpp>

#include <ostream>
#include <string>

namespace idt {

// Makes a surface from the polygons, as far as possible, and reports the repairs on the standard error.
// \param stitching_tolerance as of IT::repair_polygons()
// \exception Invalid_surface_error if the input cannot be repaired; the message begins with its path
// \exception Cancelled_error if an interruption ends the repair
Repair_report repair(Surface_input& input, const std::optional<double>& stitching_tolerance);

// The repairs of a surface.
inline Repairs repairs(const Surface& surface) { return surface.repair ? surface.repair->repairs : nullptr; }

// A restriction of a claim to the repaired surface, such as ", on the repaired surface, which was cut (2 new border
// edges)". It is empty if the repair did not cut the surface.
std::string cuts_text(const Repairs& repairs);

// The same as an array of kinds with numbers and first elements, or null.
nlohmann::ordered_json to_json_value(const Repairs& repairs);

// The origin of each vertex and face, as comma-separated values: `element,index,input`. \pre the surface was repaired
void write_repair_map(std::ostream& os, const Surface& surface);

} // namespace idt

#endif // IDT_REPAIR_H
