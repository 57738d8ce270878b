// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Solutions with the factor of a sparse matrix, several of its columns at once.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MATRICES_FACTOR_PANELS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MATRICES_FACTOR_PANELS_H

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// Solves L L* x = b for the factor L of Eigen's Cholesky factorization: each column is sorted and begins with the
// diagonal. Four columns in a row with the same rows below them are a panel: the numbers of these rows are read once,
// and x as well. Most of the factor is in panels, and to read it is what takes time.
template <class Scalar>
class Factor_panels
{
  using Matrix = Eigen::SparseMatrix<Scalar>;
  static constexpr int wide = 4;

public:
  Factor_panels() = default;
  explicit Factor_panels(const Matrix& factor)
  {
    const auto *const first = factor.outerIndexPtr(), *const row = factor.innerIndexPtr();
    const auto has_rows_of_next = [&](int c) {
      return first[c + 1] - first[c] == first[c + 2] - first[c + 1] + 1 && row[first[c] + 1] == c + 1;
    };
    for (int c = 0; c < factor.cols(); c += panels_.back().second) {
      int width = 1;
      while (width < wide && c + width < factor.cols() && has_rows_of_next(c + width - 1))
        ++width;
      panels_.push_back({c, width == wide ? wide : 1});
    }
  }

  // \param x the right side, which becomes the solution
  void solve(const Matrix& factor, Scalar* x) const
  {
    for (auto panel = panels_.begin(); panel != panels_.end(); ++panel)
      panel->second == wide ? forward<wide>(factor, panel->first, x) : forward<1>(factor, panel->first, x);
    for (auto panel = panels_.rbegin(); panel != panels_.rend(); ++panel)
      panel->second == wide ? backward<wide>(factor, panel->first, x) : backward<1>(factor, panel->first, x);
  }

private:
  template <int width>
  static void forward(const Matrix& factor, int c, Scalar* x)
  {
    if (std::all_of(x + c, x + c + width, [](const Scalar& y) { return y == Scalar(0); }))
      return; // nothing has come here yet
    const auto *const first = factor.outerIndexPtr() + c, *const row = factor.innerIndexPtr() + first[0];
    const auto entry = [&](int i, int k) { return factor.valuePtr()[first[k] + i - k]; };
    std::array<Scalar, width> y;
    for (int k = 0; k < width; ++k) {
      for (int j = 0; j < k; ++j)
        x[c + k] -= entry(k, j) * y[j];
      y[k] = x[c + k] /= entry(k, k);
    }
    for (int i = width; i < first[1] - first[0]; ++i) {
      Scalar sum = entry(i, 0) * y[0];
      for (int k = 1; k < width; ++k)
        sum += entry(i, k) * y[k];
      x[row[i]] -= sum;
    }
  }

  template <int width>
  static void backward(const Matrix& factor, int c, Scalar* x)
  {
    const auto *const first = factor.outerIndexPtr() + c, *const row = factor.innerIndexPtr() + first[0];
    const auto entry = [&](int i, int k) { return Eigen::numext::conj(factor.valuePtr()[first[k] + i - k]); };
    std::array<Scalar, width> sums{};
    for (int i = width; i < first[1] - first[0]; ++i)
      for (int k = 0; k < width; ++k)
        sums[k] += entry(i, k) * x[row[i]];
    for (int k = width; k-- > 0;) {
      for (int j = k + 1; j < width; ++j)
        sums[k] += entry(j, k) * x[c + j];
      x[c + k] = (x[c + k] - sums[k]) / entry(k, k);
    }
  }

  std::vector<std::pair<int, int>> panels_; // the first column of each panel, and how many there are
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MATRICES_FACTOR_PANELS_H
