// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Files of comma-separated values.

#ifndef IDT_TABLE_H
#define IDT_TABLE_H

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

namespace idt {

// The lines of a file that are neither empty nor comments, as cells. What is wrong is an `Invalid_surface_error` that
// names file and line.
class Table
{
public:
  // \param other_separators that separate cells, too, in lines without a comma
  explicit Table(const std::string& path, const std::string& other_separators = "");

  // Reads a line; returns false at the end.
  bool next();

  std::size_t line() const { return line_; }
  const std::vector<std::string>& cells() const { return cells_; }

  // Whether the first line is no number, but the name of a column.
  bool has_names() const;

  double real(std::size_t i) const; // perhaps not finite
  double number(std::size_t i) const;
  std::uint64_t whole(std::size_t i) const;
  // If the line has another number of cells than there are names.
  void require_size(std::size_t number_of_names) const;

  [[noreturn]] void fail(const std::string& what) const;

private:
  std::string path_, other_separators_;
  std::ifstream file_;
  std::vector<std::string> cells_;
  std::size_t line_ = 0;
};

} // namespace idt

#endif // IDT_TABLE_H
