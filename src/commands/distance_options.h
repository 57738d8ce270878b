// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The options of `idt distance`.

#ifndef IDT_DISTANCE_OPTIONS_H
#define IDT_DISTANCE_OPTIONS_H

#include "commands/distance_lines.h"
#include "commands/distance_sources.h"
#include "input/mesh_file.h"
#include "input/repair.h"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace idt {

struct Distance_options
{
  std::string input;
  Named_sources sources, barriers;
  std::vector<std::uint64_t> targets;
  std::string source_vertices_path, target_vertices_path, matrix_path;
  Line_options lines;
  std::string output_path, overlay_path, labels_path, samples_path, stats_path, view_path;
  std::uint64_t number_of_samples = 0;
  std::string cover, boundary, format = "csv", method;
  std::optional<double> time_coefficient, maximum_change;
  Repair_options repair;
  bool is_refined = false, has_vectors = false, is_compared = false, is_signed = false;

  // Whether ways begin elsewhere than at vertices, or their origin matters.
  bool has_places() const
  {
    return sources.has_files() || !labels_path.empty() || !samples_path.empty() || lines.are_wanted();
  }
  bool has_barriers() const { return barriers.has_files(); }
  double tolerance() const { return method == "exact" ? 0 : 0.001; }
  bool is_by_heat() const { return method == "heat" || (method.empty() && (!boundary.empty() || time_coefficient)); }

  std::optional<Mesh_format> overlay_format() const;

  void add_options(CLI::App& command);

  // Reads the vertices that files name, and chooses what other options imply.
  // \exception Usage_error if the options make no sense together
  void complete();
};

} // namespace idt

#endif // IDT_DISTANCE_OPTIONS_H
