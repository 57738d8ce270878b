// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Decimal numbers in any locale, correctly rounded.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_FROM_CHARS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_FROM_CHARS_H

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <clocale>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <cstring>
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
inline double by_strtod(double, const char* text, char** end, locale_t locale) { return ::strtod_l(text, end, locale); }
inline float by_strtod(float, const char* text, char** end, locale_t locale) { return ::strtof_l(text, end, locale); }

// As std::from_chars(), by the function of C that does the same in a given locale.
template <class Real>
std::from_chars_result from_chars_by_strtod(const char* const first, const char* const last, Real& number)
{
  static const locale_t classic = ::newlocale(LC_ALL_MASK, "C", nullptr);
  // A copy, which ends, and begins with no blank. To C alone, +1 and 0x10 are numbers.
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

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_FROM_CHARS_H
