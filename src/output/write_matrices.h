// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Symmetric matrices in the format Matrix Market: the lower triangle, with all digits.

#ifndef IDT_WRITE_MATRICES_H
#define IDT_WRITE_MATRICES_H

#include <Eigen/SparseCore>

#include <ostream>

namespace idt {

void write_stiffness_matrix(std::ostream& os, const Eigen::SparseMatrix<double>& matrix);
// A row for each vertex of the given surface.
void write_prolongation_matrix(std::ostream& os, const Eigen::SparseMatrix<double>& matrix);
void write_mass_matrix(std::ostream& os, const Eigen::SparseMatrix<double>& matrix, bool is_lumped);

} // namespace idt

#endif // IDT_WRITE_MATRICES_H
