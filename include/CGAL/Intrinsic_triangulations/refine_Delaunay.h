// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Delaunay refinement.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_REFINE_DELAUNAY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_REFINE_DELAUNAY_H

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/Delaunay_refiner.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Standard_arithmetic.h>
#include <CGAL/Intrinsic_triangulations/reports.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>

#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsInsertion
/// \brief the default visitor of `refine_Delaunay()`: it does nothing and never cancels.
struct Default_refinement_visitor
{
  /// is called before each step and within long ones, with the numbers of new vertices and of flips so far; the algorithm stops
  /// if it returns `false`. As long as there is no new vertex, edges are flipped until the triangulation is Delaunay.
  bool go_further(std::uint64_t /* points */, std::uint64_t /* flips */) { return true; }
  /// is called before each face that is refined, with what is left to do.
  void before_step(const Refinement_progress&) {}
  /// is called after each new vertex, when the triangulation is Delaunay again; not for the last one if that is interrupted.
  void after_insertion(Vertex_index) {}
};

/// \cond SKIP_IN_MANUAL
namespace internal {

// Asks a visitor of the refinement while edges are flipped before it.
template <class Visitor>
struct Flips_before_refinement
{
  Visitor& visitor;

  bool go_further(std::uint64_t, std::uint64_t flips) { return visitor.go_further(0, flips); }
  void after_flip(Edge_index) {}
};

} // namespace internal
/// \endcond

/// \ingroup PkgIntrinsicTriangulationsInsertion
/// \brief flips edges until the triangulation is Delaunay, and inserts vertices until no triangle is too thin or too large.
///
/// A triangle that does not meet the criteria gets a vertex at its circumcenter, or closer to its shortest side if that is far shorter than
/// the circumradius, found by a straight walk over the triangles. Small angles at the shortest sides come first, then the largest
/// triangles. An edge of the border or a constrained one that is in the way, or that the vertex would encroach on, is split instead.
/// Where the new vertices lie is chosen in doubles; what follows from that is exact, as in `insert_vertex()`: the metric does not change,
/// and after each insertion all edges that are not constrained are Delaunay.
///
/// No vertex is inserted for a face with a side shorter than the smallest size, if one is given, whatever its angles are.
///
/// A vertex inside the surface whose angles sum to less than 60 degrees gets one neighbor close to it, and the triangle between
/// them is left as it is. Edges that end in a corner of less than 60 degrees between two edges that are not flipped are split at powers of
/// two.
///
/// \tparam Traits with exact geometry
/// \param triangulation a triangulation that keeps its input
/// \param criteria which triangles are refined
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{edge_is_constrained_map}
///     \cgalParamDescription{a property map that tells which edges must not be flipped. They have to coincide with input edges. It is asked
///       at the beginning only; the parts of an edge that is split are constrained, too}
///     \cgalParamType{a model of `ReadablePropertyMap` with `Edge_index` as key type and `bool` as value type}
///     \cgalParamDefault{no edge is constrained}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{is told of each new vertex and can cancel; pass `std::ref()` to keep its state}
///     \cgalParamType{a class with the members of `Default_refinement_visitor`}
///     \cgalParamDefault{`Default_refinement_visitor`}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_number}
///     \cgalParamDescription{the largest number of new vertices}
///     \cgalParamType{`std::uint64_t`}
///     \cgalParamDefault{ten for each vertex, and a million}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return what happened. The triangulation is valid whatever the status, and Delaunay unless it was cancelled within a step
/// \exception Integer_overflow_error, Undecided_error, Cancelled_error as `insert_vertex()`. The triangulation is valid after any exception, too
/// \pre `criteria.minimum_angle <= 30`, `criteria.minimum_size >= 0`
///
/// Source: J. Ruppert, "A Delaunay refinement algorithm for quality 2-dimensional mesh generation" (1995); A. Ungor, "Off-centers: a new
/// type of Steiner points for computing size-optimal quality-guaranteed Delaunay triangulations" (2009); on surfaces, N. Sharp,
/// Y. Soliman, K. Crane, "Navigating intrinsic triangulations" (2019).
template <class Traits, class NamedParameters = parameters::Default_named_parameters>
Refinement_report refine_Delaunay(Intrinsic_triangulation<Traits>& triangulation, const Refinement_criteria& criteria = {},
                                  const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  CGAL_precondition(criteria.minimum_angle <= 30 && criteria.minimum_size >= 0);
  const auto is_constrained = choose_parameter(get_parameter(np, internal_np::edge_is_constrained),
                                               Static_boolean_property_map<Edge_index, false>());
  const Delta_complex& complex = triangulation.connectivity();
  std::vector<bool> is_segment(complex.number_of_edges());
  for (Edge_index e : complex.edges())
    is_segment[e.idx()] = complex.is_border(e) || get(is_constrained, e);
  const internal::Standard_arithmetic arithmetic;
  auto visitor = choose_parameter(get_parameter(np, internal_np::visitor), Default_refinement_visitor());
  auto& unwrapped = internal::unwrapped(visitor);
  using Visitor = std::decay_t<decltype(unwrapped)>;
  const auto constraints = parameters::edge_is_constrained_map(is_constrained);
  const Flip_report flips = [&] {
    if constexpr (std::is_same_v<Visitor, Default_refinement_visitor>)
      return flip_to_Delaunay(triangulation, constraints);
    else
      return flip_to_Delaunay(triangulation, constraints.visitor(internal::Flips_before_refinement<Visitor>{unwrapped}));
  }();
  if (flips.status == Flip_status::CANCELLED) {
    Refinement_report cancelled;
    cancelled.status = Refinement_status::CANCELLED;
    return cancelled;
  }
  const std::uint64_t maximum_number = choose_parameter(get_parameter(np, internal_np::maximum_number),
                                                        10 * std::uint64_t(complex.number_of_vertices()) + 1000000);
  internal::Delaunay_refiner<Traits, Visitor> refiner(triangulation, criteria, std::move(is_segment), unwrapped, maximum_number);
  std::optional<internal::Interruption_scope<Intrinsic_triangulation<Traits>>> scope;
  if constexpr (!std::is_same_v<Visitor, Default_refinement_visitor>)
    scope.emplace(triangulation, [&refiner] { return refiner.asks_further(); });
  return refiner();
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_REFINE_DELAUNAY_H
