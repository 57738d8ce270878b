// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The orientation of three points of the plane, exactly.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_PLANAR_ORIENTATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_PLANAR_ORIENTATION_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>

namespace CGAL::Intrinsic_triangulations::internal {

inline Orientation planar_orientation(const std::array<double, 2>& p, const std::array<double, 2>& q,
                                      const std::array<double, 2>& r)
{
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
  return CGAL::orientation(Point(p[0], p[1]), Point(q[0], q[1]), Point(r[0], r[1]));
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_PLANAR_ORIENTATION_H
