// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `idt view`

#include "commands/Result_files.h"
#include "commands/commands.h"
#include "commands/command_line.h"
#include "commands/triangulate.h"
#include "input/Triangle_soup.h"
#include "input/gluing_file.h"
#include "input/ply_values.h"
#include "input/vertex_values.h"
#include "output/Output_file.h"
#include "view/View.h"

#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/transfer.h>

#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace idt {
namespace {

namespace IT = CGAL::Intrinsic_triangulations;

struct View_options
{
  std::string input;
  std::vector<std::string> values;
  Repair_options repair;
  Result_files files;
};

// Triangles that are no surface.
Exit_status view_triangles(const std::string& path, const View_options& options)
{
  const Triangle_soup soup = read_triangle_soup(path);
  View view = make_view(path, soup.points, soup.triangles);
  for (const std::string& table : options.values) {
    Element_values values = read_element_values(table, soup.points.size(), soup.triangles.size());
    for (Named_values& column : values.columns)
      view.fields.push_back({column.name, "", values.is_of_faces, {std::move(column.values)}});
  }
  for (Named_values& column : read_ply_values(path))
    view.fields.push_back({column.name, "", false, {std::move(column.values)}});
  write_view(options.files.view, view);
  return Exit_status::DONE;
}

// What the file of a surface has at its vertices, which a repair can have merged, copied or removed.
Element_values own_values(const Surface& surface)
{
  Element_values result;
  if (surface.has_points() && !surface.saved)
    result.columns = read_ply_values(surface.path);
  if (surface.repair)
    for (Named_values& column : result.columns) {
      std::vector<double> values;
      for (std::size_t v : surface.repair->input_vertices)
        values.push_back(column.values[v]);
      column.values = std::move(values);
    }
  return result;
}

// Whether a mesh with this defect can be drawn.
bool is_drawable(IT::Invalid_surface_error::Defect defect)
{
  using Defect = IT::Invalid_surface_error::Defect;
  return defect >= Defect::NOT_A_TRIANGLE && defect <= Defect::ZERO_LENGTH_EDGE;
}

Exit_status view_surface(Surface surface, const View_options& options)
{
  options.files.check_surface(surface);
  std::vector<Element_values> tables;
  for (const std::string& table : options.values)
    tables.push_back(
      read_element_values(table, surface.connectivity.number_of_vertices(), surface.connectivity.number_of_faces()));
  tables.push_back(own_values(surface));
  Run_options run_options;
  run_options.keeps_saved = true;
  options.files.add_to(run_options.wanted);
  Triangulation_result result = triangulate(std::move(surface), run_options);
  std::vector<View_field> fields;
  const auto on_vertices = [&](const Named_values& column) {
    return IT::interpolate_input_values(*result.outcome.subdivision, column.values);
  };
  if (result.outcome.subdivision)
    for (const Element_values& table : tables)
      for (const Named_values& column : table.columns)
        fields.push_back(
          {column.name, "", table.is_of_faces, {table.is_of_faces ? column.values : on_vertices(column)}});
  options.files.write(result, std::move(fields));
  return report(result, false);
}

Exit_status view_file(const std::string& path, const View_options& options)
{
  try {
    return view_surface(load_surface(path, options.repair), options);
  } catch (const IT::Invalid_surface_error& error) {
    if (!is_drawable(error.defect()) || is_gluing_file(path))
      throw;
    std::cerr << "idt: " << error.what() << "\nidt: the page shows the triangles as they are" << std::endl;
  }
  return view_triangles(path, options);
}

Exit_status run_view(const View_options& options)
{
  std::vector<std::string> inputs = options.values;
  inputs.push_back(options.input);
  options.files.check_paths(inputs);
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
    "the mouse points at. The option --view of other subcommands writes it with their results. Triangles that are no\n"
    "surface are shown as they are.\n");
  command.add_option("INPUT", options->input, "as for `idt triangulate`; a saved triangulation is shown as it is")
    ->required();
  add_option(command, "-o,--output", options->files.view, "F.html", "the page")->required();
  add_option(
    command, "--values", options->values, "F.csv",
    "numbers that colour the surface, as CSV: vertex,NAME, or face,NAME, and more names if you like; again for "
    "more tables")
    ->allow_extra_args(false);
  add_repair_option(command, options->repair);
  command.callback([options, &selected] { selected = [options] { return run_view(*options); }; });
}

} // namespace idt
