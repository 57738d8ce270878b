// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Thin_part_merger: caps, edges of four triangles, and pieces that are left.

#include "Thin_part_merger.h"

#include <CGAL/Intrinsic_triangulations/Point_location.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Disjoint_sets.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace CGAL::Intrinsic_triangulations::internal {

static std::uint32_t after(const Straight_triangles::Triangle& corners, std::uint32_t v)
{
  return corners[std::size_t(std::find(corners.begin(), corners.end(), v) - corners.begin() + 1) % 3];
}

// Bends the longest side ab of a triangle to the third corner c: the triangle vanishes, and that beyond is divided. No
// point moves farther than the height of c.
bool Thin_part_merger::cut_cap(std::uint32_t t)
{
  const Triangle corners = mesh_.triangles[t];
  std::size_t i = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (length(corners[k], corners[(k + 1) % 3]) > length(corners[i], corners[(i + 1) % 3]))
      i = k;
  const std::uint32_t a = corners[i], b = corners[(i + 1) % 3], c = corners[(i + 2) % 3];
  const std::vector<std::uint32_t> there = triangles_at(a, b);
  if (there.size() > 2 || number_of_triangles_at(b, c) > 2 || number_of_triangles_at(c, a) > 2 ||
      (is_fixed(a) && is_fixed(b)))
    return false;
  const double height =
    std::sin(smallest_angle(map_.corners(corners)).first * CGAL_PI / 180) * (std::max)(length(b, c), length(c, a));
  const bool is_marked = std::count(marked_[a].begin(), marked_[a].end(), b) != 0;
  if (there.size() == 1) { // on the border
    const double distance = moved(t) + height;
    if (number_of_triangles_at(b, c) != 2 || number_of_triangles_at(c, a) != 2 || is_on_border(c) ||
        map_.bound(distance) > maximum_deviation_)
      return false;
    replace(t, {a, a, a});
    ++number_of_bent_border_edges_;
    for (std::uint32_t v : {a, b}) {
      const std::uint32_t n = triangles_at(v, c)[0];
      set_moved(n, (std::max)(moved(n), distance));
    }
  } else {
    const std::uint32_t n = there[there[0] == t];
    const std::uint32_t d = after(mesh_.triangles[n], a);
    const double distance = (std::max)(moved(t), moved(n)) + height;
    if (after(mesh_.triangles[n], b) != a || d == c || number_of_triangles_at(c, d) != 0 ||
        map_.bound(distance) > maximum_deviation_)
      return false;
    const double angle_beyond = smallest_angle(map_.corners(mesh_.triangles[n])).first;
    if (mesh_.is_kept[n] && angle_beyond < thin_angle_)
      return false;
    const Triangle first{a, d, c}, second{d, b, c};
    const double before = (std::min)(smallest_angle(map_.corners(corners)).first, angle_beyond);
    if (!((std::min)(smallest_angle(map_.corners(first)).first, smallest_angle(map_.corners(second)).first) > before) ||
        turns_over(map_.corners(mesh_.triangles[n]), map_.corners(first), thin_angle_) ||
        turns_over(map_.corners(mesh_.triangles[n]), map_.corners(second), thin_angle_))
      return false;
    set_moved(t, distance);
    set_moved(n, distance);
    replace(t, first);
    replace(n, second);
    mesh_.faces[t] = mesh_.faces[n];
    mesh_.is_kept[t] = mesh_.is_kept[n] = false;
  }
  if (is_marked)
    for (std::uint32_t v : {a, b}) {
      marked_[v].push_back(c);
      marked_[c].push_back(v);
      marked_[v].erase(std::remove(marked_[v].begin(), marked_[v].end(), v == a ? b : a), marked_[v].end());
    }
  for (std::uint32_t v : {a, b, c})
    look_at(v);
  return true;
}

// Some triangles around v get a vertex of their own at the same place.
void Thin_part_merger::move_to_copy(std::uint32_t v, const std::vector<std::uint32_t>& triangles)
{
  const std::uint32_t copy = map_.add_copy(v);
  at_vertex_.emplace_back();
  marked_.emplace_back();
  for (std::uint32_t t : triangles) {
    set_moved(t, moved(t));
    Triangle corners = mesh_.triangles[t];
    *std::find(corners.begin(), corners.end(), v) = copy;
    replace(t, corners);
  }
  for (std::uint32_t w : neighbors(copy))
    if (std::count(marked_[v].begin(), marked_[v].end(), w) != 0) {
      marked_[copy].push_back(w);
      marked_[w].push_back(copy);
    }
}

// An edge of four triangles is two that coincide, as a thin part of the surface is between them. The triangles around v
// from one of them to the next one get a copy of v: the surface is cut along both edges, and closed again on each side.
bool Thin_part_merger::separate(std::uint32_t v, std::uint32_t w)
{
  if (is_fixed(v))
    return false;
  for (std::uint32_t first : triangles_at(v, w)) {
    if (after(mesh_.triangles[first], v) != w)
      continue;
    std::vector<std::uint32_t> fan{first};
    std::uint32_t end = after(mesh_.triangles[first], w);
    while (end != w) {
      const std::vector<std::uint32_t> there = triangles_at(v, end);
      const auto next = std::find_if(there.begin(), there.end(), [&](std::uint32_t t) {
        return after(mesh_.triangles[t], v) == end && std::count(fan.begin(), fan.end(), t) == 0;
      });
      if (next == there.end()) // the border
        break;
      fan.push_back(*next);
      end = after(mesh_.triangles[*next], end);
    }
    if (end != w || fan.size() == at_vertex_[v].size())
      continue;
    move_to_copy(v, fan);
    const std::uint32_t copy = std::uint32_t(at_vertex_.size()) - 1;
    for (std::uint32_t x : neighbors(copy))
      separate_fans(x);
    separate_fans(v);
    look_at(v);
    look_at(copy);
    look_at(w);
    return true;
  }
  return false;
}

// Gives each fan of triangles around v a vertex of its own.
void Thin_part_merger::separate_fans(std::uint32_t v)
{
  const std::vector<std::uint32_t> all = at_vertex_[v];
  Disjoint_sets fans(all.size());
  std::map<std::uint32_t, std::uint32_t> first; // for each neighbor, a triangle
  for (std::uint32_t i = 0; i < all.size(); ++i)
    for (std::uint32_t w : mesh_.triangles[all[i]])
      if (w != v)
        fans.unite(first.try_emplace(w, i).first->second, i);
  std::vector<std::size_t> number_of;
  const std::size_t n = fans.number(number_of);
  for (std::size_t fan = 1; fan < n; ++fan) {
    std::vector<std::uint32_t> triangles;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (number_of[i] == fan)
        triangles.push_back(all[i]);
    move_to_copy(v, triangles);
  }
}

// Whether each point of a triangle is within a distance of one of the others. The distance from a convex set is convex, so
// it is largest at a corner.
bool Thin_part_merger::is_near_others(const std::array<Point, 3>& corners, const std::vector<std::uint32_t>& others,
                                      double distance, int depth) const
{
  // Those whose boxes are near the box of the triangle.
  std::vector<std::uint32_t> candidates;
  std::copy_if(others.begin(), others.end(), std::back_inserter(candidates), [&](std::uint32_t t) {
    const std::array<Point, 3> other = map_.corners(mesh_.triangles[t]);
    for (std::size_t i = 0; i < 3; ++i)
      if ((std::min)({other[0][i], other[1][i], other[2][i]}) - distance >
            (std::max)({corners[0][i], corners[1][i], corners[2][i]}) ||
          (std::max)({other[0][i], other[1][i], other[2][i]}) + distance <
            (std::min)({corners[0][i], corners[1][i], corners[2][i]}))
        return false;
    return true;
  });
  const auto is_near = [&](std::uint32_t t) {
    return std::all_of(corners.begin(), corners.end(), [&](const Point& p) {
      std::array<Point, 3> seen = map_.corners(mesh_.triangles[t]);
      for (Point& q : seen)
        for (std::size_t i = 0; i < 3; ++i)
          q[i] -= p[i];
      return nearest_to_origin(seen).second <= distance * distance;
    });
  };
  if (std::any_of(candidates.begin(), candidates.end(), is_near))
    return true;
  if (depth == 0 || candidates.empty())
    return false;
  std::size_t i = 0; // the longest side is divided
  const auto squared = [&](std::size_t k) {
    double sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      sum += std::pow(corners[k][axis] - corners[(k + 1) % 3][axis], 2);
    return sum;
  };
  for (std::size_t k = 1; k < 3; ++k)
    if (squared(k) > squared(i))
      i = k;
  std::array<Point, 3> first = corners, second = corners;
  for (std::size_t axis = 0; axis < 3; ++axis)
    first[i][axis] = second[(i + 1) % 3][axis] = (corners[i][axis] + corners[(i + 1) % 3][axis]) / 2;
  return is_near_others(first, candidates, distance, depth - 1) &&
         is_near_others(second, candidates, distance, depth - 1);
}

// Connected triangles, some of them bad, or two with the same corners; more triangles come first.
std::vector<std::vector<std::uint32_t>> Thin_part_merger::bad_pieces() const
{
  Disjoint_sets sets(map_.points().size());
  for (const Triangle& t : mesh_.triangles)
    if (!is_removed(t)) {
      sets.unite(t[0], t[1]);
      sets.unite(t[1], t[2]);
    }
  std::map<std::uint32_t, std::vector<std::uint32_t>> pieces;
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
    if (!is_removed(mesh_.triangles[t]))
      pieces[sets.find(mesh_.triangles[t][0])].push_back(t);
  std::vector<std::vector<std::uint32_t>> result;
  for (const auto& [root, piece] : pieces)
    if (std::any_of(piece.begin(), piece.end(), [this](std::uint32_t t) { return is_bad(t); }) ||
        (piece.size() == 2 && std::is_permutation(mesh_.triangles[piece[0]].begin(), mesh_.triangles[piece[0]].end(),
                                                  mesh_.triangles[piece[1]].begin())))
      result.push_back(piece);
  std::stable_sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return result;
}

// Removes such pieces, if they are small and lie along others that stay.
void Thin_part_merger::remove_pieces()
{
  constexpr std::size_t most_triangles = 64;
  constexpr int deepest = 10;
  const std::vector<std::vector<std::uint32_t>> pieces = bad_pieces();
  std::vector<bool> is_other(mesh_.triangles.size(), true);
  for (const std::vector<std::uint32_t>& piece : pieces)
    for (std::uint32_t t : piece)
      is_other[t] = false;
  std::vector<std::uint32_t> others;
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
    if (is_other[t] && !is_removed(mesh_.triangles[t]))
      others.push_back(t);
  for (const std::vector<std::uint32_t>& piece : pieces) {
    double distance = 0;
    bool is_movable = piece.size() <= most_triangles;
    for (std::uint32_t t : piece) {
      distance = (std::max)(distance, moved(t));
      for (std::uint32_t v : mesh_.triangles[t])
        is_movable = is_movable && !is_fixed(v);
    }
    if (!is_movable || others.empty()) {
      others.insert(others.end(), piece.begin(), piece.end());
      continue;
    }
    const auto is_near = [&](double rest) {
      return rest > 0 && std::all_of(piece.begin(), piece.end(), [&](std::uint32_t t) {
               return is_near_others(map_.corners(mesh_.triangles[t]), others, rest, deepest);
             });
    };
    double rest = (maximum_deviation_ - map_.bound(distance)) * (1 - 1e-9);
    if (is_near(rest)) {
      while (is_near(rest / 2) && rest > maximum_deviation_ / 1024)
        rest /= 2;
      if (distance + rest > removed_.value)
        removed_ = {distance + rest, map_.points()[mesh_.triangles[piece[0]][0]]};
      for (std::uint32_t t : piece) {
        removed_vertices_.insert(removed_vertices_.end(), mesh_.triangles[t].begin(), mesh_.triangles[t].end());
        replace(t, {0, 0, 0});
      }
      ++number_of_removed_pieces_;
    } else {
      double sufficient = maximum_deviation_;
      for (int i = 0; i < 20 && !is_near(sufficient); ++i)
        sufficient *= 1.5;
      sufficient_deviation_ = (std::max)(sufficient_deviation_, distance + sufficient);
      others.insert(others.end(), piece.begin(), piece.end());
    }
  }
}

// They get the place of the nearest vertex that is left.
void Thin_part_merger::merge_removed_vertices()
{
  std::sort(removed_vertices_.begin(), removed_vertices_.end());
  removed_vertices_.erase(std::unique(removed_vertices_.begin(), removed_vertices_.end()), removed_vertices_.end());
  for (std::uint32_t v : removed_vertices_) {
    std::uint32_t nearest = v;
    for (std::uint32_t w = 0; w < at_vertex_.size(); ++w)
      if (!at_vertex_[w].empty() && (nearest == v || length(v, w) < length(v, nearest)))
        nearest = w;
    if (nearest != v)
      map_.merge(v, nearest);
  }
}

} // namespace CGAL::Intrinsic_triangulations::internal
