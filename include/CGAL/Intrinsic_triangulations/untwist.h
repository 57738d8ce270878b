// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Gluings whose edges wind around thin parts any number of times, and their Delaunay triangulation.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_UNTWIST_H
#define CGAL_INTRINSIC_TRIANGULATIONS_UNTWIST_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/internal/flips/default_traits.h>
#include <CGAL/Intrinsic_triangulations/internal/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/observer.h>
#include <CGAL/Intrinsic_triangulations/squared_lengths.h>
#include <CGAL/Intrinsic_triangulations/errors.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsTwists
/// \brief two faces that share two edges, and whose other sides are loops: a tube.
///
/// The two shared edges run across the tube. Seen with `loop` at the bottom, from left to right, one is to the left of
/// the upper corner of the first face and one to its right: the face is (i, i, q), with the sides `loop`, `next(loop)`
/// and `prev(loop)`.
struct Tube
{
  Halfedge_index loop;  ///< one side, with the tube to its left
  Halfedge_index other; ///< the other side, with the tube to its left
  Edge_index right;     ///< the edge of `next(loop)`
  Edge_index left;      ///< the edge of `prev(loop)`
};

/// \ingroup PkgIntrinsicTriangulationsTwists
/// \brief returns whether the face to the left of `loop` and another one form a `Tube` with `loop` as one of its sides.
/// O(1).
///
/// This depends on the connectivity alone. `loop` and `other` may be the same edge, as on a torus.
bool is_tube(const Delta_complex& complex, Halfedge_index loop);

/// \ingroup PkgIntrinsicTriangulationsTwists
/// \brief returns the tube to the left of `loop`. O(1). \pre `is_tube(complex, loop)`
Tube tube(const Delta_complex& complex, Halfedge_index loop);

/// \ingroup PkgIntrinsicTriangulationsTwists
///
/// \brief how often each edge of a triangulation crosses edges of the one that it was flipped from, as integers of any
/// size.
///
/// The same numbers as in `Normal_coordinates`, which stop at 2^60 and also know the order of crossings. These follow
/// flips and whole powers of twists.
class Crossing_counts
{
public:
  /// constructs the counts of an empty triangulation.
  Crossing_counts() = default;
  /// constructs the counts of a triangulation in itself. O(edges).
  explicit Crossing_counts(const Delta_complex& input) : counts_(input.number_of_edges(), Integer(-1)) {}

  /// returns the number of edges.
  std::size_t number_of_edges() const { return counts_.size(); }
  /// returns the number of times that input edges cross `e`, or −1 if `e` coincides with one.
  const Integer& crossings(Edge_index e) const { return counts_[e.idx()]; }
  /// returns whether `e` coincides with an input edge.
  bool is_original(Edge_index e) const { return crossings(e) < 0; }
  /// returns the number of times that input edges cross `e`.
  Integer number_of_crossings(Edge_index e) const { return is_original(e) ? Integer(0) : crossings(e); }

  /// \brief updates the counts for the flip of `e`; to be called before that of the connectivity.
  ///
  /// O(1) operations with integers.
  /// \pre `complex.is_flippable(e)`
  void flip(const Delta_complex& complex, Edge_index e);

  /// \brief updates the counts for the flip of `e` that `complex.flip(e)` has just made, as the visitor of
  /// `flip_to_Delaunay()` reports it.
  void after_flip(const Delta_complex& complex, Edge_index e);

  /// \brief updates the counts for `|power|` flips within a tube, a multiple of four, which leaves the connectivity
  /// unchanged.
  ///
  /// A positive power turns the far side of the tube to the right, with its side at the bottom: the vector of an
  /// edge from the bottom to the top grows by `power` times that of the side. O(1) operations with integers.
  void twist(const Delta_complex& complex, const Tube& tube, const Integer& power);

private:
  Integer count(Halfedge_index h, const Delta_complex& complex) const { return number_of_crossings(complex.edge(h)); }
  void flip(const Delta_complex& complex, const Hinge_halfedges& around);

  std::vector<Integer> counts_;
};

/// \ingroup PkgIntrinsicTriangulationsTwists
/// \brief consecutive flips within one tube.
struct Twist
{
  Halfedge_index loop; ///< a side of the tube, with the tube to its left
  Integer
    power; ///< the number of flips; positive if they turn the far side to the right, as `Crossing_counts::twist()` explains
};

/// \ingroup PkgIntrinsicTriangulationsTwists
/// \brief what `untwist()` did.
struct Untwisting
{
  std::vector<Twist> twists;         ///< in order; each tube belongs to the triangulation that earlier twists leave
  Integer number_of_flips = 0;       ///< of all twists together
  std::uint64_t number_of_steps = 0; ///< how many of those flips were made one by one
  Crossing_counts crossings;         ///< how often each edge crosses edges of the complex that was given
  bool is_complete = true;           ///< `false` if the visitor ended it: then some tubes are left as they were
};

namespace internal {

Untwisting untwist(Delta_complex& complex, std::vector<Rational>& squared_lengths,
                   const std::function<bool(Edge_index)>& is_constrained,
                   const std::function<bool(std::uint64_t, std::uint64_t)>& go_further);

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsTwists
/// \brief makes the flips within tubes of two faces, many at a time, until the edges within each tube are Delaunay.
///
/// Two faces that share two edges, and whose other sides are loops of the same length, are a flat tube. A twisted tube
/// can need any number of flips of the edges across it. They are all of one kind, so a division gives their number, and
/// the resulting squared lengths and numbers of crossings are found at once. A torus with one vertex consists of three
/// such tubes at a time, which are untwisted in turn, as in Gauss's reduction of a lattice.
///
/// `flip_to_Delaunay()` could have made all of these flips. So flipping the result gives the intrinsic Delaunay
/// triangulation of the given surface. The squared lengths stay rational, and `Intrinsic_triangulation::from_metric()`
/// takes them as a new input, to which overlays and points refer.
///
/// It does not change tubes of more than two faces, tubes whose loops have different lengths (which cannot wind far),
/// and tubes of zero area.
///
/// \param complex the triangles; all descriptors stay valid, as with flips
/// \param squared_lengths the squared length of each edge
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamConstraints{which edges must not be flipped; a tube that such an edge crosses is not changed}
///   \cgalParamVisitor{`go_further()` is called from time to time with the numbers of tubes and of single flips so far,
///     and can cancel. `after_flip()` is not called}
/// \cgalNamedParamsEnd
///
/// \return the twists, and how often the edges cross the edges of the given complex
/// \exception Invalid_surface_error if there are not as many squared lengths as edges
///
/// Any exception, including those of a visitor, leaves everything unchanged. O(size), and for each twist O(1)
/// operations with integers of the size of its power and of the lengths. For a torus with one vertex, the number of
/// twists is logarithmic in the ratio of lengths.
///
/// Source: L. Dubois, arXiv 2601.03954 (2026), had the idea of jumping over flips, for tubes of any number of faces.
template <class NamedParameters = parameters::Default_named_parameters>
Untwisting untwist(Delta_complex& complex, std::vector<Rational>& squared_lengths,
                   const NamedParameters& np = parameters::default_values())
{
  const auto is_constrained = internal::edge_constraints_of(np);
  auto observer = internal::observer_of(np);
  return internal::untwist(
    complex, squared_lengths, [&](Edge_index e) { return bool(get(is_constrained, e)); },
    [&](std::uint64_t tests, std::uint64_t flips) { return observer.go_further(tests, flips); });
}

/// \ingroup PkgIntrinsicTriangulationsTwists
/// \brief the intrinsic Delaunay triangulation of a gluing.
///
/// \tparam Traits a model of `IntrinsicTriangulationTraits`
template <class Traits>
struct Gluing_triangulation
{
  Intrinsic_triangulation<Traits> triangulation; ///< its input is the gluing after the twists
  Flip_report report;                            ///< the report of the flips after the twists
  Untwisting untwisting; ///< the twists; `crossings` count how often its edges cross the given ones
};

namespace internal {

// Passes everything on, and counts crossings.
template <class Visitor>
class Counting_visitor
{
public:
  using Is_silent = Tag_false;

  Counting_visitor(Visitor& visitor, const Delta_complex& complex, Crossing_counts& crossings)
    : visitor_(visitor), complex_(complex), crossings_(crossings)
  {}
  bool go_further(std::uint64_t tests, std::uint64_t flips) { return visitor_.go_further(tests, flips); }
  void after_flip(Edge_index e)
  {
    crossings_.after_flip(complex_, e);
    visitor_.after_flip(e);
  }

private:
  Visitor& visitor_;
  const Delta_complex& complex_;
  Crossing_counts& crossings_;
};

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsTwists
/// \brief constructs the intrinsic Delaunay triangulation of a gluing, from its exact lengths or squared lengths.
///
/// The i-th vertex, edge and face of the result are the i-th of the gluing's complex.
///
/// \param gluing the triangles and lengths
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{fast_forward}
///     \cgalParamDescription{whether to call `untwist()` first, which allows more flips than can be made one by one;
///       must be the first parameter of the sequence}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{geom_traits}
///     \cgalParamDescription{the traits, which have to use exact geometry}
///     \cgalParamType{a model of `IntrinsicTriangulationTraits`}
///     \cgalParamDefault{`Filtered_edge_length_traits`}
///   \cgalParamNEnd
///   \cgalParamConstraints{which edges must not be flipped; tubes that they cross are not untwisted}
///   \cgalParamNBegin{visitor, maximum_number}
///     \cgalParamDescription{as for `flip_to_Delaunay()`; the visitor can also cancel `untwist()`. Both refer to the
///       single flips after the twists}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the triangulation; overlays and points refer to the gluing after the twists. `untwisting.crossings` counts
///   how often its edges cross those of the given gluing, with or without twists
///
/// \exception Invalid_surface_error if a length is not positive, or the lengths of a face violate the triangle
///   inequality; equality is accepted
template <class NamedParameters = parameters::Default_named_parameters>
auto intrinsic_Delaunay_triangulation(const Exact_gluing& gluing,
                                      const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using Traits = typename internal_np::Lookup_named_param_def<internal_np::geom_traits_t, NamedParameters,
                                                              Filtered_edge_length_traits>::type;
  using Triangulation = Intrinsic_triangulation<Traits>;
  static_assert(Triangulation::uses_exact_geometry, "needs traits that use exact geometry");
  const Traits traits = choose_parameter<Traits>(get_parameter(np, internal_np::geom_traits));
  const bool is_fast = internal::value_of<internal::Parameter::FAST_FORWARD>(np, false);
  const auto is_constrained = internal::edge_constraints_of(np);
  auto observer = internal::observer_of(np);
  const std::uint64_t budget = internal::maximum_number_of(np);

  Untwisting untwisting;
  const auto triangulation = [&] {
    Delta_complex complex = gluing.complex;
    if (!is_fast) {
      untwisting.crossings = Crossing_counts(complex);
      if (!gluing.lengths.empty())
        return Triangulation::from_lengths(
          std::move(complex), std::vector<typename Traits::FT>(gluing.lengths.begin(), gluing.lengths.end()), traits);
    }
    std::vector<Rational> squares = gluing.lengths.empty() ? gluing.squared_lengths : squared_lengths(gluing.lengths);
    if (is_fast)
      untwisting = internal::untwist(
        complex, squares, [&](Edge_index e) { return bool(get(is_constrained, e)); },
        [&](std::uint64_t tests, std::uint64_t flips) { return observer.go_further(tests, flips); });
    return Triangulation::from_metric(std::move(complex), metric_from_squared_lengths(std::move(squares)), traits);
  };
  Gluing_triangulation<Traits> result{triangulation(), {}, {}};
  result.untwisting = std::move(untwisting);
  if (!result.untwisting.is_complete)
    throw Cancelled_error("the flips within tubes were cancelled");
  internal::Counting_visitor<decltype(observer)> counting(observer, result.triangulation.connectivity(),
                                                          result.untwisting.crossings);
  result.report = internal::flip_all<Sequential_tag>(internal::Whole_triangulation<Traits>(result.triangulation),
                                                     is_constrained, counting, budget);
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_UNTWIST_H
