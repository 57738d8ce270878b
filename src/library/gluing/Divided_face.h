// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A face, triangulated so that given segments in it are edges.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GLUING_DIVIDED_FACE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GLUING_DIVIDED_FACE_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// CGAL's constrained triangulations have another licence than this source.
//
// All points are inserted first, then the segments: a segment turns the edges that it crosses (S. W. Sloan, "A fast
// algorithm for generating constrained Delaunay triangulations", 1993). All decisions are exact.
class Divided_face
{
public:
  using Node = std::uint32_t;
  using Coordinates = std::array<double, 3>; // barycentric
  using Edge = std::pair<Node, Node>;

  explicit Divided_face(const std::array<Node, 3>& corners) : last_(corners[0], corners[1])
  {
    for (std::size_t i = 0; i < 3; ++i) {
      places_[corners[i]] = {0, 0, 0};
      places_[corners[i]][i] = 1;
    }
    add(corners[0], corners[1], corners[2]);
  }

  // Inserts a point at a place of its own.
  void insert(Node v, const Coordinates& place)
  {
    places_[v] = place;
    const std::array<Node, 3> t = locate(v);
    last_ = {t[0], v};
    for (std::size_t i = 0; i < 3; ++i)
      if (turn(t[i], t[(i + 1) % 3], v) == COLLINEAR) {
        const Node a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3];
        const std::optional<Node> beyond = apex(b, a);
        apexes_.erase({a, b});
        apexes_.erase({b, a});
        add(b, c, v);
        add(c, a, v);
        if (beyond) {
          add(a, *beyond, v);
          add(*beyond, b, v);
        }
        last_ = {b, c};
        return;
      }
    for (std::size_t i = 0; i < 3; ++i)
      add(t[i], t[(i + 1) % 3], v);
  }

  // Makes the segment a sequence of edges that end at the points on it.
  // \return an edge of another segment that it crosses, if there is one
  template <class Visit>
  std::optional<Edge> insert_segment(Node from, Node to, const Visit& visit)
  {
    while (from != to) {
      Node next = to;
      std::deque<Edge> crossed;
      if (const std::optional<Edge> obstacle = look(from, to, next, crossed))
        return obstacle;
      turn_away(from, next, std::move(crossed));
      fixed_.insert({from, next});
      fixed_.insert({next, from});
      visit(from, next);
      from = next;
    }
    return std::nullopt;
  }

  // Turns other edges while that makes the smaller triangle beside it larger.
  void improve()
  {
    std::deque<Edge> open;
    for (const auto& side : apexes_)
      open.push_back(side.first);
    while (!open.empty()) {
      const auto [a, b] = open.front();
      open.pop_front();
      const std::optional<Node> c = apex(a, b), d = apex(b, a);
      if (!c || !d || fixed_.count({a, b}) > 0 || !is_convex(a, *d, b, *c) ||
          !((std::min)(area(*d, b, *c), area(*c, a, *d)) > (std::min)(area(a, b, *c), area(b, a, *d))))
        continue;
      flip(a, b);
      open.insert(open.end(), {{a, *d}, {*d, b}, {b, *c}, {*c, a}});
    }
  }

  template <class Visit>
  void for_each_triangle(const Visit& visit) const
  {
    for (const auto& [side, apex] : apexes_)
      if (side.first < side.second && side.first < apex)
        visit(std::array<Node, 3>{side.first, side.second, apex});
  }

private:
  std::optional<Node> apex(Node a, Node b) const
  {
    const auto found = apexes_.find({a, b});
    return found == apexes_.end() ? std::nullopt : std::optional<Node>(found->second);
  }

  void add(Node a, Node b, Node c)
  {
    apexes_[{a, b}] = c;
    apexes_[{b, c}] = a;
    apexes_[{c, a}] = b;
    neighbors_[a] = b;
    neighbors_[b] = c;
    neighbors_[c] = a;
  }

  Orientation turn(Node a, Node b, Node c) const
  {
    using Kernel = Exact_predicates_inexact_constructions_kernel;
    const auto vector = [this](Node v) {
      const Coordinates& p = places_.at(v);
      return Kernel::Vector_3(p[0], p[1], p[2]);
    };
    return Kernel().orientation_3_object()(vector(a), vector(b), vector(c));
  }

  // The area of a triangle, the same number whichever corner comes first.
  double area(Node a, Node b, Node c) const
  {
    while (a > b || a > c)
      std::tie(a, b, c) = std::tuple(b, c, a);
    const Coordinates &p = places_.at(a), &q = places_.at(b), &r = places_.at(c);
    return (q[1] - p[1]) * (r[2] - p[2]) - (q[2] - p[2]) * (r[1] - p[1]);
  }

  // The triangle with a point. Steps in random order lead there from anywhere.
  std::array<Node, 3> locate(Node v)
  {
    std::array<Node, 3> t{last_.first, last_.second, *apex(last_.first, last_.second)};
    for (std::size_t tries = 0; tries < 3;) {
      const std::size_t first = random_() % 3;
      for (tries = 0; tries < 3; ++tries) {
        const Node a = t[(first + tries) % 3], b = t[(first + tries + 1) % 3];
        if (turn(a, b, v) == CLOCKWISE) {
          t = {b, a, *apex(b, a)};
          break;
        }
      }
    }
    return t;
  }

  // The edges that a segment crosses up to the next point on it.
  // \return the first one that is fixed
  std::optional<Edge> look(Node from, Node to, Node& next, std::deque<Edge>& crossed) const
  {
    Node right = first_to_the_right(from, to);
    if (turn(from, right, to) == COLLINEAR) {
      next = right;
      return std::nullopt;
    }
    Node left = *apex(from, right);
    while (true) { // the segment leaves a triangle over the side from right to left
      if (fixed_.count({right, left}) > 0)
        return Edge(right, left);
      crossed.push_back({right, left});
      const Node beyond = *apex(left, right);
      const Orientation side = turn(from, to, beyond);
      if (side == COLLINEAR) {
        next = beyond;
        return std::nullopt;
      }
      (side == COUNTERCLOCKWISE ? left : right) = beyond;
    }
  }

  // The end of the side from a point that lies on the segment, or before it in the same triangle.
  Node first_to_the_right(Node from, Node to) const
  {
    Node start = neighbors_.at(from);
    for (std::optional<Node> right = apex(start, from); right && *right != neighbors_.at(from);
         right = apex(start, from))
      start = *right; // as far clockwise as there are triangles
    std::optional<Node> left = apex(from, start);
    while (left && !(turn(from, start, to) != CLOCKWISE && turn(from, to, *left) == COUNTERCLOCKWISE)) {
      start = *left;
      left = apex(from, start);
    }
    return start;
  }

  // Turns edges until they no longer cross the segment.
  void turn_away(Node from, Node to, std::deque<Edge> crossed)
  {
    while (!crossed.empty()) {
      const auto [a, b] = crossed.front();
      crossed.pop_front();
      const Node c = *apex(a, b), d = *apex(b, a);
      if (!is_convex(a, d, b, c)) {
        crossed.push_back({a, b});
        continue;
      }
      flip(a, b);
      if (c != from && c != to && d != from && d != to && turn(from, to, c) != turn(from, to, d))
        crossed.push_back({c, d});
    }
  }

  // Whether a quadrilateral, given counterclockwise, is convex at its second and fourth corner.
  bool is_convex(Node a, Node d, Node b, Node c) const
  {
    return turn(d, b, c) == COUNTERCLOCKWISE && turn(c, a, d) == COUNTERCLOCKWISE;
  }

  void flip(Node a, Node b)
  {
    const Node c = *apex(a, b), d = *apex(b, a);
    apexes_.erase({a, b});
    apexes_.erase({b, a});
    add(d, b, c);
    add(c, a, d);
    if (last_ == Edge(a, b) || last_ == Edge(b, a))
      last_ = {d, b};
  }

  std::map<Node, Coordinates> places_;
  std::map<Node, Node> neighbors_; // for each node, the end of a side that begins there
  std::map<Edge, Node> apexes_;    // the third corner of the triangle to the left of a side
  std::set<Edge> fixed_;
  Edge last_; // a side
  std::minstd_rand random_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GLUING_DIVIDED_FACE_H
