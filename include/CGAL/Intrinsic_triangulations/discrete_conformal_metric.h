// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Scale factors at the vertices that make a surface flat except at cones: discrete conformal equivalence with flips.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DISCRETE_CONFORMAL_METRIC_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DISCRETE_CONFORMAL_METRIC_H

#include <CGAL/Intrinsic_triangulations/internal/require_Eigen.h>
#include <CGAL/Intrinsic_triangulations/Conformal_metric.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/internal/parameterization/Doubled_surface.h>
#include <CGAL/Intrinsic_triangulations/internal/parameterization/conformal_solver.h>
#include <CGAL/Intrinsic_triangulations/internal/parameterization/factorize.h>
#include <CGAL/Intrinsic_triangulations/observer.h>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

template <class NamedParameters>
Conformal_options conformal_options_of(const NamedParameters& np)
{
  Conformal_options result;
  result.cone_angles = value_of<Parameter::CONE_ANGLES>(np, result.cone_angles);
  result.boundary_angles = value_of<Parameter::BOUNDARY_ANGLES>(np, result.boundary_angles);
  result.boundary = value_of<Parameter::CONFORMAL_BOUNDARY>(
    np, result.boundary_angles.empty() ? Conformal_boundary::FREE : Conformal_boundary::ANGLES);
  result.number_of_cones = value_of<Parameter::NUMBER_OF_CONES>(np, result.number_of_cones);
  result.largest_range = value_of<Parameter::MAXIMUM_RANGE>(np, result.largest_range);
  result.largest_range_with_border = value_of<Parameter::MAXIMUM_RANGE>(np, result.largest_range_with_border);
  result.progress = progress_function_of(np);
  return result;
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsParameterization
/// \brief finds the metric with given cone angles that is discretely conformally equivalent to that of a surface.
///
/// Newton's method finds u. In each step, edges of the Delaunay triangulation of the surface are flipped until it is,
/// with scaled lengths, an ideal Delaunay triangulation, by exact decisions; so there are triangles with these lengths.
/// The energy is convex, so u is unique, up to a constant for each component without a vertex that keeps its scale;
/// there the area stays the same. A surface with a border is doubled. Components may have any topology.
///
/// \b Exactness. The lengths of the Delaunay triangulation are doubles within 1 ulp. In each step they are scaled, and
/// rounded after it where edges were flipped; in between, decisions are exact. So the result is equivalent to a surface
/// whose lengths differ by rounding. `residual` is proven for triangles with exactly the resulting lengths.
///
/// \param triangulation a triangulation, which is not changed
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{cone_angles}
///     \cgalParamDescription{vertices inside the surface and the sums of the angles wanted there; others get 2π}
///     \cgalParamType{`std::vector<std::pair<Vertex_index, double>>`}
///     \cgalParamDefault{none: cones are chosen}
///   \cgalParamNEnd
///   \cgalParamNBegin{boundary_angles}
///     \cgalParamDescription{vertices on the border and their angles; others get π, so that it is straight there}
///     \cgalParamType{`std::vector<std::pair<Vertex_index, double>>`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{conformal_boundary}
///     \cgalParamDescription{what to do with the border}
///     \cgalParamType{`Conformal_boundary`}
///     \cgalParamDefault{`Conformal_boundary::FREE`, and `ANGLES` if angles of the border are given}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_cones}
///     \cgalParamDescription{how many cones are chosen in each component. They keep their scale, u = 0, and their
///       angles follow}
///     \cgalParamType{`std::size_t`, or `std::optional<std::size_t>`}
///     \cgalParamDefault{none if `cone_angles` are given; otherwise so many that u has a range of at most
///     `maximum_range`}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_range}
///     \cgalParamDescription{of u, in a linear estimate: e<sup>2</sup> is a ratio of 7 between lengths}
///     \cgalParamType{`double`}
///     \cgalParamDefault{2, and 5 for a component with a border, which stays uncut more often}
///   \cgalParamNEnd
///   \cgalParamVisitor{is called from time to time with the fraction that is done, and can cancel}
/// \cgalNamedParamsEnd
///
/// \exception Invalid_argument_error if a vertex does not exist, is named twice or isolated, an angle is not positive,
///   or the angles of a component do not have the sum that the theorem of Gauss and Bonnet demands: the message says
///   what is missing. Less than 10<sup>-9</sup> is added to the last angle
/// \exception Invalid_surface_error if the length of an edge is below the range of normal doubles
/// \exception Numerical_error if rounding prevents convergence: the message names the range of u, and where a cone
///   helps
/// \exception Cancelled_error if the visitor asks for it
/// \exception Undecided_error as `flip_to_Delaunay()`
///
/// A sparse Cholesky factorization and flips in each step; 5 to 10 steps are usual.
///
/// Sources: B. Springborn, P. Schröder, U. Pinkall, "Conformal equivalence of triangle meshes" (2008); X. Gu, F. Luo,
/// J. Sun, T. Wu, "A discrete uniformization theorem for polyhedral surfaces" (2018); M. Gillespie, B. Springborn, K.
/// Crane, "Discrete conformal equivalence of polyhedral surfaces" (2021); for the step size, M. Campen, R. Capouellez,
/// H. Shen, L. Zhu, D. Panozzo, D. Zorin, "Efficient and robust discrete conformal equivalence with boundary" (2021).
template <class NamedParameters = parameters::Default_named_parameters>
Discrete_conformal_metric
discrete_conformal_metric(const Intrinsic_triangulation<Filtered_edge_length_traits>& triangulation,
                          const NamedParameters& np = parameters::default_values())
{
  const internal::Conformal_options options = internal::conformal_options_of(np);
  const internal::Doubled_surface doubled(triangulation, options.progress);
  return internal::find_conformal_metric(triangulation, doubled, options, internal::Sparse_factorizer());
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DISCRETE_CONFORMAL_METRIC_H
