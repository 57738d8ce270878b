// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `idt table`: the columns of Table 1 in Fisher, Springborn, Schroeder, Bobenko (2006).

#include "output/write_json.h"
#include "commands/commands.h"
#include "commands/command_line.h"
#include "output/finite_weights.h"
#include "input/repair.h"
#include "system/Progress.h"
#include "system/text.h"
#include "commands/triangulate.h"

#include <CGAL/Intrinsic_triangulations/Laplace_Beltrami.h>
#include <CGAL/Intrinsic_triangulations/eigenvalues.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace idt {
namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Json = nlohmann::ordered_json;

struct Table_options
{
  std::vector<std::string> inputs;
  std::string json_path;
  bool without_condition = false;
  Repair_options repair;
};

// A row of Table 1 in Fisher, Springborn, Schroeder, Bobenko (2006).
struct Paper_row
{
  const char* model;
  std::uint64_t vertices;
  std::uint64_t flips;
  std::uint64_t simple;
  std::uint64_t longest;
  double condition_ratio;
  std::optional<std::uint64_t> crossings; // the paper does not give all
};

// The row of a model, identified by its name and number of vertices, or none.
const Paper_row* find_paper_row(const std::string& model, std::uint64_t vertices)
{
  static const Paper_row rows[] = {
    {"cathead", 131, 45, 40, 3, 0.8114, {}},
    {"bunnyhead", 741, 380, 275, 6, 0.6139, {}},
    {"beautiful_freak", 1042, 560, 364, 12, 0.1841, {}},
    {"hygeia", 8268, 4017, 2861, 6, 0.1053, {}},
    {"planck", 25445, 6417, 5584, 5, 0.7746, 7167},
    {"bunny", 34834, 2365, 2283, 4, 0.0758, 2434},
    {"camel", 40240, 17074, 12618, 22, 0.7218, 25043},
    {"horse", 48485, 3581, 3127, 7, 0.6734, 4027},
    {"feline", 49864, 12178, 10767, 7, 0.5746, 13317},
  };
  for (const Paper_row& row : rows)
    if (row.model == model && row.vertices == vertices)
      return &row;
  return nullptr;
}

struct Operator_summary
{
  IT::Extreme_eigenvalues eigenvalues;
  IT::Weight_histogram histogram;
  IT::Weight_summary weights;
};

struct Row
{
  std::string model;
  std::optional<std::uint64_t> vertices;
  std::optional<std::uint64_t> flips;
  std::optional<std::uint64_t> simple;
  std::optional<std::uint64_t> longest;
  std::optional<std::uint64_t> crossings;
  std::optional<double> minimum_angle; // of the result, in degrees
  std::optional<double> seconds;       // to build and to flip
  Repairs repairs;
  std::vector<std::string> warnings;
  const Paper_row* paper = nullptr;
  // For the Laplace-Beltrami operators before and after the flips.
  std::optional<Operator_summary> before;
  std::optional<Operator_summary> after;
};

using Line = std::vector<std::string>;

std::optional<double> condition_ratio(const Row& row)
{
  if (!row.before || !row.after)
    return std::nullopt;
  return row.after->eigenvalues.condition_number() / row.before->eigenvalues.condition_number();
}

Line line(const Row& row)
{
  return {row.model,           cell(row.vertices),      cell(row.flips),
          cell(row.simple),    cell(row.longest),       cell(condition_ratio(row)),
          cell(row.crossings), cell(row.minimum_angle), cell(row.seconds)};
}

// The paper's figures, below ours for the same model.
Line line(const Paper_row& row)
{
  return {"  paper",
          "",
          std::to_string(row.flips),
          std::to_string(row.simple),
          std::to_string(row.longest),
          in_short(row.condition_ratio),
          cell(row.crossings),
          "",
          ""};
}

Json json_value(const Paper_row* row)
{
  if (row == nullptr)
    return nullptr;
  return {{"flips", row->flips},
          {"simple", row->simple},
          {"longest", row->longest},
          {"condition_ratio", row->condition_ratio},
          {"crossings", row->crossings}};
}

Json json_value(const std::optional<Operator_summary>& summary)
{
  if (!summary)
    return nullptr;
  return {{"smallest_eigenvalue", summary->eigenvalues.smallest},
          {"largest_eigenvalue", summary->eigenvalues.largest},
          {"condition_number", summary->eigenvalues.condition_number()},
          {"min_weight", summary->weights.smallest},
          {"negative_weights", summary->weights.negative},
          {"weight_histogram",
           {{"low", summary->histogram.low},
            {"high", summary->histogram.high},
            {"counts", summary->histogram.counts},
            {"below", summary->histogram.below},
            {"above", summary->histogram.above}}}};
}

Json json_row(const Row& row)
{
  return {{"model", row.model},
          {"vertices", row.vertices},
          {"flips", row.flips},
          {"simple", row.simple},
          {"longest", row.longest},
          {"condition_ratio", condition_ratio(row)},
          {"crossings", row.crossings},
          {"minimum_angle_degrees", row.minimum_angle},
          {"seconds", row.seconds},
          {"repair", to_json_value(row.repairs)},
          {"warnings", row.warnings},
          {"paper", json_value(row.paper)},
          {"extrinsic", json_value(row.before)},
          {"intrinsic", json_value(row.after)}};
}

void write_table(std::ostream& os, const std::vector<Row>& rows)
{
  std::vector<Line> lines = {
    {"model", "V", "flips", "simple", "longest", "cond ratio", "crossings", "min angle", "time [s]"}};
  for (const Row& row : rows) {
    lines.push_back(line(row));
    if (row.paper != nullptr)
      lines.push_back(line(*row.paper));
  }
  write_aligned(os, lines);
}

Operator_summary summarize(const Surface& surface, const IT::Delta_complex& complex, const IT::Element_numbers& numbers,
                           const IT::Weight_summary& weight_summary)
{
  require_finite_weights(surface, complex, numbers);
  const std::vector<double>& weights = numbers.cotangent_weights;
  // The weights of an equilateral triangulation are 1.15; far out, only slivers count.
  return {IT::extreme_eigenvalues(complex, IT::stiffness_matrix(complex, weights)),
          IT::weight_histogram(complex, weights, -10, 10, 80), weight_summary};
}

// A surface without a condition number still has all the other columns.
void find_condition(const Triangulation_result& result, Row& row)
{
  const Outcome& outcome = result.outcome;
  try {
    const Progress progress(result.surface.path, "factoring, and finding eigenvalues");
    row.before = summarize(result.surface, result.surface.connectivity, outcome.input_numbers, *outcome.weights_before);
    row.after = summarize(result.surface, outcome.connectivity, outcome.numbers, *outcome.weights_after);
  } catch (const IT::Error& error) {
    std::cerr << "idt: " << result.surface.path << ": no condition number: " << error.what()
              << "; --without-condition omits it" << std::endl;
  }
}

Exit_status run_table(const Table_options& options)
{
  check_output_paths({options.json_path}, options.inputs);
  Run_options run_options;
  run_options.wanted.crossings = run_options.wanted.shapes = true;
  run_options.wanted.weights = run_options.wanted.numbers = run_options.wanted.input_numbers =
    !options.without_condition;
  std::vector<Row> rows;
  const Exit_status status = for_each_input(options.inputs, [&](const std::string& path) {
    rows.emplace_back();
    rows.back().model = std::filesystem::path(path).stem().string();
    const Triangulation_result result = triangulate(load_surface(path, options.repair), run_options);
    Row& row = rows.back();
    row.vertices = result.counts.vertices;
    row.flips = result.outcome.report.flips;
    if (const std::optional<Crossing_summary>& summary = result.outcome.crossing_summary) {
      row.simple = summary->simple;
      row.longest = summary->longest;
      row.crossings = summary->crossings;
    }
    if (result.outcome.shapes)
      row.minimum_angle = result.outcome.shapes->minimum_angle;
    row.seconds = result.surface.build_seconds + result.outcome.build_seconds + result.outcome.flip_seconds;
    row.repairs = repairs(result.surface);
    row.warnings = result.surface.warnings;
    row.paper = find_paper_row(row.model, result.counts.vertices);
    if (!options.without_condition)
      find_condition(result, row);
    const Exit_status row_status = exit_status(result.outcome);
    if (row_status != Exit_status::DONE)
      std::cerr << "idt: " << path << ": " << describe_status(result) << std::endl;
    return row_status;
  });

  write_table(std::cout, rows);
  flush_standard_output();
  Json json = Json::array();
  for (const Row& row : rows)
    json.push_back(json_row(row));
  write_json(options.json_path, json);
  return status;
}

} // namespace

void add_table_command(CLI::App& app, Selected_command& selected)
{
  const auto options = std::make_shared<Table_options>();
  CLI::App& command = *app.add_subcommand("table", "Show flips, crossings and condition of surfaces as a table");
  command.footer("V: vertices; simple: intrinsic edges that cross exactly one input edge; longest:\n"
                 "the largest number of segments in one intrinsic edge; cond ratio: condition number\n"
                 "of the intrinsic Laplacian over that of the extrinsic one, both for the inner\n"
                 "vertices and without zero eigenvalues; crossings: in all; min angle: the smallest angle\n"
                 "of the result, in degrees; time: to build the triangulation and to flip. `-` stands\n"
                 "for an unknown value. Below a model of the\n"
                 "paper (cathead, bunnyhead, beautiful_freak, hygeia, planck, bunny, camel, horse,\n"
                 "feline, with as many vertices as there) are its figures.\n");
  command.add_option("INPUT", options->inputs, "as for `idt triangulate`")->required();
  add_repair_option(command, options->repair);
  command.add_flag("--without-condition", options->without_condition,
                   "omit the condition numbers, which take longer than everything else");
  add_option(command, "--stats,--json", options->json_path, "F.json", "write the rows as a JSON array of objects");
  command.callback([options, &selected] { selected = [options] { return run_table(*options); }; });
}

} // namespace idt
