// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/distance_options.h"

#include "commands/command_line.h"
#include "commands/commands.h"
#include "output/Output_file.h"
#include "view/View.h"

#include <cmath>

namespace idt {
namespace {

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
      !options.samples_path.empty() || options.lines.are_wanted() || !options.view_path.empty())
    throw Usage_error("--matrix finds distances of the targets only: omit -o, --overlay, --labels, --farthest, lines "
                      "and --view");
  const std::string type = extension_with_format(options.matrix_path, options.format);
  if (type != ".csv" && type != ".mtx")
    throw Usage_error(options.matrix_path + ": a matrix is written as a file whose name ends in .csv or .mtx");
}

void check(const Distance_options& options)
{
  if (options.sources.vertices.empty() && !options.sources.has_files())
    throw Usage_error("--source is required, or --source-vertices, --source-points, --source-edges or --source-curve");
  if (options.is_by_heat() &&
      (!options.labels_path.empty() || !options.samples_path.empty() || options.lines.are_wanted()))
    throw Usage_error(
      "--labels, --farthest and lines follow straight ways, which heat does not: omit --method heat and "
      "its options");
  if (options.maximum_change && options.has_places())
    throw Usage_error("--maximum-change finds distances between vertices: omit --source-points, --source-edges, "
                      "--source-curve, --labels, --farthest and lines");
  if (options.has_barriers() && !options.samples_path.empty())
    throw Usage_error("--farthest chooses vertices, and one on a barrier has a distance on each of its sides: omit "
                      "--barrier, --barrier-edges or --farthest");
  if (options.is_signed && (options.sources.curve_path.empty() || !options.sources.vertices.empty() ||
                            !options.sources.points_path.empty() || !options.sources.edges_path.empty()))
    throw Usage_error("--signed needs --source-curve, and no other source");
  if (options.is_signed && options.is_refined)
    throw Usage_error("--signed gives signs to the vertices of the input: omit --refine");
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
    throw Usage_error(
      "--maximum-change: C has to be a number that is not negative, a part of each distance: 0.05 is 5 %");
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
                      options.sources.curve_path, options.source_vertices_path, options.target_vertices_path,
                      options.barriers.curve_path, options.barriers.edges_path});
  check_view(options.view_path);
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

} // namespace

std::optional<Mesh_format> Distance_options::overlay_format() const
{
  return find_mesh_format(name_with_format(overlay_path, format == "csv" ? "ply" : format));
}

void Distance_options::complete()
{
  const bool needs_surface = maximum_change || lines.are_wanted() || has_barriers() || is_signed;
  if (cover == "tufted" && needs_surface)
    throw Usage_error("--maximum-change, lines, barriers and --signed need --cover none: the tufted cover is not a "
                      "triangulation of the input");
  if (cover.empty())
    cover = needs_surface ? "none" : "tufted";
  read_vertex_files(*this);
  check(*this);
}

void Distance_options::add_options(CLI::App& command)
{
  command.add_option("INPUT", input, "a mesh, or a .gluing file of triangles with lengths; - is the standard input")
    ->required();
  add_option(command, "--source", sources.vertices, "V[,V...]", "the vertices with distance zero")
    ->delimiter(',')
    ->allow_extra_args(false)
    ->transform(whole_number());
  add_option(command, "--source-vertices", source_vertices_path, "F.csv",
             "more vertices with distance zero, one in each line");
  add_option(command, "--source-points", sources.points_path, "F.csv",
             "points with distance zero: a table that begins with input_face,b0,b1,b2 (barycentric coordinates), or "
             "with x,y,z, of which the nearest points of the surface are taken");
  add_option(command, "--source-edges", sources.edges_path, "F.csv",
             "edges with distance zero: two vertices in each line");
  add_option(command, "--source-curve", sources.curve_path, "F.csv",
             "a curve with distance zero, as `idt geodesic` writes it, or through points as for --source-points, along "
             "shortest paths");
  add_option(
    command, "--barrier", barriers.curve_path, "F.csv",
    "a curve that no path crosses, given as --source-curve; paths turn around its ends, and a vertex on it has "
    "the smaller distance of its sides; implies --cover none");
  add_option(command, "--barrier-edges", barriers.edges_path, "F.csv",
             "edges that no path crosses: two vertices in each line");
  add_option(command, "-o,--output", output_path, "F.(csv|ply|vtp)",
             "write the distances: as a table, or as the mesh with a value at each vertex");
  add_option(command, "--overlay", overlay_path, "F.(ply|vtp)",
             "write the overlay of input and triangulation, as `idt triangulate` does, with the distance at each of "
             "its vertices");
  command.add_flag("--signed", is_signed,
                   "distances to the right of the curves are negative; they have to be closed, or to lead from border "
                   "to border, and to cut something off together; implies --cover none");
  add_option(
    command, "--labels", labels_path, "F.csv",
    "write the nearest source of each vertex: first those of --source, then each point, all edges, each curve");
  add_option(
    command, "--matrix", matrix_path, "F.(csv|mtx)",
    "write a row of distances for each vertex of --source, and a column for each one of --target, found on all "
    "cores; other distances are not found");
  add_option(command, "--target", targets, "V[,V...]", "the vertices of the columns of --matrix")
    ->delimiter(',')
    ->allow_extra_args(false)
    ->transform(whole_number());
  add_option(command, "--target-vertices", target_vertices_path, "F.csv", "more of them, one in each line");
  lines.add_options(command);
  add_option(command, "--farthest", number_of_samples, "N",
             "choose N vertices, each as far as possible from the sources and from those before")
    ->transform(whole_number());
  add_option(command, "--samples", samples_path, "F.csv",
             "write the vertices of --farthest in their order, with their distances");
  set_words(command.add_option("--format", format, "the format of -o - and the like on the standard output"),
            {"csv", "ply", "vtp", "mtx"})
    ->type_name("EXT")
    ->capture_default_str();
  set_words(command.add_option("--cover", cover,
                               "tufted: any triangles, with heat on a closed surface over them; none: triangles that "
                               "form an oriented surface"),
            {"tufted", "none"})
    ->default_str("tufted");
  set_words(command.add_option(
              "--method", method,
              "approximate: follow straight ways over the faces, nearly equal ones together; exact: follow each of "
              "them; heat: the heat method. The default is approximate, or heat with --boundary or --time"),
            {"approximate", "exact", "heat"});
  add_option(
    command, "--maximum-change", maximum_change, "C",
    "follow all ways on a simplified surface, as of `idt simplify`, where distances change by at most this part (0.05 "
    "is 5 %), and also write proven bounds of each distance: lower and upper; implies --cover none");
  command.add_flag("--compare-exact", is_compared,
                   "report the mean and the largest error compared with the exact distances");
  set_words(
    command.add_option(
      "--boundary", boundary,
      "heat at the border: neumann, none leaves (default); dirichlet, the border is cold; average, the mean of both"),
    {"neumann", "dirichlet", "average"});
  command.add_flag("--refine", is_refined, "first insert vertices until no angle is below 25 degrees");
  add_option(command, "--time", time_coefficient, "T",
             "how long heat spreads, in units of the squared mean edge length: larger is smoother; 1 by default");
  command.add_flag("--vectors", has_vectors,
                   "also write the first axis of the source, parallel-transported to each vertex, and for one source "
                   "its logarithmic map");
  add_view_option(command, view_path);
  add_repair_option(command, repair);
  add_option(command, "--stats", stats_path, "F.json", "write the report as a JSON object");
}

} // namespace idt
