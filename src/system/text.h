// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers as text.

#ifndef IDT_TEXT_H
#define IDT_TEXT_H

#include <cstdint>
#include <array>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace idt {

// "1234567" becomes "1,234,567".
std::string with_separators(std::uint64_t number);

// "1 face", "2 faces"
std::string counted(std::uint64_t number, const char* singular, const char* plural);

// A piece of a file in quotes, which may be long or contain control characters.
std::string quoted(const std::string& text);

// With 17 significant digits, which restore a double bit for bit.
std::string in_full(double number);

// With a few digits, for people.
std::string in_short(double number);
// Rounded upward or downward, so that what is proven of the number is true of the text.
std::string in_short_not_below(double number);
std::string in_short_not_above(double number);
std::string in_short(const std::array<double, 3>& point);

// "0.012 s"
std::string seconds_text(double seconds);

// A cell of a table: "-" if unknown.
std::string cell(const std::optional<std::uint64_t>& number);
std::string cell(const std::optional<double>& number);

// A table: the first column is aligned to the left, the others to the right. \pre all lines have as many cells as the
// first
void write_aligned(std::ostream& os, const std::vector<std::vector<std::string>>& lines);

} // namespace idt

#endif // IDT_TEXT_H
