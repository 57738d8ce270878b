// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lines at a distance, offset curves and the borders of cells.

#include "curve_surfaces.h"

#include <CGAL/Intrinsic_triangulations/farthest_vertices.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/geodesic_distances.h>
#include <CGAL/Intrinsic_triangulations/isolines.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/sides_of_curve.h>
#include <CGAL/Intrinsic_triangulations/trace_geodesic.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace curve_surfaces;
namespace IT = CGAL::Intrinsic_triangulations;
using IT::Face_index;
using IT::Halfedge_index;
using IT::Surface_point;
using IT::Vertex_index;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;
using Point = std::array<double, 3>;
using Points = std::vector<Point>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;
using Curve = std::vector<Surface_point>;
using Distance = std::function<double(const Point&)>;

constexpr double pi = 3.14159265358979323846;

// From (-1, -1, -1) to (1, 1, 1), each side a grid of triangles.
Mesh cube(std::uint32_t n)
{
  Mesh result;
  std::map<Point, std::uint32_t> numbers;
  const auto vertex = [&](const Point& p) {
    const auto [place, is_new] = numbers.insert({p, std::uint32_t(result.points.size())});
    if (is_new)
      result.points.push_back(p);
    return place->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (double side : {-1., 1.})
      for (std::uint32_t y = 0; y < n; ++y)
        for (std::uint32_t x = 0; x < n; ++x) {
          const auto at = [&](std::uint32_t i, std::uint32_t j) {
            Point p;
            p[axis] = side;
            p[(axis + 1) % 3] = 2. * i / n - 1;
            p[(axis + 2) % 3] = side * (2. * j / n - 1);
            return vertex(p);
          };
          result.triangles.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
          result.triangles.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
        }
  return result;
}

// A pyramid without base: the apex first, then n corners at the distance 1 from it.
Mesh cone(std::uint32_t n, double height)
{
  Mesh result{{{0, 0, height}}, {}};
  const double radius = std::sqrt(1 - height * height);
  for (std::uint32_t i = 0; i < n; ++i) {
    result.points.push_back({radius * std::cos(2 * pi * i / n), radius * std::sin(2 * pi * i / n), 0});
    result.triangles.push_back({0, i + 1, (i + 1) % n + 1});
  }
  return result;
}

auto options(double tolerance, double deviation)
{
  return CGAL::parameters::tolerance(tolerance).maximum_deviation(deviation);
}

double between(const Point& p, const Point& q) { return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]); }

double to_segment(const Point& p, const Point& a, const Point& b)
{
  double square = 0, product = 0;
  for (int i = 0; i < 3; ++i) {
    square += (b[i] - a[i]) * (b[i] - a[i]);
    product += (p[i] - a[i]) * (b[i] - a[i]);
  }
  const double at = square > 0 ? (std::min)((std::max)(product / square, 0.), 1.) : 0;
  return between(p, {a[0] + at * (b[0] - a[0]), a[1] + at * (b[1] - a[1]), a[2] + at * (b[2] - a[2])});
}

Points in_space(const Mesh& mesh, const Triangulation& triangulation, const Curve& curve)
{
  Points result;
  for (const Surface_point& p : curve)
    result.push_back(IT::point_in_space(triangulation.input(), mesh.points, p));
  return result;
}

bool is_on_border(const IT::Delta_complex& input, const Surface_point& p)
{
  if (p.dimension() == 2)
    return false;
  if (p.dimension() == 1) {
    Halfedge_index h = p.halfedge;
    for (int i = 0; p.coordinates[std::size_t(i + 2) % 3] > 0; ++i)
      h = input.next(h);
    return input.is_border(input.opposite(h));
  }
  for (Halfedge_index h : input.halfedges())
    if (input.is_border(h)) {
      Halfedge_index corner = p.halfedge;
      for (int i = 0; !(p.coordinates[std::size_t(i)] > 0); ++i)
        corner = input.next(corner);
      if (input.source(h) == input.source(corner))
        return true;
    }
  return false;
}

// Lines are closed or end on the border, and a source can be made of each of them.
void expect_proper(const Mesh& mesh, const Triangulation& triangulation, const IT::Surface_lines& found)
{
  EXPECT_TRUE(found.is_complete);
  double size = 0;
  for (const Point& p : mesh.points)
    size = (std::max)(size, between(p, mesh.points.front()));
  for (const IT::Surface_line& line : found.lines) {
    ASSERT_GT(line.points.size(), 1u);
    const Points points = in_space(mesh, triangulation, line.points);
    if (between(points.front(), points.back()) > 1e-13 * size) {
      EXPECT_TRUE(is_on_border(triangulation.input(), line.points.front()));
      EXPECT_TRUE(is_on_border(triangulation.input(), line.points.back()));
    }
    EXPECT_NO_THROW(IT::geodesic_distances_from(triangulation, {{{line.points}}}, CGAL::parameters::maximum_number(1)));
  }
}

// Points have their distance, and points of chords have it up to the deviation.
void expect_distances(const Mesh& mesh, const Triangulation& triangulation, const IT::Surface_lines& found,
                      const Distance& distance, double accuracy)
{
  for (const IT::Surface_line& line : found.lines) {
    const Points points = in_space(mesh, triangulation, line.points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      ASSERT_NEAR(distance(points[i]), std::abs(line.distance), accuracy) << i;
      for (double t : {0.1, 0.5, 0.8})
        if (i + 1 < points.size()) {
          Point p;
          for (std::size_t k = 0; k < 3; ++k)
            p[k] = (1 - t) * points[i][k] + t * points[i + 1][k];
          ASSERT_NEAR(distance(p), std::abs(line.distance), found.maximum_deviation + accuracy) << i;
        }
    }
  }
}

double length(const Mesh& mesh, const Triangulation& triangulation, const std::vector<IT::Surface_line>& lines)
{
  double result = 0;
  for (const IT::Surface_line& line : lines) {
    const Points points = in_space(mesh, triangulation, line.points);
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      result += between(points[i], points[i + 1]);
  }
  return result;
}

TEST(Isolines, circles_in_a_plane)
{
  const Mesh mesh = shaken_plane(20, 20);
  const Triangulation triangulation = mesh.Delaunay();
  const IT::Delta_complex& input = triangulation.input();
  const Halfedge_index h = input.halfedge(Face_index(410));
  for (const Surface_point& source :
       {Surface_point{h, {1, 0, 0}}, Surface_point{h, {0.5, 0.5, 0}}, Surface_point{h, {0.2, 0.5, 0.3}}}) {
    const Point center = IT::point_in_space(input, mesh.points, source);
    for (double tolerance : {0., 0.001}) {
      const auto found = IT::isolines(triangulation, {{{{source}}}}, {0.01, 0.5, 5, 12, 50}, options(tolerance, 1e-4));
      expect_proper(mesh, triangulation, found);
      expect_distances(
        mesh, triangulation, found, [&](const Point& p) { return between(p, center); },
        tolerance == 0 ? 1e-13 * 30 : 1e-3 * 30);
      for (double d : {0.01, 0.5, 5.}) {
        std::vector<IT::Surface_line> at;
        std::copy_if(found.lines.begin(), found.lines.end(), std::back_inserter(at),
                     [d](const IT::Surface_line& line) { return line.distance == d; });
        ASSERT_EQ(at.size(), 1u) << d;
        if (tolerance == 0) {
          EXPECT_NEAR(length(mesh, triangulation, at), 2 * pi * d, 2e-2 * d);
        }
      }
      EXPECT_EQ(found.lines.back().distance, 12);
    }
  }
}

TEST(Isolines, finer_chords)
{
  const Mesh mesh = shaken_plane(20, 20);
  const Triangulation triangulation = mesh.Delaunay();
  const Vertex_index center(220);
  std::size_t last = 0;
  for (double deviation : {1e-2, 1e-4, 1e-6}) {
    const auto found =
      IT::isolines(triangulation, {IT::source_at_vertex(triangulation.input(), center)}, {7}, options(0, deviation));
    expect_proper(mesh, triangulation, found);
    expect_distances(
      mesh, triangulation, found, [&](const Point& p) { return between(p, mesh.points[220]); }, 1e-13 * 30);
    ASSERT_EQ(found.lines.size(), 1u);
    const std::size_t n = found.lines.front().points.size();
    EXPECT_GT(n, 3 * last);
    EXPECT_LT(n, 500 + 6 * 2 * pi * 7 / std::sqrt(8 * 7 * deviation)); // six times as many as needed
    last = n;
  }
}

TEST(Isolines, parallel_curves_in_a_plane)
{
  const Mesh mesh = shaken_plane(20, 20);
  const Triangulation triangulation = mesh.Delaunay();
  const Curve first = line(triangulation, Vertex_index(21 * 8 + 7), 0.4, 6.3),
              second = line(triangulation, Vertex_index(21 * 13 + 5), -0.7, 3);
  const std::vector<IT::Geodesic_source> sources{{{first}}, {{second}, 0.5}};
  const auto distance = [&](const Point& p) {
    double result = std::numeric_limits<double>::infinity();
    for (const IT::Geodesic_source& source : sources) {
      const Points points = in_space(mesh, triangulation, source.parts.front());
      for (std::size_t i = 0; i + 1 < points.size(); ++i)
        result = (std::min)(result, to_segment(p, points[i], points[i + 1]) + source.offset);
    }
    return result;
  };
  const auto found = IT::isolines(triangulation, sources, {0.3, 0.5001, 1, 2}, options(0, 1e-3));
  expect_proper(mesh, triangulation, found);
  expect_distances(mesh, triangulation, found, distance, 1e-12 * 28);
  EXPECT_NEAR(length(mesh, triangulation, {found.lines.front()}), 2 * 6.3 + 2 * pi * 0.3, 2e-2);
}

// The edges whose points have a property, as one source.
IT::Geodesic_source edges_where(const Mesh& mesh, const Triangulation& triangulation,
                                const std::function<bool(const Point&)>& is_there)
{
  IT::Geodesic_source result;
  const IT::Delta_complex& input = triangulation.input();
  for (IT::Edge_index e : input.edges()) {
    const Halfedge_index h = input.halfedge(e);
    if (is_there(mesh.points[input.source(h).idx()]) && is_there(mesh.points[input.target(h).idx()]))
      result.parts.push_back(IT::source_at_edge(input, e).parts.front());
  }
  return result;
}

TEST(Isolines, along_the_lines_of_a_grid)
{
  const Mesh mesh = grid(8, 8, [](double x, double y) -> Point { return {x, y, 0}; });
  const Triangulation triangulation = mesh.Delaunay();
  const auto bottom = edges_where(mesh, triangulation, [](const Point& p) { return p[1] == 0; });
  const auto found = IT::isolines(triangulation, {bottom}, {1, 2, 3, 4, 5, 6, 7}, options(0, 1e-3));
  expect_proper(mesh, triangulation, found);
  ASSERT_EQ(found.lines.size(), 7u);
  for (const IT::Surface_line& l : found.lines) {
    EXPECT_LT(l.points.size(), 200u);
    EXPECT_NEAR(length(mesh, triangulation, {l}), 8, 1e-13);
    for (const Point& p : in_space(mesh, triangulation, l.points))
      EXPECT_NEAR(p[1], l.distance, 1e-13);
  }
}

TEST(Isolines, offset_curves_of_a_loop)
{
  const Mesh mesh = shaken_plane(20, 20);
  const Triangulation triangulation = mesh.Delaunay();
  const Curve loop =
    IT::isolines(triangulation, {IT::source_at_vertex(triangulation.input(), Vertex_index(220))}, {4}, options(0, 0.3))
      .lines.front()
      .points;
  const Points points = in_space(mesh, triangulation, loop);
  const auto distance = [&](const Point& p) {
    double result = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      result = (std::min)(result, to_segment(p, points[i], points[i + 1]));
    return result;
  };
  // Its points lie on Delaunay edges, up to rounding.
  const auto distances =
    IT::geodesic_distances_from(triangulation, {{{loop}}}, CGAL::parameters::tolerance(0)).distances;
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    EXPECT_NEAR(distances[v], distance(mesh.points[v]), 1e-12 * 28);
  const auto found = IT::offset_curves(triangulation, {loop}, {-2, 1, 2, -3, 20}, options(0, 1e-3));
  expect_proper(mesh, triangulation, found);
  expect_distances(mesh, triangulation, found, distance, 1e-12 * 28);
  ASSERT_EQ(found.lines.size(), 4u);
  for (const IT::Surface_line& l : found.lines) // its left side is inside
    for (const Point& p : in_space(mesh, triangulation, l.points))
      EXPECT_NEAR(between(p, mesh.points[220]), 4 - l.distance, 0.35);
}

TEST(Isolines, on_cones)
{
  for (double height : {0.1, 0.5, 0.99}) {
    const Mesh mesh = cone(7, height);
    const Triangulation triangulation = mesh.Delaunay();
    const auto apex = IT::source_at_vertex(triangulation.input(), Vertex_index(0));
    const auto found = IT::isolines(triangulation, {apex}, {0.1, 0.4, 0.7}, options(0, 1e-5));
    expect_proper(mesh, triangulation, found);
    expect_distances(
      mesh, triangulation, found, [&](const Point& p) { return between(p, mesh.points[0]); }, 1e-12);
    ASSERT_EQ(found.lines.size(), 3u);
    const double angle = 14 * std::asin(std::sqrt(1 - height * height) * std::sin(pi / 7));
    EXPECT_NEAR(length(mesh, triangulation, found.lines), angle * 1.2, 1e-3);
  }
}

TEST(Isolines, on_a_folded_strip)
{
  const Mesh mesh = grid(10, 1, [](double x, double y) -> Point {
    return {x / 2, y, std::fmod(x, 2) * std::sqrt(3) / 2}; // each square is one by one
  });
  const Triangulation triangulation = mesh.Delaunay();
  const auto side = edges_where(mesh, triangulation, [](const Point& p) { return p[1] == 0; });
  const auto found = IT::isolines(triangulation, {side}, {0.25, 0.5, 0.9}, options(0, 1e-4));
  expect_proper(mesh, triangulation, found);
  expect_distances(
    mesh, triangulation, found, [](const Point& p) { return p[1]; }, 1e-12);
  ASSERT_EQ(found.lines.size(), 3u);
  EXPECT_NEAR(length(mesh, triangulation, found.lines), 30, 1e-12);
}

// The distance from a point back to the source is the same.
void expect_same_backward(const Triangulation& triangulation, const IT::Surface_lines& found, Vertex_index source,
                          std::size_t step, double accuracy)
{
  for (const IT::Surface_line& l : found.lines)
    for (std::size_t i = 0; i < l.points.size(); i += step)
      ASSERT_NEAR(IT::geodesic_distances_from(triangulation, {{{{l.points[i]}}}}, CGAL::parameters::tolerance(0))
                    .distances[source.idx()],
                  l.distance, accuracy);
}

// On each edge lie as many points as its ends tell.
void expect_all(const Triangulation& triangulation, const std::vector<IT::Geodesic_source>& sources,
                const IT::Surface_lines& found, const std::vector<double>& levels)
{
  const IT::Delta_complex& input = triangulation.input();
  const auto distances = IT::geodesic_distances_from(triangulation, sources, CGAL::parameters::tolerance(0)).distances;
  for (double level : levels) {
    std::vector<int> crossings(input.number_of_edges(), 0);
    for (const IT::Surface_line& l : found.lines)
      for (std::size_t i = 0; l.distance == level && i < l.points.size(); ++i) {
        const Surface_point& p = l.points[i];
        const bool is_closed_end = i + 1 == l.points.size() && !is_on_border(input, p);
        if (p.dimension() != 1 || is_closed_end)
          continue;
        Halfedge_index h = p.halfedge;
        for (std::size_t k = 0; p.coordinates[(k + 2) % 3] > 0; ++k)
          h = input.next(h);
        ++crossings[input.edge(h).idx()];
      }
    for (IT::Edge_index e : input.edges()) {
      const Halfedge_index h = input.halfedge(e);
      const bool differ = (distances[input.source(h).idx()] < level) != (distances[input.target(h).idx()] < level);
      EXPECT_EQ(crossings[e.idx()] % 2, differ ? 1 : 0) << level << ' ' << e.idx();
    }
  }
}

TEST(Isolines, on_a_cube_and_on_hills)
{
  const std::vector<double> levels{0.3, 1.1, 1.9, 2.7, 3.5};
  for (const Mesh& mesh : {cube(1), cube(4), hills(5, 1), hills(5, 4)}) {
    const Triangulation triangulation = mesh.Delaunay();
    for (std::uint32_t v : {0u, 7u}) {
      const std::vector<IT::Geodesic_source> sources{IT::source_at_vertex(triangulation.input(), Vertex_index(v))};
      const auto found = IT::isolines(triangulation, sources, levels, options(0, 1e-3));
      EXPECT_FALSE(found.lines.empty());
      expect_proper(mesh, triangulation, found);
      expect_same_backward(triangulation, found, Vertex_index(v), 7, 1e-12 * 8);
      expect_all(triangulation, sources, found, levels);
      expect_proper(mesh, triangulation, IT::isolines(triangulation, sources, levels, options(0.001, 1e-3)));
    }
  }
}

TEST(Isolines, of_several_sources_on_hills)
{
  const Mesh mesh = hills(8, 2);
  const Triangulation triangulation = mesh.Delaunay();
  const std::vector<IT::Geodesic_source> sources{{{line(triangulation, Vertex_index(40), 0.3, 2.5)}},
                                                 IT::source_at_vertex(triangulation.input(), Vertex_index(75)),
                                                 IT::source_of_region(triangulation.input(), {Face_index(9)})};
  const std::vector<double> levels{0.2, 0.9, 1.7, 2.2, 3.3};
  const auto found = IT::isolines(triangulation, sources, levels, options(0, 1e-3));
  expect_proper(mesh, triangulation, found);
  expect_all(triangulation, sources, found, levels);
}

TEST(Borders_of_cells, in_a_plane)
{
  const Mesh mesh = shaken_plane(20, 20);
  const Triangulation triangulation = mesh.Delaunay();
  const std::vector<std::uint32_t> vertices{21 * 5 + 5, 21 * 7 + 15, 21 * 16 + 9};
  std::vector<IT::Geodesic_source> sources;
  for (std::uint32_t v : vertices)
    sources.push_back(IT::source_at_vertex(triangulation.input(), Vertex_index(v)));
  for (double tolerance : {0., 0.001}) {
    const auto found = IT::borders_of_cells(triangulation, sources, options(tolerance, 1e-4));
    ASSERT_EQ(found.lines.size(), 3u);
    Points ends;
    for (const IT::Surface_line& l : found.lines) {
      EXPECT_LT(l.sources[0], l.sources[1]);
      const Points points = in_space(mesh, triangulation, l.points);
      for (const Point& p : points) {
        const double one = between(p, mesh.points[vertices[l.sources[0]]]),
                     two = between(p, mesh.points[vertices[l.sources[1]]]);
        const double accuracy = tolerance == 0 ? 1e-12 * 28 : 0.03;
        EXPECT_NEAR(one, two, accuracy);
        for (std::uint32_t v : vertices) // where three cells meet, too
          EXPECT_LE(one, between(p, mesh.points[v]) + accuracy);
      }
      const bool begins_on_border = is_on_border(triangulation.input(), l.points.front());
      EXPECT_NE(begins_on_border, is_on_border(triangulation.input(), l.points.back()));
      ends.push_back(begins_on_border ? points.back() : points.front());
      const Point &p = points.front(), &q = points.back(), &left = mesh.points[vertices[l.sources[0]]];
      EXPECT_GT((q[0] - p[0]) * (left[1] - p[1]) - (q[1] - p[1]) * (left[0] - p[0]), 0);
    }
    EXPECT_LT(between(ends[0], ends[1]) + between(ends[0], ends[2]), 1e-12);
  }
}

TEST(Borders_of_cells, around_a_cube)
{
  const Mesh mesh = cube(4);
  const Triangulation triangulation = mesh.Delaunay();
  const auto vertex = [&](const Point& p) {
    return std::uint32_t(std::find(mesh.points.begin(), mesh.points.end(), p) - mesh.points.begin());
  };
  const std::vector<IT::Geodesic_source> sources{
    IT::source_at_vertex(triangulation.input(), Vertex_index(vertex({0, 0, 1}))),
    IT::source_at_vertex(triangulation.input(), Vertex_index(vertex({0, 0, -1})))};
  const auto found = IT::borders_of_cells(triangulation, sources, options(0, 1e-4));
  expect_proper(mesh, triangulation, found);
  ASSERT_EQ(found.lines.size(), 1u); // the middle of the other sides
  EXPECT_NEAR(length(mesh, triangulation, found.lines), 8, 1e-12);
  for (const Point& p : in_space(mesh, triangulation, found.lines.front().points))
    EXPECT_NEAR(p[2], 0, 1e-13);
}

// Of a circle around a corner; nearer to it, they are told by the rounding of coordinates only.
TEST(Isolines, of_any_radius)
{
  const Mesh mesh = shaken_plane(4, 4);
  const Triangulation triangulation = mesh.Delaunay();
  for (std::uint32_t v : {0u, 12u})
    for (double d : {1e-3, 1e-6, 1e-9, 1e-12, 1e-14}) {
      const std::vector<IT::Geodesic_source> sources{IT::source_at_vertex(triangulation.input(), Vertex_index(v))};
      const IT::Surface_lines found = IT::isolines(triangulation, sources, {d}, options(0, d / 100));
      ASSERT_EQ(found.lines.size(), 1u) << d;
      EXPECT_GE(found.lines.front().points.size(), v == 0 ? 2u : 5u);
      for (const Point& p : in_space(mesh, triangulation, found.lines.front().points))
        EXPECT_NEAR(between(p, mesh.points[v]), d, 1e-12 * d + 4e-15);
    }
}

TEST(Isolines, are_not_too_many)
{
  const Mesh mesh = shaken_plane(4, 4);
  const Triangulation triangulation = mesh.Delaunay();
  const std::vector<IT::Geodesic_source> sources{IT::source_at_vertex(triangulation.input(), Vertex_index(12))};
  std::vector<double> many;
  for (int i = 1; i <= 100000; ++i)
    many.push_back(2e-5 * i);
  const auto message = [&](const std::vector<double>& levels, double deviation) -> std::string {
    try {
      IT::isolines(triangulation, sources, levels, options(0, deviation));
      return "";
    } catch (const IT::Invalid_argument_error& error) {
      return error.what();
    }
  };
  const std::string found = message(many, 1e-3);
  EXPECT_EQ(found.substr(0, 21), "the lines need about ") << found;
  EXPECT_NE(found.find("of the distances would do"), std::string::npos) << found;
  EXPECT_NE(message({1}, 1e-15).find("times as large would do"), std::string::npos) << message({1}, 1e-15);
  EXPECT_EQ(message({1}, 1e-6), "");
}

// The default deviation is a part of the largest distance of a corner, which is zero here.
TEST(Borders_of_cells, of_all_vertices)
{
  const Mesh mesh = shaken_plane(4, 4);
  const Triangulation triangulation = mesh.Delaunay();
  std::vector<IT::Geodesic_source> sources;
  for (Vertex_index v : triangulation.input().vertices())
    sources.push_back(IT::source_at_vertex(triangulation.input(), v));
  const IT::Surface_lines found = IT::borders_of_cells(triangulation, sources);
  EXPECT_GE(found.lines.size(), sources.size());
  EXPECT_GT(found.maximum_deviation, 0); // although no corner of a face has a distance
}

TEST(Isolines, wrong_numbers)
{
  const Mesh mesh = shaken_plane(4, 4);
  const Triangulation triangulation = mesh.Delaunay();
  const std::vector<IT::Geodesic_source> sources{IT::source_at_vertex(triangulation.input(), Vertex_index(12))};
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (double d : {0., -1., nan, infinity})
    EXPECT_THROW(IT::isolines(triangulation, sources, {1, d}), IT::Invalid_argument_error);
  for (double d : {0., nan, infinity})
    EXPECT_THROW(IT::offset_curves(triangulation, sources.front().parts, {1, d}), IT::Invalid_argument_error);
  for (double d : {0., -1., nan})
    EXPECT_THROW(IT::isolines(triangulation, sources, {1}, options(0, d)), IT::Invalid_argument_error);
  EXPECT_TRUE(IT::isolines(triangulation, sources, {}).lines.empty());
  EXPECT_TRUE(IT::isolines(triangulation, sources, {1000}).lines.empty());
  EXPECT_TRUE(IT::borders_of_cells(triangulation, sources).lines.empty());
  EXPECT_THROW(IT::isolines(triangulation, sources, {1}, CGAL::parameters::visitor([] { return false; })),
               IT::Cancelled_error);
  // At any time.
  std::size_t calls = 0, most = (std::numeric_limits<std::size_t>::max)();
  const auto goes_on = [&] { return ++calls < most; };
  const auto find = [&] {
    return IT::isolines(triangulation, sources, {0.5, 1}, CGAL::parameters::maximum_deviation(1e-7).visitor(goes_on));
  };
  find();
  EXPECT_GT(calls, 1u);
  most = (calls + 1) / 2; // as another run may ask less often
  calls = 0;
  EXPECT_THROW(find(), IT::Cancelled_error);
}

TEST(Farthest_vertices, one_after_the_other)
{
  const Mesh mesh = hills(8, 2);
  const Triangulation triangulation = mesh.Delaunay();
  for (double tolerance : {0., 0.001}) {
    const auto np = CGAL::parameters::tolerance(tolerance);
    std::vector<IT::Geodesic_source> sources{{{line(triangulation, Vertex_index(40), 0.3, 2.5)}}};
    const auto found = IT::farthest_vertices(triangulation, sources, 12, np);
    ASSERT_EQ(found.size(), 12u);
    for (const IT::Farthest_vertex& f : found) {
      const std::vector<double> distances = IT::geodesic_distances_from(triangulation, sources, np).distances;
      const double farthest = *std::max_element(distances.begin(), distances.end());
      EXPECT_NEAR(f.distance, farthest, tolerance == 0 ? 1e-12 : 0.02);
      EXPECT_NEAR(distances[f.vertex.idx()], farthest, tolerance == 0 ? 1e-12 : 0.02);
      sources.push_back(IT::source_at_vertex(triangulation.input(), f.vertex));
    }
  }
  EXPECT_EQ(IT::farthest_vertices(triangulation, {}, 1000).size(), mesh.points.size());
  EXPECT_EQ(IT::farthest_vertices(triangulation, {}, 1).front().vertex, Vertex_index(0));
}

TEST(Farthest_vertices, of_any_triangles)
{
  Points points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {5, 5, 5}, {6, 5, 5}, {5, 6, 5}, {9, 9, 9}};
  IT::Tufted_cover cover = IT::make_tufted_cover(points, Triangles{{0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {5, 6, 7}},
                                                 CGAL::parameters::surface_cover(IT::Surface_cover::SHEETS));
  IT::flip_to_Delaunay(cover.triangulation);
  const auto found = IT::farthest_vertices(cover, {IT::source_at_vertex(cover.triangulation.input(), Vertex_index(0))},
                                           4, CGAL::parameters::tolerance(0));
  ASSERT_EQ(found.size(), 4u);
  EXPECT_EQ(found[0].vertex, Vertex_index(5)); // of another component, but not the one without a face
  EXPECT_TRUE(std::isinf(found[0].distance));
  EXPECT_NEAR(found[1].distance, 1, 1e-13);
}

} // namespace
