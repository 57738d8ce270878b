// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `idt simplify`

#include "commands/command_line.h"
#include "commands/commands.h"
#include "input/Surface.h"
#include "input/mesh_file.h"
#include "input/saved_triangulation.h"
#include "input/standard_input.h"
#include "input/vertex_values.h"
#include "number_types/make_triangulation.h"
#include "output/Output_file.h"
#include "output/write_json.h"
#include "output/write_matrices.h"
#include "system/Interruption.h"
#include "system/Long_text.h"
#include "system/Progress.h"
#include "system/Stopwatch.h"
#include "system/text.h"
#include "view/View.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Point_location.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/transfer_matrices.h>
#include <CGAL/Intrinsic_triangulations/simplify_surface.h>
#include <CGAL/Intrinsic_triangulations/triangulation_io.h>

#include <boost/property_map/function_property_map.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace idt {
namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Json = nlohmann::ordered_json;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

struct Simplify_options
{
  std::string input, output, kept, vertex_map, places, prolongation, view, stats;
  std::optional<double> maximum_change, constrained_angle;
  std::optional<std::uint64_t> number_of_vertices;
  Repair_options repair;
};

void check(const Simplify_options& options)
{
  if (options.maximum_change && !(*options.maximum_change >= 0))
    throw Usage_error("--maximum-change: C has to be a number that is not negative");
  if (options.number_of_vertices && *options.number_of_vertices == 0)
    throw Usage_error("--vertices: N has to be positive; without it, --maximum-change alone decides");
  if (options.constrained_angle && !(*options.constrained_angle >= 0 && *options.constrained_angle <= 180))
    throw Usage_error("--constrain-angle: D is between 0 and 180 degrees");
  if (!options.output.empty() && !is_saved_triangulation(name_with_format(options.output, "idt"))) {
    if (find_mesh_format(options.output))
      throw Usage_error(options.output +
                        ": a simplified surface has edge lengths, but no points: straight triangles between its "
                        "vertices would have other lengths, and nothing would be known of distances. Write a file "
                        "that ends in .idt, and see it by --view");
    throw Usage_error("-o: " + options.output + " does not end in .idt, by which the file is known as a triangulation");
  }
  check_output_paths(
    {options.output, options.vertex_map, options.places, options.prolongation, options.view, options.stats},
    {options.input, options.kept});
  check_view(options.view);
}

// The vertices of a table `vertex,NAME` whose number is not zero.
std::vector<bool> kept_vertices(const Simplify_options& options, std::size_t number_of_vertices)
{
  std::vector<bool> result(number_of_vertices);
  if (options.kept.empty())
    return result;
  for (const auto& [v, value] : read_numbers_of_vertices(options.kept, number_of_vertices))
    result[v] = value != 0;
  return result;
}

// Those of a saved triangulation.
std::vector<bool> constrained_edges(const Surface& surface, const Triangulation& triangulation)
{
  const IT::Delta_complex& complex = triangulation.connectivity();
  std::vector<bool> result(complex.number_of_edges());
  if (surface.saved && !surface.saved->is_constrained.empty())
    for (IT::Edge_index e : complex.edges())
      result[e.idx()] =
        triangulation.is_input_edge(e) &&
        surface.saved->is_constrained[complex.edge(triangulation.input_halfedge(complex.halfedge(e))).idx()];
  return result;
}

// The possible change of distances, as a percentage: zero if it is no more than rounding may take.
double percentage(const IT::Metric_change& change)
{
  const double result = 100 * ((std::max)(change.stretch, 1 / change.shrink) - 1);
  return result > 1e-10 ? result : 0;
}

// Rounded away from what is proven of all distances. Near 1, the difference tells more.
std::string bound_text(double factor, bool is_upper)
{
  const double off = factor - 1;
  const auto rounded = [](double x, bool is_up) { return is_up ? in_short_not_below(x) : in_short_not_above(x); };
  if (off == 0 || std::abs(off) > 1e-3)
    return rounded(factor, is_upper);
  return (off > 0 ? "1 + " : "1 - ") + rounded(std::abs(off), (off > 0) == is_upper);
}

std::string proven_text(const IT::Simplified_surface& result)
{
  return "distances are between " + bound_text(result.shrink, false) + " and " + bound_text(result.stretch, true) +
         " times what they were, proven";
}

// The edges of the result on the input, coloured by the possible change of distances beside them.
View view_of(const Simplify_options& options, const Surface& surface, const Triangulation& fine,
             const IT::Element_numbers& input_numbers, const IT::Simplified_surface& result)
{
  const IT::Common_subdivision subdivision(fine);
  View view = make_view(options.input, "before the simplification", subdivision, surface.points, input_numbers,
                        IT::element_numbers(fine));
  const IT::Delta_complex& coarse = result.map.coarse();
  std::vector<IT::Simplification_map::Line_part> lines;
  std::vector<double> changes;
  for (IT::Edge_index e : coarse.edges()) {
    const IT::Halfedge_index h =
      coarse.is_border(coarse.halfedge(e)) ? coarse.opposite(coarse.halfedge(e)) : coarse.halfedge(e);
    lines.push_back({IT::Surface_point{h, {1, 0, 0}}, IT::Surface_point{h, {0, 1, 0}}});
    changes.push_back(percentage(result.changes_in_faces[coarse.face(h).idx()]));
    if (!coarse.is_border(e))
      changes.back() =
        (std::max)(changes.back(), percentage(result.changes_in_faces[coarse.face(coarse.opposite(h)).idx()]));
  }
  const IT::Point_location location(subdivision);
  const auto add = [&](const std::array<double, 3>& point, std::size_t line) {
    view.path.push_back(point);
    view.path_numbers.push_back(changes[line]);
  };
  const auto in_space = [&](const IT::Surface_point& p) {
    return IT::point_in_space(fine.input(), surface.points, location.intrinsic_to_input(p));
  };
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const std::vector<IT::Simplification_map::Line> on_fine = result.map.lines_to_fine(lines);
  for (std::size_t i = 0; i < on_fine.size(); ++i) {
    add({none, none, none}, i); // not joined to the one before
    for (const auto& [from, to] : on_fine[i]) {
      add(in_space(from), i);
      add(in_space(to), i);
    }
  }
  view.path_unit = "% by which lengths beside the edges may have changed";
  view.path_name =
    "edges of the result, which has " + counted(result.kept.size(), "vertex", "vertices") + "; " + proven_text(result);
  return view;
}

void write_places(std::ostream& os, const IT::Simplified_surface& result)
{
  const IT::Delta_complex& coarse = result.map.coarse();
  os << "vertex,face,b0,b1,b2\n";
  write_elements(os, result.places.size(), [&](Long_text& text, std::size_t v) {
    const IT::Surface_point& place = result.places[v];
    if (!place.halfedge.is_valid())
      return;
    const IT::Face_index f = coarse.face(place.halfedge);
    text << v << ',' << f.idx();
    for (double x : IT::coordinates_from(coarse, place, coarse.halfedge(f)))
      text << ',' << x;
    text << '\n';
  });
}

Json statistics(const Simplify_options& options, std::size_t number_of_vertices, const IT::Simplified_surface& result,
                double seconds)
{
  Json components = Json::array();
  for (const auto& [face, change] : result.changes_of_components)
    components.push_back({{"face", face.idx()}, {"shrink", change.shrink}, {"stretch", change.stretch}});
  const IT::Kept_vertices& reasons = result.reasons;
  return {{"input", options.input},
          {"input_vertices", number_of_vertices},
          {"vertices", result.kept.size()},
          {"faces", result.map.coarse().number_of_faces()},
          {"shrink", result.shrink},
          {"stretch", result.stretch},
          {"components", components},
          {"kept",
           {{"by_bound", reasons.by_bound},
            {"by_request", reasons.by_request},
            {"as_corners", reasons.as_corners},
            {"for_gluing", reasons.for_gluing},
            {"by_number", reasons.by_number},
            {"isolated", reasons.isolated}}},
          {"status", "done"},
          {"time", seconds}};
}

void write_report(std::ostream& os, const Simplify_options& options, std::size_t number_of_vertices,
                  const IT::Simplified_surface& result, double seconds)
{
  const IT::Kept_vertices& reasons = result.reasons;
  os << options.input << "\n  input             " << counted(number_of_vertices, "vertex", "vertices")
     << "\n  result            " << counted(result.kept.size(), "vertex", "vertices")
     << "\n  distances         between " << bound_text(result.shrink, false) << " and "
     << bound_text(result.stretch, true) << " times what they were, proven";
  const bool has_bound = options.maximum_change || !options.number_of_vertices;
  const std::pair<const char*, std::size_t> kept[] = {
    {has_bound ? "for the bound" : "as nothing could be proven without them", reasons.by_bound},
    {"by request", reasons.by_request},
    {"as corners", reasons.as_corners},
    {"for loops, or fewer than three faces", reasons.for_gluing},
    {"as so many were asked for", reasons.by_number},
    {"isolated", reasons.isolated}};
  for (const auto& [name, n] : kept)
    if (n > 0)
      os << "\n  kept              " << with_separators(n) << ' ' << name;
  os << "\n  time              " << seconds_text(seconds) << '\n';
}

Exit_status simplify_file(const std::string& path, const Simplify_options& options)
{
  Surface surface = load_surface(path, options.repair);
  if (!options.view.empty() && !surface.has_points())
    throw Usage_error(path + " has only lengths, no points: omit --view");
  check_view(options.view, surface.connectivity.number_of_faces());
  Stopwatch stopwatch;
  Progress progress(path, "simplifying");
  Triangulation fine = first_triangulation<IT::Filtered_edge_length_traits>(surface);
  fine.set_interruption([] { return !is_interrupted(); });
  IT::Element_numbers input_numbers;
  if (!options.view.empty())
    input_numbers = IT::element_numbers(make_triangulation<IT::Filtered_edge_length_traits>(surface));
  const std::vector<bool> is_kept = kept_vertices(options, fine.connectivity().number_of_vertices()),
                          is_constrained = constrained_edges(surface, fine);
  if (options.constrained_angle && !surface.has_points())
    refuse_file(path, "--constrain-angle needs a surface in space, but this one has only edge lengths");
  const IT::Simplified_surface result =
    IT::simplify_surface(fine, CGAL::parameters::maximum_change(options.maximum_change)
                                 .number_of_vertices(options.number_of_vertices.value_or(0))
                                 .sharp_angle(options.constrained_angle.value_or(180))
                                 .vertex_is_constrained_map(boost::make_function_property_map<IT::Vertex_index, bool>(
                                   [&](IT::Vertex_index v) { return bool(is_kept[v.idx()]); }))
                                 .edge_is_constrained_map(boost::make_function_property_map<IT::Edge_index, bool>(
                                   [&](IT::Edge_index e) { return bool(is_constrained[e.idx()]); }))
                                 .visitor([&](double done) { return progress(done); }));
  const double seconds = stopwatch.seconds();
  const std::size_t n = fine.connectivity().number_of_vertices();
  write_file(options.output, [&](std::ostream& os) {
    std::vector<IT::Halfedge_index> first_sides;
    for (IT::Face_index f : result.map.coarse().faces())
      first_sides.push_back(result.map.coarse().halfedge(f));
    IT::write_triangulation(os, result.triangulation, first_sides,
                            CGAL::parameters::edge_is_constrained_map(
                              boost::make_function_property_map<IT::Edge_index, bool>([&](IT::Edge_index e) {
                                return bool(result.is_constrained[e.idx()]); // not flipped, so the same edge
                              })));
  });
  write_file(options.vertex_map, [&](std::ostream& os) {
    os << "vertex,input\n";
    for (std::size_t v = 0; v < result.kept.size(); ++v)
      os << v << ',' << result.kept[v].idx() << '\n';
  });
  write_file(options.places, [&](std::ostream& os) { write_places(os, result); });
  write_file(options.prolongation, [&](std::ostream& os) {
    write_prolongation_matrix(os, IT::prolongation_matrix(result.triangulation, result.places));
  });
  if (!options.view.empty())
    write_view(options.view, view_of(options, surface, fine, input_numbers, result));
  write_json(options.stats, statistics(options, n, result, seconds));
  write_report(std::cout, options, n, result, seconds);
  flush_standard_output();
  return Exit_status::DONE;
}

Exit_status run_simplify(const Simplify_options& options)
{
  check(options);
  return for_each_input({options.input}, [&](const std::string& path) { return simplify_file(path, options); });
}

} // namespace

void add_simplify_command(CLI::App& app, Selected_command& selected)
{
  const auto options = std::make_shared<Simplify_options>();
  CLI::App& command =
    *app.add_subcommand("simplify", "Remove vertices, with a proven bound of how much any distance changes");
  command.footer(
    "The result is another surface, given by edge lengths: no other subcommand changes lengths. Every\n"
    "distance on it, of any two points, is between `shrink` and `stretch` times what it was; both are\n"
    "proven, and reported. Every subcommand reads the result. Flat vertices go first, and cost nothing.\n");
  command.add_option("INPUT", options->input, "as for `idt triangulate`")->required();
  add_option(command, "-o,--output", options->output, "F.idt", "write the result as a saved triangulation");
  add_option(
    command, "--maximum-change", options->maximum_change, "C",
    "by which part a distance may change, to 1/(1+C) or 1+C times what it was: 0.05 for 5 percent, the default "
    "without --vertices. Rounding may take up to 1e-12");
  add_option(command, "--vertices", options->number_of_vertices, "N", "stop when N vertices are left")
    ->transform(whole_number());
  add_option(command, "--keep", options->kept, "F.csv",
             "keep the vertices whose number is not zero in this table, as CSV: vertex,NAME");
  add_option(command, "--constrain-angle", options->constrained_angle, "D",
             "keep the edges whose two faces have normals that differ by more than D degrees, as lines that may become "
             "straight");
  add_option(command, "--vertex-map", options->vertex_map, "F.csv",
             "write which vertex of the input each vertex is, as CSV: vertex,input");
  add_option(command, "--places", options->places, "F.csv",
             "write where each vertex of the input lies on the result, as CSV: vertex,face,b0,b1,b2");
  add_option(command, "--prolongation", options->prolongation, "F.mtx",
             "write the matrix that carries values at the vertices of the result to those of the input");
  add_view_option(command, options->view);
  add_repair_option(command, options->repair);
  add_option(command, "--stats", options->stats, "F.json", "write the report as a JSON object");
  command.callback([options, &selected] { selected = [options] { return run_simplify(*options); }; });
}

} // namespace idt
