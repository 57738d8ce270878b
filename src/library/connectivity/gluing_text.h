// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The text format of gluings, for any type of number on the edges.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONNECTIVITY_GLUING_TEXT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONNECTIVITY_GLUING_TEXT_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/system/shown_text.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/Delta_complex_builder.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <ios>
#include <istream>
#include <limits>
#include <locale>
#include <ostream>
#include <sstream>
#include <streambuf>
#include <string>
#include <system_error>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// A file of a few bytes must not ask for gigabytes: no more than this many vertices without a corner are accepted,
// beyond three for each face.
constexpr std::size_t maximum_number_of_isolated_vertices = 1 << 20;

inline bool is_positive_and_finite(double x) { return x > 0 && x <= (std::numeric_limits<double>::max)(); }

// The lines of a text that are not empty once comments are removed, and their contents in version 1 of the format.
class Gluing_reader
{
public:
  explicit Gluing_reader(std::istream& is) : is_(is) { parser_.imbue(std::locale::classic()); }
  virtual ~Gluing_reader() = default;

  Delta_complex read()
  {
    read_header();
    read_faces();
    read_edges();
    check_end();
    return Delta_complex_builder::from_numbered_sides(number_of_vertices_, corner_vertex_, halfedge_of_,
                                                      number_of_edges_);
  }

  std::vector<double> lengths; // of the edges

protected:
  using Defect = Invalid_surface_error::Defect;

  virtual void take_version(const std::string& version)
  {
    if (version == "2")
      fail(Defect::UNREADABLE,
           "asks for version 2 of the format, with exact squared lengths, which read_exact_gluing() reads");
    if (version != "1")
      fail(Defect::UNREADABLE, "asks for version " + shown_text(version) + " of the format; this is version 1");
  }

  // The last field of the line of an edge.
  virtual void take_number(const std::string& field)
  {
    double x = 0;
    parser_.clear();
    parser_.str(field);
    parser_ >> x;
    if (parser_.fail() || parser_.peek() != std::istringstream::traits_type::eof())
      fail(Defect::UNREADABLE, "has '" + shown_text(field) + "' where a length is expected");
    if (!is_positive_and_finite(x))
      fail(Defect::NOT_FINITE, "has the length " + shown_text(field) + ", which is not positive and finite");
    lengths.push_back(x);
  }

  // \param what the rest of a sentence that begins with "line 3 "
  [[noreturn]] void fail(Defect defect, const std::string& what) const
  {
    throw Invalid_surface_error(defect, line_number_, 1, "line " + std::to_string(line_number_) + " " + what);
  }

private:
  static constexpr std::uint32_t null = (std::numeric_limits<std::uint32_t>::max)();

  void read_header()
  {
    next_line("'INTRINSIC_GLUING 1'", 2);
    if (fields_[0] != "INTRINSIC_GLUING")
      fail(Defect::UNREADABLE, "does not begin with INTRINSIC_GLUING");
    take_version(fields_[1]);
    next_line("the numbers of vertices, edges and faces", 3);
    number_of_vertices_ = count(fields_[0]);
    number_of_edges_ = count(fields_[1]);
    number_of_faces_ = count(fields_[2]);
    // Each side belongs to an edge, and an edge has one or two sides.
    if (number_of_edges_ > 3 * number_of_faces_ || 2 * number_of_edges_ < 3 * number_of_faces_)
      fail(Defect::INVALID_GLUING, "has " + counted(number_of_edges_, "edge", "edges") + " for the " +
                                     counted(3 * number_of_faces_, "side", "sides") + " of its faces");
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
          fail(Defect::BAD_INDEX, "names vertex " + shown_text(field) + ", but there " +
                                    are_counted(number_of_vertices_, "vertex", "vertices"));
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
      if (s != null && t != null && (corner_vertex_[s] != side_target(t) || corner_vertex_[t] != side_target(s)))
        fail(Defect::INVALID_GLUING, "glues sides that do not join the same vertices");
      take_number(fields_[2]);
    }
    const auto it = std::find(halfedge_of_.begin(), halfedge_of_.end(), null);
    if (it != halfedge_of_.end())
      throw Invalid_surface_error(Defect::INVALID_GLUING, line_number_, 1,
                                  "no edge up to line " + std::to_string(line_number_) + " has side " +
                                    std::to_string(it - halfedge_of_.begin()));
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
    while (get_line(line)) {
      if (++line_number_ == 1 && line.compare(0, 3, "\xef\xbb\xbf") == 0)
        line.erase(0, 3);
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

  // Takes the text before LF, CR LF or CR.
  bool get_line(std::string& line)
  {
    typedef std::char_traits<char> Traits;
    line.clear();
    if (!is_.good())
      return false;
    std::streambuf& buffer = *is_.rdbuf();
    for (Traits::int_type c; !Traits::eq_int_type(c = buffer.sbumpc(), Traits::eof());) {
      if (c == '\r' && buffer.sgetc() == '\n')
        continue;
      if (c == '\n' || c == '\r')
        return true;
      line += Traits::to_char_type(c);
    }
    is_.setstate(std::ios_base::eofbit);
    return !line.empty();
  }

  void next_line(const std::string& expected, std::size_t number_of_fields)
  {
    if (!read_line())
      throw Invalid_surface_error(Defect::UNREADABLE, line_number_, 1,
                                  "the text ends after line " + std::to_string(line_number_) + ", where " + expected +
                                    " should follow");
    if (fields_.size() != number_of_fields)
      fail(Defect::UNREADABLE, "has " + counted(fields_.size(), "field", "fields") + " instead of " +
                                 std::to_string(number_of_fields) + ": " + expected);
  }

  std::int64_t integer(const std::string& field) const
  {
    std::int64_t n = 0;
    const char* const end = field.data() + field.size();
    const auto result = std::from_chars(field.data(), end, n);
    if (result.ptr != end || result.ec != std::errc())
      fail(Defect::UNREADABLE, "has '" + shown_text(field) + "' where an integer is expected");
    return n;
  }

  std::size_t count(const std::string& field) const
  {
    const std::int64_t n = integer(field);
    if (n < 0)
      fail(Defect::UNREADABLE, "has the negative number " + shown_text(field) + " for a count");
    if (n >= std::int64_t(null / 2))
      fail(Defect::OUT_OF_RANGE, "has " + shown_text(field) + " elements of a kind: too many for 32-bit indices");
    return std::size_t(n);
  }

  std::uint32_t side(const std::string& field, std::size_t halfedge)
  {
    const std::int64_t s = integer(field);
    if (s == -1)
      return null;
    if (s < 0 || std::size_t(s) >= halfedge_of_.size())
      fail(Defect::INVALID_GLUING,
           "names side " + shown_text(field) + ", but there " + are_counted(halfedge_of_.size(), "side", "sides"));
    if (halfedge_of_[std::size_t(s)] != null)
      fail(Defect::INVALID_GLUING, "names side " + shown_text(field) + ", which already has an edge");
    halfedge_of_[std::size_t(s)] = std::uint32_t(halfedge);
    return std::uint32_t(s);
  }

  std::uint32_t side_target(std::uint32_t s) const { return corner_vertex_[next_side(s)]; }

  std::istream& is_;
  std::istringstream parser_; // of lengths
  std::vector<std::string> fields_;
  std::size_t line_number_ = 0;
  std::size_t number_of_vertices_ = 0, number_of_edges_ = 0, number_of_faces_ = 0;
  std::vector<std::uint32_t> corner_vertex_, halfedge_of_;
};

// \param print writes the last field of the line of an edge
template <class Print_number>
void write_gluing_text(std::ostream& os, const Delta_complex& complex, int version, const Print_number& print)
{
  if (complex.number_of_vertices() > 3 * std::size_t(complex.number_of_faces()) + maximum_number_of_isolated_vertices)
    throw Invalid_surface_error(Invalid_surface_error::Defect::OUT_OF_RANGE, 0, 1,
                                "there are too many isolated vertices");
  std::ostringstream text; // its own locale and format
  text.imbue(std::locale::classic());
  text.precision(std::numeric_limits<double>::max_digits10);
  text << "INTRINSIC_GLUING " << version << '\n'
       << complex.number_of_vertices() << ' ' << complex.number_of_edges() << ' ' << complex.number_of_faces() << '\n';
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
    text << side_of[h.idx()] << ' ' << side_of[complex.opposite(h).idx()] << ' ';
    print(text, e);
    text << '\n';
  }
  os << text.str();
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONNECTIVITY_GLUING_TEXT_H
