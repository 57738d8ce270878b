// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Symmetric matrices in the format Matrix Market.

#ifndef IDT_WRITE_SYMMETRIC_MATRIX_H
#define IDT_WRITE_SYMMETRIC_MATRIX_H

#include <Eigen/SparseCore>

#include <ostream>

namespace idt {

// Writes the lower triangle, with all digits.
// \param what a comment that says what the matrix is
void write_symmetric_matrix(std::ostream& os, const char* what, const Eigen::SparseMatrix<double>& matrix);

} // namespace idt

#endif // IDT_WRITE_SYMMETRIC_MATRIX_H
