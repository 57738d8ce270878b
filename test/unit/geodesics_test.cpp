// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Geodesics: convexity by the filter, paths and closed curves that are shortened, and lines that are traced.

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Geodesic_path_network.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/geodesic_path.h>
#include <CGAL/Intrinsic_triangulations/insert_vertex.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/trace_geodesic.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/function_property_map.hpp>
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
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;
using Network = IT::Geodesic_path_network<IT::Filtered_edge_length_traits>;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Status = IT::Geodesic_status;

namespace {

const double pi = std::acos(-1.);

Triangulation triangulation_of(const samples::Indexed_triangles& surface)
{
  return Triangulation(IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles), surface.points);
}

// Squares of side 1 with a diagonal each; the third coordinate by a function of the other two.
samples::Indexed_triangles grid(
  std::uint32_t columns, std::uint32_t rows,
  const std::function<double(double, double)>& height = [](double, double) { return 0.; })
{
  samples::Indexed_triangles result;
  for (std::uint32_t y = 0; y <= rows; ++y)
    for (std::uint32_t x = 0; x <= columns; ++x)
      result.points.push_back({double(x), double(y), height(x, y)});
  for (std::uint32_t y = 0; y < rows; ++y)
    for (std::uint32_t x = 0; x < columns; ++x) {
      const std::uint32_t v = y * (columns + 1) + x, w = v + columns + 1;
      result.triangles.push_back({v, v + 1, w + 1});
      result.triangles.push_back({v, w + 1, w});
    }
  return result;
}

// A disk of concentric rings round an apex.
samples::Indexed_triangles cone(std::uint32_t columns, std::uint32_t rings, double height)
{
  samples::Indexed_triangles result;
  result.points.push_back({0, 0, height});
  for (std::uint32_t r = 1; r <= rings; ++r)
    for (std::uint32_t c = 0; c < columns; ++c) {
      const double angle = 2 * pi * (c + 0.5 * (r % 2)) / columns, radius = double(r) / rings;
      result.points.push_back({radius * std::cos(angle), radius * std::sin(angle), height * (1 - radius)});
    }
  const auto vertex = [&](std::uint32_t r, std::uint32_t c) { return 1 + (r - 1) * columns + c % columns; };
  for (std::uint32_t c = 0; c < columns; ++c)
    result.triangles.push_back({0, vertex(1, c), vertex(1, c + 1)});
  for (std::uint32_t r = 1; r < rings; ++r)
    for (std::uint32_t c = 0; c < columns; ++c) {
      const std::uint32_t shift = r % 2; // the next ring is turned back or on
      const std::uint32_t a = vertex(r, c), b = vertex(r, c + 1), p = vertex(r + 1, c + shift),
                          q = vertex(r + 1, c + shift + 1);
      result.triangles.push_back({a, p, b});
      result.triangles.push_back({b, p, q});
    }
  return result;
}

// The surface of a plate of unit cubes, three deep, with holes in a row: of genus `holes`. All its angles are right or
// straight ones.
samples::Indexed_triangles plate(int holes)
{
  using Point = std::array<int, 3>;
  const auto is_full = [&](const Point& p) {
    const auto& [x, y, z] = p;
    return x >= 0 && x < 2 * holes + 1 && y >= 0 && y < 3 && z == 0 && !(y == 1 && x % 2 == 1);
  };
  samples::Indexed_triangles result;
  std::map<Point, std::uint32_t> numbers;
  const auto vertex = [&](const Point& p) {
    const auto [it, is_new] = numbers.insert({p, std::uint32_t(numbers.size())});
    if (is_new)
      result.points.push_back({double(p[0]), double(p[1]), double(p[2])});
    return it->second;
  };
  for (int x = 0; x < 2 * holes + 1; ++x)
    for (int y = 0; y < 3; ++y)
      for (int axis = 0; axis < 3; ++axis)
        for (int side : {0, 1}) {
          Point beside{x, y, 0};
          beside[axis] += 2 * side - 1;
          if (!is_full({x, y, 0}) || is_full(beside))
            continue;
          std::array<Point, 4> corners;
          for (int i = 0; i < 4; ++i) {
            corners[i] = {x, y, 0};
            corners[i][axis] += side;
            corners[i][(axis + 1) % 3] += i == 1 || i == 2 ? 1 : 0;
            corners[i][(axis + 2) % 3] += i >= 2 ? 1 : 0;
          }
          if (side == 0)
            std::swap(corners[1], corners[3]);
          const std::uint32_t a = vertex(corners[0]), b = vertex(corners[1]), c = vertex(corners[2]),
                              d = vertex(corners[3]);
          result.triangles.push_back({a, b, c});
          result.triangles.push_back({a, c, d});
        }
  return result;
}

IT::Halfedge_index halfedge_between(const IT::Delta_complex& complex, std::uint32_t from, std::uint32_t to)
{
  for (IT::Halfedge_index h : complex.halfedges())
    if (complex.source(h).idx() == from && complex.target(h).idx() == to)
      return h;
  ADD_FAILURE() << "no edge from " << from << " to " << to;
  return IT::Halfedge_index();
}

std::vector<IT::Halfedge_index> cycle(const IT::Delta_complex& complex, const std::vector<std::uint32_t>& vertices)
{
  std::vector<IT::Halfedge_index> result;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    result.push_back(halfedge_between(complex, vertices[i], vertices[(i + 1) % vertices.size()]));
  return result;
}

// As if a loop cannot be led round a corner: flips are undone, the last one first.
TEST(Undone_flips, leave_each_face_with_a_side_of_its_own)
{
  const std::vector<std::array<double, 3>> points{{0, 0, 0},   {2, 0, 0},   {3, 1.7, 0},
                                                  {2, 3.4, 0}, {0, 3.5, 0}, {-1, 1.6, 0}};
  const std::vector<std::array<std::uint32_t, 3>> triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}};
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    std::mt19937 random(seed);
    Triangulation t(IT::make_Delta_complex_from_triangles(points.size(), triangles), points);
    const IT::Delta_complex& complex = t.connectivity();
    IT::internal::Undoable_flips<Triangulation::Traits> flips(t);
    for (int i = 0; i < 20; ++i) {
      const IT::Edge_index e(std::uint32_t(random() % complex.number_of_edges()));
      if (complex.is_flippable(e))
        flips.flip(e);
    }
    flips.undo(0);
    for (IT::Face_index f : complex.faces())
      ASSERT_EQ(complex.face(complex.halfedge(f)), f) << seed;
  }
}

} // namespace

TEST(Convexity, TheFilterAgreesWithTheUnfolding)
{
  Triangulation t = triangulation_of(samples::random_diagonal_grid(12, 12));
  std::mt19937 random(5);
  int flipped = 0, refused = 0;
  for (int i = 0; i < 4000; ++i) {
    const IT::Edge_index e(random() % t.connectivity().number_of_edges());
    if (!t.connectivity().is_flippable(e))
      continue;
    const bool is_convex = IT::internal::engine(t).is_convex(e);
    const bool was_flipped = t.flip(e) == Triangulation::Flip_outcome::FLIPPED;
    ASSERT_EQ(was_flipped, is_convex) << "step " << i;
    ++(was_flipped ? flipped : refused);
  }
  EXPECT_GT(flipped, 100);
  EXPECT_GT(refused, 100);
  for (IT::Face_index f : t.connectivity().faces())
    EXPECT_EQ(IT::internal::engine(t).sign_of_area(f), CGAL::POSITIVE);
}

TEST(GeodesicPath, AcrossAPlaneIsTheStraightLine)
{
  Triangulation t = triangulation_of(grid(9, 7));
  for (std::uint32_t target : {79u, 78u, 39u, 9u, 70u, 0u}) {
    Triangulation copy = t;
    Network network(copy);
    network.add_path(IT::shortest_edge_path(copy, IT::Vertex_index(0), IT::Vertex_index(target)));
    EXPECT_EQ(network.shorten().status, Status::GEODESIC);
    EXPECT_TRUE(network.is_geodesic());
    EXPECT_NEAR(network.length(0), std::hypot(target % 10, target / 10), 1e-14);
    const std::vector<IT::Surface_point> points = IT::geodesic_points(copy, network.halfedges(0));
    const auto& input = copy.input();
    for (const IT::Surface_point& p : points) {
      const auto x = IT::point_in_space(input, grid(9, 7).points, p);
      EXPECT_NEAR(x[0] * (target / 10), x[1] * (target % 10), 1e-13);
    }
  }
}

TEST(GeodesicPath, AnglesOfExactlyPiAreStraight)
{
  // Along the sides of squares every angle on a path is π: there is nothing to do.
  Triangulation t = triangulation_of(grid(9, 1, [](double, double y) { return y; }));
  std::vector<IT::Halfedge_index> side;
  for (std::uint32_t x = 0; x < 9; ++x)
    side.push_back(halfedge_between(t.connectivity(), x, x + 1));
  Network network(t);
  network.add_path(side);
  EXPECT_TRUE(network.is_geodesic());
  const IT::Geodesic_report report = network.shorten();
  EXPECT_EQ(report.status, Status::GEODESIC);
  EXPECT_EQ(report.flips, 0u);
  EXPECT_EQ(network.halfedges(0), side);
}

TEST(GeodesicPath, HalfAUlpIsNotStraight)
{
  // The inner vertex is 2^-60 off the line: no double and no double-double tolerance would see a bend of this size in
  // coordinates of size 1, but exact arithmetic does.
  samples::Indexed_triangles surface;
  surface.points = {{-1, 0, 0}, {1, 0, 0}, {0, std::ldexp(1, -60), 0}, {0, 1, 0}, {0, -1, 0}};
  surface.triangles = {{0, 2, 3}, {2, 1, 3}, {0, 4, 2}, {2, 4, 1}};
  Triangulation t = triangulation_of(surface);
  Network network(t);
  network.add_path(std::vector<IT::Halfedge_index>{halfedge_between(t.connectivity(), 0, 2),
                                                   halfedge_between(t.connectivity(), 2, 1)});
  EXPECT_FALSE(network.is_geodesic());
  EXPECT_EQ(network.shorten().status, Status::GEODESIC);
  EXPECT_TRUE(network.is_geodesic());
  EXPECT_EQ(network.halfedges(0).size(), 1u);
}

TEST(GeodesicPath, AllPairsOfASphereAreProvenGeodesic)
{
  const Triangulation t = triangulation_of(samples::bumpy_sphere(12, 9));
  const std::uint32_t n = t.connectivity().number_of_vertices();
  for (std::uint32_t s = 0; s < n; s += 7)
    for (std::uint32_t target = 0; target < n; target += 5) {
      Triangulation copy = t;
      Network network(copy);
      network.add_path(IT::shortest_edge_path(copy, IT::Vertex_index(s), IT::Vertex_index(target)));
      const double before = network.length(0);
      ASSERT_EQ(network.shorten().status, Status::GEODESIC);
      ASSERT_TRUE(network.is_geodesic());
      ASSERT_LE(network.length(0), before * (1 + 1e-15));
      // The points on the input are as far from each other as the path is long.
      const auto points = IT::geodesic_points(copy, network.halfedges(0));
      double sum = 0;
      std::array<double, 3> last{};
      for (std::size_t i = 0; i < points.size(); ++i) {
        const auto x = IT::point_in_space(copy.input(), samples::bumpy_sphere(12, 9).points, points[i]);
        if (i > 0)
          sum += std::hypot(x[0] - last[0], x[1] - last[1], x[2] - last[2]);
        last = x;
      }
      ASSERT_NEAR(sum, network.length(0), 1e-13);
    }
}

TEST(GeodesicPath, AllPairsWhereAnglesAreStraightOrRight)
{
  const std::vector<samples::Indexed_triangles> surfaces{plate(1), plate(2), samples::prism()};
  for (const samples::Indexed_triangles& surface : surfaces) {
    const Triangulation t = triangulation_of(surface);
    const std::uint32_t n = std::min<std::uint32_t>(t.connectivity().number_of_vertices(), 48);
    for (std::uint32_t s = 0; s < n; ++s)
      for (std::uint32_t target = 0; target < s; ++target) {
        Triangulation copy = t;
        Network network(copy);
        network.add_path(IT::shortest_edge_path(copy, IT::Vertex_index(s), IT::Vertex_index(target)));
        ASSERT_EQ(network.shorten().status, Status::GEODESIC) << s << " to " << target;
        ASSERT_TRUE(network.is_geodesic());
        const auto &p = surface.points[s], &q = surface.points[target];
        ASSERT_GE(network.length(0), std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) * (1 - 1e-15));
      }
  }
}

TEST(GeodesicPath, OneCallOnAMesh)
{
  Mesh mesh;
  const samples::Indexed_triangles surface = grid(4, 4);
  for (const auto& [x, y, z] : surface.points)
    mesh.add_vertex({x, y, z});
  for (const auto& [i, j, k] : surface.triangles)
    mesh.add_face(Mesh::Vertex_index(i), Mesh::Vertex_index(j), Mesh::Vertex_index(k));
  const IT::Geodesic_path path = IT::geodesic_path(mesh, Mesh::Vertex_index(0), Mesh::Vertex_index(19));
  EXPECT_TRUE(path.is_geodesic);
  EXPECT_NEAR(path.length, 5, 1e-14);
  EXPECT_GT(path.initial_length, 5.2);
  ASSERT_EQ(path.points.size(), path.positions.size());
  EXPECT_EQ(path.positions.front(), (std::array<double, 3>{0, 0, 0}));
  EXPECT_EQ(path.positions.back(), (std::array<double, 3>{4, 3, 0}));
  EXPECT_THROW(IT::geodesic_path(mesh, Mesh::Vertex_index(0), Mesh::Vertex_index(99)), IT::Invalid_argument_error);
}

TEST(GeodesicPath, OneCallBetweenAnyPoints)
{
  // Every kind of point with every other: on a folded sheet, a path is as long as the straight line of the unfolding.
  Mesh mesh;
  const samples::Indexed_triangles surface = grid(4, 3, [](double, double y) { return y > 2 ? 0.75 * (y - 2) : 0; });
  for (const auto& [x, y, z] : surface.points)
    mesh.add_vertex({x, y, z});
  for (const auto& [i, j, k] : surface.triangles)
    mesh.add_face(Mesh::Vertex_index(i), Mesh::Vertex_index(j), Mesh::Vertex_index(k));
  const IT::Delta_complex input = IT::make_Delta_complex(mesh);
  std::vector<IT::Surface_point> points;
  for (IT::Face_index f : {IT::Face_index(0), IT::Face_index(1), IT::Face_index(11), IT::Face_index(22)})
    for (const auto& coordinates : {std::array<double, 3>{0, 0, 7},
                                    {0, 3, 0},
                                    {1, 0, 0},
                                    {0.5, 0.5, 0},
                                    {0.25, 0, 0.75},
                                    {0, 1, 2},
                                    {1, 2, 4},
                                    {0.25, 0.5, 1},
                                    {4, 2, 1}})
      points.push_back({input.halfedge(f), coordinates});
  const auto flat = [&](IT::Surface_point p) {
    const double sum = p.coordinates[0] + p.coordinates[1] + p.coordinates[2];
    for (double& c : p.coordinates)
      c /= sum;
    const auto x = IT::point_in_space(input, surface.points, p);
    return std::array<double, 2>{x[0], x[1] > 2 ? 2 + 1.25 * (x[1] - 2) : x[1]};
  };
  for (const IT::Surface_point& s : points)
    for (const IT::Surface_point& target : points) {
      const IT::Geodesic_path path = IT::geodesic_path(mesh, s, target);
      ASSERT_TRUE(path.is_geodesic);
      const auto a = flat(s), b = flat(target);
      ASSERT_NEAR(path.length, std::hypot(a[0] - b[0], a[1] - b[1]), 1e-14);
      ASSERT_GE(path.initial_length, path.length * (1 - 1e-15));
      if (path.length == 0)
        continue;
      const auto first = flat(path.points.front()), last = flat(path.points.back());
      ASSERT_NEAR(std::hypot(first[0] - a[0], first[1] - a[1]), 0, 1e-15);
      ASSERT_NEAR(std::hypot(last[0] - b[0], last[1] - b[1]), 0, 1e-15);
    }
  const IT::Surface_point good = points[6];
  const IT::Halfedge_index h = good.halfedge;
  const double nan = std::nan("");
  for (const IT::Surface_point& bad : std::vector<IT::Surface_point>{{h, {0, 0, 0}},
                                                                     {h, {1, -1, 0}},
                                                                     {h, {1, nan, 0}},
                                                                     {h, {nan, nan, nan}},
                                                                     {IT::Halfedge_index(), {1, 1, 1}},
                                                                     {IT::Halfedge_index(), {1, 0, 0}},
                                                                     {IT::Halfedge_index(9999), {1, 0, 0}}}) {
    EXPECT_THROW(IT::geodesic_path(mesh, good, bad), IT::Invalid_point_error);
    EXPECT_THROW(IT::geodesic_path(mesh, bad, good), IT::Invalid_point_error);
  }
}

TEST(GeodesicLoop, RoundAnApexIsContractible)
{
  for (std::uint32_t rings : {2u, 3u, 8u, 50u})
    for (double height : {0., 0.1, 1., 3.}) {
      Triangulation t = triangulation_of(cone(9, rings, height));
      std::vector<std::uint32_t> ring;
      for (std::uint32_t c = 0; c < 9; ++c)
        ring.push_back(1 + (rings - 2) * 9 + c);
      Network network(t);
      network.add_closed_path(cycle(t.connectivity(), ring));
      EXPECT_EQ(network.shorten().status, Status::GEODESIC);
      EXPECT_EQ(network.status(0), Status::CONTRACTIBLE) << rings << " rings, height " << height;
      EXPECT_TRUE(network.halfedges(0).empty());
      EXPECT_TRUE(network.contraction(0).is_valid());
      EXPECT_EQ(network.shorten().steps, 0u);
      EXPECT_EQ(network.status(0), Status::CONTRACTIBLE);
      EXPECT_TRUE(network.contraction(0).is_valid());
      EXPECT_EQ(network.length(0), 0);
    }
}

TEST(GeodesicLoop, RoundATorus)
{
  const std::uint32_t columns = 24, rows = 12;
  const Triangulation torus = triangulation_of(samples::torus(columns, rows));
  // Round the axis and round the tube, from each tenth vertex on, and both at once.
  int closed = 0;
  for (std::uint32_t start = 0; start < columns * rows; start += 10)
    for (const auto& [along_row, along_column] : {std::array<std::uint32_t, 2>{1, 0}, {0, 1}, {1, 1}}) {
      Triangulation t = torus;
      std::vector<IT::Halfedge_index> loop;
      const std::uint32_t number = along_row == 0 ? rows : columns;
      for (std::uint32_t i = 0; i < number; ++i) {
        const auto vertex = [&, x = along_row, y = along_column](std::uint32_t k) {
          return (start / columns + k * y) % rows * columns + (start % columns + k * x) % columns;
        };
        const auto part = IT::shortest_edge_path(t, IT::Vertex_index(vertex(i)), IT::Vertex_index(vertex(i + 1)));
        loop.insert(loop.end(), part.begin(), part.end());
      }
      Network network(t);
      network.add_closed_path(loop);
      const double before = network.length(0);
      const IT::Geodesic_report report = network.shorten();
      EXPECT_EQ(report.status, Status::GEODESIC) << start << ' ' << along_row << along_column;
      EXPECT_TRUE(network.is_geodesic());
      EXPECT_LE(network.length(0), before * (1 + 1e-15));
      EXPECT_GT(network.length(0), along_row == 0 ? 2.4 : 3.6); // the polygons of tube and hole
      closed += network.halfedges(0).empty() ? 0 : 1;
    }
  EXPECT_EQ(closed, 3 * 29);
}

TEST(GeodesicLoop, RoundATubeOneIsNeverLonger)
{
  // In its Delaunay triangulation, edges go round the tube from a vertex to itself.
  Triangulation tube = triangulation_of(samples::helical_tube(30));
  IT::flip_to_Delaunay(tube);
  int loops = 0;
  for (IT::Edge_index e : tube.connectivity().edges()) {
    if (!tube.connectivity().is_loop(e))
      continue;
    ++loops;
    Triangulation t = tube;
    Network network(t);
    network.add_closed_path(std::vector<IT::Halfedge_index>{t.connectivity().halfedge(e)});
    const double before = network.length(0);
    const IT::Geodesic_report report = network.shorten();
    EXPECT_LE(network.length(0), before) << e.idx();
    EXPECT_TRUE(t.connectivity().is_valid());
    EXPECT_EQ(network.is_geodesic(), report.status == Status::GEODESIC) << e.idx();
    if (network.status(0) == Status::NOT_IMPROVABLE) {
      EXPECT_EQ(network.length(0), before);
    }
  }
  EXPECT_GT(loops, 20);
}

TEST(GeodesicLoop, RoundHolesAndArms)
{
  for (int holes : {1, 2, 3}) {
    const samples::Indexed_triangles surface = plate(holes);
    const Triangulation t = triangulation_of(surface);
    ASSERT_EQ(int(t.connectivity().number_of_vertices()) - int(t.connectivity().number_of_edges()) +
                int(t.connectivity().number_of_faces()),
              2 - 2 * holes);
    const auto loop_through = [&](Triangulation& copy, const std::vector<std::array<double, 3>>& stops) {
      std::vector<IT::Halfedge_index> loop;
      for (std::size_t i = 0; i < stops.size(); ++i) {
        const auto vertex = [&](std::size_t k) {
          return IT::Vertex_index(std::find(surface.points.begin(), surface.points.end(), stops[k % stops.size()]) -
                                  surface.points.begin());
        };
        for (IT::Halfedge_index h : IT::shortest_edge_path(copy, vertex(i), vertex(i + 1)))
          loop.push_back(h);
      }
      return loop;
    };
    for (int i = 0; i < holes; ++i) {
      const double x = 2 * i;
      // Round a hole on the rim of its part of the plate; round an arm; round the whole plate between two holes.
      const std::vector<std::vector<std::array<double, 3>>> curves{
        {{x, 0, 1}, {x + 3, 0, 1}, {x + 3, 3, 1}, {x, 3, 1}},
        {{x + 1, 0, 0}, {x + 1, 1, 0}, {x + 2, 1, 1}, {x + 2, 0, 1}},
        {{x + 2, 0, 0}, {x + 2, 3, 0}, {x + 2, 3, 1}, {x + 2, 0, 1}}};
      for (std::size_t k = 0; k < (i + 1 < holes ? 3 : 2); ++k) {
        Triangulation copy = t;
        Network network(copy);
        network.add_closed_path(loop_through(copy, curves[k]));
        const double before = network.length(0);
        EXPECT_EQ(network.shorten().status, Status::GEODESIC);
        EXPECT_TRUE(network.is_geodesic());
        EXPECT_FALSE(network.halfedges(0).empty()) << holes << " holes, curve " << k;
        EXPECT_LE(network.length(0), before);
        EXPECT_GE(network.length(0), k == 2 ? 8 - 1e-14 : 4 - 1e-14); // no shorter one goes round there
        EXPECT_LE(network.length(0), k == 0 ? 8 : k == 1 ? 4 + 1e-14 : 8 + 1e-14);
      }
    }
  }
}

TEST(GeodesicLoop, StaysWhereAnotherPathIsInTheWay)
{
  // Loops round the tube of a torus that bend at their vertex, all of whose other edges are used.
  const std::uint32_t columns = 24, rows = 12;
  const Triangulation torus = triangulation_of(samples::torus(columns, rows));
  int rejected = 0;
  for (std::uint32_t start = 0; start < columns * rows; ++start) {
    Triangulation t = torus;
    const IT::Delta_complex& complex = t.connectivity();
    std::vector<std::uint32_t> ring;
    for (std::uint32_t i = 0; i < rows; ++i)
      ring.push_back((start / columns + i) % rows * columns + start % columns);
    std::vector<IT::Halfedge_index> loop;
    {
      Network fixed(t);
      fixed.add_closed_path(cycle(complex, ring));
      fixed.fix(IT::Vertex_index(start));
      ASSERT_EQ(fixed.shorten().status, Status::GEODESIC);
      loop = fixed.halfedges(0);
    }
    Network network(t);
    network.add_closed_path(loop);
    if (loop.size() != 1 || network.is_geodesic())
      continue;
    for (IT::Edge_index e : complex.edges()) {
      const IT::Halfedge_index h = complex.halfedge(e);
      if (e != complex.edge(loop[0]) && (complex.source(h).idx() == start || complex.target(h).idx() == start))
        network.add_path(std::vector<IT::Halfedge_index>{h});
    }
    const double before = network.length(0);
    EXPECT_EQ(network.shorten().status, Status::NOT_IMPROVABLE);
    EXPECT_EQ(network.halfedges(0), loop);
    EXPECT_EQ(network.length(0), before);
    EXPECT_FALSE(network.is_geodesic(0));
    EXPECT_TRUE(complex.is_valid());
    ++rejected;
  }
  EXPECT_GT(rejected, 3);
}

TEST(GeodesicLoop, IsPutBackIfTheWayRoundIsLonger)
{
  // A ring with a loop of length 1 inside. The triangle beside it has its third corner far away, and between the two
  // sides of that triangle there is a vertex so near that the way over it is long. Two more vertices are flipped away.
  const double c = 1, a = 2, gap = 0.1, r = 1.5, angle = 14 * pi / 180;
  const auto opposite = [](double x, double y, double between) {
    return std::sqrt(x * x + y * y - 2 * x * y * std::cos(between));
  };
  const double m = opposite(a, r, angle / 2), n = opposite(gap, r, angle / 2);
  const IT::Delta_complex ring = IT::make_Delta_complex_from_gluing(
    5, std::vector<std::array<std::uint32_t, 2>>{{1, 5}, {3, 8}, {6, 11}, {9, 14}, {12, 2}});
  std::vector<double> lengths(ring.number_of_edges());
  const double sides[] = {c, a, a, r, m, a, gap, n, r, r, n, gap, a, m, r};
  IT::Halfedge_index h;
  for (std::uint32_t s = 0; s < 15; ++s) {
    h = s % 3 == 0 ? ring.halfedge(IT::Face_index(s / 3)) : ring.next(h);
    lengths[ring.edge(h).idx()] = sides[s];
  }
  ASSERT_EQ(ring.number_of_vertices(), 5u);
  const std::vector<IT::Halfedge_index> loop{ring.halfedge(IT::Face_index(0))};
  const IT::Vertex_index corner = ring.target(ring.next(loop[0]));
  for (bool is_corner_fixed : {false, true}) {
    Triangulation t = Triangulation::from_lengths(ring, lengths);
    Network network(t);
    network.add_closed_path(loop);
    EXPECT_FALSE(network.is_geodesic());
    if (is_corner_fixed)
      network.fix(corner); // it keeps the curve from leaving the corner again, round which it is led
    const IT::Geodesic_report report = network.shorten();
    EXPECT_TRUE(t.connectivity().is_valid());
    if (is_corner_fixed) {
      EXPECT_EQ(report.status, Status::NOT_IMPROVABLE);
      EXPECT_EQ(report.steps, 0u);
      EXPECT_EQ(report.flips, 2u);
      EXPECT_EQ(network.halfedges(0), loop);
      EXPECT_EQ(network.length(0), c);
      for (IT::Edge_index e : ring.edges())
        EXPECT_NEAR(t.length(e), lengths[e.idx()], 1e-15);
    } else {
      EXPECT_EQ(report.status, Status::GEODESIC);
      EXPECT_NEAR(network.length(0), c - 2 * gap * std::cos(std::acos(c / (2 * a)) + angle), 1e-14);
      EXPECT_LT(network.length(0), c);
    }
  }
}

TEST(GeodesicNetwork, PathsShareEdges)
{
  const Triangulation sphere = triangulation_of(samples::bumpy_sphere(14, 11));
  Triangulation t = sphere;
  Network network(t);
  std::vector<double> alone;
  for (std::uint32_t target = 5; target < 60; target += 6) {
    network.add_path(IT::shortest_edge_path(t, IT::Vertex_index(0), IT::Vertex_index(target)));
    network.add_path(network.halfedges(network.number_of_paths() - 1));
  }
  EXPECT_EQ(network.shorten().status, Status::GEODESIC);
  EXPECT_TRUE(network.is_geodesic());
  for (std::size_t p = 0; p < network.number_of_paths(); p += 2)
    EXPECT_EQ(network.halfedges(p), network.halfedges(p + 1));
}

// Whether both are equal to the last bit, caches included.
void expect_same(const Triangulation& t, const Triangulation& before)
{
  const IT::Delta_complex& complex = t.connectivity();
  ASSERT_TRUE(complex == before.connectivity());
  for (IT::Vertex_index v : complex.vertices())
    ASSERT_EQ(complex.halfedge(v), before.connectivity().halfedge(v));
  for (IT::Edge_index e : complex.edges()) {
    ASSERT_EQ(t.edge_data(e), before.edge_data(e));
    ASSERT_EQ(t.number_of_crossings(e), before.number_of_crossings(e));
    ASSERT_EQ(t.is_input_edge(e), before.is_input_edge(e));
  }
  for (IT::Halfedge_index h : complex.halfedges())
    ASSERT_EQ(IT::internal::engine(t).correspondence().input_halfedge(h),
              IT::internal::engine(before).correspondence().input_halfedge(h));
  for (IT::Face_index f : complex.faces()) {
    ASSERT_EQ(t.face_data(f).value, before.face_data(f).value);
    ASSERT_EQ(t.face_data(f).error, before.face_data(f).error);
    ASSERT_EQ(IT::internal::Engine_numbers(IT::internal::engine(t)).is_known_to_be_straight(f),
              IT::internal::Engine_numbers(IT::internal::engine(before)).is_known_to_be_straight(f));
  }
}

// From the input, and from a Delaunay triangulation, whose faces have other numbers, and where some are straight across
// input edges.
TEST(GeodesicNetwork, RewindsToTheLastBit)
{
  for (const samples::Indexed_triangles& surface :
       {samples::bumpy_sphere(14, 11), samples::sheared_grid(8, 7, 3.), plate(2), grid(7, 6), cone(12, 5, 3.)})
    for (const bool is_flipped : {false, true}) {
      Triangulation start = triangulation_of(surface);
      if (is_flipped)
        IT::flip_to_Delaunay(start);
      const std::uint32_t n = start.connectivity().number_of_vertices();
      std::uint64_t flips = 0;
      Triangulation t = start;
      Network rewound(t);
      for (std::uint32_t v = 1; v < 12; ++v) {
        Triangulation copy = start;
        Network network(copy);
        for (Network* each : {&network, &rewound}) {
          Triangulation& own = each == &network ? copy : t;
          each->add_path(IT::shortest_edge_path(own, IT::Vertex_index(v % n), IT::Vertex_index((5 * v + n / 2) % n)));
          each->add_path(IT::shortest_edge_path(own, IT::Vertex_index(n - 1 - v % n), IT::Vertex_index(3 * v % n)));
          each->fix(IT::Vertex_index(7 * v % n));
        }
        const IT::Geodesic_report expected = network.shorten(), found = rewound.shorten();
        flips += found.flips;
        EXPECT_EQ(found.flips, expected.flips);
        EXPECT_EQ(found.steps, expected.steps);
        EXPECT_EQ(found.tests, expected.tests);
        EXPECT_EQ(found.status, expected.status);
        for (std::size_t p : {0, 1}) {
          EXPECT_EQ(rewound.halfedges(p), network.halfedges(p));
          EXPECT_EQ(rewound.length(p), network.length(p));
          const auto points = IT::geodesic_points(t, rewound.halfedges(p)),
                     expected_points = IT::geodesic_points(copy, network.halfedges(p));
          ASSERT_EQ(points.size(), expected_points.size());
          for (std::size_t i = 0; i < points.size(); ++i) {
            EXPECT_EQ(points[i].halfedge, expected_points[i].halfedge);
            EXPECT_EQ(points[i].coordinates, expected_points[i].coordinates);
          }
        }
        rewound.rewind();
        EXPECT_EQ(rewound.number_of_paths(), 0u);
        ASSERT_NO_FATAL_FAILURE(expect_same(t, start));
      }
      EXPECT_GT(flips, 10u);
    }
}

TEST(GeodesicNetwork, FixedVerticesConstrainedEdgesAndBudgets)
{
  const Triangulation plane = triangulation_of(grid(6, 6));
  const auto corner_path = [](const Triangulation& t) {
    std::vector<IT::Halfedge_index> path;
    for (std::uint32_t x = 0; x < 6; ++x)
      path.push_back(halfedge_between(t.connectivity(), x, x + 1));
    for (std::uint32_t y = 0; y < 6; ++y)
      path.push_back(halfedge_between(t.connectivity(), y * 7 + 6, y * 7 + 13));
    return path;
  };
  {
    Triangulation t = plane;
    Network network(t);
    network.add_path(corner_path(t));
    network.fix(IT::Vertex_index(6));
    EXPECT_EQ(network.shorten().status, Status::GEODESIC);
    EXPECT_EQ(network.length(0), 12);
  }
  { // a wall from (3, 1) to (5, 1) is passed at its ends
    Triangulation t = plane;
    const IT::Edge_index a = t.connectivity().edge(halfedge_between(t.connectivity(), 10, 11)),
                         b = t.connectivity().edge(halfedge_between(t.connectivity(), 11, 12));
    const auto wall =
      boost::make_function_property_map<IT::Edge_index>([&](IT::Edge_index e) { return e == a || e == b; });
    Network network(t, CGAL::parameters::edge_is_constrained_map(wall));
    network.add_path(corner_path(t));
    EXPECT_EQ(network.shorten().status, Status::GEODESIC);
    EXPECT_TRUE(network.is_geodesic());
    EXPECT_NEAR(network.length(0), std::hypot(5, 1) + std::hypot(1, 5), 1e-14);
  }
  { // a budget, and then the rest
    Triangulation t = plane;
    Network network(t);
    network.add_path(corner_path(t));
    const IT::Geodesic_report report = network.shorten(CGAL::parameters::maximum_number(std::uint64_t(3)));
    EXPECT_EQ(report.status, Status::UNFINISHED);
    EXPECT_EQ(report.flips, 3u);
    EXPECT_LE(network.length(0), 12);
    EXPECT_EQ(network.shorten().status, Status::GEODESIC);
    EXPECT_NEAR(network.length(0), std::sqrt(72), 1e-14);
  }
  { // another path in the way
    Triangulation t = plane;
    Network network(t);
    network.add_path(std::vector<IT::Halfedge_index>{halfedge_between(t.connectivity(), 6, 13),
                                                     halfedge_between(t.connectivity(), 13, 12)});
    network.add_path(std::vector<IT::Halfedge_index>{halfedge_between(t.connectivity(), 5, 13)});
    EXPECT_EQ(network.shorten().status, Status::BLOCKED);
    EXPECT_FALSE(network.is_geodesic());
    EXPECT_EQ(network.status(1), Status::GEODESIC);
  }
}

TEST(GeodesicNetwork, PathsThatCrossInAVertexStayThere)
{
  const Triangulation plane = triangulation_of(grid(6, 6));
  const auto& complex = plane.connectivity();
  std::vector<IT::Halfedge_index> column;
  for (std::uint32_t y = 0; y < 6; ++y)
    column.push_back(halfedge_between(complex, 7 * y + 3, 7 * y + 10));
  // Through (3, 2): from (2, 2) to (4, 3), on the other side of the column; or to (3, 1) and (2, 1), which is on the
  // same side.
  const std::vector<IT::Halfedge_index> crossing{halfedge_between(complex, 16, 17), halfedge_between(complex, 17, 25)},
    touching{halfedge_between(complex, 16, 17), halfedge_between(complex, 17, 10), halfedge_between(complex, 10, 9)};
  for (int kind = 0; kind < 3; ++kind) {
    Triangulation t = plane;
    Network network(t);
    network.add_path(column);
    network.add_path(kind == 0 ? touching : crossing);
    if (kind == 2)
      network.fix(IT::Vertex_index(17));
    network.shorten();
    EXPECT_EQ(network.status(0), Status::GEODESIC);
    EXPECT_EQ(network.length(0), 6);
    EXPECT_EQ(network.status(1), kind == 1 ? Status::BLOCKED : Status::GEODESIC);
    EXPECT_EQ(network.is_geodesic(1), kind != 1);
    EXPECT_NEAR(network.length(1), kind == 0 ? 1 : 1 + std::sqrt(2.), 1e-15);
  }
}

TEST(GeodesicPath, IsMarkedInTheOverlay)
{
  Triangulation t = triangulation_of(samples::bumpy_sphere(12, 9));
  Network network(t);
  network.add_path(IT::shortest_edge_path(t, IT::Vertex_index(3), IT::Vertex_index(70)));
  network.shorten();
  const std::vector<IT::Halfedge_index> path = network.halfedges(0);
  const std::vector<IT::Surface_point> points = IT::geodesic_points(t, path);
  const IT::Common_subdivision subdivision(t);
  const IT::Overlay& overlay = subdivision.overlay();
  const std::vector<IT::Overlay::Segment> segments = IT::geodesic_segments(overlay, t.connectivity(), path);
  ASSERT_EQ(segments.size() + 1, points.size());
  const auto& input = subdivision.input();
  const auto surface = samples::bumpy_sphere(12, 9);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    // Both ends, in either order, are those of the path.
    const auto h = overlay.halfedge(segments[i]);
    const auto a = subdivision.point(overlay.source(h), surface.points),
               b = subdivision.point(overlay.target(h), surface.points);
    const auto p = IT::point_in_space(input, surface.points, points[i]),
               q = IT::point_in_space(input, surface.points, points[i + 1]);
    const auto distance = [](const auto& x, const auto& y) {
      return std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]);
    };
    EXPECT_LT((std::min)((std::max)(distance(a, p), distance(b, q)), (std::max)(distance(a, q), distance(b, p))),
              1e-14);
  }
}

TEST(GeodesicPath, BetweenInsertedVertices)
{
  // Inside of faces and on edges of a folded sheet; paths over it are straight in the unfolding.
  const auto surface = grid(6, 4, [](double, double y) { return 0.75 * y; });
  Triangulation t = triangulation_of(surface);
  const std::size_t n = surface.points.size();
  const auto input_of = [&] { return t.input(); };
  for (std::size_t i = 0; i < 12; ++i) {
    const bool is_on_edge = i < 3; // far from each other, so that these edges were not flipped
    const IT::Halfedge_index h = input_of().halfedge(IT::Face_index(17 * i % surface.triangles.size()));
    IT::insert_vertex(t, {h, {0.25, is_on_edge ? 0.75 : 0.5, is_on_edge ? 0 : 0.25}});
  }
  ASSERT_EQ(t.connectivity().number_of_vertices(), n + 12);
  const IT::Delta_complex input = input_of();
  int tried = 0;
  for (std::size_t s = n; s < t.connectivity().number_of_vertices(); ++s)
    for (std::size_t target : {std::size_t(0), s + 1}) {
      if (target >= t.connectivity().number_of_vertices())
        continue;
      Triangulation copy = t;
      Network network(copy);
      network.add_path(IT::shortest_edge_path(copy, IT::Vertex_index(s), IT::Vertex_index(target)));
      ASSERT_EQ(network.shorten().status, Status::GEODESIC);
      const auto points = IT::geodesic_points(copy, network.halfedges(0));
      const auto at = [&](std::size_t i) { return IT::point_in_space(input, surface.points, points[i]); };
      const auto distance = [](const auto& x, const auto& y) {
        return std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]);
      };
      EXPECT_NEAR(network.length(0), distance(at(0), at(points.size() - 1)), 1e-13);
      double sum = 0;
      for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        sum += distance(at(i), at(i + 1));
        const auto& c = points[i].coordinates;
        EXPECT_NEAR(c[0] + c[1] + c[2], 1, 1e-15);
      }
      EXPECT_NEAR(sum, network.length(0), 1e-13);
      ++tried;
    }
  EXPECT_GT(tried, 12);
}

TEST(GeodesicNetwork, WrongPathsAreNamed)
{
  Triangulation t = triangulation_of(grid(3, 3));
  Network network(t);
  const auto h = halfedge_between(t.connectivity(), 0, 1), g = halfedge_between(t.connectivity(), 2, 3);
  EXPECT_THROW(network.add_path(std::vector<IT::Halfedge_index>{h, g}), IT::Invalid_argument_error);
  EXPECT_THROW(network.add_path(std::vector<IT::Halfedge_index>{IT::Halfedge_index(9999)}), IT::Invalid_argument_error);
  EXPECT_THROW(network.add_closed_path(std::vector<IT::Halfedge_index>{h}), IT::Invalid_argument_error);
  EXPECT_THROW(network.add_closed_path(std::vector<IT::Halfedge_index>{}), IT::Invalid_argument_error);
  EXPECT_EQ(network.number_of_paths(), 0u);
  network.add_path(std::vector<IT::Halfedge_index>{});
  network.add_path(std::vector<IT::Halfedge_index>{h, t.connectivity().opposite(h)}); // out and back
  EXPECT_EQ(network.shorten().status, Status::GEODESIC);
  EXPECT_TRUE(network.halfedges(1).empty());
}

TEST(TracedLine, OnAPlane)
{
  const samples::Indexed_triangles surface = grid(40, 30);
  const Triangulation t = triangulation_of(surface);
  const auto& input = t.input();
  std::mt19937 random(3);
  for (int i = 0; i < 300; ++i) {
    IT::Halfedge_index h(random() % t.connectivity().number_of_halfedges());
    if (input.is_border(h))
      h = input.opposite(h);
    const double a = random() % 1000, b = random() % 1000, c = random() % 1000;
    const IT::Surface_direction start{{h, {a + 1, b + 1, c + 1}}, {a - 500, b - 500}};
    const IT::Traced_geodesic line = IT::trace_geodesic(t, start, 7);
    const auto from = IT::point_in_space(input, surface.points, line.points.front()),
               to = IT::point_in_space(input, surface.points, line.points.back());
    const double dx = to[0] - from[0], dy = to[1] - from[1];
    EXPECT_NEAR(std::hypot(dx, dy), line.length, 1e-13);
    if (line.status == IT::Trace_status::AT_LENGTH) {
      EXPECT_EQ(line.length, 7);
    } else {
      EXPECT_LT((std::min)({to[0], 40 - to[0], to[1], 30 - to[1]}), 1e-13);
    }
    for (const IT::Surface_point& p : line.points) {
      const auto x = IT::point_in_space(input, surface.points, p);
      EXPECT_NEAR((x[0] - from[0]) * dy, (x[1] - from[1]) * dx, 1e-12);
    }
  }
}

TEST(TracedLine, ExactlyThroughAVertex)
{
  const Triangulation t = triangulation_of(grid(8, 8, [](double, double y) { return 0.75 * y; }));
  const IT::Halfedge_index h = halfedge_between(t.connectivity(), 0, 1);
  // From (0, 0) to (2, 1): in the first face, that is 1 times the first side and 1 times the diagonal.
  const IT::Traced_geodesic line = IT::trace_geodesic(t, {{h, {1, 0, 0}}, {1, 1}}, 100);
  EXPECT_EQ(line.status, IT::Trace_status::AT_VERTEX);
  EXPECT_EQ(line.vertex.idx(), 11u);
  EXPECT_NEAR(line.length, std::sqrt(4 + 1.5625), 1e-15);
  // A little beside it, the line goes on to the border.
  const IT::Traced_geodesic beside = IT::trace_geodesic(t, {{h, {1, 0, 0}}, {1, 1 + 0x1p-50}}, 100);
  EXPECT_EQ(beside.status, IT::Trace_status::AT_BORDER);
  // Along an edge.
  const IT::Traced_geodesic along = IT::trace_geodesic(t, {{h, {1, 0, 0}}, {1, 0}}, 0.5);
  EXPECT_EQ(along.status, IT::Trace_status::AT_LENGTH);
  EXPECT_EQ(along.points.back().coordinates, (std::array<double, 3>{0.5, 0.5, 0}));
}

TEST(TracedLine, ClosesOnATetrahedron)
{
  // All four faces of a disphenoid are congruent: each line that is parallel to a lattice vector closes up.
  samples::Indexed_triangles surface;
  surface.points = {{1, 2, 3}, {1, -2, -3}, {-1, 2, -3}, {-1, -2, 3}};
  surface.triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  const Triangulation t = triangulation_of(surface);
  const auto& input = t.input();
  // Twice a sum of sides is a period of the unfolding.
  const IT::Halfedge_index h(0);
  const double a = 501, b = 2;
  const auto x = [&](IT::Halfedge_index g) {
    return std::array<double, 3>{surface.points[input.target(g).idx()][0] - surface.points[input.source(g).idx()][0],
                                 surface.points[input.target(g).idx()][1] - surface.points[input.source(g).idx()][1],
                                 surface.points[input.target(g).idx()][2] - surface.points[input.source(g).idx()][2]};
  };
  const auto u = x(h), v = x(input.opposite(input.prev(h)));
  const double length = 2 * std::hypot(a * u[0] + b * v[0], a * u[1] + b * v[1], a * u[2] + b * v[2]);
  const IT::Traced_geodesic line = IT::trace_geodesic(t, {{h, {0.3, 0.45, 0.25}}, {a, b}}, length);
  ASSERT_EQ(line.status, IT::Trace_status::AT_LENGTH);
  EXPECT_GT(line.points.size(), 1000u);
  const auto from = IT::point_in_space(input, surface.points, line.points.front()),
             to = IT::point_in_space(input, surface.points, line.points.back());
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(from[i], to[i], 1e-12);
  for (std::size_t number : {std::size_t(1), std::size_t(100), line.points.size() - 2}) {
    const IT::Traced_geodesic first =
      IT::trace_geodesic(t, {{h, {0.3, 0.45, 0.25}}, {a, b}}, length, CGAL::parameters::maximum_number(number));
    EXPECT_EQ(first.status, IT::Trace_status::BUDGET_EXHAUSTED);
    ASSERT_EQ(first.points.size(), number + 1);
    for (std::size_t i = 0; i <= number; ++i)
      EXPECT_EQ(first.points[i].coordinates, line.points[i].coordinates);
    EXPECT_GT(first.length, 0);
    EXPECT_LT(first.length, length);
  }
  const std::size_t all = line.points.size() - 1;
  EXPECT_EQ(
    IT::trace_geodesic(t, {{h, {0.3, 0.45, 0.25}}, {a, b}}, length, CGAL::parameters::maximum_number(all)).status,
    IT::Trace_status::AT_LENGTH);
}

// On finer meshes of a sphere, a line stays nearer to the great circle that it starts on.
TEST(TracedLine, FollowsAGreatCircle)
{
  const auto largest_distance = [](std::size_t columns) {
    const samples::Indexed_triangles sphere = samples::latitude_longitude_sphere(columns, columns / 2);
    const Triangulation t = triangulation_of(sphere);
    const IT::Delta_complex& input = t.connectivity();
    double result = 0;
    for (double angle = 0.05; angle < 6.2; angle += 0.2) {
      const IT::Halfedge_index h = input.opposite(input.halfedge(IT::Vertex_index(columns * (columns / 4) + 1)));
      const IT::Traced_geodesic line = IT::trace_geodesic(t, IT::direction_at_vertex(t, h, angle), 3);
      EXPECT_NEAR(line.length, 3, 1e-12);
      std::vector<std::array<double, 3>> points;
      for (const IT::Surface_point& p : line.points)
        points.push_back(IT::point_in_space(input, sphere.points, p));
      const auto& [a, b, c] = points[0];
      const auto& [x, y, z] = points[1];
      std::array<double, 3> normal{b * z - c * y, c * x - a * z, a * y - b * x};
      const double size = std::hypot(normal[0], normal[1], normal[2]);
      for (const auto& p : points)
        result = std::max(result, std::abs(normal[0] * p[0] + normal[1] * p[1] + normal[2] * p[2]) / size);
    }
    return result;
  };
  const double coarse = largest_distance(24), fine = largest_distance(96);
  EXPECT_LT(coarse, 0.2);
  EXPECT_LT(fine, coarse / 3);
}

TEST(TracedLine, DirectionsAtVertices)
{
  const Triangulation t = triangulation_of(grid(4, 4));
  const IT::Halfedge_index h = halfedge_between(t.connectivity(), 12, 13);
  const auto& input = t.input();
  for (double angle : {0.1, 1., 2., 3., 4., 5., 6., -1., 7.}) {
    const IT::Traced_geodesic line = IT::trace_geodesic(t, IT::direction_at_vertex(t, h, angle), 1.75);
    const auto x = IT::point_in_space(input, grid(4, 4).points, line.points.back());
    EXPECT_NEAR(x[0], 2 + 1.75 * std::cos(angle), 1e-14);
    EXPECT_NEAR(x[1], 2 + 1.75 * std::sin(angle), 1e-14);
  }
  const IT::Halfedge_index at_border = halfedge_between(t.connectivity(), 0, 1);
  EXPECT_NO_THROW(IT::direction_at_vertex(t, at_border, 1.5));
  EXPECT_THROW(IT::direction_at_vertex(t, at_border, 1.6), IT::Invalid_point_error);
  EXPECT_THROW(IT::direction_at_vertex(t, at_border, std::nan("")), IT::Invalid_point_error);
}

TEST(TracedLine, WrongStartsAreNamed)
{
  const Triangulation t = triangulation_of(grid(2, 2));
  const IT::Halfedge_index h = halfedge_between(t.connectivity(), 0, 1);
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_THROW(IT::trace_geodesic(t, {{h, {1, 1, 1}}, {0, 0}}, 1), IT::Invalid_point_error);
  EXPECT_THROW(IT::trace_geodesic(t, {{h, {1, 1, 0}}, {1, -1}}, 1), IT::Invalid_point_error);
  EXPECT_THROW(IT::trace_geodesic(t, {{h, {1, 1, -1}}, {1, 1}}, 1), IT::Invalid_point_error);
  EXPECT_THROW(IT::trace_geodesic(t, {{h, {0, 0, 0}}, {1, 1}}, 1), IT::Invalid_point_error);
  EXPECT_THROW(IT::trace_geodesic(t, {{h, {1, 1, 1}}, {1, inf}}, 1), IT::Invalid_point_error);
  EXPECT_THROW(IT::trace_geodesic(t, {{h, {1, 1, 1}}, {1, 1}}, inf), IT::Invalid_argument_error);
  EXPECT_THROW(IT::trace_geodesic(t, {{h, {1, 1, 1}}, {1, 1}}, -1), IT::Invalid_argument_error);
  EXPECT_THROW(IT::trace_geodesic(t, {{t.connectivity().opposite(h), {1, 1, 1}}, {1, 1}}, 1), IT::Invalid_point_error);
  EXPECT_THROW(IT::trace_geodesic(t, {{IT::Halfedge_index(), {1, 1, 1}}, {1, 1}}, 1), IT::Invalid_point_error);
  EXPECT_EQ(IT::trace_geodesic(t, {{h, {1, 1, 1}}, {1, 1}}, 0).length, 0);
}
