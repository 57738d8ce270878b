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
#include <cstdint>

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

// Heat at the corners of a face, divided by the largest of them; zero if there is none.
inline std::array<double, 3> heat_of_face(const Layered_heat& heat, const Heat_face& face)
{
  const auto& row = face.row;
  const Eigen::VectorXd& u =
    heat.layers[(std::max)({heat.layer_of[row[0]], heat.layer_of[row[1]], heat.layer_of[row[2]]})];
  const double largest = (std::max)({std::abs(u[row[0]]), std::abs(u[row[1]]), std::abs(u[row[2]])});
  return largest > 0 ? std::array<double, 3>{u[row[0]] / largest, u[row[1]] / largest, u[row[2]] / largest}
                     : std::array<double, 3>{0, 0, 0};
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
    const double along = (u[1] - u[0]) / face.base, across = (u[2] - u[0] - along * face.x) / face.height,
                 square = along * along + across * across,
                 norm = square > 0x1p-900 && square < 0x1p900 ? std::sqrt(square) : std::hypot(along, across);
    if (norm > 0)
      add_flux(face, -along / norm, -across / norm, sums);
  }
  return sums;
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_UNIT_GRADIENT_H
