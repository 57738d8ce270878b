// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Finds vertices within edges or close to other vertices: gaps in a surface that are too narrow to see.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_VERTICES_ON_EDGES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_VERTICES_ON_EDGES_H

#include <CGAL/Intrinsic_triangulations/internal/measures/are_collinear.h>

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The vertices of a list in a tree of boxes. O(n log n); a query takes O(log n) where few vertices are near.
class Vertices_on_edges
{
  using Index = std::uint32_t;
  using Place = std::array<double, 3>;

public:
  Vertices_on_edges(const std::vector<Place>& points, std::vector<Index> vertices)
    : points_(points), vertices_(std::move(vertices))
  {
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
    if (vertices_.empty())
      return;
    build(0, Index(vertices_.size()));
    for (Index v : vertices_) {
      const Place& p = points_[v];
      is_used_[cell_at({cell(p[0], 0), cell(p[1], 1), cell(p[2], 2)})] = true;
    }
  }

  // Calls visit(vertex, distance, position) for the vertices within an edge: those exactly on it, with distance 0, and
  // those that are nearer to it than a tolerance, and farther from its ends. The tolerance is a length or a part of the
  // edge's length, whichever is larger. Positions increase from p to q.
  template <class Function>
  void for_each_within_edge(const Place& p, const Place& q, double length, double part, const Function& visit) const
  {
    const Place d = difference(p, q);
    const std::size_t axis = std::size_t(
      std::max_element(d.begin(), d.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }) - d.begin());
    const double part_of_more = 2 * part * std::abs(d[axis]);
    for_each_near(p, q, std::isfinite(part_of_more) ? (std::max)(length, part_of_more) : length, [&](Index v) {
      const Place& r = points_[v];
      if (r == p || r == q)
        return;
      const double position = d[axis] < 0 ? -r[axis] : r[axis];
      if ((r < p) != (r < q) && are_collinear(p, q, r))
        return visit(v, 0., position);
      const double size = norm(d), tolerance = std::isfinite(size) ? (std::max)(length, part * size) : length;
      const Place s = difference(p, r);
      const double along = (s[0] * (d[0] / size) + s[1] * (d[1] / size) + s[2] * (d[2] / size)) / size;
      if (!(along > 0 && along < 1))
        return;
      const double distance = norm({s[0] - along * d[0], s[1] - along * d[1], s[2] - along * d[2]});
      if (distance <= tolerance && norm(s) > tolerance && norm(difference(q, r)) > tolerance)
        visit(v, distance, position);
    });
  }

  // Calls visit(vertex, distance) for the vertices within a given distance of a point.
  template <class Function>
  void for_each_within(const Place& p, double length, const Function& visit) const
  {
    for_each_near(p, p, length, [&](Index v) {
      const double distance = points_[v] == p ? 0 : norm(difference(p, points_[v]));
      if (distance <= length)
        visit(v, distance);
    });
  }

  static Place difference(const Place& p, const Place& q) { return {q[0] - p[0], q[1] - p[1], q[2] - p[2]}; }
  static double norm(const Place& d) { return std::hypot(d[0], d[1], d[2]); }

private:
  struct Node
  {
    Index begin, end; // of its vertices
    Index behind;     // the first node after the nodes below this one
    Place lower, upper;
    double size; // the largest extent
  };
  static constexpr Index few = 8;

  void build(Index begin, Index end)
  {
    const std::size_t node = nodes_.size();
    Place lower = points_[vertices_[begin]], upper = lower;
    for (Index i = begin; i < end; ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        lower[k] = (std::min)(lower[k], points_[vertices_[i]][k]);
        upper[k] = (std::max)(upper[k], points_[vertices_[i]][k]);
      }
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k)
      if (upper[k] / 2 - lower[k] / 2 > upper[axis] / 2 - lower[axis] / 2)
        axis = k;
    nodes_.push_back({begin, end, 0, lower, upper, upper[axis] - lower[axis]});
    if (end - begin > few) {
      const Index middle = begin + (end - begin) / 2;
      std::nth_element(vertices_.begin() + begin, vertices_.begin() + middle, vertices_.begin() + end,
                       [&](Index v, Index w) { return points_[v][axis] < points_[w][axis]; });
      build(begin, middle);
      build(middle, end);
    }
    nodes_[node].behind = Index(nodes_.size());
  }

  // The cells of a grid of cubes over all vertices: they show at once that most segments are far from all vertices. In
  // each coordinate their order is that of the numbers, however those are rounded.
  static constexpr int cells = 32; // along each axis
  int cell(double x, std::size_t axis) const
  {
    const double lower = nodes_[0].lower[axis], upper = nodes_[0].upper[axis],
                 place = (x - lower) * (cells / (upper - lower));
    return !(place > 0) ? 0 : place >= cells ? cells - 1 : int(place);
  }
  static std::size_t cell_at(const std::array<int, 3>& c)
  {
    return (std::size_t(c[0]) * cells + std::size_t(c[1])) * cells + std::size_t(c[2]);
  }
  // A box around a segment, larger than it by a tolerance and all rounding.
  struct Query
  {
    Query(const Place& p, const Place& q, double tolerance) : p(p), q(q), tolerance(tolerance)
    {
      for (std::size_t k = 0; k < 3; ++k) {
        const double slack =
          tolerance + 0x1p-48 * (std::abs(p[k]) + std::abs(q[k])) + (std::numeric_limits<double>::min)();
        lower[k] = (std::min)(p[k], q[k]) - slack;
        upper[k] = (std::max)(p[k], q[k]) + slack;
        size = (std::max)(size, upper[k] - lower[k]);
      }
    }
    bool meets(const Place& low, const Place& high) const
    {
      return low[0] <= upper[0] && high[0] >= lower[0] && low[1] <= upper[1] && high[1] >= lower[1] &&
             low[2] <= upper[2] && high[2] >= lower[2];
    }
    const Place &p, &q;
    const double tolerance;
    Place lower, upper;
    double size = 0;
  };

  bool is_far_from_all(const Query& query) const
  {
    if (!query.meets(nodes_[0].lower, nodes_[0].upper))
      return true;
    std::array<int, 3> first, last;
    int number = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      first[k] = cell(query.lower[k], k);
      last[k] = cell(query.upper[k], k);
      number *= last[k] - first[k] + 1;
    }
    if (number > cells)
      return false;
    for (std::array<int, 3> c = first; c[0] <= last[0]; ++c[0])
      for (c[1] = first[1]; c[1] <= last[1]; ++c[1])
        for (c[2] = first[2]; c[2] <= last[2]; ++c[2])
          if (is_used_[cell_at(c)])
            return false;
    return true;
  }

  // Calls visit(vertex) for all vertices that may be this near to the segment, and for some others.
  template <class Function>
  void for_each_near(const Place& p, const Place& q, double tolerance, const Function& visit) const
  {
    if (nodes_.empty())
      return;
    const Query query(p, q, tolerance);
    if (is_far_from_all(query))
      return;
    for (Index n = 0; n < nodes_.size();) {
      const Node& node = nodes_[n];
      // Beside a longer segment a node may be far although the boxes meet.
      if (!query.meets(node.lower, node.upper) || (node.size < query.size && is_far(node, query))) {
        n = node.behind;
        continue;
      }
      if (node.behind == n + 1)
        for (Index i = node.begin; i < node.end; ++i)
          if (const Place& r = points_[vertices_[i]]; query.meets(r, r))
            visit(vertices_[i]);
      ++n;
    }
  }

  // The part of the segment between the two planes of each axis is empty. Boxes are larger than all rounding.
  static bool is_far(const Node& node, const Query& query)
  {
    const Place &p = query.p, &q = query.q;
    double first = 0, last = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      const double size =
        std::abs(p[k]) / 4 + std::abs(q[k]) / 4 + std::abs(node.lower[k]) / 4 + std::abs(node.upper[k]) / 4;
      const double slack = query.tolerance / 4 + 0x1p-48 * size + (std::numeric_limits<double>::min)();
      const double lower = node.lower[k] / 4 - slack, upper = node.upper[k] / 4 + slack;
      const double a = p[k] / 4, b = q[k] / 4;
      if ((std::max)(a, b) < lower || (std::min)(a, b) > upper)
        return true;
      if (std::abs(b - a) <= slack)
        continue;
      const double to_lower = (lower - a) / (b - a), to_upper = (upper - a) / (b - a);
      first = (std::max)(first, (std::min)(to_lower, to_upper) - 0x1p-40);
      last = (std::min)(last, (std::max)(to_lower, to_upper) + 0x1p-40);
    }
    return first > last;
  }

  const std::vector<Place>& points_;
  std::vector<Index> vertices_; // in the order of the tree
  std::vector<Node> nodes_;     // each before those below it
  std::bitset<std::size_t(cells) * cells * cells> is_used_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_VERTICES_ON_EDGES_H
