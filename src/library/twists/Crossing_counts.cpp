// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Tubes, and how flips and twists change the numbers of crossings.

#include <CGAL/Intrinsic_triangulations/untwist.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

namespace {

Integer visible(const Integer& count) { return count < 0 ? Integer(0) : count; }

// The number of segments that cut off the corner between sides crossed a and b times; the third side is crossed c
// times.
Integer cut_off(const Integer& a, const Integer& b, const Integer& c)
{
  return (std::min)((std::min)(a, b), visible(Integer((a + b - c) / 2)));
}

// The number of segments from a corner to the opposite side, which is crossed `far` times; the sides at the corner are
// crossed a and b times.
Integer leaving(const Integer& far, const Integer& a, const Integer& b) { return visible(far - a - b); }

// The count of the other diagonal, kl, of the hinge of ij; the formulas are explained at Normal_coordinates::flip().
Integer flipped(const Integer& ij, const Integer& jk, const Integer& ki, const Integer& il, const Integer& lj)
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

} // namespace

bool is_tube(const Delta_complex& complex, Halfedge_index loop)
{
  if (complex.is_border(loop))
    return false;
  const Halfedge_index right = complex.opposite(complex.next(loop)), left = complex.opposite(complex.prev(loop));
  return !complex.is_border(right) && complex.face(right) != complex.face(loop) && complex.next(right) == left;
}

Tube tube(const Delta_complex& complex, Halfedge_index loop)
{
  CGAL_precondition(is_tube(complex, loop));
  const Halfedge_index right = complex.next(loop), left = complex.prev(loop);
  return {loop, complex.next(complex.opposite(left)), complex.edge(right), complex.edge(left)};
}

void Crossing_counts::flip(const Delta_complex& complex, Edge_index e)
{
  CGAL_precondition(complex.is_flippable(e));
  flip(complex, complex.hinge(e));
}

void Crossing_counts::after_flip(const Delta_complex& complex, Edge_index e)
{
  const Halfedge_index h = complex.halfedge(e), g = complex.opposite(h);
  flip(complex, Hinge_halfedges{h, complex.prev(g), complex.next(h), g, complex.prev(h), complex.next(g)});
}

void Crossing_counts::twist(const Delta_complex& complex, const Tube& tube, const Integer& power)
{
  CGAL_precondition(power % 4 == 0);
  Twisted_pair pair(count(tube.loop, complex), count(tube.other, complex));
  Integer &right = counts_[tube.right.idx()], &left = counts_[tube.left.idx()];
  if (power >= 0)
    pair.advance(right, left, power);
  else
    pair.advance(left, right, -power);
}

void Crossing_counts::flip(const Delta_complex& complex, const Hinge_halfedges& around)
{
  Integer& ij = counts_[complex.edge(around.ij).idx()];
  ij = flipped(ij, count(around.jk, complex), count(around.ki, complex), count(around.il, complex),
               count(around.lj, complex));
}

} // namespace CGAL::Intrinsic_triangulations
