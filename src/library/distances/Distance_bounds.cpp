// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Bounds for all distances on a surface: shortest paths along edges, and straight lines.

#include <CGAL/Intrinsic_triangulations/internal/distances/Distance_bounds.h>
#include <CGAL/Intrinsic_triangulations/internal/system/memory_access.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

std::vector<std::uint32_t> rows_by_distance(const std::vector<double>& distances)
{
  const std::size_t n = distances.size(), number_of_intervals = n / 8 + 1;
  double largest = 0;
  for (const double d : distances)
    if (d < std::numeric_limits<double>::infinity())
      largest = (std::max)(largest, d);
  std::vector<std::uint32_t> interval, first(number_of_intervals, 0), result(n);
  interval.reserve(n);
  for (const double d : distances) {
    interval.push_back(std::uint32_t((d < largest ? d / largest : 1) * double(number_of_intervals - 1)));
    ++first[interval.back()];
  }
  std::exclusive_scan(first.begin(), first.end(), first.begin(), std::uint32_t(0));
  for (std::size_t row = 0; row < n; ++row)
    result[first[interval[row]]++] = std::uint32_t(row);
  return result;
}

void Distance_bounds::apply(std::vector<double>& distances, const std::map<std::uint32_t, double>& sources,
                            double farther) const
{
  std::vector<double> paths(first_.size() - 1, not_yet);
  std::vector<std::uint32_t> origins(paths.size(), 0);
  for (const auto& [row, distance] : sources) {
    paths[row] = distance;
    origins[row] = row;
  }
  std::priority_queue<std::pair<double, std::uint32_t>, std::vector<std::pair<double, std::uint32_t>>, std::greater<>>
    queue;
  const auto go_on_from = [&](std::uint32_t row) {
    for (std::uint32_t i = first_[row]; i < first_[row + 1]; ++i) {
      const std::uint32_t neighbor = neighbors_[i];
      if (paths[neighbor] == not_yet || !(paths[row] + lengths_[i] < paths[neighbor]))
        continue;
      paths[neighbor] = paths[row] + lengths_[i];
      origins[neighbor] = origins[row];
      queue.push({paths[neighbor], neighbor});
    }
  };
  // The first pass, in the order of the distances, finds nearly all paths. Rows that get a shorter path after their
  // turn follow by Dijkstra's algorithm.
  const std::vector<std::uint32_t> order = rows_by_distance(distances);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::uint32_t row = order[i], soon = order[(std::min)(i + 8, order.size() - 1)];
    prefetch(neighbors_.data() + first_[soon]);
    prefetch(lengths_.data() + first_[soon]);
    prefetch(lengths_.data() + first_[soon + 1]);
    double path = paths[row];
    std::uint32_t from = row;
    for (std::uint32_t k = first_[row]; k < first_[row + 1]; ++k) {
      // Without branches, because which is shorter is unpredictable.
      const double other = paths[neighbors_[k]] + lengths_[k];
      from = other < path ? neighbors_[k] : from;
      path = other < path ? other : path;
    }
    path = (std::min)(path, nowhere);
    paths[row] = path;
    origins[row] = origins[from];
    bool is_shorter = false;
    for (std::uint32_t k = first_[row]; k < first_[row + 1]; ++k) {
      const double other = paths[neighbors_[k]];
      is_shorter |= (path + lengths_[k] < other) & (other <= nowhere);
    }
    if (is_shorter)
      go_on_from(row);
  }
  while (!queue.empty()) {
    const auto [length, row] = queue.top();
    queue.pop();
    if (length == paths[row])
      go_on_from(row);
  }
  for (std::uint32_t row = 0; row < std::uint32_t(paths.size()); ++row)
    if (paths[row] < nowhere)
      distances[row] = within(distances[row], paths[row], row, origins[row], sources, farther);
}

void Distance_bounds::index(const std::vector<Edge>& edges)
{
  for (const Edge& e : edges) {
    ++first_[e.from + 1];
    ++first_[e.to + 1];
  }
  for (std::size_t v = 0; v + 1 < first_.size(); ++v)
    first_[v + 1] += first_[v];
  neighbors_.resize(2 * edges.size());
  lengths_.resize(neighbors_.size());
  std::vector<std::uint32_t> position(first_.begin(), first_.end() - 1);
  const auto add = [&](std::uint32_t from, std::uint32_t to, double length) {
    neighbors_[position[from]] = to;
    lengths_[position[from]++] = length;
  };
  for (const Edge& e : edges) {
    add(e.from, e.to, e.length);
    add(e.to, e.from, e.length);
  }
}

// A distance that is not positive is useless: use half the edge path, a lower bound for planar Delaunay
// triangulations.
double Distance_bounds::within(double distance, double path, std::uint32_t row, std::uint32_t origin,
                               const std::map<std::uint32_t, double>& sources, double farther) const
{
  distance = distance > 0 ? (std::min)(distance, path) : path / 2;
  if (points_.empty() || points_[row][0] == no_point)
    return distance;
  double nearest = line(row, origin) - sources.at(origin) - farther;
  for (auto source = sources.begin(); nearest > distance && source != sources.end(); ++source)
    if (source->first != origin)
      nearest = (std::min)(nearest, line(row, source->first) - source->second - farther);
  return (std::min)((std::max)(nearest, distance), path);
}

double Distance_bounds::line(std::uint32_t v, std::uint32_t w) const
{
  const auto &p = points_[v], &q = points_[w];
  if (q[0] == no_point)
    return 0;
  const double x = p[0] - q[0], y = p[1] - q[1], z = p[2] - q[2], square = x * x + y * y + z * z;
  return square > 0x1p-900 && square < 0x1p900 ? std::sqrt(square) : std::hypot(x, y, z);
}

} // namespace CGAL::Intrinsic_triangulations::internal
