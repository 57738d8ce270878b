// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Shared by the readers of all formats: the words and numbers of a text, and refusals that name the line or the element
// at fault.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_TEXT_FILE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_TEXT_FILE_H

#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/system/shown_text.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <clocale>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <initializer_list>
#include <string>
#include <string_view>
#include <system_error>

#ifndef _WIN32
#include <locale.h>
#endif
#ifdef __APPLE__
#include <xlocale.h>
#endif

namespace CGAL::Intrinsic_triangulations::internal {

#ifndef _WIN32 // where all standard libraries have the function
inline double by_strtod(double, const char* text, char** end, locale_t locale) { return ::strtod_l(text, end, locale); }
inline float by_strtod(float, const char* text, char** end, locale_t locale) { return ::strtof_l(text, end, locale); }

// Like std::from_chars(), by the function of C that does the same in a given locale.
template <class Real>
std::from_chars_result from_chars_by_strtod(const char* const first, const char* const last, Real& number)
{
  static const locale_t classic = ::newlocale(LC_ALL_MASK, "C", nullptr);
  // A terminated copy that does not begin with a blank. Only C accepts +1 and 0x10 as numbers.
  const auto may_be_in_number = [](const char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || std::strchr("+-.()_", c) != nullptr;
  };
  std::string text(first, std::find_if_not(first, last, may_be_in_number));
  if (const std::size_t x = text.find_first_of("xX"); x < text.find('('))
    text.resize(x);
  char* end = nullptr;
  errno = 0;
  const Real result = by_strtod(Real(), text.c_str(), &end, classic);
  if (end == text.c_str() || text[0] == '+')
    return {first, std::errc::invalid_argument};
  const char* const rest = first + (end - text.c_str());
  if (errno == ERANGE && (std::isinf(result) || result == 0))
    return {rest, std::errc::result_out_of_range};
  number = result;
  return {rest, std::errc()};
}
#endif

// As std::from_chars() for `float` and `double`, which libc++ has from version 20 on: it does not define this macro
// before.
template <class Real>
std::from_chars_result from_chars(const char* const first, const char* const last, Real& number)
{
#if defined(__cpp_lib_to_chars) || defined(_WIN32)
  return std::from_chars(first, last, number);
#else
  return from_chars_by_strtod(first, last, number);
#endif
}

using Defect = Invalid_surface_error::Defect;

// \exception Invalid_surface_error with a message that begins with `path`
[[noreturn]] inline void refuse_file(const std::string& path, const std::string& text,
                                     const Defect defect = Defect::UNREADABLE, const std::size_t element = 0,
                                     const std::size_t count = 1)
{
  throw Invalid_surface_error(defect, element, count, path + ": " + text);
}

// The bytes of a file, or its first ones.
inline std::string load_file(const std::string& path, const std::size_t at_most)
{
  std::ifstream in(path, std::ios::binary);
  std::string text(at_most, '\0');
  in.read(&text[0], static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  return text;
}

// How a text begins, after a byte order mark, and how its lines end: with CR alone if it contains no LF.
struct Text_encoding
{
  std::uintmax_t begin = 0;
  char line_end = '\n';
};

// \exception Invalid_surface_error for UTF-16
inline Text_encoding find_encoding(const std::string& path)
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

// A piece of a file in a form that is safe in a message.
inline std::string quote(const std::string_view text) { return '"' + shown_text(std::string(text)) + '"'; }

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

inline std::string in_small_letters(std::string text)
{
  for (char& c : text)
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

// Refuses a comment in which a line ends differently from all other lines: text after it would be lost.
[[noreturn]] inline void refuse_line_end(const std::string& path, const std::size_t line, const char line_end)
{
  const bool is_lf = line_end == '\n';
  refuse_file(path, "line " + std::to_string(line) + ": a " + (is_lf ? "CR" : "LF") +
                      " ends the comment, but lines end with " + (is_lf ? "LF" : "CR") +
                      " before it: write all line ends alike");
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

inline bool is_one_of(const std::string_view word, const std::initializer_list<std::string_view> keywords)
{
  return std::any_of(keywords.begin(), keywords.end(),
                     [word](const std::string_view k) { return is_keyword(word, k); });
}

// Classifies a word that should be an integer, and returns the text to read if it is one: C++ accepts no plus sign.
enum class Integer_state {
  GOOD,
  TOO_LARGE,
  NOT_AN_INTEGER
};

inline const char* skip_plus(const std::string_view word)
{
  return word.data() + (word.size() > 1 && word[0] == '+' && word[1] != '-' ? 1 : 0);
}

inline Integer_state integer_state(const std::string_view word, long long& number)
{
  const char* const end = word.data() + word.size();
  const std::from_chars_result result = std::from_chars(skip_plus(word), end, number);
  return result.ptr != end || result.ec == std::errc::invalid_argument ? Integer_state::NOT_AN_INTEGER
         : result.ec == std::errc()                                    ? Integer_state::GOOD
                                                                       : Integer_state::TOO_LARGE;
}

inline bool read_integer(const std::string_view word, long long& number)
{
  return integer_state(word, number) == Integer_state::GOOD;
}

// Moves past the number at p if it is valid and ends with the word, as most numbers do. Otherwise leaves p for a closer
// look by check_coordinate().
template <class Real>
BOOST_FORCEINLINE bool take_real(const char*& p, const char* const end, Real& number)
{
  const std::from_chars_result result = internal::from_chars(p, end, number);
  if (result.ec != std::errc() || !(result.ptr == end || is_white(*result.ptr)) || !std::isfinite(number))
    return false;
  p = result.ptr;
  return true;
}

// Moves past a word that is a number without sign and point, of at most nine digits. Otherwise leaves p.
inline bool take_count(const char*& p, const char* const end, std::uint32_t& number)
{
  const char* q = p;
  for (number = 0; q != end && is_digit(*q); ++q)
    number = 10 * number + static_cast<std::uint32_t>(*q - '0');
  if (q == p || q - p > 9 || !(q == end || is_white(*q)))
    return false;
  p = q;
  return true;
}

enum class Number_state {
  GOOD,
  NOT_FINITE,
  TOO_LARGE,
  NOT_A_NUMBER
};

// Whether some compiler writes a nonfinite number as this word, which std::from_chars() does not know. Windows
// compilers before 2015 round the letters, too: 1.#QNAN, 1.#INF00e+000, 1.#J, also with a decimal comma.
BOOST_NOINLINE inline bool is_foreign_infinity_or_nan(std::string_view word)
{
  word.remove_prefix(!word.empty() && (word[0] == '+' || word[0] == '-') ? 1 : 0);
  if (word.size() > 3 && word[0] == '1' && (word[1] == '.' || word[1] == ',') && word[2] == '#')
    return std::isalpha(static_cast<unsigned char>(word[3])) != 0;
  return is_one_of(word, {"qnan", "snan", "nanq", "nans", "1#inf", "1#ind", "1#qnan", "1#snan", "\xe2\x88\x9e"});
}

// Numbers nearer to zero than any number of the type become zero.
inline Number_state read_number(const std::string_view word, double& number)
{
  const char* const end = word.data() + word.size();
  const std::from_chars_result result = internal::from_chars(skip_plus(word), end, number);
  if (result.ptr != end || result.ec == std::errc::invalid_argument)
    return is_foreign_infinity_or_nan(word) ? Number_state::NOT_FINITE : Number_state::NOT_A_NUMBER;
  if (result.ec == std::errc::result_out_of_range) {
    // Too large or too small: the exponent tells.
    const std::size_t e = word.find_first_of("eE");
    if (e == std::string::npos || word[e + 1] != '-')
      return Number_state::TOO_LARGE;
    number = word[0] == '-' ? -0. : 0.;
  }
  return std::isfinite(number) ? Number_state::GOOD : Number_state::NOT_FINITE;
}

// Whether a word is a number, finite or not.
inline bool is_number(const std::string_view word)
{
  double ignored;
  return read_number(word, ignored) != Number_state::NOT_A_NUMBER;
}

// "line 7 (vertex 3)"
inline std::string place(const std::size_t line, const char* const kind, const std::size_t element)
{
  return "line " + std::to_string(line) + " (" + kind + " " + std::to_string(element) + ")";
}

// "3 vertices and 1 face"
inline std::string vertices_and_faces(const std::uintmax_t vertices, const std::uintmax_t faces)
{
  return counted(vertices, "vertex", "vertices") + " and " + counted(faces, "face", "faces");
}

// ", and 3 more faces like it"
inline std::string and_more_faces(const std::size_t count)
{
  return count < 2 ? std::string() : ", and " + counted(count - 1, "more face like it", "more faces like it");
}

// The coordinate given by a word; refuses the word if it is not a coordinate.
inline double check_coordinate(const std::string& path, const std::string_view word, const std::string& where,
                               const std::size_t vertex)
{
  double number = 0;
  switch (read_number(word, number)) {
  case Number_state::GOOD:
    return number;
  case Number_state::NOT_FINITE:
    refuse_file(path, where + ": the coordinate " + quote(word) + " is not finite", Defect::NOT_FINITE, vertex);
  case Number_state::TOO_LARGE:
    refuse_file(path, where + ": the coordinate " + quote(word) + " is too large for a double", Defect::OUT_OF_RANGE,
                vertex);
  case Number_state::NOT_A_NUMBER:
    break;
  }
  const auto would_be_a_number = [&](const std::string& characters, const char replacement) {
    std::string other(word);
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

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_TEXT_FILE_H
