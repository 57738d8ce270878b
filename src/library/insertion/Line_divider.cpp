// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Dividing edges and faces where lines cross them.

#include <CGAL/Intrinsic_triangulations/surface_features.h>
#include <CGAL/Intrinsic_triangulations/errors.h>

#include <CGAL/assertions.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

// A halfedge from v to w, if there is one.
std::optional<Halfedge_index> Line_divider::halfedge(Vertex_index v, Vertex_index w) const
{
  for (Halfedge_index h : internal::Halfedges_around(complex_, v))
    if (complex_.source(h) == w)
      return complex_.opposite(h);
  return std::nullopt;
}

void Line_divider::add_edge(Vertex_index v, Vertex_index w)
{
  const auto h = halfedge(v, w);
  if (!h)
    throw Invalid_point_error("no edge joins vertex " + std::to_string(v.idx()) + " and vertex " +
                              std::to_string(w.idx()));
  edges_.insert(complex_.edge(*h));
}

void Line_divider::add_point(const Corners& corners)
{
  CGAL_precondition(!corners.empty() && corners.size() <= 3);
  const Vertex_index v = corners.size() == 1   ? corners[0].first
                         : corners.size() == 2 ? on_edge(corners)
                                               : in_face(corners);
  if (last_ && *last_ != v)
    add_edge(*last_, v);
  last_ = v;
}

Vertex_index Line_divider::on_edge(const Corners& corners)
{
  if (const auto known = cuts_.find({corners[0].first, corners[1].first}); known != cuts_.end()) {
    if (known->second.second != corners[1].second)
      throw Invalid_point_error("the edge is crossed a second time: a line may cross each edge once");
    return known->second.first;
  }
  const auto h = halfedge(corners[0].first, corners[1].first);
  if (!h || complex_.is_self_glued(complex_.edge(*h)))
    throw Invalid_point_error("no edge joins vertex " + std::to_string(corners[0].first.idx()) + " and vertex " +
                              std::to_string(corners[1].first.idx()));
  const Vertex_index v = complex_.split_edge(*h);
  const bool is_kept = edges_.count(complex_.edge(*h)) != 0;
  add_place(corners);
  if (is_kept)
    add_edge(v, corners[1].first);
  cuts_[{corners[0].first, corners[1].first}] = {v, corners[1].second};
  cuts_[{corners[1].first, corners[0].first}] = {v, corners[0].second};
  return v;
}

// The end of a line that has entered the face with these corners through a vertex or across a side.
Vertex_index Line_divider::in_face(const Corners& corners)
{
  auto side = side_of_face(corners[0].first, corners[1].first, corners[2].first);
  for (std::size_t i = 0; i < 6 && !side; ++i) {
    const auto& [x, at_x] = corners[i % 3];
    const auto& [y, at_y] = corners[(i + 1 + i / 3) % 3];
    const auto cut = cuts_.find({x, y});
    if (cut != cuts_.end() && cut->second.first == last_ && at_y * (1 - cut->second.second) > at_x * cut->second.second)
      side = side_of_face(*last_, y, corners[(i + 2 - i / 3) % 3].first);
  }
  if (!side)
    throw Invalid_point_error("a line ends in a face that was cut before: let it end on an edge");
  const Vertex_index v = complex_.split_face(*side);
  add_place(corners);
  return v;
}

// A side of the face with these corners, in either order.
std::optional<Halfedge_index> Line_divider::side_of_face(Vertex_index a, Vertex_index b, Vertex_index c) const
{
  if (const auto side = halfedge(a, b))
    for (Halfedge_index h : {*side, complex_.opposite(*side)})
      if (!complex_.is_border(h) && complex_.target(complex_.next(h)) == c)
        return h;
  return std::nullopt;
}

void Line_divider::add_place(const Corners& corners)
{
  double sum = 0;
  for (const auto& [v, x] : corners)
    sum += x;
  std::array<double, 3> place{};
  for (const auto& [v, x] : corners)
    for (std::size_t axis = 0; axis < 3; ++axis)
      place[axis] += x / sum * points_[v.idx()][axis];
  points_.push_back(place);
}

std::vector<bool> Line_divider::edges() const
{
  std::vector<bool> result(complex_.number_of_edges());
  for (Edge_index e : edges_)
    result[e.idx()] = true;
  return result;
}

} // namespace CGAL::Intrinsic_triangulations
