// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Long runs of flips around tubes, made by a division.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_UNTWIST_H
#define CGAL_INTRINSIC_TRIANGULATIONS_UNTWIST_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Untwisting.h>
#include <CGAL/Intrinsic_triangulations/config.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/observer.h>
#include <CGAL/Intrinsic_triangulations/rational_metric.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/property_map.h>

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \cond SKIP_IN_MANUAL
namespace internal {

Untwisting untwist(Delta_complex& complex, std::vector<Rational>& squared_lengths,
                   const std::function<bool(Edge_index)>& is_constrained,
                   const std::function<bool(std::uint64_t, std::uint64_t)>& go_further);

} // namespace internal
/// \endcond

/// \ingroup PkgIntrinsicTriangulationsTwists
/// \brief returns the exact squares of lengths that are doubles, for `untwist()`.
/// \exception Invalid_surface_error if a length is not positive and finite
std::vector<Rational> squared_lengths(const std::vector<double>& lengths);

/// \ingroup PkgIntrinsicTriangulationsTwists
/// \brief makes the flips within tubes of two faces, many at a time, until each tube is Delaunay inside.
///
/// Two faces that share two edges, and whose other sides are loops of the same length, are a flat tube. The flips of edges
/// across a tube can be as many as it is twisted. They are all of one kind, so that a division tells how many there are, and the squared lengths
/// and the numbers of crossings after them are found at once. A torus with one vertex consists of three such tubes at a time,
/// which are untwisted in turn, as in Gauss's reduction of a lattice.
///
/// All flips are those that `flip_to_Delaunay()` could have made. So the result, flipped by it, is the intrinsic Delaunay triangulation of
/// what was given, but the squared lengths stay rational, and `Intrinsic_triangulation::from_metric()` takes them as a new input, which
/// overlays and points refer to.
///
/// Tubes that are left alone: those of more faces than two; those whose loops have different lengths, which cannot wind far; and
/// those of area zero.
///
/// \tparam NamedParameters a sequence of named parameters
/// \param complex the triangles; all descriptors stay valid, as with flips
/// \param squared_lengths the squared length of each edge
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{edge_is_constrained_map}
///     \cgalParamDescription{a property map that tells which edges must not be flipped; a tube that one crosses is left alone}
///     \cgalParamType{a model of `ReadablePropertyMap` with `Edge_index` as key type and `bool` as value type}
///     \cgalParamDefault{no edge is constrained}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{`go_further(tests, flips)` is asked now and then, with the numbers of tubes so far and of flips made one by one, and ends the function with `false`.
///       `after_flip()` is not called}
///     \cgalParamType{a model of `IntrinsicTriangulationVisitor`}
///     \cgalParamDefault{`Default_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the twists, and how often the edges cross those of the complex that was given
/// \exception Invalid_surface_error if there are not as many squared lengths as edges
///
/// An exception, that of a visitor as well, leaves everything as it was. O(size), and for each twist O(1) operations with integers of the size of its power and of the lengths. For a torus with one vertex, the number of twists is
/// logarithmic in the ratio of lengths.
///
/// Source: the idea of jumping over flips is that of L. Dubois, arXiv 2601.03954 (2026), for tubes of any number of faces.
template <class NamedParameters = parameters::Default_named_parameters>
Untwisting untwist(Delta_complex& complex, std::vector<Rational>& squared_lengths,
                   const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::is_default_parameter;
  std::function<bool(Edge_index)> is_constrained;
  if constexpr (!is_default_parameter<NamedParameters, internal_np::edge_is_constrained_t>::value)
    is_constrained = [&np](Edge_index e) { return bool(get(get_parameter(np, internal_np::edge_is_constrained), e)); };
  if constexpr (is_default_parameter<NamedParameters, internal_np::visitor_t>::value) {
    return internal::untwist(complex, squared_lengths, is_constrained, {});
  } else {
    auto observer = internal::observer_of(np);
    return internal::untwist(complex, squared_lengths, is_constrained,
                             [&observer](std::uint64_t tests, std::uint64_t flips) { return observer.go_further(tests, flips); });
  }
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/internal/flips/untwist_impl.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_UNTWIST_H
