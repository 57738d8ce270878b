// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The triangles of one polygon in space.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_TRIANGULATE_POLYGON_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_TRIANGULATE_POLYGON_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/utility.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// Returns the corners of the triangles by their positions in the polygon, in its orientation;
// always as many as the polygon has corners, less two.
inline std::vector<std::array<std::size_t, 3>>
triangulate_polygon(const std::vector<std::array<double, 3>>& polygon)
{
  typedef Exact_predicates_inexact_constructions_kernel::Point_3 Point;
  // Moved and scaled to the size of 1, lest squares and products overflow. Quartered before, for
  // the difference of two coordinates can overflow as well.
  std::vector<std::array<double, 3>> places = polygon;
  double size = 0;
  for (std::array<double, 3>& p : places)
    for (int i = 0; i < 3; ++i) {
      p[i] = p[i] / 4 - polygon[0][i] / 4;
      size = (std::max)(size, std::abs(p[i]));
    }
  const int exponent = size > 0 ? std::ilogb(size) : 0;
  std::vector<Point> points;
  for (const std::array<double, 3>& p : places)
    points.emplace_back(std::ldexp(p[0], -exponent), std::ldexp(p[1], -exponent),
                        std::ldexp(p[2], -exponent));

  // Where the polygon is not nearly planar, memory is quadratic and time cubic: with a thousand
  // corners half a minute.
  const bool is_small = polygon.size() <= 200;
  std::vector<Triple<int, int, int>> triples;
  if (size > 0)
    Polygon_mesh_processing::triangulate_hole_polyline(points, std::back_inserter(triples),
                                                       parameters::use_2d_constrained_delaunay_triangulation(true)
                                                         .use_delaunay_triangulation(is_small)
                                                         .do_not_use_cubic_algorithm(!is_small));
  std::vector<std::array<std::size_t, 3>> triangles;
  for (const Triple<int, int, int>& t : triples)
    triangles.push_back({std::size_t(t.first), std::size_t(t.second), std::size_t(t.third)});
  // A polygon that is all but a line, or a large one in space: a fan is as good as anything.
  if (triangles.size() != polygon.size() - 2) {
    triangles.clear();
    for (std::size_t i = 2; i < polygon.size(); ++i)
      triangles.push_back({0, i - 1, i});
  }
  return triangles;
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_TRIANGULATE_POLYGON_H
