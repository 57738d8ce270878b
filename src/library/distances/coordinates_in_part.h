// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Barycentric coordinates in a part of a triangle.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_COORDINATES_IN_PART_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_COORDINATES_IN_PART_H

#include <CGAL/Intrinsic_triangulations/internal/measures/are_collinear.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL::Intrinsic_triangulations::internal {

inline double determinant(const std::array<double, 3>& p, const std::array<double, 3>& q,
                          const std::array<double, 3>& r)
{
  return p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) + p[2] * (q[0] * r[1] - q[1] * r[0]);
}

// \param corners, p the corners of the part and the point, in coordinates of the triangle
inline std::array<double, 3> coordinates_in_part(const std::array<std::array<double, 3>, 3>& corners,
                                                 const std::array<double, 3>& p)
{
  const double whole = determinant(corners[0], corners[1], corners[2]);
  return {determinant(p, corners[1], corners[2]) / whole, determinant(corners[0], p, corners[2]) / whole,
          determinant(corners[0], corners[1], p) / whole};
}

// The barycentric coordinates of a point on the sides of a triangle, which may have no area.
inline std::array<double, 3> coordinates_on_sides(const std::array<std::array<double, 3>, 3>& corners,
                                                  const std::array<double, 3>& p)
{
  std::array<double, 3> result{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::array<double, 3>&a = corners[i], &b = corners[(i + 1) % 3];
    if (!are_collinear(a, b, p))
      continue;
    std::size_t k = 0;
    for (std::size_t j = 1; j < 3; ++j)
      if (std::abs(b[j] - a[j]) > std::abs(b[k] - a[k]))
        k = j;
    const double part = (p[k] - a[k]) / (b[k] - a[k]);
    if (!(part >= 0 && part <= 1))
      continue;
    result[i] = 1 - part;
    result[(i + 1) % 3] = part;
    break;
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_COORDINATES_IN_PART_H
