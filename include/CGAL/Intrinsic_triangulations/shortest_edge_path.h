// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A shortest path along the edges of a triangulation.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SHORTEST_EDGE_PATH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SHORTEST_EDGE_PATH_H

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/errors.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsGeodesics
/// \brief finds a shortest path from `source` to `target` along the edges of a triangulation, by Dijkstra's algorithm.
///
/// \return its halfedges, in order; none if both vertices are the same. Lengths are rounded: among paths of nearly the same
///   length it may be any
/// \exception Invalid_point_error if there is no such vertex, or no path
///
/// O(n log n) for the n edges that are nearer to the source than the target.
template <class Traits>
std::vector<Halfedge_index> shortest_edge_path(const Intrinsic_triangulation<Traits>& triangulation, Vertex_index source,
                                               Vertex_index target)
{
  const Delta_complex& complex = triangulation.connectivity();
  for (Vertex_index v : {source, target})
    if (!(v.idx() < complex.number_of_vertices()))
      throw Invalid_point_error("there is no vertex " + std::to_string(v.idx()) + ": the surface has " +
                                std::to_string(complex.number_of_vertices()));
  using Entry = std::pair<double, Vertex_index::size_type>;
  std::vector<double> distance(complex.number_of_vertices(), std::numeric_limits<double>::infinity());
  std::vector<Halfedge_index> arrival(complex.number_of_vertices());
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  distance[source.idx()] = 0;
  queue.push({0, source.idx()});
  while (!queue.empty()) {
    const auto [d, number] = queue.top();
    queue.pop();
    if (number == target.idx())
      break;
    const Halfedge_index first = complex.halfedge(Vertex_index(number));
    if (d > distance[number] || !first.is_valid())
      continue;
    Halfedge_index h = first;
    do {
      const Halfedge_index out = complex.opposite(h);
      const double through = d + CGAL::to_double(triangulation.length(complex.edge(h)));
      const auto next = complex.target(out).idx();
      if (through < distance[next]) {
        distance[next] = through;
        arrival[next] = out;
        queue.push({through, next});
      }
      h = complex.next_around_target(h);
    } while (h != first);
  }
  std::vector<Halfedge_index> path;
  for (Vertex_index v = target; v != source; v = complex.source(path.back())) {
    if (!arrival[v.idx()].is_valid())
      throw Invalid_point_error("no path along edges leads from vertex " + std::to_string(source.idx()) + " to vertex " +
                                std::to_string(target.idx()));
    path.push_back(arrival[v.idx()]);
  }
  std::reverse(path.begin(), path.end());
  return path;
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SHORTEST_EDGE_PATH_H
