// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Bounds for all distances on a surface.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_DISTANCE_BOUNDS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_DISTANCE_BOUNDS_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/numbers/Accurate_shapes.h>
#include <CGAL/Intrinsic_triangulations/internal/system/memory_access.h>

#include <algorithm>
#include <array>
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

// The nearest first, by intervals of equal length, an eighth as many as rows; within an interval, the smallest row
// first. \pre none is negative or NaN
template <class Distances>
std::vector<std::uint32_t> rows_by_distance(const Distances& distances)
{
  const std::size_t n = std::size_t(distances.size()), number_of_intervals = n / 8 + 1;
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

// Corrects distances longer than the shortest path along edges of the triangulation and of its input, or, for a surface
// in space, shorter than the straight line. Lengths are in the unit of Accurate_shapes.
class Distance_bounds
{
public:
  // \tparam Row gives the row of a vertex, as Row_of_vertex
  template <class Traits, class Row>
  Distance_bounds(const Intrinsic_triangulation<Traits>& triangulation, const Row& row)
    : first_(row.number_of_rows() + 1, 0)
  {
    const Accurate_shapes<Traits> shapes(triangulation);
    std::vector<Edge> edges;
    const auto add = [&](const Delta_complex& complex, Edge_index e, double length) {
      const Halfedge_index h = complex.halfedge(e);
      edges.push_back({std::uint32_t(row(complex.source(h))), std::uint32_t(row(complex.target(h))), length});
    };
    for (Edge_index e : triangulation.connectivity().edges())
      if (!is_input_edge(triangulation, e))
        add(triangulation.connectivity(), e, shapes.length(e));
    if constexpr (Intrinsic_triangulation<Traits>::uses_exact_geometry) {
      const Delta_complex& input = engine(triangulation).correspondence().input();
      const auto& metric = engine(triangulation).metric();
      const int exponent = metric.unit_exponent() - shapes.exponent();
      for (Edge_index e : input.edges())
        add(input, e,
            std::ldexp(std::sqrt((std::max)(0., metric.squared_length_double_double(input, e).hi())), exponent));
      if (!metric.points().empty()) {
        points_.resize(row.number_of_rows(), {no_point, 0, 0});
        for (Vertex_index v : input.vertices())
          for (int i = 0; i < 3; ++i)
            points_[row(v)][i] = std::ldexp(metric.points()[v.idx()][i], exponent);
      }
    }
    index(edges);
  }

  // \param distances by rows; infinite ones become finite where edges lead
  // \param sources rows, and their distances from the source that they represent
  void apply(std::vector<double>& distances, const std::map<std::uint32_t, double>& sources) const
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
    // First in the order of the distances, which finds nearly all paths at once. Rows that get a shorter path after
    // their turn follow by Dijkstra's algorithm.
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
        distances[row] = within(distances[row], paths[row], row, origins[row], sources);
    for (const auto& [row, distance] : sources)
      distances[row] = distance;
  }

private:
  static constexpr double not_yet = std::numeric_limits<double>::infinity();  // the path of a row before its turn
  static constexpr double nowhere = (std::numeric_limits<double>::max)();     // and of unreachable rows
  static constexpr double no_point = std::numeric_limits<double>::infinity(); // of rows that are not in the input

  // Whether an edge is also an input edge, which is added anyway.
  template <class Traits>
  static bool is_input_edge(const Intrinsic_triangulation<Traits>& triangulation, Edge_index e)
  {
    if constexpr (Intrinsic_triangulation<Traits>::uses_exact_geometry) {
      const Delta_complex& complex = triangulation.connectivity();
      const Halfedge_index h = complex.halfedge(e);
      return triangulation.is_input_edge(e) && !triangulation.is_inserted(complex.source(h)) &&
             !triangulation.is_inserted(complex.target(h));
    }
    return false;
  }

  struct Edge
  {
    std::uint32_t from, to;
    double length;
  };

  void index(const std::vector<Edge>& edges)
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
  double within(double distance, double path, std::uint32_t row, std::uint32_t origin,
                const std::map<std::uint32_t, double>& sources) const
  {
    distance = distance > 0 ? (std::min)(distance, path) : path / 2;
    if (points_.empty() || points_[row][0] == no_point)
      return distance;
    double nearest = line(row, origin) - sources.at(origin);
    for (auto source = sources.begin(); nearest > distance && source != sources.end(); ++source)
      if (source->first != origin)
        nearest = (std::min)(nearest, line(row, source->first) - source->second);
    return (std::min)((std::max)(nearest, distance), path);
  }

  double line(std::uint32_t v, std::uint32_t w) const
  {
    const auto &p = points_[v], &q = points_[w];
    if (q[0] == no_point)
      return 0;
    const double x = p[0] - q[0], y = p[1] - q[1], z = p[2] - q[2], square = x * x + y * y + z * z;
    return square > 0x1p-900 && square < 0x1p900 ? std::sqrt(square) : std::hypot(x, y, z);
  }

  std::vector<std::uint32_t> first_; // the first neighbor of a row
  std::vector<std::uint32_t> neighbors_;
  std::vector<double> lengths_; // of the edges to them
  std::vector<std::array<double, 3>> points_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_DISTANCE_BOUNDS_H
