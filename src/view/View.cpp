// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "view/View.h"

#include "system/Exit_status.h"
#include "system/text.h"
#include "view/page_parts.h"

#include <CGAL/Intrinsic_triangulations/Overlay.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <utility>

namespace idt {
namespace {

namespace IT = CGAL::Intrinsic_triangulations;

// A browser holds a page as a single text of limited length.
constexpr std::size_t largest_number_of_triangles = 3000000;

void check_size(std::size_t number_of_triangles)
{
  if (number_of_triangles > largest_number_of_triangles)
    throw Usage_error("a page shows up to " + with_separators(largest_number_of_triangles) + " triangles, and here " +
                      with_separators(number_of_triangles) +
                      " are to be seen: view a part of the surface, or open the overlay that `idt triangulate "
                      "--overlay F.vtp` writes in ParaView");
}

double cotangent(double opposite, double a, double b, double area)
{
  return area > 0 ? (a * a + b * b - opposite * opposite) / (4 * area) : std::numeric_limits<double>::quiet_NaN();
}

// In single precision, but nonzero numbers stay nonzero.
std::vector<float> with_signs(const std::vector<double>& numbers)
{
  std::vector<float> result;
  for (double x : numbers)
    result.push_back(float(x) == 0 && x != 0 ? float(std::copysign(std::numeric_limits<float>::denorm_min(), x))
                                             : float(x));
  return result;
}

// Lengths and areas are known, in full.
void append_face(View_triangulation& result, const std::array<std::uint32_t, 3>& corners,
                 const std::array<std::uint32_t, 3>& sides, const std::array<double, 3>& lengths, double area)
{
  result.corners.insert(result.corners.end(), corners.begin(), corners.end());
  result.sides.insert(result.sides.end(), sides.begin(), sides.end());
  for (std::size_t i = 0; i < 3; ++i)
    result.cotangents.push_back(float(cotangent(lengths[i], lengths[(i + 1) % 3], lengths[(i + 2) % 3], area)));
}

View_triangulation make_triangulation(const IT::Delta_complex& complex, const IT::Element_numbers& numbers)
{
  View_triangulation result;
  result.number_of_vertices = complex.number_of_vertices();
  for (IT::Face_index f : complex.faces()) {
    std::array<std::uint32_t, 3> corners{}, sides{};
    std::array<double, 3> lengths{};
    IT::Halfedge_index h = complex.halfedge(f);
    for (std::size_t i = 0; i < 3; ++i, h = complex.next(h)) {
      corners[i] = complex.source(h).idx();
      sides[i] = complex.edge(h).idx();
      lengths[i] = numbers.lengths[sides[i]];
    }
    append_face(result, corners, sides, lengths, numbers.areas[f.idx()]);
  }
  result.lengths.assign(numbers.lengths.begin(), numbers.lengths.end());
  result.weights = with_signs(numbers.cotangent_weights);
  return result;
}

using Point = std::array<double, 3>;

double distance(const Point& p, const Point& q) { return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]); }

double area(const Point& p, const Point& q, const Point& r)
{
  const Point u{q[0] - p[0], q[1] - p[1], q[2] - p[2]}, v{r[0] - p[0], r[1] - p[1], r[2] - p[2]};
  return std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2;
}

// Edges are pairs of vertices, in increasing order.
View_triangulation make_triangulation(const std::vector<Point>& points,
                                      const std::vector<std::array<std::uint32_t, 3>>& triangles)
{
  using Edge = std::pair<std::uint32_t, std::uint32_t>;
  const auto edge = [&](std::size_t f, std::size_t i) -> Edge {
    return std::minmax({triangles[f][i], triangles[f][(i + 1) % 3]});
  };
  std::vector<Edge> edges;
  for (std::size_t f = 0; f < triangles.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i)
      edges.push_back(edge(f, i));
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  View_triangulation result;
  result.number_of_vertices = points.size();
  for (const auto& [v, w] : edges)
    result.lengths.push_back(float(distance(points[v], points[w])));
  std::vector<double> weights(edges.size());
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    std::array<std::uint32_t, 3> sides{};
    std::array<double, 3> lengths{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Edge e = edge(f, i);
      sides[i] = std::uint32_t(std::lower_bound(edges.begin(), edges.end(), e) - edges.begin());
      lengths[i] = distance(points[e.first], points[e.second]);
    }
    const auto& [a, b, c] = triangles[f];
    const double face_area = area(points[a], points[b], points[c]);
    append_face(result, triangles[f], sides, lengths, face_area);
    for (std::size_t i = 0; i < 3; ++i)
      weights[sides[i]] += cotangent(lengths[i], lengths[(i + 1) % 3], lengths[(i + 2) % 3], face_area);
  }
  result.weights = with_signs(weights);
  return result;
}

// The number of the side in its face, from 1, or 0 if it is not a side.
std::uint8_t number_of_side(const IT::Delta_complex& complex, IT::Halfedge_index h)
{
  if (!h.is_valid())
    return 0;
  const IT::Halfedge_index first = complex.halfedge(complex.face(h));
  return std::uint8_t(h == first ? 1 : h == complex.next(first) ? 2 : 3);
}

// The faces of the overlay, cut into triangles.
void add_triangles(const IT::Common_subdivision& subdivision, View& view)
{
  const IT::Overlay& overlay = subdivision.overlay();
  std::vector<IT::Overlay::Halfedge> around; // a face; each points to a corner
  std::vector<Point> places;
  view.faces.resize(2);
  for (IT::Overlay::Face f : overlay.faces()) {
    around.clear();
    places.clear();
    IT::Overlay::Halfedge h = overlay.halfedge(f);
    do {
      around.push_back(h);
      places.push_back(view.points[overlay.target(h).idx()]);
      h = overlay.next(h);
    } while (h != around.front());
    const auto add_triangle = [&](const std::array<std::size_t, 3>& triangle) {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t end = triangle[(i + 1) % 3];
        view.corners.push_back(overlay.target(around[triangle[i]]).idx());
        std::uint8_t side = 0; // within the polygon
        if (end == (triangle[i] + 1) % around.size())
          side = std::uint8_t(number_of_side(subdivision.input(), overlay.input_halfedge(around[end])) +
                              4 * number_of_side(subdivision.intrinsic(), overlay.intrinsic_halfedge(around[end])));
        view.sides.push_back(side);
      }
      view.faces[0].push_back(overlay.input_face(f).idx());
      view.faces[1].push_back(overlay.intrinsic_face(f).idx());
    };
    if (around.size() == 3)
      add_triangle({0, 1, 2});
    else
      for (const auto& triangle : IT::triangulate_convex_polygon(places))
        add_triangle(triangle);
  }
}

std::string file_name(const std::string& path) { return std::filesystem::path(path).filename().string(); }

} // namespace

View make_view(const std::string& title, const std::string& result, const IT::Common_subdivision& subdivision,
               std::vector<Point> points, const IT::Element_numbers& input_numbers, const IT::Element_numbers& numbers)
{
  check_size(subdivision.overlay().number_of_faces());
  View view;
  view.title = file_name(title);
  view.result = result;
  view.triangulations.push_back(make_triangulation(subdivision.input(), input_numbers));
  view.triangulations.push_back(make_triangulation(subdivision.intrinsic(), numbers));
  view.points.reserve(subdivision.overlay().number_of_vertices());
  for (IT::Overlay::Vertex v : subdivision.overlay().vertices())
    view.points.push_back(subdivision.point(v, points));
  add_triangles(subdivision, view);
  check_size(view.corners.size() / 3);
  return view;
}

View make_view(const std::string& title, const std::vector<Point>& points,
               const std::vector<std::array<std::uint32_t, 3>>& triangles)
{
  check_size(triangles.size());
  View view;
  view.title = file_name(title);
  view.triangulations.push_back(make_triangulation(points, triangles));
  view.points = points;
  view.corners = view.triangulations[0].corners;
  view.faces.resize(1);
  for (std::uint32_t f = 0; f < triangles.size(); ++f) {
    view.faces[0].push_back(f);
    view.sides.insert(view.sides.end(), {1, 2, 3});
  }
  return view;
}

void check_view(const std::string& path, std::size_t number_of_triangles)
{
  if (path.empty())
    return;
  if (std::string(page_three).empty())
    throw Usage_error(path +
                      ": this command was built without three.js, which draws: install libjs-three, and build it "
                      "again");
  const std::string type = std::filesystem::path(path).extension().string();
  if (!type.empty() && type != ".html" && type != ".htm")
    throw Usage_error(path + ": a page is an .html file");
  check_size(number_of_triangles);
}

} // namespace idt
