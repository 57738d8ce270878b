// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definition of untwist().

#include <CGAL/Intrinsic_triangulations/untwist.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Rational.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {
namespace internal {

// Works on one pair of faces after the other. Meanwhile the squared lengths of its edges are integers over a common
// denominator: fractions would be reduced at each step.
class Tube_straightener
{
public:
  Tube_straightener(Delta_complex& complex, std::vector<Rational>& squared_lengths,
                    const std::function<bool(Edge_index)>& is_constrained,
                    const std::function<bool(std::uint64_t, std::uint64_t)>& go_further)
    : complex_(complex), squared_lengths_(squared_lengths), is_constrained_(is_constrained), go_further_(go_further)
  {
    result_.crossings = Crossing_counts(complex);
  }

  Untwisting run()
  {
    for (Face_index f : complex_.faces()) {
      if ((f.idx() % 256 == 0 && !goes_further()) || !straighten_tubes_of(f)) {
        result_.is_complete = false;
        break;
      }
    }
    return std::move(result_);
  }

private:
  bool goes_further() const { return go_further_(number_of_tubes_, result_.number_of_steps); }

  // Returns whether the visitor lets it go on.
  bool straighten_tubes_of(Face_index f)
  {
    bool is_loaded = false, has_changed = true, is_changed = false, goes_on = true;
    // A torus has three tubes, and each changes the others; on other surfaces the second round finds nothing to do.
    while (has_changed && goes_on) {
      // The tube around the shortest side: the other tubes of a torus can have about as many flips, one at a time.
      std::optional<Tube> shortest;
      Halfedge_index loop = complex_.halfedge(f);
      for (int i = 0; i < 3; ++i, loop = complex_.next(loop)) {
        if (!is_tube(complex_, loop))
          continue;
        const Tube tube = Intrinsic_triangulations::tube(complex_, loop);
        if (!is_flat(tube) || is_constrained_(tube.left) || is_constrained_(tube.right))
          continue;
        if (!is_loaded)
          load(tube);
        is_loaded = true;
        if (!shortest || number(complex_.edge(loop)) < number(complex_.edge(shortest->loop)))
          shortest = tube;
      }
      has_changed = shortest && straighten(*shortest);
      is_changed = is_changed || has_changed;
      if (has_changed)
        goes_on = goes_further();
    }
    if (is_changed)
      store();
    return goes_on;
  }

  bool is_flat(const Tube& tube) const
  {
    const Edge_index bottom = complex_.edge(tube.loop), top = complex_.edge(tube.other);
    return bottom == top || squared_lengths_[bottom.idx()] == squared_lengths_[top.idx()];
  }

  void load(const Tube& tube)
  {
    ++number_of_tubes_;
    edges_ = {complex_.edge(tube.loop), complex_.edge(tube.other), tube.left, tube.right};
    denominator_ = 1;
    for (Edge_index e : edges_)
      denominator_ = lcm(denominator_, denominator(squared_lengths_[e.idx()]));
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const Rational& s = squared_lengths_[edges_[i].idx()];
      numbers_[i] = numerator(s) * (denominator_ / denominator(s));
    }
  }

  void store()
  {
    for (Edge_index e : edges_)
      squared_lengths_[e.idx()] = Rational(number(e), denominator_);
  }

  Integer& number(Edge_index e)
  {
    std::size_t i = 0;
    while (edges_[i] != e)
      ++i;
    return numbers_[i];
  }

  // Returns whether there was something to do.
  bool straighten(const Tube& tube)
  {
    const Integer &side = number(complex_.edge(tube.loop)), &right = number(tube.right), &left = number(tube.left);
    const Integer sum = side + right - left;
    if (side <= 0 || 4 * side * right - sum * sum <= 0)
      return false; // no area, or not a triangle: others report it
    const Integer power = power_of(side, right, left);
    if (power == 0)
      return false;
    const Integer rest = power % 4, jump = power - rest;
    if (jump != 0)
      leap(tube, jump);
    const int steps = rest.convert_to<int>(), number_of_steps = steps < 0 ? -steps : steps;
    for (int i = 0; i < number_of_steps; ++i)
      turn(tube.loop, steps > 0);
    result_.twists.push_back({tube.loop, power});
    result_.number_of_flips +=
      boost::multiprecision::abs(power); // CGAL::abs() would name traits that its boost_mp.h specializes
    result_.number_of_steps += std::uint64_t(number_of_steps);
    return true;
  }

  // How many flips Lawson's algorithm makes in a tube, and in which direction. Laid out with the side from (0, 0) to
  // (c, 0), the right edge leads from (c, 0) to (c + x, h) and the left one from (0, 0) to (x + c, h). The right one is
  // flipped if x + c < 0, the left one if x > 0.
  static Integer power_of(const Integer& side, const Integer& right, const Integer& left)
  {
    const Integer twice_x_c = left - right - side, twice_c_c = 2 * side;
    if (twice_x_c + twice_c_c < 0)
      return (-twice_x_c - 1) / twice_c_c;
    if (twice_x_c > 0)
      return -((twice_x_c + twice_c_c - 1) / twice_c_c);
    return 0;
  }

  // A multiple of four flips: they leave the connectivity as it was.
  void leap(const Tube& tube, const Integer& power)
  {
    const Integer& side = number(complex_.edge(tube.loop));
    Integer &right = number(tube.right), &left = number(tube.left);
    const Integer twice_x_c = left - right - side;
    left += power * (twice_x_c + (power + 2) * side);
    right += power * (twice_x_c + power * side);
    result_.crossings.twist(complex_, tube, power);
  }

  void turn(Halfedge_index loop, bool is_to_right)
  {
    const Tube tube = Intrinsic_triangulations::tube(complex_, loop);
    const Edge_index e = is_to_right ? tube.right : tube.left, other = is_to_right ? tube.left : tube.right;
    // The diagonals of a parallelogram
    Integer& s = number(e);
    s = 2 * (number(complex_.edge(tube.loop)) + number(other)) - s;
    result_.crossings.flip(complex_, e);
    complex_.flip(e);
  }

  Delta_complex& complex_;
  std::vector<Rational>& squared_lengths_;
  const std::function<bool(Edge_index)>& is_constrained_;
  const std::function<bool(std::uint64_t, std::uint64_t)>& go_further_;
  Untwisting result_;
  std::uint64_t number_of_tubes_ = 0;

  // The edges of the pair of faces at hand. A torus has only three; an edge that occurs twice has the first of its
  // numbers.
  std::array<Edge_index, 4> edges_;
  std::array<Integer, 4> numbers_;
  Integer denominator_;
};

Untwisting untwist(Delta_complex& complex, std::vector<Rational>& squared_lengths,
                   const std::function<bool(Edge_index)>& is_constrained,
                   const std::function<bool(std::uint64_t, std::uint64_t)>& go_further)
{
  if (squared_lengths.size() != complex.number_of_edges())
    throw Invalid_surface_error(Invalid_surface_error::Defect::OUT_OF_RANGE, squared_lengths.size(), 1,
                                "there are " + std::to_string(squared_lengths.size()) + " squared lengths for " +
                                  std::to_string(complex.number_of_edges()) + " edges");
  // Works on copies, so that an exception leaves everything unchanged.
  Delta_complex result_complex = complex;
  std::vector<Rational> result_lengths = squared_lengths;
  Untwisting result = Tube_straightener(result_complex, result_lengths, is_constrained, go_further).run();
  complex = std::move(result_complex);
  squared_lengths = std::move(result_lengths);
  return result;
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations
