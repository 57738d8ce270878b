// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// An order of vertices and faces, and a choice among Delaunay triangulations, that do not depend on the numbering.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_PLACES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_PLACES_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>

#include <CGAL/enum.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Rows are ordered by the coordinates of their points. Numbers decide if these are equal or missing.
class Places
{
public:
  // \tparam Row gives the row of a vertex, as Row_of_vertex
  template <class Traits, class Row>
  Places(const Intrinsic_triangulation<Traits>& triangulation, const Row& row)
    : points_(row.number_of_rows(), {std::numeric_limits<double>::infinity(), 0, 0})
  {
    if constexpr (Intrinsic_triangulation<Traits>::uses_exact_geometry) {
      const auto& points = engine(triangulation).metric().points();
      for (std::size_t v = 0; v < points.size(); ++v)
        points_[row(Vertex_index(Vertex_index::size_type(v)))] = points[v];
    }
  }

  bool is_before(std::uint32_t v, std::uint32_t w) const
  {
    return points_[v] < points_[w] || (points_[v] == points_[w] && v < w);
  }

private:
  std::vector<std::array<double, 3>> points_; // infinite if there is none
};

// A copy in which the choice among several Delaunay triangulations does not depend on the order of flips; nothing if
// there is no choice. Ties that are edges of the input remain: the convex function on the surface whose edges are the
// Delaunay ones goes down with each flip, so no flipped edge is ever a tie again. Among the others, it chooses those
// that would be Delaunay if the first vertices had slightly larger weights.
// \exception Cancelled_error if the interruption says so
template <class Traits, class Row>
std::optional<Intrinsic_triangulation<Traits>> with_ties_by_place(const Intrinsic_triangulation<Traits>& triangulation,
                                                                  const Row& row, const Interruption& interruption)
{
  std::optional<Intrinsic_triangulation<Traits>> result;
  if constexpr (Intrinsic_triangulation<Traits>::uses_exact_geometry) {
    const Places places(triangulation, row);
    const auto is_to_be_flipped = [&](const Intrinsic_triangulation<Traits>& t, Edge_index e) {
      const Delta_complex& complex = t.connectivity();
      if (t.is_input_edge(e) || !complex.is_flippable(e))
        return false;
      const Halfedge_index h = complex.halfedge(e), g = complex.opposite(h);
      const auto first = [&](Halfedge_index a, Halfedge_index b) { // of their sources
        const auto v = std::uint32_t(row(complex.source(a))), w = std::uint32_t(row(complex.source(b)));
        return places.is_before(v, w) ? v : w;
      };
      return places.is_before(first(complex.prev(h), complex.prev(g)), first(h, g)) &&
             t.sign_of_cotangent_weight(e) == ZERO;
    };
    std::vector<Edge_index> open;
    for (Edge_index e : triangulation.connectivity().edges()) {
      if (e.idx() % 4096 == 0)
        interruption.check();
      if (is_to_be_flipped(triangulation, e))
        open.push_back(e);
    }
    if (!open.empty())
      result = triangulation;
    while (!open.empty()) {
      interruption.check();
      const Edge_index e = open.back();
      open.pop_back();
      if (!is_to_be_flipped(*result, e) || result->flip(e) != Intrinsic_triangulation<Traits>::Flip_outcome::FLIPPED)
        continue;
      const Delta_complex& complex = result->connectivity();
      const Halfedge_index h = complex.halfedge(e), g = complex.opposite(h);
      for (Halfedge_index beside : {complex.next(h), complex.prev(h), complex.next(g), complex.prev(g)})
        open.push_back(complex.edge(beside));
    }
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_PLACES_H
