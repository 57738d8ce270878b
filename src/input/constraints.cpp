// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/constraints.h"

#include "input/formats/vtp.h"
#include "input/standard_input.h"
#include "system/text.h"

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/surface_features.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <utility>

namespace idt {
namespace {

namespace IT = CGAL::Intrinsic_triangulations;

// The lines of a file of constraints, and edges of a surface that they name.
class Constraint_reader
{
public:
  Constraint_reader(const std::string& path, Surface& surface)
    : path_(path), complex_(surface.connectivity), divider_(surface.connectivity, surface.points)
  {}

  std::vector<bool> operator()()
  {
    std::ifstream file(path_);
    if (!file)
      fail("the file cannot be opened");
    bool is_line = false;
    for (std::string text; std::getline(file, text);) {
      if (++line_ == 1 && text.compare(0, 3, "\xef\xbb\xbf") == 0) // the byte order mark of spreadsheets
        text.erase(0, 3);
      std::replace_if(
        text.begin(), text.end(), [](char c) { return c == ',' || c == ';' || c == '\r' || c == '\t'; }, ' ');
      std::istringstream words(text);
      std::string first;
      if (!(words >> first) || first[0] == '#')
        continue;
      if (first == "face") {
        is_line = true;
        divider_.begin_line();
      } else if (is_line) {
        add_point(numbers<7>(text, "a face, three vertices and three coordinates, as `idt geodesic` writes them"));
      } else {
        const auto pair = numbers<2>(text, "two vertices");
        divide([&] { divider_.add_edge(vertex(pair[0]), vertex(pair[1])); });
      }
    }
    if (file.bad())
      fail("the file cannot be read");
    return divider_.edges();
  }

private:
  [[noreturn]] void fail(const std::string& what) const
  {
    throw IT::Invalid_surface_error(IT::Invalid_surface_error::Defect::UNREADABLE, line_, 1,
                                    path_ + (line_ > 0 ? ", line " + std::to_string(line_) : std::string()) + ": " +
                                      what);
  }

  template <std::size_t n>
  std::array<double, n> numbers(const std::string& text, const char* what) const
  {
    std::istringstream in(text);
    std::array<double, n> result{};
    for (double& x : result)
      if (!(in >> x))
        fail(std::string("expected are ") + what);
    std::string rest;
    if (n == 2 && in >> rest)
      fail(std::string("expected are ") + what + ", and nothing behind them");
    return result;
  }
  IT::Vertex_index vertex(double number) const
  {
    if (!(number >= 0 && number < double(complex_.number_of_vertices())) || number != double(std::uint32_t(number)))
      fail("there is no vertex " + in_full(number) + ": the surface has " +
           std::to_string(complex_.number_of_vertices()) + ", counted from 0");
    return IT::Vertex_index(std::uint32_t(number));
  }

  // A point of a line, given by a face, its vertices and coordinates.
  void add_point(const std::array<double, 7>& row)
  {
    std::vector<std::pair<IT::Vertex_index, double>> corners;
    for (std::size_t i = 0; i < 3; ++i)
      if (row[4 + i] > 0)
        corners.emplace_back(vertex(row[1 + i]), row[4 + i]);
    if (corners.empty())
      fail("the coordinates are not positive");
    divide([&] { divider_.add_point(corners); });
  }
  template <class Divide>
  void divide(const Divide& divide) const
  {
    try {
      divide();
    } catch (const IT::Invalid_point_error& error) {
      fail(error.what());
    }
  }

  const std::string& path_;
  IT::Delta_complex& complex_;
  IT::Line_divider divider_;
  std::size_t line_ = 0;
};

} // namespace

std::vector<bool> read_constraints(const std::string& path, Surface& surface)
{
  if (!surface.has_points())
    refuse_file(surface.path, "--constraints needs a surface in space, but this one has only edge lengths");
  return Constraint_reader(path, surface)();
}

void write_constraints(std::ostream& os, const std::string& path, const Surface& surface,
                       const std::vector<bool>& is_constrained)
{
  const IT::Delta_complex& complex = surface.connectivity;
  const bool are_lines = find_mesh_format(path) == Mesh_format::VTP;
  Flat_polygons lines;
  if (!are_lines)
    os << "# vertices of edges that are kept\n";
  for (IT::Edge_index e : complex.edges())
    if (e.idx() < is_constrained.size() && is_constrained[e.idx()]) {
      const std::uint32_t v = complex.source(complex.halfedge(e)).idx(), w = complex.target(complex.halfedge(e)).idx();
      if (!are_lines)
        os << v << ',' << w << '\n';
      lines.add(std::array<std::uint32_t, 2>{v, w});
    }
  if (are_lines)
    write_vtp(os, surface.points, Flat_polygons(), {}, lines);
}

} // namespace idt
