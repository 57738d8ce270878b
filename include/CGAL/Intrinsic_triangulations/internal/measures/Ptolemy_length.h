// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A λ-length as a double with an error bound, and the flips that made it, from which its exact value is computed.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_PTOLEMY_LENGTH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_PTOLEMY_LENGTH_H

#include <CGAL/enum.h>

#include <memory>

namespace CGAL::Intrinsic_triangulations::internal {

struct Ptolemy_flip;

struct Ptolemy_length
{
  double value = 0;
  double relative_error = 0;          // of `value`
  std::shared_ptr<Ptolemy_flip> flip; // null if the value is exact
};

// The five lengths around an edge: those of `Hinge`.
struct Ptolemy_hinge
{
  const Ptolemy_length &ij, &jk, &ki, &il, &lj;
};

// The other diagonal, by Ptolemy's formula. If rounding has added up too much, its double is computed anew from the exact
// value.
Ptolemy_length flipped_length(const Ptolemy_hinge& hinge);

// The exact sign of λ_ij² (λ_jk λ_ki + λ_il λ_lj) − (λ_jk λ_il + λ_ki λ_lj) (λ_ki λ_il + λ_jk λ_lj). Slow. A zero is
// wrong with a probability below 2^-128.
Sign exact_sign_of_Ptolemy_test(const Ptolemy_hinge& hinge);

// The same length, with a double that is the nearest to the exact value, or one beside it.
Ptolemy_length rounded_once(const Ptolemy_length& length);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_PTOLEMY_LENGTH_H
