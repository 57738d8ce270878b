// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// How often each edge crosses the input, in integers of any size; and tubes, around which edges can wind.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TWISTS_CROSSING_COUNTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TWISTS_CROSSING_COUNTS_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Rational.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsTwists
/// \brief two faces that share two edges, and whose other sides are loops: a tube.
///
/// The two shared edges run across the tube. Seen with `loop` at the bottom, from left to right, one is to the left of
/// the upper corner of the first face and one to its right: the face is (i, i, q), with the sides `loop`, `next(loop)`
/// and `prev(loop)`.
struct Tube
{
  Halfedge_index loop;  ///< one side, with the tube to its left
  Halfedge_index other; ///< the other side, with the tube to its left
  Edge_index right;     ///< the edge of `next(loop)`
  Edge_index left;      ///< the edge of `prev(loop)`
};

/// \ingroup PkgIntrinsicTriangulationsTwists
/// \brief returns whether the face to the left of `loop` and another one form a `Tube` with `loop` as one of its sides.
/// O(1).
///
/// This depends on the connectivity alone. `loop` and `other` may be the same edge, as on a torus.
inline bool is_tube(const Delta_complex& complex, Halfedge_index loop)
{
  if (complex.is_border(loop))
    return false;
  const Halfedge_index right = complex.opposite(complex.next(loop)), left = complex.opposite(complex.prev(loop));
  return !complex.is_border(right) && complex.face(right) != complex.face(loop) && complex.next(right) == left;
}

/// \ingroup PkgIntrinsicTriangulationsTwists
/// \brief returns the tube to the left of `loop`. O(1). \pre `is_tube(complex, loop)`
inline Tube tube(const Delta_complex& complex, Halfedge_index loop)
{
  CGAL_precondition(is_tube(complex, loop));
  const Halfedge_index right = complex.next(loop), left = complex.prev(loop);
  return {loop, complex.next(complex.opposite(left)), complex.edge(right), complex.edge(left)};
}

/// \ingroup PkgIntrinsicTriangulationsMetric
/// \brief an integer of any size, exact: Boost.Multiprecision's, without expression templates
using Integer = internal::Integer;

/// \ingroup PkgIntrinsicTriangulationsTwists
///
/// \brief how often each edge of a triangulation crosses edges of the one that it was flipped from, as integers of any
/// size.
///
/// The same numbers as in `Normal_coordinates`, which stop at 2^60 and also know the order of crossings. These follow
/// flips and whole powers of twists.
class Crossing_counts
{
public:
  /// constructs the counts of an empty triangulation.
  Crossing_counts() = default;
  /// constructs the counts of a triangulation in itself. O(edges).
  explicit Crossing_counts(const Delta_complex& input) : counts_(input.number_of_edges(), Integer(-1)) {}

  /// returns the number of edges.
  std::size_t number_of_edges() const { return counts_.size(); }
  /// returns the number of times that input edges cross `e`, or −1 if `e` coincides with one.
  const Integer& crossings(Edge_index e) const { return counts_[e.idx()]; }
  /// returns whether `e` coincides with an input edge.
  bool is_original(Edge_index e) const { return crossings(e) < 0; }
  /// returns the number of times that input edges cross `e`.
  Integer number_of_crossings(Edge_index e) const { return is_original(e) ? Integer(0) : crossings(e); }

  /// \brief updates the counts for the flip of `e`; to be called before that of the connectivity.
  ///
  /// O(1) operations with integers.
  /// \pre `complex.is_flippable(e)`
  void flip(const Delta_complex& complex, Edge_index e)
  {
    CGAL_precondition(complex.is_flippable(e));
    flip(complex, complex.hinge(e));
  }

  /// \brief updates the counts for the flip of `e` that `complex.flip(e)` has just made, as the visitor of
  /// `flip_to_Delaunay()` reports it.
  void after_flip(const Delta_complex& complex, Edge_index e)
  {
    const Halfedge_index h = complex.halfedge(e), g = complex.opposite(h);
    flip(complex, Hinge_halfedges{h, complex.prev(g), complex.next(h), g, complex.prev(h), complex.next(g)});
  }

  /// \brief updates the counts for `|power|` flips within a tube, a multiple of four, which leaves the connectivity
  /// unchanged.
  ///
  /// A positive power turns the far side of the tube to the right, with its side at the bottom: the vector of an
  /// edge from the bottom to the top grows by `power` times that of the side. O(1) operations with integers.
  void twist(const Delta_complex& complex, const Tube& tube, const Integer& power)
  {
    CGAL_precondition(power % 4 == 0);
    Twisted_pair pair(count(tube.loop, complex), count(tube.other, complex));
    Integer &right = counts_[tube.right.idx()], &left = counts_[tube.left.idx()];
    if (power >= 0)
      pair.advance(right, left, power);
    else
      pair.advance(left, right, -power);
  }

private:
  static Integer visible(const Integer& count) { return count < 0 ? Integer(0) : count; }
  Integer count(Halfedge_index h, const Delta_complex& complex) const { return number_of_crossings(complex.edge(h)); }

  // The number of segments that cut off the corner between sides crossed a and b times; the third side is crossed c
  // times.
  static Integer cut_off(const Integer& a, const Integer& b, const Integer& c)
  {
    return (std::min)((std::min)(a, b), visible(Integer((a + b - c) / 2)));
  }
  // The number of segments from a corner to the opposite side, which is crossed `far` times; the sides at the corner
  // are crossed a and b times.
  static Integer leaving(const Integer& far, const Integer& a, const Integer& b) { return visible(far - a - b); }

  // The count of the other diagonal, kl, of the hinge of ij; the formulas are explained at Normal_coordinates::flip().
  static Integer flipped(const Integer& ij, const Integer& jk, const Integer& ki, const Integer& il, const Integer& lj)
  {
    const Integer n_ij = visible(ij);
    const Integer above_i = cut_off(n_ij, ki, jk), above_j = cut_off(n_ij, jk, ki);
    const Integer below_i = cut_off(n_ij, il, lj), below_j = cut_off(n_ij, lj, il);
    const Integer from_k = n_ij - above_i - above_j, from_l = n_ij - below_i - below_j;
    // Counted from i, the segments that end in k cross ij after above_i others, and those that end in l after below_i
    // others.
    if ((std::max)(above_i, below_i) < (std::min)(Integer(above_i + from_k), Integer(below_i + from_l)))
      return -1;
    return (std::max)(Integer(jk - above_j), Integer(ki - above_i)) +
           (std::max)(Integer(lj - below_j), Integer(il - below_i)) + visible(above_i - below_i - from_l) +
           visible(below_i - above_i - from_k) + (ij < 0 ? 1 : 0);
  }

  void flip(const Delta_complex& complex, const Hinge_halfedges& around)
  {
    Integer& ij = counts_[complex.edge(around.ij).idx()];
    ij = flipped(ij, count(around.jk, complex), count(around.ki, complex), count(around.il, complex),
                 count(around.lj, complex));
  }

  // The counts n(k) of the edges u_k = u_0 + k a across a tube, two consecutive ones of which exist at a time. Each
  // segment through the tube adds |k − p|, up to 1/2 or 1 next to p, and no two of the numbers p differ by more than
  // one. So n(k) falls by the number N of segments up to two steps before the mean of p, and rises by N from two steps
  // after it.
  class Twisted_pair
  {
  public:
    Twisted_pair(Integer a, Integer b) : a_(std::move(a)), b_(std::move(b)) {}

    // From n(0) and n(1) to n(m) and n(m + 1).
    void advance(Integer& first, Integer& second, Integer m) const
    {
      const Integer x = visible(first), y = visible(second);
      const Integer from_bottom =
        leaving(x, a_, y) + leaving(y, a_, x) + leaving(b_, x, y) + (first < 0 ? 1 : 0) + (second < 0 ? 1 : 0);
      const Integer n = a_ + from_bottom, ends = from_bottom + n - b_;
      while (m > 0) {
        const Integer slope = visible(second) - visible(first);
        Integer steps(0);
        if (slope == n)
          steps = m;
        else if (slope == -n) // up to three steps before the mean, which is rounded down
          steps = (std::min)(m, Integer((2 * first + ends) / (2 * n) - 3));
        if (steps > 0) {
          first += steps * slope;
          second += steps * slope;
          m -= steps;
        } else {
          Integer third = flipped(first, visible(second), a_, visible(second), b_);
          first = std::move(second);
          second = std::move(third);
          m -= 1;
        }
      }
    }

  private:
    Integer a_, b_; // of the two sides
  };

  std::vector<Integer> counts_;
};

/// \ingroup PkgIntrinsicTriangulationsTwists
/// \brief consecutive flips within one tube.
struct Twist
{
  Halfedge_index loop; ///< a side of the tube, with the tube to its left
  Integer
    power; ///< the number of flips; positive if they turn the far side to the right, as `Crossing_counts::twist()` explains
};

/// \ingroup PkgIntrinsicTriangulationsTwists
/// \brief what `untwist()` did.
struct Untwisting
{
  std::vector<Twist> twists;         ///< in order; each tube belongs to the triangulation that earlier twists leave
  Integer number_of_flips = 0;       ///< of all twists together
  std::uint64_t number_of_steps = 0; ///< how many of those flips were made one by one
  Crossing_counts crossings;         ///< how often each edge crosses edges of the complex that was given
  bool is_complete = true;           ///< `false` if the visitor ended it: then some tubes are left as they were
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TWISTS_CROSSING_COUNTS_H
