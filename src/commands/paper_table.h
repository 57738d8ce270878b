// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef IDT_PAPER_TABLE_H
#define IDT_PAPER_TABLE_H

#include <cstdint>
#include <optional>
#include <string>

namespace idt {

// A row of Table 1 in Fisher, Springborn, Schroeder, Bobenko (2006).
struct Paper_row
{
  const char* model;
  std::uint64_t vertices;
  std::uint64_t flips;
  std::uint64_t simple;
  std::uint64_t longest;
  double condition_ratio;
  std::optional<std::uint64_t> crossings; // the paper does not give all
};

// The row of a model, which is known by its name and its number of vertices, or none.
const Paper_row* find_paper_row(const std::string& model, std::uint64_t vertices);

} // namespace idt

#endif // IDT_PAPER_TABLE_H
