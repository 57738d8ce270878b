// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/write_distances.h"

#include "input/formats/vtp.h"
#include "system/Long_text.h"

#include <string>
#include <vector>

namespace idt {
namespace {

std::vector<Named_values> all_values(const Surface_with_distances& surface)
{
  std::vector<Named_values> result{{"distance", surface.distances}};
  result.insert(result.end(), surface.vectors.begin(), surface.vectors.end());
  return result;
}

} // namespace

void write_distances_csv(std::ostream& os, const Surface_with_distances& surface)
{
  const std::vector<Named_values> values = all_values(surface);
  os << "vertex";
  for (const std::string& name : coordinate_names(values))
    os << ',' << name;
  os << '\n';
  write_elements(os, surface.number_of_vertices, [&values](Long_text& text, std::size_t v) {
    text << v;
    for_each_coordinate(values, v, [&text](double x) { text << ',' << x; });
    text << '\n';
  });
}

void write_distances_ply(std::ostream& os, const Surface_with_distances& surface)
{
  write_ply(os, surface.points, surface.triangles, all_values(surface));
}

void write_distances_vtp(std::ostream& os, const Surface_with_distances& surface)
{
  Flat_polygons polygons;
  for (const auto& triangle : surface.triangles) {
    polygons.corners.insert(polygons.corners.end(), triangle.begin(), triangle.end());
    polygons.ends.push_back(polygons.corners.size());
  }
  write_vtp(os, surface.points, polygons, finite(all_values(surface)));
}

} // namespace idt
