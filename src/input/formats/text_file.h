// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the checks of all formats share: the words and numbers of a text, and the refusal that
// names the line or the element at fault.

#ifndef IDT_FORMATS_TEXT_FILE_H
#define IDT_FORMATS_TEXT_FILE_H

#include <CGAL/Intrinsic_triangulations/errors.h>

#include <cstddef>
#include <limits>
#include <string>

namespace idt {

using CGAL::Intrinsic_triangulations::Invalid_surface_error;
using Defect = Invalid_surface_error::Defect;

// \exception Invalid_surface_error with a message that begins with `path`
[[noreturn]] void refuse(const std::string& path, const std::string& text,
                         Defect defect = Defect::UNREADABLE, std::size_t element = 0,
                         std::size_t count = 1);

// The bytes of a file, or its first ones.
std::string load(const std::string& path, std::size_t at_most = (std::numeric_limits<std::size_t>::max)());

// A piece of a file as it can stand in a message.
std::string quote(const std::string& text);

// The words of a text, and the line on which each is.
class Scanner
{
public:
  explicit Scanner(const std::string& text) : text_(text) {}

  std::size_t line() const { return line_; }
  std::size_t remaining() const { return text_.size() - position_; }

  // Goes to the next word behind comments and line ends; false at the end.
  bool skip_to_word()
  {
    for (; position_ < text_.size(); ++position_) {
      if (text_[position_] == '#')
        while (position_ + 1 < text_.size() && text_[position_ + 1] != '\n')
          ++position_;
      else if (text_[position_] == '\n')
        ++line_;
      else if (!is_space(text_[position_]))
        return true;
    }
    return false;
  }
  // The next word anywhere, empty at the end of the text.
  std::string word() { return skip_to_word() ? take() : std::string(); }
  // The next word on this line, empty at its end or at a comment.
  std::string word_on_line()
  {
    while (position_ < text_.size() && text_[position_] != '\n' && is_space(text_[position_]))
      ++position_;
    if (position_ == text_.size() || text_[position_] == '\n' || text_[position_] == '#')
      return std::string();
    return take();
  }
  void skip_line()
  {
    while (position_ < text_.size() && text_[position_] != '\n')
      ++position_;
  }

private:
  static bool is_space(const char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
  std::string take()
  {
    const std::size_t begin = position_;
    while (position_ < text_.size() && !is_space(text_[position_]) && text_[position_] != '#')
      ++position_;
    return text_.substr(begin, position_ - begin);
  }

  const std::string& text_;
  std::size_t position_ = 0;
  std::size_t line_ = 1;
};

// Whether a word is an integer and nothing else.
bool read_integer(const std::string& word, long long& number);

// Whether a word is an integer that no computer counts up to.
bool is_beyond_integers(const std::string& word);

// Whether a word is a number that a coordinate can be.
bool is_coordinate(const std::string& word);

// "line 7 (vertex 3)"
std::string place(const Scanner& scanner, const char* kind, std::size_t element);

// The coordinate that a word is; refuses the word if it is none.
double check_coordinate(const std::string& path, const std::string& word, const std::string& where,
                        std::size_t vertex);

} // namespace idt

#endif // IDT_FORMATS_TEXT_FILE_H
