// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What `idt geodesic` finds, and its files.

#include "commands/geodesic_result.h"

#include "input/formats/vtp.h"
#include "input/repair.h"
#include "output/Output_file.h"
#include "output/write_json.h"
#include "system/text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <iomanip>
#include <utility>

namespace idt {
namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Points = std::vector<std::array<double, 3>>;

void write_coordinates(std::ostream& os, const std::array<double, 3>& p, char separator)
{
  os << in_full(p[0]) << separator << in_full(p[1]) << separator << in_full(p[2]);
}

void write_obj(std::ostream& os, const Points& points)
{
  for (const auto& p : points) {
    os << "v ";
    write_coordinates(os, p, ' ');
    os << '\n';
  }
  if (points.size() < 2)
    return;
  os << 'l';
  for (std::size_t i = 1; i <= points.size(); ++i)
    os << ' ' << i;
  os << '\n';
}

void write_ply(std::ostream& os, const Points& points)
{
  const std::size_t edges = points.empty() ? 0 : points.size() - 1;
  os << "ply\nformat ascii 1.0\nelement vertex " << points.size()
     << "\nproperty double x\nproperty double y\nproperty double z\nelement edge " << edges
     << "\nproperty int vertex1\nproperty int vertex2\nend_header\n";
  for (const auto& p : points) {
    write_coordinates(os, p, ' ');
    os << '\n';
  }
  for (std::size_t i = 0; i < edges; ++i)
    os << i << ' ' << i + 1 << '\n';
}

void write_vtp(std::ostream& os, const std::vector<Point_in_face>& line, const Points& points)
{
  Named_values faces{"input_face", {}, 1, "Int32"};
  Flat_polygons lines;
  for (const Point_in_face& p : line) {
    lines.corners.push_back(std::uint32_t(faces.values.size()));
    faces.values.push_back(double(p.face));
  }
  if (points.size() > 1)
    lines.ends.push_back(points.size());
  write_vtp(os, points, Flat_polygons(), {faces}, lines);
}

void write_csv(std::ostream& os, const std::vector<Point_in_face>& line, const Points& points)
{
  os << "face,vertex_0,vertex_1,vertex_2,coordinate_0,coordinate_1,coordinate_2"
     << (points.empty() ? "\n" : ",x,y,z\n");
  for (std::size_t i = 0; i < line.size(); ++i) {
    const auto& [face, vertices, coordinates] = line[i];
    os << face << ',' << vertices[0] << ',' << vertices[1] << ',' << vertices[2] << ',';
    write_coordinates(os, coordinates, ',');
    if (!points.empty()) {
      os << ',';
      write_coordinates(os, points[i], ',');
    }
    os << '\n';
  }
}

} // namespace

std::vector<Point_in_face> points_in_faces(const IT::Delta_complex& input, const std::vector<IT::Surface_point>& points)
{
  std::vector<Point_in_face> result;
  for (const auto& [h, coordinates] : points)
    result.push_back({input.face(h).idx(),
                      {input.source(h).idx(), input.target(h).idx(), input.target(input.next(h)).idx()},
                      coordinates});
  return result;
}

std::vector<Point_in_face> points_in_faces(const Triangle_soup& soup, const IT::Path_on_triangles& path)
{
  std::vector<Point_in_face> result;
  for (const auto& [f, coordinates] : path.points)
    result.push_back({f, {soup.triangles[f][0], soup.triangles[f][1], soup.triangles[f][2]}, coordinates});
  return result;
}

void write_line(const std::string& path, const std::string& type, const Geodesic_result& result)
{
  write_file(path, [&](std::ostream& os) {
    if (type == ".obj")
      write_obj(os, result.positions);
    else if (type == ".ply")
      write_ply(os, result.positions);
    else if (type == ".vtp")
      write_vtp(os, result.line, result.positions);
    else
      write_csv(os, result.line, result.positions);
  });
}

void write_stats(const std::string& path, const Geodesic_result& result)
{
  nlohmann::ordered_json json;
  json["input"] = result.input;
  json["status"] = result.status;
  json["is_geodesic"] = result.is_geodesic;
  json["length"] = result.length;
  json["initial_length"] = result.initial_length;
  if (result.distance) {
    json["distance"] = *result.distance;
    json["is_shortest"] = result.is_shortest();
  }
  json["flips"] = result.flips;
  json["segments"] = result.number_of_segments();
  json["is_on_any_triangles"] = result.is_on_any_triangles;
  json["vertex"] = result.vertex ? nlohmann::ordered_json(result.vertex->idx()) : nlohmann::ordered_json(nullptr);
  json["snaps"] = nlohmann::ordered_json::array();
  for (const Snap& snap : result.snaps)
    json["snaps"].push_back({{"option", snap.option}, {"distance", snap.distance}});
  json["repair"] = to_json_value(result.repairs);
  json["warnings"] = result.warnings;
  json["seconds"] = result.seconds;
  write_json(path, json);
}

void write_report(std::ostream& os, const Geodesic_result& result)
{
  os << result.input << "\n  status    " << result.status;
  if (result.vertex)
    os << ", vertex " << result.vertex->idx();
  if (!result.is_geodesic)
    os << "; not locally shortest";
  else if (result.initial_length && !result.is_closed)
    os << ", locally shortest; use --shortest for the shortest";
  os << "\n  length    " << in_full(result.length);
  if (result.initial_length)
    os << " (along edges: " << in_short(*result.initial_length) << ')';
  if (result.distance)
    os << "\n  distance  " << in_full(*result.distance)
       << (result.is_shortest() ? "; the path is shortest" : "; the path is not shortest") << cuts_text(result.repairs);
  for (const Snap& snap : result.snaps)
    os << "\n  " << std::left << std::setw(10) << snap.option << "the nearest point of the surface, "
       << in_short(snap.distance) << " from the given one";
  if (result.is_on_any_triangles)
    os << "\n  triangles taken as they are: the path goes from each face at an edge into all others";
  os << "\n  segments  " << with_separators(result.number_of_segments()) << "\n  flips     "
     << with_separators(result.flips) << "\n  time      " << seconds_text(result.seconds) << '\n';
}

} // namespace idt
