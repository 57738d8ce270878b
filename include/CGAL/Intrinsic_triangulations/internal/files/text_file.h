// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// What the readers of all formats share: the words and numbers of a text, and the refusal that
// names the line or the element at fault.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_TEXT_FILE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_TEXT_FILE_H

#include <CGAL/Intrinsic_triangulations/internal/config.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/files/from_chars.h>
#include <CGAL/Intrinsic_triangulations/internal/system/shown_text.h>

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
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

// How a text begins, behind a byte order mark, and how its lines end: by CR alone if there is no LF.
struct Text_encoding
{
  std::uintmax_t begin = 0;
  char line_end = '\n';
};

// \exception Invalid_surface_error for UTF-16
Text_encoding find_encoding(const std::string& path);

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

// Whether a word is a keyword, which is in small letters, in letters of any case.
inline bool is_keyword(const std::string_view word, const std::string_view keyword)
{
  if (word.size() != keyword.size())
    return false;
  for (std::size_t i = 0; i < word.size(); ++i)
    if (word[i] != keyword[i] && (word[i] < 'A' || word[i] > 'Z' || word[i] - 'A' + 'a' != keyword[i]))
      return false;
  return true;
}

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

// Whether a word is a number, finite or not.
bool is_number(const std::string& word);

// "line 7 (vertex 3)"
std::string place(std::size_t line, const char* kind, std::size_t element);

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
