// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The linear systems of conformal metrics, by Eigen.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_PARAMETERIZATION_FACTORIZE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_PARAMETERIZATION_FACTORIZE_H

#include <CGAL/Intrinsic_triangulations/internal/matrices/Sparse_Cholesky.h>
#include <CGAL/Intrinsic_triangulations/internal/parameterization/conformal_solver.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <memory>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

inline Solve factorize(int n, const std::vector<Weighted_pair>& sum)
{
  std::vector<double> diagonal(std::size_t(n), 0.);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(sum.size() + std::size_t(n));
  for (const auto& [i, j, weight] : sum) {
    if (i == j)
      continue;
    if (i >= 0)
      diagonal[std::size_t(i)] += weight;
    if (j >= 0)
      diagonal[std::size_t(j)] += weight;
    if (i >= 0 && j >= 0)
      entries.emplace_back((std::max)(i, j), (std::min)(i, j), -weight);
  }
  for (int i = 0; i < n; ++i)
    entries.emplace_back(i, i, diagonal[std::size_t(i)]);
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end()); // the solver reads the lower half
  const auto cholesky =
    std::make_shared<const Sparse_Cholesky<>>(matrix, "the Laplacian of the ideal Delaunay triangulation");
  return [cholesky](const std::vector<double>& right) {
    const Eigen::VectorXd x =
      cholesky->solve(Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(right.data(), Eigen::Index(right.size()))));
    return std::vector<double>(x.data(), x.data() + x.size());
  };
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_PARAMETERIZATION_FACTORIZE_H
