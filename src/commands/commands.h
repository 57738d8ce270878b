// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The subcommands. Each one declares its options and what to run when it is chosen.

#ifndef IDT_COMMANDS_H
#define IDT_COMMANDS_H

#include "input/Surface.h"

#include "system/Exit_status.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace idt {

// The function of the chosen subcommand, called once the whole command line was understood.
using Selected_command = std::function<Exit_status()>;

void add_triangulate_command(CLI::App& app, Selected_command& selected);
void add_simplify_command(CLI::App& app, Selected_command& selected);
void add_view_command(CLI::App& app, Selected_command& selected);
void add_refine_command(CLI::App& app, Selected_command& selected);
void add_compare_command(CLI::App& app, Selected_command& selected);
void add_parameterize_command(CLI::App& app, Selected_command& selected);
void add_geodesic_command(CLI::App& app, Selected_command& selected);
void add_distance_command(CLI::App& app, Selected_command& selected);
void add_Laplacian_command(CLI::App& app, Selected_command& selected);
void add_table_command(CLI::App& app, Selected_command& selected);
void add_sample_command(CLI::App& app, Selected_command& selected);
void add_describe_command(CLI::App& app, Selected_command& selected);

// Declares the options that repair an input first.
CLI::Option* add_repair_option(CLI::App& command, Repair_options& repair);

// Declares the option that writes a page showing the result.
void add_view_option(CLI::App& command, std::string& path);

// Writes a message to the standard error and returns its exit status; must be called in a handler.
// \param input the current input; messages that do not begin with it are about it, too, as the library knows no files
Exit_status report_current_exception(const std::string& input = std::string());

// Does the same for each input until the command is interrupted. The others are still processed if one input fails; the
// first failure decides the status. If the output fails, the loop ends.
Exit_status for_each_input(const std::vector<std::string>& inputs,
                           const std::function<Exit_status(const std::string&)>& function);

} // namespace idt

#endif // IDT_COMMANDS_H
