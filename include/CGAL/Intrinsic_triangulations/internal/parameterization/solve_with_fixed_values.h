// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A linear system some of whose unknowns are given.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_PARAMETERIZATION_SOLVE_WITH_FIXED_VALUES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_PARAMETERIZATION_SOLVE_WITH_FIXED_VALUES_H

#include <CGAL/Intrinsic_triangulations/internal/matrices/Sparse_Cholesky.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// Numbers the entries that are wanted from 0 on, and the others -1.
template <class Is_wanted>
std::vector<int> numbering(std::size_t size, int& number, const Is_wanted& is_wanted)
{
  std::vector<int> result(size, -1);
  number = 0;
  for (std::size_t i = 0; i < size; ++i)
    if (is_wanted(i))
      result[i] = number++;
  return result;
}

// Solves matrix * x = 0 for the rows that are not fixed, where x has given values in the others.
inline void solve_with_fixed_values(const Eigen::SparseMatrix<double>& matrix, const std::vector<bool>& is_fixed,
                                    Eigen::MatrixXd& x, const char* what)
{
  int number_of_free = 0, number_of_fixed = 0;
  const std::vector<int> free_row =
                           numbering(is_fixed.size(), number_of_free, [&](std::size_t i) { return !is_fixed[i]; }),
                         fixed_row = numbering(is_fixed.size(), number_of_fixed,
                                               [&](std::size_t i) { return bool(is_fixed[i]); });
  Eigen::MatrixXd fixed(number_of_fixed, x.cols());
  for (std::size_t i = 0; i < is_fixed.size(); ++i)
    if (is_fixed[i])
      fixed.row(fixed_row[i]) = x.row(Eigen::Index(i));
  const Sparse_Cholesky<> cholesky(submatrix(matrix, free_row, free_row, number_of_free, number_of_free), what);
  const Eigen::MatrixXd right = -(submatrix(matrix, free_row, fixed_row, number_of_free, number_of_fixed) * fixed);
  const Eigen::MatrixXd solution = cholesky.solve(right);
  for (std::size_t i = 0; i < is_fixed.size(); ++i)
    if (!is_fixed[i])
      x.row(Eigen::Index(i)) = solution.row(free_row[i]);
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_PARAMETERIZATION_SOLVE_WITH_FIXED_VALUES_H
