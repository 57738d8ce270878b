// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/vertex_values.h"

#include "input/Table.h"

#include <limits>
#include <optional>
#include <utility>

namespace idt {
namespace {

// A table whose first line names its elements and its columns, with a line for each element.
class Element_table
{
public:
  // \param number_of_faces none if the table has to be of vertices
  Element_table(const std::string& path, std::size_t number_of_vertices, std::optional<std::size_t> number_of_faces)
    : table_(path)
  {
    if (table_.next())
      names_ = table_.cells();
    if (names_.size() < 2 || (names_[0] != "vertex" && !(names_[0] == "face" && number_of_faces)))
      table_.fail(std::string("the first line of such a table is vertex,NAME") +
                  (number_of_faces ? " or face,NAME" : "") + " or has more names");
    number_of_elements_ = is_of_faces() ? *number_of_faces : number_of_vertices;
  }

  const std::vector<std::string>& names() const { return names_; }
  bool is_of_faces() const { return names_[0] == "face"; }
  std::size_t number_of_elements() const { return number_of_elements_; }
  [[noreturn]] void fail(const std::string& what) const { table_.fail(what); }

  // Calls visit(i, line) for each line.
  template <class F>
  void read(const F& visit)
  {
    std::vector<bool> has_line(number_of_elements_);
    while (table_.next()) {
      table_.require_size(names_.size());
      const std::string& number = table_.cells()[0];
      const double v = table_.real(0);
      if (!(v >= 0 && v < double(number_of_elements_)) || v != double(std::size_t(v)))
        fail("there is no " + names_[0] + ' ' + number + ": the surface has " + std::to_string(number_of_elements_) +
             ", counted from 0");
      if (has_line[std::size_t(v)])
        fail(names_[0] + ' ' + number + " has a line already");
      has_line[std::size_t(v)] = true;
      visit(std::size_t(v), std::as_const(table_));
    }
  }

private:
  Table table_;
  std::size_t number_of_elements_ = 0;
  std::vector<std::string> names_;
};

} // namespace

Element_values read_element_values(const std::string& path, std::size_t number_of_vertices, std::size_t number_of_faces)
{
  Element_table table(path, number_of_vertices, number_of_faces);
  Element_values result;
  result.is_of_faces = table.is_of_faces();
  for (std::size_t column = 1; column < table.names().size(); ++column)
    result.columns.push_back({table.names()[column], std::vector<double>(table.number_of_elements(),
                                                                         std::numeric_limits<double>::quiet_NaN())});
  table.read([&](std::size_t i, const Table& line) {
    for (std::size_t column = 1; column < line.cells().size(); ++column)
      if (!line.cells()[column].empty())
        result.columns[column - 1].values[i] = line.real(column);
  });
  return result;
}

std::map<std::uint32_t, double> read_numbers_of_vertices(const std::string& path, std::size_t number_of_vertices)
{
  Element_table table(path, number_of_vertices, {});
  if (table.names().size() != 2)
    table.fail("the first line of this table is vertex,NAME");
  std::map<std::uint32_t, double> result;
  table.read([&](std::size_t v, const Table& line) { result.emplace(std::uint32_t(v), line.number(1)); });
  if (result.empty())
    table.fail("the table has no vertex");
  return result;
}

} // namespace idt
