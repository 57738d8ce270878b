// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// What is asked of a proof that a number is zero.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TIE_PROOF_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TIE_PROOF_H

#include <CGAL/Named_function_parameters.h>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// \brief what exact decisions accept as a tie: that a number which looks like zero is zero.
///
/// That a number is *not* zero, and its sign, is always proven.
enum class Tie_proof {
  /// A tie is proven if that takes little time. If not, it is accepted after a test that takes a number
  /// other than zero for zero with a probability below 2<sup>-128</sup>, over the choice of random
  /// primes from a fixed seed. Every decision is made.
  PROBABLE_IF_COSTLY,
  /// A tie is proven, or the decision ends with an `Undecided_error`: the time that the proof takes can double with each square root that
  /// is independent of the others.
  PROVEN
};

/// \cond SKIP_IN_MANUAL
namespace internal {
struct Tie_proof_tag
{};
} // namespace internal
/// \endcond

} // namespace Intrinsic_triangulations

namespace parameters {

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// \brief the named parameter `tie_proof`: what exact decisions accept as a tie.
///
/// It has to be the first of a sequence: `parameters::tie_proof(…).visitor(…)`.
inline Named_function_parameters<Intrinsic_triangulations::Tie_proof,
                                 Intrinsic_triangulations::internal::Tie_proof_tag>
tie_proof(Intrinsic_triangulations::Tie_proof value)
{
  return Named_function_parameters<Intrinsic_triangulations::Tie_proof,
                                   Intrinsic_triangulations::internal::Tie_proof_tag>(value);
}

} // namespace parameters
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TIE_PROOF_H
