// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Whether the angles of consecutive corners sum to less than π, exactly.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_ANGLE_SUM_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_ANGLE_SUM_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// A sum of angles with a bound on its error.
struct Bounded_angle
{
  double value = 0;
  double error = 0;

  // π is within 2^-52 of a double.
  bool is_below_pi() const { return value + error < 3.1415926535897932 - 0x1p-50; }
  bool is_above_pi() const { return value - error > 3.1415926535897932 + 0x1p-50; }
  // Whether it is π, provided that it is a multiple of π; false if it is known to be below or above.
  bool is_near_pi() const { return error < 1; }

  // Each sum is rounded by less than 2^-50.
  Bounded_angle& operator+=(const Bounded_angle& other)
  {
    value += other.value;
    error += other.error + 0x1p-50;
    return *this;
  }
};

// The angle of a corner from twice the scalar product of its sides and four times the area. A true area is never
// negative.
inline Bounded_angle bounded_angle(const Double_with_bound& p, const Double_with_bound& four_areas)
{
  const double a = (std::max)(four_areas.hi(), 0.), modulus = 0.7 * (std::abs(p.hi()) + a), // at most
    error = p.error() + four_areas.error();
  if (!(modulus > 8 * error))
    return {std::atan2(a, p.hi()), std::numeric_limits<double>::infinity()};
  return {std::atan2(a, p.hi()), 1.1 * error / modulus + 0x1p-50};
}

// A corner, named by the opposite halfedge, and an estimate of its angle.
struct Estimated_corner
{
  Halfedge_index opposite;
  Bounded_angle angle;
};

// Compares the sum of the angles of corners with π.
// \pre `engine.prepare()` was called, and no corner belongs to a face that is turned over
// \exception Undecided_error, Cancelled_error as `sign_of_cotangent_weight()`
Comparison_result compare_angle_sum_with_pi(const Exact_engine& engine, const std::vector<Estimated_corner>& corners);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_ANGLE_SUM_H
