// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `idt parameterize`

#include "output/Output_file.h"
#include "output/write_json.h"
#include "system/Progress.h"
#include "system/Stopwatch.h"
#include "commands/command_line.h"
#include "commands/conformal_map.h"
#include "commands/commands.h"
#include "output/finite_weights.h"
#include "input/mesh_file.h"
#include "input/repair.h"
#include "system/text.h"
#include "commands/triangulate.h"
#include "output/Textured_mesh.h"
#include "view/View.h"

#include <CGAL/Intrinsic_triangulations/harmonic_parameterization.h>
#include <CGAL/Intrinsic_triangulations/observer.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdint>
#include <functional>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace idt {
namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Json = nlohmann::ordered_json;

// The properties of a map on one of the two triangulations.
struct Quality
{
  IT::Parameterization_check check;
  std::vector<double> distortion; // of each face
  IT::Distortion_summary summary;
};

struct Result
{
  Triangulation_result triangulation;
  IT::Planar_points uv;
  Quality on_input, on_intrinsic;
  double seconds = 0;
};

void check(Parameterize_options& options)
{
  if (options.boundary.empty())
    options.boundary = options.method != "conformal" ? "disk" : options.boundary_angles.empty() ? "free" : "angles";
  if (options.method == "conformal") {
    if (options.Laplacian == "extrinsic")
      throw Usage_error(
        "--laplacian extrinsic: a conformal map is that of the intrinsic Delaunay triangulation; omit it");
  } else {
    if (options.cones || !options.cone_angles.empty() || !options.boundary_angles.empty())
      throw Usage_error(
        "--cones, --cone-angles and --boundary-angles: only for a conformal map: add --method conformal");
    if (options.boundary == "free" || options.boundary == "angles")
      throw Usage_error("--boundary " + options.boundary + ": only for --method conformal");
  }
  std::vector<std::string> outputs{options.stats, options.distortion, options.view};
  for (const std::string& obj_path : {options.uv, options.uv_input})
    if (!obj_path.empty() && find_mesh_format(obj_path) != Mesh_format::OBJ)
      throw Usage_error(obj_path + ": the map is written as an OBJ file, whose name ends in .obj");
    else if (obj_path.find_first_of("\r\n") != std::string::npos)
      throw Usage_error("--uv and --uv-input: a name with a line end cannot be written in an OBJ file");
    else if (!obj_path.empty())
      for (const std::string& path : textured_mesh_paths(obj_path))
        outputs.push_back(path);
  check_output_paths(outputs, {options.input, options.cone_angles, options.boundary_angles});
  check_view(options.view);
}

// \param progress is asked as often as the method allows; a single linear system is solved without interruption
void find_map(const Parameterize_options& options, Result& result, const IT::Progress_function& progress)
{
  if (!progress(0))
    throw IT::Cancelled_error("the search for the map was cancelled");
  const bool is_intrinsic = options.Laplacian == "intrinsic";
  const Outcome& outcome = result.triangulation.outcome;
  const IT::Delta_complex& complex = is_intrinsic ? outcome.connectivity : result.triangulation.surface.connectivity;
  const IT::Element_numbers& numbers = is_intrinsic ? outcome.numbers : outcome.input_numbers;
  require_finite_weights(result.triangulation.surface, complex, numbers);
  if (options.boundary == "natural") {
    result.uv = IT::natural_parameterization(complex, numbers.cotangent_weights, numbers.lengths, numbers.areas);
    return;
  }
  std::vector<double> lengths;
  for (IT::Halfedge_index h : IT::disk_boundary(complex))
    lengths.push_back(numbers.lengths[complex.edge(h).idx()]);
  result.uv = IT::harmonic_parameterization(complex, numbers.cotangent_weights, IT::positions_on_circle(lengths));
}

Quality quality(const IT::Delta_complex& complex, const IT::Element_numbers& numbers, const IT::Planar_points& uv)
{
  Quality quality;
  quality.check = IT::check_parameterization(complex, uv);
  quality.distortion = IT::quasi_conformal_distortion(complex, numbers.lengths, numbers.areas, uv);
  quality.summary = IT::summarize_distortion(quality.distortion, numbers.areas);
  return quality;
}

Json json_value(const Quality& quality)
{
  return {{"flipped", quality.check.flipped.size()},
          {"collapsed", quality.check.collapsed.size()},
          {"mean_distortion", quality.summary.mean},
          {"percentile_99_distortion", quality.summary.percentile_99},
          {"max_distortion", quality.summary.maximum}};
}

Json json_value(const std::optional<IT::Weight_summary>& weights)
{
  Json json;
  json["min_weight"] = weights->smallest;
  json["negative_weights"] = weights->negative;
  return json;
}

Json json_value(const Parameterize_options& options, const Result& result)
{
  const Outcome& outcome = result.triangulation.outcome;
  Json json;
  json["input"] = options.input;
  json["method"] = options.method;
  json["laplacian"] = options.Laplacian;
  json["boundary"] = options.boundary;
  json["vertices"] = result.triangulation.counts.vertices;
  json["faces"] = result.triangulation.counts.faces;
  json["flips"] = outcome.report.flips;
  json["weights_before"] = json_value(outcome.weights_before);
  json["weights_after"] = json_value(outcome.weights_after);
  json["over_input"] = json_value(result.on_input);
  json["over_intrinsic"] = json_value(result.on_intrinsic);
  json["repair"] = to_json_value(repairs(result.triangulation.surface));
  json["warnings"] = result.triangulation.surface.warnings;
  json["seconds"] = result.seconds;
  return json;
}

// The options to try if these fail; empty if there are none. Following this advice repeatedly ends with the least
// demanding map.
std::string alternative(const Parameterize_options& options)
{
  if (options.boundary == "natural")
    return "--boundary disk";
  return options.Laplacian == "extrinsic" ? "--laplacian intrinsic" : "";
}

// A warning about a map that can still be written; empty if no triangle is turned over or collapsed.
std::string warning(const Parameterize_options& options, const Result& result)
{
  const bool is_intrinsic = options.Laplacian == "intrinsic";
  const IT::Delta_complex& complex =
    is_intrinsic ? result.triangulation.outcome.connectivity : result.triangulation.surface.connectivity;
  const IT::Parameterization_check& check = (is_intrinsic ? result.on_intrinsic : result.on_input).check;
  if (check.is_locally_injective())
    return {};
  const IT::Halfedge_index h =
    complex.halfedge(check.flipped.empty() ? check.collapsed.front() : check.flipped.front());
  const std::size_t i = complex.source(h).idx(), j = complex.target(h).idx(), k = complex.target(complex.next(h)).idx();
  const std::string other = alternative(options);
  return counted(check.flipped.size(), "triangle", "triangles") + " of the map turned over and " +
         with_separators(check.collapsed.size()) + " collapsed, first the one with corners " + std::to_string(i) +
         ", " + std::to_string(j) + " and " + std::to_string(k) + " at (" + in_full(result.uv[i][0]) + ", " +
         in_full(result.uv[i][1]) + "); " +
         (other.empty() // no weight is negative and the boundary is convex: the exact map has none
            ? "they are too small for the last place of coordinates to distinguish their corners: cut the surface open "
              "along its length there, or map a part of it"
            : "try " + other);
}

std::string text(const Quality& quality)
{
  return counted(quality.check.flipped.size(), "triangle", "triangles") + " flipped, " +
         with_separators(quality.check.collapsed.size()) + " collapsed; distortion " + in_short(quality.summary.mean) +
         " in the mean, " + in_short(quality.summary.percentile_99) + " at 99 % of the area, " +
         in_short(quality.summary.maximum) + " at most";
}

void write_report(std::ostream& os, const Parameterize_options& options, const Result& result)
{
  const Outcome& outcome = result.triangulation.outcome;
  os << options.input << "\n  map               " << options.Laplacian << ' ' << options.method << ", boundary "
     << (options.boundary == "disk" ? "on the unit circle" : "natural") << "\n  flips             "
     << with_separators(outcome.report.flips) << "\n  negative weights  "
     << with_separators(outcome.weights_before->negative) << " before, "
     << with_separators(outcome.weights_after->negative) << " after\n";
  os << "  over the input    " << text(result.on_input) << "\n  over the iDT      " << text(result.on_intrinsic)
     << "\n  time              " << seconds_text(result.seconds) << '\n';
}

// The distortion of each face of the overlay by both maps; empty where it is infinite.
void write_distortion(std::ostream& os, const Result& result)
{
  const auto text = [](double x) { return std::isfinite(x) ? in_full(x) : std::string(); };
  const IT::Overlay& overlay = result.triangulation.outcome.subdivision->overlay();
  os << "input_face,intrinsic_face,over_input,over_intrinsic\n";
  for (IT::Overlay::Face f : overlay.faces()) {
    const std::size_t input = overlay.input_face(f).idx(), intrinsic = overlay.intrinsic_face(f).idx();
    os << input << ',' << intrinsic << ',' << text(result.on_input.distortion[input]) << ','
       << text(result.on_intrinsic.distortion[intrinsic]) << '\n';
  }
}

void write_files(const Parameterize_options& options, const Result& result)
{
  const Surface& surface = result.triangulation.surface;
  const Outcome& outcome = result.triangulation.outcome;
  if (!(options.uv.empty() && options.uv_input.empty() && options.view.empty()) && !surface.has_points())
    throw Usage_error(surface.path + " has only lengths, no points: omit --uv, --uv-input and --view");
  if (!options.uv.empty())
    write_textured_mesh(options.uv, make_map_over_intrinsic(surface, *outcome.subdivision, result.uv));
  if (!options.uv_input.empty())
    write_textured_mesh(options.uv_input, make_map_over_input(surface, result.uv));
  write_file(options.distortion, [&](std::ostream& os) { write_distortion(os, result); });
  if (!options.view.empty()) {
    View view = make_view(surface.path, "intrinsic Delaunay triangulation", *outcome.subdivision, surface.points,
                          outcome.input_numbers, outcome.numbers);
    view.fields.push_back(
      {"distortion of the map", "", true, {result.on_input.distortion, result.on_intrinsic.distortion}});
    write_view(options.view, view);
  }
  write_json(options.stats, json_value(options, result));
}

Exit_status run_parameterize(Parameterize_options options)
{
  check(options);
  if (options.method == "conformal")
    return run_conformal_map(options);
  Result result;
  Run_options run_options;
  run_options.wanted.weights = run_options.wanted.numbers = run_options.wanted.input_numbers = true;
  run_options.wanted.crossings = run_options.wanted.overlay =
    !options.uv.empty() || !options.distortion.empty() || !options.view.empty();
  return for_each_input({options.input}, [&](const std::string& path) {
    result.triangulation = triangulate(load_surface(path, options.repair), run_options);
    const Exit_status status = exit_status(result.triangulation.outcome);
    if (status != Exit_status::DONE) {
      std::cerr << "idt: " << path << ": " << describe_status(result.triangulation) << std::endl;
      return status;
    }
    const Surface& surface = result.triangulation.surface;
    const Outcome& outcome = result.triangulation.outcome;
    const Stopwatch stopwatch;
    try {
      Progress progress(path, "solving");
      find_map(options, result, std::ref(progress));
    } catch (const IT::Numerical_error& error) {
      const std::string other = alternative(options);
      throw IT::Numerical_error(error.what() + (other.empty()
                                                  ? "; cut the surface open along its length, or map a part of it"
                                                  : "; try " + other));
    } catch (const IT::Invalid_surface_error& error) {
      if (error.defect() != IT::Invalid_surface_error::Defect::WRONG_TOPOLOGY)
        throw;
      throw IT::Invalid_surface_error(error.defect(), error.element(), error.count(),
                                      error.what() + std::string("; --method conformal takes any surface"));
    }
    result.seconds = stopwatch.seconds();
    result.on_input = quality(surface.connectivity, outcome.input_numbers, result.uv);
    result.on_intrinsic = quality(outcome.connectivity, outcome.numbers, result.uv);
    if (const std::string text = warning(options, result); !text.empty())
      std::cerr << "idt: " << path << ": " << text << std::endl;
    write_files(options, result);
    write_report(std::cout, options, result);
    flush_standard_output();
    return status;
  });
}

} // namespace

void add_parameterize_command(CLI::App& app, Selected_command& selected)
{
  const auto options = std::make_shared<Parameterize_options>();
  CLI::App& command = *app.add_subcommand("parameterize", "Map a surface to the plane, harmonically or conformally");
  command.footer("Except for a conformal map, which is cut open where it has to be,\n"
                 "the surface must be a disk: one component with one boundary and no handle. Orientation\n"
                 "is decided exactly, for the map that is linear on the input triangles and for the one\n"
                 "that is linear on the intrinsic Delaunay triangles. Distortion is the ratio of the\n"
                 "singular values: 1 where a triangle keeps its shape.\n");
  command.add_option("INPUT", options->input, "as for `idt triangulate`")->required();
  set_words(command.add_option("--laplacian", options->Laplacian, "the triangulation whose cotangents are used"),
            {"intrinsic", "extrinsic"})
    ->capture_default_str();
  set_words(command.add_option("--boundary", options->boundary,
                               "disk: spread over the unit circle by arc length (default), or, conformal, a polygon "
                               "with such angles; natural: where it distorts least; conformal: free, with its scale "
                               "(default), or angles, straight where --boundary-angles has none"),
            {"disk", "natural", "free", "angles"});
  set_words(command.add_option("--method", options->method,
                               "harmonic; conformal: for any surface, proven to be locally injective"),
            {"harmonic", "conformal"})
    ->capture_default_str();
  add_option(command, "--cones", options->cones, "N",
             "conformal: choose N cones in each component; by default, so many that no length changes too much")
    ->transform(whole_number());
  add_option(command, "--cone-angles", options->cone_angles, "F.csv",
             "conformal: the sums of the angles at cones, in radians, as CSV: vertex,NAME");
  add_option(command, "--boundary-angles", options->boundary_angles, "F.csv",
             "conformal: the angles of vertices on the boundary, likewise; implies --boundary angles");
  add_option(command, "--uv", options->uv, "F.obj",
             "write the surface, as the overlay, with texture coordinates that are linear on the intrinsic "
             "triangles; and F.mtl and F.png with a checkerboard");
  add_option(command, "--uv-input", options->uv_input, "F.obj", "the same, linear on the input triangles");
  add_option(command, "--distortion", options->distortion, "F.csv",
             "write the distortion of both on each face of the overlay: "
             "input_face,intrinsic_face,over_input,over_intrinsic; of a conformal map, on each triangle of --uv: "
             "input_face,distortion,area_scale");
  add_view_option(command, options->view);
  add_option(command, "--stats,--json", options->stats, "F.json", "write the report as a JSON object");
  add_repair_option(command, options->repair);
  command.callback([options, &selected] { selected = [options] { return run_parameterize(*options); }; });
}

} // namespace idt
