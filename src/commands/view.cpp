// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `idt view`

#include "commands/Result_files.h"
#include "commands/commands.h"
#include "commands/command_line.h"
#include "commands/triangulate.h"
#include "input/vertex_values.h"
#include "output/Output_file.h"
#include "view/View.h"

#include <CGAL/Intrinsic_triangulations/transfer.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace idt {
namespace {

struct View_options
{
  std::string input, values;
  Repair_options repair;
  Result_files files;
};

Exit_status view_file(const std::string& path, const View_options& options)
{
  Surface surface = load_surface(path, options.repair);
  options.files.check_surface(surface);
  std::vector<Named_values> columns;
  if (!options.values.empty())
    columns = read_vertex_values(options.values, surface.connectivity.number_of_vertices());
  Run_options run_options;
  run_options.keeps_saved = true;
  options.files.add_to(run_options.wanted);
  Triangulation_result result = triangulate(std::move(surface), run_options);
  std::vector<View_field> fields;
  if (result.outcome.subdivision)
    for (const Named_values& column : columns)
      fields.push_back(
        {column.name,
         "",
         false,
         {CGAL::Intrinsic_triangulations::interpolate_input_values(*result.outcome.subdivision, column.values)}});
  options.files.write(result, std::move(fields));
  return report(result, false);
}

Exit_status run_view(const View_options& options)
{
  options.files.check_paths({options.input, options.values});
  check_view(options.files.view);
  return for_each_input({options.input}, [&](const std::string& path) { return view_file(path, options); });
}

} // namespace

void add_view_command(CLI::App& app, Selected_command& selected)
{
  const auto options = std::make_shared<View_options>();
  CLI::App& command = *app.add_subcommand(
    "view", "Write a page that shows a surface and its intrinsic Delaunay triangulation in a browser");
  command.footer(
    "The page is one file, which needs no other and no network. It shows edges of the input alone (black), of the\n"
    "triangulation alone (red) and of both (white), angles and weights before and after, and the numbers of what\n"
    "the mouse points at. The option --view of other subcommands writes it with their results.\n");
  command.add_option("INPUT", options->input, "as for `idt triangulate`; a saved triangulation is shown as it is")
    ->required();
  add_option(command, "-o,--output", options->files.view, "F.html", "the page")->required();
  add_option(command, "--values", options->values, "F.csv",
             "numbers at the vertices that colour the surface, as CSV: vertex,NAME, and more names if you like");
  add_repair_option(command, options->repair);
  command.callback([options, &selected] { selected = [options] { return run_view(*options); }; });
}

} // namespace idt
