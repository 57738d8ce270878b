// SPDX-License-Identifier: GPL-3.0-or-later
//
// `idt table`: the columns of Table 1 in Fisher, Springborn, Schroeder, Bobenko (2006).

#include "Output_file.h"
#include "commands.h"
#include "text.h"
#include "triangulate.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace idt {
namespace {

using Json = nlohmann::ordered_json;

struct Table_options
{
  std::vector<std::string> inputs;
  std::string json_path;
};

struct Row
{
  std::string model;
  std::optional<std::uint64_t> vertices;
  std::optional<std::uint64_t> flips;
  std::optional<std::uint64_t> simple;
  std::optional<std::uint64_t> longest;
  std::optional<double> condition_ratio;
  std::optional<std::uint64_t> crossings;
  std::optional<double> seconds; // to build and to flip
};

using Line = std::vector<std::string>;

std::string cell(const std::optional<std::uint64_t>& number)
{
  return number ? std::to_string(*number) : "-";
}

std::string cell(const std::optional<double>& number) { return number ? in_short(*number) : "-"; }

template <class T>
Json json_value(const std::optional<T>& value)
{
  return value ? Json(*value) : Json(nullptr);
}

Line line(const Row& row)
{
  return {row.model,
          cell(row.vertices),
          cell(row.flips),
          cell(row.simple),
          cell(row.longest),
          cell(row.condition_ratio),
          cell(row.crossings),
          cell(row.seconds)};
}

Json json_row(const Row& row)
{
  return {{"model", row.model},
          {"vertices", json_value(row.vertices)},
          {"flips", json_value(row.flips)},
          {"simple", json_value(row.simple)},
          {"longest", json_value(row.longest)},
          {"condition_ratio", json_value(row.condition_ratio)},
          {"crossings", json_value(row.crossings)},
          {"seconds", json_value(row.seconds)}};
}

void write_table(std::ostream& os, const std::vector<Row>& rows)
{
  std::vector<Line> lines = {{"model", "V", "flips", "simple", "longest", "cond ratio",
                              "crossings", "time [s]"}};
  for (const Row& row : rows)
    lines.push_back(line(row));
  write_aligned(os, lines);
}

Exit_status run_table(const Table_options& options)
{
  check_output_paths({options.json_path}, options.inputs);
  Kernel_options kernel_options;
  kernel_options.wanted = Wanted::nothing();
  kernel_options.wanted.crossings = true;
  std::vector<Row> rows;
  const Exit_status status = for_each_input(options.inputs, [&](const std::string& path) {
    rows.emplace_back();
    rows.back().model = std::filesystem::path(path).stem().string();
    const Triangulation_result result = triangulate(path, kernel_options, std::nullopt);
    Row& row = rows.back();
    row.vertices = result.counts.vertices;
    row.flips = result.outcome.report.flips;
    if (const std::optional<Crossing_summary>& summary = result.outcome.crossing_summary) {
      row.simple = summary->simple;
      row.longest = summary->longest;
      row.crossings = summary->crossings;
    }
    row.seconds =
      result.surface.build_seconds + result.outcome.build_seconds + result.outcome.flip_seconds;
    const Exit_status row_status = exit_status(result.outcome);
    if (row_status != Exit_status::DONE)
      std::cerr << "idt: " << path << ": " << describe_status(result) << std::endl;
    return row_status;
  });

  write_table(std::cout, rows);
  flush_standard_output();
  if (!options.json_path.empty()) {
    Json json = Json::array();
    for (const Row& row : rows)
      json.push_back(json_row(row));
    Output_file file(options.json_path);
    // A file name need not be valid UTF-8.
    file.stream() << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
    file.commit();
  }
  return status;
}

} // namespace

void add_table_command(CLI::App& app, Selected_command& selected)
{
  const auto options = std::make_shared<Table_options>();
  CLI::App& command =
    *app.add_subcommand("table", "Show flips and crossings of surfaces as a table");
  command.footer("V: vertices; simple: intrinsic edges that cross exactly one input edge; longest:\n"
                 "the largest number of segments in one intrinsic edge; cond ratio: condition number\n"
                 "of the intrinsic Laplacian over that of the extrinsic one; crossings: in all;\n"
                 "time: to build the triangulation and to flip. `-` stands for what is not known.\n");
  command.add_option("INPUT", options->inputs, "as for `idt triangulate`")->required();
  command.add_option("--json", options->json_path, "write the rows as a JSON array of objects")
    ->type_name("F.json");
  command.callback([options, &selected] { selected = [options] { return run_table(*options); }; });
}

} // namespace idt
