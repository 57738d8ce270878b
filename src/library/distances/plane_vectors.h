// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Vectors in the plane of a face.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_PLANE_VECTORS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_PLANE_VECTORS_H

#include <array>
#include <cmath>

namespace CGAL::Intrinsic_triangulations::internal::plane {

using Vector = std::array<double, 2>;

inline Vector difference(const Vector& p, const Vector& q) { return {p[0] - q[0], p[1] - q[1]}; }
inline Vector reverse(const Vector& p) { return {-p[0], -p[1]}; }
inline double dot(const Vector& p, const Vector& q) { return p[0] * q[0] + p[1] * q[1]; }
inline double cross(const Vector& p, const Vector& q) { return p[0] * q[1] - p[1] * q[0]; }
inline double angle_between(const Vector& p, const Vector& q) { return std::atan2(cross(p, q), dot(p, q)); }
inline Vector unit(const Vector& p)
{
  const double length = std::hypot(p[0], p[1]);
  return {p[0] / length, p[1] / length};
}
inline Vector turned(const Vector& p, double angle)
{
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * p[0] - s * p[1], s * p[0] + c * p[1]};
}

} // namespace CGAL::Intrinsic_triangulations::internal::plane

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_PLANE_VECTORS_H
