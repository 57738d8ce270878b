// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `idt`: intrinsic Delaunay triangulations of surfaces.

#include "system/Exit_status.h"
#include "system/Interruption.h"
#include "system/Progress.h"
#include "system/system_calls.h"
#include "output/Output_file.h"
#include "commands/command_line.h"
#include "commands/commands.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <string>
#include <utility>
#include <vector>

int main(int argc, char** argv)
{
  using idt::Exit_status;
  idt::prepare_standard_streams();
  idt::install_signal_handlers();

  Exit_status status = Exit_status::DONE;
  try {
    CLI::App app("Intrinsic Delaunay triangulations of triangulated surfaces", "idt");
    app.allow_windows_style_options(false); // a name may begin with a slash
    app.footer("idt help SUBCOMMAND lists its options.\n"
               "Exit status: 0 done; 1 a result could not be written; 2 the command line is wrong;\n"
               "3 an input or table is unusable; 4 undecided, not flippable, out of budget or cancelled\n"
               "(the result so far is still written, if that takes less than a second).\n"
               "An output file with the name - is the standard output; the report then goes to the standard error.\n");
    app.require_subcommand(1);
    idt::Selected_command selected;
    idt::add_triangulate_command(app, selected);
    idt::add_refine_command(app, selected);
    idt::add_simplify_command(app, selected);
    idt::add_view_command(app, selected);
    idt::add_compare_command(app, selected);
    idt::add_parameterize_command(app, selected);
    idt::add_geodesic_command(app, selected);
    idt::add_distance_command(app, selected);
    idt::add_Laplacian_command(app, selected);
    idt::add_table_command(app, selected);
    idt::add_sample_command(app, selected);
    idt::add_describe_command(app, selected);
    bool is_quiet = false;
    app.set_version_flag("-V,--version", "idt " IDT_VERSION, "Print the version and exit");
    for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
      command->set_version_flag("-V,--version", "idt " IDT_VERSION, "Print the version and exit");
      if (command->get_name() != "sample" && command->get_name() != "describe")
        command->add_flag("-q,--quiet", is_quiet,
                          "print no report and no progress, only what is wrong or was repaired");
      // An empty argument is more likely an unset variable than intended.
      for (CLI::Option* option : command->get_options())
        option->check(
          [](const std::string& value) { return value.empty() ? std::string("must not be empty") : std::string(); });
    }
    try {
      std::vector<std::string> arguments(argv + (argc > 0), argv + argc);
      idt::check_values(app, arguments);
      idt::parse(app, std::move(arguments));
      idt::Progress::set_shown(!is_quiet);
      idt::route_reports(is_quiet, idt::writes_to_standard_output(*app.get_subcommands().front()));
      status = selected();
    } catch (const CLI::ParseError& error) {
      // Asking for help is not an error. CLI11 has a status for each kind of mistake.
      status = app.exit(error) == 0 ? Exit_status::DONE : Exit_status::WRONG_USAGE;
    }
    idt::flush_standard_output();
  } catch (...) {
    idt::keep_first_failure(status, idt::report_current_exception());
  }
  idt::end_in_good_order();
  return static_cast<int>(status);
}
