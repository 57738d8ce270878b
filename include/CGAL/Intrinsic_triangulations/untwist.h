// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Gluings whose edges wind around thin parts any number of times, and their Delaunay triangulation.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_UNTWIST_H
#define CGAL_INTRINSIC_TRIANGULATIONS_UNTWIST_H

#include <CGAL/Intrinsic_triangulations/internal/twists/Crossing_counts.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/internal/flips/default_traits.h>
#include <CGAL/Intrinsic_triangulations/internal/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/observer.h>
#include <CGAL/Intrinsic_triangulations/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Rational.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/gluing_text.h>
#include <CGAL/Intrinsic_triangulations/internal/system/shown_text.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <istream>
#include <limits>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

Untwisting untwist(Delta_complex& complex, std::vector<Rational>& squared_lengths,
                   const std::function<bool(Edge_index)>& is_constrained,
                   const std::function<bool(std::uint64_t, std::uint64_t)>& go_further);

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsTwists
/// \brief returns the exact squares of lengths that are doubles, for `untwist()`. O(size).
/// \param lengths the length of each edge
/// \exception Invalid_surface_error if a length is not positive and finite
std::vector<Rational> squared_lengths(const std::vector<double>& lengths);

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

/// \ingroup PkgIntrinsicTriangulationsIO
/// \brief the contents of a gluing file of either version: one of the two vectors is empty.
struct Exact_gluing
{
  Delta_complex complex;                           ///< the triangles
  std::vector<double> lengths;                     ///< the length of each edge, in version 1 of the format
  std::vector<internal::Rational> squared_lengths; ///< its square, in version 2
};

namespace internal {

// Of both versions of the format.
class Exact_gluing_reader : public Gluing_reader
{
public:
  using Gluing_reader::Gluing_reader;

  std::vector<Rational> squared_lengths; // instead of lengths in version 2

private:
  void take_version(const std::string& version) override
  {
    is_squared_ = version == "2";
    if (!is_squared_ && version != "1")
      fail(Defect::UNREADABLE, "asks for version " + shown_text(version) + " of the format; there are 1 and 2");
  }

  void take_number(const std::string& field) override
  {
    if (!is_squared_)
      return Gluing_reader::take_number(field);
    // GMP would read 010 as octal, and allocate any amount of memory.
    if (field.size() > maximum_size)
      fail(Defect::OUT_OF_RANGE, "has a squared length of more than a million digits");
    const std::size_t slash = (std::min)(field.find('/'), field.size());
    const std::string above = field.substr(0, slash), below = slash == field.size() ? "1" : field.substr(slash + 1);
    Integer n, d;
    if (!parse(above, n) || !parse(below, d) || d == 0)
      fail(Defect::UNREADABLE,
           "has '" + shown_text(field) + "' where a squared length is expected, an integer or a fraction of two");
    if (n == 0)
      fail(Defect::ZERO_LENGTH_EDGE, "has the squared length " + shown_text(field) + ", which is not positive");
    squared_lengths.push_back(Rational(n, d));
  }

  static constexpr std::size_t maximum_size = 1000000;

  static bool parse(const std::string& digits, Integer& n)
  {
    return !digits.empty() && std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; }) &&
           mpz_set_str(n.backend().data(), digits.c_str(), 10) == 0;
  }

  bool is_squared_ = false;
};

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsIO
/// \brief writes a complex and the exact squared lengths of its edges, in version 2 of the gluing format.
///
/// It differs from version 1, which `write_gluing()` describes, in two things: the first line is `INTRINSIC_GLUING 2`,
/// and the last field in the line of an edge is the *square* of its length, as an integer or a fraction of two without
/// a sign, such as `5` or `25/4`.
///
/// \param os the stream; the caller has to check its state afterwards
/// \param complex any complex
/// \param squared_lengths the squared length of each edge
/// \exception Invalid_surface_error if a squared length is not positive, or there are
///   more than a million isolated vertices. Then nothing is written. O(size).
/// \pre `squared_lengths.size() == complex.number_of_edges()`
inline void write_exact_gluing(std::ostream& os, const Delta_complex& complex,
                               const std::vector<internal::Rational>& squared_lengths)
{
  CGAL_precondition(squared_lengths.size() == complex.number_of_edges());
  for (Edge_index e : complex.edges())
    if (squared_lengths[e.idx()] <= 0)
      throw Invalid_surface_error(Invalid_surface_error::Defect::ZERO_LENGTH_EDGE, e.idx(), 1,
                                  "edge " + std::to_string(e.idx()) + " does not have a positive length");
  internal::write_gluing_text(os, complex, 2,
                              [&](std::ostream& text, Edge_index e) { text << squared_lengths[e.idx()].str(); });
}

/// \ingroup PkgIntrinsicTriangulationsIO
/// \brief reads a gluing of either version.
///
/// \exception Invalid_surface_error as `read_gluing()`; also if a squared length has more than a million digits.
///   O(size)
inline Exact_gluing read_exact_gluing(std::istream& is)
{
  internal::Exact_gluing_reader reader(is);
  Exact_gluing result;
  result.complex = reader.read();
  result.lengths = std::move(reader.lengths);
  result.squared_lengths = std::move(reader.squared_lengths);
  return result;
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
