// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Conformal maps of surfaces of any topology to the plane.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CONFORMAL_PARAMETERIZATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CONFORMAL_PARAMETERIZATION_H

#include <CGAL/Intrinsic_triangulations/Conformal_map.h>
#include <CGAL/Intrinsic_triangulations/discrete_conformal_metric.h>
#include <CGAL/Intrinsic_triangulations/errors.h>

#include <utility>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsParameterization
/// \brief maps a surface to the plane conformally, and proves that the result is locally injective.
///
/// The metric is that of `discrete_conformal_metric()`. The surface is cut along shortest paths of edges of the ideal
/// Delaunay triangulation, between its cones, and open where its topology demands it, and laid out triangle by
/// triangle, across the longest edges first. A cut whose images agree to 10<sup>-12</sup> of the component's size is
/// closed, as in a flat annulus. Then the corners of each vertex off the cuts are merged, the rounded result is checked
/// by exact predicates, and overlaid with the input. Components come side by side, the smallest first. Without cones
/// and handles, a surface with one border is not cut.
///
/// If triangles turn over or the metric does not converge, more cones are chosen where that is allowed.
///
/// \param triangulation, np as for `discrete_conformal_metric()`
/// \exception Numerical_error also if triangles turn over although the cones were given: the message names the first
///   face and the range of u
/// Other exceptions as for `discrete_conformal_metric()`.
template <class NamedParameters = parameters::Default_named_parameters>
Conformal_map conformal_parameterization(const Intrinsic_triangulation<Filtered_edge_length_traits>& triangulation,
                                         const NamedParameters& np = parameters::default_values())
{
  return internal::find_conformal_map(triangulation, internal::conformal_options_of(np), internal::Sparse_factorizer());
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CONFORMAL_PARAMETERIZATION_H
