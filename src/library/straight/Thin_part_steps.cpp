// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Thin_part_merger: contractions, flips and moves.

#include "Thin_part_merger.h"

#include <CGAL/Intrinsic_triangulations/Point_location.h>

#include <algorithm>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

// Whether the triangles stay a manifold of the same kind: the links of both vertices have nothing in common but the link
// of the edge. (T. Dey, H. Edelsbrunner, S. Guha, D. Nekhayev, "Topology preserving edge contraction", 1999.)
bool Thin_part_merger::is_contractible(std::uint32_t from, std::uint32_t to)
{
  // Marked edges stay where they are, except for parts that are shorter than the deviation.
  if (length(from, to) > maximum_deviation_ && !marked_[from].empty() &&
      !(marked_[from].size() == 2 && is_marked(from, to)))
    return false;
  if (is_fixed(from) || is_hub(from))
    return false;
  std::vector<std::uint32_t> both;
  for (std::uint32_t w : neighbors(from)) {
    const std::size_t at_other = w == to ? 0 : number_of_triangles_at(to, w);
    if (at_other > 2 || number_of_triangles_at(from, w) > 2) // no surface, but it may become one
      return false;
    if (at_other > 0)
      both.push_back(w);
  }
  const std::size_t number = number_of_triangles_at(from, to);
  if (both.size() != number)
    return false;
  const auto has_in_link = [&](std::uint32_t v) {
    const std::vector<std::uint32_t> there = triangles_at(v, both[0]);
    return std::any_of(there.begin(), there.end(), [&](std::uint32_t t) {
      return std::count(mesh_.triangles[t].begin(), mesh_.triangles[t].end(), both[1]) != 0;
    });
  };
  if (number == 2 && has_in_link(from) && has_in_link(to)) // the edge between them
    return false;
  return number == 1 || !(is_on_border(from) && is_on_border(to));
}

Thin_part_merger::Change Thin_part_merger::contraction(std::uint32_t from, std::uint32_t to) const
{
  Change change;
  change.triangles = at_vertex_[from];
  for (std::uint32_t t : change.triangles) {
    Triangle corners = mesh_.triangles[t];
    std::replace(corners.begin(), corners.end(), from, to);
    const bool vanishes = std::count(corners.begin(), corners.end(), to) == 2;
    change.corners.push_back(vanishes ? Triangle{to, to, to} : corners);
  }
  std::vector<std::uint32_t> others = at_vertex_[to];
  if (is_hub(to)) { // those next to the changed ones are enough
    others.clear();
    for (std::uint32_t w : neighbors(from))
      if (w != to)
        for (std::uint32_t t : triangles_at(to, w))
          others.push_back(t);
  }
  for (std::uint32_t t : others)
    if (std::count(change.triangles.begin(), change.triangles.end(), t) == 0)
      change.beside.push_back(t);
  return change;
}

bool Thin_part_merger::contract(std::uint32_t from, std::uint32_t to)
{
  if (!is_contractible(from, to))
    return false;
  Change change = contraction(from, to);
  if (!try_to_make(change))
    return false;
  merge_vertex(from, to);
  look_at(to, change.triangles);
  return true;
}

// The image and the marked edges of a vertex move to another one.
void Thin_part_merger::merge_vertex(std::uint32_t from, std::uint32_t to)
{
  if (from < images_.size())
    images_[from] = to;
  is_merged_[to] = true;
  is_at_film_[to] = is_at_film_[to] || is_at_film_[from];
  for (std::uint32_t w : std::exchange(marked_[from], {})) {
    std::replace(marked_[w].begin(), marked_[w].end(), from, to);
    if (w != to)
      marked_[to].push_back(w);
  }
  marked_[to].erase(std::remove(marked_[to].begin(), marked_[to].end(), to), marked_[to].end());
}

std::uint32_t Thin_part_merger::after(const Triangle& corners, std::uint32_t v)
{
  return corners[std::size_t(std::find(corners.begin(), corners.end(), v) - corners.begin() + 1) % 3];
}

// Replaces the side ab of a triangle by the line from its third corner c to that of the triangle beyond. A marked side is
// bent to c, and so is one of the border, where the triangle vanishes.
bool Thin_part_merger::flip(std::uint32_t t, std::uint32_t a, std::uint32_t b)
{
  if (after(mesh_.triangles[t], a) != b)
    std::swap(a, b);
  const std::uint32_t c = after(mesh_.triangles[t], b);
  const std::vector<std::uint32_t> there = triangles_at(a, b);
  const bool is_bent = is_marked(a, b);
  if (there.size() > 2 || number_of_triangles_at(b, c) > 2 || number_of_triangles_at(c, a) > 2 ||
      (is_fixed(a) && is_fixed(b)))
    return false;
  if (is_bent || there.size() == 1) { // the height of c
    Space_triangle seen = map_.corners({a, b, b});
    for (Point& p : seen)
      for (std::size_t i = 0; i < 3; ++i)
        p[i] -= map_.points()[c][i];
    if (nearest_to_origin(seen).second > maximum_deviation_ * maximum_deviation_)
      return false;
  }
  Change change;
  if (there.size() == 1) {
    if (number_of_triangles_at(b, c) != 2 || number_of_triangles_at(c, a) != 2 || is_on_border(c))
      return false;
    change = {{t}, {{a, a, a}}, {}};
    for (std::uint32_t v : {a, b})
      for (std::uint32_t n : triangles_at(v, c))
        if (n != t)
          change.beside.push_back(n);
  } else {
    const std::uint32_t n = there[there[0] == t];
    const std::uint32_t d = after(mesh_.triangles[n], a);
    if (after(mesh_.triangles[n], b) != a || d == c || number_of_triangles_at(c, d) != 0 ||
        (mesh_.is_kept[n] && smallest_angle(map_.corners(mesh_.triangles[n])).first < thin_angle_))
      return false;
    change = {{t, n}, {{a, d, c}, {d, b, c}}, {}};
  }
  if (!try_to_make(change))
    return false;
  number_of_bent_border_edges_ += there.size() == 1;
  for (std::uint32_t n : change.triangles)
    mesh_.is_kept[n] = false;
  if (is_bent && there.size() == 2)
    mesh_.faces[t] = mesh_.faces[there[there[0] == t]];
  if (is_bent)
    for (std::uint32_t v : {a, b}) {
      marked_[v].push_back(c);
      marked_[c].push_back(v);
      marked_[v].erase(std::remove(marked_[v].begin(), marked_[v].end(), v == a ? b : a), marked_[v].end());
    }
  for (std::uint32_t v : {a, b, c})
    look_at(v, change.triangles);
  return true;
}

// Moves a vertex toward the mean of its neighbors.
bool Thin_part_merger::move_to_mean(std::uint32_t v)
{
  if (is_hub(v) || !marked_[v].empty() || is_on_border(v))
    return false;
  Point mean{};
  const std::vector<std::uint32_t> around = neighbors(v);
  for (std::uint32_t w : around)
    for (std::size_t i = 0; i < 3; ++i)
      mean[i] += map_.points()[w][i] / double(around.size());
  return move(v, {mean}, {1, 0.5, 0.25});
}

// Moves a vertex toward a neighbor or away from it; a vertex of a line moves along the line.
bool Thin_part_merger::move_along_edges(std::uint32_t v)
{
  const bool is_on_line = marked_[v].size() == 2;
  if (is_hub(v) || (!is_on_line && (!marked_[v].empty() || is_on_border(v))))
    return false;
  std::vector<Point> toward;
  for (std::uint32_t w : is_on_line ? marked_[v] : neighbors(v))
    toward.push_back(map_.points()[w]);
  return move(v, toward, is_on_line ? std::vector<double>{0.5, 0.25, 0.1} : std::vector{0.5, 0.25, 0.1, -0.1, -0.25});
}

// Moves a vertex by one of these parts toward one of these points.
bool Thin_part_merger::move(std::uint32_t v, const std::vector<Point>& toward, const std::vector<double>& parts)
{
  if (is_fixed(v))
    return false;
  const Point old = map_.points()[v];
  Change change{at_vertex_[v], {}, {}};
  for (std::uint32_t t : change.triangles)
    change.corners.push_back(mesh_.triangles[t]);
  const std::vector<Space_triangle> before = places(change);
  for (double part : parts)
    for (const Point& end : toward) {
      Point p = old;
      for (std::size_t i = 0; i < 3; ++i)
        p[i] += part * (end[i] - old[i]);
      map_.move_vertex(v, p);
      if (improves(change, before) && is_near_enough(change)) {
        make(change);
        look_at(v);
        return true;
      }
    }
  map_.move_vertex(v, old);
  return false;
}

} // namespace CGAL::Intrinsic_triangulations::internal
