// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/mesh_file.h"

#include "input/formats/vtp.h"
#include "system/Long_text.h"
#include "system/text.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cctype>
#include <utility>

namespace idt {
namespace {

const std::pair<Mesh_format, const char*> formats[] = {{Mesh_format::PLY, ".ply"}, {Mesh_format::OFF, ".off"},
                                                       {Mesh_format::OBJ, ".obj"}, {Mesh_format::VTP, ".vtp"},
                                                       {Mesh_format::STL, ".stl"}, {Mesh_format::TS, ".ts"}};

// The lowest bytes first on any machine: CGAL's writer uses the order of the machine, whatever the header says.
void write_ply(std::ostream& os, const std::vector<std::array<double, 3>>& points,
               const std::vector<std::array<std::uint32_t, 3>>& triangles, const std::vector<Named_values>& at_points)
{
  os << "ply\nformat binary_little_endian 1.0\nelement vertex " << points.size()
     << "\nproperty double x\nproperty double y\nproperty double z\n";
  for (const std::string& name : coordinate_names(at_points))
    os << "property double " << name << '\n';
  os << "element face " << triangles.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
  write_elements(os, points.size(), [&](Long_text& text, std::size_t v) {
    for (double x : points[v])
      text.add_bytes(x);
    for_each_coordinate(at_points, v, [&text](double x) { text.add_bytes(x); });
  });
  write_elements(os, triangles.size(), [&triangles](Long_text& text, std::size_t f) {
    text.add_bytes(std::uint8_t(3));
    for (std::uint32_t v : triangles[f])
      text.add_bytes(v);
  });
}

} // namespace

std::optional<Mesh_format> find_mesh_format(const std::string& path)
{
  const std::string name = path.substr(path.find_last_of('/') + 1);
  std::string extension = name.substr((std::min)(name.rfind('.'), name.size()));
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const auto& [format, of_format] : formats)
    if (extension == of_format)
      return format;
  return std::nullopt;
}

bool holds_polygons(Mesh_format format) { return format != Mesh_format::STL && format != Mesh_format::TS; }

std::string mesh_extensions(bool are_polygons)
{
  std::vector<std::string> names;
  for (const auto& [format, extension] : formats)
    if (holds_polygons(format) || !are_polygons)
      names.push_back(extension);
  std::string text = names.front();
  for (std::size_t i = 1; i < names.size(); ++i)
    text += (i + 1 < names.size() ? ", " : " or ") + names[i];
  return text;
}

std::vector<std::string> coordinate_names(const std::vector<Named_values>& arrays)
{
  std::vector<std::string> result;
  for (const Named_values& array : arrays)
    for (std::size_t c = 0; c < array.components; ++c)
      result.push_back(array.components == 1 ? array.name : array.name + '_' + "xyz"[c]);
  return result;
}

void write_mesh(std::ostream& os, const std::vector<std::array<double, 3>>& points,
                const std::vector<std::array<std::uint32_t, 3>>& triangles, Mesh_format format,
                const std::vector<Named_values>& at_points)
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  const auto places = [&points] {
    std::vector<Point> result;
    result.reserve(points.size());
    for (const auto& [x, y, z] : points)
      result.emplace_back(x, y, z);
    return result;
  };
  const auto faces = [&triangles] {
    std::vector<std::vector<std::size_t>> result;
    result.reserve(triangles.size());
    for (const auto& [a, b, c] : triangles)
      result.push_back({a, b, c});
    return result;
  };
  const auto all_digits = CGAL::parameters::stream_precision(17);
  switch (format) {
  case Mesh_format::PLY:
    write_ply(os, points, triangles, at_points);
    return;
  case Mesh_format::OFF:
    CGAL::IO::write_OFF(os, places(), faces(), all_digits);
    return;
  case Mesh_format::OBJ:
    CGAL::IO::write_OBJ(os, places(), faces(), all_digits);
    return;
  case Mesh_format::STL:
    // A reader has to compute a normal of zero itself. CGAL's writer writes NaN for small faces.
    os << "solid\n";
    for (const auto& triangle : triangles) {
      os << "facet normal 0 0 0\nouter loop\n";
      for (std::uint32_t v : triangle)
        os << "vertex " << in_full(points[v][0]) << ' ' << in_full(points[v][1]) << ' ' << in_full(points[v][2])
           << '\n';
      os << "endloop\nendfacet\n";
    }
    os << "endsolid\n";
    return;
  case Mesh_format::TS:
    CGAL::IO::write_GOCAD(os, places(), faces(), all_digits);
    return;
  case Mesh_format::VTP:
    Flat_polygons polygons;
    for (const auto& triangle : triangles)
      polygons.add(triangle);
    write_vtp(os, points, polygons, at_points);
    return;
  }
}

} // namespace idt
