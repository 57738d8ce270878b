// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Exact decisions about points of the plane.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_PARAMETERIZATION_PLANAR_PREDICATES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_PARAMETERIZATION_PLANAR_PREDICATES_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

inline CGAL::Orientation orientation_in_plane(const std::array<double, 2>& p, const std::array<double, 2>& q,
                                              const std::array<double, 2>& r)
{
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
  return CGAL::orientation(Point(p[0], p[1]), Point(q[0], q[1]), Point(r[0], r[1]));
}

inline bool turns_left(const std::array<double, 2>& p, const std::array<double, 2>& q, const std::array<double, 2>& r)
{
  return orientation_in_plane(p, q, r) == CGAL::LEFT_TURN;
}

using Planar_segment = std::array<std::array<double, 2>, 2>;

// Whether two of the segments have a common point other than a common end.
bool have_common_points(const std::vector<Planar_segment>& segments);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_PARAMETERIZATION_PLANAR_PREDICATES_H
