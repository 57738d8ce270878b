// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Exactly the vertices in flat sides and on straight edges are removed, and the sides do not change.

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/surface_features.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Point = std::array<double, 3>;

struct Surface
{
  IT::Delta_complex complex;
  std::vector<Point> points;
};

Surface surface_of(const samples::Indexed_triangles& sample)
{
  return {IT::make_Delta_complex_from_triangles(sample.points.size(), sample.triangles), sample.points};
}

// The surface of cubes of side 1, each side of a cube cut in two triangles.
Surface cubes(const std::vector<std::array<int, 3>>& cells)
{
  std::map<std::array<int, 3>, std::uint32_t> number;
  samples::Indexed_triangles result;
  const auto vertex = [&](std::array<int, 3> p) {
    const auto [position, is_new] = number.emplace(p, std::uint32_t(result.points.size()));
    if (is_new)
      result.points.push_back({double(p[0]), double(p[1]), double(p[2])});
    return position->second;
  };
  for (const auto& cell : cells)
    for (int axis = 0; axis < 3; ++axis)
      for (int side : {0, 1}) {
        std::array<int, 3> beside = cell;
        beside[axis] += side == 0 ? -1 : 1;
        if (std::find(cells.begin(), cells.end(), beside) != cells.end())
          continue;
        std::array<int, 3> corner = cell;
        corner[axis] += side;
        std::array<std::uint32_t, 4> q;
        for (int k = 0; k < 4; ++k) {
          std::array<int, 3> p = corner;
          p[(axis + 1) % 3] += k == 1 || k == 2 ? 1 : 0;
          p[(axis + 2) % 3] += k >= 2 ? 1 : 0;
          q[k] = vertex(p);
        }
        if (side == 0)
          std::swap(q[1], q[3]);
        result.triangles.push_back({q[0], q[1], q[2]});
        result.triangles.push_back({q[0], q[2], q[3]});
      }
  return surface_of(result);
}

Point minus(const Point& p, const Point& q) { return {p[0] - q[0], p[1] - q[1], p[2] - q[2]}; }

// Twice the area of a face, as a vector. Exact for small integers.
Point normal(const Surface& s, IT::Face_index f)
{
  const IT::Halfedge_index h = s.complex.halfedge(f);
  const Point& p = s.points[s.complex.source(h).idx()];
  const Point u = minus(s.points[s.complex.target(h).idx()], p),
              v = minus(s.points[s.complex.target(s.complex.next(h)).idx()], p);
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

// The plane of a face: its normal in lowest terms, and the product of that with a point. \pre the coordinates are
// integers
std::array<std::int64_t, 4> plane(const Surface& s, IT::Face_index f)
{
  const Point n = normal(s, f), p = s.points[s.complex.source(s.complex.halfedge(f)).idx()];
  std::array<std::int64_t, 4> result{};
  std::int64_t divisor = 0;
  for (int i = 0; i < 3; ++i)
    divisor = std::gcd(divisor, std::int64_t(n[i]));
  for (int i = 0; i < 3; ++i) {
    result[i] = std::int64_t(n[i]) / divisor;
    result[3] += result[i] * std::int64_t(p[i]);
  }
  return result;
}

// The area in each plane with its side, in units of the normal. Faces that are turned over or stick out would change
// it.
std::map<std::array<std::int64_t, 4>, std::int64_t> areas(const Surface& s)
{
  std::map<std::array<std::int64_t, 4>, std::int64_t> result;
  for (IT::Face_index f : s.complex.faces()) {
    const Point n = normal(s, f);
    const auto key = plane(s, f);
    const int axis = key[0] != 0 ? 0 : key[1] != 0 ? 1 : 2;
    result[key] += std::int64_t(n[axis]) / key[axis];
  }
  return result;
}

// Flips edges in the middle of flat sides at random.
void flip_flat_edges(Surface& s, std::mt19937& random, int number)
{
  for (int i = 0; i < number; ++i) {
    const IT::Edge_index e(std::uint32_t(random() % s.complex.number_of_edges()));
    if (!s.complex.is_flippable(e))
      continue;
    const IT::Face_index f = s.complex.face(s.complex.halfedge(e)),
                         g = s.complex.face(s.complex.opposite(s.complex.halfedge(e)));
    const auto before = plane(s, f);
    if (before != plane(s, g))
      continue;
    s.complex.flip(e);
    if (normal(s, f) == Point{} || normal(s, g) == Point{} || plane(s, f) != before || plane(s, g) != before)
      s.complex.flip_back(e);
  }
}

// \return the number of vertices that were removed
std::size_t expect_the_same_sides_without_flat_vertices(Surface& s)
{
  const auto before = areas(s);
  const std::vector<Point> points = s.points;
  const auto characteristic = [](const IT::Delta_complex& c) {
    return int(c.number_of_vertices()) - int(c.number_of_edges()) + int(c.number_of_faces());
  };
  const int euler = characteristic(s.complex);
  const std::vector<IT::Vertex_index> origin = IT::remove_flat_vertices(s.complex, s.points);
  EXPECT_TRUE(s.complex.is_valid());
  EXPECT_EQ(characteristic(s.complex), euler);
  EXPECT_EQ(areas(s), before);
  EXPECT_EQ(origin.size(), s.complex.number_of_vertices());
  EXPECT_EQ(origin.size(), s.points.size());
  for (std::size_t v = 0; v < origin.size(); ++v)
    EXPECT_EQ(s.points[v], points[origin[v].idx()]);
  const std::size_t number = s.points.size();
  EXPECT_EQ(IT::remove_flat_vertices(s.complex, s.points).size(), number); // nothing is left to do
  return points.size() - number;
}

TEST(Remove_flat_vertices, leaves_the_corners_of_blocks)
{
  std::mt19937 random(1);
  std::vector<std::array<int, 3>> block, ring, stairs;
  for (int x = 0; x < 5; ++x)
    for (int y = 0; y < 5; ++y)
      for (int z = 0; z < 5; ++z) {
        block.push_back({x, y, z});
        if (z < 2 && (x == 0 || y == 0 || x == 4 || y == 4))
          ring.push_back({x, y, z});
        if (x / 2 + z / 2 < 3)
          stairs.push_back({x, y, z});
      }
  for (const auto& [cells, corners] : {std::pair{block, 8}, {ring, 16}, {stairs, 16}})
    for (int flips : {0, 20, 5000}) {
      Surface s = cubes(cells);
      for (Point& p : s.points) // an affine map keeps flat parts flat
        p = {3 * p[0] + p[1], 2 * p[1] - p[2] + p[0], 5 * p[2] + p[0]};
      flip_flat_edges(s, random, flips);
      expect_the_same_sides_without_flat_vertices(s);
      EXPECT_EQ(s.points.size(), std::size_t(corners));
    }
}

TEST(Remove_flat_vertices, keeps_the_metric)
{
  std::vector<std::array<int, 3>> cells;
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 4; ++j)
      for (int k = 0; k < (i < 5 ? 1 : 2); ++k)
        cells.push_back({i, j, k});
  Surface s = cubes(cells);
  const IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits> before(s.complex, s.points);
  const std::vector<IT::Vertex_index> origin = IT::remove_flat_vertices(s.complex, s.points);
  const IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits> after(s.complex, s.points);
  std::vector<bool> is_left(before.connectivity().number_of_vertices());
  for (IT::Vertex_index v : s.complex.vertices()) {
    is_left[origin[v.idx()].idx()] = true;
    EXPECT_NEAR(IT::angle_defect(after, v), IT::angle_defect(before, origin[v.idx()]), 1e-13);
  }
  for (IT::Vertex_index v : before.connectivity().vertices())
    if (!is_left[v.idx()]) {
      EXPECT_NEAR(IT::angle_defect(before, v), 0, 1e-13);
    }
  EXPECT_LT(s.points.size(), is_left.size());
}

// A vertex in the middle of a polygon that is seen from it as a whole, with many corners in line with each other.
TEST(Remove_flat_vertices, of_any_star)
{
  std::mt19937 random(2);
  int number_of_stars = 0;
  for (int run = 0; run < 3000; ++run) {
    const int range = run % 3 == 0 ? 2 : run % 3 == 1 ? 6 : 1000;
    const auto coordinate = [&] { return int(random() % (2 * range + 1)) - range; };
    std::map<std::pair<int, int>, std::pair<int, int>> corner_by_direction;
    const int number = 3 + int(random() % 30);
    for (int i = 0; i < number; ++i) {
      const int x = coordinate(), y = coordinate(), divisor = std::gcd(x, y);
      if (divisor != 0)
        corner_by_direction[{x / divisor, y / divisor}] = {x, y};
    }
    std::vector<std::pair<int, int>> corners;
    for (const auto& item : corner_by_direction)
      corners.push_back(item.second);
    std::sort(corners.begin(), corners.end(),
              [](auto a, auto b) { return std::atan2(a.second, a.first) < std::atan2(b.second, b.first); });
    samples::Indexed_triangles star;
    star.points.push_back({7, 7, 7});
    bool is_star = corners.size() > 2;
    const auto number_of_corners = std::uint32_t(corners.size());
    for (std::uint32_t i = 0; i < number_of_corners; ++i) {
      const auto [x, y] = corners[i];
      const auto [z, w] = corners[(i + 1) % number_of_corners];
      star.points.push_back({7. + x, 7. + y, 7. + 2 * x - 3 * y});
      star.triangles.push_back({0, i + 1, (i + 1) % number_of_corners + 1});
      is_star = is_star && x * w - y * z > 0;
    }
    if (!is_star)
      continue;
    ++number_of_stars;
    Surface s = surface_of(star);
    EXPECT_EQ(expect_the_same_sides_without_flat_vertices(s), 1u);
  }
  EXPECT_GT(number_of_stars, 2000);
}

// The faces around vertex 0, between points that are given in order.
Surface fan(const std::vector<Point>& points)
{
  samples::Indexed_triangles result;
  result.points.push_back({0, 0, 0});
  const auto number = std::uint32_t(points.size());
  for (std::uint32_t i = 0; i < number; ++i) {
    result.points.push_back(points[i]);
    result.triangles.push_back({0, i + 1, (i + 1) % number + 1});
  }
  return surface_of(result);
}

TEST(Remove_flat_vertices, is_exact)
{
  const double ulp = 0x1p-52;
  const auto number_left = [](const std::vector<Point>& points) {
    Surface s = fan(points);
    IT::remove_flat_vertices(s.complex, s.points);
    return s.points.size();
  };
  EXPECT_EQ(number_left({{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}), 4u);
  EXPECT_EQ(number_left({{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 1e-300}}), 4u); // folded along a straight line
  EXPECT_EQ(number_left({{1, 0, 0}, {0, 1, 0}, {-1, 0, 1e-300}, {0, -1, 1e-300}}), 5u);
  EXPECT_EQ(number_left({{1, 0, 0}, {0, 1, 1}, {-1, 0, 0}, {0, -1, 5}}), 4u);
  EXPECT_EQ(number_left({{1, 0, 0}, {0, 1, 1}, {-1, 5e-324, 0}, {0, -1, 5}}), 5u);
  EXPECT_EQ(number_left({{1, 1, 1}, {-1, 2, 2 + 2 * ulp}, {-2, -1, -1}, {1, -2, -2}}), 5u);
  EXPECT_EQ(number_left({{1, 1, 1}, {-1, 2, 2}, {-2, -1, -1}, {1, -2, -2}}), 4u);
  EXPECT_EQ(number_left({{1e200, 0, 0}, {0, 1e200, 0}, {-1e200, -1e200, 0}}), 3u);
  EXPECT_EQ(number_left({{1, 0, 0}, {0, 1, 0}, {-1, 1, 1}, {-1, -1, 0}, {0, -1, 0}}), 6u); // a ridge that ends here
}

TEST(Remove_flat_vertices, cuts_no_corner_off_that_has_others_behind_it)
{
  std::vector<Point> arrow = {{10, -1, 0}, {1, 10, 0}, {-10, -1, 0}, {0, -0.5, 0}};
  for (std::size_t turn = 0; turn < arrow.size(); ++turn) {
    Surface s = fan(arrow);
    IT::remove_flat_vertices(s.complex, s.points);
    ASSERT_EQ(s.points.size(), 4u);
    for (IT::Face_index f : s.complex.faces())
      EXPECT_GT(normal(s, f)[2], 0);
    std::rotate(arrow.begin(), arrow.begin() + 1, arrow.end());
  }
}

TEST(Remove_flat_vertices, keeps_what_only_looks_flat)
{
  const std::vector<Point> once = {{2, 0, 0}, {1, 2, 0}, {-2, 1, 0}, {-1, -2, 0}, {1, -2, 0}};
  std::vector<Point> twice = once;
  twice.insert(twice.end(), once.begin(), once.end());
  for (const std::vector<Point>& points :
       {twice, // the angles sum to 4 pi
        // half a turn, and one and a half on the other side of a straight line
        {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 0, -1}, {-1, 0, 0}, {0, 0, 1}},
        // a full turn on both sides of a line that returns
        {{1, 0, 0}, {0, 1, 0}, {-1, -1, 0}, {2, 0, 0}, {0, 0, 1}, {-1, 0, -1}},
        // faces that lie on each other
        {{2, 0, 0}, {10, 17, 0}, {2.6, 1.5, 0}, {-2, 0.1, 0}, {0, -2, 0}},
        // a face of zero area
        {{1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}}) {
    Surface s = fan(points);
    const IT::Delta_complex before = s.complex;
    EXPECT_EQ(IT::remove_flat_vertices(s.complex, s.points).size(), points.size() + 1);
    EXPECT_TRUE(s.complex == before);
  }
}

TEST(Remove_flat_vertices, keeps_borders_and_curved_surfaces)
{
  for (const samples::Indexed_triangles& sample :
       {samples::bumpy_dome(), samples::torus(8, 6), samples::bumpy_sphere()}) {
    Surface s = surface_of(sample);
    const IT::Delta_complex before = s.complex;
    EXPECT_EQ(IT::remove_flat_vertices(s.complex, s.points).size(), sample.points.size());
    EXPECT_TRUE(s.complex == before);
  }
  samples::Indexed_triangles grid;
  for (std::uint32_t y = 0; y < 4; ++y)
    for (std::uint32_t x = 0; x < 4; ++x) {
      const std::uint32_t v = 4 * y + x;
      grid.points.push_back({double(x), double(y), 0});
      if (x < 3 && y < 3) {
        grid.triangles.push_back({v, v + 1, v + 5});
        grid.triangles.push_back({v, v + 5, v + 4});
      }
    }
  Surface s = surface_of(grid);
  EXPECT_EQ(expect_the_same_sides_without_flat_vertices(s), 4u);
}

// The distance from a triangle.
double distance(const Point& p, const Point& a, const Point& b, const Point& c)
{
  const auto dot = [](const Point& u, const Point& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; };
  const auto to_side = [&](const Point& u, const Point& v) {
    const Point along = minus(v, u), d = minus(p, u);
    const double t = std::max(0., std::min(1., dot(along, d) / dot(along, along)));
    return std::hypot(d[0] - t * along[0], d[1] - t * along[1], d[2] - t * along[2]);
  };
  double result = std::min({to_side(a, b), to_side(b, c), to_side(c, a)});
  const Point u = minus(b, a), v = minus(c, a), d = minus(p, a);
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), determinant = uu * vv - uv * uv;
  const double s = (vv * dot(u, d) - uv * dot(v, d)) / determinant, t = (uu * dot(v, d) - uv * dot(u, d)) / determinant;
  if (s >= 0 && t >= 0 && s + t <= 1)
    result =
      std::min(result, std::hypot(d[0] - s * u[0] - t * v[0], d[1] - s * u[1] - t * v[1], d[2] - s * u[2] - t * v[2]));
  return result;
}

// The largest distance of a point from a surface.
double largest_distance(const std::vector<Point>& points, const Surface& s)
{
  double largest = 0;
  for (const Point& p : points) {
    double smallest = 1e300;
    for (IT::Face_index f : s.complex.faces()) {
      const IT::Halfedge_index h = s.complex.halfedge(f);
      smallest =
        std::min(smallest, distance(p, s.points[s.complex.source(h).idx()], s.points[s.complex.target(h).idx()],
                                    s.points[s.complex.target(s.complex.next(h)).idx()]));
    }
    largest = std::max(largest, smallest);
  }
  return largest;
}

Surface turned_block()
{
  std::vector<std::array<int, 3>> cells;
  for (int x = 0; x < 5; ++x)
    for (int y = 0; y < 4; ++y)
      for (int z = 0; z < 3; ++z)
        cells.push_back({x, y, z});
  Surface s = cubes(cells);
  for (Point& p : s.points) {
    p = {std::cos(0.7) * p[0] - std::sin(0.7) * p[1], std::sin(0.7) * p[0] + std::cos(0.7) * p[1], p[2]};
    p = {p[0], std::cos(1.1) * p[1] - std::sin(1.1) * p[2], std::sin(1.1) * p[1] + std::cos(1.1) * p[2]};
  }
  return s;
}

TEST(Remove_nearly_flat_vertices, leaves_the_corners_of_a_block_that_was_turned)
{
  for (double scale : {1e-3, 1., 1e3}) {
    Surface s = turned_block();
    for (Point& p : s.points)
      for (double& x : p)
        x *= scale;
    const std::vector<Point> points = s.points;
    Surface exact = s;
    IT::remove_flat_vertices(exact.complex, exact.points);
    EXPECT_GT(exact.points.size(), 40u); // exactly, few are flat
    const IT::Flat_vertex_removal removal = IT::remove_nearly_flat_vertices(s.complex, s.points, 1e-12 * scale);
    EXPECT_TRUE(s.complex.is_valid());
    EXPECT_EQ(s.points.size(), 8u);
    EXPECT_EQ(removal.vertices.size(), 8u);
    EXPECT_GT(removal.deviation, 0);
    EXPECT_LE(removal.deviation, 1e-12 * scale);
    EXPECT_LE(largest_distance(points, s), 1e-12 * scale);
  }
}

// Random heights on a block: with a larger tolerance fewer vertices are left, and no point is farther away than
// reported.
TEST(Remove_nearly_flat_vertices, keeps_the_distance)
{
  std::mt19937 random(3);
  Surface noisy = turned_block();
  for (Point& p : noisy.points)
    for (double& x : p)
      x += 1e-3 * (double(random()) / 4294967296. - 0.5);
  std::size_t number = noisy.points.size();
  for (double tolerance : {0., 1e-4, 1e-3, 5e-3, 3e-2}) {
    Surface s = noisy;
    const IT::Flat_vertex_removal removal = IT::remove_nearly_flat_vertices(s.complex, s.points, tolerance);
    EXPECT_TRUE(s.complex.is_valid());
    EXPECT_LE(removal.deviation, tolerance);
    EXPECT_LE(largest_distance(noisy.points, s), removal.deviation + 1e-15);
    for (std::size_t v = 0; v < removal.vertices.size(); ++v)
      EXPECT_EQ(s.points[v], noisy.points[removal.vertices[v].idx()]);
    EXPECT_LE(s.points.size(), number);
    number = s.points.size();
  }
  EXPECT_LT(number, 3 * noisy.points.size() / 4);
  EXPECT_GE(number, 8u);
}

// Beyond the lengths of edges, too, where triangles are not thin for being smaller than the tolerance.
TEST(Remove_nearly_flat_vertices, removes_more_with_a_larger_tolerance)
{
  for (const samples::Indexed_triangles& sample : {samples::bumpy_sphere(), samples::bumpy_dome()}) {
    const Surface surface = surface_of(sample);
    std::size_t number = surface.points.size();
    for (double tolerance : {0., 1e-3, 1e-2, 3e-2, 0.1, 0.3, 1.}) {
      Surface s = surface;
      EXPECT_LE(IT::remove_nearly_flat_vertices(s.complex, s.points, tolerance).deviation, tolerance);
      EXPECT_LE(s.points.size(), number) << tolerance;
      number = s.points.size();
    }
    EXPECT_LT(number, surface.points.size() / 2);
  }
}

TEST(Remove_nearly_flat_vertices, without_a_tolerance_is_exact)
{
  Surface s = cubes({{0, 0, 0}, {0, 0, 1}, {0, 0, 2}}), t = s;
  const IT::Flat_vertex_removal removal = IT::remove_nearly_flat_vertices(s.complex, s.points, 0);
  EXPECT_EQ(removal.vertices, IT::remove_flat_vertices(t.complex, t.points));
  EXPECT_EQ(removal.deviation, 0);
  EXPECT_TRUE(s.complex == t.complex);
}

TEST(Remove_flat_vertices, can_be_cancelled)
{
  Surface s = cubes({{0, 0, 0}, {0, 0, 1}});
  EXPECT_THROW(IT::remove_flat_vertices(s.complex, s.points, CGAL::parameters::visitor([](double) { return false; })),
               IT::Cancelled_error);
}

} // namespace
