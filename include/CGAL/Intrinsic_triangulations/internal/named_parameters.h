// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The named parameters of the package, beside those that it shares with CGAL.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_NAMED_PARAMETERS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_NAMED_PARAMETERS_H

#include <CGAL/Intrinsic_triangulations/internal/Index.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>

#include <boost/property_map/property_map.hpp>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Intrinsic_triangulations {

namespace internal {

enum class Parameter {
  TIE_PROOF,
  FAST_FORWARD,
  MINIMUM_ANGLE,
  MAXIMUM_CIRCUMRADIUS,
  MAXIMUM_EDGE_LENGTH,
  MINIMUM_SIZE,
  SPLITS_ENCROACHED_EDGES,
  TIME_COEFFICIENT,
  HEAT_BOUNDARY,
  KEEPS_RIDGES,
  TOLERANCE,
  SURFACE_COVER,
  COINCIDENT_VERTICES,
  IS_WELDED,
  MOLLIFICATION,
  MASS_TYPE
};
template <Parameter parameter>
using Parameter_tag = std::integral_constant<Parameter, parameter>;

// A sequence of named parameters that goes on with those of the package or of CGAL, in any order. CGAL's own class
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
  CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(edge_is_constrained_map, internal_np::edge_is_constrained_t)
  CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(visitor, internal_np::visitor_t)
  CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(maximum_number, internal_np::maximum_number_t)
  CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(tie_proof, Parameter_tag<Parameter::TIE_PROOF>)
  CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(fast_forward, Parameter_tag<Parameter::FAST_FORWARD>)
  CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(minimum_angle, Parameter_tag<Parameter::MINIMUM_ANGLE>)
  CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(maximum_circumradius, Parameter_tag<Parameter::MAXIMUM_CIRCUMRADIUS>)
  CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(maximum_edge_length, Parameter_tag<Parameter::MAXIMUM_EDGE_LENGTH>)
  CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(minimum_size, Parameter_tag<Parameter::MINIMUM_SIZE>)
  CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(splits_encroached_edges, Parameter_tag<Parameter::SPLITS_ENCROACHED_EDGES>)
  CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(time_coefficient, Parameter_tag<Parameter::TIME_COEFFICIENT>)
  CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(heat_boundary, Parameter_tag<Parameter::HEAT_BOUNDARY>)
  CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(keeps_ridges, Parameter_tag<Parameter::KEEPS_RIDGES>)
  CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(tolerance, Parameter_tag<Parameter::TOLERANCE>)
  CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(surface_cover, Parameter_tag<Parameter::SURFACE_COVER>)
  CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(coincident_vertices, Parameter_tag<Parameter::COINCIDENT_VERTICES>)
  CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(is_welded, Parameter_tag<Parameter::IS_WELDED>)
  CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(mollification, Parameter_tag<Parameter::MOLLIFICATION>)
  CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(mass_type, Parameter_tag<Parameter::MASS_TYPE>)
#undef CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER
};

template <Parameter parameter, class T>
Named_parameters<T, Parameter_tag<parameter>> named(const T& value)
{
  return Named_parameters<T, Parameter_tag<parameter>>(value);
}

// Whether a map of constrained edges is given.
template <class NamedParameters>
constexpr bool has_edge_constraints =
  !std::is_same<std::decay_t<decltype(parameters::get_parameter(std::declval<const NamedParameters&>(),
                                                                internal_np::edge_is_constrained))>,
                internal_np::Param_not_found>::value;

} // namespace internal

} // namespace Intrinsic_triangulations

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
/// \ingroup PkgIntrinsicTriangulationsNamedParameters
/// \brief what exact decisions accept as a tie: a `Tie_proof`.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(tie_proof, TIE_PROOF)
/// \ingroup PkgIntrinsicTriangulationsNamedParameters
/// \brief whether tubes of a gluing are untwisted before edges are flipped.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(fast_forward, FAST_FORWARD)
/// \ingroup PkgIntrinsicTriangulationsNamedParameters
/// \brief the angle in degrees below which no corner is to be.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(minimum_angle, MINIMUM_ANGLE)
/// \ingroup PkgIntrinsicTriangulationsNamedParameters
/// \brief the largest circumradius of a face, in the unit of the input.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(maximum_circumradius, MAXIMUM_CIRCUMRADIUS)
/// \ingroup PkgIntrinsicTriangulationsNamedParameters
/// \brief the largest length of an edge, in the unit of the input.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(maximum_edge_length, MAXIMUM_EDGE_LENGTH)
/// \ingroup PkgIntrinsicTriangulationsNamedParameters
/// \brief the length of a side below which a face is not refined, in the unit of the input.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(minimum_size, MINIMUM_SIZE)
/// \ingroup PkgIntrinsicTriangulationsNamedParameters
/// \brief whether edges that are not flipped are split until no angle opposite to them is obtuse.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(splits_encroached_edges, SPLITS_ENCROACHED_EDGES)
/// \ingroup PkgIntrinsicTriangulationsNamedParameters
/// \brief the time for which heat spreads, in units of the squared mean length of the edges.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(time_coefficient, TIME_COEFFICIENT)
/// \ingroup PkgIntrinsicTriangulationsNamedParameters
/// \brief what heat does at the border: a `Heat_boundary`.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(heat_boundary, HEAT_BOUNDARY)
/// \ingroup PkgIntrinsicTriangulationsNamedParameters
/// \brief whether distances that are less than those of the vertices around allow are raised.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(keeps_ridges, KEEPS_RIDGES)
/// \ingroup PkgIntrinsicTriangulationsNamedParameters
/// \brief how much the length of a path may be changed at each edge that it crosses, as a part of the length of the
/// edge.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(tolerance, TOLERANCE)
/// \ingroup PkgIntrinsicTriangulationsNamedParameters
/// \brief what is built over triangles: a `Surface_cover`.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(surface_cover, SURFACE_COVER)
/// \ingroup PkgIntrinsicTriangulationsNamedParameters
/// \brief what is done with edges of length zero: a value of `Coincident_vertices`.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(coincident_vertices, COINCIDENT_VERTICES)
/// \ingroup PkgIntrinsicTriangulationsNamedParameters
/// \brief whether all vertices at the same place become one.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(is_welded, IS_WELDED)
/// \ingroup PkgIntrinsicTriangulationsNamedParameters
/// \brief if positive, the margin by which edges are lengthened, as by `mollify_lengths()`.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(mollification, MOLLIFICATION)
/// \ingroup PkgIntrinsicTriangulationsNamedParameters
/// \brief which mass matrix is returned: a `Mass_type`.
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER(mass_type, MASS_TYPE)
#undef CGAL_INTRINSIC_TRIANGULATIONS_PARAMETER

} // namespace parameters

namespace Intrinsic_triangulations {

namespace internal {

// The value of a parameter, or the default; of the type of the default.
template <Parameter parameter, class NamedParameters, class D>
D value_of(const NamedParameters& np, const D& otherwise)
{
  return D(parameters::choose_parameter(parameters::get_parameter(np, Parameter_tag<parameter>()), otherwise));
}

// The map of the edges that must not be flipped, or one that constrains none.
template <class NamedParameters>
auto edge_constraints_of(const NamedParameters& np)
{
  const auto result = parameters::choose_parameter(parameters::get_parameter(np, internal_np::edge_is_constrained),
                                                   Static_boolean_property_map<Edge_index, false>());
  static_assert(
    std::is_convertible<Edge_index, typename boost::property_traits<std::decay_t<decltype(result)>>::key_type>::value,
    "edge_is_constrained_map: its keys have to be the edges of the triangulation, of type Edge_index");
  return result;
}

} // namespace internal

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_NAMED_PARAMETERS_H
