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

/// \ingroup PkgIntrinsicTriangulationsNamedParameters
/// \brief what exact decisions accept as a tie: a `Tie_proof`.
template <class T>
auto tie_proof(const T& value)
{
  return Intrinsic_triangulations::internal::named<Intrinsic_triangulations::internal::Parameter::TIE_PROOF>(value);
}
/// \ingroup PkgIntrinsicTriangulationsNamedParameters
/// \brief whether tubes of a gluing are untwisted before edges are flipped.
template <class T>
auto fast_forward(const T& value)
{
  return Intrinsic_triangulations::internal::named<Intrinsic_triangulations::internal::Parameter::FAST_FORWARD>(value);
}
/// \ingroup PkgIntrinsicTriangulationsNamedParameters
/// \brief the angle in degrees below which no corner is to be.
template <class T>
auto minimum_angle(const T& value)
{
  return Intrinsic_triangulations::internal::named<Intrinsic_triangulations::internal::Parameter::MINIMUM_ANGLE>(value);
}
/// \ingroup PkgIntrinsicTriangulationsNamedParameters
/// \brief the largest circumradius of a face, in the unit of the input.
template <class T>
auto maximum_circumradius(const T& value)
{
  return Intrinsic_triangulations::internal::named<Intrinsic_triangulations::internal::Parameter::MAXIMUM_CIRCUMRADIUS>(
    value);
}
/// \ingroup PkgIntrinsicTriangulationsNamedParameters
/// \brief the largest length of an edge, in the unit of the input.
template <class T>
auto maximum_edge_length(const T& value)
{
  return Intrinsic_triangulations::internal::named<Intrinsic_triangulations::internal::Parameter::MAXIMUM_EDGE_LENGTH>(
    value);
}
/// \ingroup PkgIntrinsicTriangulationsNamedParameters
/// \brief the length of a side below which a face is not refined, in the unit of the input.
template <class T>
auto minimum_size(const T& value)
{
  return Intrinsic_triangulations::internal::named<Intrinsic_triangulations::internal::Parameter::MINIMUM_SIZE>(value);
}
/// \ingroup PkgIntrinsicTriangulationsNamedParameters
/// \brief whether edges that are not flipped are split until no angle opposite to them is obtuse.
template <class T>
auto splits_encroached_edges(const T& value)
{
  return Intrinsic_triangulations::internal::named<
    Intrinsic_triangulations::internal::Parameter::SPLITS_ENCROACHED_EDGES>(value);
}
/// \ingroup PkgIntrinsicTriangulationsNamedParameters
/// \brief the time for which heat spreads, in units of the squared mean length of the edges.
template <class T>
auto time_coefficient(const T& value)
{
  return Intrinsic_triangulations::internal::named<Intrinsic_triangulations::internal::Parameter::TIME_COEFFICIENT>(
    value);
}
/// \ingroup PkgIntrinsicTriangulationsNamedParameters
/// \brief what heat does at the border: a `Heat_boundary`.
template <class T>
auto heat_boundary(const T& value)
{
  return Intrinsic_triangulations::internal::named<Intrinsic_triangulations::internal::Parameter::HEAT_BOUNDARY>(value);
}
/// \ingroup PkgIntrinsicTriangulationsNamedParameters
/// \brief whether distances that are less than those of the vertices around allow are raised.
template <class T>
auto keeps_ridges(const T& value)
{
  return Intrinsic_triangulations::internal::named<Intrinsic_triangulations::internal::Parameter::KEEPS_RIDGES>(value);
}
/// \ingroup PkgIntrinsicTriangulationsNamedParameters
/// \brief how much the length of a path may be changed at each edge that it crosses, as a part of the length of the
/// edge.
template <class T>
auto tolerance(const T& value)
{
  return Intrinsic_triangulations::internal::named<Intrinsic_triangulations::internal::Parameter::TOLERANCE>(value);
}
/// \ingroup PkgIntrinsicTriangulationsNamedParameters
/// \brief what is built over triangles: a `Surface_cover`.
template <class T>
auto surface_cover(const T& value)
{
  return Intrinsic_triangulations::internal::named<Intrinsic_triangulations::internal::Parameter::SURFACE_COVER>(value);
}
/// \ingroup PkgIntrinsicTriangulationsNamedParameters
/// \brief what is done with edges of length zero: a value of `Coincident_vertices`.
template <class T>
auto coincident_vertices(const T& value)
{
  return Intrinsic_triangulations::internal::named<Intrinsic_triangulations::internal::Parameter::COINCIDENT_VERTICES>(
    value);
}
/// \ingroup PkgIntrinsicTriangulationsNamedParameters
/// \brief whether all vertices at the same place become one.
template <class T>
auto is_welded(const T& value)
{
  return Intrinsic_triangulations::internal::named<Intrinsic_triangulations::internal::Parameter::IS_WELDED>(value);
}
/// \ingroup PkgIntrinsicTriangulationsNamedParameters
/// \brief if positive, the margin by which edges are lengthened, as by `mollify_lengths()`.
template <class T>
auto mollification(const T& value)
{
  return Intrinsic_triangulations::internal::named<Intrinsic_triangulations::internal::Parameter::MOLLIFICATION>(value);
}
/// \ingroup PkgIntrinsicTriangulationsNamedParameters
/// \brief which mass matrix is returned: a `Mass_type`.
template <class T>
auto mass_type(const T& value)
{
  return Intrinsic_triangulations::internal::named<Intrinsic_triangulations::internal::Parameter::MASS_TYPE>(value);
}

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
