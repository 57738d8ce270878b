// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/vertex_values.h"

#include "system/text.h"

#include <CGAL/Intrinsic_triangulations/errors.h>

#include <boost/algorithm/string/split.hpp>

#include <cstdlib>
#include <fstream>
#include <limits>
#include <optional>

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

Element_values read_values(const std::string& path, std::size_t number_of_vertices,
                           std::optional<std::size_t> number_of_faces)
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
  const std::string& kind = names[0];
  Element_values result;
  result.is_of_faces = kind == "face" && number_of_faces;
  if ((kind != "vertex" && !result.is_of_faces) || names.size() < 2)
    fail(std::string("the first line of such a table is vertex,NAME") + (number_of_faces ? " or face,NAME" : "") +
         " or has more names");
  const std::size_t number_of_elements = result.is_of_faces ? *number_of_faces : number_of_vertices;
  for (std::size_t column = 1; column < names.size(); ++column)
    result.columns.push_back(
      {names[column], std::vector<double>(number_of_elements, std::numeric_limits<double>::quiet_NaN())});
  std::vector<bool> has_line(number_of_elements);
  while (std::getline(file, text)) {
    ++line;
    const std::vector<std::string> cells = cells_of(text);
    if (text.empty() || text == "\r")
      continue;
    if (cells.size() != names.size())
      fail("there are " + std::to_string(names.size()) + " names and " + counted(cells.size(), "cell", "cells"));
    const double v = number(cells[0]);
    if (!(v >= 0 && v < double(number_of_elements)) || v != double(std::size_t(v)))
      fail("there is no " + kind + ' ' + cells[0] + ": the surface has " + std::to_string(number_of_elements) +
           ", counted from 0");
    if (has_line[std::size_t(v)])
      fail(kind + ' ' + cells[0] + " has a line already");
    has_line[std::size_t(v)] = true;
    for (std::size_t column = 1; column < cells.size(); ++column)
      if (!cells[column].empty())
        result.columns[column - 1].values[std::size_t(v)] = number(cells[column]);
  }
  if (file.bad())
    fail("the file cannot be read");
  return result;
}

} // namespace

Element_values read_element_values(const std::string& path, std::size_t number_of_vertices, std::size_t number_of_faces)
{
  return read_values(path, number_of_vertices, number_of_faces);
}

std::vector<Named_values> read_vertex_values(const std::string& path, std::size_t number_of_vertices)
{
  return read_values(path, number_of_vertices, {}).columns;
}

} // namespace idt
