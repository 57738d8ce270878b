// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Finds which vertices a repair merges.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_VERTEX_MERGER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_VERTEX_MERGER_H

#include "Vertices_on_edges.h"
#include <CGAL/Intrinsic_triangulations/internal/system/Disjoint_sets.h>
#include <CGAL/Intrinsic_triangulations/observer.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Merges vertices at the same position where an edge joins them and along the border, which closes seams; with a
// tolerance, also vertices that are no farther apart than that.
class Vertex_merger
{
  using Index = std::size_t;

public:
  static constexpr Index none = (std::numeric_limits<Index>::max)();

  Vertex_merger(const std::vector<std::array<double, 3>>& points, const std::optional<double>& tolerance)
    : points_(points), tolerance_(tolerance)
  {}

  // The vertex that takes the place of each vertex, or `none` if no polygon has it. Inner vertices are not candidates:
  // otherwise sheets that lie on each other would be glued together.
  std::vector<Index> representatives(const std::vector<std::vector<Index>>& polygons,
                                     const Progress_function& progress) const
  {
    const Loop_progress at_edges(progress, "the repair", 0, 0.03, polygons.size()),
      at_vertices(progress, "the repair", 0.04, 0.08, points_.size());
    std::vector<std::array<Index, 2>> edges;
    std::vector<bool> may_merge(points_.size(), false);
    std::vector<Index> result(points_.size(), none);
    for (Index f = 0; f < polygons.size(); ++f) {
      at_edges.at(f);
      for (Index i = 0; i < polygons[f].size(); ++i) {
        const Index v = polygons[f][i], w = polygons[f][(i + 1) % polygons[f].size()];
        result[v] = v;
        if (points_[v] == points_[w] || (tolerance_ && distance(v, w) <= *tolerance_))
          may_merge[v] = may_merge[w] = true;
        edges.push_back({(std::min)(v, w), (std::max)(v, w)});
      }
    }
    std::sort(edges.begin(), edges.end());
    for (Index i = 0; i < edges.size(); ++i)
      if ((i == 0 || edges[i] != edges[i - 1]) && (i + 1 == edges.size() || edges[i] != edges[i + 1]))
        may_merge[edges[i][0]] = may_merge[edges[i][1]] = true;

    std::map<std::array<double, 3>, Index> first_at;
    for (Index v = 0; v < points_.size(); ++v) {
      at_vertices.at(v);
      if (may_merge[v])
        result[v] = first_at.emplace(points_[v], v).first->second;
    }
    if (tolerance_ && *tolerance_ > 0)
      merge_near(may_merge, result);
    return result;
  }

  double distance(Index v, Index w) const
  {
    return Vertices_on_edges::norm(Vertices_on_edges::difference(points_[v], points_[w]));
  }

private:
  void merge_near(const std::vector<bool>& may_merge, std::vector<Index>& result) const
  {
    std::vector<std::uint32_t> vertices;
    for (Index v = 0; v < may_merge.size(); ++v)
      if (may_merge[v] && result[v] == v)
        vertices.push_back(std::uint32_t(v));
    const Vertices_on_edges near(points_, vertices);
    Disjoint_sets sets(points_.size());
    for (std::uint32_t v : vertices)
      near.for_each_within(points_[v], *tolerance_, [&](std::uint32_t w, double) { sets.unite(v, w); });
    for (Index& v : result)
      if (v != none)
        v = sets.find(std::uint32_t(v));
  }

  const std::vector<std::array<double, 3>>& points_;
  const std::optional<double> tolerance_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_VERTEX_MERGER_H
