// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Symmetric matrices in the format Matrix Market: the lower triangle, with all digits.

#ifndef IDT_WRITE_MATRICES_H
#define IDT_WRITE_MATRICES_H

#include <Eigen/SparseCore>

#include <cstdint>
#include <ostream>
#include <vector>

namespace idt {

void write_stiffness_matrix(std::ostream& os, const Eigen::SparseMatrix<double>& matrix);
// A row for each vertex of the given surface.
void write_prolongation_matrix(std::ostream& os, const Eigen::SparseMatrix<double>& matrix);
void write_mass_matrix(std::ostream& os, const Eigen::SparseMatrix<double>& matrix, bool is_lumped);

// \param distances rows of the sources with columns of the targets, row after row
void write_distance_table(std::ostream& os, const std::vector<std::uint64_t>& sources,
                          const std::vector<std::uint64_t>& targets, const std::vector<double>& distances);
void write_distance_matrix(std::ostream& os, const std::vector<std::uint64_t>& sources,
                           const std::vector<std::uint64_t>& targets, const std::vector<double>& distances);

} // namespace idt

#endif // IDT_WRITE_MATRICES_H
