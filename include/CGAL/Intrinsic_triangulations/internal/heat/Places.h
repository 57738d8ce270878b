// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// An order of vertices and faces, and a choice among Delaunay triangulations, that no numbering has an influence on.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_PLACES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_PLACES_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// Rows are ordered by the coordinates of their points. Numbers decide where these are equal, and if there are none.
class Places
{
public:
  // \tparam Row gives the row of a vertex, as Row_of_vertex
  template <class Traits, class Row>
  Places(const Intrinsic_triangulation<Traits>& triangulation, const Row& row) : ranks_(row.number_of_rows())
  {
    std::vector<std::array<double, 3>> points(ranks_.size(), {std::numeric_limits<double>::infinity(), 0, 0});
    if constexpr (Intrinsic_triangulation<Traits>::uses_exact_geometry) {
      const auto& of_input = engine(triangulation).metric().points();
      for (std::size_t v = 0; v < of_input.size(); ++v)
        points[row(Vertex_index(Vertex_index::size_type(v)))] = of_input[v];
    }
    std::vector<std::uint32_t> order(ranks_.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](std::uint32_t v, std::uint32_t w) {
      return points[v] < points[w] || (points[v] == points[w] && v < w);
    });
    for (std::size_t i = 0; i < order.size(); ++i)
      ranks_[order[i]] = std::uint32_t(i);
  }

  std::uint32_t rank(std::uint32_t row) const { return ranks_[row]; }

private:
  std::vector<std::uint32_t> ranks_;
};

// For each face the side from which its corners come first, in the order of the faces by these corners.
template <class Row>
std::vector<Halfedge_index> first_sides_by_place(const Delta_complex& complex, const Row& row, const Places& places)
{
  std::vector<std::pair<std::array<std::uint32_t, 3>, Halfedge_index>> sides;
  sides.reserve(complex.number_of_faces());
  const auto rank = [&](Halfedge_index h) { return places.rank(std::uint32_t(row(complex.source(h)))); };
  for (Face_index f : complex.faces()) {
    const Halfedge_index h = complex.halfedge(f), g = complex.next(h), k = complex.prev(h);
    const std::uint32_t a = rank(h), b = rank(g), c = rank(k);
    using Side = std::pair<std::array<std::uint32_t, 3>, Halfedge_index>;
    sides.push_back((std::min)({Side{{a, b, c}, h}, Side{{b, c, a}, g}, Side{{c, a, b}, k}}));
  }
  std::sort(sides.begin(), sides.end());
  std::vector<Halfedge_index> result;
  result.reserve(sides.size());
  for (const auto& side : sides)
    result.push_back(side.second);
  return result;
}

// A copy in which the choice among several Delaunay triangulations does not depend on the order of flips; nothing if
// there is no choice. Ties that are edges of the input remain: the convex function on the surface whose edges are the
// Delaunay ones goes down with each flip, so no flipped edge is ever a tie again. Among the others, those are chosen
// that would be Delaunay if the first vertices counted a little more.
template <class Traits, class Row>
std::optional<Intrinsic_triangulation<Traits>> with_ties_by_place(const Intrinsic_triangulation<Traits>& triangulation,
                                                                  const Row& row)
{
  std::optional<Intrinsic_triangulation<Traits>> result;
  if constexpr (Intrinsic_triangulation<Traits>::uses_exact_geometry) {
    const auto is_free_tie = [](const Intrinsic_triangulation<Traits>& t, Edge_index e) {
      return !t.is_input_edge(e) && t.connectivity().is_flippable(e) && t.sign_of_cotangent_weight(e) == ZERO;
    };
    std::vector<Edge_index> open;
    for (Edge_index e : triangulation.connectivity().edges())
      if (is_free_tie(triangulation, e))
        open.push_back(e);
    if (open.empty())
      return result;
    result = triangulation;
    const Places places(triangulation, row);
    const Delta_complex& complex = result->connectivity();
    const auto rank = [&](Halfedge_index h) { return places.rank(std::uint32_t(row(complex.source(h)))); };
    while (!open.empty()) {
      const Edge_index e = open.back();
      open.pop_back();
      const Halfedge_index h = complex.halfedge(e), g = complex.opposite(h);
      if ((std::min)(rank(complex.prev(h)), rank(complex.prev(g))) < (std::min)(rank(h), rank(g)) &&
          is_free_tie(*result, e) && result->flip(e) == Intrinsic_triangulation<Traits>::Flip_outcome::FLIPPED)
        for (Halfedge_index beside : {complex.next(h), complex.prev(h), complex.next(g), complex.prev(g)})
          open.push_back(complex.edge(beside));
    }
  }
  return result;
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_PLACES_H
