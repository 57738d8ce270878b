// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `idt geodesic`

#include "commands/command_line.h"
#include "commands/commands.h"
#include "commands/distance_sources.h"
#include "commands/geodesic_result.h"
#include "input/Surface.h"
#include "input/Triangle_soup.h"
#include "input/mesh_file.h"
#include "input/repair.h"
#include "number_types/make_triangulation.h"
#include "output/Output_file.h"
#include "system/Interruption.h"
#include "system/Progress.h"
#include "system/Stopwatch.h"
#include "view/View.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Geodesic_path_network.h>
#include <CGAL/Intrinsic_triangulations/Point_location.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/geodesic_path.h>
#include <CGAL/Intrinsic_triangulations/cut_along_path.h>
#include <CGAL/Intrinsic_triangulations/nearest_source_point.h>
#include <CGAL/Intrinsic_triangulations/shortest_path.h>
#include <CGAL/Intrinsic_triangulations/shortest_path_on_triangles.h>
#include <CGAL/Intrinsic_triangulations/trace_geodesic.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace idt {
namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

struct Geodesic_options
{
  std::string input;
  std::string from, to; // stops, as Stop reads them
  std::vector<std::string> via;
  bool is_closed = false, is_shortest = false;
  std::optional<double> direction, length;
  std::uint64_t maximum_number_of_faces = 1000000;
  Named_sources barriers, curve; // the end
  std::string output_path, cut_path, stats_path, view_path, format = "csv";
  Repair_options repair;
};

// A vertex, or a point in space.
struct Stop
{
  std::optional<std::uint64_t> vertex;
  std::array<double, 3> point{};

  // \param text "V" or "X,Y,Z"
  Stop(const std::string& option, std::string text)
  {
    if (text.find(',') == std::string::npos) {
      if (!whole_number()(text).empty())
        throw Usage_error(option + ": \"" + text + "\" is neither a vertex nor a point: write V or X,Y,Z");
      vertex = std::stoull(text);
      return;
    }
    std::replace(text.begin(), text.end(), ',', ' ');
    std::istringstream numbers(text);
    std::string rest;
    for (double& x : point)
      if (!(numbers >> x))
        throw Usage_error(option + ": a point has three finite coordinates: write X,Y,Z");
    if (numbers >> rest)
      throw Usage_error(option + ": a point has three finite coordinates: write X,Y,Z");
  }
};

void check(const Geodesic_options& options)
{
  if (options.direction.has_value() != options.length.has_value())
    throw Usage_error("--direction and --length belong together");
  if (options.direction && (!options.to.empty() || !options.via.empty() || options.is_closed))
    throw Usage_error("a line in a direction has no --to, --via or --closed");
  if (options.curve.has_files() && (options.direction || options.is_closed || !options.to.empty()))
    throw Usage_error("--to-curve is for paths: without --to, --closed and --direction");
  if (!options.direction && options.to.empty() && !options.curve.has_files() && !options.is_closed)
    throw Usage_error(
      "a path needs --to or --to-curve, a closed one --via or --to with --closed, and a line --direction and --length");
  if (options.is_closed && options.via.size() + (options.to.empty() ? 0 : 1) < 2)
    throw Usage_error(
      "--closed needs two of --via and --to besides --from: the curve initially runs through these vertices");
  if (options.direction &&
      (!std::isfinite(*options.direction) || !std::isfinite(*options.length) || *options.length < 0))
    throw Usage_error("--direction and --length have to be finite, and the length not negative");
  if (options.is_shortest && (options.direction || options.is_closed))
    throw Usage_error("--shortest is for paths: without --direction and --closed");
  if (options.direction && !Stop("--from", options.from).vertex)
    throw Usage_error("a line in a direction begins at a vertex: --from V");
  if (options.barriers.has_files() && (options.direction || !options.view_path.empty()))
    throw Usage_error("--barrier and --barrier-edges are for paths: without --direction and --view");
  const std::optional<Mesh_format> cut_format = find_mesh_format(options.cut_path);
  if (!options.cut_path.empty() && (!cut_format || cut_format == Mesh_format::STL))
    throw Usage_error(
      options.cut_path +
      ": the surface that is cut open is written as a file whose name ends in .off, .obj, .ply, .ts or .vtp");
  const std::string type = extension_with_format(options.output_path, options.format);
  if (!options.output_path.empty() && type != ".obj" && type != ".csv" && type != ".ply" && type != ".vtp")
    throw Usage_error(options.output_path +
                      ": a curve is written as a file whose name ends in .obj, .csv, .ply or .vtp");
  check_output_paths(
    {options.output_path, options.cut_path, options.stats_path, options.view_path},
    {options.input, options.curve.curve_path, options.barriers.curve_path, options.barriers.edges_path});
  check_view(options.view_path);
}

bool goes_on() { return !is_interrupted(); }

std::string name(IT::Geodesic_status status)
{
  switch (status) {
  case IT::Geodesic_status::GEODESIC:
    return "geodesic";
  case IT::Geodesic_status::CONTRACTIBLE:
    return "contractible";
  case IT::Geodesic_status::BLOCKED:
    return "blocked";
  case IT::Geodesic_status::NOT_IMPROVABLE:
    return "not_improvable";
  case IT::Geodesic_status::UNFINISHED:
    break;
  }
  return "unfinished";
}

IT::Vertex_index vertex(const Triangulation& triangulation, std::uint64_t number)
{
  const std::uint64_t n = triangulation.input().number_of_vertices();
  if (number >= n)
    throw Usage_error("there is no vertex " + std::to_string(number) + ": the surface has " + std::to_string(n) +
                      ", counted from 0");
  return IT::Vertex_index(IT::Vertex_index::size_type(number));
}

// The ends and what lies between them, each with its option.
std::vector<std::pair<std::string, std::string>> stops_of(const Geodesic_options& options)
{
  std::vector<std::pair<std::string, std::string>> result{{"--from", options.from}};
  for (const std::string& text : options.via)
    result.emplace_back("--via", text);
  result.emplace_back("--to", options.to);
  return result;
}

// As messages call it.
std::string name_of_stop(const std::string& text)
{
  return (text.find(',') == std::string::npos ? "vertex " : "the point ") + text;
}

// The point of the surface that is nearest to a stop in space.
IT::Surface_point nearest_point(const IT::Delta_complex& complex, const std::vector<std::array<double, 3>>& points,
                                const std::string& option, const Stop& stop, std::vector<Snap>& snaps)
{
  const IT::Surface_point nearest = IT::locate(complex, points, stop.point);
  const auto [x, y, z] = IT::point_in_space(complex, points, nearest);
  snaps.push_back({option, std::hypot(x - stop.point[0], y - stop.point[1], z - stop.point[2])});
  return nearest;
}

// The vertex of a stop; for a point in space, a vertex is inserted at the nearest point of the surface.
IT::Vertex_index vertex(const Surface& surface, Triangulation& triangulation, const std::string& option,
                        const std::string& text, std::vector<Snap>& snaps)
{
  const Stop stop(option, text);
  if (stop.vertex)
    return vertex(triangulation, *stop.vertex);
  if (!surface.has_points())
    throw Usage_error(surface.path + " has only lengths, no points: begin and end at vertices");
  return IT::vertex_at_point(triangulation, nearest_point(surface.connectivity, surface.points, option, stop, snaps));
}

// Calls a function, and names stops as the user does if there is no path from one to the next.
template <class Function>
auto with_names(const std::vector<std::string>& names, std::size_t i, const Function& find)
{
  try {
    return find();
  } catch (const IT::Invalid_argument_error&) {
    throw IT::Invalid_argument_error("no path leads from " + names[i] + " to " + names[i + 1] +
                                     ": choose two of the same component");
  }
}

// The curve at which the path ends, on a Delaunay triangulation.
IT::Geodesic_source end_curve(const Geodesic_options& options, const Triangulation& triangulation,
                              const std::vector<std::array<double, 3>>& points)
{
  IT::Geodesic_source result;
  for (const IT::Geodesic_source& curve : place_sources(options.curve, triangulation, points).sources)
    result.parts.insert(result.parts.end(), curve.parts.begin(), curve.parts.end());
  return result;
}

// \param end_on gives the curve on the surface where the path ends, if there is one
template <class End_on>
Geodesic_result find_path(const Geodesic_options& options, const Surface& surface, Triangulation& triangulation,
                          const End_on& end_on)
{
  Geodesic_result curve;
  std::vector<IT::Vertex_index> stops;
  std::vector<std::string> names;
  const auto add_stop = [&](const std::string& option, const std::string& text) {
    names.push_back(name_of_stop(text));
    stops.push_back(vertex(surface, triangulation, option, text, curve.snaps));
  };
  add_stop("--from", options.from);
  for (const std::string& text : options.via)
    add_stop("--via", text);
  const std::size_t last_via = stops.size();
  if (!options.to.empty())
    add_stop("--to", options.to);
  if (options.curve.has_files()) {
    IT::flip_to_Delaunay(triangulation, CGAL::parameters::visitor(&goes_on));
    names.push_back("the curve");
    const IT::Geodesic_source curves = end_on(triangulation);
    const IT::Nearest_source_point end = with_names(names, names.size() - 2, [&] {
      return IT::nearest_source_point(triangulation, stops.back(), curves, CGAL::parameters::visitor(&goes_on));
    });
    stops.push_back(IT::vertex_at_point(triangulation, end.point));
  }
  if (options.is_closed) {
    stops.push_back(stops.front());
    names.push_back(names.front());
  }
  const auto np = CGAL::parameters::visitor(&goes_on);
  if (options.is_shortest)
    IT::flip_to_Delaunay(triangulation, np);
  IT::Geodesic_path_network<IT::Filtered_edge_length_traits> network(triangulation);
  IT::internal::Path_over_stops path;
  std::vector<IT::Halfedge_index> start; // along edges
  for (std::size_t i = 0; i + 1 < stops.size(); ++i)
    with_names(names, i, [&] {
      if (options.is_shortest)
        return path.append_shortest(triangulation, network, stops[i], stops[i + 1], np);
      const std::vector<IT::Halfedge_index> part = IT::shortest_edge_path(triangulation, stops[i], stops[i + 1]);
      start.insert(start.end(), part.begin(), part.end());
    });
  if (options.is_shortest) {
    curve.distance = path.distance;
  } else {
    const std::size_t p = options.is_closed ? network.add_closed_path(start) : network.add_path(start);
    for (std::size_t i = 1; !options.is_closed && i < last_via; ++i)
      network.fix(stops[i]);
    path.append(triangulation, network, p, np);
    curve.initial_length = path.initial_length;
    if (path.status == IT::Geodesic_status::CONTRACTIBLE)
      curve.vertex = network.contraction(p);
  }
  curve.points = std::move(path.points);
  curve.length = path.length;
  curve.flips = path.flips;
  curve.is_geodesic = path.is_geodesic;
  curve.status = name(path.status);
  return curve;
}

// At an inner vertex the direction 0 points to the neighbour with the smallest number; at the border, along the first
// side of the fan.
IT::Halfedge_index reference(const IT::Delta_complex& complex, IT::Vertex_index v)
{
  const IT::Halfedge_index first = complex.halfedge(v);
  if (!first.is_valid())
    throw IT::Invalid_argument_error("vertex " + std::to_string(v.idx()) + " belongs to no face: choose one that does");
  IT::Halfedge_index best = first;
  if (!complex.is_border(first))
    for (IT::Halfedge_index h : IT::internal::Halfedges_around(complex, v))
      if (complex.source(h) < complex.source(best))
        best = h;
  return complex.opposite(best);
}

Geodesic_result trace(const Geodesic_options& options, const Triangulation& triangulation)
{
  const IT::Halfedge_index h =
    reference(triangulation.connectivity(), vertex(triangulation, *Stop("--from", options.from).vertex));
  IT::Traced_geodesic line =
    IT::trace_geodesic(triangulation, IT::direction_at_vertex(triangulation, h, *options.direction), *options.length,
                       CGAL::parameters::maximum_number(options.maximum_number_of_faces));
  Geodesic_result curve;
  curve.length = line.length;
  curve.points = std::move(line.points);
  switch (line.status) {
  case IT::Trace_status::AT_LENGTH:
    curve.status = "at_length";
    break;
  case IT::Trace_status::AT_BORDER:
    curve.status = "at_border";
    break;
  case IT::Trace_status::AT_VERTEX:
    curve.status = "at_vertex";
    curve.vertex = line.vertex;
    break;
  case IT::Trace_status::BUDGET_EXHAUSTED:
    curve.status = "unfinished";
    break;
  }
  return curve;
}

// The surface, cut open; its vertices at barriers are no stops, as these have several sides.
IT::Surface_with_barriers with_barriers(const Geodesic_options& options, const Surface& surface,
                                        const Triangulation& triangulation)
{
  double largest_snap = -1;
  IT::Surface_with_barriers result = place_barriers(options.barriers, triangulation, surface.points, largest_snap);
  for (const auto& [option, text] : stops_of(options))
    if (!text.empty())
      if (const std::optional<std::uint64_t> v = Stop(option, text).vertex)
        if (result.copies(vertex(triangulation, *v)).size() > 1)
          throw Usage_error("vertex " + std::to_string(*v) + " lies on a barrier: choose a point X,Y,Z beside it");
  return result;
}

// Whether the line can be a path over triangles that are no surface.
bool takes_any_triangles(const Geodesic_options& options)
{
  return !options.direction && !options.is_closed && !options.curve.has_files() && !options.barriers.has_files() &&
         options.cut_path.empty() && options.view_path.empty() && !options.repair.is_wanted;
}

Geodesic_result find_path_over(const Triangle_soup& soup, const Geodesic_options& options)
{
  const auto np = CGAL::parameters::visitor(&goes_on);
  const IT::internal::Points points = IT::internal::copy_points(soup.points);
  const auto triangles = IT::internal::copy_triangles(soup.triangles, points.size());
  IT::internal::Divided_triangles divided(points, triangles);
  std::optional<IT::Tufted_cover> cover;     // where points are looked for
  std::vector<std::array<double, 3>> places; // of its vertices
  Geodesic_result curve;
  std::vector<IT::internal::Path_stop> stops;
  for (const auto& [option, text] : stops_of(options)) {
    const Stop stop(option, text);
    if (stop.vertex) {
      IT::internal::require_vertex(*stop.vertex, points.size());
      stops.push_back({std::uint32_t(*stop.vertex), name_of_stop(text)});
      continue;
    }
    if (!cover) {
      cover = IT::make_tufted_cover(points, triangles,
                                    CGAL::parameters::surface_cover(IT::Surface_cover::SHEETS).visitor(&goes_on));
      for (std::uint32_t v : cover->vertex_of)
        places.push_back(points[v]);
    }
    const IT::Surface_point nearest = nearest_point(cover->triangulation.input(), places, option, stop, curve.snaps);
    stops.push_back(
      {divided.vertex_at(IT::internal::point_below_cover(*cover, points, triangles, nearest)), name_of_stop(text)});
  }
  IT::Path_on_triangles path = IT::internal::path_over_sheets(divided.points(), divided.triangles(), stops, np);
  for (IT::Point_in_triangle& p : path.points)
    p = divided.in_given_triangle(p);
  curve.length = path.length;
  curve.distance = path.distance;
  curve.status = path.is_complete ? "geodesic" : "unfinished";
  curve.is_on_any_triangles = true;
  curve.line = points_in_faces(soup, path);
  curve.positions = std::move(path.positions);
  return curve;
}

Exit_status run_geodesic(Geodesic_options options)
{
  options.is_shortest = options.is_shortest || options.curve.has_files();
  check(options);
  return for_each_input({options.input}, [&](const std::string& path) {
    std::optional<Triangle_soup> soup; // if the triangles are no surface
    const Surface surface = load_surface(path, options.repair, {}, takes_any_triangles(options) ? &soup : nullptr);
    const std::string type = extension_with_format(options.output_path, options.format);
    if (!surface.has_points() && !type.empty() && type != ".csv")
      throw Usage_error(options.output_path + ": " + path + " has only lengths, no points: write a .csv file");
    if (!surface.has_points() && !(options.cut_path.empty() && options.view_path.empty()))
      throw Usage_error(path + " has only lengths, no points: omit " + (options.cut_path.empty() ? "--view" : "--cut"));
    check_view(options.view_path, surface.connectivity.number_of_faces());
    const Stopwatch stopwatch;
    std::optional<View> view;
    const auto find = [&] {
      const Progress progress(path, "looking for the line");
      if (soup)
        return find_path_over(*soup, options);
      if (options.barriers.has_files()) {
        Triangulation whole(surface.connectivity, surface.points);
        IT::flip_to_Delaunay(whole, CGAL::parameters::visitor(&goes_on));
        const IT::Surface_with_barriers cut = with_barriers(options, surface, whole);
        Surface opened;
        opened.path = path;
        opened.connectivity = cut.connectivity();
        opened.points = cut.points();
        Triangulation triangulation(opened.connectivity, opened.points);
        Geodesic_result curve = find_path(options, opened, triangulation, [&](const Triangulation&) {
          return cut.sources({end_curve(options, whole, surface.points)}).front();
        });
        curve.points = cut.on_input(curve.points);
        return curve;
      }
      auto triangulation = make_triangulation<Triangulation::Traits>(surface);
      const bool has_view = !options.view_path.empty();
      const IT::Element_numbers input_numbers = has_view ? IT::element_numbers(triangulation) : IT::Element_numbers();
      Geodesic_result curve =
        options.direction ? trace(options, triangulation)
                          : find_path(options, surface, triangulation,
                                      [&](const Triangulation& t) { return end_curve(options, t, surface.points); });
      if (has_view)
        view = make_view(path,
                         options.direction     ? "the same, as the line crosses edges"
                         : options.is_shortest ? "triangulation with the line as edges, after Delaunay flips"
                                               : "triangulation with the line as edges",
                         IT::Common_subdivision(triangulation), surface.points, input_numbers,
                         IT::element_numbers(triangulation));
      return curve;
    };
    Geodesic_result curve = [&] {
      try {
        return find();
      } catch (const IT::Invalid_surface_error& error) {
        // Where faces of zero area join vertices at one place, flips fail; over any triangles, they become one.
        if (soup || error.defect() != IT::Invalid_surface_error::Defect::ZERO_LENGTH_EDGE || !surface.has_points() ||
            !takes_any_triangles(options))
          throw;
        soup.emplace();
        soup->points = surface.points;
        for (IT::Face_index f : surface.connectivity.faces()) {
          const IT::Halfedge_index h = surface.connectivity.halfedge(f);
          soup->triangles.push_back({surface.connectivity.source(h).idx(), surface.connectivity.target(h).idx(),
                                     surface.connectivity.target(surface.connectivity.next(h)).idx()});
        }
        return find();
      }
    }();
    curve.seconds = stopwatch.seconds();
    curve.input = path;
    curve.is_closed = options.is_closed;
    curve.repairs = repairs(surface);
    curve.warnings = surface.warnings;
    if (!soup) {
      curve.line = points_in_faces(surface.connectivity, curve.points);
      for (const IT::Surface_point& p : curve.points)
        if (surface.has_points())
          curve.positions.push_back(IT::point_in_space(surface.connectivity, surface.points, p));
    }
    write_line(options.output_path, type, curve);
    write_file(options.cut_path, [&](std::ostream& os) {
      const IT::Cut_surface cut = IT::cut_along_path(surface.connectivity, surface.points, curve.points);
      write_mesh(os, cut.points, cut.triangles, *find_mesh_format(options.cut_path));
    });
    if (view) {
      view->path = curve.positions;
      write_view(options.view_path, *view);
    }
    write_stats(options.stats_path, curve);
    write_report(std::cout, curve);
    flush_standard_output();
    if (curve.status == name(IT::Geodesic_status::CONTRACTIBLE)) {
      std::cerr << "idt: " << path << ": the curve shrinks to vertex " << curve.vertex->idx()
                << ", so no closed curve is locally shortest, and files have no points: let it run around a handle, a "
                   "hole or a spike"
                << std::endl;
      return Exit_status::NOT_FINISHED;
    }
    return curve.is_geodesic && curve.status != "unfinished" && (!curve.distance || curve.is_shortest())
             ? Exit_status::DONE
             : Exit_status::NOT_FINISHED;
  });
}

} // namespace

void add_geodesic_command(CLI::App& app, Selected_command& selected)
{
  const auto options = std::make_shared<Geodesic_options>();
  CLI::App& command = *app.add_subcommand("geodesic", "Find straight lines on a surface");
  command.footer(
    "A path or a closed curve begins along edges, and flips shorten it until it is proven to be\n"
    "locally shortest. On triangles that are no oriented manifold, a path is the shortest of all. A "
    "line is followed over the faces, with exact decisions. Vertices are counted from\n"
    "zero. The exit status is 4 if a curve could not be made locally shortest, or shortest with --shortest, or\n"
    "shrinks to a point, or a line reached --maximum-faces.\n");
  command.add_option("INPUT", options->input, "as for `idt triangulate`")->required();
  add_option(command, "--from", options->from, "V|X,Y,Z",
             "the start: a vertex, or the point of the surface nearest to a point in space")
    ->required();
  add_option(command, "--to", options->to, "V|X,Y,Z", "the end of a path");
  add_option(command, "--to-curve", options->curve.curve_path, "F.csv",
             "instead, the end of the shortest path: the nearest point of a curve, given as --source-curve of `idt "
             "distance`");
  add_option(command, "--via", options->via, "V|X,Y,Z",
             "a vertex or point in between; can be repeated. A path keeps passing through it, a closed curve only "
             "begins there")
    ->expected(1)
    ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command.add_flag("--closed", options->is_closed, "a closed curve: from the last vertex back to the first");
  command.add_flag("--shortest", options->is_shortest,
                   "the shortest path of all, from stop to stop, and its exact length up to rounding");
  add_option(command, "--barrier", options->barriers.curve_path, "F.csv",
             "a curve that the path does not cross, as for `idt distance`");
  add_option(command, "--barrier-edges", options->barriers.edges_path, "F.csv",
             "edges that it does not cross: two vertices in each line");
  command.add_option("--direction", options->direction,
                     "a line instead, in this direction: an angle on the surface in radians, counterclockwise from the "
                     "neighbour with the smallest number, or from the border");
  command.add_option("--length", options->length, "the length of the line");
  need_one_of(
    add_option(command, "--maximum-faces", options->maximum_number_of_faces, "N", "end the line after N faces"),
    {"--direction"})
    ->transform(whole_number())
    ->capture_default_str();
  add_option(command, "-o,--output", options->output_path, "F.(obj|csv|ply|vtp)",
             "write the curve: as a polyline, or its points with input face and barycentric coordinates (CSV)");
  add_option(command, "--cut", options->cut_path, "F.(off|obj|ply|ts|vtp)",
             "write the surface, cut open along the curve");
  set_words(command.add_option("--format", options->format, "the format of -o - on the standard output"),
            {"csv", "obj", "ply", "vtp"})
    ->type_name("EXT")
    ->capture_default_str();
  add_option(command, "--stats", options->stats_path, "F.json", "write the report as a JSON object");
  add_view_option(command, options->view_path);
  add_repair_option(command, options->repair);
  command.callback([options, &selected] { selected = [options] { return run_geodesic(*options); }; });
}

} // namespace idt
