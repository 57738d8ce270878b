// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Finds the edges at which a repair had to cut a surface.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_OPENED_EDGES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_OPENED_EDGES_H

#include "Edge_stitcher.h"
#include "Polygon_part.h"
#include "Polygon_sides.h"
#include "../gluing/Surface_gluer.h"
#include <CGAL/Intrinsic_triangulations/internal/measures/are_collinear.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Disjoint_sets.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Edges that gluing made border edges: they had several faces in the input, or lay inside one. Pieces of zero area that
// this cuts off are not reported unless there is nothing else.
class Opened_edges
{
  using Index = std::size_t;

public:
  Opened_edges(const std::vector<std::array<double, 3>>& points, const std::vector<Polygon_part>& triangles,
               const Surface_gluer& gluer)
    : points_(points), triangles_(triangles), gluer_(gluer)
  {}

  // Finds the border edges that had several faces in the input, or lay inside one.
  // \param representative of each vertex of the input, the one whose place it took
  // \param stitcher null if nothing was stitched
  void find(const std::vector<std::vector<Index>>& input, const std::vector<Index>& representative,
            const Edge_stitcher* stitcher)
  {
    using Edge = std::array<Index, 2>;
    const auto edge = [](Index v, Index w) { return Edge{(std::min)(v, w), (std::max)(v, w)}; };
    std::vector<std::pair<Edge, Index>> border; // with the triangle
    for (Index c = 0; c < 3 * triangles_.size(); ++c)
      if (gluer_.neighbor(c) == Surface_gluer::none) {
        const std::vector<Index>& v = triangles_[c / 3].corners;
        border.emplace_back(edge(v[c % 3], v[(c + 1) % 3]), c / 3);
      }
    std::sort(border.begin(), border.end());
    std::vector<Index> number_of_faces(border.size(), 0);
    for (const std::vector<Index>& polygon : input)
      for (Index i = 0; i < polygon.size() && !border.empty(); ++i) {
        const std::pair<Edge, Index> key(
          edge(representative[polygon[i]], representative[polygon[i + 1 < polygon.size() ? i + 1 : 0]]), 0);
        for (auto it = std::lower_bound(border.begin(), border.end(), key);
             it != border.end() && it->first == key.first; ++it)
          ++number_of_faces[Index(it - border.begin())];
      }
    std::vector<Index> opened; // positions in the list
    for (Index i = 0; i < border.size(); ++i) {
      const auto& [ends, triangle] = border[i];
      const bool was_inner = stitcher && stitcher->is_part_of_inner_edge(ends[0], ends[1], triangles_[triangle].input);
      number_of_faces[i] += was_inner ? 2 : 0;
      if (was_inner || (number_of_faces[i] != 1 && !(stitcher && stitcher->is_part_of_border(ends[0], ends[1]))))
        opened.push_back(i);
    }
    if (opened.empty())
      return;
    Disjoint_sets pieces = this->pieces();
    std::set<Index> with_area, cut_off;
    for (Index t = 0; t < triangles_.size(); ++t)
      if (has_area(t))
        with_area.insert(pieces.find(std::uint32_t(t)));
    for (Index i : opened) {
      const auto& [ends, triangle] = border[i];
      const Index face = triangles_[triangle].input, piece = pieces.find(std::uint32_t(triangle));
      if (!with_area.empty() && with_area.count(piece) == 0) {
        cut_off.insert(piece);
        continue;
      }
      if (faces_.count() == 0 || face < faces_.first())
        first_ = {ends[0], ends[1], number_of_faces[i]};
      faces_.add(face);
    }
    for (Index t = 0; t < triangles_.size() && !cut_off.empty(); ++t)
      if (cut_off.count(pieces.find(std::uint32_t(t))) != 0)
        cut_off_.insert(t);
  }

  // The input faces with such an edge.
  const Element_collector& faces() const { return faces_; }
  // For the first of them: the ends of the edge, and how many faces it had.
  const std::array<Index, 3>& first_edge() const { return first_; }
  // The triangles of pieces without area.
  const std::set<Index>& cut_off() const { return cut_off_; }

private:
  // Triangles that are glued together.
  Disjoint_sets pieces() const
  {
    Disjoint_sets result(triangles_.size());
    for (Index c = 0; c < 3 * triangles_.size(); ++c)
      if (gluer_.neighbor(c) != Surface_gluer::none)
        result.unite(std::uint32_t(c / 3), gluer_.neighbor(c) / 3);
    return result;
  }

  bool has_area(Index triangle) const
  {
    const std::vector<Index>& v = triangles_[triangle].corners;
    return !are_collinear(points_[v[0]], points_[v[1]], points_[v[2]]);
  }

  const std::vector<std::array<double, 3>>& points_;
  const std::vector<Polygon_part>& triangles_;
  const Surface_gluer& gluer_;
  Element_collector faces_;
  std::array<Index, 3> first_ = {};
  std::set<Index> cut_off_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_OPENED_EDGES_H
