// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Linear systems with a sparse and positive definite matrix, symmetric or Hermitian.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MATRICES_SPARSE_CHOLESKY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MATRICES_SPARSE_CHOLESKY_H

#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/system/memory_access.h>

#include <Eigen/SparseCore>
#ifdef CGAL_INTRINSIC_TRIANGULATIONS_USE_CHOLMOD
#include <Eigen/CholmodSupport>
#else
#include <Eigen/SparseCholesky>
#endif

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// With CGAL_INTRINSIC_TRIANGULATIONS_USE_CHOLMOD, SuiteSparse factorizes, which is faster for large systems; the
// program must then link with cholmod.
//
// \tparam Scalar `double`, or `std::complex<double>` for Hermitian matrices
// \tparam Ordering `Eigen::NaturalOrdering<int>` if rows are in an order that makes the factor sparse; CHOLMOD has its
//   own
template <class Scalar = double, class Ordering = Eigen::AMDOrdering<int>>
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

  // Factorizes another matrix with the same pattern.
  void factorize(const Matrix& matrix)
  {
    if (matrix.rows() == 0)
      return;
    solver_.factorize(matrix);
    if (solver_.info() != Eigen::Success)
      throw Numerical_error(std::string(what_) + " is not positive definite after rounding");
#ifndef CGAL_INTRINSIC_TRIANGULATIONS_USE_CHOLMOD
    if (panels_.empty())
      find_panels();
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
    Columns x = right;
    if (solver_.permutationP().size() > 0)
      x = solver_.permutationP() * right;
    for (Eigen::Index c = 0; c < x.cols(); ++c)
      solve_in_place(x.col(c).data());
    if (solver_.permutationP().size() > 0)
      x = solver_.permutationPinv() * x;
#endif
    if (!x.allFinite())
      throw Numerical_error(std::string("a linear system cannot be solved: ") + what_ + " is too badly conditioned");
    return x;
  }

  // The number of entries of the factor; 0 with CHOLMOD.
  std::size_t size_of_factor() const
  {
#ifdef CGAL_INTRINSIC_TRIANGULATIONS_USE_CHOLMOD
    return 0;
#else
    return std::size_t(factor().nonZeros());
#endif
  }

private:
#ifdef CGAL_INTRINSIC_TRIANGULATIONS_USE_CHOLMOD
  Eigen::CholmodSupernodalLLT<Matrix> solver_;
#else
  // Reading the factor takes most of the time. So up to four consecutive columns with the same rows below them form a
  // panel, for which these row numbers and the right side are read once.
  static constexpr int wide = 4;
  static constexpr std::ptrdiff_t soon = 512; // numbers ahead

  // Each column is sorted and begins with the diagonal.
  const Matrix& factor() const { return solver_.matrixL().nestedExpression(); }

  void find_panels()
  {
    const auto *const first = factor().outerIndexPtr(), *const row = factor().innerIndexPtr();
    const auto has_rows_of_next = [&](int c) {
      return first[c + 1] - first[c] == first[c + 2] - first[c + 1] + 1 && row[first[c] + 1] == c + 1;
    };
    for (int c = 0; c < factor().cols(); c += panels_.back().second) {
      int width = 1;
      while (width < wide && c + width < factor().cols() && has_rows_of_next(c + width - 1))
        ++width;
      panels_.push_back({c, width});
    }
  }

  void solve_in_place(Scalar* x) const
  {
    for (auto panel = panels_.begin(); panel != panels_.end(); ++panel)
      with_width<wide>(panel->second, [&](auto width) { forward<width()>(panel->first, x); });
    for (auto panel = panels_.rbegin(); panel != panels_.rend(); ++panel)
      with_width<wide>(panel->second, [&](auto width) { backward<width()>(panel->first, x); });
  }

  // Calls f with the width as a type.
  template <int widest, class F>
  static void with_width(int width, const F& f)
  {
    if constexpr (widest > 1)
      if (width < widest)
        return with_width<widest - 1>(width, f);
    f(std::integral_constant<int, widest>());
  }

  template <int width>
  void forward(int c, Scalar* x) const
  {
    if (std::all_of(x + c, x + c + width, [](const Scalar& y) { return y == Scalar(0); }))
      return; // still zero
    const auto *const first = factor().outerIndexPtr() + c, *const row = factor().innerIndexPtr() + first[0];
    const Scalar* const values = factor().valuePtr();
    const auto entry = [&](int i, int k) { return values[first[k] + i - k]; };
    std::array<Scalar, width> y;
    for (int k = 0; k < width; ++k) {
      for (int j = 0; j < k; ++j)
        x[c + k] -= entry(k, j) * y[j];
      y[k] = x[c + k] /= entry(k, k);
    }
    const std::ptrdiff_t begin = first[0], end = factor().nonZeros();
    for (int i = width; i < first[1] - first[0]; ++i) {
      prefetch(values + (std::min)(begin + width * i + soon, end));
      Scalar sum = entry(i, 0) * y[0];
      for (int k = 1; k < width; ++k)
        sum += entry(i, k) * y[k];
      x[row[i]] -= sum;
    }
  }

  template <int width>
  void backward(int c, Scalar* x) const
  {
    const auto *const first = factor().outerIndexPtr() + c, *const row = factor().innerIndexPtr() + first[0];
    const Scalar* const values = factor().valuePtr();
    const auto entry = [&](int i, int k) { return Eigen::numext::conj(values[first[k] + i - k]); };
    const std::ptrdiff_t begin = first[0];
    std::array<Scalar, width> sums{};
    for (int i = width; i < first[1] - first[0]; ++i) {
      prefetch(values + (std::max)(begin + width * i - soon, std::ptrdiff_t(0)));
      for (int k = 0; k < width; ++k)
        sums[k] += entry(i, k) * x[row[i]];
    }
    for (int k = width; k-- > 0;) {
      for (int j = k + 1; j < width; ++j)
        sums[k] += entry(j, k) * x[c + j];
      x[c + k] = (x[c + k] - sums[k]) / entry(k, k);
    }
  }

  Eigen::SimplicialLLT<Matrix, Eigen::Lower, Ordering> solver_;
  std::vector<std::pair<int, int>> panels_; // the first column, and how many there are
#endif
  const char* what_;
};

// The rows and columns of a matrix whose new number is not negative, renumbered. New numbers must be in the order of
// the rows.
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

// The rows of an increasing list, and their columns: in time that grows with what these have.
// \param new_row the position of each in the list; negative for others
inline Eigen::SparseMatrix<double> principal_submatrix(const Eigen::SparseMatrix<double>& matrix,
                                                       const std::vector<int>& rows, const std::vector<int>& new_row)
{
  Eigen::SparseMatrix<double> result(Eigen::Index(rows.size()), Eigen::Index(rows.size()));
  for (std::size_t c = 0; c < rows.size(); ++c) {
    result.startVec(Eigen::Index(c));
    for (Eigen::SparseMatrix<double>::InnerIterator i(matrix, rows[c]); i; ++i)
      if (new_row[std::size_t(i.row())] >= 0)
        result.insertBack(new_row[std::size_t(i.row())], Eigen::Index(c)) = i.value();
  }
  result.finalize();
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MATRICES_SPARSE_CHOLESKY_H
