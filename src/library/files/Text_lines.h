// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A text line by line, and each line word by word, up to a comment; shared by the readers of such texts.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_TEXT_LINES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_TEXT_LINES_H

#include "File_blocks.h"
#include "text_file.h"

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace CGAL::Intrinsic_triangulations::internal {

class Text_lines
{
public:
  // \param number of the line before the first
  // \param comment begins a comment
  Text_lines(const std::string& path, const std::uintmax_t size, const Progress_function& progress,
             const Text_encoding& encoding, const std::size_t number = 0, const char comment = '#')
    : path_(path), file_(path, size, encoding.begin, progress, encoding.line_end), line_end_(encoding.line_end),
      number_(number), last_number_(number), comment_(comment)
  {}
  Text_lines(const std::string& path, const std::uintmax_t size, const Progress_function& progress)
    : Text_lines(path, size, progress, find_encoding(path))
  {}

  // The rest of the line: the caller advances `p`. Pointers are valid until the next line.
  const char* p = nullptr;
  const char* last = nullptr;

  // The number of the line, counted from 1; 0 before the first.
  std::size_t number() const { return number_; }

  // Goes to the next line; false if there is none.
  bool next_line()
  {
    number_ = last_number_;
    if (!file_.take_line(p, last)) {
      p = last = nullptr;
      return false;
    }
    number_ = ++last_number_;
    return true;
  }
  // Replaces the lines from a given number on by a text.
  void replace_lines(const std::size_t number, const std::string& text)
  {
    number_ = number;
    p = text.data();
    last = p + text.size();
  }
  // Goes to the next word of the line; false at its end or at a comment.
  bool find_word_on_line()
  {
    p = skip_white(p, last);
    if (p != last && *p == comment_)
      skip_comment();
    return p != last;
  }
  // Goes to the next word anywhere; false at the end of the file.
  BOOST_FORCEINLINE bool find_word()
  {
    while (!find_word_on_line())
      if (!next_line())
        return false;
    return true;
  }
  // Skips the word at p, which ends at a comment, unless it is one of the words with that letter.
  // Inline: a call for each word would take 4 % of the reading of short numbers.
  BOOST_FORCEINLINE std::string_view take_word()
  {
    const char* const begin = p;
    const char* const end = skip_word(begin, last);
    p = std::find(begin, end, comment_);
    if (p != end && is_foreign_infinity_or_nan({begin, static_cast<std::size_t>(end - begin)}))
      p = end;
    return std::string_view(begin, static_cast<std::size_t>(p - begin));
  }
  // The rest of the line, in a form that can be quoted.
  std::string rest() const
  {
    const char* end = last;
    while (end != p && is_white(end[-1]))
      --end;
    std::string text(p, end);
    std::replace(text.begin(), text.end(), '\t', ' ');
    return text;
  }

private:
  // Separate, so that the function called for each word stays short.
  BOOST_NOINLINE void skip_comment()
  {
    while ((p = skip_white(std::find(p, last, line_end_ == '\n' ? '\r' : '\n'), last)) != last)
      if (begins_element())
        refuse_line_end(path_, number_, line_end_);
  }

  // Whether a keyword or number at p may begin an element on a line of its own: if a word follows, it is prose.
  bool begins_element() const
  {
    const char* const end = std::find_if(p, last, [](const char c) { return c == '\r' || c == '\n'; });
    const char* q = skip_word(p, end);
    const std::string_view first(p, static_cast<std::size_t>(q - p));
    const auto is_first = [first](const char* const keyword) { return is_keyword(first, keyword); };
    const bool has_keyword =
      is_first("v") || is_first("f") || is_first("trgl") || is_first("vrtx") || is_first("pvrtx");
    bool is_element = has_keyword || is_digit(first[0]) || first[0] == '-';
    while (is_element && (q = skip_white(q, end)) != end) {
      const std::string_view word(q, static_cast<std::size_t>(skip_word(q, end) - q));
      is_element = word.size() < 2 || word.substr(0, 2).find_first_of("0123456789+-./") != word.npos || is_number(word);
      q = has_keyword ? end : q + word.size(); // a control node has words after its numbers
    }
    return is_element;
  }

  const std::string path_;
  File_blocks file_;
  const char line_end_;
  std::size_t number_, last_number_;
  const char comment_;
};

class Text_reader
{
protected:
  Text_reader(const std::string& path, Polygon_soup& soup, const std::uintmax_t size, const Progress_function& progress)
    : path_(path), soup_(soup), lines_(path, size, progress)
  {}

  std::string line() const { return "line " + std::to_string(lines_.number()); }
  std::string where(const char* const kind, const std::size_t element) const
  {
    return place(lines_.number(), kind, element);
  }

  [[noreturn]] void refuse(const std::string& text, const Defect defect = Defect::UNREADABLE,
                           const std::size_t element = 0, const std::size_t count = 1) const
  {
    refuse_file(path_, text, defect, element, count);
  }
  [[noreturn]] void refuse(const char* const kind, const std::size_t element, const std::string& text,
                           const Defect defect = Defect::UNREADABLE) const
  {
    refuse(where(kind, element) + text, defect, element);
  }

  // The vertex number at or after p, of which the line must have several.
  double take_coordinate(const std::size_t vertex, const std::size_t number, const std::size_t needed = 3)
  {
    if (!lines_.find_word_on_line())
      refuse("vertex", vertex,
             ": there " + are_counted(number, "number", "numbers") + " where " + std::to_string(needed) +
               " are needed");
    double coordinate;
    if (!take_real(lines_.p, lines_.last, coordinate))
      coordinate = check_coordinate(path_, lines_.take_word(), where("vertex", vertex), vertex);
    return coordinate;
  }
  // Skips an unneeded number, which need not be finite.
  void skip_number(const std::size_t vertex, const std::size_t number, const std::size_t needed)
  {
    const char* const begin = lines_.p;
    if (!lines_.find_word_on_line() || !is_number(lines_.take_word())) {
      lines_.p = begin;
      take_coordinate(vertex, number, needed);
    }
  }
  std::array<double, 3> take_point(const std::size_t vertex)
  {
    std::array<double, 3> point;
    for (std::size_t i = 0; i < 3; ++i)
      point[i] = take_coordinate(vertex, i);
    return point;
  }

  // Skips the rest of the line, of numbers, and returns their count.
  // \param place describes what may be there
  template <class Place, class Is_allowed>
  std::size_t take_others(const char* const kind, const std::size_t element, const std::size_t at_most,
                          const Place& place, const Is_allowed& is_allowed)
  {
    std::size_t count = 0;
    for (; lines_.find_word_on_line(); ++count)
      if (const std::string_view word = lines_.take_word(); count == at_most || !is_allowed(word))
        refuse(kind, element, ": " + quote(word) + " is behind the " + place());
    return count;
  }

  // "there is no vertex in the file", or no face
  [[noreturn]] void refuse_empty(const std::size_t vertices, const std::size_t faces) const
  {
    refuse("there is no " + std::string(vertices == 0 ? "vertex" : "face") + " in the file (" +
             vertices_and_faces(vertices, faces) + ")",
           Defect::EMPTY);
  }

  const std::string& path_;
  Polygon_soup& soup_;
  Text_lines lines_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_TEXT_LINES_H
