// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Whether three points are on a line, exactly; nearly always told by a few operations.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_ARE_COLLINEAR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_ARE_COLLINEAR_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>
#include <cmath>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// A component of the cross product that is larger than its rounding error says no, and the
// rest is left to CGAL. \pre the coordinates are finite
inline bool are_collinear(const std::array<double, 3>& p, const std::array<double, 3>& q,
                          const std::array<double, 3>& r)
{
  double u[3], v[3];
  for (int i = 0; i < 3; ++i) {
    u[i] = q[i] - p[i];
    v[i] = r[i] - p[i];
  }
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double s = u[j] * v[k], t = u[k] * v[j];
    // 8 units of rounding (4 would do) and room for the underflow of both products.
    if (std::abs(s - t) > 1e-15 * (std::abs(s) + std::abs(t)) + 1e-300)
      return false;
  }
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  typedef Kernel::Point_3 Point;
  return Kernel().collinear_3_object()(Point(p[0], p[1], p[2]), Point(q[0], q[1], q[2]),
                                       Point(r[0], r[1], r[2]));
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_ARE_COLLINEAR_H
