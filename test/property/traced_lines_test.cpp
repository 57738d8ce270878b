// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Straight lines over the faces of flipped and refined triangulations, compared with the same lines over the input.

#include "insert_random_vertices.h"
#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Point_location.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/geodesic_path.h>
#include <CGAL/Intrinsic_triangulations/insert_vertex.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/trace_geodesic.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

Triangulation triangulation_of(const samples::Indexed_triangles& surface)
{
  return Triangulation(IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles), surface.points);
}

// Where a point lies in its face, in a plane where h runs from 0 along the real axis.
std::complex<double> in_plane(const Triangulation& t, const IT::Surface_point& p, IT::Halfedge_index h)
{
  const IT::Delta_complex& c = t.connectivity();
  std::array<double, 3> b = p.coordinates;
  for (IT::Halfedge_index g = p.halfedge; g != h; g = c.next(g))
    std::rotate(b.begin(), b.begin() + 1, b.end());
  const double ij = t.length(c.edge(h)), jk = t.length(c.edge(c.next(h))), ki = t.length(c.edge(c.prev(h)));
  const double x = (ij * ij + ki * ki - jk * jk) / (2 * ij);
  return b[1] * ij + b[2] * std::complex<double>(x, 2 * t.area(c.face(h)) / ij);
}

// The distances of the points of a line from its start, by the lengths of the triangulation. Checks that each part runs
// through the face that it is said to run through.
std::vector<double> distances(const Triangulation& t, const IT::Traced_geodesic& line)
{
  const IT::Delta_complex& c = t.connectivity();
  std::vector<double> result{0};
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
    const IT::Surface_point &p = line.points[i], &q = line.points[i + 1];
    const IT::Face_index f = c.face(p.halfedge);
    // Where the line leaves the face: in the other face beside an edge, at a corner, or where it ends.
    IT::Surface_point exit = q;
    if (c.face(q.halfedge) != f && q.dimension() == 1)
      exit = {c.opposite(q.halfedge), {q.coordinates[1], q.coordinates[0], 0}};
    else if (c.face(q.halfedge) != f) {
      EXPECT_EQ(q.coordinates, (std::array<double, 3>{1, 0, 0}));
      exit = {p.halfedge, {1, 0, 0}};
      while (c.source(exit.halfedge) != c.source(q.halfedge)) {
        exit.halfedge = c.next(exit.halfedge);
        if (exit.halfedge == p.halfedge)
          break;
      }
      EXPECT_EQ(c.source(exit.halfedge), c.source(q.halfedge));
    } else if (q.dimension() == 1 && q.coordinates[2] == 0 && i + 2 < line.points.size() &&
               c.face(c.opposite(q.halfedge)) == f)
      exit = {c.opposite(q.halfedge), {q.coordinates[1], q.coordinates[0], 0}};
    EXPECT_EQ(c.face(exit.halfedge), f) << i;
    if (c.face(exit.halfedge) != f)
      return result;
    result.push_back(result.back() + std::abs(in_plane(t, exit, p.halfedge) - in_plane(t, p, p.halfedge)));
  }
  return result;
}

using Point = std::array<double, 3>;

double distance(const Point& p, const Point& q) { return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]); }

// A line over the input as a polyline.
struct Line_in_space
{
  std::vector<Point> points;
  std::vector<double> distances;

  Point at(double d) const
  {
    std::size_t i = 1;
    while (i + 1 < points.size() && distances[i] < d)
      ++i;
    const double length = distances[i] - distances[i - 1], x = length > 0 ? (d - distances[i - 1]) / length : 0;
    Point p;
    for (int k = 0; k < 3; ++k)
      p[k] = (1 - x) * points[i - 1][k] + x * points[i][k];
    return p;
  }
};

// \return the number of points
std::size_t expect_the_same_line(const Triangulation& t, const IT::Point_location& location,
                                 const std::vector<Point>& points, const IT::Surface_direction& start, double length)
{
  const IT::Delta_complex& input = t.input();
  const IT::Traced_geodesic line = IT::trace_geodesic(t, start, length),
                            in_faces = IT::trace_geodesic_in_triangulation(t, start, length);
  EXPECT_EQ(line.status, in_faces.status);
  EXPECT_EQ(line.vertex, in_faces.vertex);
  EXPECT_NEAR(line.length, in_faces.length, 1e-12 * (1 + line.length));
  Line_in_space in_space;
  for (const IT::Surface_point& p : line.points) {
    in_space.points.push_back(IT::point_in_space(input, points, p));
    in_space.distances.push_back(in_space.distances.empty()
                                   ? 0
                                   : in_space.distances.back() +
                                       distance(in_space.points.back(), in_space.points[in_space.points.size() - 2]));
  }
  const std::vector<double> d = distances(t, in_faces);
  EXPECT_EQ(d.size(), in_faces.points.size());
  EXPECT_NEAR(d.back(), in_faces.length, 1e-10 * (1 + line.length));
  for (std::size_t i = 0; i < d.size(); ++i)
    EXPECT_LT(
      distance(IT::point_in_space(input, points, location.intrinsic_to_input(in_faces.points[i])), in_space.at(d[i])),
      1e-9)
      << i;
  return in_faces.points.size();
}

// Starts inside of faces, on edges and at vertices of the input, at vertices of the triangulation, and on its edges as
// well as doubles allow.
IT::Surface_direction random_start(const Triangulation& t, const IT::Point_location& location, std::mt19937& random)
{
  const IT::Delta_complex& input = t.input();
  const auto coordinate = [&] { return double(random() % 5); };
  for (;;) {
    IT::Surface_direction start{{IT::Halfedge_index(std::uint32_t(random() % input.number_of_halfedges())), {}}, {}};
    if (input.is_border(start.point.halfedge))
      continue;
    for (double& x : start.point.coordinates)
      x = coordinate();
    if (random() % 4 == 0) {
      IT::Halfedge_index h(std::uint32_t(random() % t.connectivity().number_of_halfedges()));
      const IT::Vertex_index v = t.connectivity().source(h);
      if (t.is_inserted(v))
        start.point = t.location(v);
      else if (!t.connectivity().is_border(h))
        start.point = location.intrinsic_to_input({h, {coordinate(), coordinate() + 1, 0}});
    }
    if (start.point.coordinates == std::array<double, 3>{0, 0, 0})
      continue;
    start.displacement = {double(random() % 7) - 3, double(random() % 7) - 3};
    const double d[3] = {-(start.displacement[0] + start.displacement[1]), start.displacement[0],
                         start.displacement[1]};
    bool leads_into_face = d[1] != 0 || d[2] != 0;
    for (int i = 0; i < 3; ++i)
      leads_into_face = leads_into_face && (start.point.coordinates[i] > 0 || d[i] >= 0);
    if (leads_into_face)
      return start;
  }
}

// Squares of side 1, each with a rising diagonal.
samples::Indexed_triangles squares(std::uint32_t columns, std::uint32_t rows)
{
  samples::Indexed_triangles result;
  for (std::uint32_t y = 0; y <= rows; ++y)
    for (std::uint32_t x = 0; x <= columns; ++x)
      result.points.push_back({double(x), double(y), 0});
  for (std::uint32_t y = 0; y < rows; ++y)
    for (std::uint32_t x = 0; x < columns; ++x) {
      const std::uint32_t v = y * (columns + 1) + x, w = v + columns + 1;
      result.triangles.push_back({v, v + 1, w + 1});
      result.triangles.push_back({v, w + 1, w});
    }
  return result;
}

TEST(Traced_line, goes_on_behind_inserted_vertices)
{
  Triangulation t = triangulation_of(squares(4, 2));
  // From the corner (0, 0) to (4, 1): half way through each face, with a vertex at (1, 1/4), (3/2, 3/8) and (2, 1/2).
  const IT::Delta_complex input = t.connectivity();
  const auto halfedge_from = [&input](std::uint32_t source, std::uint32_t target) {
    for (IT::Halfedge_index h : input.halfedges())
      if (input.source(h).idx() == source && input.target(h).idx() == target)
        return h;
    return IT::Halfedge_index();
  };
  for (const IT::Surface_point& p :
       {IT::Surface_point{halfedge_from(1, 6), {0.75, 0.25, 0}}, IT::Surface_point{halfedge_from(2, 7), {0.5, 0.5, 0}},
        IT::Surface_point{halfedge_from(1, 2), {0.5, 0.125, 0.375}}})
    IT::insert_vertex(t, p);
  const IT::Surface_direction start{{halfedge_from(0, 1), {1, 0, 0}}, {3, 1}};
  const IT::Traced_geodesic line = IT::trace_geodesic_in_triangulation(t, start, 100);
  EXPECT_EQ(line.status, IT::Trace_status::AT_VERTEX);
  EXPECT_EQ(line.vertex.idx(), 9u);
  EXPECT_NEAR(line.length, std::sqrt(17.), 1e-15);
  const auto at_corners = std::count_if(line.points.begin(), line.points.end(),
                                        [](const IT::Surface_point& p) { return p.dimension() == 0; });
  EXPECT_EQ(at_corners, 5); // both ends and three inserted vertices
  distances(t, line);
  // A little beside it, no vertex is met.
  const IT::Traced_geodesic beside = IT::trace_geodesic_in_triangulation(t, {start.point, {3, 1 - 0x1p-50}}, 100);
  EXPECT_EQ(beside.status, IT::Trace_status::AT_BORDER);
  EXPECT_EQ(std::count_if(beside.points.begin(), beside.points.end(),
                          [](const IT::Surface_point& p) { return p.dimension() == 0; }),
            1);
}

TEST(Traced_line, runs_along_edges)
{
  Triangulation t = triangulation_of(squares(3, 3));
  const IT::Delta_complex input = t.connectivity();
  for (IT::Halfedge_index h : input.halfedges()) {
    if (input.is_border(h))
      continue;
    for (const IT::Surface_point& p : {IT::Surface_point{h, {1, 0, 0}}, IT::Surface_point{h, {1, 2, 0}}}) {
      const IT::Traced_geodesic line = IT::trace_geodesic_in_triangulation(t, {p, {1, 0}}, 10);
      EXPECT_EQ(line.status, IT::Trace_status::AT_VERTEX);
      EXPECT_EQ(line.vertex, input.target(h));
      EXPECT_EQ(line.points.size(), 2u);
    }
  }
}

// All diagonals are flipped, so that the middle of each input diagonal lies on an edge.
TEST(Traced_line, begins_on_edges)
{
  const samples::Indexed_triangles surface = squares(4, 3);
  Triangulation t = triangulation_of(surface);
  const IT::Delta_complex input = t.connectivity();
  std::vector<IT::Halfedge_index> diagonals;
  for (IT::Halfedge_index h : input.halfedges())
    if (t.length(input.edge(h)) > 1.2)
      diagonals.push_back(h);
  for (IT::Halfedge_index h : diagonals)
    if (h == input.halfedge(input.edge(h)))
      t.flip(input.edge(h));
  const IT::Common_subdivision subdivision(t);
  const IT::Point_location location(subdivision);
  for (IT::Halfedge_index h : diagonals)
    for (const std::array<double, 2>& displacement :
         {std::array<double, 2>{1, 0}, {-1, 0}, {-3, 2}, {-1, 2}, {-2, 3}, {0, 1}, {-1, 1}}) {
      const IT::Surface_direction start{{h, {1, 1, 0}}, displacement};
      expect_the_same_line(t, location, surface.points, start, 2.3);
      EXPECT_GT(distances(t, IT::trace_geodesic_in_triangulation(t, start, 2.3))[1], 0.1); // not in the face behind
    }
}

TEST(Traced_line, runs_along_the_border_past_inserted_vertices)
{
  const samples::Indexed_triangles surface = squares(3, 2);
  Triangulation t = triangulation_of(surface);
  const IT::Delta_complex input = t.connectivity();
  for (IT::Halfedge_index h : input.halfedges())
    if (input.is_border(input.opposite(h)))
      for (double x : {0.25, 0.5})
        IT::insert_vertex(t, {h, {1 - x, x, 0}});
  const IT::Common_subdivision subdivision(t);
  const IT::Point_location location(subdivision);
  for (IT::Halfedge_index h : input.halfedges())
    if (input.is_border(input.opposite(h))) {
      for (const std::array<double, 3>& b : {std::array<double, 3>{1, 0, 0}, {3, 1, 0}, {7, 1, 0}})
        expect_the_same_line(t, location, surface.points, {{h, b}, {1, 0}}, 10);
      for (const std::array<double, 3>& b : {std::array<double, 3>{0, 1, 0}, {1, 1, 0}, {1, 7, 0}})
        expect_the_same_line(t, location, surface.points, {{h, b}, {-1, 0}}, 10);
      // Into an inserted vertex of the border from inside.
      expect_the_same_line(t, location, surface.points, {{h, {1, 1, 2}}, {1, -2}}, 10);
    }
}

class Traced_lines : public testing::TestWithParam<int>
{};

TEST_P(Traced_lines, are_the_same_over_input_and_triangulation)
{
  std::mt19937 random{std::uint32_t(GetParam())};
  for (const samples::Indexed_triangles& surface :
       {samples::bumpy_sphere(), samples::torus(12, 8), samples::bumpy_dome(12, 8), samples::random_diagonal_grid(6, 6),
        samples::sheared_grid(5, 5, 2), samples::prism(8, 3), samples::bad_torus(10, 8)}) {
    Triangulation t = triangulation_of(surface);
    if (GetParam() > 0)
      IT::flip_to_Delaunay(t);
    if (GetParam() > 1)
      IT::insert_random_vertices(t, 5 * std::size_t(GetParam()), 6, random);
    const IT::Common_subdivision subdivision(t);
    const IT::Point_location location(subdivision);
    std::size_t number_of_points = 0;
    for (int i = 0; i < 60; ++i) {
      const IT::Surface_direction start = random_start(t, location, random);
      SCOPED_TRACE(i);
      number_of_points += expect_the_same_line(t, location, surface.points, start, 0.1037 * double(random() % 60));
    }
    EXPECT_GT(number_of_points, 200u);
  }
}

INSTANTIATE_TEST_SUITE_P(Triangulations, Traced_lines, testing::Range(0, 6));

} // namespace
