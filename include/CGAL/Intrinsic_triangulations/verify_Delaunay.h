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
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>
#include <CGAL/Intrinsic_triangulations/internal/system/for_each_block.h>
#include <CGAL/Intrinsic_triangulations/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/enum.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
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

/// \cond SKIP_IN_MANUAL
namespace internal {

// Decides blocks of faces, then blocks of edges.
template <class ConstraintMap>
class Delaunay_verifier
{
public:
  Delaunay_verifier(const Delta_complex& complex, const Exact_geometry& geometry, const ConstraintMap& is_constrained)
    : complex_(complex), geometry_(geometry), is_constrained_(is_constrained)
  {}

  // `loop(n, f)` calls f(first, last) for ranges that make up [0, n) on one thread or several.
  template <class Loop>
  Delaunay_verification verify(const Loop& loop) const
  {
    Delaunay_verification result;
    verify_elements<Face_index>(complex_.number_of_faces(), loop, result);
    verify_elements<Edge_index>(complex_.number_of_edges(), loop, result);
    return result;
  }

private:
  // A decision takes a microsecond, but some take a thousand: small blocks share them out well.
  static constexpr std::size_t elements_of_block = 1024;

  // What was found in a block, or what ended it.
  struct Part
  {
    Delaunay_verification found;
    std::exception_ptr failure;
  };

  template <class Element, class Loop>
  void verify_elements(std::size_t n, const Loop& loop, Delaunay_verification& result) const
  {
    std::vector<Part> parts((n + elements_of_block - 1) / elements_of_block);
    // Blocks before this one go on: of the decisions that fail, the first is to be named.
    std::atomic<std::size_t> end{parts.size()};
    const auto verify_block = [&](std::size_t block) {
      Part& part = parts[block];
      try {
        const std::size_t last = (std::min)((block + 1) * elements_of_block, n);
        for (std::size_t i = block * elements_of_block; i < last && block < end.load(std::memory_order_relaxed); ++i)
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
    };
    loop(parts.size(), [&](std::size_t first, std::size_t last) {
      for (std::size_t block = first; block < last; ++block)
        verify_block(block);
    });
    for (const Part& part : parts) {
      if (part.failure)
        std::rethrow_exception(part.failure);
      append(part.found, result);
    }
  }

  void verify(Face_index f, Delaunay_verification& found) const
  {
    geometry_.interruption().check();
    if (geometry_.sign_of_area(complex_, f) == NEGATIVE)
      found.inverted.push_back(f);
  }
  void verify(Edge_index e, Delaunay_verification& found) const
  {
    if (!complex_.is_flippable(e) || get(is_constrained_, e))
      return;
    ++found.tests;
    geometry_.interruption().check();
    const Sign sign = geometry_.sign_by_unfolding(complex_, e);
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
  const Exact_geometry& geometry_;
  const ConstraintMap& is_constrained_;
};

} // namespace internal
/// \endcond

/// \ingroup PkgIntrinsicTriangulationsRef
/// \brief decides every interior edge once more, exactly, from the input and the
/// connectivity alone.
///
/// Nothing that the traits stored is used: lengths and angles come from the unfolding over
/// the input triangles, and each sign is exact (for ties see `Tie_proof`). So the check holds for a result that was
/// made with any number type.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` (with TBB) or `Parallel_if_available_tag`: what is found, or the
///   edge that cannot be decided, is the same
/// \tparam Triangulation an `Intrinsic_triangulation`
/// \param triangulation a triangulation that keeps its input
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{edge_is_constrained_map}
///     \cgalParamDescription{a property map that tells which edges to leave out; with `Parallel_tag` it is read by several threads at once}
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
template <class ConcurrencyTag = Sequential_tag, class Triangulation,
          class NamedParameters = parameters::Default_named_parameters>
Delaunay_verification verify_Delaunay(const Triangulation& triangulation,
                                      const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  return internal::Delaunay_verifier(triangulation.connectivity(), triangulation.template exact_geometry<ConcurrencyTag>(),
                                     choose_parameter(get_parameter(np, internal_np::edge_is_constrained),
                                                      Static_boolean_property_map<Edge_index, false>()))
    .verify([](std::size_t n, const auto& f) { internal::for_each_block<ConcurrencyTag>(n, 1, f); });
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_VERIFY_DELAUNAY_H
