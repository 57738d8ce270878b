// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `idt refine`

#include "commands/Result_files.h"
#include "commands/command_line.h"
#include "commands/commands.h"
#include "commands/triangulate.h"
#include "input/constraints.h"
#include "input/flat_vertices.h"
#include "input/saved_triangulation.h"
#include "input/standard_input.h"
#include "input/vertex_values.h"
#include "output/Output_file.h"
#include "output/write_straight_mesh.h"
#include "system/Interruption.h"
#include "system/Progress.h"
#include "system/text.h"
#include "view/View.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/reports.h>
#include <CGAL/Intrinsic_triangulations/straight_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace idt {
namespace {

namespace IT = CGAL::Intrinsic_triangulations;

struct Refine_options
{
  std::string input;
  Refinement_options refinement;
  std::optional<double> flat_tolerance;
  std::string constraints, whole, sizes, kept_edges, flattened, maximum_deviation;
  Repair_options repair;
  bool removes_flat_vertices = false;
  bool is_verified = false;
  Result_files files;
};

// The longest side of the box.
double extent_of(const Surface& surface)
{
  double result = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (IT::Vertex_index v : surface.connectivity.vertices())
      if (surface.connectivity.halfedge(v).is_valid()) { // as for the smallest size
        low = (std::min)(low, surface.points[v.idx()][axis]);
        high = (std::max)(high, surface.points[v.idx()][axis]);
      }
    result = (std::max)(result, high - low);
  }
  return result;
}

// A length, or a percentage of another one; NaN if the text is neither.
double length(const std::string& text, double whole)
{
  const bool is_percentage = !text.empty() && text.back() == '%';
  std::istringstream stream(is_percentage ? text.substr(0, text.size() - 1) : text);
  double number = 0;
  if (!(stream >> number) || stream.get() != std::istringstream::traits_type::eof() || !std::isfinite(number))
    return std::numeric_limits<double>::quiet_NaN();
  return is_percentage ? number / 100 * whole : number;
}

void check(const Refine_options& options)
{
  // No comparison holds for NaN.
  const auto& criteria = options.refinement.criteria;
  if (!(criteria.minimum_angle >= 0 && criteria.minimum_angle <= 30))
    throw Usage_error("--minimum-angle: A is between 0 and 30 degrees");
  if (!(criteria.maximum_circumradius > 0))
    throw Usage_error("--maximum-circumradius: R is larger than 0");
  if (!(criteria.maximum_edge_length > 0))
    throw Usage_error("--maximum-edge-length: L is larger than 0");
  if (criteria.minimum_size && !(*criteria.minimum_size >= 0))
    throw Usage_error("--minimum-size: S has to be a number that is not negative");
  if (options.flat_tolerance && !(*options.flat_tolerance >= 0))
    throw Usage_error("--flat-tolerance: D has to be a number that is not negative");
  if (criteria.sharp_edge_angle && !(*criteria.sharp_edge_angle >= 0 && *criteria.sharp_edge_angle <= 180))
    throw Usage_error("--constrain-angle: D is between 0 and 180 degrees");
  if (!options.maximum_deviation.empty() && !(length(options.maximum_deviation, 1) > 0))
    throw Usage_error("--maximum-deviation: D is larger than 0, a length or a percentage such as 0.1%");
  options.files.check_paths({options.input});
  std::vector<std::string> outputs = options.files.paths();
  outputs.insert(outputs.end(), {options.kept_edges, options.flattened});
  if (!options.flattened.empty() && !is_straight_mesh_name(options.flattened))
    throw Usage_error("--flatten: " + options.flattened + " does not end in " + straight_mesh_extensions());
  if (criteria.normal_angle && !(*criteria.normal_angle > 0))
    throw Usage_error("--maximum-normal-angle: A is larger than 0");
  if (!(criteria.gradation > 0 && std::isfinite(criteria.gradation)))
    throw Usage_error("--size-gradation: G is larger than 0");
  if (options.removes_flat_vertices && !options.whole.empty() && options.whole != "border")
    throw Usage_error("--keep-whole: --remove-flat-vertices renumbers the vertices that a file names");
  check_output_paths(outputs, {options.input, options.constraints, options.whole, options.sizes});
}

// Writes once to the standard error that the budget will not suffice, as soon as two estimates in a row say so: the
// first one takes the thin faces around a vertex for a strip that has to be filled evenly.
class Budget_warning
{
public:
  Budget_warning(std::string path, std::uint64_t budget) : path_(std::move(path)), budget_(budget) {}

  void look(const IT::Refinement_progress& progress, const std::function<Short_side()>& where)
  {
    if (is_written_ || progress.estimated_points == estimate_)
      return;
    estimate_ = progress.estimated_points;
    if (progress.points + estimate_ <= budget_) {
      was_exceeded_ = false;
      return;
    }
    if (!std::exchange(was_exceeded_, true))
      return;
    is_written_ = true;
    std::cerr << erased_progress() << "idt: " << path_ << ": after " << with_separators(progress.points)
              << " new vertices, about " << with_separators(estimate_) << " more are needed, now for sides of "
              << text(where()) << ": the budget of " << with_separators(budget_)
              << " may not suffice; then try a larger --minimum-size, --maximum-edge-length or --maximum-points"
              << std::endl;
  }

private:
  std::string path_;
  std::uint64_t budget_, estimate_ = 0;
  bool was_exceeded_ = false, is_written_ = false;
};

std::uint64_t budget(const Surface& surface, const Refine_options& options)
{
  return options.refinement.maximum_number_of_points.value_or(
    10 * std::uint64_t(surface.connectivity.number_of_vertices()) + 1000000);
}

// For each edge of the surface.
std::vector<bool> read_edges(const std::string& path, const std::string& option, Surface& surface)
{
  const std::size_t number_of_points = surface.points.size();
  std::vector<bool> result = read_constraints(path, surface);
  if (surface.points.size() != number_of_points && (surface.saved || option != "--constraints"))
    throw Usage_error(option + ": " + path +
                      " has lines through faces, which need new vertices in the input: refine the mesh instead");
  return result;
}

// Those of the border are no constraints.
void add_whole_edges(const std::string& name, Surface& surface, Refinement_options& refinement)
{
  const IT::Delta_complex& complex = surface.connectivity;
  std::vector<bool> result(complex.number_of_edges());
  if (name == "border")
    for (IT::Edge_index e : complex.edges())
      result[e.idx()] = complex.is_border(e);
  else
    result = read_edges(name, "--keep-whole", surface);
  refinement.is_constrained.resize(result.size());
  for (IT::Edge_index e : complex.edges())
    if (result[e.idx()] && !complex.is_border(e))
      refinement.is_constrained[e.idx()] = true;
  refinement.is_whole = std::move(result);
}

// Whether a vertex is an end of a flagged edge.
std::vector<bool> ends(const std::vector<bool>& edges, const IT::Delta_complex& complex)
{
  std::vector<bool> result(edges.empty() ? 0 : complex.number_of_vertices());
  for (IT::Halfedge_index h : complex.halfedges())
    if (!edges.empty() && edges[complex.edge(h).idx()])
      result[complex.source(h).idx()] = true;
  return result;
}

// A size for each vertex; infinite where the table has none.
std::vector<double> read_sizes(const std::string& path, const Surface& surface)
{
  const std::size_t n = surface.connectivity.number_of_vertices();
  std::vector<double> result(n, std::numeric_limits<double>::infinity());
  for (const auto& [v, size] : read_numbers_of_vertices(path, n)) {
    if (!(size > 0))
      throw IT::Invalid_argument_error("--size-map: " + path + ": the size at vertex " + std::to_string(v) +
                                       " is not positive");
    result[v] = size;
  }
  return result;
}

Triangulation_result refine_surface(Surface surface, Run_options run_options, const Refine_options& options)
{
  Budget_warning warning(surface.path, budget(surface, options));
  Refinement_options& refinement = *run_options.refinement;
  std::vector<bool>& is_constrained = refinement.is_constrained;
  if (surface.saved)
    is_constrained = surface.saved->is_constrained;
  if (!options.constraints.empty()) {
    const std::vector<bool> read = read_edges(options.constraints, "--constraints", surface);
    is_constrained.resize(read.size());
    std::transform(read.begin(), read.end(), is_constrained.begin(), is_constrained.begin(), std::logical_or<>());
  }
  if (!options.whole.empty())
    add_whole_edges(options.whole, surface, refinement);
  if (!options.sizes.empty())
    refinement.sizes = read_sizes(options.sizes, surface);
  refinement.look = [&](const IT::Refinement_progress& progress, const std::function<Short_side()>& where) {
    if (!progress.is_on_trial)
      warning.look(progress, where);
  };
  Triangulation_result result = triangulate(std::move(surface), run_options);
  if (result.outcome.refinement) {
    const std::optional<double>& given = refinement.criteria.minimum_size;
    const double size = result.outcome.refinement->report.minimum_size;
    result.smallest_size = given       ? in_short(*given)
                           : size == 0 ? "0: no place needs one"
                                       : in_short(size) + ", chosen: smaller faces need many vertices, which "
                                                          "--minimum-size 0 allows";
  }
  return result;
}

IT::Straight_mesh straight_mesh(const Triangulation_result& result, bool is_trial = false)
{
  const Refinement_options& refinement = *result.options.refinement;
  const double maximum = refinement.criteria.maximum_deviation;
  Progress progress(result.surface.path, "straight triangles");
  return IT::internal::straight_mesh(
    *result.outcome.subdivision, result.surface.points, refinement.is_constrained, Triangulation_result::thin_angle,
    std::isfinite(maximum) ? maximum : 0, ends(refinement.is_whole, result.surface.connectivity),
    IT::internal::progress_function_of(CGAL::parameters::visitor(std::ref(progress))), !is_trial);
}

// A unit in the last place of the largest coordinate.
double coordinate_rounding(const Surface& surface)
{
  double largest = 0;
  for (const auto& p : surface.points)
    for (double x : p)
      largest = (std::max)(largest, std::abs(x));
  return std::numeric_limits<double>::epsilon() * largest;
}

// A larger deviation for which refinement leads to good triangles, found by trying, with two digits; or 0. No point is as
// near as rounding.
double sufficient_deviation(const Surface& surface, Run_options run_options, const Refine_options& options,
                            const IT::Straight_mesh& before)
{
  double& deviation = run_options.refinement->criteria.maximum_deviation;
  const double rounding = coordinate_rounding(surface),
               first = (std::max)({before.sufficient_deviation, 2 * deviation, 0x1p10 * rounding}),
               largest = (std::min)((std::max)(100 * deviation, 0x1p17 * rounding), extent_of(surface) / 4);
  for (double d = first; d < largest; d *= 2) {
    const double digit = std::pow(10, std::floor(std::log10(d)) - 1);
    deviation = std::ceil(d / digit) * digit;
    std::istringstream(in_short(deviation)) >> deviation; // as it is written
    const Triangulation_result result = refine_surface(surface, run_options, options);
    if (!result.outcome.subdivision || is_interrupted())
      return 0;
    if (const IT::Straight_mesh mesh = straight_mesh(result, true);
        mesh.is_good() && mesh.deviation <= deviation && IT::internal::keeps_most(mesh, before))
      return deviation;
  }
  return 0;
}

// Those of straight triangles, if there are several, on the faces of the input and of the result.
std::vector<View_field> regions(const Triangulation_result& result)
{
  if (!result.straight || result.straight->number_of_regions < 2)
    return {};
  const IT::Straight_mesh& mesh = *result.straight;
  const IT::Common_subdivision& subdivision = *result.outcome.subdivision;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> of_input(subdivision.input().number_of_faces(), none),
    of_result(subdivision.intrinsic().number_of_faces(), none);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    of_result[mesh.faces[t].idx()] = mesh.regions[t];
  const IT::Overlay& overlay = subdivision.overlay();
  for (IT::Overlay::Face f : overlay.faces())
    if (const double region = of_result[overlay.intrinsic_face(f).idx()]; !std::isnan(region))
      of_input[overlay.input_face(f).idx()] = region;
  return {{"region", "", true, {of_input, of_result}}};
}

Exit_status refine_file(const std::string& path, const Refine_options& options)
{
  Surface surface = load_surface(path, options.repair);
  const double deviation = options.removes_flat_vertices ? remove_flat_vertices(surface, options.flat_tolerance) : 0;
  options.files.check_surface(surface);
  if (!options.flattened.empty() && !surface.has_points())
    throw Usage_error(path + ": --flatten needs a surface in space, but this one has only edge lengths");
  if (options.refinement.criteria.sharp_edge_angle && !surface.has_points())
    refuse_file(path, "--constrain-angle needs a surface in space, but this one has only edge lengths");
  Run_options run_options;
  run_options.refinement = options.refinement;
  if (!options.maximum_deviation.empty()) {
    if (!surface.has_points())
      throw Usage_error(path + ": --maximum-deviation needs a surface in space, but this one has only edge lengths");
    run_options.refinement->criteria.maximum_deviation = length(options.maximum_deviation, extent_of(surface));
  }
  options.files.add_to(run_options.wanted);
  const bool makes_triangles = !options.flattened.empty() || !options.maximum_deviation.empty();
  run_options.wanted.overlay = run_options.wanted.overlay || makes_triangles;
  run_options.wanted.shapes = true;
  run_options.wanted.verification = options.is_verified;
  const bool is_bounded = !options.maximum_deviation.empty();
  const std::optional<Surface> copy = is_bounded ? std::optional<Surface>(surface) : std::nullopt;
  Triangulation_result result = refine_surface(std::move(surface), run_options, options);
  result.flat_tolerance = options.flat_tolerance;
  result.flat_deviation = deviation;
  if (makes_triangles && result.outcome.subdivision) {
    try {
      result.straight = straight_mesh(result);
      if (is_bounded && !result.straight->is_good())
        result.straight->sufficient_deviation = sufficient_deviation(*copy, run_options, options, *result.straight);
    } catch (const IT::Cancelled_error& error) {
      result.outcome.failure = error.what();
    }
    if (result.straight)
      write_file(options.flattened,
                 [&](std::ostream& os) { write_straight_mesh(os, *result.straight, options.flattened); });
  }
  options.files.write(result, regions(result));
  write_file(options.kept_edges, [&](std::ostream& os) {
    write_constraints(os, options.kept_edges, result.surface, result.options.refinement->is_constrained);
  });
  const Exit_status status = report(result, options.files.is_verbose);
  if (result.straight && options.flattened.empty())
    std::cout << "  not written     the straight triangles: --flatten F writes them" << std::endl;
  return status;
}

Exit_status run_refine(const Refine_options& options)
{
  check(options);
  return for_each_input({options.input}, [&](const std::string& path) { return refine_file(path, options); });
}

} // namespace

void add_refine_command(CLI::App& app, Selected_command& selected)
{
  const auto options = std::make_shared<Refine_options>();
  CLI::App& command =
    *app.add_subcommand("refine", "Insert vertices until no triangle is too thin or too large, by Delaunay refinement");
  command.footer("No length of the surface changes. New vertices follow those of the input, and the\n"
                 "triangulation is intrinsic Delaunay except for constrained edges. Where the input leaves no\n"
                 "choice, a face stays below the bound; --stats and the report count such faces by reason:\n"
                 "cone, a vertex with a small angle sum; small input angle, between edges that stay;\n"
                 "beside small input angle, across from two points at the same distance from such a corner;\n"
                 "unrepresentable, doubles are too coarse for the point; too small, below --minimum-size;\n"
                 "whole edge, beside one of --keep-whole;\n"
                 "budget, time or the number of points ran out. The status is 4 only for the last of these.\n");
  command.add_option("INPUT", options->input, "as for `idt triangulate`")->required();
  add_option(command, "--minimum-angle", options->refinement.criteria.minimum_angle, "A",
             "the smallest angle allowed, in degrees; at most 30")
    ->capture_default_str();
  add_option(command, "--maximum-circumradius", options->refinement.criteria.maximum_circumradius, "R",
             "the largest circumradius allowed (default: unlimited)");
  add_option(command, "--maximum-edge-length", options->refinement.criteria.maximum_edge_length, "L",
             "the largest edge length allowed (default: unlimited)");
  CLI::Option* const sizes =
    add_option(command, "--size-map", options->sizes, "F.csv",
               "how long edges may be at each vertex of the input: a table vertex,size. An edge may be as long as the "
               "mean of the sizes at its ends, which are linear on the faces of the input");
  add_option(command, "--maximum-normal-angle", options->refinement.criteria.normal_angle, "A",
             "edges may be as long as the way on which the normal of the surface turns by A degrees; edges sharper "
             "than --constrain-angle do not count (default: unlimited)");
  need_one_of(add_option(command, "--size-gradation", options->refinement.criteria.gradation, "G",
                         "by which part of a length these sizes may grow along it; larger ones are lowered"),
              {"--maximum-normal-angle", "--size-map"})
    ->capture_default_str();
  add_option(
    command, "--maximum-deviation", options->maximum_deviation, "D[%]",
    "the largest distance allowed between the surface and the straight triangles of --flatten: a length, or a "
    "percentage of the longest side of the box (default: unlimited). What is thinner is merged in them, and the "
    "status is 4 if they are no surface, too far away, have angles below 10 degrees other than at corners of kept "
    "edges, or, where they are closed, lie on each other or cross unlike the surface");
  add_option(command, "--minimum-size", options->refinement.criteria.minimum_size, "S",
             "insert no vertex for a face with a side or a height shorter than S, so that refinement ends early at "
             "irrelevantly thin sheets and slivers (default: 0, or up to 2^-14 of the box if smaller faces need many "
             "vertices)");
  add_option(command, "--maximum-points", options->refinement.maximum_number_of_points, "N",
             "give up after this many new vertices (default: 1,000,000 and 10 for each vertex; then nothing is "
             "done if lengths of edges need more, judged by areas)")
    ->transform(whole_number());
  add_option(command, "--constrain-angle", options->refinement.criteria.sharp_edge_angle, "D",
             "keep the edges whose two faces have normals that differ by more than D degrees: they may be split, "
             "but not flipped");
  CLI::Option* const constraints =
    add_option(command, "--constraints", options->constraints, "F.csv",
               "also keep these edges: pairs of vertices, one pair per line, or a CSV file of `idt geodesic` with a "
               "line on the surface, along which faces are cut first");
  add_option(
    command, "--keep-whole", options->whole, "F.csv|border",
    "neither flip nor split these edges, or those of the border; a face that would need a vertex there is left");
  add_option(command, "--kept-edges", options->kept_edges, "F.(csv|vtp)",
             "write the edges of --constrain-angle and --constraints: pairs of vertices, which --constraints reads, "
             "or lines in space");
  CLI::Option* const flat = command.add_flag("--remove-flat-vertices", options->removes_flat_vertices,
                                             "first remove the vertices in flat sides and on straight edges, exactly: "
                                             "the surface stays the same, but its vertices and faces are renumbered");
  add_option(command, "--flat-tolerance", options->flat_tolerance, "D",
             "also remove vertices that are slightly off, such as those of a rotated part: no point of the surface "
             "moves by more than D")
    ->needs(flat);
  add_option(command, "--vertex-map", options->files.vertex_map, "F.csv",
             "write which vertices of the input remain, as CSV: vertex,input")
    ->needs(flat);
  CLI::Option* const repair = add_repair_option(command, options->repair);
  command.add_flag("--verify", options->is_verified,
                   "afterwards decide every interior edge that is not constrained again, exactly and from the input "
                   "alone; status 4 if one is not Delaunay");
  add_option(command, "--points", options->files.points, "F.csv",
             "write the positions of the new vertices as CSV: vertex,input_face,b0,b1,b2,x,y,z; the barycentric "
             "coordinates are exact once they are divided by their sum, the position in space is rounded");
  add_option(
    command, "--flatten", options->flattened, "F.(msh|inp|vtp|ply|off|obj|stl|ts)",
    "write the result as a mesh of straight triangles, for other solvers: that is another surface, and the "
    "report gives its distance; status 4 if they are no surface. Gmsh's .msh and Abaqus' .inp name the regions "
    "between kept edges, and the lines around them");
  options->files.add_options(command, repair);
  command.get_option("--repair-map")->excludes(flat);
  constraints->excludes(flat);
  sizes->excludes(flat);
  command.callback([options, &selected] { selected = [options] { return run_refine(*options); }; });
}

} // namespace idt
