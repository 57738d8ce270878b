// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The named parameters of the package, beside those that it shares with CGAL.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_NAMED_PARAMETERS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_NAMED_PARAMETERS_H

#include <CGAL/Intrinsic_triangulations/Index.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>

#include <boost/property_map/property_map.hpp>

#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Intrinsic_triangulations::internal {

// The named parameters that CGAL does not have.
#define CGAL_INTRINSIC_TRIANGULATIONS_PARAMETERS(F)                                                                    \
  F(tie_proof, TIE_PROOF)                                                                                              \
  F(fast_forward, FAST_FORWARD)                                                                                        \
  F(minimum_angle, MINIMUM_ANGLE)                                                                                      \
  F(maximum_circumradius, MAXIMUM_CIRCUMRADIUS)                                                                        \
  F(maximum_edge_length, MAXIMUM_EDGE_LENGTH)                                                                          \
  F(minimum_size, MINIMUM_SIZE)                                                                                        \
  F(sharp_edge_angle, SHARP_EDGE_ANGLE)                                                                                \
  F(maximum_deviation, MAXIMUM_DEVIATION)                                                                              \
  F(whole_edges_map, WHOLE_EDGES_MAP)                                                                                  \
  F(size_map, SIZE_MAP)                                                                                                \
  F(size_gradation, SIZE_GRADATION)                                                                                    \
  F(maximum_normal_angle, MAXIMUM_NORMAL_ANGLE)                                                                        \
  F(splits_encroached_edges, SPLITS_ENCROACHED_EDGES)                                                                  \
  F(time_coefficient, TIME_COEFFICIENT)                                                                                \
  F(heat_boundary, HEAT_BOUNDARY)                                                                                      \
  F(keeps_ridges, KEEPS_RIDGES)                                                                                        \
  F(tolerance, TOLERANCE)                                                                                              \
  F(surface_cover, SURFACE_COVER)                                                                                      \
  F(coincident_vertices, COINCIDENT_VERTICES)                                                                          \
  F(stitching_tolerance, STITCHING_TOLERANCE)                                                                          \
  F(is_welded, IS_WELDED)                                                                                              \
  F(mollification, MOLLIFICATION)                                                                                      \
  F(mass_type, MASS_TYPE)                                                                                              \
  F(relative_error, RELATIVE_ERROR)                                                                                    \
  F(maximum_change, MAXIMUM_CHANGE)                                                                                    \
  F(number_of_vertices, NUMBER_OF_VERTICES)                                                                            \
  F(sharp_angle, SHARP_ANGLE)                                                                                          \
  F(cone_angles, CONE_ANGLES)                                                                                          \
  F(boundary_angles, BOUNDARY_ANGLES)                                                                                  \
  F(conformal_boundary, CONFORMAL_BOUNDARY)                                                                            \
  F(number_of_cones, NUMBER_OF_CONES)                                                                                  \
  F(maximum_range, MAXIMUM_RANGE)

#define CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(name, tag) tag,
enum class Parameter {
  CGAL_INTRINSIC_TRIANGULATIONS_PARAMETERS(CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER)
};
#undef CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER
template <Parameter parameter>
using Parameter_tag = std::integral_constant<Parameter, parameter>;

// A sequence of named parameters that may continue with those of the package or of CGAL, in any order. CGAL's own class
// knows only CGAL's.
template <class T, class Tag, class Base = internal_np::No_property>
struct Named_parameters : internal_np::Named_params_impl<T, Tag, Base>
{
  using base = internal_np::Named_params_impl<T, Tag, Base>; // CGAL looks for this name
  using base::base;

#define CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(name, tag)                                                             \
  template <class K>                                                                                                   \
  Named_parameters<K, tag, Named_parameters> name(const K& k) const                                                    \
  {                                                                                                                    \
    return Named_parameters<K, tag, Named_parameters>(k, *this);                                                       \
  }
  CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(vertex_point_map, internal_np::vertex_point_t)
  CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(geom_traits, internal_np::geom_traits_t)
  CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(vertex_is_constrained_map, internal_np::vertex_is_constrained_t)
  CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(edge_is_constrained_map, internal_np::edge_is_constrained_t)
  CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(visitor, internal_np::visitor_t)
  CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(maximum_number, internal_np::maximum_number_t)
#define CGAL_INTRINSIC_TRIANGULATIONS_OWN_PARAMETER(name, tag)                                                         \
  CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(name, Parameter_tag<Parameter::tag>)
  CGAL_INTRINSIC_TRIANGULATIONS_PARAMETERS(CGAL_INTRINSIC_TRIANGULATIONS_OWN_PARAMETER)
#undef CGAL_INTRINSIC_TRIANGULATIONS_OWN_PARAMETER
#undef CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER
#undef CGAL_INTRINSIC_TRIANGULATIONS_PARAMETERS
};

template <Parameter parameter, class T>
Named_parameters<T, Parameter_tag<parameter>> named(const T& value)
{
  return Named_parameters<T, Parameter_tag<parameter>>(value);
}

// Whether a map of constrained edges is given.
template <class NamedParameters>
constexpr bool has_edge_constraints =
  !parameters::is_default_parameter<NamedParameters, internal_np::edge_is_constrained_t>::value;

} // namespace Intrinsic_triangulations::internal

namespace parameters {

/// \cond SKIP_IN_MANUAL
template <class T, class Tag, class Base, class QueryTag>
auto get_parameter(const Intrinsic_triangulations::internal::Named_parameters<T, Tag, Base>& np, QueryTag tag)
{
  return internal_np::get_parameter_impl(static_cast<const internal_np::Named_params_impl<T, Tag, Base>&>(np), tag);
}
/// \endcond

// A function that begins a sequence with a parameter. The manual expands it, too.
#define CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(name, parameter)                                                       \
  template <class T>                                                                                                   \
  auto name(const T& value)                                                                                            \
  {                                                                                                                    \
    using namespace Intrinsic_triangulations::internal;                                                                \
    return named<Parameter::parameter>(value);                                                                         \
  }
/// \addtogroup PkgIntrinsicTriangulationsNamedParameters
/// @{

/// \brief which proof exact decisions require for a tie: a `Tie_proof`.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(tie_proof, TIE_PROOF)
/// \brief whether tubes of a gluing are untwisted before edges are flipped.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(fast_forward, FAST_FORWARD)
/// \brief the smallest angle of a corner, in degrees.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(minimum_angle, MINIMUM_ANGLE)
/// \brief the largest circumradius of a face, in the unit of the input.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(maximum_circumradius, MAXIMUM_CIRCUMRADIUS)
/// \brief the largest length of an edge, in the unit of the input.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(maximum_edge_length, MAXIMUM_EDGE_LENGTH)
/// \brief the length of a side below which a face is not refined, in the unit of the input.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(minimum_size, MINIMUM_SIZE)
/// \brief the angle between the directions of two faces beyond which their edge is not flipped, in degrees.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(sharp_edge_angle, SHARP_EDGE_ANGLE)
/// \brief how far the straight triangles between the corners of faces may be from the surface, in the unit of the
/// input.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(maximum_deviation, MAXIMUM_DEVIATION)
/// \brief which edges must neither be flipped nor split.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(whole_edges_map, WHOLE_EDGES_MAP)
/// \brief how long edges may be at each vertex of the input, in the unit of the input.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(size_map, SIZE_MAP)
/// \brief by how much the length of edges may grow over a distance, as a part of it.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(size_gradation, SIZE_GRADATION)
/// \brief the angle by which the normal may turn along an edge, in degrees.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(maximum_normal_angle, MAXIMUM_NORMAL_ANGLE)
/// \brief whether edges that are not flipped are split until no angle opposite them is obtuse.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(splits_encroached_edges, SPLITS_ENCROACHED_EDGES)
/// \brief the time for which heat spreads, in units of the squared mean length of the edges.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(time_coefficient, TIME_COEFFICIENT)
/// \brief the behaviour of heat at the border: a `Heat_boundary`.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(heat_boundary, HEAT_BOUNDARY)
/// \brief whether distances that are too small for those of the neighbors are raised.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(keeps_ridges, KEEPS_RIDGES)
/// \brief how much the length of a path may change at each edge that it crosses, as a fraction of the length of the
/// edge.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(tolerance, TOLERANCE)
/// \brief which surface is built over triangles: a `Surface_cover`.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(surface_cover, SURFACE_COVER)
/// \brief how edges of length zero are treated: a value of `Coincident_vertices`.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(coincident_vertices, COINCIDENT_VERTICES)
/// \brief the length within which the border of a surface is stitched.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(stitching_tolerance, STITCHING_TOLERANCE)
/// \brief whether all vertices at the same place become one.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(is_welded, IS_WELDED)
/// \brief if positive, the margin by which edges are lengthened, as by `mollify_lengths()`.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(mollification, MOLLIFICATION)
/// \brief which mass matrix is returned: a `Mass_type`.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(mass_type, MASS_TYPE)
/// \brief the relative error that a number may have.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(relative_error, RELATIVE_ERROR)
/// \brief by which part a simplification may change distances: 0.05 for 5 percent.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(maximum_change, MAXIMUM_CHANGE)
/// \brief how many vertices a simplification leaves.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(number_of_vertices, NUMBER_OF_VERTICES)
/// \brief the angle between the normals of two faces, in degrees, above which their common edge is sharp.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(sharp_angle, SHARP_ANGLE)
/// \brief vertices inside a surface that are cones of a conformal map, with the sums of their angles.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(cone_angles, CONE_ANGLES)
/// \brief vertices on the border, with the angles that a conformal map gives them.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(boundary_angles, BOUNDARY_ANGLES)
/// \brief what a conformal map does with the border: a `Conformal_boundary`.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(conformal_boundary, CONFORMAL_BOUNDARY)
/// \brief how many cones of a conformal map are chosen in each component.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(number_of_cones, NUMBER_OF_CONES)
/// \brief the range of the logarithms of scale factors up to which no more cones are chosen.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(maximum_range, MAXIMUM_RANGE)
/// @}
#undef CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER

} // namespace parameters

namespace Intrinsic_triangulations::internal {

// The value of a parameter, or the default, in the type of the default.
template <Parameter parameter, class NamedParameters, class D>
D value_of(const NamedParameters& np, const D& otherwise)
{
  return D(parameters::choose_parameter(parameters::get_parameter(np, Parameter_tag<parameter>()), otherwise));
}

// The maximum number of steps; without it there is no limit.
template <class NamedParameters>
std::uint64_t maximum_number_of(const NamedParameters& np)
{
  return parameters::choose_parameter(parameters::get_parameter(np, internal_np::maximum_number),
                                      (std::numeric_limits<std::uint64_t>::max)());
}

// A map of edges that are marked, or one that marks none.
template <class NamedParameters, class Tag>
auto marked_edges_of(const NamedParameters& np, Tag tag)
{
  const auto result =
    parameters::choose_parameter(parameters::get_parameter(np, tag), Static_boolean_property_map<Edge_index, false>());
  static_assert(
    std::is_convertible<Edge_index, typename boost::property_traits<std::decay_t<decltype(result)>>::key_type>::value,
    "the keys of a map of edges have to be those of the triangulation, of type Edge_index");
  return result;
}

// The map of the edges that must not be flipped, or one without constraints.
template <class NamedParameters>
auto edge_constraints_of(const NamedParameters& np)
{
  return marked_edges_of(np, internal_np::edge_is_constrained);
}

} // namespace Intrinsic_triangulations::internal
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_NAMED_PARAMETERS_H
