// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Inserted vertices are taken away again.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_REMOVE_VERTEX_H
#define CGAL_INTRINSIC_TRIANGULATIONS_REMOVE_VERTEX_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Removed_elements.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/Vertex_remover.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>

#include <string>
#include <type_traits>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsInsertion
/// \brief removes a vertex that was inserted, and flips edges until the triangulation is Delaunay again.
///
/// The metric does not change, and all decisions are exact. A vertex on the border, or where a constrained edge was split,
/// is removed with the two halves of that edge becoming one.
///
/// Descriptors have no holes: the last vertex, edges and faces take the places of those that are removed. Vertices,
/// edges and faces of the input are never more than there are at the end, so that vertices of the input keep
/// their descriptors. An array with one entry for each element follows by `remove_entries()`.
///
/// \param triangulation a Delaunay triangulation, or a constrained one
/// \param v a vertex of it that was inserted
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{edge_is_constrained_map}
///     \cgalParamDescription{a property map that tells which edges must not be flipped, by their descriptors before the removal}
///     \cgalParamType{a model of `ReadablePropertyMap` with `Edge_index` as key type and `bool` as value type}
///     \cgalParamDefault{no edge is constrained}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return what was removed, and thereby which descriptors moved
/// \exception Invalid_removal_error if `v` was not inserted, if constrained edges end in it other than the two halves of an
///   input edge, or if flips leave other edges at it than three, as can happen where edges lead from `v` around a handle
///   back to `v`. The triangulation has the same vertices then, and is Delaunay
/// \exception Integer_overflow_error as `flip()` of `Normal_coordinates`
/// \exception Undecided_error, Cancelled_error as `sign_of_cotangents()` of `Exact_geometry`
/// \pre `triangulation.keeps_input()`, with traits that use exact geometry
///
/// After any exception but the first, the triangulation is valid, but may not be Delaunay near `v`, nor near the edges opposite to it. If `v` was removed
/// already, which the number of vertices tells, descriptors have moved as described.
///
/// Complexity: at most the square of the degree of `v`, that of the vertex that moves, and the number of flips afterwards.
template <class Traits, class NamedParameters = parameters::Default_named_parameters>
Removed_elements remove_vertex(Intrinsic_triangulation<Traits>& triangulation, Vertex_index v,
                               const NamedParameters& np = parameters::default_values())
{
  const auto is_constrained = parameters::choose_parameter(parameters::get_parameter(np, internal_np::edge_is_constrained),
                                                           Static_boolean_property_map<Edge_index, false>());
  if (v.idx() >= triangulation.connectivity().number_of_vertices() || !triangulation.is_inserted(v))
    throw Invalid_removal_error("vertex " + std::to_string(v.idx()) + " was not inserted: only inserted vertices can be removed");
  return internal::Vertex_remover<Traits, std::decay_t<decltype(is_constrained)>>(triangulation, v, is_constrained).remove();
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_REMOVE_VERTEX_H
