// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `idt parameterize --method conformal`

#ifndef IDT_CONFORMAL_MAP_H
#define IDT_CONFORMAL_MAP_H

#include "input/repair.h"
#include "system/Exit_status.h"

#include <cstdint>
#include <optional>
#include <string>

namespace idt {

struct Parameterize_options
{
  std::string input, method = "harmonic", Laplacian = "intrinsic", boundary, cone_angles, boundary_angles;
  std::string uv, uv_input, distortion, view, stats;
  std::optional<std::uint64_t> cones;
  Repair_options repair;
};

// Maps a surface, writes the files and reports.
// \exception Usage_error if options contradict each other
Exit_status run_conformal_map(const Parameterize_options& options);

} // namespace idt

#endif // IDT_CONFORMAL_MAP_H
