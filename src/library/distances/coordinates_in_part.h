// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Barycentric coordinates in a part of a triangle.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_COORDINATES_IN_PART_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_COORDINATES_IN_PART_H

#include <array>

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

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_COORDINATES_IN_PART_H
