// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `idt sample`: the surfaces that are built in.

#include "output/Output_file.h"
#include "commands/command_line.h"
#include "commands/commands.h"
#include "input/mesh_file.h"

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <variant>

namespace idt {
namespace {

namespace IT = CGAL::Intrinsic_triangulations;

struct Sample_options
{
  std::string name;
  std::string path;
  bool lists_names = false;
};

// \param format OFF if none is given
void write_surface(std::ostream& os, const samples::Indexed_triangles& surface, std::optional<Mesh_format> format)
{
  write_mesh(os, surface.points, surface.triangles, format.value_or(Mesh_format::OFF));
}

void write_surface(std::ostream& os, const samples::Glued_triangles& surface, std::optional<Mesh_format>)
{
  const IT::Delta_complex complex = IT::make_Delta_complex_from_gluing(surface.number_of_faces, surface.glued_sides);
  std::vector<double> lengths(complex.number_of_edges());
  for (IT::Face_index f : complex.faces()) {
    IT::Halfedge_index h = complex.halfedge(f);
    for (std::size_t i = 0; i < 3; ++i, h = complex.next(h))
      lengths[complex.edge(h).idx()] = surface.side_lengths[3 * f.idx() + i];
  }
  IT::write_gluing(os, complex, lengths);
}

// A gluing has no positions in space that a mesh file could hold.
const char* extension(const samples::Indexed_triangles&) { return ".off"; }
const char* extension(const samples::Glued_triangles&) { return ".gluing"; }

std::string path_with_extension(const Sample_options& options, const std::string& extension)
{
  const std::filesystem::path path = options.path;
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    return options.path; // a device or a pipe; opening a folder will fail
  if (!path.has_extension())
    return options.path + extension;
  if (extension != ".gluing" && find_mesh_format(options.path))
    return options.path;
  if (path.extension() != extension)
    throw Usage_error(options.path + ": the sample " + options.name + " is written as " +
                      (extension == ".gluing" ? extension : mesh_extensions(false)) +
                      "; use that, or omit the extension");
  return options.path;
}

Exit_status run_sample(const Sample_options& options)
{
  if (options.lists_names == !options.name.empty())
    throw Usage_error(options.lists_names ? "sample: either NAME or --list, not both"
                                          : "sample: NAME is missing; --list shows the names");
  if (options.lists_names) {
    if (!options.path.empty())
      throw Usage_error("sample: --list writes to the standard output, without -o");
    for (const samples::Sample& sample : samples::sample_names())
      std::cout << sample.name << '\n';
    return Exit_status::DONE;
  }
  std::visit(
    [&](const auto& surface) {
      const bool is_printed = options.path.empty() || options.path == "-";
      const std::string path = is_printed ? "-" : path_with_extension(options, extension(surface));
      write_file(path, [&](std::ostream& os) { write_surface(os, surface, find_mesh_format(path)); });
      if (!is_printed)
        std::cout << path << '\n';
    },
    samples::make_sample(options.name));
  return Exit_status::DONE;
}

std::string sample_help()
{
  std::ostringstream text;
  text << "Names:\n";
  for (const samples::Sample& sample : samples::sample_names())
    text << "  " << sample.name << std::string(sample.name.size() < 26 ? 26 - sample.name.size() : 1, ' ')
         << sample.description << '\n';
  return text.str();
}

} // namespace

void add_sample_command(CLI::App& app, Selected_command& selected)
{
  const auto options = std::make_shared<Sample_options>();
  CLI::App& command = *app.add_subcommand("sample", "Write one of the built-in surfaces");
  command.footer(sample_help());
  std::vector<std::string> names;
  for (const samples::Sample& sample : samples::sample_names())
    names.push_back(sample.name);
  set_words(command.add_option("NAME", options->name, "which one; see below"), names, false);
  command
    .add_option("-o,--output", options->path,
                "write to this file and print its name; " + mesh_extensions(false) +
                  " determines the format; without an extension, .off is added, or .gluing for a surface with lengths "
                  "only (default: the standard output)")
    ->type_name("F");
  command.add_flag("--list", options->lists_names, "print the names, one per line");
  command.callback([options, &selected] { selected = [options] { return run_sample(*options); }; });
}

} // namespace idt
