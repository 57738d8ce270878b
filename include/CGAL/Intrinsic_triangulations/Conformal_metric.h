// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A conformal metric.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CONFORMAL_METRIC_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CONFORMAL_METRIC_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsParameterization
/// \brief what a conformal map does with the border.
enum class Conformal_boundary {
  FREE,   ///< it keeps its scale, u = 0, which stretches least; its angles follow
  ANGLES, ///< its angles are given: π, so that it is straight, where none is
  DISK ///< it becomes a polygon whose outer angles are proportional to the lengths of the edges: a convex one, for a disk
};

/// \ingroup PkgIntrinsicTriangulationsParameterization
/// \brief a metric that is discretely conformally equivalent to that of a surface.
struct Discrete_conformal_metric
{
  /// for each vertex of the surface, the logarithm of the scale factor: λ-lengths are multiplied by e<sup>(u_i + u_j) /
  /// 2</sup>
  std::vector<double> u;
  std::vector<Vertex_index> cones; ///< the vertices inside the surface whose angles do not sum to 2π, given or chosen
  std::vector<double> cone_angles; ///< for each cone, the sum of its angles, up to rounding
  /// proven: at no vertex whose angle was wanted does the sum of the angles differ by more from it, in radians
  double residual = 0;
  double range_of_u = 0; ///< the largest minus the smallest value of u
  int steps = 0;         ///< steps of Newton's method
  /// the ideal Delaunay triangulation of the surface, or if it has a border, of its double: two copies that are glued
  /// along the border
  Delta_complex triangulation;
  std::vector<double> lengths;        ///< the new lengths of its edges: triangles with these lengths are the metric
  std::vector<Vertex_index> vertices; ///< for each vertex of `triangulation`, the vertex of the surface
  std::vector<Edge_index>
    flips; ///< from the Delaunay triangulation of the surface, or of its double, to `triangulation`
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CONFORMAL_METRIC_H
