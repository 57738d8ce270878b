// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Squared distance and area of points in space, on a bare number type.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_TRIANGLE_FORMULAS_3_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_TRIANGLE_FORMULAS_3_H

#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Two_doubles.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/rounded_sqrt.h>
#include <CGAL/Intrinsic_triangulations/Large_vector.h>

#include <CGAL/Uncertain.h>
#include <CGAL/number_type_basic.h>

#include <array>

namespace CGAL::Intrinsic_triangulations::internal {

using Points = Large_vector<std::array<double, 3>>;

template <class FT>
using Vector_3 = std::array<FT, 3>;

template <class FT>
FT scalar_product(const Vector_3<FT>& a, const Vector_3<FT>& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class FT>
Vector_3<FT> cross_product(const Vector_3<FT>& a, const Vector_3<FT>& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Rounding can make a radicand that is zero slightly negative; an invalid one was
// refused before.
template <class FT>
FT sqrt_of_non_negative(const FT& x)
{
  if (possibly(x > FT(0)))
    return rounded_sqrt(x);
  return FT(0);
}

// For sums of squares, which are not negative.
inline Two_doubles sqrt_of_non_negative(const Two_doubles& x) { return rounded_sqrt(x); }

// The same bits for (p, q) and (q, p).
template <class FT>
FT squared_distance_3(const std::array<FT, 3>& p, const std::array<FT, 3>& q)
{
  const FT x = q[0] - p[0], y = q[1] - p[1], z = q[2] - p[2];
  return x * x + y * y + z * z;
}

// 2 |(q − p) × (r − p)|: four times the area; accurate for slivers, where Heron's
// formula on squared lengths cancels.
template <class FT>
FT four_areas_3(const std::array<FT, 3>& p, const std::array<FT, 3>& q, const std::array<FT, 3>& r)
{
  const FT ux = q[0] - p[0], uy = q[1] - p[1], uz = q[2] - p[2];
  const FT vx = r[0] - p[0], vy = r[1] - p[1], vz = r[2] - p[2];
  const FT x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
  return FT(2) * sqrt_of_non_negative(FT(x * x + y * y + z * z));
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_TRIANGLE_FORMULAS_3_H
