// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Whether three points are on a line: an exact test that nearly always takes a few operations.

#include <CGAL/Intrinsic_triangulations/internal/measures/are_collinear.h>
#include "Flat_geometry.h"

#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <cmath>

namespace CGAL::Intrinsic_triangulations::internal {

// If a component of the cross product exceeds its rounding error, the points are not collinear; all other cases are
// decided exactly. \pre the coordinates are finite
bool are_collinear(const std::array<double, 3>& p, const std::array<double, 3>& q, const std::array<double, 3>& r)
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
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const auto difference = [](double a, double b) { return Exact_ring(a) - Exact_ring(b); };
    if (CGAL::sign(difference(q[j], p[j]) * difference(r[k], p[k]) - difference(q[k], p[k]) * difference(r[j], p[j])) !=
        ZERO)
      return false;
  }
  return true;
}

} // namespace CGAL::Intrinsic_triangulations::internal
