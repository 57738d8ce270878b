// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Text of files in messages, and numbers of things.

#include <CGAL/Intrinsic_triangulations/internal/system/shown_text.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

namespace CGAL::Intrinsic_triangulations::internal {

std::string shown_text(const std::string& text)
{
  std::string result = text.substr(0, 40);
  std::replace_if(
    result.begin(), result.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return result + (text.size() > 40 ? "..." : "");
}

std::string counted(const std::uintmax_t n, const char* const singular, const char* const plural)
{
  return std::to_string(n) + " " + (n == 1 ? singular : plural);
}

std::string are_counted(const std::uintmax_t n, const char* const singular, const char* const plural)
{
  return (n == 1 ? "is " : "are ") + counted(n, singular, plural);
}

std::string index_text(const std::size_t value)
{
  constexpr std::size_t none = (std::numeric_limits<std::uint32_t>::max)();
  if (value > (std::numeric_limits<std::size_t>::max)() / 2)
    return "-" + std::to_string(std::size_t(0) - value);
  if (value > none / 2 && value <= none)
    return "-" + std::to_string(none + 1 - value);
  return std::to_string(value);
}

} // namespace CGAL::Intrinsic_triangulations::internal
