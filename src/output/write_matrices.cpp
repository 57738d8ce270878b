// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/write_matrices.h"

#include "output/Triangulation_result.h"
#include "output/finite_weights.h"
#include "system/Long_text.h"

#include <CGAL/Intrinsic_triangulations/Laplace_Beltrami.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace idt {
namespace {

namespace IT = CGAL::Intrinsic_triangulations;

// Eigen's own writer takes a file name, and writes both triangles of a symmetric matrix.
// \param what a comment that describes the matrix
void write_matrix(std::ostream& os, bool is_symmetric, const char* what, const Eigen::SparseMatrix<double>& matrix)
{
  const auto is_written = [is_symmetric](const Eigen::SparseMatrix<double>::InnerIterator& i) {
    return !is_symmetric || i.row() >= i.col();
  };
  std::size_t entries = 0;
  for (int c = 0; c < matrix.outerSize(); ++c)
    for (Eigen::SparseMatrix<double>::InnerIterator i(matrix, c); i; ++i)
      entries += is_written(i);
  os << "%%MatrixMarket matrix coordinate real " << (is_symmetric ? "symmetric" : "general") << "\n% " << what << '\n'
     << matrix.rows() << ' ' << matrix.cols() << ' ' << entries << '\n';
  write_elements(os, static_cast<std::size_t>(matrix.outerSize()), [&](Long_text& text, std::size_t c) {
    for (Eigen::SparseMatrix<double>::InnerIterator i(matrix, static_cast<int>(c)); i; ++i)
      if (is_written(i))
        text << i.row() + 1 << ' ' << i.col() + 1 << ' ' << i.value() << '\n';
  });
}

} // namespace

void write_stiffness_matrix(std::ostream& os, const Eigen::SparseMatrix<double>& matrix)
{
  write_matrix(os, true, "Laplace-Beltrami operator: -(cot + cot)/2 off the diagonal, row sums zero", matrix);
}

void write_mass_matrix(std::ostream& os, const Eigen::SparseMatrix<double>& matrix, bool is_lumped)
{
  write_matrix(os, true,
               is_lumped ? "lumped mass: a third of the area of the faces at each vertex"
                         : "mass of linear finite elements",
               matrix);
}

void write_prolongation_matrix(std::ostream& os, const Eigen::SparseMatrix<double>& matrix)
{
  write_matrix(os, false, "prolongation: values at the vertices of the simplified surface to those of the given one",
               matrix);
}

void write_Laplacian(std::ostream& os, const Triangulation_result& result)
{
  const Outcome& outcome = result.outcome;
  require_finite_weights(result.surface, outcome.connectivity, outcome.numbers);
  write_stiffness_matrix(os, IT::stiffness_matrix(outcome.connectivity, outcome.numbers.cotangent_weights));
}

void write_mass(std::ostream& os, const Triangulation_result& result)
{
  write_mass_matrix(os, IT::lumped_mass_matrix(result.outcome.connectivity, result.outcome.numbers.areas), true);
}

void write_distance_table(std::ostream& os, const std::vector<std::uint64_t>& sources,
                          const std::vector<std::uint64_t>& targets, const std::vector<double>& distances)
{
  os << "source";
  for (std::uint64_t v : targets)
    os << ',' << v;
  os << '\n';
  write_elements(os, sources.size(), [&](Long_text& text, std::size_t i) {
    text << sources[i];
    for (std::size_t k = 0; k < targets.size(); ++k)
      text << ',' << distances[i * targets.size() + k];
    text << '\n';
  });
}

// The format goes down the columns.
void write_distance_matrix(std::ostream& os, const std::vector<std::uint64_t>& sources,
                           const std::vector<std::uint64_t>& targets, const std::vector<double>& distances)
{
  os << "%%MatrixMarket matrix array real general\n% lengths of shortest paths\n"
     << sources.size() << ' ' << targets.size() << '\n';
  write_elements(os, targets.size(), [&](Long_text& text, std::size_t k) {
    for (std::size_t i = 0; i < sources.size(); ++i)
      text << distances[i * targets.size() + k] << '\n';
  });
}

} // namespace idt
