// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// An exact check of a result, whatever number type made it.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_VERIFY_DELAUNAY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_VERIFY_DELAUNAY_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Exact_geometry.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsRef
/// \brief what `verify_Delaunay()` found.
struct Delaunay_verification
{
  std::size_t tests = 0;                ///< number of edges that were tested
  std::size_t ties = 0;                 ///< edges whose opposite angles sum to exactly π
  std::vector<Edge_index> not_Delaunay; ///< edges whose opposite angles sum to more than π
  /// faces whose corners, laid out over the input, have the wrong orientation: a flip of a
  /// hinge that was not convex leaves no triangulation
  std::vector<Face_index> inverted;

  /// returns whether the triangulation is a Delaunay triangulation of the input surface.
  bool is_Delaunay() const { return not_Delaunay.empty() && inverted.empty(); }
};

/// \ingroup PkgIntrinsicTriangulationsRef
/// \brief decides every interior edge once more, exactly, from the input and the
/// connectivity alone.
///
/// Nothing that the traits stored is used: lengths and angles come from the unfolding over
/// the input triangles, and each sign is exact (for ties see `Tie_proof`). So the check holds for a result that was
/// made with any number type.
///
/// \tparam Triangulation an `Intrinsic_triangulation`
/// \param triangulation a triangulation that keeps its input
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{edge_is_constrained_map}
///     \cgalParamDescription{a property map that tells which edges to leave out}
///     \cgalParamType{a model of `ReadablePropertyMap` with `Edge_index` as key type and `bool` as value type}
///     \cgalParamDefault{no edge is left out}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \pre `triangulation.keeps_input()`
/// \exception Undecided_error if a proof is demanded of each tie (see `Tie_proof`), and takes too long
/// \exception Cancelled_error if the function that was given to `set_interruption()` says so
///
/// Cost: O(size + crossings) arithmetic operations in the ordinary case.
template <class Triangulation, class NamedParameters = parameters::Default_named_parameters>
Delaunay_verification verify_Delaunay(const Triangulation& triangulation,
                                      const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  const auto is_constrained =
    choose_parameter(get_parameter(np, internal_np::edge_is_constrained),
                     Static_boolean_property_map<Edge_index, false>());

  const Delta_complex& complex = triangulation.connectivity();
  const Exact_geometry& geometry = triangulation.exact_geometry();
  Delaunay_verification result;
  for (Face_index f : complex.faces()) {
    geometry.interruption().check();
    if (geometry.sign_of_area(complex, f) == NEGATIVE)
      result.inverted.push_back(f);
  }
  for (Edge_index e : complex.edges()) {
    if (!complex.is_flippable(e) || get(is_constrained, e))
      continue;
    ++result.tests;
    geometry.interruption().check();
    const Sign sign = geometry.sign_by_unfolding(complex, e);
    if (sign == NEGATIVE)
      result.not_Delaunay.push_back(e);
    else if (sign == ZERO)
      ++result.ties;
  }
  return result;
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_VERIFY_DELAUNAY_H
