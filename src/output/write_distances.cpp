// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/write_distances.h"

#include "system/Long_text.h"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace idt {
namespace {

// The name of each coordinate, vertex values one after the other.
std::vector<std::string> column_names(const Surface_with_distances& surface)
{
  std::vector<std::string> result;
  for (const Point_values& at : surface.vectors)
    for (std::size_t c = 0; c < at.components; ++c)
      result.push_back(at.name + '_' + "xyz"[c]);
  return result;
}

// Calls `visit(x)` for each coordinate at a vertex, in the order of their names.
template <class Visit>
void for_each_coordinate(const Surface_with_distances& surface, std::size_t v, const Visit& visit)
{
  for (const Point_values& at : surface.vectors)
    for (std::size_t c = 0; c < at.components; ++c)
      visit(at.values[v * at.components + c]);
}

} // namespace

void write_distances_csv(std::ostream& os, const Surface_with_distances& surface)
{
  os << "vertex,distance";
  for (const std::string& name : column_names(surface))
    os << ',' << name;
  os << '\n';
  write_elements(os, surface.number_of_vertices, [&surface](Long_text& text, std::size_t v) {
    text << v << ',' << surface.distances[v];
    for_each_coordinate(surface, v, [&text](double x) { text << ',' << x; });
    text << '\n';
  });
}

void write_distances_ply(std::ostream& os, const Surface_with_distances& surface)
{
  os << "ply\nformat binary_little_endian 1.0\nelement vertex " << surface.number_of_vertices
     << "\nproperty double x\nproperty double y\nproperty double z\nproperty double distance\n";
  for (const std::string& name : column_names(surface))
    os << "property double " << name << '\n';
  os << "element face " << surface.triangles.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
  write_elements(os, surface.number_of_vertices, [&surface](Long_text& text, std::size_t v) {
    for (double x : surface.points[v])
      text.add_bytes(x);
    text.add_bytes(surface.distances[v]);
    for_each_coordinate(surface, v, [&text](double x) { text.add_bytes(x); });
  });
  write_elements(os, surface.triangles.size(), [&surface](Long_text& text, std::size_t f) {
    text.add_bytes(std::uint8_t(3));
    for (std::uint32_t v : surface.triangles[f])
      text.add_bytes(v);
  });
}

void write_distances_vtp(std::ostream& os, const Surface_with_distances& surface)
{
  std::vector<Point_values> finite{{"distance", surface.distances}};
  finite.insert(finite.end(), surface.vectors.begin(), surface.vectors.end());
  for (Point_values& at : finite)
    for (double& x : at.values)
      x = (std::min)(x, (std::numeric_limits<double>::max)());
  Flat_polygons polygons;
  for (const auto& triangle : surface.triangles) {
    polygons.corners.insert(polygons.corners.end(), triangle.begin(), triangle.end());
    polygons.ends.push_back(polygons.corners.size());
  }
  write_vtp(os, surface.points, polygons, finite);
}

} // namespace idt
