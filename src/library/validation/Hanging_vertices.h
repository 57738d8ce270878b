// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Finds where edges end within other edges, so that the faces there do not meet although they seem to.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_HANGING_VERTICES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_HANGING_VERTICES_H

#include "Vertices_on_edges.h"
#include <CGAL/Intrinsic_triangulations/internal/system/Disjoint_sets.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// A vertex hangs if it lies within an edge without being a corner of the faces there, and an edge ends at it: a border
// edge, or one from a vertex where sheets meet that are not neighbors. (A sheet consists of faces joined by edges with
// two faces.) Within an edge of two or more faces, only vertices of other sheets hang. Solids that touch elsewhere do
// not meet.
//
// \tparam Edges has `for_each_edge(visit)`, which calls visit(v, w, sides) with the ends of each edge and its sides, a
//   vector of numbers; `face(side)`; and `has_corner(face, vertex)`
template <class Edges>
class Hanging_vertices
{
  using Index = std::uint32_t;
  using Place = std::array<double, 3>;

public:
  Hanging_vertices(const std::vector<Place>& points, std::size_t number_of_faces, const Edges& edges)
    : points_(points), edges_(edges), sheets_(number_of_faces), sheet_of_(points.size(), none)
  {
    using Sides = std::vector<Index>;
    edges_.for_each_edge([&](Index, Index, const Sides& sides) {
      if (sides.size() == 2)
        sheets_.unite(edges_.face(sides[0]), edges_.face(sides[1]));
    });
    edges_.for_each_edge([&](Index v, Index w, const Sides& sides) {
      for (Index side : sides) {
        const Index sheet = sheets_.find(edges_.face(side));
        for (Index x : {v, w})
          if (sheet_of_[x] != sheet)
            sheet_of_[x] = sheet_of_[x] == none ? sheet : several;
        if (sides.size() == 2)
          break; // the other face is in the same sheet
      }
      if (sides.size() == 1)
        ends_.insert(ends_.end(), {v, w});
    });
    if (std::find(sheet_of_.begin(), sheet_of_.end(), several) != sheet_of_.end())
      edges_.for_each_edge([&](Index v, Index w, const Sides&) {
        if (sheet_of_[v] == several)
          ends_.push_back(w);
        if (sheet_of_[w] == several)
          ends_.push_back(v);
      });
    for (Index x : ends_)
      only_sheet_ = only_sheet_ == none || only_sheet_ == sheet_of_[x] ? sheet_of_[x] : several;
  }

  // Calls visit(v, w, sides, vertex, distance, position) for the vertices that hang within each edge, within a
  // tolerance as in Vertices_on_edges.
  // \param go_on is called for each edge
  template <class Visit, class Function>
  void find(double length, double part, const Visit& visit, const Function& go_on)
  {
    const Vertices_on_edges near(points_, ends_);
    edges_.for_each_edge([&](Index v, Index w, const std::vector<Index>& sides) {
      go_on();
      if (sides.size() > 1 && sheets_.find(edges_.face(sides[0])) == only_sheet_)
        return; // only vertices of other sheets hang there
      near.for_each_within_edge(points_[v], points_[w], length, part, [&](Index x, double distance, double position) {
        if (sides.size() > 1 && sheet_of_[x] == sheets_.find(edges_.face(sides[0])))
          return;
        for (Index side : sides)
          if (edges_.has_corner(edges_.face(side), x))
            return;
        visit(v, w, sides, x, distance, position);
      });
    });
  }

private:
  static constexpr Index none = (std::numeric_limits<Index>::max)(), several = none - 1;

  const std::vector<Place>& points_;
  const Edges& edges_;
  Disjoint_sets sheets_;        // of faces
  std::vector<Index> sheet_of_; // of each vertex
  Index only_sheet_ = none;     // of all ends, or `several`
  std::vector<Index> ends_;     // of edges that may end within others
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_HANGING_VERTICES_H
