// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// OBJ: lines whose first word tells their kind; vertices and faces are read, the others skipped.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_READ_OBJ_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_READ_OBJ_H

#include "Text_lines.h"
#include <CGAL/Intrinsic_triangulations/polygon_soup.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Whether a line may begin with this word, other than `v` and `f`: it is valid, and neither a vertex nor a face.
inline bool is_other_obj_keyword(const std::string_view word)
{
  return is_one_of(word,
                   {"vt", "vn", "vp", "l", "p", "o", "g", "s", "mg", "usemtl", "mtllib", "usemap", "maplib",
                    // how it is shown
                    "bevel", "c_interp", "d_interp", "lod", "shadow_obj", "trace_obj", "ctech", "stech",
                    // curves and surfaces
                    "cstype", "deg", "bmat", "step", "curv", "curv2", "surf", "parm", "trim", "hole", "scrv", "sp",
                    "end", "con", "surf_1", "q0_1", "q1_1", "curv2d_1", "surf_2", "q0_2", "q1_2", "curv2d_2",
                    // superseded ones
                    "bsp", "bzp", "cdc", "cdp", "res"});
}

class Obj_reader : Text_reader
{
public:
  Obj_reader(const std::string& path, const std::uintmax_t size, const Progress_function& progress, Polygon_soup& soup)
    : Text_reader(path, soup, size, progress)
  {
    reserve(soup_, size / 64, size / 32); // a guess: the usual file has fewer
  }

  void read()
  {
    while (lines_.next_line()) {
      if (const char* const end = end_before_backslash(); end != lines_.last)
        join_lines(end);
      take_line();
    }
    // Faces may come before their vertices: missing ones are found at the end.
    const std::size_t vertices = soup_.points.size();
    for (const Forward_reference& r : forward_references_)
      if (r.index > vertices)
        refuse_bad_index(r);
    if (vertices == 0 || soup_.number_of_faces() == 0)
      refuse_empty(vertices, soup_.number_of_faces());
  }

private:
  // The place where a face names a vertex that has not come yet and is greater than all named before.
  struct Forward_reference
  {
    std::size_t index, face, line; // the index counted from 1
  };

  // The position of the backslash at the end of the line, or the end of the line if there is none.
  const char* end_before_backslash() const
  {
    const char* end = lines_.last;
    while (end != lines_.p && is_white(end[-1]))
      --end;
    return end != lines_.p && end[-1] == '\\' ? end - 1 : lines_.last;
  }

  // A continued line includes the next one, even in a comment. But a path may end with a backslash, too: vertices and
  // faces must not disappear after one.
  void join_lines(const char* end)
  {
    const std::size_t first = lines_.number();
    joined_.assign(lines_.p, end);
    do {
      if (!lines_.next_line()) {
        if (is_vertex_or_face(joined_.data(), joined_.data() + joined_.size()))
          refuse(line() + ": the file ends behind the backslash with which the line goes on");
        break;
      }
      if (is_vertex_or_face(lines_.p, lines_.last))
        refuse(line() + ": " + quote(lines_.rest()) +
               " belongs to the line before, which ends with a backslash: put a blank line between them, or write them "
               "in one");
      end = end_before_backslash();
      joined_.append(1, ' ').append(lines_.p, end);
    } while (end != lines_.last);
    lines_.replace_lines(first, joined_);
  }

  static bool is_vertex_or_face(const char* p, const char* const last)
  {
    p = skip_white(p, last);
    return last - p > 1 && is_white(p[1]) && (*p == 'v' || *p == 'V' || *p == 'f' || *p == 'F');
  }

  void take_line()
  {
    const char* const first = lines_.p;
    if (!lines_.find_word_on_line())
      return;
    const std::string_view keyword(lines_.p, static_cast<std::size_t>(skip_word(lines_.p, lines_.last) - lines_.p));
    lines_.p += keyword.size();
    if (is_keyword(keyword, "v"))
      take_vertex();
    else if (is_keyword(keyword, "f"))
      take_face();
    else {
      lines_.p = first;
      take_other(keyword);
    }
  }

  void take_other(const std::string_view keyword)
  {
    const auto is = [keyword](const std::string_view word) { return is_keyword(keyword, word); };
    if (is("vt") || is("vn")) // nearly all
      return check_others(keyword);
    if (is("call") || is("csh"))
      refuse(line() + ": " + quote(lines_.rest()) +
             " runs another file or program, which is not supported: replace it with the contents");
    if (!is_other_obj_keyword(keyword))
      refuse(line() + ": " + quote(lines_.rest()) + " is not understood (after " +
             vertices_and_faces(soup_.points.size(), soup_.number_of_faces()) +
             "): correct it, or put # before it if it has no part of the surface");
    check_others(keyword);
    if (has_curved_surfaces_ || !(is("surf") || is("bsp") || is("bzp") || is("cdp")))
      return;
    has_curved_surfaces_ = true;
    soup_.warnings.push_back(line() +
                             ": this and all other curved surfaces are left out, because they are not polygons");
  }

  // A vertex or face after something else on its line would be lost, also if a line end is missing before it: s offf 1
  // 2 3.
  void check_others(const std::string_view keyword)
  {
    lines_.p = skip_word(skip_white(lines_.p, lines_.last), lines_.last);
    const auto is_letter = [](const char c) { return (c | 0x20) == 'f' || (c | 0x20) == 'v'; };
    if (std::none_of(lines_.p, lines_.last, is_letter))
      return;
    if (is_keyword(keyword, "parm") || is_keyword(keyword, "bmat"))
      return;
    // A name may have any words. A CR or LF that is not this file's line end shows that they are more.
    const char* const end = std::find_if(lines_.p, lines_.last, [](const char c) { return c == '\r' || c == '\n'; });
    const bool may_be_name =
      is_one_of(keyword, {"g", "o", "usemtl", "mtllib", "usemap", "maplib", "shadow_obj", "trace_obj"}) &&
      skip_white(end, lines_.last) == lines_.last;
    std::string_view element; // v or f
    std::size_t numbers = 0;  // behind it
    while (lines_.find_word_on_line()) {
      const std::string_view word = lines_.take_word(), before = word.substr(0, word.size() - 1),
                             letter = word.substr(before.size());
      if ((is_keyword(letter, "v") || is_keyword(letter, "f")) &&
          (before.empty() || is_digit(before.back()) || is_keyword(before, "off"))) {
        element = letter;
        numbers = 0;
      } else if (!is_number(word.substr(0, word.find('/'))))
        element = {};
      else if (!element.empty() && ++numbers == 3) {
        const std::string text = line() + ": " + quote(element) +
                                 " is within another element: begin each vertex and each face on a line of its own";
        if (!may_be_name)
          refuse(text);
        soup_.warnings.push_back(text + ", if it is no part of a name");
        return;
      }
    }
  }

  // Three coordinates, and perhaps a weight and a color.
  void take_vertex()
  {
    const std::size_t vertex = soup_.points.size();
    soup_.points.push_back(take_point(vertex));
    take_others(
      "vertex", vertex, 5, [] { return "coordinates, where only a weight and a color may be"; }, is_number);
  }

  void take_face()
  {
    corners_.clear();
    while (lines_.find_word_on_line()) {
      const char* const begin = lines_.p;
      std::uint32_t index = 0;
      if (!take_count(lines_.p, lines_.last, index) || index == 0) {
        lines_.p = skip_word(begin, lines_.last);
        index = index_of_corner(begin, lines_.p);
      }
      if (index > greatest_index_)
        see_greatest_index(index);
      corners_.push_back(index - 1);
    }
    soup_.add_face(corners_.data(), corners_.data() + corners_.size());
  }

  // The vertex, counted from 1, at a corner with a sign, or with texture and normal after slashes.
  std::uint32_t index_of_corner(const char* const p, const char* const end) const
  {
    long long index = 0;
    const char* q = read_index(p, end, index);
    for (int slashes = 0; q != nullptr && q != end;) {
      if (*q != '/' || ++slashes > 2)
        q = nullptr;
      else if (++q != end && *q != '/') {
        long long ignored = 0;
        q = read_index(q, end, ignored);
      }
    }
    const std::size_t face = soup_.number_of_faces(), vertices = soup_.points.size();
    const std::string_view word(p, static_cast<std::size_t>(end - p));
    if (q == nullptr)
      refuse_corner(word);
    if (index == 0)
      refuse("face", face, ": " + quote(word) + " names vertex 0, but vertices are counted from 1", Defect::BAD_INDEX);
    if (index > 0)
      return static_cast<std::uint32_t>(index);
    if (static_cast<std::size_t>(-index) > vertices)
      refuse("face", face,
             ": the face names vertex " + std::to_string(index) + ", and there " +
               are_counted(vertices, "vertex", "vertices") + " before it",
             Defect::BAD_INDEX);
    return static_cast<std::uint32_t>(vertices + 1 - static_cast<std::size_t>(-index));
  }

  void see_greatest_index(const std::uint32_t index)
  {
    greatest_index_ = index;
    if (index > soup_.points.size())
      forward_references_.push_back({index, soup_.number_of_faces(), lines_.number()});
  }
  [[noreturn]] void refuse_bad_index(const Forward_reference& first) const
  {
    const std::size_t vertices = soup_.points.size();
    std::size_t count = 0;
    for (const auto& polygon : soup_.polygons())
      count += std::any_of(polygon.begin(), polygon.end(), [vertices](const std::uint32_t v) { return v >= vertices; });
    refuse(place(first.line, "face", first.face) + ": the face names vertex " + std::to_string(first.index) +
             ", but there " + are_counted(vertices, "vertex", "vertices") + " (counted from 1)" + and_more_faces(count),
           Defect::BAD_INDEX, first.face, count);
  }

  // The end of an index, null if there is none.
  static const char* read_index(const char* p, const char* const end, long long& index)
  {
    const std::from_chars_result result =
      std::from_chars(skip_plus({p, static_cast<std::size_t>(end - p)}), end, index);
    return result.ec == std::errc() && index <= (std::numeric_limits<int>::max)() &&
               index >= -(std::numeric_limits<int>::max)()
             ? result.ptr
             : nullptr;
  }

  [[noreturn]] void refuse_corner(const std::string_view word) const
  {
    long long index = 0;
    const std::string_view corner = word.substr(0, word.find('/'));
    const std::size_t sign = !corner.empty() && (corner[0] == '+' || corner[0] == '-') ? 1 : 0;
    if (corner.size() > sign && corner.find_first_not_of("0123456789", sign) == std::string::npos &&
        read_index(corner.data(), corner.data() + corner.size(), index) == nullptr)
      refuse("face", soup_.number_of_faces(), ": " + quote(word) + " is beyond all numbers of vertices",
             Defect::BAD_INDEX);
    refuse("face", soup_.number_of_faces(),
           ": " + quote(word) + " is not a corner of a face (the number of a vertex, alone or as in 1/2/3" +
             (word.find('#') == word.npos ? ")" : "; comments begin with # behind a blank)"));
  }

  bool has_curved_surfaces_ = false;
  std::string joined_;                 // lines that go on
  std::vector<std::uint32_t> corners_; // of a face
  std::size_t greatest_index_ = 0;
  std::vector<Forward_reference> forward_references_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_READ_OBJ_H
