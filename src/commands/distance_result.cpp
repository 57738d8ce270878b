// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/distance_result.h"

#include "commands/commands.h"
#include "output/Output_file.h"
#include "output/write_json.h"
#include "output/write_matrices.h"
#include "output/write_overlay.h"
#include "system/Long_text.h"
#include "system/text.h"
#include "view/View.h"

#include <nlohmann/json.hpp>

#include <utility>

namespace idt {
namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Json = nlohmann::ordered_json;

Json statistics(const Distance_options& options, const Distance_result& result)
{
  Json json = {{"input", options.input},
               {"vertices", result.number_of_vertices},
               {"sources", options.sources.vertices},
               {"inserted", result.number_of_inserted_vertices},
               {"flips", result.flips},
               {"method", options.is_by_heat()     ? "heat"
                          : options.maximum_change ? "simplified"
                          : options.method.empty() ? "approximate"
                                                   : options.method},
               {"largest_distance", result.largest_distance()},
               {"unreachable", result.number_of_unreachable_vertices()},
               {"is_complete", result.is_complete},
               {"warnings", result.warnings},
               {"status", "done"},
               {"time",
                {{"read", result.read_seconds},
                 {"triangulation", result.triangulation_seconds},
                 {"distances", result.distance_seconds}}}};
  if (result.mean_edge_length) {
    json["mean_edge_length"] = *result.mean_edge_length;
    json["bounded"] = result.number_of_bounded_distances;
  }
  if (result.change)
    json["simplification"] = {{"vertices", result.number_of_simplified_vertices},
                              {"shrink", result.change->shrink},
                              {"stretch", result.change->stretch}};
  if (options.sources.has_files()) {
    json["source_points"] = options.sources.points_path;
    json["source_edges"] = options.sources.edges_path;
    json["source_curve"] = options.sources.curve_path;
  }
  if (options.barriers.has_files())
    json["barriers"] = {options.barriers.curve_path, options.barriers.edges_path};
  if (!options.targets.empty())
    json["targets"] = options.targets;
  if (result.largest_snap >= 0)
    json["largest_snap"] = result.largest_snap;
  for (const auto& [name, found] : {std::pair("isolines", &result.lines.isolines), {"borders", &result.lines.borders}})
    if (*found)
      json[name] = {{"lines", (*found)->lines.size()}, {"chord_tolerance", (*found)->maximum_deviation}};
  if (result.errors)
    json["error"] = {{"mean", (*result.errors)[0]}, {"largest", (*result.errors)[1]}};
  return json;
}

// Text about the error.
std::string accuracy(const Distance_options& options, const Distance_result& result)
{
  if (!result.is_complete)
    return std::string("some distances may be too large, up to those along edges: there were too many straight ways to "
                       "follow; ") +
           (options.method == "exact" || options.is_compared
              ? "without exact distances there are fewer"
              : "--method heat needs none, and idt refine makes faces that need fewer");
  std::string measured;
  if (result.errors)
    measured =
      "mean error " + in_short(100 * (*result.errors)[0]) + " %, largest " + in_short(100 * (*result.errors)[1]) + " %";
  if (result.change)
    return "proven up to rounding: at most " + in_short_not_below(100 * (1 - result.change->shrink)) +
           " % too short and " + in_short_not_below(100 * (result.change->stretch - 1)) + " % too long, found on " +
           counted(result.number_of_simplified_vertices, "vertex", "vertices") +
           (result.errors ? "; " + measured : std::string());
  if (result.errors)
    return measured;
  if (result.is_far_from_right())
    return "poor: see the warning";
  if (options.is_by_heat())
    return "that of the heat method" +
           (result.nonmanifold_edges > 0 ? ", too long across " + counted(result.nonmanifold_edges, "edge", "edges") +
                                             " with more than two faces, where heat goes to the next faces only"
                                         : "") +
           "; --compare-exact measures it";
  return options.method == "exact" ? "exact up to rounding" : "errors of about 0.1 %, seldom more than 1 %";
}

// A row `vertex,distance` for each vertex, and a column for each coordinate of the vectors: `NAME_x` and so on; `inf`
// where a number is infinite.
void write_csv(std::ostream& os, std::size_t number_of_vertices, const std::vector<Named_values>& values)
{
  os << "vertex";
  for (const std::string& name : coordinate_names(values))
    os << ',' << name;
  os << '\n';
  write_elements(os, number_of_vertices, [&values](Long_text& text, std::size_t v) {
    text << v;
    for_each_coordinate(values, v, [&text](double x) { text << ',' << x; });
    text << '\n';
  });
}

// A row `vertex,source` for each vertex that a source reaches.
void write_labels(std::ostream& os, const Distance_result& result)
{
  os << "vertex,source\n";
  write_elements(os, result.number_of_vertices, [&result](Long_text& text, std::size_t v) {
    if (result.nearest_sources[v] != IT::Geodesic_distances::no_source)
      text << v << ',' << result.nearest_sources[v] << '\n';
  });
}

// A row `vertex,distance` for each chosen vertex, in their order.
void write_samples(std::ostream& os, const Distance_result& result)
{
  os << "vertex,distance\n";
  for (const IT::Farthest_vertex& sample : result.samples)
    os << sample.vertex.idx() << ',' << in_full(sample.distance) << '\n';
}

// The nearest source of each face of the input, and NaN between them.
std::vector<double> labels_of_faces(const Distance_result& result)
{
  std::vector<double> labels;
  for (const auto& [a, b, c] : result.triangles) {
    const std::uint32_t label = result.nearest_sources[a];
    const bool is_one = result.nearest_sources[b] == label && result.nearest_sources[c] == label &&
                        label != IT::Geodesic_distances::no_source;
    labels.push_back(is_one ? double(label) : std::numeric_limits<double>::quiet_NaN());
  }
  return labels;
}

View view_of(const Distance_options& options, const Distance_result& result)
{
  View view =
    result.subdivision
      ? make_view(options.input, options.is_refined ? "refined triangulation" : "intrinsic Delaunay triangulation",
                  *result.subdivision, result.points_below(), result.input_numbers, result.numbers)
      : make_view(options.input, result.points, result.triangles);
  view.fields.push_back({"distance",
                         "in the unit of the input",
                         false,
                         {result.subdivision ? result.overlay_distances.values : result.distances}});
  // Barriers within faces cut these.
  if (!options.labels_path.empty() &&
      (!result.subdivision || result.subdivision->input().number_of_faces() == result.triangles.size()))
    view.fields.push_back({"nearest source", "", true, {labels_of_faces(result)}});
  view.path = result.source_curves;
  view.path_name = "lines with distance zero";
  view.marks = result.source_points;
  if (!options.has_places())
    for (std::uint64_t v : options.sources.vertices)
      view.marks.push_back(result.points[v]);
  view.marks_name = counted(view.marks.size(), "point", "points") + " with distance zero";
  for (const IT::Farthest_vertex& sample : result.samples)
    view.marks.push_back(result.points[sample.vertex.idx()]);
  if (!result.samples.empty())
    view.marks_name += ", and " + counted(result.samples.size(), "chosen vertex", "chosen vertices");
  if (options.lines.are_wanted())
    result.lines.show(view, result.points);
  return view;
}

} // namespace

void write_files(const Distance_options& options, const Distance_result& result)
{
  const std::string& output = options.output_path;
  const std::string type = extension_with_format(output, options.format);
  if (result.points.empty() && result.number_of_vertices > 0 && !type.empty() && type != ".csv")
    throw Usage_error(output + ": " + options.input + " has only lengths, no points: write a .csv file");
  if (result.points.empty() && !(options.overlay_path.empty() && options.view_path.empty()))
    throw Usage_error(options.input + " has only lengths, no points: omit " +
                      (options.overlay_path.empty() ? "--view" : "--overlay"));
  write_file(options.overlay_path, [&](std::ostream& os) {
    write_overlay(os, *result.subdivision, result.points_below(), *options.overlay_format(), false,
                  {result.overlay_distances});
  });
  write_file(output, [&](std::ostream& os) {
    std::vector<Named_values> values{{"distance", result.distances}};
    values.insert(values.end(), result.vectors.begin(), result.vectors.end());
    if (type == ".csv")
      write_csv(os, result.number_of_vertices, values);
    else
      write_mesh(os, result.points, result.triangles, *find_mesh_format(type), values);
  });
  write_file(options.labels_path, [&](std::ostream& os) { write_labels(os, result); });
  write_file(options.matrix_path, [&](std::ostream& os) {
    (extension_with_format(options.matrix_path, options.format) == ".csv"
       ? write_distance_table
       : write_distance_matrix)(os, options.sources.vertices, options.targets, result.distances);
  });
  write_file(options.samples_path, [&](std::ostream& os) { write_samples(os, result); });
  result.lines.write(options.lines, result.points);
  if (!options.view_path.empty())
    write_view(options.view_path, view_of(options, result));
  write_json(options.stats_path, statistics(options, result));
}

void write_report(std::ostream& os, const Distance_options& options, const Distance_result& result)
{
  os << options.input << "\n  input             " << counted(result.number_of_vertices, "vertex", "vertices");
  if (result.number_of_inserted_vertices > 0)
    os << "\n  inserted          " << counted(result.number_of_inserted_vertices, "vertex", "vertices");
  os << "\n  flips             " << with_separators(result.flips) << "\n  largest distance  "
     << in_short(result.largest_distance()) << "\n  accuracy          " << accuracy(options, result) << result.cuts;
  if (result.largest_snap >= 0)
    os << "\n  snap              points in space were up to " << in_short(result.largest_snap) << " from the surface";
  if (options.lines.are_wanted())
    os << "\n  lines             " << result.lines.text();
  if (const std::size_t n = result.number_of_unreachable_vertices())
    os << "\n  unreachable       "
       << (options.matrix_path.empty() ? counted(n, "vertex", "vertices") : counted(n, "pair", "pairs"));
  os << "\n  time              " << seconds_text(result.triangulation_seconds + result.distance_seconds) << '\n';
}

} // namespace idt
