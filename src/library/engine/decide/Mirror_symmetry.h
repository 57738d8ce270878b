// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Ties due to a symmetry of the input: a proof by congruence.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_DECIDE_MIRROR_SYMMETRY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_DECIDE_MIRROR_SYMMETRY_H

#include <CGAL/Intrinsic_triangulations/internal/engine/history/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Crossed_halfedges.h>
#include "../layout/metric_images.h"
#include "../../measures/Flat_geometry.h"
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Rational.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/With_error.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Let z, a, b, c be the corners of the hinge of an edge, counterclockwise. If a reflection of the plane in which the
// hinge is laid out maps a ↔ b and z ↔ c, then the hinge is an isosceles trapezoid, and its edge is a tie, given that
// both faces have positive area. That is the case for two points and their mirror images in a symmetric mesh.
//
// The strip of a side turns around one vertex after the other, on its left or on its right. The segments from each to
// the next form a path from z by a and b to c, and its angle at a vertex is a sum of angles of input triangles, in any
// order. If lengths and angles of the path are the same from both ends, there is such a reflection; the middle, a
// length or an angle, does not matter. Triangles in one plane form a polygon, however it was cut. Time: as many
// comparisons of rational numbers, or sorting by them.
class Mirror_symmetry
{
public:
  Mirror_symmetry(const Delta_complex& complex, const Correspondence& correspondence, Input_surface& surface)
    : complex_(complex), correspondence_(correspondence), input_(correspondence.input()), surface_(surface),
      points_(surface.metric().points())
  {}

  // Whether the hinge of e is proven to be symmetric in this way.
  bool operator()(Edge_index e)
  {
    const Halfedge_index ij = complex_.halfedge(e), ji = complex_.opposite(ij);
    for (Halfedge_index h : {ij, complex_.next(ij), ji, complex_.next(ji)})
      if (correspondence_.is_inserted(complex_.target(h))) // it does not begin in a corner of an input triangle
        return false;
    Side sides[] = {side(complex_.next(ji), 2), side(complex_.prev(ji), 1), side(complex_.next(ij), 2),
                    side(complex_.prev(ij), 1)};
    for (int i = 0; i < 4; ++i)
      if (swaps_ends(sides[(i + 3) % 4], sides[i], sides[(i + 1) % 4]))
        return true;
    return false;
  }

private:
  // An input vertex, as the source of a halfedge in the current face, or in its plane.
  using Node = Halfedge_index;

  // The corners of the hinge, counterclockwise.
  struct Side
  {
    Halfedge_index halfedge;
    int number_of_corners;             // of the hinge at its source
    Node source, target;               // in the first triangle and in the last
    std::vector<Halfedge_index> folds; // the edges between two planes that it crosses, from left to right
    bool is_left_of_one = true;        // the end of a single one around which it turns
  };

  struct Segment
  {
    Node p, q;
  };
  // The angle from p to q around v, in one plane: to the left if `side` is positive.
  struct Corner
  {
    Node v, p, q;
    Sign side;
  };
  // An angle of the path, the sum of the corners from one number up to that of the next turn.
  struct Turn
  {
    std::size_t first_corner;
    bool is_around_left;
  };

  Side side(Halfedge_index h, int number_of_corners)
  {
    if (is_original(h)) {
      const Halfedge_index along = correspondence_.input_halfedge(h);
      return {h, number_of_corners, along, input_.next(along), {}};
    }
    const Crossed_halfedges crossed(complex_, correspondence_, h, surface_.interruption());
    Side result{h,
                number_of_corners,
                input_.prev(input_.opposite(crossed.front())),
                input_.prev(crossed[crossed.size() - 1]),
                {}};
    for (std::size_t i = 0; i < crossed.size(); ++i)
      if (!surface_.is_flat(crossed[i]))
        result.folds.push_back(crossed[i]);
    return result;
  }

  // The ends of a fold, from the face behind it and from the face before it.
  static Node left_behind(Halfedge_index fold) { return fold; }
  Node right_behind(Halfedge_index fold) const { return input_.next(fold); }
  Node left_before(Halfedge_index fold) const { return input_.next(input_.opposite(fold)); }
  Node right_before(Halfedge_index fold) const { return input_.opposite(fold); }

  bool is_same(Node p, Node q) const { return p == q || (!points_.empty() && input_.source(p) == input_.source(q)); }

  // For three sides za, ab, bc in succession.
  bool swaps_ends(Side& za, Side& ab, Side& bc)
  {
    if (za.folds.size() != bc.folds.size())
      return false;
    if (ab.folds.size() == 1)
      ab.is_left_of_one = have_equal_lengths({ab.source, left_before(ab.folds[0])}, {ab.folds[0], ab.target});
    for (bool is_left : {true, false}) {
      za.is_left_of_one = bc.is_left_of_one = is_left;
      if (is_symmetric_path(za, ab, bc))
        return true;
      if (za.folds.size() != 1)
        break;
    }
    return false;
  }

  // Equal turns imply that the path has as many segments up to a as from b on, since both sides have equally many
  // folds: if za had fewer segments, its turns would equal those of a part of bc with as many corners. But a side has
  // one more corner than folds, and another one for each segment between two turns to the left. At the other end of a
  // part there is one fold less, or no corner before its first one, after a turn to the other side.
  bool is_symmetric_path(const Side& za, const Side& ab, const Side& bc)
  {
    path_.clear();
    turns_.clear();
    corners_.clear();
    is_defined_ = true;
    add_turn(za, add(za), ab);
    add_turn(ab, add(ab), bc);
    add(bc);
    if (!is_defined_)
      return false;
    turns_.push_back({corners_.size(), true}); // where the last one ends
    for (std::size_t i = 0, j = path_.size() - 1; i < j; ++i, --j)
      if (!have_equal_lengths(path_[i], path_[j]) || (i + 1 < j && !are_mirrored_turns(i, j - 1)))
        return false;
    return true;
  }

  // Whether a side turns around the left ends of a fold and of the next one, rather than the right ends. If they have
  // no end in common, it does.
  bool is_around_left(Halfedge_index fold, Halfedge_index next) const
  {
    return !is_same(right_behind(fold), right_before(next));
  }
  bool begins_left(const Side& side) const
  {
    return side.folds.size() == 1 ? side.is_left_of_one : is_around_left(side.folds[0], side.folds[1]);
  }
  // The second vertex of the path of a side.
  Node second(const Side& side) const
  {
    return side.folds.empty()  ? side.target
           : begins_left(side) ? left_before(side.folds[0])
                               : right_before(side.folds[0]);
  }

  // The path of a side.
  // \return its second-to-last vertex
  Node add(const Side& side)
  {
    path_.push_back({side.source, second(side)});
    if (side.folds.empty())
      return side.source;
    bool is_left = begins_left(side);
    begin_turn(is_left);
    const Node left = left_before(side.folds[0]), right = right_before(side.folds[0]);
    is_left ? add_corner(left, side.source, right) : add_corner(right, left, side.source);
    for (std::size_t i = 1; i < side.folds.size(); ++i) {
      const Halfedge_index fold = side.folds[i - 1], next = side.folds[i];
      const Node l = left_behind(fold), r = right_behind(fold), next_l = left_before(next), next_r = right_before(next);
      if (is_around_left(fold, next) != is_left) {
        is_left = !is_left;
        path_.push_back({l, r});
        begin_turn(is_left);
      }
      if (!is_left) {
        add_corner(r, next_l, l);
      } else if (is_same(l, next_l)) {
        add_corner(l, r, next_r);
      } else {
        add_corner(l, r, next_l);
        path_.push_back({l, next_l});
        begin_turn(true);
        add_corner(next_l, l, next_r);
      }
    }
    const Node l = left_behind(side.folds.back()), r = right_behind(side.folds.back());
    is_left ? add_corner(l, r, side.target) : add_corner(r, side.target, l);
    path_.push_back({is_left ? l : r, side.target});
    return path_.back().p;
  }

  // The angle of the path between two sides, through the hinge.
  // \param last the second-to-last vertex of the path of za
  void add_turn(const Side& za, Node last, const Side& ab)
  {
    std::int64_t number_of_steps = is_original(za.halfedge) ? -1 : 0;
    Halfedge_index h = ab.halfedge;
    for (int i = 0; i < ab.number_of_corners; ++i, h = complex_.next_around_source(h))
      number_of_steps += fan_of_corner(h);
    begin_turn(false);
    Node v = ab.source, p = second(ab);
    const auto add_up_to = [&](Node q) {
      if (!is_same(p, q))
        add_corner(v, p, q);
    };
    for (; number_of_steps > 0; --number_of_steps) {
      const Halfedge_index next = input_.next_around_source(v);
      if (!surface_.is_flat(next)) {
        add_up_to(input_.opposite(next));
        p = input_.next(next);
      }
      v = next;
    }
    add_up_to(last);
  }

  void begin_turn(bool is_around_left) { turns_.push_back({corners_.size(), is_around_left}); }

  void add_corner(Node v, Node p, Node q)
  {
    if (p == input_.next(v) && q == input_.prev(v))
      return corners_.push_back({v, p, q, POSITIVE});
    if (p == input_.prev(v) && q == input_.next(v))
      return corners_.push_back({v, p, q, NEGATIVE});
    const Vertex_index i = input_.source(v), j = input_.source(p), k = input_.source(q);
    is_defined_ = is_defined_ && points_[i.idx()] != points_[j.idx()] && points_[i.idx()] != points_[k.idx()];
    corners_.push_back(
      {v, p, q, sign_of_normals(points_, {i, j}, {i, k}, {i, input_.target(v)}, {i, input_.target(input_.next(v))})});
  }

  bool is_original(Halfedge_index h) const { return correspondence_.coordinates().is_original(complex_.edge(h)); }

  // The number of steps from the input halfedge along h, or next to it clockwise, to that of the next halfedge around
  // its source.
  std::int64_t fan_of_corner(Halfedge_index h) const
  {
    const Halfedge_index opposite_side = complex_.next(h), next = complex_.opposite(complex_.prev(h));
    return correspondence_.coordinates().triangle_crossings(complex_, opposite_side).e_k + (is_original(next) ? 1 : 0);
  }

  // Whether two angles are sums of the same angles.
  bool are_mirrored_turns(std::size_t i, std::size_t j)
  {
    const auto corner = [&](std::size_t turn) { return corners_.begin() + std::ptrdiff_t(turns_[turn].first_corner); };
    const auto first_i = corner(i), last_i = corner(i + 1), first_j = corner(j), last_j = corner(j + 1);
    if (turns_[i].is_around_left != turns_[j].is_around_left || last_i - first_i != last_j - first_j)
      return false;
    const auto are_equal = [&](const Corner& c, const Corner& d) { return compare(c, d) == EQUAL; };
    if (std::equal(first_i, last_i, std::make_reverse_iterator(last_j), are_equal)) // as in a mirror
      return true;
    const auto is_smaller = [&](const Corner& c, const Corner& d) { return compare(c, d) == SMALLER; };
    std::sort(first_i, last_i, is_smaller);
    std::sort(first_j, last_j, is_smaller);
    return std::equal(first_i, last_i, first_j, are_equal);
  }

  // Corners in some order, by their angles.
  Comparison_result compare(const Corner& c, const Corner& d)
  {
    surface_.interruption().check();
    if (c.side != d.side)
      return c.side < d.side ? SMALLER : LARGER;
    // Triangles are mostly mirror images or copies.
    if (have_equal_lengths({c.p, c.q}, {d.p, d.q}) &&
        ((have_equal_lengths({c.v, c.p}, {d.v, d.q}) && have_equal_lengths({c.v, c.q}, {d.v, d.p})) ||
         (have_equal_lengths({c.v, c.p}, {d.v, d.p}) && have_equal_lengths({c.v, c.q}, {d.v, d.q}))))
      return EQUAL;
    return sign_of([&](auto zero) {
      using FT = decltype(zero);
      // cos |cos| = `square` / `divisor`
      struct Cosine
      {
        FT square, divisor;
      };
      const auto cosine = [&](const Corner& x) {
        const FT s = squared_length<FT>({x.v, x.p}), t = squared_length<FT>({x.v, x.q}),
                 p = s + t - squared_length<FT>({x.p, x.q}), square = p * p;
        return Cosine{is_negative(p) ? -square : square, s * t};
      };
      const Cosine a = cosine(c), b = cosine(d);
      return FT(a.square * b.divisor - b.square * a.divisor);
    });
  }
  static bool is_negative(const Rational& x) { return x < 0; }
  // If the error leaves the sign open, it is larger than the number, and the error of the square covers both signs.
  static bool is_negative(const Bounded_double_double& x) { return x.hi() < 0; }

  bool have_equal_lengths(const Segment& s, const Segment& t) const
  {
    return are_mirrored_in_space(s, t) || sign_of([&](auto zero) {
                                            using FT = decltype(zero);
                                            return FT(squared_length<FT>(s) - squared_length<FT>(t));
                                          }) == ZERO;
  }

  // Whether two segments have the same extents along the axes, in any order, as if mirrored by a plane that is
  // perpendicular to an axis or between two axes.
  bool are_mirrored_in_space(const Segment& s, const Segment& t) const
  {
    return points_.empty() ? edge(s) == edge(t) : extents(s) == extents(t);
  }
  // As differences of doubles, which are exact.
  std::array<std::pair<double, double>, 3> extents(const Segment& s) const
  {
    std::array<std::pair<double, double>, 3> result;
    const auto u = difference<Double_double>(points_, input_.source(s.p), input_.source(s.q));
    for (std::size_t i = 0; i < 3; ++i)
      result[i] = u[i].hi < 0 ? std::pair(-u[i].hi, -u[i].lo) : std::pair(u[i].hi, u[i].lo);
    std::sort(result.begin(), result.end());
    return result;
  }

  // The sign of a number that a function computes in double-doubles and exactly.
  template <class Evaluate>
  static Sign sign_of(const Evaluate& evaluate)
  {
    const Uncertain<Sign> sign = evaluate(Bounded_double_double()).sign();
    return is_certain(sign) ? get_certain(sign) : static_cast<Sign>(evaluate(Rational()).sign());
  }

  template <class FT>
  FT squared_length(const Segment& s) const
  {
    constexpr bool is_exact = std::is_same<FT, Rational>::value;
    if (points_.empty()) {
      if constexpr (is_exact)
        return Intrinsic_triangulations::squared_length(surface_.metric(), input_, edge(s));
      else
        return surface_.metric().squared_length_double_double(input_, edge(s));
    }
    const auto u = difference<FT>(points_, input_.source(s.p), input_.source(s.q));
    return scalar_product(u, u);
  }

  // \pre the ends are two corners of one face
  Edge_index edge(const Segment& s) const { return input_.edge(input_.next(s.p) == s.q ? s.p : s.q); }

  const Delta_complex& complex_;
  const Correspondence& correspondence_;
  const Delta_complex& input_;
  Input_surface& surface_;
  const Points& points_; // empty if the input consists of lengths
  // Turn number i follows segment number i.
  std::vector<Segment> path_;
  std::vector<Turn> turns_;
  std::vector<Corner> corners_;
  bool is_defined_ = true; // no vertices of a corner coincide
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_DECIDE_MIRROR_SYMMETRY_H
