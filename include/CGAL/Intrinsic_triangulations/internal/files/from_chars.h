// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Decimal numbers in any locale, correctly rounded.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_FROM_CHARS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_FROM_CHARS_H

#include <cctype>
#include <charconv>
#include <clocale>
#include <cmath>
#include <cstdlib>
#include <string>
#include <system_error>

#ifndef _WIN32
#include <locale.h>
#endif
#ifdef __APPLE__
#include <xlocale.h>
#endif

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

#ifndef _WIN32 // where all standard libraries have the function
// Where a number of std::from_chars() ends; `first` if there is none.
inline const char* end_of_number(const char* const first, const char* const last)
{
  const char* p = first;
  const auto is_digit_at = [last](const char* q) { return q != last && *q >= '0' && *q <= '9'; };
  const auto skip_word = [&p, last](const char* word) {
    const char* q = p;
    for (; *word != 0 && q != last && (*q | 0x20) == *word; ++q, ++word) {
    }
    return *word == 0 ? (p = q, true) : false;
  };
  if (p != last && *p == '-')
    ++p;
  if (skip_word("infinity") || skip_word("inf"))
    return p;
  if (skip_word("nan")) {
    const char* q = p;
    if (q != last && *q == '(')
      for (++q; q != last && (std::isalnum(static_cast<unsigned char>(*q)) || *q == '_'); ++q) {
      }
    return q != p && q != last && *q == ')' ? q + 1 : p;
  }
  bool has_digits = is_digit_at(p);
  while (is_digit_at(p))
    ++p;
  if (p != last && *p == '.') {
    has_digits |= is_digit_at(p + 1);
    if (has_digits)
      for (++p; is_digit_at(p);)
        ++p;
  }
  if (!has_digits)
    return first;
  if (p != last && (*p | 0x20) == 'e') {
    const char* q = p + 1;
    if (q != last && (*q == '+' || *q == '-'))
      ++q;
    if (is_digit_at(q))
      for (p = q; is_digit_at(p);)
        ++p;
  }
  return p;
}

inline double by_strtod(double, const char* text, locale_t locale) { return ::strtod_l(text, nullptr, locale); }
inline float by_strtod(float, const char* text, locale_t locale) { return ::strtof_l(text, nullptr, locale); }

// As std::from_chars(), by the function of C that does the same in a given locale.
template <class Real>
std::from_chars_result from_chars_by_strtod(const char* const first, const char* const last, Real& number)
{
  static const locale_t classic = ::newlocale(LC_ALL_MASK, "C", nullptr);
  const char* const end = end_of_number(first, last);
  if (end == first)
    return {first, std::errc::invalid_argument};
  // A copy, which ends; nearly all fit into this.
  char buffer[64];
  std::string text;
  const std::size_t size = static_cast<std::size_t>(end - first);
  if (size < sizeof buffer) {
    std::char_traits<char>::copy(buffer, first, size);
    buffer[size] = 0;
  } else {
    text.assign(first, end);
  }
  const Real result = by_strtod(Real(), size < sizeof buffer ? buffer : text.c_str(), classic);
  const auto has_digit_but_zero = [&] {
    const char* p = first;
    while (p != end && (*p | 0x20) != 'e' && !(*p >= '1' && *p <= '9'))
      ++p;
    return p != end && *p >= '1' && *p <= '9';
  };
  // Beyond the range, unless the word says so.
  if ((std::isinf(result) || result == 0) && has_digit_but_zero())
    return {end, std::errc::result_out_of_range};
  number = result;
  return {end, std::errc()};
}
#endif

// As std::from_chars() for `float` and `double`, which libc++ has from version 20 on: it does not define this macro before.
template <class Real>
std::from_chars_result from_chars(const char* const first, const char* const last, Real& number)
{
#if defined(__cpp_lib_to_chars) || defined(_WIN32)
  return std::from_chars(first, last, number);
#else
  return from_chars_by_strtod(first, last, number);
#endif
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_FROM_CHARS_H
