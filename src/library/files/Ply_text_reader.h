// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Reads the elements of a PLY file of text.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_PLY_TEXT_READER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_PLY_TEXT_READER_H

#include "Ply_header.h"
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

// Words in the order of the elements and their properties. An element is a line, or goes on over several; or everything
// is in one line.
class Ply_text_reader
{
public:
  Ply_text_reader(const std::string& path, const Ply_header& header, Polygon_soup& soup, const std::uintmax_t size,
                  const Progress_function& progress, const char line_end)
    : path_(path), header_(header), soup_(soup),
      lines_(path, size, progress, {header.bytes, line_end}, header.lines - 1, no_comment),
      size_(size - (std::min<std::uintmax_t>)(size, header.bytes))
  {}

  void read()
  {
    std::size_t end = 0; // the line on which the element before ends
    for (const Ply_element& element : header_.elements) {
      element_ = &element;
      reserve_ply(element, size_, soup_);
      const bool is_vertex = element.is_vertex();
      for (index_ = 0; index_ < element.count; ++index_) {
        if (!find_word())
          refuse_end();
        if (begin_ == 0)
          first_ = lines_.number();
        if (lines_.number() == end && surplus_.empty()) {
          is_row_short_ = begin_ != lines_.number();
          surplus_ = line_of_two();
          last_line_ = end;
        }
        if (lines_.number() == end && end != first_)
          refuse_surplus();
        begin_ = lines_.number();
        take_element(is_vertex);
        end = lines_.number();
      }
    }
    if (!find_word())
      return;
    if (!surplus_.empty() && lines_.number() != end)
      refuse_surplus();
    refuse_file(path_, "line " + std::to_string(lines_.number()) + ": " + quote(lines_.take_word()) +
                         " is behind the " + so_far() +
                         " that the header announces: correct these numbers, or remove what is left over");
  }

private:
  // The defect if the line ends within the elements that begin on it: a row of too many or too few numbers.
  std::string line_of_two()
  {
    const bool is_first = index_ == 0;
    const Ply_element& before = is_first ? *(element_ - 1) : *element_;
    std::string names;
    for (const Ply_property& property : before.properties)
      names += (names.empty() ? "" : ", ") + property.name;
    return "line " + std::to_string(begin_) + ", element " + before.name + " " +
           std::to_string(is_first ? before.count - 1 : index_ - 1) +
           (!is_row_short_ ? std::string() : ", which goes on over line " + std::to_string(lines_.number())) + ": " +
           quote(std::string(lines_.p, skip_word(lines_.p, lines_.last))) +
           " is behind the numbers that the header names (" + names + "); " +
           (!is_row_short_ ? "name it there" : "add what is missing before it");
  }

  [[noreturn]] void refuse_surplus()
  {
    std::size_t elements = 0;
    for (const Ply_element& element : header_.elements)
      elements += element.count;
    while (lines_.next_line()) {
    }
    // There are enough lines: each element has one.
    const bool are_alone = lines_.number() >= header_.lines - 1 + elements;
    refuse_file(path_,
                surplus_ + (!are_alone      ? ", or begin each element on a line of its own"
                            : is_row_short_ ? ""
                                            : ", or remove it"),
                Defect::UNREADABLE, index_);
  }

  void take_element(const bool is_vertex)
  {
    std::array<double, 3> point{};
    for (const Ply_property& property : element_->properties) {
      if (!property.is_list()) {
        if (property.role < 3)
          point[property.role] = take_value(property);
        else
          skip_value(property);
        continue;
      }
      const long long count = take_integer(property.size_type, [&] { return "the size of the list " + property.name; });
      if (count < 0)
        refuse_file(path_, where() + ": the list " + property.name + " claims a negative number of entries");
      // Each entry takes two bytes.
      if (static_cast<std::uintmax_t>(count) > size_ / 2 + 1)
        refuse_file(path_, where() + ": the list " + property.name + " claims more entries than the file has");
      corners_.clear();
      for (long long i = 0; i < count; ++i)
        if (property.has_corners())
          corners_.push_back(static_cast<std::uint32_t>(take_integer(property.type, [&] { return property.name; })));
        else
          skip_value(property);
      if (!property.has_corners())
        continue;
      if (property.role == Ply_property::CORNERS)
        soup_.add_face(corners_.data(), corners_.data() + corners_.size());
      else
        add_strips(path_, where(), corners_, soup_);
    }
    if (is_vertex)
      soup_.points.push_back(point);
  }

  // Goes to the next word; false at the end of the file.
  bool find_word()
  {
    const bool is_there = lines_.find_word();
    if (is_there && lines_.number() > last_line_)
      refuse_surplus();
    return is_there;
  }
  void require_word()
  {
    if (!find_word())
      refuse_end();
  }
  [[noreturn]] void refuse_end()
  {
    if (!surplus_.empty())
      refuse_surplus();
    refuse_file(path_, "the file ends too early, after " + so_far());
  }
  std::string so_far() const { return vertices_and_faces(soup_.points.size(), soup_.number_of_faces()); }
  template <class Real>
  bool take_real(Real& number)
  {
    return internal::take_real(lines_.p, lines_.last, number);
  }

  double take_value(const Ply_property& property)
  {
    if (!property.type.is_real)
      return static_cast<double>(take_integer(property.type, [&] { return property.name; }));
    const bool is_double = property.type.size == 8;
    require_word();
    double number = 0;
    float rounded = 0;
    if (is_double ? take_real(number) : take_real(rounded))
      return is_double ? number : rounded;
    const std::string_view word = lines_.take_word();
    number = check_coordinate(path_, word, where(), index_);
    if (is_double)
      return number;
    if (std::abs(number) > (std::numeric_limits<float>::max)())
      refuse_file(path_,
                  where() + ": " + property.name + " is of type float, for which " + quote(word) + " is too large",
                  Defect::OUT_OF_RANGE, index_);
    return static_cast<float>(number);
  }

  // Skips unneeded data, which may be any number: not finite, or out of the range of its type.
  void skip_value(const Ply_property& property)
  {
    require_word();
    if (double ignored = 0; take_real(ignored))
      return;
    if (const std::string_view word = lines_.take_word(); !is_number(word))
      refuse_file(path_, where() + ": " + quote(word) + " is not a number, which is needed for " + property.name,
                  Defect::UNREADABLE, index_);
  }

  // \param what describes it
  template <class What>
  long long take_integer(const Ply_type& type, const What& what)
  {
    require_word();
    const char* p = lines_.p;
    if (std::uint32_t count = 0; take_count(p, lines_.last, count) && count <= type.greatest) {
      lines_.p = p;
      return count;
    }
    long long number = 0;
    const std::string_view word = lines_.take_word();
    Integer_state state = integer_state(word, number);
    if (double real = 0; state == Integer_state::NOT_AN_INTEGER && type.is_real &&
                         read_number(word, real) == Number_state::GOOD && real == std::trunc(real)) {
      const bool is_small = real >= double(type.least) && real <= double(type.greatest);
      state = is_small ? Integer_state::GOOD : Integer_state::TOO_LARGE;
      number = is_small ? static_cast<long long>(real) : 0;
    }
    if (state == Integer_state::NOT_AN_INTEGER)
      refuse_file(path_, where() + ": " + quote(word) + " is not an integer, which is needed for " + what());
    if (state == Integer_state::TOO_LARGE || number < type.least || number > type.greatest)
      refuse_file(path_,
                  where() + ": " + quote(word) + " is out of range for " + what() + ", which is of type " + type.name);
    return number;
  }

  std::string where() const
  {
    return "line " + std::to_string(lines_.number()) + ", element " + element_->name + " " + std::to_string(index_);
  }

  std::string path_;
  const Ply_header& header_;
  Polygon_soup& soup_;
  static constexpr char no_comment = '\n'; // no word begins with it
  Text_lines lines_;
  const std::uintmax_t size_;         // of the data after the header
  std::size_t first_ = 0, begin_ = 0; // the lines on which the first element begins, and this one
  std::string surplus_;               // the defect of the line if another one follows it
  bool is_row_short_ = false;         // whether the defect is that the previous row has too few numbers
  std::size_t last_line_ = (std::numeric_limits<std::size_t>::max)(); // there must be no other then
  const Ply_element* element_ = nullptr;
  std::size_t index_ = 0;              // of the element among the elements of its kind
  std::vector<std::uint32_t> corners_; // of a face
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_PLY_TEXT_READER_H
