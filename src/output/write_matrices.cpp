// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/Triangulation_result.h"

#include "output/finite_weights.h"
#include "system/text.h"

#include <CGAL/Intrinsic_triangulations/Laplace_Beltrami.h>

namespace idt {
namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Matrix = Eigen::SparseMatrix<double>;

// Eigen's own writer takes a file name, and writes both triangles of a symmetric matrix.
void write_symmetric(std::ostream& os, const char* what, const Matrix& matrix)
{
  std::size_t entries = 0;
  for (int c = 0; c < matrix.outerSize(); ++c)
    for (Matrix::InnerIterator i(matrix, c); i; ++i)
      entries += i.row() >= i.col();
  os << "%%MatrixMarket matrix coordinate real symmetric\n% " << what << '\n'
     << matrix.rows() << ' ' << matrix.cols() << ' ' << entries << '\n';
  for (int c = 0; c < matrix.outerSize() && os; ++c)
    for (Matrix::InnerIterator i(matrix, c); i; ++i)
      if (i.row() >= i.col())
        os << i.row() + 1 << ' ' << i.col() + 1 << ' ' << in_full(i.value()) << '\n';
}

} // namespace

void write_laplacian(std::ostream& os, const Triangulation_result& result)
{
  const Outcome& outcome = result.outcome;
  require_finite_weights(outcome.connectivity, outcome.numbers.weights, result.surface.path);
  write_symmetric(os, "Laplace-Beltrami operator: -(cot + cot)/2 off the diagonal, row sums zero",
                  IT::stiffness_matrix(outcome.connectivity, outcome.numbers.weights));
}

void write_mass(std::ostream& os, const Triangulation_result& result)
{
  write_symmetric(os, "lumped mass: a third of the area of the faces at each vertex",
                  IT::lumped_mass_matrix(result.outcome.connectivity, result.outcome.numbers.areas));
}

} // namespace idt
