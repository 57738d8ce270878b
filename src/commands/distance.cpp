// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `idt distance`

#include "commands/command_line.h"
#include "commands/commands.h"
#include "commands/distance_lines.h"
#include "commands/distance_sources.h"
#include "input/Surface.h"
#include "input/Triangle_soup.h"
#include "input/gluing_file.h"
#include "input/mesh_file.h"
#include "input/repair.h"
#include "input/saved_triangulation.h"
#include "input/standard_input.h"
#include "number_types/make_triangulation.h"
#include "output/Output_file.h"
#include "output/write_json.h"
#include "output/write_matrices.h"
#include "output/write_overlay.h"
#include "system/Interruption.h"
#include "system/Long_text.h"
#include "system/Progress.h"
#include "system/Stopwatch.h"
#include "system/text.h"
#include "view/View.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Heat_method.h>
#include <CGAL/Intrinsic_triangulations/Simplified_distances.h>
#include <CGAL/Intrinsic_triangulations/Tufted_cover.h>
#include <CGAL/Intrinsic_triangulations/Vector_heat_method.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/farthest_vertices.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/geodesic_distance_matrix.h>
#include <CGAL/Intrinsic_triangulations/shortest_path.h>
#include <CGAL/Intrinsic_triangulations/refine_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/sides_of_curve.h>
#include <CGAL/Intrinsic_triangulations/simplify_surface.h>
#include <CGAL/Intrinsic_triangulations/tangent_vectors.h>
#include <CGAL/Intrinsic_triangulations/transfer.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace idt {
namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Json = nlohmann::ordered_json;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

struct Distance_options
{
  std::string input;
  Named_sources sources, barriers;
  std::vector<std::uint64_t> targets;
  std::string source_vertices_path, target_vertices_path, matrix_path;
  Line_options lines;
  std::string output_path, overlay_path, labels_path, samples_path, stats_path, view_path;
  std::uint64_t number_of_samples = 0;
  std::string cover = "tufted", boundary, format = "csv", method;
  std::optional<double> time_coefficient, maximum_change;
  Repair_options repair;
  bool is_refined = false, has_vectors = false, is_compared = false, is_signed = false;

  // Whether ways begin elsewhere than at vertices, or their origin matters.
  bool has_places() const
  {
    return sources.has_files() || !labels_path.empty() || !samples_path.empty() || lines.are_wanted();
  }
  double tolerance() const { return method == "exact" ? 0 : 0.001; }
  bool is_by_heat() const { return method == "heat" || (method.empty() && (!boundary.empty() || time_coefficient)); }

  std::optional<Mesh_format> overlay_format() const
  {
    return find_mesh_format(name_with_format(overlay_path, format == "csv" ? "ply" : format));
  }
};

struct Distance_result
{
  std::size_t number_of_vertices = 0;
  std::vector<std::array<double, 3>> points; // empty if the surface is given by lengths
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<double> distances; // infinite where no source is connected; for a matrix, row after row
  std::vector<std::uint32_t> nearest_sources;
  std::vector<IT::Farthest_vertex> samples;
  Distance_lines lines;
  std::vector<std::array<double, 3>> source_points, source_curves; // as those of Placed_sources
  double largest_snap = -1;                                        // of sources in space, if there are any
  std::vector<Named_values> vectors;                               // other values at each vertex
  std::uint64_t flips = 0;
  std::size_t number_of_inserted_vertices = 0;
  std::optional<double> mean_edge_length; // by heat
  std::size_t number_of_bounded_distances = 0;
  std::size_t nonmanifold_edges = 0;
  std::string cuts; // by repair
  bool is_complete = true;
  std::optional<IT::Metric_change> change; // by simplification
  std::size_t number_of_simplified_vertices = 0;
  std::optional<std::array<double, 2>> errors;       // the mean and the largest one, as fractions of the exact distance
  std::optional<IT::Common_subdivision> subdivision; // for the overlay and the view
  IT::Element_numbers input_numbers, numbers;        // for the view
  Named_values overlay_distances{"distance", {}};
  double read_seconds = 0, triangulation_seconds = 0, distance_seconds = 0;
  std::vector<std::string> warnings;

  std::size_t number_of_unreachable_vertices() const
  {
    return std::size_t(std::count(distances.begin(), distances.end(), std::numeric_limits<double>::infinity()));
  }
  // Whether heat gave more than a few impossible distances. Next to the sources there are always some.
  bool is_far_from_right() const { return number_of_bounded_distances > 3 + number_of_vertices / 100; }
  // The largest distance of vertices that can be reached.
  double largest_distance() const
  {
    double result = 0;
    for (double d : distances)
      if (std::isfinite(d))
        result = (std::max)(result, std::abs(d));
    return result;
  }
};

void check_matrix(const Distance_options& options)
{
  if (options.targets.empty() != options.matrix_path.empty())
    throw Usage_error("--matrix needs --target or --target-vertices, and these need --matrix");
  if (options.matrix_path.empty())
    return;
  if (options.sources.has_files() || options.is_by_heat() || options.maximum_change || options.is_refined ||
      options.is_compared || options.has_vectors)
    throw Usage_error("--matrix follows straight ways between vertices: omit other sources, heat, --maximum-change, "
                      "--refine, --compare-exact and --vectors");
  if (!options.output_path.empty() || !options.overlay_path.empty() || !options.labels_path.empty() ||
      !options.view_path.empty())
    throw Usage_error("--matrix finds distances of the targets only: omit -o, --overlay, --labels and --view");
  const std::string type = extension_with_format(options.matrix_path, options.format);
  if (type != ".csv" && type != ".mtx")
    throw Usage_error(options.matrix_path + ": a matrix is written as a file whose name ends in .csv or .mtx");
}

void check_barriers(const Distance_options& options)
{
  if (options.maximum_change || options.is_refined || options.has_vectors || !options.matrix_path.empty() ||
      !options.overlay_path.empty() || !options.view_path.empty() || !options.samples_path.empty() ||
      (options.is_signed && options.lines.are_wanted()))
    throw Usage_error("--barrier and --barrier-edges cut the surface open: omit --maximum-change, --refine, --vectors, "
                      "--matrix, --overlay, --farthest and --view, and --signed with lines");
}

void check(const Distance_options& options)
{
  if (options.barriers.has_files())
    check_barriers(options);
  if (options.sources.vertices.empty() && !options.sources.has_files())
    throw Usage_error("--source is required, or --source-vertices, --source-points, --source-edges or --source-curve");
  if (options.has_places() && (options.is_by_heat() || options.maximum_change))
    throw Usage_error("--source-points, --source-edges, --source-curve, --labels, --farthest and lines follow straight "
                      "ways on the surface "
                      "itself: omit heat and --maximum-change");
  if (options.is_signed && (options.sources.curve_path.empty() || !options.sources.vertices.empty() ||
                            !options.sources.points_path.empty() || !options.sources.edges_path.empty()))
    throw Usage_error("--signed needs --source-curve, and no other source");
  if (options.is_signed && (options.cover == "tufted" || options.is_refined))
    throw Usage_error("--signed needs --cover none, and no --refine");
  if (options.has_places() && options.has_vectors)
    throw Usage_error("--vectors needs vertices as sources, and no --labels, --farthest or lines");
  if (options.samples_path.empty() != (options.number_of_samples == 0))
    throw Usage_error("--farthest N needs --samples, and a number above 0; and --samples needs --farthest");
  options.lines.check(options.is_signed, !options.view_path.empty());
  if (!options.is_by_heat() && !options.boundary.empty())
    throw Usage_error("--boundary needs --method heat");
  if (!options.is_by_heat() && options.time_coefficient)
    throw Usage_error("--time needs --method heat");
  if (options.cover == "tufted" && !options.boundary.empty() && options.boundary != "neumann")
    throw Usage_error("--boundary needs --cover none: the tufted cover has no border");
  if (options.cover == "tufted" && options.is_refined)
    throw Usage_error("--refine needs --cover none");
  if (options.cover == "tufted" && options.repair.is_wanted)
    throw Usage_error("--repair needs --cover none: the tufted cover takes any triangles");
  if (options.cover == "tufted" && options.has_vectors)
    throw Usage_error("--vectors needs --cover none: a vertex of the tufted cover has no tangent plane");
  if (options.cover == "tufted" && !options.overlay_path.empty())
    throw Usage_error("--overlay needs --cover none: the tufted cover is not a triangulation of the input");
  if (options.maximum_change && !(*options.maximum_change >= 0))
    throw Usage_error("--maximum-change: C has to be a number that is not negative");
  if (options.maximum_change && (options.is_by_heat() || !options.method.empty() || options.is_refined))
    throw Usage_error("--maximum-change follows all straight ways on a simplified surface: omit --method, --refine and "
                      "the options of heat");
  const std::optional<Mesh_format> overlay_format = options.overlay_format();
  if (!options.overlay_path.empty() && overlay_format != Mesh_format::PLY && overlay_format != Mesh_format::VTP)
    throw Usage_error(options.overlay_path +
                      ": the overlay with distances is written as a file whose name ends in .ply or .vtp");
  if (options.has_vectors && options.output_path.empty())
    throw Usage_error("--vectors needs -o, the file to write them to");
  if (options.time_coefficient && !(*options.time_coefficient > 0 && std::isfinite(*options.time_coefficient)))
    throw Usage_error("--time: T is a positive number");
  const std::string& path = options.output_path;
  const std::string type = extension_with_format(path, options.format);
  if (!path.empty() && type != ".csv" && type != ".ply" && type != ".vtp")
    throw Usage_error(path + ": distances are written as a file whose name ends in .csv, .ply or .vtp");
  check_matrix(options);
  check_output_paths({path, options.overlay_path, options.labels_path, options.samples_path, options.matrix_path,
                      options.stats_path, options.view_path, options.lines.lines_path, options.lines.borders_path},
                     {options.input, options.sources.points_path, options.sources.edges_path,
                      options.sources.curve_path, options.source_vertices_path, options.target_vertices_path});
  check_view(options.view_path);
}

auto library_options(const Distance_options& options)
{
  const std::map<std::string, IT::Heat_boundary> boundaries = {{"", IT::Heat_boundary::NEUMANN},
                                                               {"neumann", IT::Heat_boundary::NEUMANN},
                                                               {"dirichlet", IT::Heat_boundary::DIRICHLET},
                                                               {"average", IT::Heat_boundary::AVERAGED}};
  return CGAL::parameters::heat_boundary(boundaries.at(options.boundary))
    .time_coefficient(options.time_coefficient.value_or(1))
    .visitor([] { return !is_interrupted(); });
}

struct Refinement_watch
{
  bool go_further(const IT::Progress& done)
  {
    progress.show_points(done.insertions, refinement.waiting_faces, refinement.size);
    return !is_interrupted();
  }
  void before_step(const IT::Refinement_progress& step) { refinement = step; }
  Progress& progress;
  IT::Refinement_progress refinement = {};
};

void set_number_of_vertices(const Distance_options& options, std::size_t n, Distance_result& result)
{
  const auto require_vertices = [n](const char* option, const std::vector<std::uint64_t>& vertices) {
    for (std::uint64_t v : vertices)
      if (v >= n)
        throw Usage_error(option + std::string(": there is no vertex ") + std::to_string(v) + ": the input has " +
                          std::to_string(n) + ", counted from 0");
  };
  require_vertices("--source", options.sources.vertices);
  require_vertices("--target", options.targets);
  result.number_of_vertices = n;
}

// The mean and the largest error, as fractions of the exact distance.
std::array<double, 2> compare(const std::vector<double>& distances, const std::vector<double>& exact)
{
  double sum = 0, largest = 0;
  std::size_t n = 0;
  for (std::size_t v = 0; v < exact.size(); ++v)
    if (exact[v] > 0 && std::isfinite(exact[v])) {
      const double error = std::abs(distances[v] - exact[v]) / exact[v];
      sum += error;
      largest = (std::max)(largest, error);
      ++n;
    }
  return {n > 0 ? sum / double(n) : 0, largest};
}

std::vector<IT::Vertex_index> to_vertices(const std::vector<std::uint64_t>& numbers)
{
  std::vector<IT::Vertex_index> result;
  for (std::uint64_t v : numbers)
    result.push_back(IT::Vertex_index(IT::Vertex_index::size_type(v)));
  return result;
}
std::vector<IT::Vertex_index> sources_of(const Distance_options& options)
{
  return to_vertices(options.sources.vertices);
}

// \param surface a triangulation, or a tufted cover
template <class Any_surface>
void find_by_heat(const Distance_options& options, const Any_surface& surface,
                  const std::vector<IT::Vertex_index>& sources, Progress& progress, Distance_result& result)
{
  progress.begin("building and factoring the matrix of the heat");
  IT::Heat_method<> heat(surface, library_options(options));
  progress.begin("solving for distances");
  for (IT::Vertex_index v : sources)
    heat.add_source(v);
  result.mean_edge_length = heat.mean_edge_length();
  result.distances = heat.distances();
  result.number_of_bounded_distances = heat.number_of_bounded_distances();
}

auto geodesic_options(double tolerance)
{
  return CGAL::parameters::tolerance(tolerance).visitor([] { return !is_interrupted(); });
}

template <class Any_surface, class Options>
IT::Geodesic_distances distances_from(const Any_surface& surface, const std::vector<IT::Vertex_index>& sources,
                                      const Options& options)
{
  return IT::geodesic_distances(surface, sources, options);
}
template <class Any_surface, class Options>
IT::Geodesic_distances distances_from(const Any_surface& surface, const std::vector<IT::Geodesic_source>& sources,
                                      const Options& options)
{
  return IT::geodesic_distances_from(surface, sources, options);
}

// The distances, unless they come from heat, and the ones for comparison.
// \param surface a triangulation, or a cover that is made of sheets
// \param sources vertices, or `Geodesic_source`s
template <class Any_surface, class Sources>
void follow_ways(const Distance_options& options, const Any_surface& surface, const Sources& sources,
                 Progress& progress, Distance_result& result)
{
  if (!options.is_by_heat() && !options.maximum_change) {
    progress.begin("following straight ways");
    IT::Geodesic_distances found = distances_from(surface, sources, geodesic_options(options.tolerance()));
    result.is_complete = found.is_complete;
    result.distances = std::move(found.distances);
    result.nearest_sources = std::move(found.nearest_sources);
  }
  if (options.is_compared) {
    progress.begin("following all straight ways");
    const IT::Geodesic_distances exact = distances_from(surface, sources, geodesic_options(0));
    result.is_complete = result.is_complete && exact.is_complete;
    result.errors = compare(result.distances, exact.distances);
  }
}

// The distances with their intervals, by way of fewer vertices.
void find_by_simplification(const Distance_options& options, Triangulation& triangulation, Progress& progress,
                            Distance_result& result)
{
  const auto while_not_interrupted = CGAL::parameters::visitor([] { return !is_interrupted(); });
  progress.begin("simplifying");
  const IT::Simplified_surface simplified = IT::simplify_surface(
    triangulation,
    CGAL::parameters::maximum_change(*options.maximum_change).visitor([&](double done) { return progress(done); }));
  result.change = IT::Metric_change{simplified.shrink, simplified.stretch};
  result.number_of_simplified_vertices = simplified.kept.size();
  progress.begin("following all straight ways");
  IT::Distance_intervals found = IT::Simplified_distances(simplified).from(sources_of(options), while_not_interrupted);
  result.distances = std::move(found.distances);
  result.vectors.push_back({"lower", std::move(found.lower)});
  result.vectors.push_back({"upper", std::move(found.upper)});
}

// Distances from a curve become positive to its left, and negative to its right.
void set_signs(const Triangulation& triangulation, const Placed_sources& placed, Distance_result& result)
{
  if (placed.sources.size() != 1)
    throw Usage_error("--signed needs one curve");
  const std::vector<CGAL::Sign> signs = IT::sides_of_curve(triangulation.input(), placed.sources.front().parts.front());
  for (std::size_t v = 0; v < signs.size(); ++v)
    if (signs[v] == CGAL::NEGATIVE)
      result.distances[v] = -result.distances[v];
}
void set_signs(const IT::Tufted_cover&, const Placed_sources&, Distance_result&) {} // refused by check()

// On all cores.
template <class Any_surface>
void find_matrix(const Distance_options& options, const Any_surface& surface, Progress& progress,
                 Distance_result& result)
{
  progress.begin("following straight ways");
  const auto go_further = [&progress](double done) { return done > 0 ? progress(done) : !is_interrupted(); };
  const IT::Geodesic_distance_matrix found = IT::geodesic_distance_matrix<CGAL::Parallel_if_available_tag>(
    surface, sources_of(options), to_vertices(options.targets),
    CGAL::parameters::tolerance(options.method == "exact" ? 0 : 0.001).visitor(go_further));
  result.is_complete = found.is_complete;
  for (const std::vector<double>& row : found.distances)
    result.distances.insert(result.distances.end(), row.begin(), row.end());
}

void add_lines(const Distance_options& options, const Triangulation& triangulation, const Placed_sources& placed,
               Progress& progress, Distance_result& result)
{
  progress.begin("following lines");
  result.lines = find_lines(options.lines, triangulation, placed.sources, options.is_signed, options.tolerance(),
                            result.largest_distance());
}
void add_lines(const Distance_options&, const IT::Tufted_cover&, const Placed_sources&, Progress&, Distance_result&) {
} // they imply a surface

// \param place_sources places the sources if they are not only vertices
template <class Any_surface, class Place_sources>
void follow_ways_from(const Place_sources& place_sources, const Distance_options& options, const Any_surface& surface,
                      Progress& progress, Distance_result& result)
{
  if (!options.matrix_path.empty())
    return find_matrix(options, surface, progress, result);
  if (!options.has_places())
    return follow_ways(options, surface, sources_of(options), progress, result);
  progress.begin("placing the sources");
  const Placed_sources placed = place_sources();
  result.largest_snap = placed.largest_snap;
  result.source_points = placed.points;
  result.source_curves = placed.curves;
  follow_ways(options, surface, placed.sources, progress, result);
  if (options.is_signed)
    set_signs(surface, placed, result);
  if (options.lines.are_wanted())
    add_lines(options, surface, placed, progress, result);
  progress.begin("choosing vertices");
  if (!options.samples_path.empty())
    result.samples =
      IT::farthest_vertices(surface, placed.sources, options.number_of_samples, geodesic_options(options.tolerance()));
}

// The first axis of the tangent plane of each source, transported to the vertices nearest to it; and for a single
// source the logarithmic map.
void find_vectors(const Distance_options& options, const Triangulation& triangulation,
                  const std::vector<std::array<double, 3>>& points, Distance_result& result)
{
  const std::size_t n = result.number_of_vertices;
  const IT::Vector_heat_method heat(triangulation, CGAL::parameters::visitor([] { return !is_interrupted(); }));
  std::vector<std::pair<IT::Vertex_index, std::complex<double>>> axes;
  for (std::uint64_t v : std::set<std::uint64_t>(options.sources.vertices.begin(), options.sources.vertices.end()))
    axes.push_back({IT::Vertex_index(IT::Vertex_index::size_type(v)), {1, 0}});
  const auto transported = heat.transport_tangent_vectors(axes);
  Named_values axis{"axis", {}, points.empty() ? std::size_t(2) : std::size_t(3)};
  const auto frames = points.empty() ? std::vector<IT::Vertex_frame>() : IT::vertex_frames(triangulation, points);
  for (std::size_t v = 0; v < n; ++v) {
    const std::complex<double>& z = transported[v];
    const std::array<double, 3> vector =
      points.empty() ? std::array<double, 3>{z.real(), z.imag(), 0} : frames[v].in_space(z);
    axis.values.insert(axis.values.end(), vector.begin(), vector.begin() + std::ptrdiff_t(axis.components));
  }
  result.vectors.push_back(std::move(axis));
  if (axes.size() > 1)
    return;
  Named_values log{"log", {}, 2};
  const auto map = heat.log_map(axes.front().first);
  for (std::size_t v = 0; v < n; ++v)
    log.values.insert(log.values.end(), {map[v].real(), map[v].imag()});
  result.vectors.push_back(std::move(log));
}

// Any triangles: heat on their tufted cover, straight ways on sheets of them.
// \param make_cover makes a cover of the given kind
// \param place_on places the sources on it
template <class Make_cover, class Place_on>
void find_on_cover(const Distance_options& options, const Make_cover& make_cover, const Place_on& place_on,
                   Progress& progress, Distance_result& result)
{
  const auto with = [&](IT::Surface_cover kind, const auto& find) {
    progress.begin("covering");
    Stopwatch stopwatch;
    IT::Tufted_cover cover = make_cover(kind);
    result.nonmanifold_edges = cover.report.nonmanifold_edges;
    result.flips += IT::flip_to_Delaunay(cover.triangulation, CGAL::parameters::visitor(std::ref(progress))).flips;
    result.triangulation_seconds += stopwatch.restart();
    find(cover);
    result.distance_seconds += stopwatch.seconds();
  };
  if (options.is_by_heat())
    with(IT::Surface_cover::TUFTED,
         [&](const IT::Tufted_cover& cover) { find_by_heat(options, cover, sources_of(options), progress, result); });
  if (!options.is_by_heat() || options.is_compared)
    with(IT::Surface_cover::SHEETS, [&](const IT::Tufted_cover& cover) {
      follow_ways_from([&] { return place_on(cover); }, options, cover, progress, result);
    });
}

void find_on_cover(const Distance_options& options, Distance_result& result)
{
  const Stopwatch stopwatch;
  if (is_gluing_file(options.input)) {
    Progress progress(options.input, "reading");
    const IT::Exact_gluing gluing = read_gluing_file(options.input, std::ref(progress));
    set_number_of_vertices(options, gluing.complex.number_of_vertices(), result);
    result.read_seconds = stopwatch.seconds();
    find_on_cover(
      options,
      [&gluing](IT::Surface_cover kind) {
        return IT::make_tufted_cover(gluing.complex, gluing.lengths, CGAL::parameters::surface_cover(kind));
      },
      [&](const IT::Tufted_cover& cover) {
        std::vector<std::array<std::uint32_t, 3>> triangles;
        for (IT::Face_index f : gluing.complex.faces()) {
          const IT::Halfedge_index h = gluing.complex.halfedge(f);
          triangles.push_back({gluing.complex.source(h).idx(), gluing.complex.target(h).idx(),
                               gluing.complex.target(gluing.complex.next(h)).idx()});
        }
        return place_sources(options.sources, cover, {}, triangles);
      },
      progress, result);
  } else {
    Triangle_soup soup = read_triangle_soup(options.input);
    check_view(options.view_path, soup.triangles.size());
    set_number_of_vertices(options, soup.points.size(), result);
    result.read_seconds = stopwatch.seconds();
    Progress progress(options.input, "covering");
    find_on_cover(
      options,
      [&soup](IT::Surface_cover kind) {
        return IT::make_tufted_cover(soup.points, soup.triangles, CGAL::parameters::surface_cover(kind));
      },
      [&](const IT::Tufted_cover& cover) { return place_sources(options.sources, cover, soup.points, soup.triangles); },
      progress, result);
    result.points = std::move(soup.points);
    result.triangles = std::move(soup.triangles);
    result.warnings = std::move(soup.warnings);
  }
}

void find_without_barriers(const Distance_options& options, Triangulation& triangulation,
                           const std::vector<std::array<double, 3>>& points, Progress& progress,
                           Distance_result& result)
{
  if (options.is_by_heat())
    find_by_heat(options, triangulation, sources_of(options), progress, result);
  if (options.maximum_change)
    find_by_simplification(options, triangulation, progress, result);
  follow_ways_from([&] { return place_sources(options.sources, triangulation, points); }, options, triangulation,
                   progress, result);
}

// On the surface, cut open.
void find_with_barriers(const Distance_options& options, const Triangulation& of_input,
                        const std::vector<std::array<double, 3>>& points, Progress& progress, Distance_result& result)
{
  progress.begin("placing the sources and the barriers");
  const Placed_sources placed = place_sources(options.sources, of_input, points);
  result.largest_snap = placed.largest_snap;
  const IT::Surface_with_barriers surface = place_barriers(options.barriers, of_input, points, result.largest_snap);
  Triangulation triangulation(surface.connectivity(), surface.points());
  result.flips += IT::flip_to_Delaunay(triangulation, CGAL::parameters::visitor(std::ref(progress))).flips;
  if (options.is_by_heat()) {
    std::vector<IT::Vertex_index> sources;
    for (IT::Vertex_index v : sources_of(options))
      for (IT::Vertex_index copy : surface.copies(v))
        sources.push_back(copy);
    find_by_heat(options, triangulation, sources, progress, result);
  }
  const std::vector<IT::Geodesic_source> sources = surface.sources(placed.sources);
  follow_ways(options, triangulation, sources, progress, result);
  if (options.lines.are_wanted()) {
    progress.begin("following lines");
    result.lines =
      find_lines(options.lines, triangulation, sources, false, options.tolerance(), result.largest_distance());
    result.lines.input = of_input.input();
    for (std::optional<IT::Surface_lines>* found : {&result.lines.isolines, &result.lines.borders})
      if (*found)
        for (IT::Surface_line& line : (*found)->lines)
          line.points = surface.on_input(line.points);
  }
  IT::Geodesic_distances nearer =
    surface.of_nearer_sides({std::move(result.distances), 0, true, std::move(result.nearest_sources)});
  result.distances = std::move(nearer.distances);
  result.nearest_sources = std::move(nearer.nearest_sources);
  if (options.is_signed)
    set_signs(of_input, placed, result);
}

// An oriented surface.
void find_on_surface(const Distance_options& options, Distance_result& result)
{
  Stopwatch stopwatch;
  Surface surface = load_surface(options.input, options.repair);
  const IT::Delta_complex& complex = surface.connectivity;
  set_number_of_vertices(options, complex.number_of_vertices(), result);
  result.read_seconds = stopwatch.restart();
  Progress progress(options.input, "triangulating");
  auto triangulation = first_triangulation<Triangulation::Traits>(surface);
  const bool has_view = !options.view_path.empty();
  if (has_view) {
    check_view(options.view_path, complex.number_of_faces());
    result.input_numbers = surface.saved ? IT::element_numbers(make_triangulation<Triangulation::Traits>(surface))
                                         : IT::element_numbers(triangulation);
  }
  result.flips = IT::flip_to_Delaunay(triangulation, CGAL::parameters::visitor(std::ref(progress))).flips;
  if (options.is_refined) {
    triangulation.set_interruption([] { return !is_interrupted(); }); // a single decision can take long
    const IT::Refinement_report refinement =
      IT::refine_Delaunay(triangulation, CGAL::parameters::visitor(Refinement_watch{progress}));
    result.flips += refinement.flips;
    result.number_of_inserted_vertices =
      triangulation.connectivity().number_of_vertices() - complex.number_of_vertices();
  }
  result.triangulation_seconds = stopwatch.restart();
  if (has_view)
    result.numbers = IT::element_numbers(triangulation);
  if (has_view || !options.overlay_path.empty()) {
    progress.begin("overlay");
    result.subdivision.emplace(triangulation);
  }
  if (options.barriers.has_files())
    find_with_barriers(options, triangulation, surface.points, progress, result);
  else
    find_without_barriers(options, triangulation, surface.points, progress, result);
  if (result.subdivision)
    result.overlay_distances.values = IT::interpolate_intrinsic_values(*result.subdivision, result.distances);
  if (options.matrix_path.empty())
    result.distances.resize(result.number_of_vertices); // without vertices inserted by refinement
  progress.begin("factoring and solving for vectors");
  if (options.has_vectors)
    find_vectors(options, triangulation, surface.points, result);
  result.distance_seconds = stopwatch.seconds();
  for (IT::Face_index f : complex.faces()) {
    const IT::Halfedge_index h = complex.halfedge(f);
    result.triangles.push_back(
      {complex.source(h).idx(), complex.target(h).idx(), complex.target(complex.next(h)).idx()});
  }
  result.points = std::move(surface.points);
  result.warnings = std::move(surface.warnings);
  result.cuts = cuts_text(repairs(surface));
}

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
  if (result.change && !result.errors)
    return "proven up to rounding: at most " + in_short(100 * (1 - result.change->shrink)) + " % too short and " +
           in_short(100 * (result.change->stretch - 1)) + " % too long, found on " +
           counted(result.number_of_simplified_vertices, "vertex", "vertices");
  if (result.errors)
    return "mean error " + in_short(100 * (*result.errors)[0]) + " %, largest " + in_short(100 * (*result.errors)[1]) +
           " %";
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
    if (std::isfinite(result.distances[v]))
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

View view_of(const Distance_options& options, const Distance_result& result)
{
  View view =
    result.subdivision
      ? make_view(options.input, options.is_refined ? "refined triangulation" : "intrinsic Delaunay triangulation",
                  *result.subdivision, result.points, result.input_numbers, result.numbers)
      : make_view(options.input, result.points, result.triangles);
  view.fields.push_back({"distance",
                         "in the unit of the input",
                         false,
                         {result.subdivision ? result.overlay_distances.values : result.distances}});
  view.path = result.source_curves;
  view.path_name = "lines with distance zero";
  view.marks = result.source_points;
  if (!options.has_places())
    for (std::uint64_t v : options.sources.vertices)
      view.marks.push_back(result.points[v]);
  view.marks_name = counted(view.marks.size(), "point", "points") + " with distance zero";
  if (options.lines.are_wanted())
    result.lines.show(view, result.points);
  return view;
}

// Adds the vertices that are named in files.
void read_vertex_files(Distance_options& options)
{
  const auto read = [](const std::string& path, std::vector<std::uint64_t>& vertices) {
    const std::vector<std::uint64_t> more = path.empty() ? std::vector<std::uint64_t>() : read_vertices(path);
    vertices.insert(vertices.end(), more.begin(), more.end());
  };
  read(options.source_vertices_path, options.sources.vertices);
  read(options.target_vertices_path, options.targets);
}

Exit_status run_distance(Distance_options options)
{
  if (options.maximum_change || options.lines.are_wanted() || options.barriers.has_files())
    options.cover = "none";
  read_vertex_files(options);
  check(options);
  return for_each_input({options.input}, [&](const std::string& path) {
    Distance_result result;
    try {
      if (options.cover == "tufted" && !is_saved_triangulation(readable_file(options.input)))
        find_on_cover(options, result);
      else
        find_on_surface(options, result);
    } catch (const IT::Numerical_error& error) {
      throw IT::Numerical_error(error.what() +
                                std::string(options.time_coefficient > 1 ? "; try a smaller --time" : ""));
    }
    if (result.is_far_from_right()) {
      result.warnings.push_back("heat gave " + std::to_string(result.number_of_bounded_distances) + " of " +
                                std::to_string(result.number_of_vertices) +
                                " distances which are shorter than straight lines or longer than paths along edges, by "
                                "more than 5 %: others are inaccurate, too; omit --method heat");
      std::cerr << "idt: " << path << ": " << result.warnings.back() << std::endl;
    }
    const std::string& output = options.output_path;
    const std::string type = extension_with_format(output, options.format);
    if (result.points.empty() && result.number_of_vertices > 0 && !type.empty() && type != ".csv")
      throw Usage_error(output + ": " + path + " has only lengths, no points: write a .csv file");
    if (result.points.empty() && !(options.overlay_path.empty() && options.view_path.empty()))
      throw Usage_error(path + " has only lengths, no points: omit " +
                        (options.overlay_path.empty() ? "--view" : "--overlay"));
    write_file(options.overlay_path, [&](std::ostream& os) {
      write_overlay(os, *result.subdivision, result.points, *options.overlay_format(), false,
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
    write_report(std::cout, options, result);
    flush_standard_output();
    return Exit_status::DONE;
  });
}

} // namespace

void add_distance_command(CLI::App& app, Selected_command& selected)
{
  const auto options = std::make_shared<Distance_options>();
  CLI::App& command = *app.add_subcommand("distance", "Find the distances of all vertices from some of them");
  command.footer(
    "Distances are lengths of shortest paths on an intrinsic Delaunay triangulation, or computed by the heat\n"
    "method. They are zero at the sources, and infinite where no source is connected. Vertices are counted from\n"
    "zero.\n");
  command
    .add_option("INPUT", options->input, "a mesh, or a .gluing file of triangles with lengths; - is the standard input")
    ->required();
  add_option(command, "--source", options->sources.vertices, "V[,V...]", "the vertices with distance zero")
    ->delimiter(',')
    ->allow_extra_args(false)
    ->transform(whole_number());
  add_option(command, "--source-vertices", options->source_vertices_path, "F.csv",
             "more vertices with distance zero, one in each line");
  add_option(command, "--source-points", options->sources.points_path, "F.csv",
             "points with distance zero: a table that begins with input_face,b0,b1,b2 (barycentric coordinates), or "
             "with x,y,z, of which the nearest points of the surface are taken");
  add_option(command, "--source-edges", options->sources.edges_path, "F.csv",
             "edges with distance zero: two vertices in each line");
  add_option(command, "--source-curve", options->sources.curve_path, "F.csv",
             "a curve with distance zero, as `idt geodesic` writes it, or through points as for --source-points, along "
             "shortest paths");
  add_option(
    command, "--barrier", options->barriers.curve_path, "F.csv",
    "a curve that no path crosses, given as --source-curve; paths turn around its ends, and a vertex on it has "
    "the smaller distance of its sides; implies --cover none");
  add_option(command, "--barrier-edges", options->barriers.edges_path, "F.csv",
             "edges that no path crosses: two vertices in each line");
  add_option(command, "-o,--output", options->output_path, "F.(csv|ply|vtp)",
             "write the distances: as a table, or as the mesh with a value at each vertex");
  add_option(command, "--overlay", options->overlay_path, "F.(ply|vtp)",
             "write the overlay of input and triangulation, as `idt triangulate` does, with the distance at each of "
             "its vertices");
  command.add_flag("--signed", options->is_signed,
                   "distances to the right of the curve are negative; it has to be closed, or to lead from border to "
                   "border, and to cut something off");
  add_option(
    command, "--labels", options->labels_path, "F.csv",
    "write the nearest source of each vertex: first those of --source, then each point, all edges, each curve");
  add_option(
    command, "--matrix", options->matrix_path, "F.(csv|mtx)",
    "write a row of distances for each vertex of --source, and a column for each one of --target, found on all "
    "cores; other distances are not found");
  add_option(command, "--target", options->targets, "V[,V...]", "the vertices of the columns of --matrix")
    ->delimiter(',')
    ->allow_extra_args(false)
    ->transform(whole_number());
  add_option(command, "--target-vertices", options->target_vertices_path, "F.csv", "more of them, one in each line");
  options->lines.add_options(command);
  add_option(command, "--farthest", options->number_of_samples, "N",
             "choose N vertices, each as far as possible from the sources and from those before")
    ->transform(whole_number());
  add_option(command, "--samples", options->samples_path, "F.csv",
             "write the vertices of --farthest in their order, with their distances");
  set_words(command.add_option("--format", options->format, "the format of -o - and the like on the standard output"),
            {"csv", "ply", "vtp", "mtx"})
    ->type_name("EXT")
    ->capture_default_str();
  set_words(command.add_option("--cover", options->cover,
                               "tufted: any triangles, with heat on a closed surface over them; none: triangles that "
                               "form an oriented surface"),
            {"tufted", "none"})
    ->capture_default_str();
  set_words(command.add_option(
              "--method", options->method,
              "approximate: follow straight ways over the faces, nearly equal ones together; exact: follow each of "
              "them; heat: the heat method. The default is approximate, or heat with --boundary or --time"),
            {"approximate", "exact", "heat"});
  add_option(
    command, "--maximum-change", options->maximum_change, "C",
    "follow all ways on a simplified surface, as of `idt simplify`, where distances change by at most this part, and "
    "also write proven bounds of each distance: lower and upper; implies --cover none");
  command.add_flag("--compare-exact", options->is_compared,
                   "report the mean and the largest error compared with the exact distances");
  set_words(
    command.add_option(
      "--boundary", options->boundary,
      "heat at the border: neumann, none leaves (default); dirichlet, the border is cold; average, the mean of both"),
    {"neumann", "dirichlet", "average"});
  command.add_flag("--refine", options->is_refined, "first insert vertices until no angle is below 25 degrees");
  add_option(command, "--time", options->time_coefficient, "T",
             "how long heat spreads, in units of the squared mean edge length: larger is smoother; 1 by default");
  command.add_flag("--vectors", options->has_vectors,
                   "also write the first axis of the source, parallel-transported to each vertex, and for one source "
                   "its logarithmic map");
  add_view_option(command, options->view_path);
  add_repair_option(command, options->repair);
  add_option(command, "--stats", options->stats_path, "F.json", "write the report as a JSON object");
  command.callback([options, &selected] { selected = [options] { return run_distance(*options); }; });
}

} // namespace idt
