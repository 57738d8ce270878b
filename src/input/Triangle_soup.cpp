// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/Triangle_soup.h"

#include "input/read_surface.h"

#include <CGAL/Intrinsic_triangulations/repair_polygons.h>

#include <algorithm>
#include <utility>

namespace idt {
namespace {

// The reader has checked the file name, the face and the index.
void add_polygon(const Surface_input& input, std::size_t face, Triangle_soup& soup)
{
  const Surface_input::Polygon polygon = input.polygon(face);
  if (polygon.size() < 3) {
    ++soup.small_faces;
    return;
  }
  if (polygon.size() == 3) {
    soup.triangles.push_back({polygon.first[0], polygon.first[1], polygon.first[2]});
    return;
  }
  ++soup.triangulated_faces;
  std::vector<std::array<double, 3>> places;
  for (std::uint32_t v : polygon)
    places.push_back(input.points[v]);
  for (const auto& [i, j, k] : CGAL::Intrinsic_triangulations::triangulate_polygon(places))
    soup.triangles.push_back({polygon.first[i], polygon.first[j], polygon.first[k]});
}

} // namespace

Triangle_soup read_triangle_soup(const std::string& path)
{
  Surface_input input = read_and_warn(path);
  Triangle_soup soup;
  soup.number_of_faces = input.number_of_faces();
  if (input.is_triangulated()) {
    soup.triangles = std::move(input.triangles);
  } else {
    for (std::size_t f = 0; f < soup.number_of_faces; ++f)
      add_polygon(input, f, soup);
  }
  soup.points = std::move(input.points);
  soup.warnings = std::move(input.warnings);
  return soup;
}

} // namespace idt
