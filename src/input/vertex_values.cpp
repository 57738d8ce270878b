// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/vertex_values.h"

#include "system/text.h"

#include <CGAL/Intrinsic_triangulations/errors.h>

#include <boost/algorithm/string/split.hpp>

#include <cmath>
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

class Element_table
{
public:
  // \param number_of_faces none if the table has to be of vertices
  Element_table(const std::string& path, std::size_t number_of_vertices, std::optional<std::size_t> number_of_faces)
    : path_(path), file_(path)
  {
    if (!file_)
      fail("the file cannot be opened");
    ++line_;
    std::string text;
    std::getline(file_, text);
    names_ = cells_of(text);
    if ((names_[0] != "vertex" && !(names_[0] == "face" && number_of_faces)) || names_.size() < 2)
      fail(std::string("the first line of such a table is vertex,NAME") + (number_of_faces ? " or face,NAME" : "") +
           " or has more names");
    number_of_elements_ = is_of_faces() ? *number_of_faces : number_of_vertices;
  }

  const std::vector<std::string>& names() const { return names_; }
  bool is_of_faces() const { return names_[0] == "face"; }
  std::size_t number_of_elements() const { return number_of_elements_; }

  // Calls visit(i, cells) for each line.
  template <class F>
  void read(const F& visit)
  {
    std::vector<bool> has_line(number_of_elements_);
    for (std::string text; std::getline(file_, text);) {
      ++line_;
      const std::vector<std::string> cells = cells_of(text);
      if (text.empty() || text == "\r")
        continue;
      if (cells.size() != names_.size())
        fail("there are " + std::to_string(names_.size()) + " names and " + counted(cells.size(), "cell", "cells"));
      const double v = number(cells[0]);
      if (!(v >= 0 && v < double(number_of_elements_)) || v != double(std::size_t(v)))
        fail("there is no " + names_[0] + ' ' + cells[0] + ": the surface has " + std::to_string(number_of_elements_) +
             ", counted from 0");
      if (has_line[std::size_t(v)])
        fail(names_[0] + ' ' + cells[0] + " has a line already");
      has_line[std::size_t(v)] = true;
      visit(std::size_t(v), cells);
    }
    if (file_.bad())
      fail("the file cannot be read");
  }

  double number(const std::string& cell) const
  {
    char* end = nullptr;
    const double x = std::strtod(cell.c_str(), &end);
    if (end == cell.c_str() || *end != '\0')
      fail(quoted(cell) + " is no number");
    return x;
  }
  [[noreturn]] void fail(const std::string& what) const
  {
    using CGAL::Intrinsic_triangulations::Invalid_surface_error;
    throw Invalid_surface_error(Invalid_surface_error::Defect::UNREADABLE, line_, 1,
                                path_ + (line_ > 0 ? ", line " + std::to_string(line_) : std::string()) + ": " + what);
  }

private:
  std::string path_;
  std::size_t number_of_elements_ = 0, line_ = 0;
  std::ifstream file_;
  std::vector<std::string> names_;
};

Element_values read_values(Element_table table)
{
  Element_values result;
  result.is_of_faces = table.is_of_faces();
  for (std::size_t column = 1; column < table.names().size(); ++column)
    result.columns.push_back({table.names()[column], std::vector<double>(table.number_of_elements(),
                                                                         std::numeric_limits<double>::quiet_NaN())});
  table.read([&](std::size_t i, const std::vector<std::string>& cells) {
    for (std::size_t column = 1; column < cells.size(); ++column)
      if (!cells[column].empty())
        result.columns[column - 1].values[i] = table.number(cells[column]);
  });
  return result;
}

} // namespace

Element_values read_element_values(const std::string& path, std::size_t number_of_vertices, std::size_t number_of_faces)
{
  return read_values({path, number_of_vertices, number_of_faces});
}

std::vector<Named_values> read_vertex_values(const std::string& path, std::size_t number_of_vertices)
{
  return read_values({path, number_of_vertices, {}}).columns;
}

std::map<std::uint32_t, double> read_numbers_of_vertices(const std::string& path, std::size_t number_of_vertices)
{
  Element_table table(path, number_of_vertices, {});
  if (table.names().size() != 2)
    table.fail("the first line of this table is vertex,NAME");
  std::map<std::uint32_t, double> result;
  table.read([&](std::size_t v, const std::vector<std::string>& cells) {
    const double x = table.number(cells[1]);
    if (!std::isfinite(x))
      table.fail(quoted(cells[1]) + " is no finite number");
    result.emplace(std::uint32_t(v), x);
  });
  if (result.empty())
    table.fail("the table has no vertex");
  return result;
}

} // namespace idt
