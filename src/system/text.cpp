// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "system/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

namespace idt {
namespace {

// Independent of the locale.
std::string formatted(double number, int digits)
{
  char buffer[64];
  const std::to_chars_result result =
    std::to_chars(buffer, buffer + sizeof buffer, number, std::chars_format::general, digits);
  return std::string(buffer, result.ptr);
}

} // namespace

std::string with_separators(std::uint64_t number)
{
  std::string text = std::to_string(number);
  for (std::size_t i = text.size(); i > 3; i -= 3)
    text.insert(i - 3, 1, ',');
  return text;
}

std::string counted(std::uint64_t number, const char* singular, const char* plural)
{
  return with_separators(number) + " " + (number == 1 ? singular : plural);
}

std::string quoted(const std::string& text)
{
  std::string shown = text.substr(0, 40);
  std::replace_if(
    shown.begin(), shown.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return '"' + shown + (text.size() > 40 ? "...\"" : "\"");
}

std::string in_full(double number) { return formatted(number, 17); }

std::string in_short(double number) { return formatted(number, 4); }

namespace {

// \param toward the infinity in whose direction
std::string rounded(double number, double toward)
{
  const auto is_right = [&](const std::string& text) {
    const double value = std::strtod(text.c_str(), nullptr);
    return toward > 0 ? value >= number : value <= number;
  };
  std::string result = in_short(number);
  // By less than the last of four digits, until the text changes.
  for (double x = number; std::isfinite(x) && !is_right(result); result = in_short(x))
    x += std::copysign(std::abs(number) * 1e-4, toward);
  return result;
}

} // namespace

std::string in_short_not_below(double number) { return rounded(number, std::numeric_limits<double>::infinity()); }

std::string in_short_not_above(double number) { return rounded(number, -std::numeric_limits<double>::infinity()); }

std::string in_short(const std::array<double, 3>& point)
{
  return '(' + in_short(point[0]) + ", " + in_short(point[1]) + ", " + in_short(point[2]) + ')';
}

std::string seconds_text(double seconds)
{
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, seconds < 10 ? "%.3f s" : "%.1f s", seconds);
  return buffer;
}

std::string cell(const std::optional<std::uint64_t>& number) { return number ? std::to_string(*number) : "-"; }

std::string cell(const std::optional<double>& number) { return number ? in_short(*number) : "-"; }

void write_aligned(std::ostream& os, const std::vector<std::vector<std::string>>& lines)
{
  if (lines.empty())
    return;
  std::vector<std::size_t> widths(lines.front().size(), 0);
  for (const std::vector<std::string>& line : lines)
    for (std::size_t i = 0; i < widths.size(); ++i)
      widths[i] = (std::max)(widths[i], line[i].size());
  for (const std::vector<std::string>& line : lines) {
    os << line[0] << std::string(widths[0] - line[0].size(), ' ');
    for (std::size_t i = 1; i < widths.size(); ++i)
      os << "  " << std::string(widths[i] - line[i].size(), ' ') << line[i];
    os << '\n';
  }
}

} // namespace idt
