// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The coordinates of a point that a user gives.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_CONNECTIVITY_CHECKED_COORDINATES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_CONNECTIVITY_CHECKED_COORDINATES_H

#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/errors.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

namespace CGAL::Intrinsic_triangulations::internal {

// The barycentric coordinates of a point with sum 1, or nothing if they are not finite, negative, or all zero.
inline std::optional<std::array<double, 3>> checked_coordinates(std::array<double, 3> coordinates)
{
  double largest = 0;
  for (double x : coordinates) {
    if (!(x >= 0 && x <= (std::numeric_limits<double>::max)()))
      return std::nullopt;
    largest = (std::max)(largest, x);
  }
  if (largest == 0)
    return std::nullopt;
  for (double& x : coordinates) // otherwise the sum could overflow
    x = std::ldexp(x, -std::ilogb(largest));
  return with_sum_one(coordinates);
}

// Likewise, in the order of `halfedge(f)` of the face of the point.
// \exception Invalid_point_error if the halfedge has no face, or the coordinates are no point of it
inline std::array<double, 3> checked_coordinates(const Delta_complex& complex, const Surface_point& point)
{
  const auto fail = [&](const char* what) {
    throw Invalid_point_error("a point at halfedge " + std::to_string(point.halfedge.idx()) + " of a surface " + what);
  };
  if (point.halfedge.idx() >= complex.number_of_halfedges() || complex.is_border(point.halfedge))
    fail("is not in a face");
  const std::optional<std::array<double, 3>> coordinates = checked_coordinates(point.coordinates);
  if (!coordinates)
    fail("has coordinates that are not finite, negative, or all zero");
  return coordinates_from(complex, {point.halfedge, *coordinates}, complex.halfedge(complex.face(point.halfedge)));
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_CONNECTIVITY_CHECKED_COORDINATES_H
