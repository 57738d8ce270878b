// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The direction away from heat.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_UNIT_GRADIENT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_UNIT_GRADIENT_H

#include <CGAL/Intrinsic_triangulations/internal/heat/Heat_surface.h>
#include <CGAL/Intrinsic_triangulations/internal/heat/Layered_heat.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// Adds up for each row the integral of X · ∇(hat function) for a vector X in a face.
inline void add_flux(const Heat_face& face, double x, double y, Eigen::VectorXd& sums)
{
  const double to_second = face.share * (x * face.height - y * face.x) / 2, to_third = face.share * y * face.base / 2;
  sums[face.row[0]] -= to_second + to_third;
  sums[face.row[1]] += to_second;
  sums[face.row[2]] += to_third;
}

// Heat at the corners of a face.
inline std::array<double, 3> heat_of_face(const Layered_heat& heat, const Heat_face& face)
{
  const auto& row = face.row;
  const Eigen::VectorXd& u =
    heat.layers[(std::max)({heat.layer_of[row[0]], heat.layer_of[row[1]], heat.layer_of[row[2]]})];
  return {u[row[0]], u[row[1]], u[row[2]]};
}

// The gradient, times twice the area.
inline std::array<double, 2> slope(const Heat_face& face, const std::array<double, 3>& u)
{
  return {(u[1] - u[0]) * face.height, (u[2] - u[0]) * face.base - (u[1] - u[0]) * face.x};
}

// That sum for X = -∇u/|∇u|. Nothing flows in a face in which u is constant.
// \param instead the heat that counts in faces which have no other, as those with all corners on a cold border
inline Eigen::VectorXd flux_of_unit_gradient(const Heat_surface& surface, const Layered_heat& heat,
                                             const Layered_heat& instead)
{
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(Eigen::Index(surface.size()));
  for (const Heat_face& face : surface.faces) {
    std::array<double, 3> u = heat_of_face(heat, face);
    if (u[0] == 0 && u[1] == 0 && u[2] == 0)
      u = heat_of_face(instead, face);
    std::array<double, 2> v = slope(face, u);
    double norm = std::sqrt(v[0] * v[0] + v[1] * v[1]);
    if (!(norm > 0x1p-450 && norm < 0x1p450)) { // the squares are out of range, or there is no heat
      const double largest = (std::max)({std::abs(u[0]), std::abs(u[1]), std::abs(u[2])});
      v = slope(face, {u[0] / largest, u[1] / largest, u[2] / largest});
      norm = std::hypot(v[0], v[1]);
    }
    if (norm > 0)
      add_flux(face, -v[0] / norm, -v[1] / norm, sums);
  }
  return sums;
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_UNIT_GRADIENT_H
