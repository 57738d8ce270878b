// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/Result_files.h"

#include "commands/command_line.h"
#include "commands/commands.h"
#include "input/flat_vertices.h"
#include "input/repair.h"
#include "input/saved_triangulation.h"
#include "input/standard_input.h"
#include "output/Output_file.h"
#include "output/write_json.h"
#include "output/write_overlay.h"
#include "system/Progress.h"
#include "system/Stopwatch.h"

#include <CGAL/Intrinsic_triangulations/errors.h>

#include <nlohmann/json.hpp>

#include <optional>
#include <utility>

namespace idt {

void Result_files::add_options(CLI::App& command, CLI::Option* repair)
{
  command.add_flag("--verbose", is_verbose,
                   "also report how edges were decided, where the input lies in the result, and the time of each step");
  add_option(command, "--stats", stats, "F.json", "write the verbose report as a JSON object");
  add_option(command, "--edges", edges, "F.csv",
             "write the intrinsic edges as CSV: source,target,length,cotan_weight,crossings,original; the weight is "
             "cot + cot, and empty where it is infinite, beside a face of zero area");
  add_option(command, "--laplacian", Laplacian, "F.mtx",
             "write the Laplace-Beltrami operator as a Matrix Market file: positive "
             "semidefinite, entries -(cot + cot)/2, natural boundary conditions");
  add_option(command, "--mass", mass, "F.mtx", "write the lumped mass matrix: a third of the area around each vertex");
  add_option(command, "--crossings", crossings, "F.csv",
             "write the crossings of each intrinsic edge, in order, as CSV: "
             "source,target,edge,position,input_source,input_target,t,u");
  CLI::Option* const overlay_option = add_option(
    command, "--overlay", overlay, "F.(ply|off|obj|vtp)",
    "write the overlay of input and result as a mesh of polygons; with --overlay-triangles, also as F.stl or F.ts");
  command
    .add_flag("--overlay-triangles", has_overlay_triangles,
              "cut the polygons of --overlay into triangles, for programs that accept only triangles")
    ->needs(overlay_option);
  set_words(command.add_option("--overlay-format", overlay_format, "the format of --overlay - on the standard output"),
            {"ply", "off", "obj", "vtp", "stl", "ts"})
    ->type_name("EXT")
    ->capture_default_str()
    ->needs(overlay_option);
  add_view_option(command, view);
  add_option(command, "--save", save, "F.idt",
             "write the triangulation itself, with its input and where that lies: a file that each subcommand takes "
             "as INPUT, to go on from there");
  add_option(command, "--repair-map", repair_map, "F.csv",
             "write where the vertices and faces of the repaired surface come from, as CSV: "
             "element,index,input")
    ->needs(repair);
}

void Result_files::check_paths(const std::vector<std::string>& inputs) const
{
  check_output_paths(paths(), inputs);
  if (!save.empty() && !is_saved_triangulation(name_with_format(save, "idt")))
    throw Usage_error("--save: " + save + " does not end in .idt, by which the file is known as a triangulation");
  if (overlay.empty())
    return;
  const std::optional<Mesh_format> format = format_of_overlay();
  if (!format || (!has_overlay_triangles && !holds_polygons(*format)))
    throw Usage_error(
      "--overlay: " + name_with_format(overlay, overlay_format) + " does not end in " +
      mesh_extensions(!has_overlay_triangles) +
      (format ? ": the overlay has faces with more than three corners, which --overlay-triangles cuts" : ""));
}

void Result_files::check_surface(const Surface& surface) const
{
  check_view(view, surface.connectivity.number_of_faces());
  if (!(overlay.empty() && view.empty()) && !surface.has_points())
    refuse_file(surface.path, (overlay.empty() ? "a page" : "--overlay") +
                                std::string(" needs a surface in space, but this one has only edge lengths") +
                                (surface.mollification ? ", because --mollify changed them" : ""));
}

void Result_files::add_to(Requested_results& wanted) const
{
  wanted.weights = wanted.crossings = true;
  wanted.saved = !save.empty();
  wanted.numbers = !edges.empty() || !Laplacian.empty() || !mass.empty() || !view.empty();
  wanted.input_numbers = !view.empty();
  wanted.overlay = !crossings.empty() || !overlay.empty() || !view.empty();
}

void Result_files::write(Triangulation_result& result, std::vector<View_field> fields) const
{
  const Progress progress(result.surface.path, "writing");
  const auto write_one = [&result](const char* option, const std::string& path, const auto& write) {
    if (path.empty())
      return;
    const Stopwatch stopwatch;
    write_file(path, write);
    result.file_seconds.emplace_back(option, stopwatch.seconds());
  };
  write_one("repair-map", repair_map, [&](std::ostream& os) { write_repair_map(os, result.surface); });
  write_one("vertex-map", vertex_map, [&](std::ostream& os) { write_vertex_map(os, result.surface); });
  write_one("points", points, [&](std::ostream& os) { write_points(os, result); });
  write_one("edges", edges, [&](std::ostream& os) { write_edges(os, result); });
  try {
    write_one("laplacian", Laplacian, [&](std::ostream& os) { write_Laplacian(os, result); });
  } catch (const CGAL::Intrinsic_triangulations::Invalid_surface_error& error) {
    result.no_Laplacian = error;
  }
  write_one("mass", mass, [&](std::ostream& os) { write_mass(os, result); });
  if (!result.outcome.saved.empty())
    write_one("save", save, [&](std::ostream& os) { os << result.outcome.saved; });
  if (result.outcome.subdivision) {
    write_one("crossings", crossings, [&](std::ostream& os) { write_crossings(os, result); });
    write_one("overlay", overlay, [&](std::ostream& os) {
      write_overlay(os, *result.outcome.subdivision, result.surface.points, *format_of_overlay(),
                    has_overlay_triangles);
    });
    if (!view.empty()) {
      const Stopwatch stopwatch;
      const Outcome& outcome = result.outcome;
      View page = make_view(result.surface.path,
                            result.options.refinement                            ? "refined triangulation"
                            : result.options.keeps_saved && result.surface.saved ? "saved triangulation"
                                                                                 : "intrinsic Delaunay triangulation",
                            *outcome.subdivision, result.surface.points, outcome.input_numbers, outcome.numbers);
      page.fields = std::move(fields);
      write_view(view, page);
      result.file_seconds.emplace_back("view", stopwatch.seconds());
    }
  }
  write_json(stats, statistics(result));
}

} // namespace idt
