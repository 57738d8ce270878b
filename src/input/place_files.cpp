// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/place_files.h"

#include "system/text.h"

#include <CGAL/Intrinsic_triangulations/errors.h>

#include <boost/algorithm/string/split.hpp>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <utility>

namespace idt {
namespace {

// The lines of a file that are not empty, as cells.
class Table
{
public:
  explicit Table(const std::string& path) : path_(path), file_(path)
  {
    if (!file_)
      fail("the file cannot be opened");
  }

  bool next()
  {
    for (std::string text; std::getline(file_, text);) {
      ++line_;
      if (!text.empty() && text.back() == '\r')
        text.pop_back();
      if (text.empty() || text[0] == '#')
        continue;
      boost::split(cells_, text, [](char c) { return c == ','; });
      return true;
    }
    if (file_.bad())
      fail("the file cannot be read");
    return false;
  }

  std::size_t line() const { return line_; }
  const std::vector<std::string>& cells() const { return cells_; }

  // Whether the first line is no number, but the name of a column.
  bool has_names() const { return line_ == 1 && cells_[0].find_first_not_of("0123456789 ") != std::string::npos; }

  double number(std::size_t i) const
  {
    if (i >= cells_.size())
      fail("a number is missing");
    char* end = nullptr;
    const double x = std::strtod(cells_[i].c_str(), &end);
    if (end == cells_[i].c_str() || *end != '\0' || !std::isfinite(x))
      fail(quoted(cells_[i]) + " is no finite number");
    return x;
  }
  std::uint64_t whole(std::size_t i) const
  {
    const double x = number(i);
    if (!(x >= 0 && x < 0x1p53) || x != std::floor(x))
      fail(quoted(cells_[i]) + " is no whole number");
    return std::uint64_t(x);
  }

  [[noreturn]] void fail(const std::string& what) const
  {
    using CGAL::Intrinsic_triangulations::Invalid_surface_error;
    throw Invalid_surface_error(Invalid_surface_error::Defect::UNREADABLE, line_, 1,
                                path_ + (line_ > 0 ? ", line " + std::to_string(line_) : std::string()) + ": " + what);
  }

private:
  std::string path_;
  std::ifstream file_;
  std::vector<std::string> cells_;
  std::size_t line_ = 0;
};

// That the last table is not empty, as that of a curve which was shrunk to a point is.
void require_points(const Table& table, const std::vector<std::vector<Place>>& read)
{
  if (!read.empty() && read.back().empty())
    table.fail("the table before this line has no point");
}

} // namespace

std::vector<std::vector<Place>> read_places(const std::string& path)
{
  std::vector<std::vector<Place>> result;
  Place::Kind kind = Place::IN_SPACE;
  std::string last_line; // its number
  std::size_t begin = 0, number_of_cells = 0;
  Table table(path);
  while (table.next()) {
    const std::string& first = table.cells()[0];
    if (first == "x" || first == "input_face" || first == "face" || first == "line") {
      require_points(table, result);
      number_of_cells = table.cells().size();
      kind = first == "x" ? Place::IN_SPACE : first == "input_face" ? Place::IN_FACE : Place::BETWEEN_VERTICES;
      begin = first == "line" ? 1 : 0;
      last_line.clear();
      result.emplace_back();
      continue;
    }
    if (begin == 1 && std::exchange(last_line, first) != first && !result.empty() && !result.back().empty())
      result.emplace_back();
    if (result.empty())
      table.fail("the first line of such a table is x,y,z or input_face,b0,b1,b2, or that of `idt geodesic`");
    if (table.cells().size() != number_of_cells)
      table.fail("there are " + std::to_string(number_of_cells) + " names and " +
                 counted(table.cells().size(), "cell", "cells"));
    Place place{kind, {}, 0, {}, table.line()};
    std::size_t at = begin;
    if (kind != Place::IN_SPACE)
      place.face = table.whole(at++);
    if (kind == Place::BETWEEN_VERTICES)
      for (std::uint64_t& v : place.corners)
        v = table.whole(at++);
    for (double& x : place.numbers)
      x = table.number(at++);
    result.back().push_back(place);
  }
  if (result.empty())
    table.fail("the file is empty");
  require_points(table, result);
  return result;
}

std::vector<std::pair<std::uint64_t, std::uint64_t>> read_vertex_pairs(const std::string& path)
{
  std::vector<std::pair<std::uint64_t, std::uint64_t>> result;
  Table table(path);
  while (table.next()) {
    if (table.cells().size() != 2)
      table.fail("expected are two vertices");
    if (!table.has_names())
      result.emplace_back(table.whole(0), table.whole(1));
  }
  if (result.empty())
    table.fail("the file has no pair of vertices");
  return result;
}

std::vector<std::uint64_t> read_vertices(const std::string& path)
{
  std::vector<std::uint64_t> result;
  Table table(path);
  while (table.next()) {
    if (table.cells().size() != 1)
      table.fail("expected is one vertex");
    if (!table.has_names())
      result.push_back(table.whole(0));
  }
  if (result.empty())
    table.fail("the file has no vertex");
  return result;
}

} // namespace idt
