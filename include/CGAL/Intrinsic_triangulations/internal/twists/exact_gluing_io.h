// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Text files of gluings whose squared lengths are rational and no squares of doubles.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TWISTS_EXACT_GLUING_IO_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TWISTS_EXACT_GLUING_IO_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Rational.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/gluing_text.h>
#include <CGAL/Intrinsic_triangulations/internal/system/shown_text.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <istream>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsIO
/// \brief the contents of a gluing file of either version: one of the two vectors is empty.
struct Exact_gluing
{
  Delta_complex complex;                           ///< the triangles
  std::vector<double> lengths;                     ///< the length of each edge, in version 1 of the format
  std::vector<internal::Rational> squared_lengths; ///< its square, in version 2
};

namespace internal {

class Exact_number_fields : public Length_fields
{
public:
  template <class Fail>
  void begin(const std::string& version, const Fail& fail)
  {
    is_squared_ = version == "2";
    if (!is_squared_ && version != "1")
      fail(Defect::UNREADABLE, "asks for version " + shown_text(version) + " of the format; there are 1 and 2");
  }

  template <class Fail>
  void add(const std::string& field, const Fail& fail)
  {
    if (!is_squared_)
      return Length_fields::add(field, fail);
    // GMP would read 010 in octal, and ask for any amount of memory.
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

  std::vector<Rational> squared_lengths;

private:
  using Defect = Invalid_surface_error::Defect;
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
  internal::Exact_number_fields numbers;
  Exact_gluing result;
  result.complex = internal::Gluing_reader<internal::Exact_number_fields>(is).read(numbers);
  result.lengths = std::move(numbers.lengths);
  result.squared_lengths = std::move(numbers.squared_lengths);
  return result;
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TWISTS_EXACT_GLUING_IO_H
