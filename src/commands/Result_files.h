// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The files that a subcommand writes about its triangulation.

#ifndef IDT_RESULT_FILES_H
#define IDT_RESULT_FILES_H

#include "input/mesh_file.h"
#include "output/Output_file.h"
#include "output/Triangulation_result.h"
#include "view/View.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace idt {

// Their paths as command line options; files with an empty path are not written.
struct Result_files
{
  std::string stats, edges, Laplacian, mass, crossings, overlay, points, repair_map, vertex_map, save, view;
  std::string overlay_format = "ply"; // on the standard output
  bool has_overlay_triangles = false;
  bool is_verbose = false; // of the report

  // Declares the options that all triangulations have. \param repair the option that a repair map requires
  void add_options(CLI::App& command, CLI::Option* repair);

  std::vector<std::string> paths() const
  {
    return {stats, edges, Laplacian, mass, crossings, overlay, points, repair_map, vertex_map, save, view};
  }

  // \exception Usage_error if a file would replace another, or an input, or has no format for an overlay
  void check_paths(const std::vector<std::string>& inputs) const;

  // \exception Invalid_surface_error if the overlay of the surface has no positions in space
  // \exception Usage_error as check_view()
  void check_surface(const Surface& surface) const;

  // The results needed for the files.
  void add_to(Requested_results& wanted) const;

  // \param fields the colours of the surface in the view
  // \exception Output_error as write_file()
  // \exception Usage_error as make_view()
  void write(Triangulation_result& result, std::vector<View_field> fields = {}) const;

private:
  std::optional<Mesh_format> format_of_overlay() const
  {
    return find_mesh_format(name_with_format(overlay, overlay_format));
  }
};

} // namespace idt

#endif // IDT_RESULT_FILES_H
