// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/write_symmetric_matrix.h"

#include "system/Long_text.h"

#include <cstddef>

namespace idt {

// Eigen's own writer takes a file name, and writes both triangles of a symmetric matrix.
void write_symmetric_matrix(std::ostream& os, const char* what, const Eigen::SparseMatrix<double>& matrix)
{
  std::size_t entries = 0;
  for (int c = 0; c < matrix.outerSize(); ++c)
    for (Eigen::SparseMatrix<double>::InnerIterator i(matrix, c); i; ++i)
      entries += i.row() >= i.col();
  os << "%%MatrixMarket matrix coordinate real symmetric\n% " << what << '\n'
     << matrix.rows() << ' ' << matrix.cols() << ' ' << entries << '\n';
  write_elements(os, static_cast<std::size_t>(matrix.outerSize()), [&matrix](Long_text& text, std::size_t c) {
    for (Eigen::SparseMatrix<double>::InnerIterator i(matrix, static_cast<int>(c)); i; ++i)
      if (i.row() >= i.col())
        text << i.row() + 1 << ' ' << i.col() + 1 << ' ' << i.value() << '\n';
  });
}

} // namespace idt
