// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Linear systems with a sparse and positive definite matrix, symmetric or Hermitian.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MATRICES_SPARSE_CHOLESKY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MATRICES_SPARSE_CHOLESKY_H

#include <CGAL/Intrinsic_triangulations/errors.h>

#include <Eigen/SparseCore>
#ifdef CGAL_INTRINSIC_TRIANGULATIONS_USE_CHOLMOD
#include <Eigen/CholmodSupport>
#else
#include <CGAL/Intrinsic_triangulations/internal/matrices/Factor_panels.h>

#include <Eigen/SparseCholesky>
#endif

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// With CGAL_INTRINSIC_TRIANGULATIONS_USE_CHOLMOD the factors are those of SuiteSparse, which is
// faster for large systems; whoever defines it links with cholmod.
//
// \tparam Scalar `double`, or `std::complex<double>` for Hermitian matrices
template <class Scalar = double>
class Sparse_Cholesky
{
public:
  using Matrix = Eigen::SparseMatrix<Scalar>;

  // \param what names the matrix in the message of the exception
  Sparse_Cholesky(const Matrix& matrix, const char* what) : what_(what)
  {
    if (matrix.rows() > 0)
      solver_.analyzePattern(matrix);
    factorize(matrix);
  }

  // For another matrix with the same pattern.
  void factorize(const Matrix& matrix)
  {
    if (matrix.rows() == 0)
      return;
    solver_.factorize(matrix);
    if (solver_.info() != Eigen::Success)
      throw Numerical_error(std::string(what_) + " is not positive definite after rounding");
#ifndef CGAL_INTRINSIC_TRIANGULATIONS_USE_CHOLMOD
    panels_ = Factor_panels<Scalar>(solver_.matrixL().nestedExpression());
#endif
  }

  // Each column is a system.
  template <class Columns>
  Columns solve(const Columns& right) const
  {
    if (right.rows() == 0)
      return right;
#ifdef CGAL_INTRINSIC_TRIANGULATIONS_USE_CHOLMOD
    const Columns x = solver_.solve(right);
#else
    Columns ordered = solver_.permutationP() * right;
    for (Eigen::Index c = 0; c < ordered.cols(); ++c)
      panels_.solve(solver_.matrixL().nestedExpression(), ordered.col(c).data());
    const Columns x = solver_.permutationPinv() * ordered;
#endif
    if (!x.allFinite())
      throw Numerical_error(std::string("a linear system cannot be solved: ") + what_ + " is too badly conditioned");
    return x;
  }

private:
#ifdef CGAL_INTRINSIC_TRIANGULATIONS_USE_CHOLMOD
  Eigen::CholmodSupernodalLLT<Matrix> solver_;
#else
  Eigen::SimplicialLLT<Matrix> solver_;
  Factor_panels<Scalar> panels_;
#endif
  const char* what_;
};

// The rows and columns of a matrix whose new number is not negative, renumbered. The order
// of numbers must be that of the rows.
inline Eigen::SparseMatrix<double> submatrix(const Eigen::SparseMatrix<double>& matrix,
                                             const std::vector<int>& new_rows, const std::vector<int>& new_columns,
                                             int number_of_rows, int number_of_columns)
{
  Eigen::SparseMatrix<double> result(number_of_rows, number_of_columns);
  for (int c = 0; c < matrix.outerSize(); ++c) {
    if (new_columns[std::size_t(c)] < 0)
      continue;
    result.startVec(new_columns[std::size_t(c)]);
    for (Eigen::SparseMatrix<double>::InnerIterator i(matrix, c); i; ++i)
      if (new_rows[std::size_t(i.row())] >= 0)
        result.insertBack(new_rows[std::size_t(i.row())], new_columns[std::size_t(c)]) = i.value();
  }
  result.finalize();
  return result;
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MATRICES_SPARSE_CHOLESKY_H
