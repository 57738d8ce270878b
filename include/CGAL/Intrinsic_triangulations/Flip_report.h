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
  INCONSISTENT,     ///< some edge is not Delaunay although it was just flipped: rounded decisions
                    ///< contradict each other near a tie
  UNDECIDED,        ///< the number type could not decide some edge
  BUDGET_EXHAUSTED, ///< the flip budget did not suffice
  CANCELLED         ///< the visitor cancelled the run
};

/// \ingroup PkgIntrinsicTriangulationsRef
/// \brief the result of a run of `flip_to_Delaunay()`.
struct Flip_report
{
  Flip_status status = Flip_status::DELAUNAY; ///< how the run ended
  std::uint64_t flips = 0;                    ///< the number of flips
  std::uint64_t tests = 0;                    ///< the number of Delaunay tests
  std::vector<Edge_index> not_flippable;      ///< the edges that are not Delaunay, but have no other diagonal
  std::vector<Edge_index> inconsistent;       ///< the edges that are not Delaunay although a flip should have made them so
  std::vector<Edge_index> undecided;          ///< the edges that the number type could not decide
};

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FLIP_REPORT_H
