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
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Orders the variables once, and again when flips have filled the factor.
class Sparse_factorizer
{
public:
  Solve operator()(int n, const std::vector<Weighted_pair>& sum)
  {
    if (order_.size() == 0) {
      order_.setIdentity(n);
      Order order;
      Eigen::AMDOrdering<int>()(matrix(sum).selfadjointView<Eigen::Lower>(), order);
      order_ = order.inverse();
      size_ = 0;
    }
    const auto cholesky =
      std::make_shared<const Cholesky>(matrix(sum), "the Laplacian of the ideal Delaunay triangulation");
    const auto solve = [cholesky, order = order_](const std::vector<double>& right) {
      const Eigen::Map<const Eigen::VectorXd> given(right.data(), Eigen::Index(right.size()));
      const Eigen::VectorXd x = order.inverse() * cholesky->solve(Eigen::VectorXd(order * given));
      return std::vector<double>(x.data(), x.data() + x.size());
    };
    if (size_ == 0)
      size_ = cholesky->size_of_factor();
    else if (cholesky->size_of_factor() > size_ + size_ / 4)
      order_.resize(0);
    return solve;
  }

private:
  using Matrix = Eigen::SparseMatrix<double>;
  using Cholesky = Sparse_Cholesky<double, Eigen::NaturalOrdering<int>>;
  using Order = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;

  // The lower half.
  Matrix matrix(const std::vector<Weighted_pair>& sum) const
  {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(3 * sum.size());
    for (const auto& [i, j, weight] : sum) {
      const int r = i < 0 ? i : order_.indices()[i], c = j < 0 ? j : order_.indices()[j];
      if (r >= 0)
        entries.emplace_back(r, r, weight);
      if (c >= 0)
        entries.emplace_back(c, c, weight);
      if (r >= 0 && c >= 0)
        entries.emplace_back((std::max)(r, c), (std::min)(r, c), -weight);
    }
    Matrix result(order_.size(), order_.size());
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  }

  Order order_;
  std::size_t size_ = 0; // of the factor when they were ordered
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_PARAMETERIZATION_FACTORIZE_H
