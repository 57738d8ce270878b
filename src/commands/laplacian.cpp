// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `idt laplacian`

#include "commands/command_line.h"
#include "commands/commands.h"

#include "input/Surface.h"
#include "input/Triangle_soup.h"
#include "input/gluing_file.h"
#include "input/saved_triangulation.h"
#include "input/standard_input.h"
#include "output/Output_file.h"
#include "output/write_json.h"
#include "output/write_matrices.h"
#include "system/Progress.h"
#include "system/Stopwatch.h"
#include "system/text.h"
#include "view/View.h"

#include <CGAL/Intrinsic_triangulations/Laplace_Beltrami.h>
#include <CGAL/Intrinsic_triangulations/eigenvalues.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/tufted_Laplacian.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdint>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <numeric>
#include <utility>

namespace idt {
namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Json = nlohmann::ordered_json;

struct Laplacian_options
{
  std::string input;
  std::string stiffness_path, mass_path, stats_path, view_path;
  std::string mass_type = "lumped";
  std::string cover = "tufted";
  std::string coincident_vertices = "merge";
  bool is_welded = false;
  double mollification = 0;
  std::size_t number_of_eigenvalues = 0;

  bool prepares_triangles() const
  {
    return cover != "tufted" || coincident_vertices != "merge" || is_welded || mollification != 0;
  }
};

struct Laplacian_result
{
  IT::Tufted_Laplacian Laplacian;
  std::size_t number_of_faces = 0, triangulated_faces = 0, small_faces = 0; // of the file
  std::vector<double> eigenvalues;
  Triangle_soup soup; // for the view: points and triangles alone
  std::vector<View_field> fields;
  std::vector<std::string> warnings;
  double read_seconds = 0, seconds = 0;

  std::size_t dropped_faces() const { return small_faces + Laplacian.report.dropped_faces(); }
};

auto library_options(const Laplacian_options& options, Progress& progress)
{
  const std::map<std::string, IT::Coincident_vertices> policies = {{"error", IT::Coincident_vertices::ERROR},
                                                                   {"merge", IT::Coincident_vertices::MERGE},
                                                                   {"drop", IT::Coincident_vertices::DROP}};
  return CGAL::parameters::mass_type(options.mass_type == "lumped" ? IT::Mass_type::LUMPED : IT::Mass_type::GALERKIN)
    .surface_cover(options.cover == "tufted" ? IT::Surface_cover::TUFTED : IT::Surface_cover::NONE)
    .coincident_vertices(policies.at(options.coincident_vertices))
    .is_welded(options.is_welded)
    .mollification(options.mollification)
    .visitor(std::ref(progress));
}

// The Laplacian of a saved triangulation, as it is.
void find_operator_of_saved(const Laplacian_options& options, Laplacian_result& result)
{
  Stopwatch stopwatch;
  const Surface surface = load_surface(options.input);
  const auto& triangulation = surface.saved->triangulation;
  result.number_of_faces = triangulation.connectivity().number_of_faces();
  result.read_seconds = stopwatch.restart();
  const Progress progress(options.input, "building matrices");
  IT::Tufted_Laplacian& Laplacian = result.Laplacian;
  Laplacian.stiffness = IT::stiffness_matrix(triangulation, IT::Stiffness_factor::HALF);
  Laplacian.mass =
    options.mass_type == "lumped" ? IT::lumped_mass_matrix(triangulation) : IT::Galerkin_mass_matrix(triangulation);
  const IT::Delta_complex& complex = triangulation.connectivity();
  Laplacian.report.number_of_vertices = complex.number_of_vertices();
  for (IT::Edge_index e : complex.edges())
    Laplacian.report.border_edges += complex.is_border(e);
  Laplacian.representative.resize(Laplacian.report.number_of_vertices);
  std::iota(Laplacian.representative.begin(), Laplacian.representative.end(), 0);
  Laplacian.minimum_weight = IT::summarize_cotangent_weights(triangulation).smallest.value_or(0) / 2;
  result.seconds = stopwatch.seconds();
}

void find_operator(const Laplacian_options& options, Laplacian_result& result)
{
  if (is_saved_triangulation(readable_file(options.input)))
    return find_operator_of_saved(options, result);
  Stopwatch stopwatch;
  if (is_gluing_file(options.input)) {
    Progress progress(options.input, "reading");
    const IT::Exact_gluing gluing = read_gluing_file(options.input, std::ref(progress));
    result.number_of_faces = gluing.complex.number_of_faces();
    result.read_seconds = stopwatch.restart();
    progress.begin("building matrices");
    result.Laplacian = IT::tufted_Laplacian(gluing.complex, gluing.lengths, library_options(options, progress));
  } else {
    Triangle_soup soup = read_triangle_soup(options.input);
    check_view(options.view_path, soup.triangles.size());
    result.number_of_faces = soup.number_of_faces;
    result.triangulated_faces = soup.triangulated_faces;
    result.small_faces = soup.small_faces;
    result.warnings = soup.warnings;
    result.read_seconds = stopwatch.restart();
    Progress progress(options.input, "building matrices");
    result.Laplacian = IT::tufted_Laplacian(soup.points, soup.triangles, library_options(options, progress));
    if (!options.view_path.empty())
      result.soup = std::move(soup);
  }
  result.seconds = stopwatch.seconds();
}

// The functions are for the view. A merged vertex has the value of its representative.
void find_eigenvalues(const Laplacian_options& options, Laplacian_result& result)
{
  const Progress progress(options.input, "factoring, and finding eigenvalues");
  const auto& [stiffness, mass, representative, report, flips, minimum_weight] = result.Laplacian;
  if (options.view_path.empty()) {
    result.eigenvalues = IT::smallest_eigenvalues(stiffness, mass, options.number_of_eigenvalues);
    return;
  }
  const IT::Eigenfunctions found = IT::smallest_eigenfunctions(stiffness, mass, options.number_of_eigenvalues);
  result.eigenvalues = found.eigenvalues;
  for (std::size_t i = 0; i < found.eigenvalues.size(); ++i) {
    std::vector<double> values;
    for (std::uint32_t v : representative)
      values.push_back(found.functions(Eigen::Index(v), Eigen::Index(i)));
    result.fields.push_back({"eigenfunction " + std::to_string(i) + ", eigenvalue " + in_short(found.eigenvalues[i]),
                             "",
                             false,
                             {std::move(values)}});
  }
}

Json mollification_json(const Laplacian_options& options, const IT::Mollification_report& report)
{
  if (options.mollification == 0)
    return nullptr;
  return {{"changed_edges", report.number_of_changed_edges},
          {"epsilon", report.epsilon},
          {"largest_relative_change", report.largest_relative_change}};
}

Json statistics(const Laplacian_options& options, const Laplacian_result& result)
{
  const IT::Tufted_cover_report& report = result.Laplacian.report;
  Json json = {{"input", options.input},
               {"vertices", report.number_of_vertices},
               {"faces", result.number_of_faces},
               {"triangulated_faces", result.triangulated_faces},
               {"nonmanifold_edges", report.nonmanifold_edges},
               {"nonmanifold_vertices", report.nonmanifold_vertices},
               {"border_edges", report.border_edges},
               {"orientable", report.is_orientable},
               {"dropped_faces", result.dropped_faces()},
               {"merged_vertices", report.merged_vertices},
               {"unreferenced_vertices", report.unreferenced_vertices},
               {"mollification", mollification_json(options, report.mollification)},
               {"flips", result.Laplacian.flips.flips},
               {"minimum_weight", result.Laplacian.minimum_weight}};
  if (options.number_of_eigenvalues > 0)
    json["eigenvalues"] = result.eigenvalues;
  json["warnings"] = result.warnings;
  json["status"] = "done";
  json["time"] = {{"read", result.read_seconds}, {"laplacian", result.seconds}};
  return json;
}

void write_report(std::ostream& os, const Laplacian_options& options, const Laplacian_result& result)
{
  const IT::Tufted_cover_report& report = result.Laplacian.report;
  os << options.input << "\n  input             " << counted(report.number_of_vertices, "vertex", "vertices") << ", "
     << counted(result.number_of_faces, "face", "faces");
  if (result.triangulated_faces > 0)
    os << ", " << with_separators(result.triangulated_faces) << " cut into triangles";
  os << "\n  not manifold      " << counted(report.nonmanifold_edges, "edge", "edges") << ", "
     << counted(report.nonmanifold_vertices, "vertex", "vertices") << "; "
     << counted(report.border_edges, "border edge", "border edges") << (report.is_orientable ? "" : "; not orientable");
  const auto line = [&os](std::size_t number, const char* singular, const char* plural, const char* why) {
    if (number > 0)
      os << "\n  dropped           " << counted(number, singular, plural) << ' ' << why;
  };
  line(result.small_faces, "face", "faces", "that enclose nothing");
  line(report.repeated_corner_faces, "face", "faces", "with a vertex as two corners");
  line(report.collapsed_faces, "face", "faces", "whose corners were merged");
  line(report.zero_length_faces, "face", "faces", "with a side of length zero");
  line(report.faces_without_area, "face", "faces", "connected only with faces of zero area");
  if (report.merged_vertices > 0)
    os << "\n  merged            " << counted(report.merged_vertices, "vertex", "vertices")
       << " with another at the same place: rows of zeros";
  if (report.unreferenced_vertices > 0)
    os << "\n  without faces     " << counted(report.unreferenced_vertices, "vertex", "vertices") << ": rows of zeros";
  if (options.mollification > 0)
    os << "\n  mollification     " << counted(report.mollification.number_of_changed_edges, "edge", "edges")
       << " longer, by a factor of 1 + " << in_short(report.mollification.largest_relative_change) << " at most";
  os << "\n  flips             " << with_separators(result.Laplacian.flips.flips) << "\n  smallest weight   "
     << in_short(result.Laplacian.minimum_weight) << "\n  time              " << seconds_text(result.seconds) << '\n';
  for (std::size_t i = 0; i < result.eigenvalues.size(); ++i)
    os << (i == 0 ? "  eigenvalues       " : "                    ") << in_full(result.eigenvalues[i]) << '\n';
}

Exit_status run_Laplacian(const Laplacian_options& options)
{
  if (!(options.mollification >= 0 && options.mollification <= 1e6))
    throw Usage_error("--mollify: D is between 0 and 1e6");
  check_output_paths({options.stiffness_path, options.mass_path, options.stats_path, options.view_path},
                     {options.input});
  check_view(options.view_path);
  if (!options.view_path.empty() && is_gluing_file(options.input))
    throw Usage_error(options.input + " has only lengths, no points: omit --view");
  if (is_saved_triangulation(options.input) && options.prepares_triangles())
    throw Usage_error(options.input + ": --cover, --coincident-vertices, --weld and --mollify are for meshes; the "
                                      "Laplacian of a saved triangulation is that of its faces, as they are");
  if (!options.view_path.empty() && is_saved_triangulation(options.input))
    throw Usage_error("--view: idt view shows " + options.input);
  return for_each_input({options.input}, [&](const std::string&) {
    Laplacian_result result;
    find_operator(options, result);
    if (options.number_of_eigenvalues > 0)
      find_eigenvalues(options, result);
    write_file(options.stiffness_path,
               [&](std::ostream& os) { write_stiffness_matrix(os, result.Laplacian.stiffness); });
    write_file(options.mass_path,
               [&](std::ostream& os) { write_mass_matrix(os, result.Laplacian.mass, options.mass_type == "lumped"); });
    if (!options.view_path.empty()) {
      View view = make_view(options.input, result.soup.points, result.soup.triangles);
      view.fields = std::move(result.fields);
      write_view(options.view_path, view);
    }
    write_json(options.stats_path, statistics(options, result));
    write_report(std::cout, options, result);
    flush_standard_output();
    return Exit_status::DONE;
  });
}

} // namespace

void add_Laplacian_command(CLI::App& app, Selected_command& selected)
{
  const auto options = std::make_shared<Laplacian_options>();
  CLI::App& command = *app.add_subcommand(
    "laplacian", "Compute the Laplace-Beltrami operator of any triangles, which need not be a surface");
  command.footer("Edges may have any number of faces, which need not be oriented; there may be borders,\n"
                 "duplicate faces, several components and vertices without faces. No length is changed\n"
                 "unless --mollify is given, and no entry off the diagonal is positive, except at the border\n"
                 "with --cover none.\n");
  command
    .add_option("INPUT", options->input,
                "a mesh (OFF, OBJ, PLY, STL, TS), or a .gluing file of triangles with lengths; - is the standard input")
    ->required();
  add_option(
    command, "--stiffness", options->stiffness_path, "L.mtx",
    "write the operator as a Matrix Market file: positive semidefinite, entries -(cot + cot)/2, rows in the order "
    "of the vertices");
  add_option(command, "--mass", options->mass_path, "M.mtx", "write the mass matrix");
  set_words(need_one_of(command.add_option("--mass-type", options->mass_type,
                                           "lumped: a third of the area around each vertex; galerkin: the mass matrix "
                                           "of linear finite elements"),
                        {"--mass", "--eigenvalues"}),
            {"lumped", "galerkin"})
    ->capture_default_str();
  set_words(
    command.add_option("--cover", options->cover,
                       "tufted: two copies of each face, glued around each edge, where the surface is not closed; "
                       "none: the faces themselves, which must form an orientable surface, with a fixed border"),
    {"tufted", "none"})
    ->capture_default_str();
  set_words(
    command.add_option(
      "--coincident-vertices", options->coincident_vertices,
      "what to do if an edge joins two vertices at the same place: report an error, merge them, or drop its faces"),
    {"error", "merge", "drop"})
    ->capture_default_str();
  command.add_flag("--weld", options->is_welded, "first merge all vertices at the same place");
  add_option(command, "--mollify", options->mollification, "D",
             "lengthen all edges by the same amount, so that each triangle inequality holds with a margin of D times "
             "the mean length");
  add_option(command, "--eigenvalues", options->number_of_eigenvalues, "K", "print the K smallest eigenvalues")
    ->check(CLI::Range(1, 10000));
  add_view_option(command, options->view_path);
  add_option(command, "--stats", options->stats_path, "F.json", "write the report as a JSON object");
  command.callback([options, &selected] { selected = [options] { return run_Laplacian(*options); }; });
}

} // namespace idt
