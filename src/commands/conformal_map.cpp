// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Definitions of conformal_map.h.

#include "commands/conformal_map.h"
#include "commands/commands.h"
#include "input/Surface.h"
#include "input/standard_input.h"
#include "input/vertex_values.h"
#include "number_types/make_triangulation.h"
#include "output/Output_file.h"
#include "output/Textured_mesh.h"
#include "output/write_json.h"
#include "system/Interruption.h"
#include "system/Progress.h"
#include "system/Stopwatch.h"
#include "system/text.h"
#include "view/View.h"

#include <CGAL/Intrinsic_triangulations/conformal_parameterization.h>
#include <CGAL/Intrinsic_triangulations/harmonic_parameterization.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace idt {
namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Json = nlohmann::ordered_json;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

// Of the vertices that a file names; none without a file.
std::vector<std::pair<IT::Vertex_index, double>> read_angles(const std::string& path, const Surface& surface)
{
  std::vector<std::pair<IT::Vertex_index, double>> result;
  if (path.empty())
    return result;
  for (const auto& [v, angle] : read_numbers_of_vertices(path, surface.connectivity.number_of_vertices()))
    result.emplace_back(IT::Vertex_index(v), angle);
  return result;
}

IT::Conformal_boundary boundary(const Parameterize_options& options)
{
  return options.boundary == "disk"     ? IT::Conformal_boundary::DISK
         : options.boundary == "angles" ? IT::Conformal_boundary::ANGLES
                                        : IT::Conformal_boundary::FREE;
}

std::array<double, 3> in_space(const IT::Conformal_map& map, const Surface& surface, std::uint32_t v)
{
  if (!map.places[v].halfedge.is_valid()) // without a face
    return surface.points[v];
  return IT::point_in_space(map.input, surface.points, map.places[v]);
}

using Numbers_of_images = std::map<IT::Conformal_map::Point, std::size_t>;

// Equal images have one number, so that viewers see where the map is continuous.
void add_images(const std::array<IT::Conformal_map::Point, 3>& corners, Textured_mesh& mesh, Numbers_of_images& numbers)
{
  std::vector<std::size_t>& uv = mesh.uv_of_faces.emplace_back();
  for (const IT::Conformal_map::Point& p : corners) {
    const auto [place, is_new] = numbers.insert({p, mesh.uv.size()});
    if (is_new)
      mesh.uv.push_back(p);
    uv.push_back(place->second);
  }
}

Textured_mesh mesh_of(const IT::Conformal_map& map, const Surface& surface)
{
  Textured_mesh mesh;
  mesh.is_exact = true;
  for (std::uint32_t v = 0; v < map.places.size(); ++v)
    mesh.points.push_back(in_space(map, surface, v));
  Numbers_of_images numbers;
  for (std::size_t i = 0; i < map.triangles.size(); ++i) {
    mesh.faces.emplace_back(map.triangles[i].begin(), map.triangles[i].end());
    add_images(map.uv[i], mesh, numbers);
  }
  return mesh;
}

Textured_mesh input_of(const IT::Conformal_map& map, const Surface& surface)
{
  Textured_mesh mesh = make_map_over_input(surface, {});
  mesh.is_exact = true;
  Numbers_of_images numbers;
  for (IT::Face_index f : map.input.faces()) {
    const IT::Halfedge_index h = map.input.halfedge(f);
    const auto image = [&](IT::Halfedge_index side) { return map.input_uv[side.idx()]; };
    add_images({image(h), image(map.input.next(h)), image(map.input.prev(h))}, mesh, numbers);
  }
  return mesh;
}

// The surface and its image, with the cuts and the cones.
View view_of(const Parameterize_options& options, const IT::Conformal_map& map, const Surface& surface)
{
  std::vector<std::array<double, 3>> points;
  for (std::uint32_t v = 0; v < map.places.size(); ++v)
    points.push_back(in_space(map, surface, v));
  View view = make_view(options.input, points, map.triangles);
  view.path_name = "the cuts";
  view.marks_name = "the cones";
  std::vector<bool> is_cone(points.size(), false);
  for (IT::Vertex_index v : map.metric.cones)
    is_cone[v.idx()] = true;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < map.triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& [x, y] = map.uv[i][k];
      view.plane.corners.push_back({x, y, 0});
      if (is_cone[map.triangles[i][k]]) {
        view.plane.marks.push_back({x, y, 0});
        view.marks.push_back(points[map.triangles[i][k]]);
      }
      if (!map.is_cut[i][k])
        continue;
      const std::size_t next = (k + 1) % 3;
      view.path.push_back({none, none, none});
      view.plane.path.push_back({none, none, none});
      for (std::size_t end : {k, next}) {
        view.path.push_back(points[map.triangles[i][end]]);
        view.plane.path.push_back({map.uv[i][end][0], map.uv[i][end][1], 0});
      }
    }
  return view;
}

struct Distortion
{
  std::vector<double> ratios, scales; // of lengths, and of areas, of each triangle
  IT::Distortion_summary ratio, scale;
};

Distortion distortion_of(const IT::Conformal_map& map)
{
  Distortion result;
  double size = 0;
  for (const auto& corners : map.uv)
    for (const auto& [x, y] : corners)
      size = (std::max)({size, std::abs(x), std::abs(y)});
  std::vector<double> areas; // on the surface, in proportion
  for (std::size_t i = 0; i < map.triangles.size(); ++i) {
    const auto& [most, least] = map.stretch[i];
    const auto& [p, q, r] = map.uv[i];
    result.ratios.push_back(most / least);
    result.scales.push_back(most * least);
    const double x = (q[0] - p[0]) / size, y = (q[1] - p[1]) / size;
    const double area = std::abs(x * ((r[1] - p[1]) / size) - y * ((r[0] - p[0]) / size)) / (most * least);
    areas.push_back(std::isfinite(area) ? area : 0);
  }
  result.ratio = IT::summarize_distortion(result.ratios, areas);
  result.scale = IT::summarize_distortion(result.scales, areas);
  return result;
}

void write_distortion(std::ostream& os, const IT::Conformal_map& map, const Distortion& distortion)
{
  const auto text = [](double x) { return std::isfinite(x) ? in_full(x) : std::string(); };
  os << "input_face,distortion,area_scale\n";
  for (std::size_t i = 0; i < map.triangles.size(); ++i)
    os << map.input_faces[i].idx() << ',' << text(distortion.ratios[i]) << ',' << text(distortion.scales[i]) << '\n';
}

// Of the lengths of edges, at the vertices.
std::array<double, 2> range_of_scale(const IT::Conformal_map& map)
{
  const auto [least, most] = std::minmax_element(map.metric.u.begin(), map.metric.u.end());
  return {std::exp(*least), std::exp(*most)};
}

Json statistics(const Parameterize_options& options, const IT::Conformal_map& map, const Distortion& distortion,
                const Surface& surface, double seconds)
{
  Json cones = Json::array(), turned = Json::array();
  for (std::size_t i = 0; i < map.metric.cones.size(); ++i)
    cones.push_back({{"vertex", map.metric.cones[i].idx()}, {"angle", map.metric.cone_angles[i]}});
  const std::array<double, 2> scale = range_of_scale(map);
  return {{"input", options.input},
          {"method", "conformal"},
          {"boundary", options.boundary},
          {"vertices", surface.connectivity.number_of_vertices()},
          {"faces", surface.connectivity.number_of_faces()},
          {"triangles", map.triangles.size()},
          {"steps", map.metric.steps},
          {"residual", map.metric.residual},
          {"turned", map.turned.size()},
          {"cones", cones},
          {"range_of_u", map.metric.range_of_u},
          {"smallest_scale", scale[0]},
          {"largest_scale", scale[1]},
          {"mean_distortion", distortion.ratio.mean},
          {"percentile_99_distortion", distortion.ratio.percentile_99},
          {"mean_area_scale", distortion.scale.mean},
          {"percentile_99_area_scale", distortion.scale.percentile_99},
          {"seam", map.seam},
          {"certified", map.is_certified},
          {"overlaps", map.overlaps},
          {"turned_input", map.turned_input.size()},
          {"divided_input", map.divided_input.size()},
          {"repair", to_json_value(repairs(surface))},
          {"warnings", surface.warnings},
          {"seconds", seconds}};
}

void write_report(std::ostream& os, const Parameterize_options& options, const IT::Conformal_map& map,
                  const Distortion& distortion, double seconds)
{
  const std::array<double, 2> scale = range_of_scale(map);
  os << options.input << "\n  map               conformal, boundary " << options.boundary << "\n  cones             "
     << with_separators(map.metric.cones.size()) << "\n  angles            within " << in_short(map.metric.residual)
     << " of the wanted sums, proven\n  lengths           between " << in_short(scale[0]) << " and "
     << in_short(scale[1]) << " times those of the surface\n  distortion        " << in_short(distortion.ratio.mean)
     << " in the mean, " << in_short(distortion.ratio.percentile_99) << " at 99 % of the area; areas "
     << in_short(distortion.scale.mean) << " times those of the surface in the mean, "
     << in_short(distortion.scale.percentile_99) << " at 99 %\n  triangles         "
     << with_separators(map.triangles.size()) << ", of which " << with_separators(map.turned.size())
     << " turned over\n  input triangles   " << with_separators(map.turned_input.size())
     << " would turn over if the map were linear on them; " << with_separators(map.divided_input.size())
     << " are cut, and follow one side\n  locally injective "
     << (!map.is_certified    ? "no"
         : map.turned.empty() ? "yes, proven"
                              : "on the ideal Delaunay triangles only, proven")
     << "\n  overlaps itself   " << (map.overlaps ? "yes: cut it into parts, or try other cones" : "no")
     << "\n  seams             within " << in_short(map.seam) << "\n  time              " << seconds_text(seconds)
     << '\n';
}

void check(const Parameterize_options& options)
{
  if (options.cones && !options.cone_angles.empty())
    throw Usage_error("--cones and --cone-angles: cones are either chosen or given; omit one of them");
  if (options.boundary != "angles" && !options.boundary_angles.empty())
    throw Usage_error("--boundary-angles: the boundary is " + options.boundary + "; omit one of them");
  if (options.boundary == "natural")
    throw Usage_error("--boundary natural: a conformal map has the boundary free, angles or disk");
}

} // namespace

Exit_status run_conformal_map(const Parameterize_options& options)
{
  check(options);
  return for_each_input({options.input}, [&](const std::string& path) {
    const Surface surface = load_surface(path, options.repair);
    if (!(options.uv.empty() && options.uv_input.empty() && options.view.empty()) && !surface.has_points())
      throw Usage_error(path + " has only lengths, no points: omit --uv, --uv-input and --view");
    const Stopwatch stopwatch;
    Triangulation triangulation =
      surface.saved ? surface.saved->triangulation : make_triangulation<IT::Filtered_edge_length_traits>(surface);
    triangulation.set_interruption([] { return !is_interrupted(); });
    Progress progress(path, "solving");
    const IT::Conformal_map map = IT::conformal_parameterization(
      triangulation, CGAL::parameters::cone_angles(read_angles(options.cone_angles, surface))
                       .boundary_angles(read_angles(options.boundary_angles, surface))
                       .conformal_boundary(boundary(options))
                       .number_of_cones(options.cones)
                       .visitor(std::ref(progress)));
    const double seconds = stopwatch.seconds();
    if (!map.turned.empty())
      std::cerr << "idt: " << path << ": " << counted(map.turned.size(), "triangle", "triangles")
                << " of the map turned over, first in face " << map.input_faces[map.turned.front()].idx()
                << ", as they are thinner than the spacing of doubles there: "
                << (surface.has_points() ? "map the surface that idt refine --maximum-deviation 0.1% --flatten F writes"
                                         : "try other cones, or idt refine first if the surface is closed")
                << std::endl;
    if (!options.uv.empty())
      write_textured_mesh(options.uv, mesh_of(map, surface));
    if (!options.uv_input.empty())
      write_textured_mesh(options.uv_input, input_of(map, surface));
    const Distortion distortion = distortion_of(map);
    write_file(options.distortion, [&](std::ostream& os) { write_distortion(os, map, distortion); });
    if (!options.view.empty())
      write_view(options.view, view_of(options, map, surface));
    write_json(options.stats, statistics(options, map, distortion, surface, seconds));
    write_report(std::cout, options, map, distortion, seconds);
    flush_standard_output();
    return Exit_status::DONE;
  });
}

} // namespace idt
