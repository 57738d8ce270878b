// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// TS, the triangulated surfaces of GOCAD.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_READ_TS_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_READ_TS_IMPL_H

#include <CGAL/Intrinsic_triangulations/internal/files/File_blocks.h>
#include <CGAL/Intrinsic_triangulations/internal/files/formats.h>
#include <CGAL/Intrinsic_triangulations/internal/files/text_file.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// Vertices have numbers as names, which count within their part of the file.
class Ts_reader
{
public:
  Ts_reader(const std::string& path, Polygon_soup& soup) : path_(path), soup_(soup) {}

  void read(const std::uintmax_t size, const Progress_function& progress)
  {
    File_blocks file(path_, size, 0, progress);
    for (const char *p = nullptr, *last = nullptr; file.take_line(p, last);) {
      ++number_;
      line(p, last);
    }
    end_part();
    if (vertices_ == 0 || triangles_ == 0)
      refuse_file(path_,
                  "there is " + std::string(vertices_ == 0 ? "no vertex" : "no face") + " in the file (" +
                    std::to_string(vertices_) + " vertices and " + std::to_string(triangles_) +
                    " faces; they are behind a line TFACE)",
                  Defect::EMPTY);
    if (!is_ended_)
      refuse_file(path_, "the file has no line END, or not as many as it has parts");
  }

private:
  void line(const char* p, const char* const last)
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
        refuse_file(path_, "line " + std::to_string(number_) + ": a part begins where the one before has no line END");
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
    define(integer(p, last, "vertex", vertices_), static_cast<std::uint32_t>(vertices_));
    std::array<double, 3> point;
    for (std::size_t i = 0; i < 3; ++i) {
      const char* const end = next_word(p, last);
      if (p == end)
        refuse_file(path_, where("vertex", vertices_) + ": there are " + std::to_string(i) + " numbers where 3 are needed",
                    Defect::UNREADABLE, vertices_);
      const char* const begin = p;
      if (!take_real(p, last, point[i]) || p != end)
        point[i] = check_coordinate(path_, std::string(begin, end), where("vertex", vertices_), vertices_);
      p = end;
    }
    soup_.points.push_back(point);
    ++vertices_;
  }

  // Another number for a vertex that is there.
  void atom(const char* p, const char* const last)
  {
    const long long name = integer(p, last, "vertex", vertices_), other = integer(p, last, "vertex", vertices_);
    const auto it = vertex_of_number_.find(other);
    if (it == vertex_of_number_.end())
      refuse_file(path_, where("vertex", vertices_) + ": the part has no vertex " + std::to_string(other) + " before this line",
                  Defect::BAD_INDEX, vertices_);
    define(name, it->second);
  }

  void triangle(const char* p, const char* const last)
  {
    Triangle triangle{{}, number_};
    for (long long& corner : triangle.corners)
      corner = integer(p, last, "face", triangles_);
    if (next_word(p, last) != p)
      refuse_file(path_, where("face", triangles_) + ": there is more in the line than three vertices",
                  Defect::NOT_A_TRIANGLE, triangles_);
    triangles_of_part_.push_back(triangle);
    ++triangles_;
  }

  // Triangles may come before their vertices, but not in another part.
  void end_part()
  {
    std::size_t face = triangles_ - triangles_of_part_.size();
    for (const Triangle& triangle : triangles_of_part_) {
      std::array<std::uint32_t, 3> corners;
      for (std::size_t i = 0; i < 3; ++i) {
        const long long corner = triangle.corners[i];
        const auto it = vertex_of_number_.find(corner);
        if (it == vertex_of_number_.end())
          refuse_file(path_,
                      place(triangle.line, "face", face) + ": the face names vertex " + std::to_string(corner) + ", but its part has no vertex of this number",
                      Defect::BAD_INDEX, face);
        corners[i] = it->second;
      }
      soup_.triangles.push_back(corners);
      ++face;
    }
    triangles_of_part_.clear();
  }

  void define(const long long name, const std::uint32_t vertex)
  {
    if (!vertex_of_number_.emplace(name, vertex).second)
      refuse_file(path_, where("vertex", vertices_) + ": there is a vertex " + std::to_string(name) + " before it in the same part",
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
      refuse_file(path_,
                  where(kind, element) + ": " +
                    (p == end ? "the number of a vertex is missing" : quote(std::string(p, end)) + " is not the number of a vertex"),
                  Defect::UNREADABLE, element);
    p = end;
    return number;
  }

  std::string where(const char* const kind, const std::size_t element) const { return place(number_, kind, element); }

  struct Triangle
  {
    std::array<long long, 3> corners;
    std::size_t line;
  };

  std::string path_;
  Polygon_soup& soup_;
  std::size_t number_ = 0;                                        // of the line, counted from 1
  std::unordered_map<long long, std::uint32_t> vertex_of_number_; // in this part
  std::vector<Triangle> triangles_of_part_;
  std::size_t vertices_ = 0, triangles_ = 0;
  bool is_begun_ = false; // there was a line TFACE
  bool is_ended_ = false; // the part has its line END
};

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
void read_ts(const std::string& path, const std::uintmax_t size, const Progress_function& progress, Polygon_soup& soup)
{
  Ts_reader(path, soup).read(size, progress);
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_READ_TS_IMPL_H
