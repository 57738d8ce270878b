// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// What the readers of all formats share: the words and numbers of a text, and the refusal that
// names the line or the element at fault.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_TEXT_FILE_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_TEXT_FILE_IMPL_H

#include <CGAL/Intrinsic_triangulations/internal/files/text_file.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
void refuse_file(const std::string& path, const std::string& text, const Defect defect,
                 const std::size_t element, const std::size_t count)
{
  throw Invalid_surface_error(defect, element, count, path + ": " + text);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
std::uintmax_t check_file(const std::string& path)
{
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found)
    refuse_file(path, "there is no such file");
  if (fs::is_directory(status))
    refuse_file(path, "this is a directory, not a file");
  if (fs::exists(status) && !fs::is_regular_file(status))
    refuse_file(path, "this is not a regular file");
  errno = 0;
  if (!std::ifstream(path, std::ios::binary))
    refuse_file(path, std::string("the file cannot be opened") +
                        (errno == 0 ? "" : std::string(" (") + std::strerror(errno) + ")"));
  const std::uintmax_t size = fs::file_size(path, error);
  if (error)
    refuse_file(path, "the file cannot be read (" + error.message() + ")");
  return size;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Text_encoding find_encoding(const std::string& path)
{
  const std::string head = load_file(path, 1 << 16);
  if (head.compare(0, 2, "\xff\xfe") == 0 || head.compare(0, 2, "\xfe\xff") == 0)
    refuse_file(path, "the text is in UTF-16: save it as ASCII or UTF-8");
  Text_encoding result;
  if (head.compare(0, 3, "\xef\xbb\xbf") == 0)
    result.begin = 3;
  if (head.find('\n') == std::string::npos && head.find('\r') != std::string::npos)
    result.line_end = '\r';
  return result;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
std::string load_file(const std::string& path, const std::size_t at_most)
{
  std::ifstream in(path, std::ios::binary);
  std::error_code ignored;
  std::string text((std::min<std::uintmax_t>)(std::filesystem::file_size(path, ignored), at_most), '\0');
  in.read(&text[0], static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  return text;
}

enum class Number_state {
  GOOD,
  NOT_FINITE,
  TOO_LARGE,
  NOT_A_NUMBER
};

inline Number_state read_number(const std::string& word, double& number)
{
  const char* const begin = word.data() + (word.size() > 1 && word[0] == '+' && word[1] != '-' ? 1 : 0);
  const std::from_chars_result result = internal::from_chars(begin, word.data() + word.size(), number);
  if (result.ptr != word.data() + word.size() || result.ec == std::errc::invalid_argument)
    return Number_state::NOT_A_NUMBER;
  if (result.ec == std::errc::result_out_of_range) {
    // Too large or too small: the exponent tells.
    const std::size_t e = word.find_first_of("eE");
    if (e == std::string::npos || word[e + 1] != '-')
      return Number_state::TOO_LARGE;
    number = word[0] == '-' ? -0. : 0.;
  }
  return std::isfinite(number) ? Number_state::GOOD : Number_state::NOT_FINITE;
}

inline std::from_chars_result parse_integer(const std::string& word, long long& number)
{
  const bool has_plus = word.size() > 1 && word[0] == '+' && word[1] != '-';
  return std::from_chars(word.data() + has_plus, word.data() + word.size(), number);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
bool read_integer(const std::string& word, long long& number)
{
  const std::from_chars_result result = parse_integer(word, number);
  return result.ec == std::errc() && result.ptr == word.data() + word.size();
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
bool is_beyond_integers(const std::string& word)
{
  long long number = 0;
  const std::from_chars_result result = parse_integer(word, number);
  return result.ec == std::errc::result_out_of_range && result.ptr == word.data() + word.size();
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
bool read_coordinate(const std::string& word, double& number)
{
  return read_number(word, number) == Number_state::GOOD;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
bool is_number(const std::string& word)
{
  double ignored;
  return read_number(word, ignored) != Number_state::NOT_A_NUMBER;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
std::string place(const std::size_t line, const char* const kind, const std::size_t element)
{
  return "line " + std::to_string(line) + " (" + kind + " " + std::to_string(element) + ")";
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
double check_coordinate(const std::string& path, const std::string& word, const std::string& where,
                        const std::size_t vertex)
{
  double number = 0;
  switch (read_number(word, number)) {
  case Number_state::GOOD:
    return number;
  case Number_state::NOT_FINITE:
    refuse_file(path, where + ": the coordinate " + quote(word) + " is not finite", Defect::NOT_FINITE, vertex);
  case Number_state::TOO_LARGE:
    refuse_file(path, where + ": the coordinate " + quote(word) + " is too large for a double",
                Defect::OUT_OF_RANGE, vertex);
  case Number_state::NOT_A_NUMBER:
    break;
  }
  const auto would_be_a_number = [&](const std::string& characters, const char replacement) {
    std::string other = word;
    std::replace_if(
      other.begin(), other.end(), [&](char c) { return characters.find(c) != std::string::npos; }, replacement);
    return other != word && read_number(other, number) == Number_state::GOOD;
  };
  const char* const advice = word.find_first_of(",;") + 1 == word.size() ? ": separate numbers by blanks alone"
                             : would_be_a_number(",", '.')               ? ": write a point for the decimal comma"
                             : would_be_a_number("dD", 'e')              ? ": write e before the exponent"
                                                                         : "";
  refuse_file(path, where + ": " + quote(word) + " is not a number" + advice, Defect::UNREADABLE, vertex);
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_TEXT_FILE_IMPL_H
