// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// What the readers of all formats share: the words and numbers of a text, and the refusal that
// names the line or the element at fault.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_TEXT_FILE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_TEXT_FILE_H

#include <CGAL/Intrinsic_triangulations/config.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/files/from_chars.h>
#include <CGAL/Intrinsic_triangulations/internal/system/shown_text.h>

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <system_error>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

using Defect = Invalid_surface_error::Defect;

// \exception Invalid_surface_error with a message that begins with `path`
[[noreturn]] void refuse_file(const std::string& path, const std::string& text,
                              Defect defect = Defect::UNREADABLE, std::size_t element = 0, std::size_t count = 1);

// The size of a regular file that can be opened. A device or a pipe may have no end, or no beginning.
// \exception Invalid_surface_error if it is none
std::uintmax_t check_file(const std::string& path);

// Refuses what the lines of no text format can begin with.
// \exception Invalid_surface_error as all others
void check_encoding(const std::string& path);

// The bytes of a file, or its first ones.
std::string load_file(const std::string& path, std::size_t at_most = (std::numeric_limits<std::size_t>::max)());

// A piece of a file as it can stand in a message.
inline std::string quote(const std::string& text) { return '"' + shown_text(text) + '"'; }

inline bool is_white(const char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
inline bool is_digit(const char c) { return c >= '0' && c <= '9'; }

inline const char* skip_white(const char* p, const char* const end)
{
  while (p != end && is_white(*p))
    ++p;
  return p;
}

inline const char* skip_word(const char* p, const char* const end)
{
  while (p != end && !is_white(*p))
    ++p;
  return p;
}

// The words of a text, and the line on which each is. For headers, and for saying what is wrong.
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
      else if (!is_white(text_[position_]))
        return true;
    }
    return false;
  }
  // The next word anywhere, empty at the end of the text.
  std::string word() { return skip_to_word() ? take() : std::string(); }
  // The next word on this line, empty at its end or at a comment.
  std::string word_on_line()
  {
    while (position_ < text_.size() && text_[position_] != '\n' && is_white(text_[position_]))
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
  std::string take()
  {
    const std::size_t begin = position_;
    while (position_ < text_.size() && !is_white(text_[position_]) && text_[position_] != '#')
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

// Reads a word that is a number that a coordinate can be; what is nearer to zero than any number of the type is zero.
bool read_coordinate(const std::string& word, double& number);

// Goes behind the number at p if all is well with it, and it ends with the word or at a comment: most numbers do, and
// anything else needs a closer look, by read_coordinate() or check_coordinate(). Leaves p otherwise.
template <class Real>
bool take_real(const char*& p, const char* const end, Real& number)
{
  const std::from_chars_result result = internal::from_chars(p, end, number);
  if (result.ec != std::errc() || !(result.ptr == end || is_white(*result.ptr) || *result.ptr == '#') ||
      !std::isfinite(number))
    return false;
  p = result.ptr;
  return true;
}

// Goes behind a number without a sign and a point, of nine digits at most, at whose end the word may go on. Leaves p otherwise.
inline bool take_count(const char*& p, const char* const end, std::uint32_t& number)
{
  const char* q = p;
  for (number = 0; q != end && is_digit(*q); ++q)
    number = 10 * number + static_cast<std::uint32_t>(*q - '0');
  if (q == p || q - p > 9)
    return false;
  p = q;
  return true;
}

// "line 7 (vertex 3)"
std::string place(std::size_t line, const char* kind, std::size_t element);
inline std::string place(const Scanner& scanner, const char* const kind, const std::size_t element)
{
  return place(scanner.line(), kind, element);
}

// The coordinate that a word is; refuses the word if it is none.
double check_coordinate(const std::string& path, const std::string& word, const std::string& where,
                        std::size_t vertex);

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/internal/files/text_file_impl.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_TEXT_FILE_H
