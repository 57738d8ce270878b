// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The first eigenvalues of a Laplace-Beltrami operator. Needs Spectra.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SMALLEST_EIGENVALUES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SMALLEST_EIGENVALUES_H

#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/matrices/Sparse_Cholesky.h>

#include <CGAL/assertions.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>
#include <Spectra/MatOp/SparseSymMatProd.h>
#include <Spectra/SymGEigsShiftSolver.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \cond SKIP_IN_MANUAL
namespace internal {

// Solves (L + M) x = b, as Spectra asks for it: the shift is -1 always.
class Shifted_inverse
{
public:
  using Scalar = double;

  Shifted_inverse(const Eigen::SparseMatrix<double>& stiffness, const Eigen::SparseMatrix<double>& mass)
    : rows_(stiffness.rows()), cholesky_(stiffness + mass, "the Laplace-Beltrami operator plus the mass matrix")
  {}
  Eigen::Index rows() const { return rows_; }
  Eigen::Index cols() const { return rows_; }
  void set_shift(double) {}
  void perform_op(const double* in, double* out) const
  {
    Eigen::Map<Eigen::VectorXd>(out, rows_) =
      cholesky_.solve<Eigen::VectorXd>(Eigen::Map<const Eigen::VectorXd>(in, rows_));
  }

private:
  Eigen::Index rows_;
  Sparse_Cholesky<> cholesky_;
};

// Of a connected part. \pre the diagonal of the mass matrix is positive
inline void append_smallest_eigenvalues(const Eigen::SparseMatrix<double>& stiffness, Eigen::SparseMatrix<double> mass,
                                        Eigen::Index k, std::vector<double>& result)
{
  const Eigen::Index n = stiffness.rows();
  // By Weyl's law the j-th eigenvalue of a surface of area 4π is about j.
  const double unit = 4 * 3.14159265358979 / mass.sum();
  mass *= unit;
  Eigen::VectorXd values;
  if (n <= 64 || 3 * k > n) {
    values = Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(Eigen::MatrixXd(stiffness), Eigen::MatrixXd(mass),
                                                                       Eigen::EigenvaluesOnly)
               .eigenvalues();
  } else {
    Shifted_inverse inverse(stiffness, mass);
    Spectra::SparseSymMatProd<double> product(mass);
    Spectra::SymGEigsShiftSolver<Shifted_inverse, Spectra::SparseSymMatProd<double>, Spectra::GEigsMode::ShiftInvert>
      solver(inverse, product, k, (std::min)(n, (std::max)(3 * k, Eigen::Index(40))), -1);
    solver.init();
    solver.compute(Spectra::SortRule::LargestMagn, 1000, 1e-11);
    if (solver.info() != Spectra::CompInfo::Successful)
      throw Numerical_error("the smallest eigenvalues do not converge");
    values = solver.eigenvalues();
  }
  for (double x : values)
    result.push_back(x * unit);
}

// The connected parts of a symmetric matrix, each as an increasing list of its rows.
inline std::vector<std::vector<int>> connected_rows(const Eigen::SparseMatrix<double>& matrix)
{
  std::vector<std::vector<int>> parts;
  std::vector<bool> is_met(std::size_t(matrix.rows()), false);
  for (int first = 0; first < matrix.rows(); ++first) {
    if (is_met[std::size_t(first)])
      continue;
    std::vector<int> part(1, first);
    is_met[std::size_t(first)] = true;
    for (std::size_t i = 0; i < part.size(); ++i)
      for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, part[i]); entry; ++entry)
        if (entry.value() != 0 && !is_met[std::size_t(entry.row())]) {
          is_met[std::size_t(entry.row())] = true;
          part.push_back(int(entry.row()));
        }
    std::sort(part.begin(), part.end());
    parts.push_back(std::move(part));
  }
  return parts;
}

} // namespace internal
/// \endcond

/// \ingroup PkgIntrinsicTriangulationsOperators
/// \brief returns the smallest solutions λ of `L u = λ M u`, in increasing order.
///
/// Rows without mass, which are those of vertices without faces, are left out. A zero appears once for each connected
/// part of the surface, as each is solved by itself.
///
/// Method: Lanczos (Spectra) for the inverse of `L + c M`, with one sparse Cholesky factorization; small parts as dense matrices.
/// An eigenvalue is within about 1e-10 of itself plus the first one that is positive.
///
/// \param stiffness a positive semidefinite matrix, as of `stiffness_matrix()` or `tufted_Laplacian()`
/// \param mass the mass matrix, lumped or Galerkin
/// \param number how many are wanted; there are no more than rows with mass
/// \pre both matrices have the same size
/// \exception Numerical_error if the iteration does not converge, or if the matrix is not positive definite after rounding
inline std::vector<double> smallest_eigenvalues(const Eigen::SparseMatrix<double>& stiffness,
                                                const Eigen::SparseMatrix<double>& mass, std::size_t number)
{
  CGAL_precondition(stiffness.rows() == mass.rows());
  std::vector<double> result;
  const Eigen::VectorXd masses = mass.diagonal();
  for (const std::vector<int>& part : internal::connected_rows(stiffness)) {
    std::vector<int> new_row(std::size_t(stiffness.rows()), -1);
    int n = 0;
    for (int row : part)
      if (masses[row] > 0)
        new_row[std::size_t(row)] = n++;
    if (n > 0)
      internal::append_smallest_eigenvalues(internal::submatrix(stiffness, new_row, new_row, n, n),
                                            internal::submatrix(mass, new_row, new_row, n, n),
                                            (std::min)(Eigen::Index(number), Eigen::Index(n)), result);
  }
  std::sort(result.begin(), result.end());
  result.resize((std::min)(result.size(), number));
  return result;
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SMALLEST_EIGENVALUES_H
