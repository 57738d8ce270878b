// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/constraints.h"

#include "input/formats/vtp.h"
#include "input/standard_input.h"
#include "system/text.h"

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/errors.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <map>
#include <optional>
#include <set>
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
    : path_(path), surface_(surface), complex_(surface.connectivity)
  {}

  std::vector<bool> operator()()
  {
    std::ifstream file(path_);
    if (!file)
      fail("the file cannot be opened");
    bool is_line = false;
    for (std::string text; std::getline(file, text);) {
      ++line_;
      std::replace_if(
        text.begin(), text.end(), [](char c) { return c == ',' || c == ';' || c == '\r' || c == '\t'; }, ' ');
      std::istringstream words(text);
      std::string first;
      if (!(words >> first) || first[0] == '#')
        continue;
      if (first == "face") {
        is_line = true;
        last_.reset();
      } else if (is_line) {
        add_point(numbers<7>(text, "a face, three vertices and three coordinates, as `idt geodesic` writes them"));
      } else {
        const auto pair = numbers<2>(text, "two vertices");
        constrain(vertex(pair[0]), vertex(pair[1]));
      }
    }
    if (file.bad())
      fail("the file cannot be read");
    std::vector<bool> result(complex_.number_of_edges());
    for (IT::Edge_index e : edges_)
      result[e.idx()] = true;
    return result;
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

  // A halfedge from v to w, if there is one.
  std::optional<IT::Halfedge_index> halfedge(IT::Vertex_index v, IT::Vertex_index w) const
  {
    for (IT::Halfedge_index h : IT::internal::Halfedges_around(complex_, v))
      if (complex_.source(h) == w)
        return complex_.opposite(h);
    return std::nullopt;
  }
  void constrain(IT::Vertex_index v, IT::Vertex_index w)
  {
    const auto h = halfedge(v, w);
    if (!h)
      fail("no edge joins vertex " + std::to_string(v.idx()) + " and vertex " + std::to_string(w.idx()));
    edges_.insert(complex_.edge(*h));
  }

  // A point of a line: a vertex, or inside an edge or a face, which is split there.
  void add_point(const std::array<double, 7>& row)
  {
    std::vector<std::pair<IT::Vertex_index, double>> corners;
    for (std::size_t i = 0; i < 3; ++i)
      if (row[4 + i] > 0)
        corners.emplace_back(vertex(row[1 + i]), row[4 + i]);
    if (corners.empty())
      fail("the coordinates are not positive");
    const IT::Vertex_index v = corners.size() == 1   ? corners[0].first
                               : corners.size() == 2 ? on_edge(corners)
                                                     : in_face(corners);
    if (last_ && *last_ != v)
      constrain(*last_, v);
    last_ = v;
  }
  IT::Vertex_index on_edge(const std::vector<std::pair<IT::Vertex_index, double>>& corners)
  {
    if (const auto known = cuts_.find({corners[0].first, corners[1].first}); known != cuts_.end()) {
      if (known->second.second != corners[1].second)
        fail("the edge is crossed a second time: a line may cross each edge once");
      return known->second.first;
    }
    const auto h = halfedge(corners[0].first, corners[1].first);
    if (!h || complex_.is_self_glued(complex_.edge(*h)))
      fail("no edge joins vertex " + std::to_string(corners[0].first.idx()) + " and vertex " +
           std::to_string(corners[1].first.idx()));
    const IT::Vertex_index v = complex_.split_edge(*h);
    const bool is_kept = edges_.count(complex_.edge(*h)) != 0;
    add_place(corners);
    if (is_kept)
      constrain(v, corners[1].first);
    cuts_[{corners[0].first, corners[1].first}] = {v, corners[1].second};
    cuts_[{corners[1].first, corners[0].first}] = {v, corners[0].second};
    return v;
  }
  // The end of a line that has entered the face with these corners through a vertex or across a side.
  IT::Vertex_index in_face(const std::vector<std::pair<IT::Vertex_index, double>>& corners)
  {
    auto side = side_of_face(corners[0].first, corners[1].first, corners[2].first);
    for (std::size_t i = 0; i < 6 && !side; ++i) {
      const auto& [x, at_x] = corners[i % 3];
      const auto& [y, at_y] = corners[(i + 1 + i / 3) % 3];
      const auto cut = cuts_.find({x, y});
      if (cut != cuts_.end() && cut->second.first == last_ &&
          at_y * (1 - cut->second.second) > at_x * cut->second.second)
        side = side_of_face(*last_, y, corners[(i + 2 - i / 3) % 3].first);
    }
    if (!side)
      fail("a line ends in a face that was cut before: let it end on an edge");
    const IT::Vertex_index v = complex_.split_face(*side);
    add_place(corners);
    return v;
  }
  // A side of the face with these corners, in either order.
  std::optional<IT::Halfedge_index> side_of_face(IT::Vertex_index a, IT::Vertex_index b, IT::Vertex_index c) const
  {
    if (const auto side = halfedge(a, b))
      for (IT::Halfedge_index h : {*side, complex_.opposite(*side)})
        if (!complex_.is_border(h) && complex_.target(complex_.next(h)) == c)
          return h;
    return std::nullopt;
  }
  void add_place(const std::vector<std::pair<IT::Vertex_index, double>>& corners)
  {
    double sum = 0;
    for (const auto& [v, x] : corners)
      sum += x;
    std::array<double, 3> place{};
    for (const auto& [v, x] : corners)
      for (std::size_t axis = 0; axis < 3; ++axis)
        place[axis] += x / sum * surface_.points[v.idx()][axis];
    surface_.points.push_back(place);
  }

  const std::string& path_;
  Surface& surface_;
  IT::Delta_complex& complex_;
  std::size_t line_ = 0;
  std::set<IT::Edge_index> edges_;
  std::optional<IT::Vertex_index> last_; // of the current line
  // The vertex on an edge that was cut, and its coordinate at the second end.
  std::map<std::pair<IT::Vertex_index, IT::Vertex_index>, std::pair<IT::Vertex_index, double>> cuts_;
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
