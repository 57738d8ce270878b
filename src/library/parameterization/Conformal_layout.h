// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A flat surface cut open and laid out in the plane.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_PARAMETERIZATION_CONFORMAL_LAYOUT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_PARAMETERIZATION_CONFORMAL_LAYOUT_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/planar_orientation.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Disjoint_sets.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

class Conformal_layout
{
public:
  using Point = std::array<double, 2>;

  // \param lengths in a unit of 2^unit units of the input, as the corners are
  // \param is_inside for each halfedge, whether a part of the surface lies to its left
  // \param is_end for each vertex, whether a cut has to end there: at cones, and on the border
  Conformal_layout(const Delta_complex& complex, const std::vector<double>& lengths, int unit,
                   const std::vector<bool>& is_inside, const std::vector<bool>& is_end)
    : complex_(complex), lengths_(lengths), unit_(std::ldexp(1., unit)), is_inside_(is_inside),
      is_cut_(complex.number_of_edges(), false), corners_(complex.number_of_halfedges(), {0, 0})
  {
    cut(is_end);
    lay_out();
    merge_corners();
  }

  // The source of a halfedge, in its face.
  const Point& corner(Halfedge_index h) const { return corners_[h.idx()]; }
  // The point next to p that scaling to the unit of the input does not round.
  Point rounded(const Point& p) const { return {p[0] * unit_ / unit_, p[1] * unit_ / unit_}; }

  // Whether the surface continues on the other side of an edge, but is cut there.
  bool is_cut(Halfedge_index h) const { return is_inner(complex_.edge(h)) && is_cut_[complex_.edge(h).idx()]; }

  // Whether all triangles keep their orientation, exactly, and go around each vertex off the cuts once.
  bool is_certified() const
  {
    for (Face_index f : complex_.faces()) {
      const Halfedge_index h = complex_.halfedge(f);
      if (is_inside(f) &&
          planar_orientation(corner(h), corner(complex_.next(h)), corner(complex_.prev(h))) != LEFT_TURN)
        return false;
    }
    std::vector<bool> is_once = go_around_once();
    for (Edge_index e : complex_.edges())
      if (is_cut(complex_.halfedge(e)))
        is_once[complex_.source(complex_.halfedge(e)).idx()] = is_once[complex_.target(complex_.halfedge(e)).idx()] =
          true;
    return std::find(is_once.begin(), is_once.end(), false) == is_once.end();
  }

  // The largest difference between the lengths of the images of a cut edge, or a part of it, or from its length.
  double seam() const
  {
    double result = 0, largest = 0; // the latter of coordinates: parts end at points that are rounded by 2^-50 of it
    for (Edge_index e : complex_.edges())
      if (const Halfedge_index h = complex_.halfedge(e), g = complex_.opposite(h); is_cut(h)) {
        const auto image = [&](Halfedge_index side) {
          const Point &p = corner(side), &q = corner(complex_.next(side));
          largest = (std::max)({largest, std::abs(p[0]), std::abs(p[1]), std::abs(q[0]), std::abs(q[1])});
          return std::hypot(q[0] - p[0], q[1] - p[1]);
        };
        const auto [least, most] = std::minmax({length(h), image(h), image(g)});
        result = (std::max)(result, most - least);
      }
    return result + 0x1p-47 * largest;
  }

private:
  bool is_inner(Edge_index e) const
  {
    return is_inside_[complex_.halfedge(e).idx()] && is_inside_[complex_.opposite(complex_.halfedge(e)).idx()];
  }
  bool is_inside(Face_index f) const
  {
    const Halfedge_index h = complex_.halfedge(f);
    return is_inside_[h.idx()] || is_inside_[complex_.next(h).idx()] || is_inside_[complex_.prev(h).idx()];
  }

  double length(Halfedge_index h) const { return lengths_[complex_.edge(h).idx()]; }

  // For each vertex, whether triangles that keep their orientation go around it once: the sum of their angles is a
  // multiple of 2 pi, so it need not be known exactly. True on the border.
  std::vector<bool> go_around_once() const
  {
    std::vector<double> sums(complex_.number_of_vertices(), 0.);
    for (Halfedge_index h : complex_.halfedges())
      if (is_inside(complex_.face(h))) {
        const Point &p = corner(h), &q = corner(complex_.next(h)), &r = corner(complex_.prev(h));
        const double ux = q[0] - p[0], uy = q[1] - p[1], vx = r[0] - p[0], vy = r[1] - p[1];
        sums[complex_.source(h).idx()] += std::atan2(ux * vy - uy * vx, ux * vx + uy * vy);
      }
    for (Edge_index e : complex_.edges())
      if (!is_inner(e))
        sums[complex_.source(complex_.halfedge(e)).idx()] = sums[complex_.target(complex_.halfedge(e)).idx()] = 0;
    std::vector<bool> result;
    for (double sum : sums)
      result.push_back(sum == 0 || std::abs(sum - 2 * CGAL_PI) < 1);
    return result;
  }

  // Shortest paths lead from all vertices to the nearest border, or to one vertex where cuts end. A maximal tree of
  // faces does not cross them; the edges that it does not cross either close a loop each, the shortest ones if the tree
  // crosses those first whose loops are longest (Erickson, Whittlesey 2005). Dead ends are not cut.
  void cut(const std::vector<bool>& is_end)
  {
    std::vector<bool> is_in_tree(complex_.number_of_edges(), false);
    const std::vector<double> distance = distances(is_end, is_in_tree);
    std::vector<std::pair<double, Edge_index>> loops;
    for (Edge_index e : complex_.edges()) {
      const Halfedge_index h = complex_.halfedge(e);
      is_cut_[e.idx()] = true;
      if (is_inner(e) && !is_in_tree[e.idx()])
        loops.emplace_back(distance[complex_.source(h).idx()] + distance[complex_.target(h).idx()] + length(h), e);
    }
    std::stable_sort(loops.begin(), loops.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    Disjoint_sets faces(complex_.number_of_faces());
    for (const auto& [loop, e] : loops) {
      const std::uint32_t f = faces.find(complex_.face(complex_.halfedge(e)).idx()),
                          g = faces.find(complex_.face(complex_.opposite(complex_.halfedge(e))).idx());
      if (f != g) {
        faces.unite(f, g);
        is_cut_[e.idx()] = false;
      }
    }
    prune(is_end);
  }

  // Distances from the border along edges inside the surface. In each component without a border, one vertex is the
  // root.
  std::vector<double> distances(const std::vector<bool>& is_end, std::vector<bool>& is_in_tree) const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::vector<double> result(complex_.number_of_vertices(), infinity);
    using Entry = std::pair<double, Halfedge_index>; // to its target
    const auto later = [](const Entry& a, const Entry& b) {
      return a.first != b.first ? a.first > b.first : a.second.idx() > b.second.idx();
    };
    std::priority_queue<Entry, std::vector<Entry>, decltype(later)> queue(later);
    const auto push = [&](Vertex_index v) {
      for (Halfedge_index in : Halfedges_around(complex_, v)) {
        const Halfedge_index h = complex_.opposite(in);
        if (is_inner(complex_.edge(h)) && result[v.idx()] + length(h) < result[complex_.target(h).idx()])
          queue.emplace(result[v.idx()] + length(h), h);
      }
    };
    const auto spread = [&] {
      while (!queue.empty()) {
        const auto [distance, h] = queue.top();
        queue.pop();
        double& at = result[complex_.target(h).idx()];
        if (!(distance < at))
          continue;
        at = distance;
        is_in_tree[complex_.edge(h).idx()] = true;
        push(complex_.target(h));
      }
    };
    const auto start = [&](Vertex_index v) {
      result[v.idx()] = 0;
      push(v);
    };
    for (Halfedge_index h : complex_.halfedges())
      if (is_inside(complex_.face(h)) && !is_inner(complex_.edge(h)))
        for (Vertex_index v : {complex_.source(h), complex_.target(h)})
          if (result[v.idx()] != 0)
            start(v);
    spread();
    for (bool wanted : {true, false})
      for (Vertex_index v : complex_.vertices())
        if (result[v.idx()] == infinity && is_end[v.idx()] == wanted) {
          start(v);
          spread();
        }
    return result;
  }

  void prune(const std::vector<bool>& is_end)
  {
    std::vector<int> degree(complex_.number_of_vertices(), 0);
    for (Edge_index e : complex_.edges())
      if (is_cut_[e.idx()])
        for (Vertex_index v : {complex_.source(complex_.halfedge(e)), complex_.target(complex_.halfedge(e))})
          ++degree[v.idx()];
    std::vector<Vertex_index> dead_ends(complex_.vertices().begin(), complex_.vertices().end());
    while (!dead_ends.empty()) {
      const Vertex_index v = dead_ends.back();
      dead_ends.pop_back();
      if (degree[v.idx()] != 1 || is_end[v.idx()])
        continue;
      for (Halfedge_index h : Halfedges_around(complex_, v))
        if (is_cut_[complex_.edge(h).idx()] && is_inner(complex_.edge(h))) {
          is_cut_[complex_.edge(h).idx()] = false;
          --degree[v.idx()];
          --degree[complex_.source(h).idx()];
          dead_ends.push_back(complex_.source(h));
          break;
        }
    }
  }

  // Goes from the largest face of each component over the longest edges first, so that small triangles get their places
  // from their neighbors. The components come from left to right, the smallest first, lest it be rounded to nothing.
  void lay_out()
  {
    std::vector<std::pair<double, Face_index>> faces;
    for (Face_index f : complex_.faces())
      if (is_inside(f)) {
        const Halfedge_index h = complex_.halfedge(f);
        const double a = length(h), b = length(complex_.next(h)), c = length(complex_.prev(h));
        faces.emplace_back((a + b + c) * (std::min)({a + b - c, b + c - a, c + a - b}), f);
      }
    std::stable_sort(faces.begin(), faces.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<bool> is_placed(complex_.number_of_faces(), false);
    std::vector<std::vector<Halfedge_index>> components;
    for (const auto& [size, first] : faces)
      if (!is_placed[first.idx()])
        components.push_back(lay_out_from(first, is_placed));
    close_slits(components);
    double right = 0;
    for (auto placed = components.rbegin(); placed != components.rend(); ++placed) {
      const auto [least, most] =
        std::minmax_element(placed->begin(), placed->end(),
                            [&](Halfedge_index h, Halfedge_index g) { return corner(h)[0] < corner(g)[0]; });
      const double from = corner(*least)[0], to = corner(*most)[0], width = to - from,
                   shift = components.size() == 1 ? 0 : right + 0.05 * width - from;
      for (Halfedge_index h : *placed)
        corners_[h.idx()][0] += shift;
      right = to + shift;
    }
  }

  // Both images of a slit into a flat part agree to 10^-12 of the component's size: there is no need of a cut. At a
  // cone of 4 pi there is.
  void close_slits(const std::vector<std::vector<Halfedge_index>>& components)
  {
    std::vector<Halfedge_index> slits;
    for (const std::vector<Halfedge_index>& placed : components) {
      double size = 0;
      for (Halfedge_index h : placed)
        size = (std::max)({size, std::abs(corner(h)[0]), std::abs(corner(h)[1])});
      const auto agree = [&](const Point& p, const Point& q) {
        return std::abs(p[0] - q[0]) + std::abs(p[1] - q[1]) <= 1e-12 * size;
      };
      for (Halfedge_index h : placed)
        if (const Halfedge_index g = complex_.opposite(h);
            is_cut(h) && agree(corner(h), corner(complex_.next(g))) && agree(corner(complex_.next(h)), corner(g)))
          slits.push_back(h);
    }
    if (slits.empty())
      return;
    const std::vector<bool> is_once = go_around_once();
    for (Halfedge_index h : slits)
      if (is_once[complex_.source(h).idx()] && is_once[complex_.target(h).idx()])
        is_cut_[complex_.edge(h).idx()] = false;
  }

  // Returns the halfedges whose sources were placed.
  std::vector<Halfedge_index> lay_out_from(Face_index first, std::vector<bool>& is_placed)
  {
    using Entry = std::pair<double, Halfedge_index>; // whose face is placed
    const auto shorter = [](const Entry& a, const Entry& b) {
      return a.first != b.first ? a.first < b.first : a.second.idx() > b.second.idx();
    };
    std::priority_queue<Entry, std::vector<Entry>, decltype(shorter)> queue(shorter);
    std::vector<Halfedge_index> placed;
    const auto place = [&](Halfedge_index h, const Point& p, const Point& q) {
      corners_[h.idx()] = p;
      corners_[complex_.next(h).idx()] = q;
      corners_[complex_.prev(h).idx()] = third(h);
      is_placed[complex_.face(h).idx()] = true;
      for (Halfedge_index side : {h, complex_.next(h), complex_.prev(h)}) {
        placed.push_back(side);
        if (is_inner(complex_.edge(side)) && !is_cut_[complex_.edge(side).idx()])
          queue.emplace(length(side), side);
      }
    };
    const Halfedge_index start = side_with_largest(complex_, first, [&](Halfedge_index h) { return length(h); });
    place(start, {0, 0}, {length(start), 0});
    while (!queue.empty()) {
      const Halfedge_index h = queue.top().second, g = complex_.opposite(h);
      queue.pop();
      if (!is_placed[complex_.face(g).idx()])
        place(g, corner(complex_.next(h)), corner(h));
    }
    return placed;
  }

  // The place of the third corner of the face of h, where the ends of h have been placed.
  Point third(Halfedge_index h) const
  {
    const double c = length(h), a = length(complex_.next(h)), b = length(complex_.prev(h));
    const Point &p = corner(h), &q = corner(complex_.next(h));
    const double dx = q[0] - p[0], dy = q[1] - p[1], d = std::hypot(dx, dy);
    if (!(d > 0))
      return p;
    const double s = a + b + c, y = std::sqrt((std::max)(0., s * (b + c - a))) *
                                    std::sqrt((std::max)(0., (c + a - b) * (a + b - c))) / (2 * c);
    const double x = (c + (b - a) * ((b + a) / c)) / 2;
    return {p[0] + (x * dx - y * dy) / d, p[1] + (x * dy + y * dx) / d};
  }

  // Corners around a vertex between two cuts get the mean of their places.
  void merge_corners()
  {
    Disjoint_sets sets(corners_.size());
    for (Edge_index e : complex_.edges())
      if (is_inner(e) && !is_cut_[e.idx()]) {
        const Halfedge_index h = complex_.halfedge(e), g = complex_.opposite(h);
        sets.unite(h.idx(), complex_.next(g).idx());
        sets.unite(g.idx(), complex_.next(h).idx());
      }
    std::vector<std::array<double, 3>> sums(corners_.size(), {0, 0, 0});
    for (std::uint32_t h = 0; h < corners_.size(); ++h) {
      auto& [x, y, count] = sums[sets.find(h)];
      x += corners_[h][0];
      y += corners_[h][1];
      ++count;
    }
    for (std::uint32_t h = 0; h < corners_.size(); ++h) {
      const auto& [x, y, count] = sums[sets.find(h)];
      corners_[h] = rounded({x / count, y / count});
      if (!std::isfinite(corners_[h][0]) || !std::isfinite(corners_[h][1]))
        throw Numerical_error("coordinates of the conformal map leave the range of double");
    }
  }

  const Delta_complex& complex_;
  const std::vector<double>& lengths_;
  double unit_;
  const std::vector<bool>& is_inside_;
  std::vector<bool> is_cut_;
  std::vector<Point> corners_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_PARAMETERIZATION_CONFORMAL_LAYOUT_H
