// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The straight triangles between the corners of faces, during refinement: how far they are from the surface.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_STRAIGHT_EDGES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_STRAIGHT_EDGES_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/point_on_input.h>

#include <array>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Distances are rounded, and in the unit of the input. `straight_mesh()` proves them later.
class Straight_edges
{
public:
  // \pre the input has points
  Straight_edges(const Exact_engine& engine, Input_shapes& shapes) : engine_(engine), shapes_(shapes) {}

  // Must be called for each edge that has changed.
  void measure(Edge_index e);

  // Whether the straight triangle of f is farther than this from the surface. Or, if it is not much smaller than that,
  // whether f shares ends with an edge that is not its own, or only the triangle has an angle below 15 degrees.
  // \param is_thin whether f has a small angle itself
  bool deviates(Face_index f, double maximum_deviation, bool is_thin) const;

private:
  using Point = std::array<double, 3>;

  double deviation(Halfedge_index h);

  const Exact_engine& engine_;
  Input_shapes& shapes_;
  std::vector<Point> points_;      // of the vertices, in the internal unit
  std::vector<double> deviations_; // of the edges, likewise
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_STRAIGHT_EDGES_H
