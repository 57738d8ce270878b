// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Judges the result of a system by the exact one.
//
// RIGHT: the triangles are those of a Delaunay triangulation of the surface, which an exact test of all edges confirms,
// and lengths (or entries of the Laplacian, or counts of crossings) are those of the exact result up to rounding
// (`rounding_tolerance`). CLOSE: some edges are not Delaunay, but within `tie_tolerance` of a tie, or numbers are off
// by at most `close_tolerance`. WRONG: everything else.

#ifndef IDT_BENCHMARK_SYSTEMS_JUDGE_H
#define IDT_BENCHMARK_SYSTEMS_JUDGE_H

#include "match_triangles.h"

#include <CGAL/Intrinsic_triangulations/Laplace_Beltrami.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/verify_Delaunay.h>

#include <Eigen/Sparse>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace systems {

constexpr double rounding_tolerance = 1e-6;
constexpr double close_tolerance = 1e-3;

enum class Verdict {
  RIGHT,
  CLOSE,
  WRONG
};

struct Judgement
{
  Verdict verdict = Verdict::RIGHT;
  std::string why;             // empty if right
  double largest_error = 0;    // of lengths, relative, or of the matrix, relative to the diagonal
  std::size_t wrong_faces = 0; // edges of theirs in no Delaunay triangulation of the surface
  std::size_t wrong_edges = 0; // not Delaunay, but nearly ties

  void lower(Verdict to, const std::string& because)
  {
    verdict = (std::max)(verdict, to);
    why += (why.empty() ? "" : "; ") + because;
  }
};

namespace internal {

inline std::string text_of(double number)
{
  std::ostringstream os;
  os.precision(2);
  os << number;
  return os.str();
}

inline void judge_error(double error, const std::string& name, Judgement& judgement)
{
  judgement.largest_error = error;
  if (!(error <= rounding_tolerance)) // NaN is not
    judgement.lower(error <= close_tolerance ? Verdict::CLOSE : Verdict::WRONG, name + " off by " + text_of(error));
}

// Whether they are triangles at all, with as many faces as ours.
inline bool is_triangulation(const Triangles& theirs, const IT::Delta_complex& ours)
{
  const std::size_t size = theirs.number_of_sides();
  if (theirs.corners.size() != ours.number_of_faces() || theirs.opposite.size() != size ||
      theirs.lengths.size() != size)
    return false;
  for (std::size_t side = 0; side < size; ++side) {
    const std::int64_t opposite = theirs.opposite[side];
    if (theirs.source(side) >= ours.number_of_vertices() || opposite >= std::int64_t(size) ||
        (opposite >= 0 && theirs.opposite[std::size_t(opposite)] != std::int64_t(side)))
      return false;
  }
  return true;
}

inline Judgement judge_triangles(const Own_triangulation& exact, const Result& result, bool with_overlay)
{
  Judgement judgement;
  const Triangles& theirs = result.triangles;
  if (!is_triangulation(theirs, exact.connectivity())) {
    judgement.lower(Verdict::WRONG, "no triangulation with these vertices and as many faces");
    return judgement;
  }
  const Match match(exact, theirs);
  if (!match.is_complete()) {
    judgement.wrong_faces = theirs.corners.size() - match.number_of_faces();
    judgement.lower(Verdict::WRONG, judgement.wrong_faces > 0
                                      ? std::to_string(judgement.wrong_faces) + " of " +
                                          std::to_string(theirs.corners.size()) + " faces are not Delaunay"
                                      : "sides are glued in another way");
    return judgement;
  }
  // Our triangulation with their diagonals, so this is a verdict about theirs.
  const IT::Delaunay_verification verification = IT::verify_Delaunay(match.triangulation());
  judgement.wrong_edges = verification.not_Delaunay.size();
  if (!verification.inverted.empty())
    judgement.lower(Verdict::WRONG, std::to_string(verification.inverted.size()) + " faces are inverted");
  if (judgement.wrong_edges > 0)
    judgement.lower(Verdict::CLOSE, std::to_string(judgement.wrong_edges) + " edges nearly ties");

  double error = 0;
  std::size_t wrong_counts = 0;
  for (std::size_t side = 0; side < theirs.number_of_sides(); ++side) {
    const IT::Edge_index e = match.triangulation().connectivity().edge(match.halfedge(side));
    const double length = match.triangulation().length(e), theirs_relative = theirs.lengths[side] / length;
    error = std::isfinite(theirs_relative) ? (std::max)(error, std::abs(theirs_relative - 1))
                                           : std::numeric_limits<double>::infinity();
    if (std::isinf(error))
      break;
    if (with_overlay &&
        (result.crossings.size() <= side || result.crossings[side] != match.triangulation().number_of_crossings(e)))
      ++wrong_counts;
  }
  judge_error(error, "lengths", judgement);
  if (wrong_counts > 0)
    judgement.lower(Verdict::WRONG, std::to_string(wrong_counts) + " sides cross other numbers of input edges");
  return judgement;
}

// The largest difference between two entries, relative to the diagonal entries of row and column.
inline Judgement judge_Laplacian(const Own_triangulation& exact, const Result& result)
{
  Judgement judgement;
  const Eigen::SparseMatrix<double> ours = IT::stiffness_matrix(exact);
  std::vector<Eigen::Triplet<double>> entries;
  for (const Matrix_entry& entry : result.Laplacian) {
    if (entry.row >= ours.rows() || entry.column >= ours.cols() || !std::isfinite(entry.value)) {
      judgement.lower(Verdict::WRONG, "an entry is not finite, or has no place");
      return judgement;
    }
    entries.emplace_back(int(entry.row), int(entry.column), entry.value);
  }
  Eigen::SparseMatrix<double> theirs(ours.rows(), ours.cols());
  theirs.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SparseMatrix<double> difference = ours - theirs;
  const Eigen::VectorXd diagonal = ours.diagonal();
  double error = 0;
  for (int k = 0; k < difference.outerSize(); ++k)
    for (Eigen::SparseMatrix<double>::InnerIterator it(difference, k); it; ++it)
      if (it.value() != 0)
        error = (std::max)(error, std::abs(it.value()) / std::sqrt(diagonal[it.row()] * diagonal[it.col()]));
  judge_error(error, "entries", judgement);
  return judgement;
}

} // namespace internal

// \exception IT::Error if the input is not a surface, or if the exact decisions cannot be made
inline Judgement judge(const std::string& task, const Surface& surface, const Result& result)
{
  Own_triangulation exact = make_own_triangulation(surface);
  if (triangles_of(exact.connectivity()).corners != surface.triangles.corners)
    throw std::logic_error("the corners of the surface are numbered in another way");
  IT::flip_to_Delaunay(exact);
  // Not taken for granted: the exact result is tested again in another way.
  if (!IT::verify_Delaunay(exact).is_Delaunay())
    throw std::logic_error("the exact result is not Delaunay");
  return task == "Laplacian" ? internal::judge_Laplacian(exact, result)
                             : internal::judge_triangles(exact, result, task == "overlay");
}

} // namespace systems

#endif // IDT_BENCHMARK_SYSTEMS_JUDGE_H
