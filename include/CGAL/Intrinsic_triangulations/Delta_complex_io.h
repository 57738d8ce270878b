// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Text files for what OFF and PLY cannot hold: gluings with loops, several edges between
// the same vertices and faces that meet themselves.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DELTA_COMPLEX_IO_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DELTA_COMPLEX_IO_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/Delta_complex_builder.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <limits>
#include <locale>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsIO
/// \brief the contents of a gluing file.
struct Gluing
{
  Delta_complex complex;       ///< the triangles
  std::vector<double> lengths; ///< the length of each edge, in the order of the edges
};

/// \cond SKIP_IN_MANUAL
namespace internal {

// A file of a few bytes must not ask for gigabytes: this many vertices without a corner
// are believed, each beyond the three that a face can bring.
constexpr std::size_t maximum_number_of_isolated_vertices = 1 << 20;

inline bool is_positive_and_finite(double x)
{
  return x > 0 && x <= (std::numeric_limits<double>::max)();
}

// The lines of a text that are not empty without their comments, and what they contain.
class Gluing_reader
{
public:
  explicit Gluing_reader(std::istream& is) : is_(is) { number_parser_.imbue(std::locale::classic()); }

  Gluing read()
  {
    read_header();
    read_faces();
    read_edges();
    check_end();
    Gluing result;
    result.complex = Delta_complex_builder::from_numbered_sides(
      number_of_vertices_, corner_vertex_, halfedge_of_, lengths_.size());
    result.lengths = std::move(lengths_);
    return result;
  }

private:
  static constexpr std::uint32_t null = (std::numeric_limits<std::uint32_t>::max)();

  void read_header()
  {
    next_line("'INTRINSIC_GLUING 1'", 2);
    if (fields_[0] != "INTRINSIC_GLUING")
      fail(Defect::UNREADABLE, "does not begin with INTRINSIC_GLUING");
    if (fields_[1] != "1")
      fail(Defect::UNREADABLE, "asks for version " + shown(fields_[1]) + " of the format; this is version 1");
    next_line("the numbers of vertices, edges and faces", 3);
    number_of_vertices_ = count(fields_[0]);
    number_of_edges_ = count(fields_[1]);
    number_of_faces_ = count(fields_[2]);
    // Each side is that of an edge, and an edge has one or two.
    if (number_of_edges_ > 3 * number_of_faces_ || 2 * number_of_edges_ < 3 * number_of_faces_)
      fail(Defect::INVALID_GLUING, "has " + std::to_string(number_of_edges_) + " edges for the " +
                                     std::to_string(3 * number_of_faces_) +
                                     " sides of its faces");
    if (number_of_vertices_ > 3 * number_of_faces_ + maximum_number_of_isolated_vertices)
      fail(Defect::OUT_OF_RANGE, "has too many isolated vertices");
  }

  void read_faces()
  {
    for (std::size_t f = 0; f < number_of_faces_; ++f) {
      next_line("the corners of face " + std::to_string(f), 3);
      for (const std::string& field : fields_) {
        const std::int64_t v = integer(field);
        if (v < 0 || std::size_t(v) >= number_of_vertices_)
          fail(Defect::BAD_INDEX, "names vertex " + shown(field) + ", but there are " +
                                    std::to_string(number_of_vertices_) + " vertices");
        corner_vertex_.push_back(std::uint32_t(v));
      }
    }
  }

  void read_edges()
  {
    halfedge_of_.assign(corner_vertex_.size(), null);
    for (std::size_t e = 0; e < number_of_edges_; ++e) {
      next_line("the two sides and the length of edge " + std::to_string(e), 3);
      const std::uint32_t s = side(fields_[0], 2 * e), t = side(fields_[1], 2 * e + 1);
      if (s == null && t == null)
        fail(Defect::INVALID_GLUING, "is an edge without a face");
      if (s != null && t != null &&
          (corner_vertex_[s] != side_target(t) || corner_vertex_[t] != side_target(s)))
        fail(Defect::INVALID_GLUING, "glues sides that do not join the same vertices");
      lengths_.push_back(length(fields_[2]));
    }
    const auto it = std::find(halfedge_of_.begin(), halfedge_of_.end(), null);
    if (it != halfedge_of_.end())
      throw Invalid_surface_error(Defect::INVALID_GLUING, line_number_, 1,
                                  "no edge up to line " + std::to_string(line_number_) +
                                    " has side " + std::to_string(it - halfedge_of_.begin()));
  }

  void check_end()
  {
    if (read_line())
      fail(Defect::UNREADABLE, "follows the last edge; lines with other content are not expected");
  }

  // Reads the next line with content and splits it.
  bool read_line()
  {
    std::string line;
    while (std::getline(is_, line)) {
      ++line_number_;
      const std::size_t comment = line.find('#');
      if (comment != std::string::npos)
        line.resize(comment);
      fields_.clear();
      const char* const blanks = " \t\r\v\f";
      std::size_t end = 0;
      for (std::size_t begin; (begin = line.find_first_not_of(blanks, end)) != std::string::npos;) {
        end = (std::min)(line.find_first_of(blanks, begin), line.size());
        fields_.push_back(line.substr(begin, end - begin));
      }
      if (!fields_.empty())
        return true;
    }
    return false;
  }

  void next_line(const std::string& expected, std::size_t number_of_fields)
  {
    if (!read_line())
      throw Invalid_surface_error(Defect::UNREADABLE, line_number_, 1,
                                  "the text ends after line " + std::to_string(line_number_) +
                                    ", where " + expected + " should follow");
    if (fields_.size() != number_of_fields)
      fail(Defect::UNREADABLE, "has " + std::to_string(fields_.size()) + " fields instead of " +
                                 std::to_string(number_of_fields) + ": " + expected);
  }

  std::int64_t integer(const std::string& field) const
  {
    std::int64_t n = 0;
    const char* const end = field.data() + field.size();
    const auto result = std::from_chars(field.data(), end, n);
    if (result.ptr != end || result.ec != std::errc())
      fail(Defect::UNREADABLE, "has '" + shown(field) + "' where an integer is expected");
    return n;
  }

  std::size_t count(const std::string& field) const
  {
    const std::int64_t n = integer(field);
    if (n < 0)
      fail(Defect::UNREADABLE, "has the negative number " + shown(field) + " for a count");
    if (n >= std::int64_t(null / 2))
      fail(Defect::OUT_OF_RANGE, "has " + shown(field) + " elements of a kind: too many for 32-bit indices");
    return std::size_t(n);
  }

  std::uint32_t side(const std::string& field, std::size_t halfedge)
  {
    const std::int64_t s = integer(field);
    if (s == -1)
      return null;
    if (s < 0 || std::size_t(s) >= halfedge_of_.size())
      fail(Defect::INVALID_GLUING, "names side " + shown(field) + ", but there are " +
                                     std::to_string(halfedge_of_.size()) + " sides");
    if (halfedge_of_[std::size_t(s)] != null)
      fail(Defect::INVALID_GLUING, "names side " + shown(field) + ", which already has an edge");
    halfedge_of_[std::size_t(s)] = std::uint32_t(halfedge);
    return std::uint32_t(s);
  }

  double length(const std::string& field)
  {
    double x = 0;
    number_parser_.clear();
    number_parser_.str(field);
    number_parser_ >> x;
    if (number_parser_.fail() || number_parser_.peek() != std::istringstream::traits_type::eof())
      fail(Defect::UNREADABLE, "has '" + shown(field) + "' where a length is expected");
    if (!is_positive_and_finite(x))
      fail(Defect::NOT_FINITE, "has the length " + shown(field) + ", which is not positive and finite");
    return x;
  }

  std::uint32_t side_target(std::uint32_t s) const
  {
    return corner_vertex_[s % 3 == 2 ? s - 2 : s + 1];
  }

  // A field as it can stand in a message: what is in a file may steer a terminal, or be long.
  static std::string shown(const std::string& field)
  {
    std::string result = field.substr(0, 40);
    std::replace_if(
      result.begin(), result.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return result + (field.size() > 40 ? "..." : "");
  }

  [[noreturn]] void fail(Defect defect, const std::string& what) const
  {
    throw Invalid_surface_error(defect, line_number_, 1,
                                "line " + std::to_string(line_number_) + " " + what);
  }

  std::istream& is_;
  std::istringstream number_parser_;
  std::vector<std::string> fields_;
  std::size_t line_number_ = 0;
  std::size_t number_of_vertices_ = 0, number_of_edges_ = 0, number_of_faces_ = 0;
  std::vector<std::uint32_t> corner_vertex_, halfedge_of_;
  std::vector<double> lengths_;
};

} // namespace internal
/// \endcond

/// \ingroup PkgIntrinsicTriangulationsIO
/// \brief writes a complex and the lengths of its edges in the gluing format.
///
/// The format is text; files have the extension `.gluing`. A `#` starts a comment, and
/// empty lines are ignored.
///
/// \verbatim
/// INTRINSIC_GLUING 1
/// V E F                    the numbers of vertices, edges and faces
/// a b c                    for each face, the vertices of its corners
/// side opposite length     for each edge, the sides of its halfedges 2e and 2e + 1, and its length
/// \endverbatim
///
/// Side `3f + i` runs from corner i of face f to corner i + 1; side `3f` is
/// `halfedge(f)`. A border halfedge has side -1. Lengths are written with 17 significant digits, so
/// they are read back as the same numbers. Reading also restores all descriptors, the direction of
/// each edge and the first halfedge of each face; `halfedge(v)` of an interior vertex may differ.
///
/// \param os the stream; the caller has to check its state afterwards
/// \param complex any complex
/// \param lengths the length of each edge
/// \exception Invalid_surface_error if a length is not positive and finite, or there are
///   more than a million isolated vertices, which `read_gluing()` would take for damage.
///   Then nothing is written. O(size).
/// \pre `lengths.size() == complex.number_of_edges()`
inline void write_gluing(std::ostream& os, const Delta_complex& complex,
                         const std::vector<double>& lengths)
{
  using Defect = Invalid_surface_error::Defect;
  CGAL_precondition(lengths.size() == complex.number_of_edges());
  if (complex.number_of_vertices() > 3 * std::size_t(complex.number_of_faces()) +
                                       internal::maximum_number_of_isolated_vertices)
    throw Invalid_surface_error(Defect::OUT_OF_RANGE, 0, 1, "there are too many isolated vertices");

  std::ostringstream text; // its own locale and format
  text.imbue(std::locale::classic());
  text.precision(std::numeric_limits<double>::max_digits10);
  text << "INTRINSIC_GLUING 1\n"
       << complex.number_of_vertices() << ' ' << complex.number_of_edges() << ' '
       << complex.number_of_faces() << '\n';
  std::vector<std::int64_t> side_of(complex.number_of_halfedges(), -1);
  for (Face_index f : complex.faces()) {
    Halfedge_index h = complex.halfedge(f);
    for (std::int64_t i = 0; i < 3; ++i) {
      side_of[h.idx()] = 3 * std::int64_t(f.idx()) + i;
      text << complex.source(h).idx() << (i < 2 ? ' ' : '\n');
      h = complex.next(h);
    }
  }
  for (Edge_index e : complex.edges()) {
    const Halfedge_index h = complex.halfedge(e);
    const double length = lengths[e.idx()];
    if (!internal::is_positive_and_finite(length))
      throw Invalid_surface_error(Defect::NOT_FINITE, e.idx(), 1,
                                  "the length of edge " + std::to_string(e.idx()) +
                                    " is not a positive finite number");
    text << side_of[h.idx()] << ' ' << side_of[complex.opposite(h).idx()] << ' ' << length << '\n';
  }
  os << text.str();
}

/// \ingroup PkgIntrinsicTriangulationsIO
/// \brief reads a complex and the lengths of its edges in the format of `write_gluing()`.
///
/// The output of `write_gluing()` gives an equal complex and the same lengths.
///
/// \exception Invalid_surface_error if anything is wrong with the text. The message and
///   `element()` name the line; only if faces form more than one fan around a vertex, they
///   name that vertex. The triangle inequality is not checked here, but in
///   `Intrinsic_triangulation::from_lengths()`. O(size).
inline Gluing read_gluing(std::istream& is)
{
  return internal::Gluing_reader(is).read();
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DELTA_COMPLEX_IO_H
