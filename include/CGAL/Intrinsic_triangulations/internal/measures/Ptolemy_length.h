// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A λ-length as a double with an error bound, and its exact value, which is computed if it is needed.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_PTOLEMY_LENGTH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_PTOLEMY_LENGTH_H

#include <memory>

namespace CGAL::Intrinsic_triangulations::internal {

struct Exact_length;

struct Ptolemy_length
{
  double value = 0;
  double relative_error = 0;                 // of `value`
  std::shared_ptr<const Exact_length> exact; // null if the value is
};

// The five lengths around an edge: those of `Hinge`.
struct Ptolemy_hinge
{
  const Ptolemy_length &ij, &jk, &ki, &il, &lj;
};

// The other diagonal, by Ptolemy's formula. If rounding has added up too much, its double is computed anew from the
// exact value.
Ptolemy_length flipped_length(const Ptolemy_hinge& hinge);

// In double-doubles, and in rational numbers if these do not decide.
bool is_Delaunay_exactly(const Ptolemy_hinge& hinge);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_PTOLEMY_LENGTH_H
