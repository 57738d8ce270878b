// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/place_files.h"

#include "system/text.h"

#include <CGAL/Intrinsic_triangulations/errors.h>

#include <boost/algorithm/string/split.hpp>

#include <cmath>
#include <cstdlib>
#include <fstream>

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

} // namespace

std::vector<std::vector<Place>> read_places(const std::string& path)
{
  std::vector<std::vector<Place>> result;
  Place::Kind kind = Place::IN_SPACE;
  for (Table table(path); table.next();) {
    const std::string& first = table.cells()[0];
    if (first == "x" || first == "input_face" || first == "face") {
      kind = first == "x" ? Place::IN_SPACE : first == "face" ? Place::BETWEEN_VERTICES : Place::IN_FACE;
      result.emplace_back();
      continue;
    }
    if (result.empty())
      table.fail("the first line of such a table is x,y,z or input_face,b0,b1,b2, or that of `idt geodesic`");
    Place place{kind, {}, 0, {}, table.line()};
    std::size_t at = 0;
    if (kind != Place::IN_SPACE)
      place.face = table.whole(at++);
    if (kind == Place::BETWEEN_VERTICES)
      for (std::uint64_t& v : place.corners)
        v = table.whole(at++);
    for (double& x : place.numbers)
      x = table.number(at++);
    result.back().push_back(place);
  }
  return result;
}

std::vector<std::pair<std::uint64_t, std::uint64_t>> read_vertex_pairs(const std::string& path)
{
  std::vector<std::pair<std::uint64_t, std::uint64_t>> result;
  for (Table table(path); table.next();) {
    if (table.cells().size() != 2)
      table.fail("expected are two vertices");
    if (result.empty() && table.line() == 1 && table.cells()[0].find_first_not_of("0123456789 ") != std::string::npos)
      continue; // the names of the columns
    result.emplace_back(table.whole(0), table.whole(1));
  }
  return result;
}

} // namespace idt
