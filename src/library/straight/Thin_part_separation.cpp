// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Thin_part_merger: thin tubes, and the pieces that remain.

#include "Thin_part_merger.h"

#include <CGAL/Intrinsic_triangulations/internal/system/Disjoint_sets.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

// Some triangles around v get a vertex of their own at the same place.
void Thin_part_merger::move_to_copy(std::uint32_t v, const std::vector<std::uint32_t>& triangles)
{
  const std::uint32_t copy = add_vertex(map_.points()[v]);
  is_at_film_[copy] = is_at_film_[v];
  is_merged_[copy] = is_merged_[v];
  for (std::uint32_t t : triangles) {
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

// The triangles around v from one of them counterclockwise to the edge between v and another vertex; none if the border
// lies between.
std::vector<std::uint32_t> Thin_part_merger::fan_between(std::uint32_t first, std::uint32_t v, std::uint32_t to) const
{
  std::vector<std::uint32_t> result{first};
  std::uint32_t end = after(mesh_.triangles[first], after(mesh_.triangles[first], v));
  while (end != to) {
    const std::vector<std::uint32_t> there = triangles_at(v, end);
    const auto next = std::find_if(there.begin(), there.end(), [&](std::uint32_t t) {
      return after(mesh_.triangles[t], v) == end && std::count(result.begin(), result.end(), t) == 0;
    });
    if (next == there.end())
      return {};
    result.push_back(*next);
    end = after(mesh_.triangles[*next], after(mesh_.triangles[*next], v));
  }
  return result;
}

// Where the edge vw and two others run around a tube, cuts it there and closes both ends by triangles.
bool Thin_part_merger::cut_tube(std::uint32_t v, std::uint32_t w)
{
  const std::vector<std::uint32_t> a = neighbors(v), b = neighbors(w);
  std::vector<std::uint32_t> both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  for (std::uint32_t x : both) {
    if ((std::max)(length(w, x), length(x, v)) > maximum_deviation_)
      continue;
    const Triangle around{v, w, x};
    std::array<std::vector<std::uint32_t>, 3> fans; // left of these edges
    std::vector<std::uint32_t> beside;
    bool is_tube = true;
    for (std::size_t i = 0; i < 3 && is_tube; ++i) {
      const std::uint32_t p = around[i], next = around[(i + 1) % 3], previous = around[(i + 2) % 3];
      const std::vector<std::uint32_t> there = triangles_at(p, next);
      is_tube = there.size() == 2 && !is_fixed(p);
      for (std::uint32_t t : there) {
        const Triangle& corners = mesh_.triangles[t];
        is_tube = is_tube && std::count(corners.begin(), corners.end(), previous) == 0;
        if (after(corners, p) == next)
          fans[i] = fan_between(t, p, previous);
      }
      beside.insert(beside.end(), there.begin(), there.end());
      is_tube = is_tube && !fans[i].empty() && fans[i].size() < at_vertex_[p].size();
    }
    const Surface_part surface = is_tube ? surface_in(faces_of(beside)) : Surface_part{};
    std::vector<std::array<std::uint32_t, 2>> pairs;
    if (!is_tube || !are_near({map_.corners(around)}, surface.triangles, most_, pairs))
      continue;
    Triangle copy = around;
    for (std::size_t i = 0; i < 3; ++i) {
      copy[i] = std::uint32_t(at_vertex_.size());
      move_to_copy(around[i], fans[i]);
    }
    for (const Triangle& cap : {around, Triangle{copy[1], copy[0], copy[2]}}) {
      const std::uint32_t t = add_triangle(at_vertex_[cap[0]][0]);
      replace(t, cap);
      for (const auto& [number, f] : pairs)
        add_face(t, surface.faces[f]);
    }
    for (const Triangle& cap : {around, copy})
      for (std::uint32_t p : cap) {
        separate_fans_around(p); // an edge of four triangles may be two now
        look_at(p);
      }
    return true;
  }
  return false;
}

// An edge of four triangles is two edges that coincide, because a thin part of the surface lies between them. The
// triangles around v from one of them to the next one get a copy of v: the surface is cut along both edges, and closed
// again on each side.
bool Thin_part_merger::separate(std::uint32_t v, std::uint32_t w)
{
  if (is_fixed(v))
    return false;
  for (std::uint32_t first : triangles_at(v, w)) {
    if (after(mesh_.triangles[first], v) != w)
      continue;
    const std::vector<std::uint32_t> fan = fan_between(first, v, w);
    if (fan.empty() || fan.size() == at_vertex_[v].size())
      continue;
    move_to_copy(v, fan);
    const std::uint32_t copy = std::uint32_t(at_vertex_.size()) - 1;
    separate_fans_around(copy);
    separate_fans_around(v);
    look_at(v);
    look_at(copy);
    look_at(w);
    return true;
  }
  return false;
}

// Separates fans at a vertex and at its neighbors.
void Thin_part_merger::separate_fans_around(std::uint32_t v)
{
  separate_fans(v);
  for (std::uint32_t w : neighbors(v))
    separate_fans(w);
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

// The connected pieces, each by one of its vertices.
std::map<std::uint32_t, std::vector<std::uint32_t>> Thin_part_merger::pieces() const
{
  Disjoint_sets sets(map_.points().size());
  for (const Triangle& t : mesh_.triangles)
    if (!is_removed(t) && !is_of_film_[t[0]]) {
      sets.unite(t[0], t[1]);
      sets.unite(t[1], t[2]);
    }
  std::map<std::uint32_t, std::vector<std::uint32_t>> result;
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
    if (!is_removed(mesh_.triangles[t]) && !is_left_out(t))
      result[sets.find(mesh_.triangles[t][0])].push_back(t);
  return result;
}

// Which component of the surface a triangle belongs to.
std::uint32_t Thin_part_merger::component_of(std::uint32_t t) const { return component_of_face_[mesh_.faces[t].idx()]; }

std::size_t Thin_part_merger::number_of_new_components() const
{
  const std::map<std::uint32_t, std::vector<std::uint32_t>> pieces = this->pieces();
  std::set<std::uint32_t> components;
  for (const auto& [root, piece] : pieces)
    components.insert(component_of(piece[0]));
  return pieces.size() - components.size();
}

bool Thin_part_merger::is_bad_piece(const std::vector<std::uint32_t>& piece) const
{
  return std::any_of(piece.begin(), piece.end(), [this](std::uint32_t t) { return is_bad(t) || is_folded(t); }) ||
         (piece.size() == 2 && std::is_permutation(mesh_.triangles[piece[0]].begin(), mesh_.triangles[piece[0]].end(),
                                                   mesh_.triangles[piece[1]].begin()));
}

// Pieces of a few triangles, some of which are bad, or two of which have the same corners, or whose component came
// apart. Pieces of more triangles come first. None has a fixed vertex.
std::vector<std::vector<std::uint32_t>> Thin_part_merger::small_pieces() const
{
  constexpr std::size_t most_triangles = 64;
  const std::map<std::uint32_t, std::vector<std::uint32_t>> all = pieces();
  std::map<std::uint32_t, std::size_t> number_of_pieces;
  for (const auto& [root, piece] : all)
    ++number_of_pieces[component_of(piece[0])];
  std::vector<std::vector<std::uint32_t>> result;
  for (const auto& [root, piece] : all) {
    const auto has_fixed_corner = [&](std::uint32_t t) {
      const Triangle& corners = mesh_.triangles[t];
      return std::any_of(corners.begin(), corners.end(), [&](std::uint32_t v) { return is_fixed(v); });
    };
    if (piece.size() <= most_triangles && (number_of_pieces[component_of(piece[0])] > 1 || is_bad_piece(piece)) &&
        std::none_of(piece.begin(), piece.end(), has_fixed_corner))
      result.push_back(piece);
  }
  std::stable_sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return result;
}

// Removes such pieces if they lie along others that stay. Of the others, neighbors become one rod, or each bad one
// becomes a rod of its own.
void Thin_part_merger::remove_pieces()
{
  const std::vector<std::vector<std::uint32_t>> pieces = small_pieces();
  std::vector<bool> is_other(mesh_.triangles.size(), true);
  std::vector<Space_box> boxes, other_boxes;
  for (const std::vector<std::uint32_t>& piece : pieces) {
    boxes.emplace_back(map_.corners(mesh_.triangles[piece[0]]));
    for (std::uint32_t t : piece) {
      is_other[t] = false;
      boxes.back().add(Space_box(map_.corners(mesh_.triangles[t])));
    }
  }
  std::vector<std::uint32_t> others;
  for (std::uint32_t t = 0; t < is_other.size(); ++t)
    if (is_other[t] && !is_removed(mesh_.triangles[t]) && !is_left_out(t)) {
      others.push_back(t);
      other_boxes.emplace_back(map_.corners(mesh_.triangles[t]));
    }
  const double distance = 2 * maximum_deviation_;
  const Box_tree tree(std::move(other_boxes)), piece_tree(std::move(boxes));
  const auto near_pieces = [&](std::uint32_t i) { return piece_tree.near(piece_tree.box(i), distance); };
  std::vector<bool> is_left(pieces.size(), false);
  for (std::uint32_t i = 0; i < pieces.size(); ++i) {
    report(0.8 + 0.05 * double(i) / double(pieces.size()));
    Change change{pieces[i], std::vector<Triangle>(pieces[i].size(), Triangle{0, 0, 0}), {}};
    for (std::uint32_t other : tree.near(piece_tree.box(i), distance))
      change.beside.push_back(others[other]);
    for (std::uint32_t other : near_pieces(i))
      if (is_left[other])
        change.beside.insert(change.beside.end(), pieces[other].begin(), pieces[other].end());
    is_left[i] = !is_near_enough(change);
    if (is_left[i])
      continue;
    remove_piece(change, pieces[i].size());
    ++number_of_removed_pieces_;
  }
  Disjoint_sets sets(pieces.size());
  for (std::uint32_t i = 0; i < pieces.size(); ++i)
    for (std::uint32_t other : near_pieces(i))
      if (is_left[i] && is_left[other] && component_of(pieces[i][0]) == component_of(pieces[other][0]))
        sets.unite(i, other);
  std::map<std::uint32_t, std::vector<std::uint32_t>> groups;
  for (std::uint32_t i = 0; i < pieces.size(); ++i)
    if (is_left[i])
      groups[sets.find(i)].push_back(i);
  for (const auto& [root, group] : groups) {
    report(0.87);
    std::vector<std::uint32_t> all;
    for (std::uint32_t i : group)
      all.insert(all.end(), pieces[i].begin(), pieces[i].end());
    if (group.size() > 1 && replace_by_rod(all))
      continue;
    for (std::uint32_t i : group)
      if (is_bad_piece(pieces[i]))
        replace_by_rod(pieces[i]);
  }
}

// Its vertices move to the nearest vertex of the triangles that then stand for its faces.
// \param number_of_triangles those of the piece, which come first
void Thin_part_merger::remove_piece(const Change& change, std::size_t number_of_triangles)
{
  std::vector<std::uint32_t> vertices;
  for (std::size_t i = 0; i < number_of_triangles; ++i)
    for (std::uint32_t v : mesh_.triangles[change.triangles[i]])
      if (v < images_.size())
        vertices.push_back(v);
  make(change);
  for (std::uint32_t v : vertices)
    for (const auto& [t, f] : change.stands_for)
      for (std::uint32_t w : mesh_.triangles[t])
        if (images_[v] == v || length(v, w) < length(v, images_[v]))
          images_[v] = w;
}

// Triangles around a segment: rings of three vertices, turned by 60 degrees one after the other. Each angle is above 25
// degrees. Long rods end before the segment does, so that they do not touch what that touches; the points at the ends are
// at most radius / 2 beyond the segment.
static std::pair<std::vector<std::array<double, 3>>, std::vector<Straight_triangles::Triangle>>
rod_around(const std::array<double, 3>& p, const std::array<double, 3>& q, double radius)
{
  using Point = std::array<double, 3>;
  const double length = std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
  const auto number = std::uint32_t(std::ceil(length / (3.5 * radius))) + 1 + (length == 0);
  const double step = (std::max)((length - radius) / (number - 1), radius), begin = (length - step * (number - 1)) / 2;
  std::array<Point, 3> axes{};
  std::size_t smallest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    axes[0][i] = length > 0 ? (q[i] - p[i]) / length : i == 0;
    if (std::abs(axes[0][i]) < std::abs(axes[0][smallest]))
      smallest = i;
  }
  const auto across = [](const Point& x, const Point& y) {
    const Point z{x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
    const double norm = std::hypot(z[0], z[1], z[2]);
    return Point{z[0] / norm, z[1] / norm, z[2] / norm};
  };
  Point unit{};
  unit[smallest] = 1;
  axes[1] = across(axes[0], unit);
  axes[2] = across(axes[0], axes[1]);
  std::vector<Point> points;
  std::vector<Straight_triangles::Triangle> triangles{{0, 2, 1}};
  for (std::uint32_t k = 0; k < number; ++k)
    for (std::uint32_t i = 0; i < 3; ++i) {
      const double angle = CGAL_PI / 3 * (2 * i + k);
      points.push_back(p);
      for (std::size_t axis = 0; axis < 3; ++axis)
        points.back()[axis] += (begin + step * k) * axes[0][axis] +
                               radius * (std::cos(angle) * axes[1][axis] + std::sin(angle) * axes[2][axis]);
      if (k > 0) {
        const std::uint32_t next = (i + 1) % 3, here = 3 * k, before = here - 3;
        triangles.push_back({before + i, before + next, here + i});
        triangles.push_back({here + i, before + next, here + next});
      }
    }
  triangles.push_back({3 * number - 3, 3 * number - 2, 3 * number - 1});
  return {points, triangles};
}

// Replaces a piece that is a wire, or a point, by a rod around it that is as thick as the distance allows.
bool Thin_part_merger::replace_by_rod(const std::vector<std::uint32_t>& piece)
{
  // In a wire, the point farthest from any other point is an end.
  std::uint32_t first = mesh_.triangles[piece[0]][0], last = first;
  for (std::uint32_t* end : {&first, &last}) {
    const std::uint32_t from = end == &first ? last : first;
    for (std::uint32_t t : piece)
      for (std::uint32_t v : mesh_.triangles[t])
        if (length(from, v) > length(from, *end))
          *end = v;
  }
  if (!(length(first, last) < 0x1p16 * maximum_deviation_))
    return false; // that would be too many triangles
  const Point p = map_.points()[first], q = map_.points()[last];
  for (double radius = maximum_deviation_ * 0.7; radius > maximum_deviation_ / 8; radius *= 0.7) {
    const auto [points, triangles] = rod_around(p, q, radius);
    Change change{piece, std::vector<Triangle>(piece.size(), Triangle{0, 0, 0}), {}};
    const auto begin = std::uint32_t(at_vertex_.size());
    for (const Point& point : points)
      add_vertex(point);
    for (const Triangle& t : triangles) {
      change.triangles.push_back(add_triangle(piece[0]));
      change.corners.push_back({begin + t[0], begin + t[1], begin + t[2]});
    }
    if (is_near_enough(change)) {
      remove_piece(change, piece.size());
      ++number_of_rods_;
      return true;
    }
  }
  return false;
}

} // namespace CGAL::Intrinsic_triangulations::internal
