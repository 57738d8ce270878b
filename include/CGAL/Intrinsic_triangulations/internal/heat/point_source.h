// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A source inside a face, as its corners see it.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_POINT_SOURCE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_POINT_SOURCE_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/numbers/Accurate_shapes.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

struct Source_corner
{
  Vertex_index vertex;
  double coordinate;
  double distance; // from the point, in the plane of the face and in the unit of the input
};

template <class Traits>
std::array<Source_corner, 3> corners_of_point(const Intrinsic_triangulation<Traits>& triangulation,
                                              const Surface_point& point)
{
  const Delta_complex& complex = triangulation.connectivity();
  const Halfedge_index h = point.halfedge;
  double sum = 0;
  bool is_valid = h.is_valid() && h.idx() < complex.number_of_halfedges() && !complex.is_border(h);
  for (double x : point.coordinates) {
    is_valid = is_valid && x >= 0 && std::isfinite(x);
    sum += x;
  }
  if (!is_valid || !(sum > 0 && std::isfinite(sum)))
    throw Invalid_point_error("a source is not a point of a face: its halfedge needs a face, and its coordinates have "
                              "to be positive or zero, and not all zero");
  const Accurate_shapes<Traits> shapes(triangulation);
  const std::array<Halfedge_index, 3> sides{h, complex.next(h), complex.prev(h)};
  std::array<double, 3> x, length; // of the side from corner i on
  for (int i = 0; i < 3; ++i) {
    x[i] = point.coordinates[i] / sum;
    length[i] = std::ldexp(shapes.length(complex.edge(sides[i])), shapes.exponent());
  }
  std::array<Source_corner, 3> result;
  for (int i = 0; i < 3; ++i) {
    // The vector from the corner is y v + z w for the sides v and w that start there.
    const double y = x[(i + 1) % 3], z = x[(i + 2) % 3], v = length[i], w = length[(i + 2) % 3],
                 opposite = length[(i + 1) % 3];
    result[i] = {complex.source(sides[i]), x[i], 0};
    const double largest = (std::max)({v, w, opposite});
    // |y v + z w|² = (y + z) (y v² + z w²) - y z (v - w)²
    const auto square = [largest](double l) { return l / largest * (l / largest); };
    result[i].distance =
      largest * std::sqrt((std::max)(0., (y + z) * (y * square(v) + z * square(w)) - y * z * square(opposite)));
  }
  return result;
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_POINT_SOURCE_H
