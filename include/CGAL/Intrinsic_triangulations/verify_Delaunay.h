// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Whether a triangulation is Delaunay, exactly or by its numbers, and the cells formed by its ties.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_VERIFY_DELAUNAY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_VERIFY_DELAUNAY_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>
#include <CGAL/Intrinsic_triangulations/internal/system/for_each_block.h>
#include <CGAL/Intrinsic_triangulations/internal/named_parameters.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>
#include <CGAL/tags.h>

#include <atomic>
#include <cstddef>
#include <exception>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsRef
/// \brief the result of `verify_Delaunay()`.
struct Delaunay_verification
{
  std::size_t tests = 0;                ///< number of edges that were tested
  std::size_t ties = 0;                 ///< edges whose opposite angles sum to exactly π
  std::vector<Edge_index> not_Delaunay; ///< edges whose opposite angles sum to more than π
  /// faces whose corners, laid out over the input, have the wrong orientation: after a flip of a nonconvex hinge there
  /// is no triangulation
  std::vector<Face_index> inverted;

  /// returns whether the triangulation is a Delaunay triangulation of the input surface.
  bool is_Delaunay() const { return not_Delaunay.empty() && inverted.empty(); }
};

namespace internal {

// Decides blocks of faces, then blocks of edges.
template <class ConcurrencyTag, class ConstraintMap>
class Delaunay_verifier
{
public:
  Delaunay_verifier(const Exact_engine& engine, const ConstraintMap& is_constrained)
    : complex_(engine.connectivity()), engine_(engine), is_constrained_(is_constrained)
  {}

  Delaunay_verification verify() const
  {
    Delaunay_verification result;
    verify_elements<Face_index>(complex_.number_of_faces(), result);
    verify_elements<Edge_index>(complex_.number_of_edges(), result);
    return result;
  }

private:
  // A decision takes a microsecond, but some take a thousand; small blocks distribute them well.
  static constexpr std::size_t elements_of_block = 1024;

  // The findings in a block, or the exception that ended it.
  struct Part
  {
    Delaunay_verification found;
    std::exception_ptr failure;
  };

  template <class Element>
  void verify_elements(std::size_t n, Delaunay_verification& result) const
  {
    std::vector<Part> parts((n + elements_of_block - 1) / elements_of_block);
    // Earlier blocks go on, because the first failing decision must be reported.
    std::atomic<std::size_t> end{parts.size()};
    for_each_block<ConcurrencyTag>(n, elements_of_block, [&](std::size_t first, std::size_t last) {
      const std::size_t block = first / elements_of_block;
      Part& part = parts[block];
      try {
        for (std::size_t i = first; i < last && block < end.load(std::memory_order_relaxed); ++i)
          verify(Element(typename Element::size_type(i)), part.found);
      } catch (const Cancelled_error&) {
        part.failure = std::current_exception();
        end = 0;
      } catch (...) {
        part.failure = std::current_exception();
        std::size_t before = end;
        while (block < before && !end.compare_exchange_weak(before, block)) {
        }
      }
    });
    for (const Part& part : parts) {
      if (part.failure)
        std::rethrow_exception(part.failure);
      append(part.found, result);
    }
  }

  void verify(Face_index f, Delaunay_verification& found) const
  {
    engine_.decisions().interruption.check();
    if (engine_.sign_of_area(f) == NEGATIVE)
      found.inverted.push_back(f);
  }
  void verify(Edge_index e, Delaunay_verification& found) const
  {
    if (!complex_.is_flippable(e) || get(is_constrained_, e))
      return;
    ++found.tests;
    engine_.decisions().interruption.check();
    const Sign sign = engine_.test(e, Exact_engine::Means::UNFOLDING)->sign;
    if (sign == NEGATIVE)
      found.not_Delaunay.push_back(e);
    else if (sign == ZERO)
      ++found.ties;
  }

  static void append(const Delaunay_verification& part, Delaunay_verification& result)
  {
    result.tests += part.tests;
    result.ties += part.ties;
    result.not_Delaunay.insert(result.not_Delaunay.end(), part.not_Delaunay.begin(), part.not_Delaunay.end());
    result.inverted.insert(result.inverted.end(), part.inverted.begin(), part.inverted.end());
  }

  const Delta_complex& complex_;
  const Exact_engine& engine_;
  const ConstraintMap& is_constrained_;
};

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsRef
/// \brief decides every interior edge again, exactly, from the input and the connectivity alone.
///
/// No number stored by the traits is used: lengths and angles come from the unfolding over the input triangles, and
/// each sign is exact (for ties see `Tie_proof`). So the check is valid for results of any number type.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` (with TBB) or `Parallel_if_available_tag`: the result, or
///   the edge that cannot be decided, is the same
/// \tparam Triangulation an `Intrinsic_triangulation`
/// \param triangulation a triangulation that keeps its input
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamConstraints{which edges to leave out; with `Parallel_tag` several threads read it at once}
/// \cgalNamedParamsEnd
///
/// \exception Invalid_argument_error if the triangulation does not keep its input: those of traits that round keep it
/// if `Intrinsic_triangulation::keep_input()` was called before the first flip
/// \exception Undecided_error if proofs of ties are demanded (see `Tie_proof`), and one takes too long
/// \exception Cancelled_error if the function given to `set_interruption()` asks for it
///
/// Cost: O(size + crossings) arithmetic operations in the ordinary case.
template <class ConcurrencyTag = Sequential_tag, class Triangulation,
          class NamedParameters = parameters::Default_named_parameters>
Delaunay_verification verify_Delaunay(const Triangulation& triangulation,
                                      const NamedParameters& np = parameters::default_values())
{
  const auto is_constrained = internal::edge_constraints_of(np);
  return internal::Delaunay_verifier<ConcurrencyTag, std::decay_t<decltype(is_constrained)>>(
           internal::engine<ConcurrencyTag>(triangulation), is_constrained)
    .verify();
}

/// \ingroup PkgIntrinsicTriangulationsRef
/// \brief returns whether each edge that is not constrained is Delaunay, by
/// `Intrinsic_triangulation::is_locally_Delaunay()`: exactly with the default traits.
///
/// `verify_Delaunay()` decides this from the input alone, exactly for any traits, and names the edges.
///
/// \param triangulation the triangulation
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamConstraints{which edges to ignore}
/// \cgalNamedParamsEnd
///
/// \return `false` if an edge is certainly not Delaunay; otherwise, an uncertain value if an interval number type
///   cannot tell for some edge
/// \exception Undecided_error as `sign_of_cotangent_weight()`. O(size).
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

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_VERIFY_DELAUNAY_H
