// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// OBJ: lines that begin with a word that tells what they are; vertices and faces are read, the others skipped.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_READ_OBJ_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_READ_OBJ_IMPL_H

#include <CGAL/Intrinsic_triangulations/internal/files/Text_lines.h>
#include <CGAL/Intrinsic_triangulations/internal/files/formats.h>
#include <CGAL/Intrinsic_triangulations/internal/files/reserve.h>
#include <CGAL/Intrinsic_triangulations/internal/files/text_file.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// Whether a line may begin with a word that is neither `v` nor `f`: what is there is valid, and is no vertex and no face.
inline bool is_other_obj_keyword(const std::string_view word)
{
  static constexpr std::string_view keywords[] = {
    "vt", "vn", "vp", "l", "p", "o", "g", "s", "mg", "usemtl", "mtllib", "usemap", "maplib",
    // how it is shown
    "bevel", "c_interp", "d_interp", "lod", "shadow_obj", "trace_obj", "ctech", "stech",
    // curves and surfaces
    "cstype", "deg", "bmat", "step", "curv", "curv2", "surf", "parm", "trim", "hole", "scrv", "sp", "end", "con",
    "surf_1", "q0_1", "q1_1", "curv2d_1", "surf_2", "q0_2", "q1_2", "curv2d_2",
    // those that were superseded
    "bsp", "bzp", "cdc", "cdp", "res"};
  return std::any_of(std::begin(keywords), std::end(keywords), [word](std::string_view keyword) { return is_keyword(word, keyword); });
}

class Obj_reader
{
public:
  Obj_reader(const std::string& path, Polygon_soup& soup) : path_(path), soup_(soup) {}

  void read(const std::uintmax_t size, const Progress_function& progress)
  {
    Text_lines lines(path_, size, progress);
    reserve(soup_, size / 64, size / 32); // a guess: the usual file has fewer
    while (lines.next_line()) {
      number_ = lines.number();
      if (const char* const end = end_before_backslash(lines.p, lines.last); end == lines.last)
        take_line(lines.p, end);
      else
        take_continued_line(std::string(lines.p, end), lines);
    }
    const std::size_t vertices = soup_.points.size();
    // Faces may come before their vertices: whether all are there is known at the end.
    if (limit_ == no_limit && greatest_index_ > vertices) {
      Polygon_soup ignored;
      Obj_reader second(path_, ignored);
      second.limit_ = vertices;
      second.read(size, progress);
    }
    if (limit_ != no_limit && bad_faces_ > 0) {
      if (bad_faces_ > 1)
        first_bad_index_ += ", and " + std::to_string(bad_faces_ - 1) +
                            (bad_faces_ == 2 ? " more face like it" : " more faces like it");
      refuse_file(path_, first_bad_index_, Defect::BAD_INDEX, first_bad_face_, bad_faces_);
    }
    if (vertices == 0 || soup_.number_of_faces() == 0)
      refuse_file(path_,
                  "there is " + std::string(vertices == 0 ? "no vertex" : "no face") + " in the file (" + so_far() + ")",
                  Defect::EMPTY);
  }

private:
  static constexpr std::size_t no_limit = (std::numeric_limits<std::size_t>::max)();

  // Before the backslash at the end of a line, or where the line ends if there is none.
  static const char* end_before_backslash(const char* const first, const char* const last)
  {
    const char* end = last;
    while (end != first && is_white(end[-1]))
      --end;
    return end != first && end[-1] == '\\' ? end - 1 : last;
  }

  // A line that goes on is one with the next, also if it is a comment. But a path may end with a backslash, too: vertices and
  // faces do not disappear behind one.
  void take_continued_line(std::string text, Text_lines& lines)
  {
    for (bool goes_on = true; goes_on;) {
      if (!lines.next_line()) {
        if (is_vertex_or_face(text.data(), text.data() + text.size()))
          refuse_file(path_, "line " + std::to_string(lines.number()) + ": the file ends behind the backslash with which the line goes on");
        break;
      }
      if (is_vertex_or_face(lines.p, lines.last))
        refuse_file(path_, "line " + std::to_string(lines.number()) + ": " + quote(lines.rest()) +
                             " belongs to the line before, which ends with a backslash: put a blank line between them, or write them in one");
      const char* const end = end_before_backslash(lines.p, lines.last);
      goes_on = end != lines.last;
      text.append(1, ' ').append(lines.p, end);
    }
    take_line(text.data(), text.data() + text.size());
  }

  static bool is_vertex_or_face(const char* p, const char* const last)
  {
    p = skip_white(p, last);
    return last - p > 1 && is_white(p[1]) && (*p == 'v' || *p == 'V' || *p == 'f' || *p == 'F');
  }

  void take_line(const char* const first, const char* const last)
  {
    const char* p = skip_white(first, last);
    if (p == last || *p == '#')
      return;
    const char* const end = skip_word(p, last);
    if (end - p == 1 && (*p == 'v' || *p == 'V'))
      take_vertex(end, last);
    else if (end - p == 1 && (*p == 'f' || *p == 'F'))
      take_face(end, last);
    else
      take_other(std::string_view(p, static_cast<std::size_t>(end - p)), first, last);
  }

  void take_other(const std::string_view keyword, const char* const first, const char* const last)
  {
    const auto is = [keyword](const std::string_view word) { return is_keyword(keyword, word); };
    if (is("call") || is("csh"))
      refuse_line(first, last, "runs another file or program, which is not done: put what comes from there in its place");
    if (!is_other_obj_keyword(keyword))
      refuse_line(first, last, "is not understood (after " + so_far() + ")");
    if (has_curved_surfaces_ || !(is("surf") || is("bsp") || is("bzp") || is("cdp")))
      return;
    has_curved_surfaces_ = true;
    soup_.warnings.push_back("line " + std::to_string(number_) + ": this and all other curved surfaces are left out, as they are no polygons");
  }

  // Three coordinates, and perhaps a weight and a color.
  void take_vertex(const char* p, const char* const last)
  {
    std::array<double, 3> point;
    for (std::size_t i = 0; i < 3; ++i) {
      p = skip_white(p, last);
      if (take_real(p, last, point[i]))
        continue;
      if (p == last || *p == '#')
        refuse_file(path_, where("vertex", soup_.points.size()) + ": there " + are_counted(i, "number", "numbers") + " where 3 are needed",
                    Defect::UNREADABLE, soup_.points.size());
      const char* const end = std::find(p, skip_word(p, last), '#');
      point[i] = check_coordinate(path_, std::string(p, end), where("vertex", soup_.points.size()), soup_.points.size());
      p = end;
    }
    p = skip_white(p, last);
    for (std::size_t others = 0; p != last && *p != '#'; p = skip_white(p, last)) {
      const char* const end = std::find(p, skip_word(p, last), '#');
      if (const std::string word(p, end); ++others > 5 || !is_number(word))
        refuse_file(path_, where("vertex", soup_.points.size()) + ": " + quote(word) + " is behind the coordinates, where only a weight and a color may be",
                    Defect::UNREADABLE, soup_.points.size());
      p = end;
    }
    soup_.points.push_back(point);
  }

  void take_face(const char* p, const char* const last)
  {
    corners_.clear();
    is_bad_ = false;
    for (p = skip_white(p, last); p != last && *p != '#'; p = skip_white(p, last)) {
      std::uint32_t index = 0;
      const char* q = p;
      if (take_count(q, last, index) && (q == last || is_white(*q)) && index > 0)
        add_corner(index);
      else {
        q = skip_word(p, last);
        take_corner(p, q);
      }
      p = q;
    }
    soup_.add_face(corners_.data(), corners_.data() + corners_.size());
  }

  // A corner with a sign, or with texture and normal behind slashes.
  void take_corner(const char* const p, const char* const end)
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
    if (q == nullptr)
      refuse_corner(std::string(p, end));
    if (index == 0)
      refuse_file(path_, where("face", face) + ": " + quote(std::string(p, end)) + " names vertex 0, but vertices are counted from 1",
                  Defect::BAD_INDEX, face);
    if (index > 0)
      return add_corner(static_cast<std::uint32_t>(index));
    if (static_cast<std::size_t>(-index) > vertices)
      refuse_file(path_,
                  where("face", face) + ": the face names vertex " + std::to_string(index) + ", and there " +
                    are_counted(vertices, "vertex", "vertices") + " before it",
                  Defect::BAD_INDEX, face);
    corners_.push_back(static_cast<std::uint32_t>(vertices - static_cast<std::size_t>(-index)));
  }

  // \param index counted from 1
  void add_corner(const std::uint32_t index)
  {
    corners_.push_back(index - 1);
    if (index > greatest_index_)
      see_greatest_index(index);
  }
  void see_greatest_index(const std::uint32_t index)
  {
    if (limit_ == no_limit)
      greatest_index_ = index;
    else if (index > limit_ && !is_bad_) {
      is_bad_ = true;
      if (bad_faces_++ == 0) {
        first_bad_face_ = soup_.number_of_faces();
        first_bad_index_ = where("face", first_bad_face_) + ": the face names vertex " + std::to_string(index) +
                           ", but there " + are_counted(limit_, "vertex", "vertices") + " (counted from 1)";
      }
    }
  }

  // Behind an index, null if there is none.
  static const char* read_index(const char* p, const char* const end, long long& index)
  {
    if (p != end && *p == '+' && p + 1 != end && p[1] != '-')
      ++p;
    const std::from_chars_result result = std::from_chars(p, end, index);
    return result.ec == std::errc() && index <= (std::numeric_limits<int>::max)() &&
               index >= -(std::numeric_limits<int>::max)()
             ? result.ptr
             : nullptr;
  }

  [[noreturn]] void refuse_corner(const std::string& word) const
  {
    const std::size_t face = soup_.number_of_faces();
    const std::string begin = where("face", face) + ": " + quote(word);
    long long index = 0;
    const std::string corner = word.substr(0, word.find('/'));
    const std::size_t sign = !corner.empty() && (corner[0] == '+' || corner[0] == '-') ? 1 : 0;
    if (corner.size() > sign && corner.find_first_not_of("0123456789", sign) == std::string::npos &&
        read_index(corner.data(), corner.data() + corner.size(), index) == nullptr)
      refuse_file(path_, begin + " is beyond all numbers of vertices", Defect::BAD_INDEX, face);
    refuse_file(path_,
                begin + " is not a corner of a face (the number of a vertex, alone or as in 1/2/3; comments begin"
                        " with # behind a blank)",
                Defect::UNREADABLE, face);
  }

  [[noreturn]] void refuse_line(const char* const first, const char* last, const std::string& text) const
  {
    while (last != first && is_white(last[-1]))
      --last;
    std::string line(first, last);
    std::replace(line.begin(), line.end(), '\t', ' ');
    refuse_file(path_, "line " + std::to_string(number_) + ": " + quote(line) + " " + text);
  }

  std::string so_far() const
  {
    return counted(soup_.points.size(), "vertex", "vertices") + " and " + counted(soup_.number_of_faces(), "face", "faces");
  }

  std::string where(const char* const kind, const std::size_t element) const { return place(number_, kind, element); }

  std::string path_;
  Polygon_soup& soup_;
  std::size_t number_ = 0; // of the line, counted from 1
  bool has_curved_surfaces_ = false;
  std::vector<std::uint32_t> corners_; // of a face
  std::size_t greatest_index_ = 0;
  std::size_t limit_ = no_limit; // faces with greater indices are counted
  bool is_bad_ = false;          // the face has one
  std::size_t bad_faces_ = 0, first_bad_face_ = 0;
  std::string first_bad_index_;
};

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
void read_obj(const std::string& path, const std::uintmax_t size, const Progress_function& progress, Polygon_soup& soup)
{
  Obj_reader(path, soup).read(size, progress);
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_READ_OBJ_IMPL_H
