// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `idt compare`: robustness and time, number type by number type.

#include "commands/Comparison.h"
#include "commands/command_line.h"
#include "output/write_json.h"
#include "commands/commands.h"
#include "system/text.h"

#include <nlohmann/json.hpp>

#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace idt {
namespace {

using Json = nlohmann::ordered_json;

struct Compare_options
{
  std::vector<std::string> inputs;
  std::vector<std::string> number_types = {"half-angle-double", "float", "double", "long-double",     "float128",
                                           "interval",          "mpfr",  "core",   "half-angle-core", "filtered"};
  std::vector<int> precisions = {64, 128, 256, 512};
  std::string json_path;
  bool counts_decisions = false;
  bool leaves_decisions = false;
  Comparison_options comparison;
};

std::vector<Compared_type> compared_types(const Compare_options& options)
{
  std::vector<Compared_type> types;
  for (const std::string& wanted : options.number_types) {
    const Number_type number_type = *find_number_type(wanted);
    if (number_type != Number_type::MPFR)
      types.push_back({number_type, std::nullopt});
    else
      for (int precision : options.precisions)
        types.push_back({number_type, precision});
  }
  return types;
}

void write(std::ostream& os, const Surface_comparison& comparison)
{
  os << comparison.path << '\n'
     << "  " << counted(comparison.counts.vertices, "vertex", "vertices") << ", "
     << counted(comparison.counts.edges, "edge", "edges") << ", " << counted(comparison.ties, "tie", "ties") << '\n';
  std::vector<std::vector<std::string>> lines = {{"  number type", "status", "flips", "tests", "wrong tests",
                                                  "not Del.", "inverted", "missing", "length error", "time [s]",
                                                  "x double"}};
  for (const Comparison_row& row : comparison.rows)
    lines.push_back({"  " + title(row.type), row.status, cell(row.flips), cell(row.tests), cell(row.wrong_decisions),
                     cell(row.not_Delaunay), cell(row.inverted_faces), cell(row.missing_edges), cell(row.length_error),
                     cell(row.seconds), cell(row.ratio_to_double)});
  write_aligned(os, lines);
}

void write(std::ostream& os, const std::vector<Comparison_total>& totals)
{
  std::vector<std::vector<std::string>> lines = {{"  number type", "surfaces", "refused", "not ended", "wrong",
                                                  "unnoticed", "wrong tests", "not Del.", "inverted", "missing",
                                                  "length error", "x double"}};
  for (const Comparison_total& total : totals)
    lines.push_back({"  " + title(total.type), std::to_string(total.surfaces), std::to_string(total.refused),
                     std::to_string(total.not_ended), std::to_string(total.wrong), std::to_string(total.unnoticed),
                     std::to_string(total.wrong_decisions), std::to_string(total.not_Delaunay),
                     std::to_string(total.inverted_faces), std::to_string(total.missing_edges),
                     cell(total.length_error), cell(total.ratio_to_double)});
  os << "all together\n";
  write_aligned(os, lines);
}

template <class Item>
Json json_array(const std::vector<Item>& items)
{
  Json json = Json::array();
  for (const Item& item : items)
    json.push_back(to_json_value(item));
  return json;
}

Exit_status run_compare(Compare_options options)
{
  if (!(options.comparison.time_limit > 0))
    throw Usage_error("--time-limit: S is positive");
  if (options.counts_decisions || options.leaves_decisions)
    options.comparison.counts_wrong_decisions = options.counts_decisions;
  options.comparison.types = compared_types(options);
  check_output_paths({options.json_path}, options.inputs);

  std::vector<Surface_comparison> comparisons;
  const Exit_status status = for_each_input(options.inputs, [&](const std::string& path) {
    comparisons.push_back(compare(path, options.comparison));
    if (comparisons.size() > 1)
      std::cout << '\n';
    write(std::cout, comparisons.back());
    flush_standard_output();
    return Exit_status::DONE;
  });

  const std::vector<Comparison_total> all = totals(comparisons, options.comparison.types);
  if (comparisons.size() > 1) {
    std::cout << '\n';
    write(std::cout, all);
    flush_standard_output();
  }
  write_json(options.json_path, {{"surfaces", json_array(comparisons)}, {"totals", json_array(all)}});
  return status;
}

const char* const columns_help =
  "Each number type starts from the same surface. Its result is compared with the surface\n"
  "that the doubles of the input define, by exact decisions and exact lengths:\n"
  "  status        done; not flippable, inconsistent or undecided if some edges defied the\n"
  "                number type; flip budget, time limit, overflow or crashed if it did not\n"
  "                end; refused if the number type cannot hold the surface\n"
  "  wrong tests   Delaunay tests on the way whose outcome is not that of exact arithmetic;\n"
  "                for surfaces of fewer than 100,000 edges unless --count-decisions or\n"
  "                --no-count-decisions says otherwise, as each costs an exact test\n"
  "  not Del.      edges of the result that are not Delaunay\n"
  "  inverted      faces of the result that are inside out\n"
  "  missing       edges that every Delaunay triangulation of the surface has (all but ties),\n"
  "                and the result has not\n"
  "  length error  largest relative error of a length, against the exact length of that edge\n"
  "  time          to build and to flip, the median of several runs in which the number types\n"
  "                take turns; core cannot be interrupted and has one run in a process of its own\n"
  "The totals count a surface as wrong if an edge of its result is not Delaunay or missing, or\n"
  "a face is inverted, and the error as unnoticed if its status is `done` all the same. They\n"
  "give the largest length error and the median of the ratios.\n"
  "`-` stands for what is not known. The status is 0 whatever the number types do.\n";

} // namespace

void add_compare_command(CLI::App& app, Selected_command& selected)
{
  const auto options = std::make_shared<Compare_options>();
  CLI::App& command = *app.add_subcommand("compare", "Compare number types: errors, failures and time");
  command.footer(columns_help);
  command.add_option("INPUT", options->inputs, "as for `idt triangulate`")->required();
  set_words(command.add_option("--number-types", options->number_types,
                               "what to compare, separated by commas; see `idt triangulate --help`"),
            number_type_names(), false)
    ->type_name("NT,NT,...")
    ->delimiter(',')
    ->allow_extra_args(false)
    ->capture_default_str();
  need_one_of(add_option(command, "--precisions", options->precisions, "BITS,BITS,...",
                         "minimum precision in bits, for each run of mpfr"),
              {"--number-types mpfr"})
    ->delimiter(',')
    ->allow_extra_args(false)
    ->check(CLI::Range(2, 1000000))
    ->capture_default_str();
  add_option(command, "--time-limit", options->comparison.time_limit, "S",
             "time limit in seconds for a number type on a surface; each exact check of its result has the same limit")
    ->capture_default_str();
  add_option(command, "--repetitions", options->comparison.repetitions, "N",
             "minimum number of runs, whose median time is reported")
    ->check(CLI::Range(1, 1000))
    ->capture_default_str();
  add_repair_option(command, options->comparison.repair);
  CLI::Option* const count =
    command.add_flag("--count-decisions", options->counts_decisions, "count wrong tests for large surfaces too");
  command.add_flag("--no-count-decisions", options->leaves_decisions, "do not count wrong tests, whatever the size")
    ->excludes(count);
  add_option(command, "--stats,--json", options->json_path, "F.json", "write the tables as a JSON object");
  command.callback([options, &selected] { selected = [options] { return run_compare(*options); }; });
}

} // namespace idt
