// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Thin_part_merger: the order of its steps, and the contraction of edges.

#include "Thin_part_merger.h"

#include <algorithm>
#include <iterator>
#include <tuple>

namespace CGAL::Intrinsic_triangulations::internal {

static constexpr double not_moved = -1;

Thin_part_merger::Thin_part_merger(Straight_map& map, Straight_triangles& mesh, double thin_angle,
                                   double maximum_deviation)
  : map_(map), mesh_(mesh), thin_angle_(thin_angle), maximum_deviation_(maximum_deviation),
    at_vertex_(map.points().size()), marked_(map.points().size()), moved_(mesh.triangles.size(), not_moved)
{
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
    for (std::uint32_t v : mesh_.triangles[t])
      at_vertex_[v].push_back(t);
  for (const auto& [v, w] : mesh_.marked_edges) {
    marked_[v].push_back(w);
    marked_[w].push_back(v);
  }
}

Straight_map::Distance Thin_part_merger::operator()()
{
  // The thinnest last, which are looked at first.
  std::vector<std::pair<double, std::uint32_t>> bad;
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
    if (is_bad(t))
      bad.emplace_back(smallest_angle(map_.corners(mesh_.triangles[t])).first, t);
  std::sort(bad.rbegin(), bad.rend());
  for (const auto& [angle, t] : bad)
    to_look_at_.push_back(t);
  while (!to_look_at_.empty()) {
    const std::uint32_t t = to_look_at_.back();
    to_look_at_.pop_back();
    if (is_bad(t))
      improve(t);
  }
  remove_pieces();
  const Straight_map::Distance result = largest_distance();
  merge_removed_vertices();
  mesh_.marked_edges.clear();
  for (std::uint32_t v = 0; v < marked_.size(); ++v)
    for (std::uint32_t w : marked_[v])
      if (v < w && number_of_triangles_at(v, w) > 0)
        mesh_.marked_edges.push_back({v, w});
  std::sort(mesh_.marked_edges.begin(), mesh_.marked_edges.end());
  mesh_.marked_edges.erase(std::unique(mesh_.marked_edges.begin(), mesh_.marked_edges.end()), mesh_.marked_edges.end());
  return result;
}

Straight_map::Distance Thin_part_merger::largest_distance() const
{
  Straight_map::Distance result = map_.largest_distance();
  if (removed_.value > result.value)
    result = removed_;
  for (std::uint32_t t = 0; t < moved_.size(); ++t)
    if (moved_[t] > result.value && !is_removed(mesh_.triangles[t]))
      result = {moved_[t], map_.points()[mesh_.triangles[t][0]]};
  return result;
}

// Whether a triangle is thin, or has a side with too many others.
bool Thin_part_merger::is_bad(std::uint32_t t) const
{
  const Triangle& corners = mesh_.triangles[t];
  return !is_removed(corners) &&
         ((!mesh_.is_kept[t] && smallest_angle(map_.corners(corners)).first < thin_angle_) ||
          number_of_triangles_at(corners[0], corners[1]) > 2 || number_of_triangles_at(corners[1], corners[2]) > 2 ||
          number_of_triangles_at(corners[2], corners[0]) > 2);
}

std::vector<std::uint32_t> Thin_part_merger::triangles_at(std::uint32_t v, std::uint32_t w) const
{
  std::vector<std::uint32_t> result;
  for (std::uint32_t t : at_vertex_[v])
    if (std::count(mesh_.triangles[t].begin(), mesh_.triangles[t].end(), w) != 0)
      result.push_back(t);
  return result;
}

std::vector<std::uint32_t> Thin_part_merger::neighbors(std::uint32_t v) const
{
  std::vector<std::uint32_t> result;
  for (std::uint32_t t : at_vertex_[v])
    for (std::uint32_t w : mesh_.triangles[t])
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

double Thin_part_merger::length(std::uint32_t v, std::uint32_t w) const
{
  const Point &p = map_.points()[v], &q = map_.points()[w];
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

void Thin_part_merger::look_at(std::uint32_t v)
{
  to_look_at_.insert(to_look_at_.end(), at_vertex_[v].begin(), at_vertex_[v].end());
}

void Thin_part_merger::replace(std::uint32_t t, const Triangle& corners)
{
  Triangle& old = mesh_.triangles[t];
  if (!is_removed(old))
    for (std::uint32_t v : old)
      at_vertex_[v].erase(std::find(at_vertex_[v].begin(), at_vertex_[v].end(), t));
  old = corners;
  if (!is_removed(old))
    for (std::uint32_t v : old)
      at_vertex_[v].push_back(t);
}

// How far points have moved at most whose images a triangle has.
double Thin_part_merger::moved(std::uint32_t t) const
{
  if (moved_[t] != not_moved)
    return moved_[t];
  double result = map_.distance_on(mesh_.faces[t]).value;
  if (const auto taken = taken_.find(t); taken != taken_.end())
    for (Face_index f : taken->second)
      result = (std::max)(result, map_.distance_on(f).value);
  return result;
}

// Gives what a triangle stands for, that has shrunk to the edge vw, to another one there.
void Thin_part_merger::hand_on(std::uint32_t t, std::uint32_t v, std::uint32_t w)
{
  const std::vector<std::uint32_t> there = triangles_at(v, w);
  if (there.empty() || (moved_[t] != not_moved)) {
    const double distance = moved(t);
    if (!there.empty())
      moved_[there[0]] = (std::max)(moved(there[0]), distance);
    else if (distance > removed_.value)
      removed_ = {distance, map_.points()[v]};
    return;
  }
  std::vector<Face_index>& faces = taken_[there[0]];
  faces.push_back(mesh_.faces[t]);
  if (const auto own = taken_.find(t); own != taken_.end()) {
    const std::vector<Face_index> of_t = own->second;
    taken_[there[0]].insert(taken_[there[0]].end(), of_t.begin(), of_t.end());
  }
}

bool Thin_part_merger::improve(std::uint32_t t)
{
  std::array<std::tuple<double, std::uint32_t, std::uint32_t>, 3> sides;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t v = mesh_.triangles[t][i], w = mesh_.triangles[t][(i + 1) % 3];
    sides[i] = {length(v, w), v, w};
  }
  std::sort(sides.begin(), sides.end());
  for (const auto& [length, v, w] : sides)
    if (number_of_triangles_at(v, w) > 2)
      return separate(v, w) || separate(w, v);
  for (const auto& [length, v, w] : sides)
    if (length <= maximum_deviation_ && (contract(v, w) || contract(w, v)))
      return true;
  return cut_cap(t);
}

// Whether the triangles stay a manifold of the same kind: the links of both vertices have nothing in common but the link
// of the edge. (T. Dey, H. Edelsbrunner, S. Guha, D. Nekhayev, "Topology preserving edge contraction", 1999.)
bool Thin_part_merger::is_contractible(std::uint32_t from, std::uint32_t to)
{
  const std::vector<std::uint32_t> a = neighbors(from), b = neighbors(to);
  std::vector<std::uint32_t> both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  const std::size_t number = number_of_triangles_at(from, to);
  if (is_fixed(from) || both.size() != number || number > 2)
    return false;
  for (std::uint32_t v : {from, to}) // an edge of three triangles is no surface, but may become one
    for (std::uint32_t w : v == from ? a : b)
      if (number_of_triangles_at(v, w) > 2)
        return false;
  const auto has_in_link = [&](std::uint32_t v) {
    return std::any_of(at_vertex_[v].begin(), at_vertex_[v].end(), [&](std::uint32_t t) {
      return std::count(mesh_.triangles[t].begin(), mesh_.triangles[t].end(), both[0]) != 0 &&
             std::count(mesh_.triangles[t].begin(), mesh_.triangles[t].end(), both[1]) != 0;
    });
  };
  if (number == 2 && has_in_link(from) && has_in_link(to)) // the edge between them
    return false;
  return number == 1 || !(is_on_border(from) && is_on_border(to));
}

static std::array<double, 3> normal_of(const std::array<std::array<double, 3>, 3>& p)
{
  std::array<double, 3> result{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    result[i] = (p[1][j] - p[0][j]) * (p[2][k] - p[0][k]) - (p[1][k] - p[0][k]) * (p[2][j] - p[0][j]);
  }
  return result;
}

// Whether a triangle that is not thin turns over; the normals of thin ones mean nothing.
static bool turns_over(const std::array<std::array<double, 3>, 3>& before,
                       const std::array<std::array<double, 3>, 3>& after, double thin_angle)
{
  const auto m = normal_of(before), n = normal_of(after);
  return smallest_angle(before).first >= thin_angle && smallest_angle(after).first >= thin_angle &&
         m[0] * n[0] + m[1] * n[1] + m[2] * n[2] < 0;
}

// Whether fewer angles around the edge are small, or the smallest one grows, and no triangle turns over.
bool Thin_part_merger::improves(std::uint32_t from, std::uint32_t to) const
{
  double before = 180, after = 180;
  int number_of_thin = 0; // how many there are less
  for (std::uint32_t v : {from, to})
    for (std::uint32_t t : at_vertex_[v]) {
      const Triangle& corners = mesh_.triangles[t];
      const auto at_from = std::find(corners.begin(), corners.end(), from);
      const bool vanishes = at_from != corners.end() && std::count(corners.begin(), corners.end(), to) != 0;
      if (vanishes && v == to)
        continue;
      const std::array<Point, 3> old = map_.corners(corners);
      const double angle = smallest_angle(old).first;
      if (!mesh_.is_kept[t]) {
        before = (std::min)(before, angle);
        number_of_thin += angle < thin_angle_;
      }
      if (vanishes)
        continue;
      std::array<Point, 3> points = old;
      if (at_from != corners.end())
        points[std::size_t(at_from - corners.begin())] = map_.points()[to];
      if (turns_over(old, points, thin_angle_))
        return false;
      if (const double moved = smallest_angle(points).first; !mesh_.is_kept[t]) {
        if (at_from != corners.end())
          after = (std::min)(after, moved);
        number_of_thin -= moved < thin_angle_;
      }
    }
  return number_of_thin > 0 || (number_of_thin == 0 && after > before);
}

bool Thin_part_merger::contract(std::uint32_t from, std::uint32_t to)
{
  if (!is_contractible(from, to) || !improves(from, to))
    return false;
  const double step = length(from, to);
  for (std::uint32_t t : at_vertex_[from])
    if (moved_[t] != not_moved && map_.bound(moved_[t] + step) > maximum_deviation_)
      return false;
  Straight_map::Undo undo = map_.merge(from, to);
  if (map_.bound(map_.distance_around(to).value) > maximum_deviation_) {
    map_.undo(undo);
    return false;
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> vanished; // and their third corners
  for (std::uint32_t t : std::vector<std::uint32_t>(at_vertex_[from])) {
    Triangle corners = mesh_.triangles[t];
    if (moved_[t] != not_moved)
      moved_[t] += step;
    if (std::count(corners.begin(), corners.end(), to) != 0) {
      vanished.emplace_back(
        t, *std::find_if(corners.begin(), corners.end(), [&](std::uint32_t v) { return v != from && v != to; }));
      corners = {to, to, to};
    } else {
      *std::find(corners.begin(), corners.end(), from) = to;
    }
    replace(t, corners);
  }
  for (const auto& [t, w] : vanished)
    hand_on(t, to, w);
  for (std::uint32_t w : std::exchange(marked_[from], {})) {
    std::replace(marked_[w].begin(), marked_[w].end(), from, to);
    if (w != to)
      marked_[to].push_back(w);
  }
  look_at(to);
  return true;
}

} // namespace CGAL::Intrinsic_triangulations::internal
