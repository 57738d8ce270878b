// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// What `refine_Delaunay()` is asked for, and what it reports.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_REFINEMENT_REPORT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_REFINEMENT_REPORT_H

#include <CGAL/Intrinsic_triangulations/Index.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsInsertion
/// \brief which triangles `refine_Delaunay()` makes smaller.
struct Refinement_criteria
{
  double minimum_angle = 25;                                               ///< no corner is to be smaller, in degrees; at most 30
  double maximum_circumradius = (std::numeric_limits<double>::infinity)(); ///< no circumradius is to be larger, in the unit of the input
  double maximum_edge_length = (std::numeric_limits<double>::infinity)();  ///< no edge is to be longer, in the unit of the input
  /// whether edges that are not flipped are split until no angle opposite to them is obtuse: first of all, whether a face needs it or not.
  /// No cotangent weight of the border is negative then
  bool splits_encroached_edges = false;
  /// no vertex is inserted for a face whose shortest side is shorter, in the unit of the input: so refinement ends soon where sheets, tubes
  /// or slivers are far thinner than what matters
  double minimum_size = 0;
};

/// \ingroup PkgIntrinsicTriangulationsInsertion
/// \brief why a face does not meet the criteria.
enum class Refinement_obstacle {
  CONE,              ///< a corner at a vertex with so small an angle sum, or a point that would be too close to one
  SMALL_INPUT_ANGLE, ///< a corner between two edges that must not be flipped, or between points on two such edges
  UNREPRESENTABLE,   ///< doubles are too coarse for the point that the face needs
  TOO_SMALL,         ///< a side is shorter than the smallest size
  BUDGET             ///< the budget did not suffice, or the run was cancelled
};

/// \ingroup PkgIntrinsicTriangulationsInsertion
/// \brief a face that does not meet the criteria.
struct Unrefined_face
{
  Face_index face;            ///< the face
  Refinement_obstacle reason; ///< why it was left
};

/// \ingroup PkgIntrinsicTriangulationsInsertion
/// \brief what a visitor of `refine_Delaunay()` is told before each step.
struct Refinement_progress
{
  std::uint64_t points = 0;      ///< new vertices so far
  std::size_t waiting_faces = 0; ///< an upper bound on the faces that do not meet the criteria: some of them may meet them by now
  double size = 0;               ///< the shortest side of the face that is next, in the unit of the input
  Face_index face;               ///< that face
  /// about how many more vertices are needed at least: by faces that are too large, and by thin ones whose shortest sides are of that size.
  /// Taken from the areas of these faces at 1024 new vertices and whenever their number has doubled since
  std::uint64_t estimated_points = 0;
};

/// \ingroup PkgIntrinsicTriangulationsInsertion
/// \brief how a run of `refine_Delaunay()` ended.
enum class Refinement_status {
  REFINED,          ///< all faces meet the criteria but those that are listed with a reason other than `BUDGET`
  BUDGET_EXHAUSTED, ///< the largest number of new vertices was reached
  CANCELLED         ///< the visitor cancelled the run. If that was within a step, no faces are listed
};

/// \ingroup PkgIntrinsicTriangulationsInsertion
/// \brief the result of a run of `refine_Delaunay()`.
struct Refinement_report
{
  Refinement_status status = Refinement_status::REFINED; ///< how the run ended
  std::uint64_t insertions = 0;                          ///< the number of vertices inserted into faces
  std::uint64_t segment_splits = 0;                      ///< the number of vertices inserted on edges
  std::uint64_t flips = 0;                               ///< the number of flips
  std::vector<Unrefined_face> unrefined;                 ///< the faces that do not meet the criteria, in order
};

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_REFINEMENT_REPORT_H
