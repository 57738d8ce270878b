// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/formats/checks.h"

#include "input/formats/Text_check.h"
#include "input/formats/text_file.h"

#include <array>
#include <cstddef>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace idt {
namespace {

// The same triangles with vertices that are numbered from 0 on, in the order of the file. CGAL's reader
// looks at the number of the first vertex alone, and takes any line for a vertex in which there is VRTX.
class Ts_writer : public Line_check
{
public:
  explicit Ts_writer(const std::string& path) : path_(path) {}

  std::string take_text()
  {
    end_part();
    if (vertices_ == 0 || triangles_ == 0)
      refuse(path_,
             "there is " + std::string(vertices_ == 0 ? "no vertex" : "no face") + " in the file (" +
               std::to_string(vertices_) + " vertices and " + std::to_string(triangles_) +
               " faces; they are behind a line TFACE)",
             Defect::EMPTY);
    if (!is_ended_)
      refuse(path_, "the file has no line END, or not as many as it has parts");
    text_ += "END\n";
    return std::move(text_);
  }

private:
  void line(const char* p, const char* const last) override
  {
    const char* const end = next_word(p, last);
    const std::string keyword(p, end);
    // What is before the first triangulated part is of another kind.
    is_begun_ = is_begun_ || keyword == "TFACE";
    if (!is_begun_)
      return;
    if (keyword == "GOCAD") {
      end_part();
      if (!is_ended_)
        refuse(path_, "line " + std::to_string(number()) + ": a part begins where the one before has no line END");
      is_ended_ = false;
      vertex_of_number_.clear();
    } else if (keyword == "END")
      is_ended_ = true;
    else if (keyword == "VRTX" || keyword == "PVRTX")
      vertex(end, last);
    else if (keyword == "ATOM" || keyword == "PATOM")
      atom(end, last);
    else if (keyword == "TRGL")
      triangle(end, last);
  }

  void vertex(const char* p, const char* const last)
  {
    define(integer(p, last, "vertex", vertices_), vertices_);
    text_ += "VRTX " + std::to_string(vertices_);
    for (int i = 0; i < 3; ++i) {
      const char* const end = next_word(p, last);
      if (p == end)
        refuse(path_, where("vertex", vertices_) + ": there are " + std::to_string(i) + " numbers where 3 are needed",
               Defect::UNREADABLE, vertices_);
      if (skip_plain_number(p, end) != end)
        check_coordinate(path_, std::string(p, end), where("vertex", vertices_), vertices_);
      text_ += ' ';
      text_.append(p, end);
      p = end;
    }
    text_ += '\n';
    ++vertices_;
  }

  // Another number for a vertex that is there.
  void atom(const char* p, const char* const last)
  {
    const long long name = integer(p, last, "vertex", vertices_), other = integer(p, last, "vertex", vertices_);
    const auto it = vertex_of_number_.find(other);
    if (it == vertex_of_number_.end())
      refuse(path_, where("vertex", vertices_) + ": the part has no vertex " + std::to_string(other) + " before this line",
             Defect::BAD_INDEX, vertices_);
    define(name, it->second);
  }

  void triangle(const char* p, const char* const last)
  {
    Triangle triangle{{}, number()};
    for (long long& corner : triangle.corners)
      corner = integer(p, last, "face", triangles_);
    if (next_word(p, last) != p)
      refuse(path_, where("face", triangles_) + ": there is more in the line than three vertices",
             Defect::NOT_A_TRIANGLE, triangles_);
    triangles_of_part_.push_back(triangle);
    ++triangles_;
  }

  // Triangles may come before their vertices, but not in another part.
  void end_part()
  {
    std::size_t face = triangles_ - triangles_of_part_.size();
    for (const Triangle& triangle : triangles_of_part_) {
      text_ += "TRGL";
      for (const long long corner : triangle.corners) {
        const auto it = vertex_of_number_.find(corner);
        if (it == vertex_of_number_.end())
          refuse(path_,
                 "line " + std::to_string(triangle.line) + " (face " + std::to_string(face) + "): the face names vertex " +
                   std::to_string(corner) + ", but its part has no vertex of this number",
                 Defect::BAD_INDEX, face);
        text_ += ' ' + std::to_string(it->second);
      }
      text_ += '\n';
      ++face;
    }
    triangles_of_part_.clear();
  }

  void define(const long long name, const std::size_t vertex)
  {
    if (!vertex_of_number_.emplace(name, vertex).second)
      refuse(path_, where("vertex", vertices_) + ": there is a vertex " + std::to_string(name) + " before it in the same part",
             Defect::UNREADABLE, vertices_);
  }

  // Goes to the next word, up to a comment, and returns its end.
  static const char* next_word(const char*& p, const char* const last)
  {
    p = skip_white(p, last);
    return p != last && *p == '#' ? p : skip_word(p, last);
  }

  long long integer(const char*& p, const char* const last, const char* const kind, const std::size_t element) const
  {
    const char* const end = next_word(p, last);
    long long number = 0;
    if (!read_integer(std::string(p, end), number))
      refuse(path_,
             where(kind, element) + ": " +
               (p == end ? "the number of a vertex is missing" : quote(std::string(p, end)) + " is not the number of a vertex"),
             Defect::UNREADABLE, element);
    p = end;
    return number;
  }

  std::string where(const char* const kind, const std::size_t element) const
  {
    return "line " + std::to_string(number()) + " (" + kind + " " + std::to_string(element) + ")";
  }

  struct Triangle
  {
    std::array<long long, 3> corners;
    std::size_t line;
  };

  std::string path_;
  std::string text_ = "GOCAD TSurf 1\nTFACE\n";
  std::unordered_map<long long, std::size_t> vertex_of_number_; // in this part
  std::vector<Triangle> triangles_of_part_;
  std::size_t vertices_ = 0, triangles_ = 0;
  bool is_begun_ = false; // there was a line TFACE
  bool is_ended_ = false; // the part has its line END
};

} // namespace

Prepared_text check_ts(const std::string& path)
{
  Ts_writer writer(path);
  {
    const std::string text = load(path);
    writer.take(text.data(), text.data() + text.size());
  }
  writer.finish();
  return {nullptr, writer.take_text()};
}

} // namespace idt
