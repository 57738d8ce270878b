// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/Triangle_soup.h"

#include "input/Surface.h"
#include "input/read_surface.h"
#include "system/text.h"

#include <CGAL/Intrinsic_triangulations/repair_polygons.h>

#include <iostream>
#include <utility>

namespace idt {
namespace {

namespace IT = CGAL::Intrinsic_triangulations;

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
  for (const std::uint32_t v : polygon)
    if (v >= input.points.size())
      throw IT::Invalid_surface_error(IT::Invalid_surface_error::Defect::BAD_INDEX, face, 1,
                                      "face " + std::to_string(face) + " names vertex " + std::to_string(v) +
                                        ", but there are " + std::to_string(input.points.size()) + " vertices");
  ++soup.triangulated_faces;
  const IT::Polygon_triangles parts = IT::triangulate_polygon(input.points, {polygon.first, polygon.last}, face);
  for (const auto& [a, b, c] : parts.triangles)
    soup.triangles.push_back({std::uint32_t(a), std::uint32_t(b), std::uint32_t(c)});
  if (parts.triangles.empty())
    ++soup.small_faces;
  if (!parts.warning.empty())
    soup.warnings.push_back(parts.warning);
}

void add_polygons(const Surface_input& input, Triangle_soup& soup)
{
  try {
    for (std::size_t f = 0; f < soup.number_of_faces; ++f)
      add_polygon(input, f, soup);
  } catch (const IT::Invalid_surface_error& error) {
    throw IT::Invalid_surface_error(error.defect(), error.element(), error.count(), input.path + ": " + error.what());
  }
  for (const std::string& warning : soup.warnings)
    std::cerr << "idt: " << input.path << ": warning: " << warning << std::endl;
}

} // namespace

Triangle_soup read_triangle_soup(const std::string& path) { return to_triangle_soup(read_and_warn(path)); }

Triangle_soup to_triangle_soup(Surface_input input)
{
  Triangle_soup soup;
  soup.number_of_faces = input.number_of_faces();
  if (input.is_triangulated()) {
    soup.triangles = std::move(input.triangles);
  } else {
    add_polygons(input, soup);
  }
  soup.points = std::move(input.points);
  soup.warnings.insert(soup.warnings.begin(), input.warnings.begin(), input.warnings.end());
  const IT::Surface_report gaps = IT::find_gaps(soup.points, soup.triangles);
  for (std::string& warning : gap_warnings(gaps, input.path,
                                           "--repair --stitch " + in_short(gaps.stitching_tolerance) +
                                             " --save joined.idt of triangulate joins them: read joined.idt instead"))
    soup.warnings.push_back(std::move(warning));
  return soup;
}

} // namespace idt
