// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// TS, the triangulated surfaces of GOCAD.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_READ_TS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_READ_TS_H

#include "Text_lines.h"
#include <CGAL/Intrinsic_triangulations/polygon_soup.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Parts from a line GOCAD to a line END: a header, which is skipped, then vertices and triangles. Vertex numbers are
// names, valid within their part.
class Ts_reader : Text_reader
{
public:
  Ts_reader(const std::string& path, const std::uintmax_t size, const Progress_function& progress, Polygon_soup& soup)
    : Text_reader(path, soup, size, progress)
  {}

  void read()
  {
    while (lines_.next_line())
      if (lines_.find_word_on_line())
        take_line();
    end_part();
    if (brace_line_ != 0)
      refuse("the brace on line " + std::to_string(brace_line_) + " is not closed");
    const std::size_t vertices = soup_.points.size(), triangles = soup_.triangles.size();
    if (vertices == 0 && !soup_.warnings.empty())
      refuse(soup_.warnings.front() + "; there is no other part", Defect::EMPTY);
    if (vertices == 0 || triangles == 0)
      refuse_empty(vertices, triangles);
    if (!is_ended_)
      refuse("the file has no line END, or not as many as it has parts");
  }

private:
  void take_line()
  {
    const std::string_view word = lines_.take_word();
    const auto is = [word](const std::string_view keyword) { return is_keyword(word, keyword); };
    const bool is_vertex = is("vrtx") || is("pvrtx"), is_atom = is("atom") || is("patom"), is_triangle = is("trgl");
    const bool is_data = is_vertex || is_atom || is_triangle || is("tface");
    if (brace_line_ != 0) {
      if (is_data || is("gocad") || is("end"))
        refuse_line(word, "the brace on line " + std::to_string(brace_line_) + " is not closed before it");
      if (word[0] == '}')
        brace_line_ = 0;
      return check_rest();
    }
    if (is("gocad")) {
      begin_part();
      return check_rest();
    }
    if (is_ended_)
      refuse_line(word, "nothing but a line GOCAD may follow a line END");
    if (is("end")) {
      is_ended_ = true;
      return check_rest();
    }
    if (is_other_ && (is_triangle || is("tface")))
      refuse_line(word, "the part is not a TSurf according to line " + std::to_string(part_line_));
    if (is_other_)
      return check_rest();
    is_begun_ = is_begun_ || is_data;
    if (is_vertex)
      vertex();
    else if (is_atom)
      atom();
    else if (is_triangle)
      triangle();
    else if (is_data)
      check_rest();
    else if (is("trgl_properties") || is("trgl_esizes"))
      count_properties(is("trgl_esizes"));
    else if (const std::string rest = lines_.rest(); word.back() == '{' || (!rest.empty() && rest.back() == '{'))
      brace_line_ = lines_.number();
    else if ((is_begun_ || is_nearly_trgl(word)) && !is("bstone") && !is("border") && !is("control_node"))
      refuse_line(word, "it is not understood (VRTX, PVRTX, ATOM, PATOM, TRGL, TFACE, BSTONE, BORDER or END)");
    else
      check_rest();
  }

  // A triangle after something else would be lost.
  void check_rest()
  {
    int corners = -1; // after the word, if present
    while (lines_.find_word_on_line()) {
      const std::string_view word = lines_.take_word();
      if (is_keyword(word, "trgl"))
        corners = 0;
      else if (corners >= 0 && (corners = is_digit(word[0]) ? corners + 1 : -1) == 3)
        refuse_line("TRGL", "it is not at the beginning of a line: begin each triangle on a line of its own");
    }
  }

  // The header may have any words, but this is a misspelt triangle, which would be lost.
  static bool is_nearly_trgl(const std::string_view word)
  {
    const std::string letters = in_small_letters(std::string(word)), keyword = "trgl";
    return letters.size() <= 5 && std::count_if(keyword.begin(), keyword.end(), [&letters](const char c) {
                                    return letters.find(c) != std::string::npos;
                                  }) >= 3;
  }

  void begin_part()
  {
    end_part();
    part_line_ = lines_.number();
    if (!is_ended_ && (is_begun_ || is_other_))
      refuse(line() + ": a part begins, but the previous one has no line END");
    is_ended_ = is_begun_ = false;
    vertex_of_number_.clear();
    properties_ = 0;
    std::string kind;
    if (lines_.find_word_on_line())
      kind = lines_.take_word();
    is_other_ = !kind.empty() && !is_keyword(kind, "tsurf");
    if (is_other_)
      soup_.warnings.push_back(line() + ": the part of the kind " + quote(kind) +
                               " is not a surface of triangles (TSurf), and is left out");
  }

  void vertex()
  {
    const std::size_t v = soup_.points.size();
    define(integer("vertex", v), static_cast<std::uint32_t>(v));
    soup_.points.push_back(take_point(v));
    take_properties("vertex", v);
  }

  // Numbers, and the word that makes a vertex a control node: CN, with the coordinates that it fixes. How many there
  // are.
  std::size_t take_properties(const char* const kind, const std::size_t element)
  {
    return take_others(
      kind, element, (std::numeric_limits<std::size_t>::max)(),
      [kind] { return std::string("numbers of the ") + kind + ", where only properties may be"; },
      [](const std::string_view word) { return is_number(word) || is_keyword(word.substr(0, 2), "cn"); });
  }

  // Another number for a vertex that is there.
  void atom()
  {
    const std::size_t v = soup_.points.size();
    const long long name = integer("vertex", v), other = integer("vertex", v);
    const auto it = vertex_of_number_.find(other);
    if (it == vertex_of_number_.end())
      refuse("vertex", v, ": the part has no vertex " + std::to_string(other) + " before this line", Defect::BAD_INDEX);
    define(name, it->second);
    take_properties("vertex", v);
  }

  void triangle()
  {
    const std::size_t f = soup_.triangles.size() + triangles_of_part_.size();
    Triangle triangle{{}, lines_.number()};
    for (long long& corner : triangle.corners)
      corner = integer("face", f);
    if (properties_ == 0 ? lines_.find_word_on_line() : take_properties("face", f) != properties_)
      refuse("face", f,
             properties_ == 0 ? ": there is more in the line than three vertices"
                              : ": three vertices are not followed by " +
                                  counted(properties_, "property", "properties") + ", as TRGL_PROPERTIES announces",
             Defect::NOT_A_TRIANGLE);
    triangles_of_part_.push_back(triangle);
  }

  // The properties of triangles are named, and may have sizes.
  void count_properties(const bool are_sizes)
  {
    properties_ = 0;
    for (; lines_.find_word_on_line();) {
      long long size = 1;
      const std::string word(lines_.take_word());
      if (are_sizes && (!read_integer(word, size) || size < 0))
        refuse_line(word, "it is not the size of a property");
      properties_ += static_cast<std::size_t>(size);
    }
  }

  // Triangles may come before their vertices, but not in another part.
  void end_part()
  {
    for (const Triangle& triangle : triangles_of_part_) {
      std::array<std::uint32_t, 3> corners;
      for (std::size_t i = 0; i < 3; ++i) {
        const long long corner = triangle.corners[i];
        const auto it = vertex_of_number_.find(corner);
        if (it == vertex_of_number_.end())
          refuse(place(triangle.line, "face", soup_.triangles.size()) + ": the face names vertex " +
                   std::to_string(corner) + ", but its part has no vertex of this number",
                 Defect::BAD_INDEX, soup_.triangles.size());
        corners[i] = it->second;
      }
      soup_.triangles.push_back(corners);
    }
    triangles_of_part_.clear();
  }

  void define(const long long name, const std::uint32_t vertex)
  {
    if (!vertex_of_number_.emplace(name, vertex).second)
      refuse("vertex", soup_.points.size(),
             ": there is a vertex " + std::to_string(name) + " before it in the same part");
  }

  long long integer(const char* const kind, const std::size_t element)
  {
    const bool is_there = lines_.find_word_on_line();
    const std::string_view word = lines_.take_word();
    long long number = 0;
    if (!read_integer(word, number))
      refuse(kind, element,
             is_there ? ": " + quote(word) + " is not the number of a vertex" : ": the number of a vertex is missing");
    return number;
  }

  [[noreturn]] void refuse_line(const std::string_view word, const std::string& text) const
  {
    refuse(line() + ", " + quote(word) + ": " + text);
  }

  struct Triangle
  {
    std::array<long long, 3> corners;
    std::size_t line;
  };

  std::unordered_map<long long, std::uint32_t> vertex_of_number_; // in this part
  std::vector<Triangle> triangles_of_part_;
  std::size_t properties_ = 0; // of a triangle of this part
  std::size_t brace_line_ = 0; // of a brace that is still open
  std::size_t part_line_ = 0;  // on which the part begins
  bool is_other_ = false;      // the part is not a surface
  bool is_begun_ = false;      // the part has more than its header
  bool is_ended_ = false;      // the part has its line END
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_READ_TS_H
