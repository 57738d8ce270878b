// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/vertex_values.h"

#include "system/text.h"

#include <CGAL/Intrinsic_triangulations/errors.h>

#include <boost/algorithm/string/split.hpp>

#include <cstdlib>
#include <fstream>
#include <limits>

namespace idt {
namespace {

std::vector<std::string> cells_of(std::string line)
{
  if (!line.empty() && line.back() == '\r')
    line.pop_back();
  std::vector<std::string> cells;
  boost::split(cells, line, [](char c) { return c == ','; });
  return cells;
}

} // namespace

std::vector<Named_values> read_vertex_values(const std::string& path, std::size_t number_of_vertices)
{
  std::size_t line = 0;
  const auto fail = [&](const std::string& what) {
    using CGAL::Intrinsic_triangulations::Invalid_surface_error;
    throw Invalid_surface_error(Invalid_surface_error::Defect::UNREADABLE, line, 1,
                                path + (line > 0 ? ", line " + std::to_string(line) : std::string()) + ": " + what);
  };
  const auto number = [&](const std::string& cell) {
    char* end = nullptr;
    const double x = std::strtod(cell.c_str(), &end);
    if (end == cell.c_str() || *end != '\0')
      fail(quoted(cell) + " is no number");
    return x;
  };
  std::ifstream file(path);
  std::string text;
  if (!file)
    fail("the file cannot be opened");
  ++line;
  std::getline(file, text);
  const std::vector<std::string> names = cells_of(text);
  if (names[0] != "vertex" || names.size() < 2)
    fail("the first line of such a table is vertex,NAME or has more names");
  std::vector<Named_values> result;
  for (std::size_t column = 1; column < names.size(); ++column)
    result.push_back(
      {names[column], std::vector<double>(number_of_vertices, std::numeric_limits<double>::quiet_NaN())});
  std::vector<bool> has_line(number_of_vertices);
  while (std::getline(file, text)) {
    ++line;
    const std::vector<std::string> cells = cells_of(text);
    if (text.empty() || text == "\r")
      continue;
    if (cells.size() != names.size())
      fail("there are " + std::to_string(names.size()) + " names and " + counted(cells.size(), "cell", "cells"));
    const double v = number(cells[0]);
    if (!(v >= 0 && v < double(number_of_vertices)) || v != double(std::size_t(v)))
      fail("there is no vertex " + cells[0] + ": the surface has " + std::to_string(number_of_vertices) +
           ", counted from 0");
    if (has_line[std::size_t(v)])
      fail("vertex " + cells[0] + " has a line already");
    has_line[std::size_t(v)] = true;
    for (std::size_t column = 1; column < cells.size(); ++column)
      if (!cells[column].empty())
        result[column - 1].values[std::size_t(v)] = number(cells[column]);
  }
  if (file.bad())
    fail("the file cannot be read");
  return result;
}

} // namespace idt
