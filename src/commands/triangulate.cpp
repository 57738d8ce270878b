// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `idt triangulate`

#include "commands/triangulate.h"

#include "system/Interruption.h"
#include "output/Output_file.h"
#include "system/Progress.h"
#include "system/child_process.h"
#include "commands/Result_files.h"
#include "commands/command_line.h"
#include "commands/commands.h"

#include <algorithm>
#include <functional>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>
#include <utility>

namespace idt {
namespace {

struct Triangulate_options
{
  std::vector<std::string> inputs;
  std::string number_type = name(default_number_type);
  int precision = 128;
  std::optional<std::uint64_t> maximum_number_of_flips;
  bool are_ties_proven = false;
  std::optional<double> mollification;
  bool is_mollification_local = false;
  Repair_options repair;
  bool is_verified = false;
  bool is_fast = false;
  Result_files files;
};

Run_options make_run_options(const Triangulate_options& options)
{
  Run_options result;
  result.number_type = *find_number_type(options.number_type);
  result.precision = options.precision;
  result.maximum_number_of_flips = options.maximum_number_of_flips;
  if (options.are_ties_proven)
    result.tie_proof = CGAL::Intrinsic_triangulations::Tie_proof::PROVEN;
  options.files.add_to(result.wanted);
  result.wanted.verification = options.is_verified;
  result.wanted.tessellation = !options.files.stats.empty();
  return result;
}

void check(const Triangulate_options& options)
{
  if (options.mollification && !(*options.mollification >= 0 && *options.mollification <= 1e6))
    throw Usage_error("--mollify: D is between 0 and 1e6");
  const std::vector<std::string> outputs = options.files.paths();
  if (options.inputs.size() > 1 &&
      std::any_of(outputs.begin(), outputs.end(), [](const std::string& s) { return !s.empty(); }))
    throw Usage_error(
      "--stats, --edges, --crossings, --overlay, --laplacian, --mass, --save, --repair-map and --view take one input: "
      "several would be written to the same file");
  options.files.check_paths(options.inputs);
  if (!options.files.save.empty() && options.number_type != name(Number_type::FILTERED))
    throw Usage_error("--save needs --number-type " + std::string(name(Number_type::FILTERED)) +
                      ": no other makes triangulations that can be saved");
}

Exit_status triangulate_file(const std::string& path, const Triangulate_options& options,
                             const Run_options& run_options, bool& is_first)
{
  std::optional<Mollification_options> mollification;
  if (options.mollification)
    mollification = {*options.mollification, options.is_mollification_local};
  Surface surface = load_surface(path, options.repair, mollification);
  options.files.check_surface(surface);
  if (options.is_fast)
    untwist(surface);
  Triangulation_result result = triangulate(std::move(surface), run_options);
  options.files.write(result);
  if (!is_first)
    std::cout << '\n';
  is_first = false;
  return report(result, options.files.is_verbose);
}

// Calls exit() in situations it was not made for.
bool may_end_the_process(Number_type number_type)
{
  return number_type == Number_type::CORE || number_type == Number_type::HALF_ANGLE_CORE;
}

// Runs it in a child process, so that an abort ends only that.
Exit_status run_in_subprocess(const std::string& path, const Run_options& run_options,
                              const std::function<Exit_status()>& triangulate_input, bool& is_first)
{
  constexpr int has_report = 256;
  const std::optional<int> end = run_in_expendable_process([&] {
    Exit_status status;
    try {
      status = triangulate_input();
    } catch (...) {
      status = report_current_exception(path);
    }
    return static_cast<int>(status) + (is_first ? 0 : has_report);
  });
  if (!end && is_interrupted())
    throw CGAL::Intrinsic_triangulations::Cancelled_error(path + ": cancelled");
  if (!end)
    throw CGAL::Intrinsic_triangulations::Undecided_error(path + ": as " + name(run_options.number_type) +
                                                          ": the number type cannot continue with these numbers; " +
                                                          name(Number_type::FILTERED) + " can");
  is_first = is_first && *end < has_report;
  return static_cast<Exit_status>(*end % has_report);
}

Exit_status run_triangulate(const Triangulate_options& options)
{
  check(options);
  const Run_options run_options = make_run_options(options);
  bool is_first = true;
  return for_each_input(options.inputs, [&](const std::string& path) {
    const auto triangulate_input = [&] { return triangulate_file(path, options, run_options, is_first); };
    return may_end_the_process(run_options.number_type)
             ? run_in_subprocess(path, run_options, triangulate_input, is_first)
             : triangulate_input();
  });
}

std::string number_type_help()
{
  std::ostringstream text;
  text << "Number types:\n";
  for (const Named_number_type& entry : number_types())
    text << "  " << std::left << std::setw(19) << entry.name << ' ' << entry.description
         << (entry.number_type == default_number_type ? " (default)" : "") << '\n';
  return text.str();
}

} // namespace

Exit_status report(const Triangulation_result& result, bool is_verbose)
{
  write_report(std::cout, result, is_verbose);
  flush_standard_output();
  const Exit_status status = exit_status(result);
  if (status != Exit_status::DONE)
    std::cerr << "idt: " << result.surface.path << ": " << describe_status(result) << std::endl;
  if (result.no_Laplacian)
    throw *result.no_Laplacian;
  return status;
}

Triangulation_result triangulate(Surface surface, const Run_options& options)
{
  Triangulation_result result;
  result.options = options;
  result.surface = std::move(surface);
  {
    Progress progress(result.surface.path, "triangulating");
    const auto show_flips = [&](std::uint64_t tests, std::uint64_t flips) {
      progress.show_flips(tests, flips);
      return !is_interrupted();
    };
    // After an interruption of the flips there is a result, which has an overlay as well; only a further one, during
    // the overlay, omits it.
    std::optional<bool> was_interrupted;
    const auto show_overlay = [&](double fraction) {
      progress.show("overlay", fraction);
      if (!was_interrupted)
        was_interrupted = is_interrupted();
      return *was_interrupted || !is_interrupted();
    };
    const auto show_points = [&](const CGAL::Intrinsic_triangulations::Refinement_progress& refinement) {
      progress.show_points(refinement.points, refinement.waiting_faces, refinement.size);
      return !is_interrupted();
    };
    result.outcome = run({result.surface, options, show_flips, has_time_to_decide, show_overlay, show_points});
  }
  if (result.outcome.refinement)
    result.options.refinement->is_constrained = result.outcome.refinement->is_constrained;
  const Stopwatch stopwatch;
  result.counts = count_elements(result.outcome.connectivity);
  result.count_seconds = stopwatch.seconds();
  return result;
}

void add_triangulate_command(CLI::App& app, Selected_command& selected)
{
  const auto options = std::make_shared<Triangulate_options>();
  CLI::App& command =
    *app.add_subcommand("triangulate", "Flip edges until the triangulation of each surface is intrinsic Delaunay");
  command.footer(number_type_help() +
                 "\n"
                 "Several inputs are processed one after the other; the status is that of the\n"
                 "first failure. An output file appears when it is complete. Ctrl-C stops the flips,\n"
                 "writes the current result, and ends the command within a second; a second Ctrl-C\n"
                 "ends it at once.\n");
  command
    .add_option("INPUT", options->inputs,
                "meshes of triangles (OFF, OBJ, PLY, STL, TS), or .gluing files of triangles "
                "with lengths; - is the standard input")
    ->required();
  set_words(command.add_option("--number-type", options->number_type, "the number type of the computation; see below"),
            number_type_names(), false)
    ->type_name("NT")
    ->capture_default_str();
  need_one_of(add_option(command, "--precision", options->precision, "BITS", "minimum precision in bits, for mpfr"),
              {"--number-type mpfr"})
    ->check(CLI::Range(2, 1000000))
    ->capture_default_str();
  add_option(command, "--maximum-flips", options->maximum_number_of_flips, "N",
             "give up after this many flips (default: unlimited for an exact number type, else the larger of "
             "10,000,000 and 100 times the number of edges)")
    ->transform(whole_number());
  set_words(need_one_of(
              command.add_option_function<std::string>(
                "--tie-proof", [options](const std::string& word) { options->are_ties_proven = word == "proven"; },
                "what the exact decisions of filtered and of --verify accept as a tie: probable (an error probability "
                "below 2^-128 if a proof would be costly), or proven (a tie without a proof then ends the run)"),
              {"--number-type filtered", "--verify"}),
            {"probable", "proven"})
    ->default_str("probable");
  CLI::Option* const mollify = add_option(command, "--mollify", options->mollification, "D",
                                          "first lengthen all edges by the same amount, so that each triangle "
                                          "inequality holds with a margin of D times the mean length");
  command
    .add_flag("--mollify-local", options->is_mollification_local,
              "lengthen only edges of triangles that lack the margin")
    ->needs(mollify);
  CLI::Option* const repair = add_repair_option(command, options->repair);
  command.add_flag("--verify", options->is_verified,
                   "afterwards decide every interior edge again, exactly and from the input alone, for any number "
                   "type; status 4 if one is not Delaunay");
  command.add_flag(
    "--fast-forward", options->is_fast,
    "for a gluing, first make the flips within tubes of two triangles, any number of them at once; overlay and "
    "crossings refer to the resulting gluing, only --edges counts crossings with the given one");
  options->files.add_options(command, repair);
  command.callback([options, &selected] { selected = [options] { return run_triangulate(*options); }; });
}

} // namespace idt
