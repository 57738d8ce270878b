// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A piece of a file as it can stand in a message.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_SHOWN_TEXT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_SHOWN_TEXT_H

#include <cstddef>
#include <cstdint>
#include <string>

namespace CGAL::Intrinsic_triangulations::internal {

// The contents of a file may control a terminal, or be long.
std::string shown_text(const std::string& text);

// "1 vertex", "2 vertices"
std::string counted(const std::uintmax_t n, const char* const singular, const char* const plural);
// "is 1 vertex", "are 2 vertices"
std::string are_counted(const std::uintmax_t n, const char* const singular, const char* const plural);

// A -1 that was converted to std::size_t, or to 32 bits, is shown as -1.
std::string index_text(const std::size_t value);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_SHOWN_TEXT_H
