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
#include <limits>
#include <string>

namespace CGAL::Intrinsic_triangulations::internal {

// The coordinates of a point with sum 1, in the order of `halfedge(f)` of its face.
// \exception Invalid_point_error if the halfedge has no face, or the coordinates are not finite, negative, or all zero
inline std::array<double, 3> checked_coordinates(const Delta_complex& complex, const Surface_point& point)
{
  const auto fail = [&](const char* what) {
    throw Invalid_point_error("a point at halfedge " + std::to_string(point.halfedge.idx()) + " of a surface " + what);
  };
  if (point.halfedge.idx() >= complex.number_of_halfedges() || complex.is_border(point.halfedge))
    fail("is not in a face");
  double largest = 0;
  for (double x : point.coordinates) {
    if (!(x >= 0 && x <= (std::numeric_limits<double>::max)()))
      fail("has a coordinate that is negative or not finite");
    largest = (std::max)(largest, x);
  }
  if (largest == 0)
    fail("has no positive coordinate");
  std::array<double, 3> result = coordinates_from(complex, point, complex.halfedge(complex.face(point.halfedge)));
  for (double& x : result)
    x /= largest;
  return with_sum_one(result);
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_CONNECTIVITY_CHECKED_COORDINATES_H
