// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Delaunay refinement.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_REFINE_DELAUNAY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_REFINE_DELAUNAY_H

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Refinement_report.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/Delaunay_refiner.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsInsertion
/// \brief the default visitor of `refine_Delaunay()`: it does nothing and never cancels.
struct Default_refinement_visitor
{
  /// is called before each step, with the numbers of new vertices and of flips so far; the algorithm stops if it returns `false`.
  bool go_further(std::uint64_t /* points */, std::uint64_t /* flips */) { return true; }
  /// is called after each new vertex, when the triangulation is Delaunay again.
  void after_insertion(Vertex_index) {}
};

template <class Traits, class NamedParameters = parameters::Default_named_parameters>
Refinement_report refine_Delaunay(Intrinsic_triangulation<Traits>& triangulation, const Refinement_criteria& criteria = {},
                                  const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  CGAL_precondition(criteria.minimum_angle <= 30);
  const auto is_constrained = choose_parameter(get_parameter(np, internal_np::edge_is_constrained),
                                               Static_boolean_property_map<Edge_index, false>());
  const Delta_complex& complex = triangulation.connectivity();
  std::vector<bool> is_segment(complex.number_of_edges());
  for (Edge_index e : complex.edges())
    is_segment[e.idx()] = complex.is_border(e) || get(is_constrained, e);
  flip_to_Delaunay(triangulation, parameters::edge_is_constrained_map(is_constrained));
  auto visitor = choose_parameter(get_parameter(np, internal_np::visitor), Default_refinement_visitor());
  auto& unwrapped = internal::unwrapped(visitor);
  const std::uint64_t maximum_number = choose_parameter(get_parameter(np, internal_np::maximum_number),
                                                        10 * std::uint64_t(complex.number_of_vertices()) + 1000000);
  return internal::Delaunay_refiner<Traits, std::decay_t<decltype(unwrapped)>>(triangulation, criteria, std::move(is_segment), unwrapped,
                                                                              maximum_number)();
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_REFINE_DELAUNAY_H
