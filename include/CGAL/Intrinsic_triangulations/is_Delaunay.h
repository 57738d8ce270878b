// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Whether a triangulation is Delaunay.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IS_DELAUNAY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IS_DELAUNAY_H

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/named_parameters.h>

#include <CGAL/Uncertain.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/property_map.h>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsRef
/// \brief returns whether each edge that is not constrained is Delaunay, by
/// `Intrinsic_triangulation::is_locally_Delaunay()`: exactly with the default traits.
///
/// `verify_Delaunay()` decides it anew from the input alone, exactly for any traits, and names the edges.
///
/// \tparam NamedParameters a sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{edge_is_constrained_map}
///     \cgalParamDescription{a property map that tells which edges do not matter}
///     \cgalParamType{a model of `ReadablePropertyMap` with `Edge_index` as key type and `bool` as value type}
///     \cgalParamDefault{no edge is constrained}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `false` if an edge is certainly not Delaunay; otherwise, an uncertain value if an interval number type cannot
///   tell for some edge
/// \exception Undecided_error as `sign_of_cotangents()` of `Exact_geometry`. O(size).
template <class Traits, class NamedParameters = parameters::Default_named_parameters>
typename Traits::Boolean is_Delaunay(const Intrinsic_triangulation<Traits>& triangulation,
                                     const NamedParameters& np = parameters::default_values())
{
  const auto is_constrained = internal::edge_constraints_of(np);
  typename Traits::Boolean result = true;
  for (Edge_index e : triangulation.connectivity().edges()) {
    if (get(is_constrained, e))
      continue;
    const typename Traits::Boolean answer = triangulation.is_locally_Delaunay(e);
    if (certainly_not(answer))
      return false;
    if (!certainly(answer))
      result = answer;
  }
  return result;
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IS_DELAUNAY_H
