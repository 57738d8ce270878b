// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A solver of CGAL's package Solver_interface, used as ours.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_SOLVER_TRAITS_ADAPTOR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_SOLVER_TRAITS_ADAPTOR_H

#include <CGAL/Intrinsic_triangulations/errors.h>

#include <Eigen/SparseCore>

#include <memory>
#include <string>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// \tparam LA a model of SparseLinearAlgebraWithFactorTraits_d
template <class LA>
class Solver_traits_adaptor
{
  using Matrix = Eigen::SparseMatrix<double>;
  using Index = typename LA::Index;

public:
  Solver_traits_adaptor(const Matrix& matrix, const char* what) : what_(what) { factorize(matrix); }

  void factorize(const Matrix& matrix)
  {
    matrix_ =
      std::make_unique<typename LA::Matrix>(int(matrix.rows()), int(matrix.cols())); // the solver may refer to it
    for (Eigen::Index c = 0; c < matrix.outerSize(); ++c)
      for (Matrix::InnerIterator i(matrix, c); i; ++i)
        matrix_->set_coef(Index(i.row()), Index(c), i.value(), true);
    double denominator = 1;
    if (!solver_.factor(*matrix_, denominator))
      throw Numerical_error(std::string(what_) + " cannot be factorized");
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& right) const
  {
    typename LA::Vector b(Index(right.size())), x(Index(right.size()));
    for (Eigen::Index i = 0; i < right.size(); ++i)
      b[Index(i)] = right[i];
    if (!solver_.linear_solver(b, x))
      throw Numerical_error(std::string("a linear system cannot be solved: that of ") + what_);
    Eigen::VectorXd result(right.size());
    for (Eigen::Index i = 0; i < right.size(); ++i)
      result[i] = x[Index(i)];
    if (!result.allFinite())
      throw Numerical_error(std::string("a linear system cannot be solved: ") + what_ + " is too badly conditioned");
    return result;
  }

private:
  const char* what_;
  std::unique_ptr<typename LA::Matrix> matrix_;
  mutable LA solver_; // CGAL's have no function for constant ones
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_SOLVER_TRAITS_ADAPTOR_H
