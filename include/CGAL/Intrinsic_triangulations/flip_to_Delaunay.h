// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The flip algorithm of the paper, section 2.2: a list of edges, a mark for each.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FLIP_TO_DELAUNAY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FLIP_TO_DELAUNAY_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/flips/Delaunay_flipper.h>
#include <CGAL/Intrinsic_triangulations/internal/flips/Whole_triangulation.h>
#ifdef CGAL_LINKED_WITH_TBB
#include <CGAL/Intrinsic_triangulations/internal/flips/Parallel_Delaunay_flipper.h>
#endif
#include <CGAL/Intrinsic_triangulations/internal/system/for_each_block.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Standard_arithmetic.h>
#include <CGAL/Intrinsic_triangulations/internal/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/observer.h>
#include <CGAL/Intrinsic_triangulations/reports.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsRef
/// \brief returns the default bound on the number of flips for an inexact number type.
///
/// Rounded decisions can flip forever; the bound is far beyond what a surface needs.
/// \param number_of_edges the number of edges of the surface
inline std::uint64_t default_maximum_number_of_flips(std::size_t number_of_edges)
{
  return (std::max)(std::uint64_t(10000000), 100 * std::uint64_t(number_of_edges));
}

namespace internal {

// \param triangulation a Whole_triangulation, or a class with its members
template <class ConcurrencyTag, class Triangulation, class ConstraintMap, class Visitor>
Flip_report flip_all(Triangulation triangulation, const ConstraintMap& is_constrained, Visitor& visitor,
                     std::uint64_t budget)
{
  const Edge_index::size_type n = triangulation.connectivity().number_of_edges();
  triangulation.engine().begin_log();
  Edge_marks marks(n, default_init);
  if (n != 0)
    std::memset(marks.data(), int(Edge_mark::CANDIDATE), n);
  Delaunay_flipper<Triangulation, ConstraintMap, Visitor> flipper(triangulation, is_constrained, visitor, budget,
                                                                  marks);
  std::optional<Standard_arithmetic> arithmetic;
  if constexpr (Triangulation::Traits::Uses_exact_geometry::value)
    arithmetic.emplace();
  std::optional<Interruption_scope<Triangulation>> scope;
  if constexpr (Triangulation::Traits::Uses_exact_geometry::value && !Visitor::Is_silent::value)
    scope.emplace(triangulation, [&flipper] { return flipper.goes_further(); });
  require_threads<ConcurrencyTag>();
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr (std::is_convertible<ConcurrencyTag, Parallel_tag>::value) {
    using Parallel = Parallel_Delaunay_flipper<typename Triangulation::Traits, ConstraintMap, Visitor>;
    if (Parallel::is_useful(triangulation.triangulation()))
      return flipper.finish(
        Parallel(triangulation.triangulation(), is_constrained, visitor, budget, marks).settle_all(flipper));
  }
#endif
  return flipper.finish(flipper.settle(0, n));
}

// As flip_to_Delaunay(), with the constraints separate from the other parameters.
template <class ConcurrencyTag, class Traits, class ConstraintMap, class NamedParameters>
Flip_report flip_to_Delaunay_with(Intrinsic_triangulation<Traits>& triangulation, const ConstraintMap& is_constrained,
                                  const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  constexpr bool is_exact = Traits::Has_exact_decisions::value;

  const std::uint64_t budget =
    choose_parameter(get_parameter(np, internal_np::maximum_number),
                     is_exact ? (std::numeric_limits<std::uint64_t>::max)()
                              : default_maximum_number_of_flips(triangulation.connectivity().number_of_edges()));
  auto observer = observer_of(np);
  if constexpr (Traits::Uses_exact_geometry::value &&
                !parameters::is_default_parameter<NamedParameters, Parameter_tag<Parameter::TIE_PROOF>>::value)
    triangulation.set_tie_proof(get_parameter(np, Parameter_tag<Parameter::TIE_PROOF>()));
  if constexpr (decltype(observer)::template sees_tests<typename Traits::Boolean>)
    return flip_all<Sequential_tag>(Watched_triangulation<Traits, decltype(observer)>(triangulation, observer),
                                    is_constrained, observer, budget);
  else
    return flip_all<ConcurrencyTag>(Whole_triangulation<Traits>(triangulation), is_constrained, observer, budget);
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsRef
/// \brief flips edges until the triangulation is Delaunay.
///
/// All edges are visited in order, a thousand at a time. An edge that is not Delaunay is flipped, and the four edges
/// around it join a list unless they are already on it or still to be visited. The list is processed, round by round,
/// before more edges are visited. (The paper uses a stack. The order does not affect the result, but here most steps
/// need not wait for the previous one.) With exact decisions the algorithm ends, and then every edge that is not
/// constrained is Delaunay.
///
/// Because of rounding, an edge that is not Delaunay may seem to have no other diagonal. It is kept and reported, like
/// an edge that an interval cannot decide.
///
/// With `Parallel_tag`, the threads of TBB flip edges within blocks of 65,536 consecutive edges, then within other such
/// blocks. After that they test the edges that are still open, such as ties, while nothing is flipped, and one thread
/// handles the few that are not Delaunay. The result is the same for any number of threads. It equals that of
/// `Sequential_tag`, except for the choice among several Delaunay triangulations if there are ties. The counts of tests
/// and stages do not depend on the number of threads either, but may differ from those of `Sequential_tag`. It is
/// effective if the edge numbering is spatially coherent. With number types other than `double` and `float` it acts
/// like `Sequential_tag`.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` (with TBB) or `Parallel_if_available_tag`
/// \param triangulation the triangulation, which is flipped
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin \cgalParamConstraints{which edges must not be flipped; with `Parallel_tag` several threads
///   read it at once} \cgalParamVisitor{is called after each flip and can cancel; pass `std::ref()` to keep its state}
///   \cgalParamNBegin{tie_proof} \cgalParamDescription{which proof exact decisions require for a tie, in this run and
///   later ones. It has no effect without exact geometry} \cgalParamType{`Tie_proof`} \cgalParamDefault{the current
///   setting, initially `Tie_proof::PROBABLE_IF_COSTLY`} \cgalParamNEnd \cgalParamNBegin{maximum_number}
///   \cgalParamDescription{the flip budget: the number of flips after which the algorithm gives up}
///   \cgalParamType{`std::uint64_t`} \cgalParamDefault{unlimited for an exact number type,
///   `default_maximum_number_of_flips()` otherwise} \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the report. The triangulation is valid with any status.
/// \exception Cancelled_error if the visitor asks for it
/// \exception Undecided_error if an edge crosses more than 2<sup>20</sup> input edges, or a demanded proof of a tie
///   (`tie_proof`) takes too long. After any exception, including those of a visitor and `std::bad_alloc`, the
///   triangulation is valid, and another call continues
///
/// Source: Fisher, Springborn, Schroeder, Bobenko (2006), section 2.2.
template <class ConcurrencyTag = Sequential_tag, class Traits,
          class NamedParameters = parameters::Default_named_parameters>
Flip_report flip_to_Delaunay(Intrinsic_triangulation<Traits>& triangulation,
                             const NamedParameters& np = parameters::default_values())
{
  return internal::flip_to_Delaunay_with<ConcurrencyTag>(triangulation, internal::edge_constraints_of(np), np);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FLIP_TO_DELAUNAY_H
