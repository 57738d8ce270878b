// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The reports of algorithms: how a run ended, its counts and its findings.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_REPORTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_REPORTS_H

#include <CGAL/Intrinsic_triangulations/Index.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsRef
/// \brief the outcome of `Intrinsic_triangulation::flip()`.
enum class Flip_outcome {
  FLIPPED,    ///< the edge was flipped
  NOT_CONVEX, ///< the hinge has no other diagonal; nothing was changed
  UNDECIDED   ///< the number type cannot tell; nothing was changed
};

/// \ingroup PkgIntrinsicTriangulationsRef
/// \brief how a run of `flip_to_Delaunay()` ended.
enum class Flip_status {
  DELAUNAY,        ///< every edge that is not constrained is Delaunay
  NOT_FLIPPABLE,   ///< some edge is not Delaunay, but its hinge has no other diagonal
  INCONSISTENT,    ///< some edge is not Delaunay although it was just flipped: rounded decisions
                   ///< contradict each other near a tie
  UNDECIDED,       ///< the number type could not decide some edge
  BUDGET_EXHAUSTED ///< the flip budget did not suffice
};

/// \ingroup PkgIntrinsicTriangulationsRef
/// \brief the result of a run of `flip_to_Delaunay()`.
struct Flip_report
{
  Flip_status status = Flip_status::DELAUNAY; ///< how the run ended
  std::uint64_t flips = 0;                    ///< the number of flips
  std::uint64_t tests = 0;                    ///< the number of Delaunay tests
  std::vector<Edge_index> not_flippable;      ///< the edges that are not Delaunay, but have no other diagonal
  std::vector<Edge_index> inconsistent; ///< the edges that are not Delaunay although a flip should have made them so
  std::vector<Edge_index> undecided;    ///< the edges that the number type could not decide
};

/// \ingroup PkgIntrinsicTriangulationsInsertion
/// \brief why a face does not meet the criteria.
enum class Refinement_obstacle {
  CONE,              ///< a corner at a vertex with so small an angle sum, or a point that would be too close to one
  SMALL_INPUT_ANGLE, ///< a corner between two edges that must not be flipped
  BESIDE_SMALL_INPUT_ANGLE, ///< its shortest side joins points on two such edges, at the same distance from their corner
  UNREPRESENTABLE,          ///< doubles are too coarse for the point that the face needs
  TOO_SMALL,                ///< a side or a height is shorter than the smallest size
  WHOLE_EDGE,               ///< an edge that must not be split is in the way
  BUDGET                    ///< the budget did not suffice
};

/// \ingroup PkgIntrinsicTriangulationsInsertion
/// \brief the number of these reasons.
constexpr std::size_t number_of_refinement_obstacles = 7;

/// \ingroup PkgIntrinsicTriangulationsInsertion
/// \brief a face that does not meet the criteria.
struct Unrefined_face
{
  Face_index face;            ///< the face
  Refinement_obstacle reason; ///< why it was left
};

/// \ingroup PkgIntrinsicTriangulationsInsertion
/// \brief the information that a visitor of `refine_Delaunay()` gets before each step.
struct Refinement_progress
{
  std::uint64_t points = 0; ///< new vertices so far
  std::size_t waiting_faces =
    0;             ///< an upper bound on the faces that do not meet the criteria: some of them may meet them by now
  double size = 0; ///< the shortest side of the face that is next, in the unit of the input
  Face_index face; ///< that face
  double minimum_size = 0; ///< the smallest size, given or chosen for now
  /// whether a smallest size may still be chosen that leaves this face: then refinement begins anew
  bool is_on_trial = false;
  /// a rough estimate of the vertices still needed by faces that are too large, and by thin ones whose shortest
  /// sides are of that size. It is computed from the areas of these faces at 1024 new vertices and whenever their
  /// number has doubled
  std::uint64_t estimated_points = 0;
};

/// \ingroup PkgIntrinsicTriangulationsInsertion
/// \brief how a run of `refine_Delaunay()` ended.
enum class Refinement_status {
  REFINED,         ///< all faces meet the criteria except those listed with a reason other than `BUDGET`
  BUDGET_EXHAUSTED ///< the maximum number of new vertices was reached
};

/// \ingroup PkgIntrinsicTriangulationsInsertion
/// \brief the result of a run of `refine_Delaunay()`.
struct Refinement_report
{
  Refinement_status status = Refinement_status::REFINED; ///< how the run ended
  std::uint64_t insertions = 0;                          ///< the number of vertices inserted into faces
  std::uint64_t segment_splits = 0;                      ///< the number of vertices inserted on edges
  std::uint64_t flips = 0;                               ///< the number of flips, also before the first vertex
  std::vector<Unrefined_face> unrefined;                 ///< the faces that do not meet the criteria, in order
  double minimum_size = 0; ///< the smallest size, given or chosen, in the unit of the input

  /// returns whether all faces meet the criteria. Complexity: constant.
  bool is_refined() const { return status == Refinement_status::REFINED && unrefined.empty(); }

  /// returns how many faces were left for each reason, by `Refinement_obstacle`. O(number of these faces).
  std::array<std::size_t, number_of_refinement_obstacles> numbers_by_reason() const
  {
    std::array<std::size_t, number_of_refinement_obstacles> result{};
    for (const Unrefined_face& left : unrefined)
      ++result[std::size_t(left.reason)];
    return result;
  }
};

/// \ingroup PkgIntrinsicTriangulationsGeodesics
/// \brief the status of a path of a `Geodesic_path_network`.
enum class Geodesic_status {
  GEODESIC,     ///< locally shortest: at each inner vertex that is not fixed, the angles on both sides are at least π
  CONTRACTIBLE, ///< a closed curve that was shrunk to a point
  BLOCKED,      ///< it can only be shortened over an edge of the network, or over edges that cannot be flipped
  NOT_IMPROVABLE, ///< a loop of one edge that is not a geodesic, for which no shorter path of edges was found
  UNFINISHED      ///< the budget did not suffice, or an exception ended the run
};

/// \ingroup PkgIntrinsicTriangulationsGeodesics
/// \brief the result of `Geodesic_path_network::shorten()`.
struct Geodesic_report
{
  /// the worst status of all paths, in the order of the enumeration; a contractible one does not worsen it
  Geodesic_status status = Geodesic_status::GEODESIC;
  std::uint64_t flips = 0; ///< the number of flips
  std::uint64_t steps = 0; ///< how often a part of a path was replaced by a shorter one
  std::uint64_t tests = 0; ///< the number of edges examined
};

/// \ingroup PkgIntrinsicTriangulationsMetric
/// \brief the stages of an exact Delaunay test, each taken when those before cannot decide.
enum class Stage {
  FILTER,         ///< the stored squared lengths and areas with their error bounds
  COPLANAR,       ///< both faces lie in one plane in space: the in-circle test of four points
  UNFOLDING,      ///< the unfolding over the input triangles, in double-doubles with error bounds
  MULTIPRECISION, ///< the unfolding in MPFR intervals
  ALGEBRAIC,      ///< the unfolding in exact numbers: most often a proof of zero
  CONGRUENCE,     ///< a tie: both halves of the quadrilateral run over mirror images in the input
  MODULAR         ///< a tie, with an error below 2<sup>-128</sup>: zero in several finite fields
};
/// \ingroup PkgIntrinsicTriangulationsMetric
/// \brief the number of stages.
constexpr std::size_t number_of_stages = 7;

/// \ingroup PkgIntrinsicTriangulationsMetric
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
  /// adds the counts of another object.
  Stage_counts& operator+=(const Stage_counts& other)
  {
    for (std::size_t i = 0; i < number_of_stages; ++i)
      decided[i] += other.decided[i];
    ties += other.ties;
    return *this;
  }
};

/// \ingroup PkgIntrinsicTriangulationsMetric
/// \brief which proof exact decisions require that a number is zero, that is, for a tie.
///
/// That a number is *not* zero, and its sign, is always proven.
enum class Tie_proof {
  /// A tie is proven if that takes little time. If not, it is accepted after a test that takes a nonzero number for
  /// zero with a probability below 2<sup>-128</sup>, over the choice of random primes from a fixed seed. So every
  /// decision succeeds.
  PROBABLE_IF_COSTLY,
  /// A tie is proven, or the decision ends with an `Undecided_error`: the time that the proof takes can double with
  /// each square root that is independent of the others.
  PROVEN
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_REPORTS_H
