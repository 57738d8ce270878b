// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/formats/text_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace idt {
namespace {

enum class Number_state {
  GOOD,
  NOT_FINITE,
  TOO_LARGE,
  NOT_A_NUMBER
};

Number_state read_number(const std::string& word, double& number)
{
  const char* const begin = word.data() + (word.size() > 1 && word[0] == '+' && word[1] != '-' ? 1 : 0);
  const std::from_chars_result result = std::from_chars(begin, word.data() + word.size(), number);
  if (result.ptr != word.data() + word.size() || result.ec == std::errc::invalid_argument)
    return Number_state::NOT_A_NUMBER;
  if (result.ec == std::errc::result_out_of_range) {
    // Too large or too small: the exponent tells.
    const std::size_t e = word.find_first_of("eE");
    return e != std::string::npos && word[e + 1] == '-' ? Number_state::GOOD : Number_state::TOO_LARGE;
  }
  return std::isfinite(number) ? Number_state::GOOD : Number_state::NOT_FINITE;
}

} // namespace

[[noreturn]] void refuse(const std::string& path, const std::string& text,
                         const Defect defect, const std::size_t element,
                         const std::size_t count)
{
  throw Invalid_surface_error(defect, element, count, path + ": " + text);
}

std::string load(const std::string& path, const std::size_t at_most)
{
  std::ifstream in(path, std::ios::binary);
  std::error_code ignored;
  std::string text((std::min<std::uintmax_t>)(std::filesystem::file_size(path, ignored), at_most), '\0');
  in.read(&text[0], static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  return text;
}

std::string quote(const std::string& text)
{
  std::string quoted = "\"";
  for (const char c : text.substr(0, 40))
    quoted += c >= ' ' && c <= '~' ? c : '?';
  return quoted + (text.size() > 40 ? "...\"" : "\"");
}

namespace {

std::from_chars_result parse_integer(const std::string& word, long long& number)
{
  const bool has_plus = word.size() > 1 && word[0] == '+' && word[1] != '-';
  return std::from_chars(word.data() + has_plus, word.data() + word.size(), number);
}

} // namespace

bool read_integer(const std::string& word, long long& number)
{
  const std::from_chars_result result = parse_integer(word, number);
  return result.ec == std::errc() && result.ptr == word.data() + word.size();
}

bool is_beyond_integers(const std::string& word)
{
  long long number = 0;
  const std::from_chars_result result = parse_integer(word, number);
  return result.ec == std::errc::result_out_of_range && result.ptr == word.data() + word.size();
}

bool is_coordinate(const std::string& word)
{
  double number = 0;
  return read_number(word, number) == Number_state::GOOD;
}

std::string place(const Scanner& scanner, const char* const kind, const std::size_t element)
{
  return "line " + std::to_string(scanner.line()) + " (" + kind + " " + std::to_string(element) + ")";
}

double check_coordinate(const std::string& path, const std::string& word, const std::string& where,
                        const std::size_t vertex)
{
  double number = 0;
  switch (read_number(word, number)) {
  case Number_state::GOOD:
    return number;
  case Number_state::NOT_FINITE:
    refuse(path, where + ": the coordinate " + quote(word) + " is not finite", Defect::NOT_FINITE, vertex);
  case Number_state::TOO_LARGE:
    refuse(path, where + ": the coordinate " + quote(word) + " is too large for a double",
           Defect::OUT_OF_RANGE, vertex);
  case Number_state::NOT_A_NUMBER:
    break;
  }
  std::string with_point = word;
  std::replace(with_point.begin(), with_point.end(), ',', '.');
  const bool has_comma = with_point != word && read_number(with_point, number) == Number_state::GOOD;
  refuse(path, where + ": " + quote(word) + " is not a number" + (has_comma ? ": write a point for the decimal comma" : ""),
         Defect::UNREADABLE, vertex);
}

} // namespace idt
