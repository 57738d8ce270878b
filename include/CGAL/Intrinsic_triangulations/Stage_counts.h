// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The stages of an exact Delaunay test, and how many tests each decided.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_STAGE_COUNTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_STAGE_COUNTS_H

#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// \brief the stages of an exact Delaunay test, each taken when those before cannot decide.
enum class Stage {
  FILTER,         ///< the stored squared lengths and areas with their error bounds
  COPLANAR,       ///< both faces lie in one plane in space: the in-circle test of four points
  UNFOLDING,      ///< the unfolding over the input triangles, in double-doubles with error bounds
  MULTIPRECISION, ///< the unfolding in MPFR intervals
  ALGEBRAIC,      ///< the unfolding in exact numbers: most often a proof of zero
  MODULAR         ///< a tie, with an error below 2<sup>-128</sup>: zero in several finite fields
};
/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// \brief the number of stages.
constexpr std::size_t number_of_stages = 6;

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// \brief how many Delaunay tests each stage decided, and how many were ties.
struct Stage_counts
{
  std::array<std::uint64_t, number_of_stages> decided{}; ///< by `Stage`
  std::uint64_t ties = 0;                                ///< tests whose opposite angles sum to exactly π

  /// returns the number of tests that `stage` decided.
  std::uint64_t operator[](Stage stage) const { return decided[std::size_t(stage)]; }

  /// counts a test that `stage` decided.
  void add(Stage stage, bool is_tie)
  {
    ++decided[std::size_t(stage)];
    ties += is_tie;
  }
  /// adds the numbers of others.
  Stage_counts& operator+=(const Stage_counts& other)
  {
    for (std::size_t i = 0; i < number_of_stages; ++i)
      decided[i] += other.decided[i];
    ties += other.ties;
    return *this;
  }
};

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_STAGE_COUNTS_H
