// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Bounds for all distances on a surface.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_DISTANCE_BOUNDS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_DISTANCE_BOUNDS_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/internal/numbers/Accurate_shapes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The rows, the nearest first: by intervals of equal length, an eighth as many as there are rows, and by row within an
// interval. \pre none is negative or NaN
std::vector<std::uint32_t> rows_by_distance(const std::vector<double>& distances);

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
          for (int i = 0; i < 3 && input.halfedge(v).is_valid(); ++i) // the point of an isolated vertex is ignored
            points_[row(v)][i] = std::ldexp(metric.points()[v.idx()][i], exponent);
      }
    }
    row.for_each_flat_edge([&](std::uint32_t v, std::uint32_t w, double length) {
      edges.push_back({v, w, std::ldexp(length, -shapes.exponent())});
    });
    index(edges);
  }

  // \param distances by rows; infinite ones become finite where edges lead
  // \param sources rows, and their distances from the source that they represent
  // \param farther how much farther than its row the points of a source may be
  void apply(std::vector<double>& distances, const std::map<std::uint32_t, double>& sources, double farther = 0) const;

private:
  static constexpr double not_yet = std::numeric_limits<double>::infinity();  // a row whose turn has not come
  static constexpr double nowhere = (std::numeric_limits<double>::max)();     // an unreachable row
  static constexpr double no_point = std::numeric_limits<double>::infinity(); // a row that is not in the input

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

  void index(const std::vector<Edge>& edges);
  double within(double distance, double path, std::uint32_t row, std::uint32_t origin,
                const std::map<std::uint32_t, double>& sources, double farther) const;
  double line(std::uint32_t v, std::uint32_t w) const;

  std::vector<std::uint32_t> first_; // the first neighbor of a row
  std::vector<std::uint32_t> neighbors_;
  std::vector<double> lengths_; // of the edges to them
  std::vector<std::array<double, 3>> points_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_DISTANCE_BOUNDS_H
