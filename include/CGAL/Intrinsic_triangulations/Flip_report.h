// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// What flip_to_Delaunay() tells of its run.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FLIP_REPORT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FLIP_REPORT_H

#include <CGAL/Intrinsic_triangulations/Index.h>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsRef
/// \brief how a run of `flip_to_Delaunay()` ended.
enum class Flip_status {
  DELAUNAY,         ///< every edge that is not constrained is Delaunay
  NOT_FLIPPABLE,    ///< some edge is not Delaunay, but its hinge has no other diagonal
  INCONSISTENT,     ///< some edge is not Delaunay though it was just flipped: rounded decisions
                    ///< contradict each other near a tie
  UNDECIDED,        ///< the number type could not decide on some edge
  BUDGET_EXHAUSTED, ///< the given number of flips did not suffice
  CANCELLED         ///< the visitor cancelled
};

/// \ingroup PkgIntrinsicTriangulationsRef
/// \brief what a run of `flip_to_Delaunay()` did.
struct Flip_report
{
  Flip_status status = Flip_status::DELAUNAY; ///< how the run ended
  std::uint64_t flips = 0;                    ///< number of flips
  std::uint64_t tests = 0;                    ///< number of Delaunay tests
  std::vector<Edge_index> not_flippable;      ///< not Delaunay, but without another diagonal
  std::vector<Edge_index> inconsistent;       ///< not Delaunay although the flip should have made them so
  std::vector<Edge_index> undecided;          ///< the number type could not decide on them
};

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FLIP_REPORT_H
