// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Distances to vertices that have no face in a cover, along the edges of faces without area.

#include <CGAL/Intrinsic_triangulations/internal/distances/Flat_ways.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

class Flat_ways
{
  using Waiting = std::pair<double, std::uint32_t>; // a distance, and a vertex

public:
  Flat_ways(const Tufted_cover& cover, const Surface_distances& on_surface)
    : cover_(cover), on_surface_(on_surface), edges_(cover.representative.size())
  {
    for (const Tufted_cover::Flat_edge& e : cover.flat_edges) {
      edges_[e.source].push_back({e.length, e.target});
      edges_[e.target].push_back({e.length, e.source});
    }
  }

  std::vector<double> run(const std::vector<Vertex_index>& sources)
  {
    distances_ = on_surface_(sources);
    std::vector<std::uint32_t> reached;
    for (std::uint32_t v = 0; v < edges_.size(); ++v)
      if (!edges_[v].empty())
        reached.push_back(v);
    for (reached = go_along_edges(reached); !reached.empty();) {
      const std::uint32_t v = reached.front();
      const double start = distances_[v];
      const std::vector<double> beyond = on_surface_({Vertex_index(v)});
      std::vector<std::uint32_t> nearer;
      for (std::uint32_t w = 0; w < beyond.size(); ++w)
        if (start + beyond[w] < distances_[w]) {
          distances_[w] = start + beyond[w];
          if (!edges_[w].empty())
            nearer.push_back(w);
        }
      reached.erase(reached.begin());
      for (std::uint32_t w : go_along_edges(nearer))
        if (std::find(reached.begin(), reached.end(), w) == reached.end())
          reached.push_back(w);
    }
    for (std::size_t v = 0; v < distances_.size(); ++v)
      distances_[v] = distances_[cover_.representative[v]];
    return std::move(distances_);
  }

private:
  // \return the vertices that come nearer, the nearest first. Vertices without faces are finished.
  std::vector<std::uint32_t> go_along_edges(const std::vector<std::uint32_t>& from)
  {
    std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> queue;
    for (std::uint32_t v : from)
      queue.push({distances_[v], v});
    std::vector<std::uint32_t> result;
    while (!queue.empty()) {
      const auto [d, v] = queue.top();
      queue.pop();
      if (d > distances_[v] || d == std::numeric_limits<double>::infinity())
        continue;
      for (const auto& [length, w] : edges_[v])
        if (d + length < distances_[w] * (1 - 0x1p-40)) {
          distances_[w] = d + length;
          queue.push({distances_[w], w});
          if (std::find(result.begin(), result.end(), w) == result.end())
            result.push_back(w);
        }
    }
    std::sort(result.begin(), result.end(),
              [this](std::uint32_t v, std::uint32_t w) { return distances_[v] < distances_[w]; });
    return result;
  }

  const Tufted_cover& cover_;
  const Surface_distances& on_surface_;
  std::vector<std::vector<Waiting>> edges_; // for each vertex: length and other end of each edge
  std::vector<double> distances_;
};

} // namespace

std::vector<double> distances_along_flat_edges(const Tufted_cover& cover, const Surface_distances& on_surface,
                                               const std::vector<Vertex_index>& sources)
{
  return Flat_ways(cover, on_surface).run(sources);
}

} // namespace CGAL::Intrinsic_triangulations::internal
