// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Newton's method for conformal metrics, compiled without a solver of linear systems.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_PARAMETERIZATION_CONFORMAL_SOLVER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_PARAMETERIZATION_CONFORMAL_SOLVER_H

#include <CGAL/Intrinsic_triangulations/Conformal_map.h>
#include <CGAL/Intrinsic_triangulations/Conformal_metric.h>
#include <CGAL/Intrinsic_triangulations/internal/parameterization/Doubled_surface.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The named parameters of discrete_conformal_metric().
struct Conformal_options
{
  std::vector<std::pair<Vertex_index, double>> cone_angles{}, boundary_angles{};
  Conformal_boundary boundary = Conformal_boundary::FREE;
  std::optional<std::size_t> number_of_cones{};
  // The largest range of u, for a closed surface and for one with a border, where every cone costs a cut.
  double largest_range = 2, largest_range_with_border = 5;
  Progress_function progress{};
};

// A term w (x_i − x_j)² of a sum. A negative number of a variable stands for the value zero.
struct Weighted_pair
{
  int i, j;
  double weight;
};
using Solve = std::function<std::vector<double>(const std::vector<double>&)>;
// Factorizes the matrix of such a sum with n variables, the same number each time.
// \exception Numerical_error if it is not positive definite after rounding
using Factorize = std::function<Solve(int n, const std::vector<Weighted_pair>& sum)>;

// \param surface the given one; `doubled` is made from it
Discrete_conformal_metric find_conformal_metric(const Doubled_surface::Triangulation& surface,
                                                const Doubled_surface& doubled, const Conformal_options& options,
                                                const Factorize& factorize);

// Adds cones until the map is certified, if they may be chosen.
Conformal_map find_conformal_map(const Doubled_surface::Triangulation& surface, Conformal_options options,
                                 const Factorize& factorize);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_PARAMETERIZATION_CONFORMAL_SOLVER_H
