// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Exact squared lengths of doubles, and gluing files that have them.

#include <CGAL/Intrinsic_triangulations/squared_lengths.h>
#include "../../connectivity/gluing_text.h"
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/system/shown_text.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <istream>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

std::vector<Rational> squared_lengths(const std::vector<double>& lengths)
{
  std::vector<Rational> result;
  result.reserve(lengths.size());
  for (std::size_t e = 0; e < lengths.size(); ++e) {
    if (!(lengths[e] > 0 && lengths[e] <= (std::numeric_limits<double>::max)()))
      throw Invalid_surface_error(Invalid_surface_error::Defect::NOT_FINITE, e, 1,
                                  "the length of edge " + std::to_string(e) + " is not a positive finite number");
    const Rational l(lengths[e]);
    result.push_back(l * l);
  }
  return result;
}

namespace internal {

// Reads both versions of the format.
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

void write_exact_gluing(std::ostream& os, const Delta_complex& complex, const std::vector<Rational>& squared_lengths)
{
  CGAL_precondition(squared_lengths.size() == complex.number_of_edges());
  for (Edge_index e : complex.edges())
    if (squared_lengths[e.idx()] <= 0)
      throw Invalid_surface_error(Invalid_surface_error::Defect::ZERO_LENGTH_EDGE, e.idx(), 1,
                                  "edge " + std::to_string(e.idx()) + " does not have a positive length");
  internal::write_gluing_text(os, complex, 2,
                              [&](std::ostream& text, Edge_index e) { text << squared_lengths[e.idx()].str(); });
}

Exact_gluing read_exact_gluing(std::istream& is)
{
  internal::Exact_gluing_reader reader(is);
  Exact_gluing result;
  result.complex = reader.read();
  result.lengths = std::move(reader.lengths);
  result.squared_lengths = std::move(reader.squared_lengths);
  return result;
}

} // namespace CGAL::Intrinsic_triangulations
