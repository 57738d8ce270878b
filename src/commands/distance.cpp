// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `idt distance`

#include "commands/commands.h"
#include "commands/distance_options.h"
#include "commands/distance_result.h"
#include "commands/find_distances.h"
#include "output/Output_file.h"

#include <CGAL/Intrinsic_triangulations/errors.h>

#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace idt {
namespace {

namespace IT = CGAL::Intrinsic_triangulations;

Exit_status run_distance(Distance_options options)
{
  options.complete();
  return for_each_input({options.input}, [&](const std::string& path) {
    Distance_result result;
    try {
      result = find_distances(options);
    } catch (const IT::Numerical_error& error) {
      throw IT::Numerical_error(error.what() +
                                std::string(options.time_coefficient > 1 ? "; try a smaller --time" : ""));
    }
    std::vector<std::string> warnings = result.lines.warnings();
    if (result.is_far_from_right())
      warnings.push_back("heat gave " + std::to_string(result.number_of_bounded_distances) + " of " +
                         std::to_string(result.number_of_vertices) +
                         " distances which are shorter than straight lines or longer than paths along edges, by "
                         "more than 5 %: others are inaccurate, too; omit --method heat");
    for (std::string& warning : warnings) {
      std::cerr << "idt: " << path << ": " << warning << std::endl;
      result.warnings.push_back(std::move(warning));
    }
    write_files(options, result);
    write_report(std::cout, options, result);
    flush_standard_output();
    return Exit_status::DONE;
  });
}

} // namespace

void add_distance_command(CLI::App& app, Selected_command& selected)
{
  const auto options = std::make_shared<Distance_options>();
  CLI::App& command = *app.add_subcommand("distance", "Find the distances of all vertices from some of them");
  command.footer(
    "Distances are lengths of shortest paths on an intrinsic Delaunay triangulation, or computed by the heat\n"
    "method. They are zero at the sources, and infinite where no source is connected. Vertices are counted from\n"
    "zero.\n");
  options->add_options(command);
  command.callback([options, &selected] { selected = [options] { return run_distance(*options); }; });
}

} // namespace idt
