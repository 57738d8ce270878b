// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/write_distances.h"

#include "system/text.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace idt {
namespace {

// The lowest byte first, whatever this machine does.
template <class Integer>
void write_bytes(std::ostream& os, Integer bits)
{
  for (std::size_t b = 0; b < sizeof(Integer); ++b)
    os.put(static_cast<char>(bits >> 8 * b & 0xff));
}

void write_double(std::ostream& os, double x)
{
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  write_bytes(os, bits);
}

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
  for (std::size_t v = 0; v < surface.number_of_vertices; ++v) {
    os << v << ',' << in_full(surface.distances[v]);
    for_each_coordinate(surface, v, [&os](double x) { os << ',' << in_full(x); });
    os << '\n';
  }
}

void write_distances_ply(std::ostream& os, const Surface_with_distances& surface)
{
  os << "ply\nformat binary_little_endian 1.0\nelement vertex " << surface.number_of_vertices
     << "\nproperty double x\nproperty double y\nproperty double z\nproperty double distance\n";
  for (const std::string& name : column_names(surface))
    os << "property double " << name << '\n';
  os << "element face " << surface.triangles.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (std::size_t v = 0; v < surface.number_of_vertices; ++v) {
    for (double x : surface.points[v])
      write_double(os, x);
    write_double(os, surface.distances[v]);
    for_each_coordinate(surface, v, [&os](double x) { write_double(os, x); });
  }
  for (const auto& triangle : surface.triangles) {
    os.put(3);
    for (std::uint32_t v : triangle)
      write_bytes(os, v);
  }
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
