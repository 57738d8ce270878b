// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// OFF: a header, then vertices and faces.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_READ_OFF_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_READ_OFF_H

#include "Text_lines.h"
#include <CGAL/Intrinsic_triangulations/polygon_soup.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// A vertex is a line. A face may continue over several lines if nothing follows it on the last one. Up to four numbers
// after an element are its color.
class Off_reader : Text_reader
{
public:
  Off_reader(const std::string& path, const std::uintmax_t size, const Progress_function& progress, Polygon_soup& soup)
    : Text_reader(path, soup, size, progress), size_(size)
  {}

  void read()
  {
    read_header();
    reserve(soup_, vertices_, (std::min<std::uintmax_t>)(faces_, size_ / 8 + 1));
    for (std::size_t v = 0; v < vertices_; ++v)
      take_vertex(v);
    for (std::size_t f = 0; f < faces_; ++f)
      if (!lines_.find_word() || !take_usual_triangle())
        take_face(f);
    if (bad_faces_ > 0)
      refuse_bad_index();
    if (lines_.find_word())
      refuse("face", faces_,
             ": " + quote(lines_.rest()) + " is behind the last face; " + announced() +
               ": correct these numbers, or remove what is left over" + hint());
  }

private:
  // [ST][C][N][4][n]OFF, where some programs write the first three in another order, and the numbers of vertices, faces
  // and edges, the first of which may be in the same word.
  void read_header()
  {
    if (!lines_.find_word())
      refuse("there is nothing but white space and comments in the file");
    const std::string first(lines_.take_word());
    std::string_view keyword = first;
    const auto take = [&keyword](const std::string_view prefix) {
      const bool is_there = is_keyword(keyword.substr(0, prefix.size()), prefix);
      keyword.remove_prefix(is_there ? prefix.size() : 0);
      return is_there;
    };
    bool has_textures = false, has_normals = false;
    for (;;)
      if (take("st"))
        has_textures = true;
      else if (take("c"))
        has_colors_ = true;
      else if (keyword.substr(0, 4) != "nOFF" && take("n"))
        has_normals = true;
      else
        break;
    is_homogeneous_ = take("4");
    const bool has_dimension = keyword.substr(0, 4) == "nOFF" && take("n");
    if (!take("off") || !(keyword.empty() || is_digit(keyword[0])))
      refuse(line() + ": the file begins with " + quote(first) + " where OFF is expected");
    numbers_per_vertex_ =
      3 + is_homogeneous_ + has_normals * (3 + is_homogeneous_) + has_textures * (2 + is_homogeneous_);
    std::string word(keyword);
    if (has_dimension) {
      take_count_word(word, "coordinates");
      if (word != "3")
        refuse(line() + ": points of " + quote(word) + " coordinates are not read, only of 3");
      word.clear();
    }
    const std::uintmax_t vertices = take_count_word(word, "vertices");
    const std::uintmax_t faces = take_count_word(word = "", "faces");
    header_line_ = lines_.number();
    take_count_word(word = "", "edges");
    if (lines_.number() > header_line_ && lines_.find_word_on_line())
      refuse("line " + std::to_string(header_line_) + ": the number of edges is missing behind those of " +
             vertices_and_faces(vertices, faces) + ": write 0");
    // A vertex takes at least "0 0 0" and a line end, a face at least "0" and one.
    if (vertices > size_ / 6 + 1 || faces > size_ / 2 + 1)
      refuse("the header announces " + vertices_and_faces(vertices, faces) + ", more than fit into the " +
             counted(size_, "byte", "bytes") + " of the file");
    vertices_ = static_cast<std::size_t>(vertices);
    faces_ = static_cast<std::size_t>(faces);
  }

  // \param word empty if it is still to come
  std::uintmax_t take_count_word(std::string& word, const std::string& name)
  {
    if (word.empty() && !lines_.find_word())
      refuse("the file ends before the number of " + name);
    if (word.empty())
      word = lines_.take_word();
    if (is_keyword(word, "binary"))
      refuse("binary OFF is not read: write the file as text, or as PLY");
    long long number = 0;
    if (!read_integer(word, number) || number < 0)
      refuse(line() + ": " + quote(word) + " is not a number of " + name +
             " (the header is OFF, then the numbers of vertices, faces and edges; 0 stands for any number of edges)");
    return static_cast<std::uintmax_t>(number);
  }

  void take_vertex(const std::size_t v)
  {
    if (!lines_.find_word())
      refuse("the file ends after " + std::to_string(v) + " of " + counted(vertices_, "vertex", "vertices"),
             Defect::UNREADABLE, v);
    std::array<double, 3> point;
    for (std::size_t i = 0; i < numbers_per_vertex_; ++i) {
      if (i >= 3 + std::size_t(is_homogeneous_)) { // a normal or a texture
        skip_number(v, i, numbers_per_vertex_);
        continue;
      }
      const double number = take_coordinate(v, i, numbers_per_vertex_);
      if (i < 3)
        point[i] = number;
      else {
        if (number == 0)
          refuse("vertex", v, ": the fourth coordinate is zero", Defect::NOT_FINITE);
        for (double& coordinate : point) {
          coordinate /= number;
          if (!std::isfinite(coordinate))
            refuse("vertex", v, ": divided by the fourth coordinate, another is too large for a double",
                   Defect::OUT_OF_RANGE);
        }
      }
    }
    soup_.points.push_back(point);
    const std::size_t colors = take_colors("vertex", v);
    if (v == 0)
      colors_ = colors;
    else if (colors != colors_ && !(has_colors_ && (colors == 0 || colors > 2))) // some may have none, RGB or RGBA
      refuse("vertex", v,
             ": there " + are_counted(numbers_per_vertex_ + colors, "number", "numbers") +
               " where the vertices before have " + std::to_string(numbers_per_vertex_ + colors_) + "; " + announced());
  }

  // The number of numbers on the rest of the line.
  std::size_t take_colors(const char* const kind, const std::size_t element)
  {
    return take_others(
      kind, element, 4, [&] { return std::string("numbers of the ") + kind + ", where only a color may be" + hint(); },
      is_number);
  }

  void take_face(const std::size_t f)
  {
    if (!lines_.find_word())
      refuse_face(f, "the file ends after " + std::to_string(f) + " of " + counted(faces_, "face", "faces") + hint());
    const std::size_t line = lines_.number();
    const auto where = [&] { return place(line, "face", f); };
    std::uint32_t size = 0;
    if (std::string word; !take_index(size, word)) {
      long long number = 0;
      const Integer_state state = integer_state(word, number);
      if (state == Integer_state::TOO_LARGE ||
          (state == Integer_state::GOOD && number > (std::numeric_limits<std::uint32_t>::max)()))
        refuse_face(f, where() + ": no face has " + quote(word) + " corners");
      if (state != Integer_state::GOOD || number < 0)
        refuse_face(f,
                    where() + ": " + quote(word) + " is not a number of corners" + (f == 0 ? "; " + announced() : ""));
      size = static_cast<std::uint32_t>(number);
    }
    corners_.clear();
    std::size_t on_first_line = 0;
    std::string bad_word;
    const auto refuse_size = [&] {
      refuse_face(f, where() + ": there " + are_counted(on_first_line, "vertex", "vertices") + " where " +
                       std::to_string(size) + " are announced");
    };
    for (std::uint32_t i = 0, index = 0; i < size; ++i) {
      if (!lines_.find_word_on_line()) {
        if (lines_.number() == line)
          on_first_line = i;
        if (!lines_.find_word())
          refuse_size();
      }
      if (std::string word; !take_index(index, word)) {
        long long number = 0;
        const Integer_state state = integer_state(word, number);
        if (state == Integer_state::NOT_AN_INTEGER)
          refuse_face(f, where() + ": " + quote(word) + " is not the index of a vertex");
        index =
          number < 0 || number >= none || state == Integer_state::TOO_LARGE ? none : static_cast<std::uint32_t>(number);
        if (index >= vertices_ && bad_word.empty())
          bad_word = word.size() > 30 ? quote(word) : word;
      } else if (index >= vertices_ && bad_word.empty())
        bad_word = std::to_string(index);
      corners_.push_back(index);
    }
    if (lines_.number() > line) {
      if (lines_.find_word_on_line())
        refuse_size();
      if (first_long_face_.empty())
        first_long_face_ = where() + ", whose " + std::to_string(size) + " corners go on over " +
                           std::to_string(lines_.number() - line + 1) + " lines";
    } else if (const std::size_t colors = take_colors("face", f); size < 3 && first_small_face_.empty())
      first_small_face_ = where() + ", which has " + counted(size, "corner", "corners") + " and " +
                          counted(colors, "number", "numbers") + " behind them";
    if (!bad_word.empty() && bad_faces_++ == 0) {
      first_bad_face_ = f;
      first_bad_index_ = where() + ": the face names vertex " + bad_word + ", but there " +
                         are_counted(vertices_, "vertex", "vertices") + " (counted from 0)";
    }
    soup_.add_face(corners_.data(), corners_.data() + corners_.size());
  }

  // Reads a triangle alone on its line, as nearly all faces are; does not move at any other face.
  bool take_usual_triangle()
  {
    const char* p = lines_.p;
    std::array<std::uint32_t, 4> numbers;
    for (std::uint32_t& number : numbers) {
      if (!take_count(p, lines_.last, number))
        return false;
      p = skip_white(p, lines_.last);
    }
    if (numbers[0] != 3 || (std::max)({numbers[1], numbers[2], numbers[3]}) >= vertices_ || p != lines_.last)
      return false;
    lines_.p = p;
    soup_.add_face(&numbers[1], &numbers[1] + 3);
    return true;
  }

  // Reads most numbers, or returns the word for a closer look.
  bool take_index(std::uint32_t& number, std::string& word)
  {
    const bool is_usual = take_count(lines_.p, lines_.last, number);
    if (!is_usual)
      word = lines_.take_word();
    return is_usual;
  }

  // If a file has wrong indices, the message is about them.
  [[noreturn]] void refuse_face(const std::size_t face, const std::string& text) const
  {
    if (bad_faces_ > 0)
      refuse_bad_index();
    refuse(text, Defect::UNREADABLE, face);
  }

  [[noreturn]] void refuse_bad_index() const
  {
    std::string text = first_bad_index_ + and_more_faces(bad_faces_);
    std::uint32_t least = none, greatest = 0;
    for (std::size_t f = 0; f < soup_.number_of_faces(); ++f)
      for (const std::uint32_t v : soup_.polygon(f)) {
        least = (std::min)(least, v);
        greatest = (std::max)(greatest, v);
      }
    if (least == 1 && greatest == vertices_)
      text += ". No face names vertex 0: the indices seem to count from 1, subtract 1 from each";
    refuse(text, Defect::BAD_INDEX, first_bad_face_, bad_faces_);
  }

  std::string announced() const
  {
    return "the header announces " + vertices_and_faces(vertices_, faces_) + " on line " + std::to_string(header_line_);
  }
  // Where the mistake may be if element counts are wrong.
  std::string hint() const
  {
    return !first_small_face_.empty()  ? "; look at " + first_small_face_
           : !first_long_face_.empty() ? "; look at " + first_long_face_
                                       : std::string();
  }

  static constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();

  const std::uintmax_t size_;
  bool has_colors_ = false, is_homogeneous_ = false;
  std::size_t numbers_per_vertex_ = 3, vertices_ = 0, faces_ = 0, header_line_ = 0, colors_ = 0;
  std::vector<std::uint32_t> corners_; // of a face
  std::size_t bad_faces_ = 0, first_bad_face_ = 0;
  std::string first_bad_index_, first_small_face_, first_long_face_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_READ_OFF_H
