// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Dividing edges and faces where lines cross them.

#include <CGAL/Intrinsic_triangulations/surface_features.h>
#include <CGAL/Intrinsic_triangulations/errors.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {
namespace {

// What is nearer, as a part of the size of the face, has been rounded.
constexpr double rounding = 0x1p-40;

using Plane_vector = std::array<double, 2>;

Plane_vector difference(const Plane_vector& p, const Plane_vector& q) { return {p[0] - q[0], p[1] - q[1]}; }
double product(const Plane_vector& p, const Plane_vector& q) { return p[0] * q[0] + p[1] * q[1]; }
double area(const Plane_vector& p, const Plane_vector& q) { return p[0] * q[1] - p[1] * q[0]; }

} // namespace

// A halfedge from v to w, if there is one.
std::optional<Halfedge_index> Line_divider::halfedge(Vertex_index v, Vertex_index w) const
{
  for (Halfedge_index h : internal::Halfedges_around(complex_, v))
    if (complex_.source(h) == w)
      return complex_.opposite(h);
  return std::nullopt;
}

void Line_divider::keep(Vertex_index v, Vertex_index w)
{
  const auto h = halfedge(v, w);
  if (!h)
    throw Invalid_point_error("no edge joins vertex " + std::to_string(v.idx()) + " and vertex " +
                              std::to_string(w.idx()));
  edges_.insert(complex_.edge(*h));
}

void Line_divider::add_edge(Vertex_index v, Vertex_index w)
{
  Vertex_index before = (std::min)(v, w);
  const auto cuts = cuts_.find({before, (std::max)(v, w)});
  if (cuts != cuts_.end())
    for (const auto& [position, cut] : cuts->second) {
      keep(before, cut);
      before = cut;
    }
  keep(before, (std::max)(v, w));
}

void Line_divider::add_point(Corners corners)
{
  CGAL_precondition(!corners.empty() && corners.size() <= 3);
  double sum = 0;
  for (const auto& corner : corners)
    sum += corner.second;
  const auto is_gone = [sum](const auto& corner) { return corner.second < rounding * sum; };
  corners.erase(std::remove_if(corners.begin(), corners.end(), is_gone), corners.end());
  sum = 0;
  for (const auto& corner : corners)
    sum += corner.second;
  for (auto& corner : corners)
    corner.second /= sum;
  std::sort(corners.begin(), corners.end());
  const Vertex_index v = corners.size() == 1   ? corners[0].first
                         : corners.size() == 2 ? on_edge(corners)
                                               : in_face(corners);
  if (last_)
    connect(*last_, v);
  last_ = v;
}

Line_divider::Corners Line_divider::place(Vertex_index v) const
{
  return v.idx() < number_before_ ? Corners{{v, 1}} : places_[v.idx() - number_before_];
}

// Its weights at the second and third corner of the face, if it lies in it.
std::optional<Plane_vector> Line_divider::coordinates(Vertex_index v, const Face& face) const
{
  Plane_vector result{};
  for (const auto& [corner, weight] : place(v)) {
    const auto i = std::find(face.begin(), face.end(), corner) - face.begin();
    if (i == 3)
      return std::nullopt;
    if (i > 0)
      result[std::size_t(i - 1)] = weight;
  }
  return result;
}

// The new vertex at a point of a halfedge. Both parts of an edge that is kept are.
Vertex_index Line_divider::split(Halfedge_index h, const Corners& corners)
{
  const Vertex_index v = complex_.split_edge(h);
  add_place(corners);
  if (edges_.count(complex_.edge(h)) != 0)
    edges_.insert(complex_.edge(complex_.continuation(h)));
  return v;
}

Vertex_index Line_divider::on_edge(const Corners& corners)
{
  const Vertex_index from = corners[0].first, to = corners[1].first;
  const double position = corners[1].second;
  const auto known = cuts_.find({from, to});
  Vertex_index before = from, after = to;
  if (known != cuts_.end()) {
    const auto next = known->second.lower_bound(position - rounding);
    if (next != known->second.end() && next->first <= position + rounding)
      return next->second;
    if (next != known->second.begin())
      before = std::prev(next)->second;
    if (next != known->second.end())
      after = next->second;
  }
  const auto h = halfedge(before, after);
  if (!h || complex_.is_self_glued(complex_.edge(*h)))
    throw Invalid_point_error("no edge joins vertex " + std::to_string(from.idx()) + " and vertex " +
                              std::to_string(to.idx()));
  const Vertex_index v = split(*h, corners);
  cuts_[{from, to}].emplace(position, v);
  return v;
}

// Looks at all parts of the face.
Vertex_index Line_divider::in_face(const Corners& corners)
{
  const Face face{corners[0].first, corners[1].first, corners[2].first};
  const Plane_vector p{corners[1].second, corners[2].second};
  std::vector<Halfedge_index> sides;
  std::set<Face_index> found;
  const auto look_at = [&](Halfedge_index h) {
    if (!complex_.is_border(h) && coordinates(complex_.source(h), face) && coordinates(complex_.target(h), face) &&
        coordinates(complex_.target(complex_.next(h)), face) && found.insert(complex_.face(h)).second)
      sides.push_back(h);
  };
  for (Halfedge_index h : internal::Halfedges_around(complex_, face[0]))
    look_at(complex_.opposite(h));
  double best = -1;
  std::array<double, 3> weights{};
  Halfedge_index side;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Halfedge_index h = sides[i];
    const Plane_vector a = *coordinates(complex_.source(h), face), b = *coordinates(complex_.target(h), face),
                       c = *coordinates(complex_.target(complex_.next(h)), face);
    const double whole = area(difference(b, a), difference(c, a));
    const std::array<double, 3> w{area(difference(b, p), difference(c, p)) / whole,
                                  area(difference(c, p), difference(a, p)) / whole,
                                  area(difference(a, p), difference(b, p)) / whole};
    if (const double least = *std::min_element(w.begin(), w.end()); least > best) {
      best = least;
      weights = w;
      side = h;
    }
    for (Halfedge_index other : {h, complex_.next(h), complex_.prev(h)})
      look_at(complex_.opposite(other));
  }
  if (!side.is_valid() || best < -rounding)
    throw Invalid_point_error("no face has the corners " + std::to_string(face[0].idx()) + ", " +
                              std::to_string(face[1].idx()) + " and " + std::to_string(face[2].idx()));
  for (const bool is_at_corner : {true, false})
    for (std::size_t i = 0; i < 3; ++i, side = complex_.next(side)) {
      if (is_at_corner && weights[i] > 1 - 2 * rounding)
        return complex_.source(side);
      if (!is_at_corner && weights[(i + 2) % 3] < rounding)
        return split(side, corners);
    }
  const Vertex_index v = complex_.split_face(side);
  add_place(corners);
  return v;
}

// Makes the straight line between two vertices edges, and divides those that it crosses.
void Line_divider::connect(Vertex_index from, Vertex_index to)
{
  std::set<Vertex_index> all;
  for (Vertex_index end : {from, to})
    for (const auto& corner : place(end))
      all.insert(corner.first);
  while (from != to) {
    Halfedge_index along;
    for (Halfedge_index h : internal::Halfedges_around(complex_, from)) {
      const Halfedge_index out = complex_.opposite(h);
      if (complex_.target(out) == to) {
        along = out;
        break;
      }
      if (along.is_valid() || complex_.is_border(out))
        continue;
      const Vertex_index a = complex_.target(out), b = complex_.target(complex_.next(out));
      std::set<Vertex_index> corners = all;
      for (Vertex_index end : {a, b})
        for (const auto& corner : place(end))
          corners.insert(corner.first);
      if (corners.size() != 3)
        continue;
      Face face{};
      std::copy(corners.begin(), corners.end(), face.begin());
      const Plane_vector p = *coordinates(from, face), way = difference(*coordinates(to, face), p),
                         to_a = difference(*coordinates(a, face), p), to_b = difference(*coordinates(b, face), p);
      const auto is_along = [&](const Plane_vector& x) {
        return product(way, x) > 0 && product(way, x) <= product(way, way) &&
               std::abs(area(way, x)) <= rounding * std::hypot(way[0], way[1]) * std::hypot(x[0], x[1]);
      };
      if (is_along(to_a) || is_along(to_b)) {
        along = is_along(to_a) ? out : complex_.opposite(complex_.prev(out));
        continue;
      }
      const double left = area(way, to_a), right = area(way, to_b), t = left / (left - right);
      if (!(left * right < 0) || !(product(way, to_a) * (1 - t) + product(way, to_b) * t > 0))
        continue;
      Corners crossing;
      const Plane_vector x{p[0] + to_a[0] * (1 - t) + to_b[0] * t, p[1] + to_a[1] * (1 - t) + to_b[1] * t};
      const std::array<double, 3> weights{1 - x[0] - x[1], x[0], x[1]};
      for (std::size_t i = 0; i < 3; ++i)
        if (weights[i] > rounding)
          crossing.emplace_back(face[i], weights[i]);
      if (crossing.size() < 3)
        continue; // it would leave the face
      split(complex_.next(out), crossing);
      along = complex_.opposite(complex_.prev(out));
      break;
    }
    if (!along.is_valid())
      throw Invalid_point_error("two consecutive points of a line do not lie in one face");
    edges_.insert(complex_.edge(along));
    from = complex_.target(along);
  }
}

void Line_divider::add_place(const Corners& corners)
{
  std::array<double, 3> place{};
  for (const auto& [v, x] : corners)
    for (std::size_t axis = 0; axis < 3; ++axis)
      place[axis] += x * points_[v.idx()][axis];
  points_.push_back(place);
  places_.push_back(corners);
}

std::vector<bool> Line_divider::edges() const
{
  std::vector<bool> result(complex_.number_of_edges());
  for (Edge_index e : edges_)
    result[e.idx()] = true;
  return result;
}

} // namespace CGAL::Intrinsic_triangulations
