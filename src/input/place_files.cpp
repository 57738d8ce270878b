// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/place_files.h"

#include "input/Table.h"

#include <array>
#include <cmath>
#include <utility>

namespace idt {
namespace {

// That the last table is not empty, as that of a curve which was shrunk to a point is.
void require_points(const Table& table, const std::vector<std::vector<Place>>& read)
{
  if (!read.empty() && read.back().empty())
    table.fail("the table before this line has no point");
}

void require_barycentric(const Table& table, const std::array<double, 3>& numbers)
{
  const double sum = numbers[0] + numbers[1] + numbers[2];
  if (!(numbers[0] >= 0 && numbers[1] >= 0 && numbers[2] >= 0 && sum > 0 && std::isfinite(sum)))
    table.fail("barycentric coordinates are not negative, and their sum is positive");
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
    table.require_size(number_of_cells);
    Place place{kind, {}, 0, {}, table.line()};
    std::size_t at = begin;
    if (kind != Place::IN_SPACE)
      place.face = table.whole(at++);
    if (kind == Place::BETWEEN_VERTICES)
      for (std::uint64_t& v : place.corners)
        v = table.whole(at++);
    for (double& x : place.numbers)
      x = table.number(at++);
    if (kind != Place::IN_SPACE)
      require_barycentric(table, place.numbers);
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
  Table table(path, " \t;"); // as the files of --constraints
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
