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
    if (n == 0) // Eigen has no factor then
      return [](const std::vector<double>& right) { return right; };
    if (order_.size() != n)
      find_order(n, sum);
    const auto cholesky =
      std::make_shared<const Cholesky>(matrix(n, sum), "the Laplacian of the ideal Delaunay triangulation");
    if (size_ == 0)
      size_ = cholesky->size_of_factor();
    const Order order = order_;
    if (cholesky->size_of_factor() > size_ + size_ / 4)
      order_.resize(0);
    return [cholesky, order](const std::vector<double>& right) {
      const Eigen::Map<const Eigen::VectorXd> given(right.data(), Eigen::Index(right.size()));
      const Eigen::VectorXd x = order.inverse() * cholesky->solve(Eigen::VectorXd(order * given));
      return std::vector<double>(x.data(), x.data() + x.size());
    };
  }

private:
  using Matrix = Eigen::SparseMatrix<double>;
  using Cholesky = Sparse_Cholesky<double, Eigen::NaturalOrdering<int>>;
  using Order = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;

  void find_order(int n, const std::vector<Weighted_pair>& sum)
  {
    order_.setIdentity(n);
    Order order;
    if (n > 0)
      Eigen::AMDOrdering<int>()(matrix(n, sum).selfadjointView<Eigen::Lower>(), order);
    order_ = order.inverse();
    size_ = 0;
  }

  // The lower half.
  Matrix matrix(int n, const std::vector<Weighted_pair>& sum) const
  {
    std::vector<double> diagonal(std::size_t(n), 0.);
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(sum.size() + std::size_t(n));
    const auto number = [&](int i) { return order_.indices()[i]; };
    for (const auto& [i, j, weight] : sum) {
      if (i == j)
        continue;
      if (i >= 0)
        diagonal[std::size_t(i)] += weight;
      if (j >= 0)
        diagonal[std::size_t(j)] += weight;
      if (i >= 0 && j >= 0)
        entries.emplace_back((std::max)(number(i), number(j)), (std::min)(number(i), number(j)), -weight);
    }
    for (int i = 0; i < n; ++i)
      entries.emplace_back(number(i), number(i), diagonal[std::size_t(i)]);
    Matrix result(n, n);
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  }

  Order order_;
  std::size_t size_ = 0; // of the factor when they were ordered
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_PARAMETERIZATION_FACTORIZE_H
