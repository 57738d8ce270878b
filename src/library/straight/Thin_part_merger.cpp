// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Thin_part_merger.

#include "Thin_part_merger.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <tuple>

namespace CGAL::Intrinsic_triangulations::internal {

Thin_part_merger::Thin_part_merger(Straight_map& map, std::vector<Triangle>& triangles,
                                   const std::vector<Face_index>& faces, const std::vector<bool>& is_kept,
                                   double thin_angle, double maximum_deviation)
  : map_(map), triangles_(triangles), faces_(faces), is_kept_(is_kept), thin_angle_(thin_angle),
    maximum_deviation_(maximum_deviation), at_vertex_(map.points().size())
{
  for (std::uint32_t t = 0; t < triangles_.size(); ++t)
    for (std::uint32_t v : triangles_[t])
      at_vertex_[v].push_back(t);
}

void Thin_part_merger::operator()()
{
  // The thinnest last, which are looked at first.
  std::vector<std::pair<double, std::uint32_t>> bad;
  for (std::uint32_t t = 0; t < triangles_.size(); ++t)
    if (is_bad(t))
      bad.emplace_back(smallest_angle(map_.corners(triangles_[t])).first, t);
  std::sort(bad.rbegin(), bad.rend());
  for (const auto& [angle, t] : bad)
    to_look_at_.push_back(t);
  while (!to_look_at_.empty()) {
    const std::uint32_t t = to_look_at_.back();
    to_look_at_.pop_back();
    if (is_bad(t))
      improve(t);
  }
}

// The distance of a point of a triangle from one of its sides is less than each of the two others.
double Thin_part_merger::height(const Cancelled& triangle) const
{
  const auto place = [&](std::uint32_t v) { return map_.points()[map_.image(Vertex_index(v))]; };
  const Point a = place(triangle.a), b = place(triangle.b), c = place(triangle.c);
  return (std::min)(std::hypot(a[0] - c[0], a[1] - c[1], a[2] - c[2]),
                    std::hypot(b[0] - c[0], b[1] - c[1], b[2] - c[2]));
}

Straight_map::Distance Thin_part_merger::distance_of_cancelled() const
{
  Straight_map::Distance result;
  std::vector<double> heights(cancelled_.size()); // over a side that was not removed
  for (std::size_t i = cancelled_.size(); i-- > 0;) {
    const Cancelled& triangle = cancelled_[i];
    heights[i] = height(triangle) + (triangle.next ? heights[*triangle.next] : 0);
    for (Face_index f : triangle.faces) {
      Straight_map::Distance distance = map_.distance_on(f);
      distance.value += heights[i];
      if (distance.value > result.value)
        result = distance;
    }
  }
  return result;
}

// Whether a triangle is thin, or is there twice.
bool Thin_part_merger::is_bad(std::uint32_t t) const
{
  const Triangle& corners = triangles_[t];
  return !is_removed(corners) &&
         ((!is_kept_[t] && smallest_angle(map_.corners(corners)).first < thin_angle_) ||
          number_of_triangles_at(corners[0], corners[1]) > 2 || number_of_triangles_at(corners[1], corners[2]) > 2 ||
          number_of_triangles_at(corners[2], corners[0]) > 2);
}

std::size_t Thin_part_merger::number_of_triangles_at(std::uint32_t v, std::uint32_t w) const
{
  return std::size_t(std::count_if(at_vertex_[v].begin(), at_vertex_[v].end(), [&](std::uint32_t t) {
    return std::count(triangles_[t].begin(), triangles_[t].end(), w) != 0;
  }));
}

std::vector<std::uint32_t> Thin_part_merger::neighbors(std::uint32_t v) const
{
  std::vector<std::uint32_t> result;
  for (std::uint32_t t : at_vertex_[v])
    for (std::uint32_t w : triangles_[t])
      if (w != v)
        result.push_back(w);
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

bool Thin_part_merger::is_on_border(std::uint32_t v) const
{
  const std::vector<std::uint32_t> around = neighbors(v);
  return std::any_of(around.begin(), around.end(), [&](std::uint32_t w) { return number_of_triangles_at(v, w) == 1; });
}

// Contracts the shortest side that can be.
bool Thin_part_merger::improve(std::uint32_t t)
{
  if (cancel_twin(t))
    return true;
  std::array<std::tuple<double, std::uint32_t, std::uint32_t>, 3> sides;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t v = triangles_[t][i], w = triangles_[t][(i + 1) % 3];
    const Point &p = map_.points()[v], &q = map_.points()[w];
    sides[i] = {std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]), v, w};
  }
  std::sort(sides.begin(), sides.end());
  for (const auto& [length, v, w] : sides)
    if (length <= maximum_deviation_ && (contract(v, w) || contract(w, v)))
      return true;
  return false;
}

// Two triangles with the same corners and opposite directions, which are a sheet of no thickness. Removed, the other
// triangles there are a manifold again, and nothing of the sheet is farther from them than its height over one of their
// sides.
bool Thin_part_merger::cancel_twin(std::uint32_t t)
{
  const Triangle corners = triangles_[t];
  for (std::uint32_t twin : at_vertex_[corners[0]]) {
    const Triangle& other = triangles_[twin];
    const auto at = std::find(other.begin(), other.end(), corners[0]);
    const std::size_t i = std::size_t(at - other.begin());
    if (twin == t || other[(i + 1) % 3] != corners[2] || other[(i + 2) % 3] != corners[1])
      continue;
    std::optional<Cancelled> least;
    for (std::size_t side = 0; side < 3; ++side) {
      const Cancelled candidate{
        corners[side], corners[(side + 1) % 3], corners[(side + 2) % 3], {faces_[t], faces_[twin]}};
      if (number_of_triangles_at(candidate.a, candidate.b) == 4 && (!least || height(candidate) < height(*least)))
        least = candidate;
    }
    if (!least)
      continue;
    const auto is_corner = [&](std::uint32_t v) {
      return std::count(corners.begin(), corners.end(), map_.image(Vertex_index(v))) != 0;
    };
    std::vector<std::size_t> before;
    for (std::size_t i = 0; i < cancelled_.size(); ++i)
      if (!cancelled_[i].next && is_corner(cancelled_[i].a) && is_corner(cancelled_[i].b)) {
        cancelled_[i].next = cancelled_.size();
        before.push_back(i);
      }
    cancelled_.push_back(*least);
    if (map_.bound(distance_of_cancelled().value) > maximum_deviation_) {
      cancelled_.pop_back();
      for (std::size_t i : before)
        cancelled_[i].next.reset();
      continue;
    }
    for (std::uint32_t removed : {t, twin})
      for (std::uint32_t v : corners)
        at_vertex_[v].erase(std::find(at_vertex_[v].begin(), at_vertex_[v].end(), removed));
    triangles_[t] = triangles_[twin] = {corners[0], corners[0], corners[0]};
    for (std::uint32_t v : corners)
      to_look_at_.insert(to_look_at_.end(), at_vertex_[v].begin(), at_vertex_[v].end());
    return true;
  }
  return false;
}

// Whether the triangles stay a manifold of the same kind: the links of both vertices have nothing in common but the link
// of the edge. (T. Dey, H. Edelsbrunner, S. Guha, D. Nekhayev, "Topology preserving edge contraction", 1999.)
bool Thin_part_merger::is_contractible(std::uint32_t from, std::uint32_t to)
{
  const std::vector<std::uint32_t> a = neighbors(from), b = neighbors(to);
  std::vector<std::uint32_t> both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  const std::size_t number = number_of_triangles_at(from, to);
  if (both.size() != number || number > 2)
    return false;
  for (std::uint32_t v : {from, to}) // an edge of three triangles is no surface, but may become one
    for (std::uint32_t w : v == from ? a : b)
      if (number_of_triangles_at(v, w) > 2)
        return false;
  const auto has_in_link = [&](std::uint32_t v) {
    return std::any_of(at_vertex_[v].begin(), at_vertex_[v].end(), [&](std::uint32_t t) {
      return std::count(triangles_[t].begin(), triangles_[t].end(), both[0]) != 0 &&
             std::count(triangles_[t].begin(), triangles_[t].end(), both[1]) != 0;
    });
  };
  if (number == 2 && has_in_link(from) && has_in_link(to)) // the edge between them
    return false;
  return number == 1 || !(is_on_border(from) && is_on_border(to));
}

// Whether the smallest angle around the edge grows, or fewer are small, and no triangle turns over.
bool Thin_part_merger::improves(std::uint32_t from, std::uint32_t to) const
{
  double before = 180, after = 180;
  int number_of_thin = 0; // how many there are less
  for (std::uint32_t v : {from, to})
    for (std::uint32_t t : at_vertex_[v]) {
      const Triangle& corners = triangles_[t];
      const auto at_from = std::find(corners.begin(), corners.end(), from);
      const bool vanishes = at_from != corners.end() && std::count(corners.begin(), corners.end(), to) != 0;
      if (vanishes && v == to)
        continue;
      std::array<Point, 3> points = map_.corners(corners);
      const double angle = smallest_angle(points).first;
      if (!is_kept_[t]) {
        before = (std::min)(before, angle);
        number_of_thin += angle < thin_angle_;
      }
      if (vanishes)
        continue;
      const auto normal = [](const std::array<Point, 3>& p) {
        Point result{};
        for (std::size_t i = 0; i < 3; ++i) {
          const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
          result[i] = (p[1][j] - p[0][j]) * (p[2][k] - p[0][k]) - (p[1][k] - p[0][k]) * (p[2][j] - p[0][j]);
        }
        return result;
      };
      const Point m = normal(points);
      if (at_from != corners.end())
        points[std::size_t(at_from - corners.begin())] = map_.points()[to];
      const Point n = normal(points);
      const double moved = smallest_angle(points).first;
      // The normals of thin triangles mean nothing.
      if (angle >= thin_angle_ && moved >= thin_angle_ && m[0] * n[0] + m[1] * n[1] + m[2] * n[2] < 0)
        return false;
      if (!is_kept_[t]) {
        if (at_from != corners.end())
          after = (std::min)(after, moved);
        number_of_thin -= moved < thin_angle_;
      }
    }
  return after > before || (after == before && number_of_thin > 0);
}

bool Thin_part_merger::contract(std::uint32_t from, std::uint32_t to)
{
  if (!is_contractible(from, to) || !improves(from, to))
    return false;
  Straight_map::Undo undo = map_.merge(from, to);
  if (map_.bound((std::max)(map_.distance_around(to).value, distance_of_cancelled().value)) > maximum_deviation_) {
    map_.undo(undo);
    return false;
  }
  for (std::uint32_t t : std::exchange(at_vertex_[from], {})) {
    Triangle& corners = triangles_[t];
    if (std::count(corners.begin(), corners.end(), to) != 0) {
      for (std::uint32_t v : corners)
        if (v != from)
          at_vertex_[v].erase(std::find(at_vertex_[v].begin(), at_vertex_[v].end(), t));
      corners = {to, to, to};
    } else {
      *std::find(corners.begin(), corners.end(), from) = to;
      at_vertex_[to].push_back(t);
    }
  }
  to_look_at_.insert(to_look_at_.end(), at_vertex_[to].begin(), at_vertex_[to].end());
  return true;
}

} // namespace CGAL::Intrinsic_triangulations::internal
