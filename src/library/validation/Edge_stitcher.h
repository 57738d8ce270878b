// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Closes T-junctions.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_EDGE_STITCHER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_EDGE_STITCHER_H

#include "Hanging_vertices.h"
#include "Polygon_part.h"
#include "Polygon_sides.h"
#include "../gluing/Sides_by_edge.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The edges in the form that Hanging_vertices requires; side 3t + i belongs to triangle t.
class Edges_of_triangles
{
  using Index = std::uint32_t;

public:
  Edges_of_triangles(std::size_t number_of_vertices, const std::vector<Index_triangle>& triangles)
    : triangles_(triangles), sides_(number_of_vertices, triangles)
  {}

  template <class Function>
  void for_each_edge(const Function& function) const
  {
    std::vector<Index> sides;
    sides_.for_each_edge([&](Index v, const Side_at_edge* begin, const Side_at_edge* end) {
      sides.clear();
      for (const Side_at_edge* side = begin; side != end; ++side)
        sides.push_back(side->side());
      function(v, begin->larger_end, sides);
    });
  }
  static Index face(Index side) { return side / 3; }
  bool has_corner(Index face, Index v) const
  {
    const Index_triangle& t = triangles_[face];
    return std::find(t.begin(), t.end(), v) != t.end();
  }

private:
  const std::vector<Index_triangle>& triangles_;
  Sides_by_edge sides_;
};

// Closes T-junctions: splits edges at the vertices that hang within them.
class Edge_stitcher
{
  using Index = std::size_t;

public:
  Edge_stitcher(const std::vector<std::array<double, 3>>& points, double tolerance)
    : points_(points), tolerance_(tolerance)
  {}

  // Calls go_on() for each edge.
  template <class Function>
  void stitch(std::vector<Polygon_part>& triangles, const Function& go_on)
  {
    const std::vector<Index_triangle> all = index_triangles(triangles);
    const Edges_of_triangles edges(points_.size(), all);
    struct Place
    {
      double position;
      Index vertex;
    };
    std::map<std::uint32_t, std::vector<Place>> places; // within each side, from its smaller end
    std::set<std::uint32_t> border;                     // sides
    Hanging_vertices(points_, all.size(), edges)
      .find(
        tolerance_, 0,
        [&](Index, Index, const std::vector<std::uint32_t>& sides, Index vertex, double, double position) {
          for (std::uint32_t side : sides)
            places[side].push_back({position, vertex});
          if (sides.size() == 1)
            border.insert(sides.front());
        },
        go_on);
    std::map<std::uint32_t, std::vector<Index>> within; // in the direction of the side
    for (auto& [side, list] : places) {
      std::sort(list.begin(), list.end(), [](const Place& a, const Place& b) {
        return a.position != b.position ? a.position < b.position : a.vertex < b.vertex;
      });
      for (const Place& place : list)
        if (std::vector<Index>& vertices = within[side];
            vertices.empty() || points_[vertices.back()] != points_[place.vertex])
          vertices.push_back(place.vertex);
    }
    std::vector<Polygon_part> result;
    for (Index t = 0; t < all.size(); ++t) {
      std::vector<std::vector<Index>> parts{triangles[t].corners};
      for (std::uint32_t s = 3 * std::uint32_t(t), i = 0; i < 3; ++i, ++s)
        if (const auto found = within.find(s); found != within.end()) {
          if (all[t][i] > all[t][(i + 1) % 3])
            std::reverse(found->second.begin(), found->second.end());
          note_stitch(all[t][i], all[t][(i + 1) % 3], found->second, triangles[t].input, border.count(s) != 0);
          split_side(parts, all[t][i], all[t][(i + 1) % 3], found->second);
        }
      for (std::vector<Index>& part : parts)
        result.push_back({triangles[t].input, std::move(part)});
    }
    triangles = std::move(result);
  }

  // The input faces with an edge that was split.
  const Element_collector& faces() const { return faces_; }
  // For the first of them: the ends of the edge, and the vertex.
  const std::array<Index, 3>& first_edge() const { return first_; }
  bool is_part_of_border(Index v, Index w) const { return border_sides_.count({v, w}) != 0; }
  // \pre v < w, here and above
  bool is_part_of_inner_edge(Index v, Index w, Index face) const { return inner_sides_.count({v, w, face}) != 0; }

private:
  void note_stitch(Index v, Index w, const std::vector<Index>& within, Index face, bool is_border)
  {
    if (faces_.count() == 0 || face < faces_.first())
      first_ = {v, w, within.front()};
    faces_.add(face);
    for (Index last = v, i = 0; i <= within.size(); ++i) {
      const Index next = i < within.size() ? within[i] : w;
      const std::array<Index, 2> ends = {(std::min)(last, next), (std::max)(last, next)};
      if (is_border)
        border_sides_.insert(ends);
      else
        inner_sides_.insert({ends[0], ends[1], face});
      last = next;
    }
  }
  // The triangle that has the side becomes a fan.
  static void split_side(std::vector<std::vector<Index>>& parts, Index v, Index w, const std::vector<Index>& within)
  {
    for (std::vector<Index>& part : parts)
      for (Index i = 0; i < 3; ++i)
        if (part[i] == v && part[(i + 1) % 3] == w) {
          const Index apex = part[(i + 2) % 3];
          part = {v, within.front(), apex};
          for (Index k = 0; k < within.size(); ++k)
            parts.push_back({within[k], k + 1 < within.size() ? within[k + 1] : w, apex});
          return;
        }
  }

  const std::vector<std::array<double, 3>>& points_;
  const double tolerance_;
  Element_collector faces_;
  std::array<Index, 3> first_ = {};
  std::set<std::array<Index, 2>> border_sides_;
  std::set<std::array<Index, 3>> inner_sides_; // with the face
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_EDGE_STITCHER_H
