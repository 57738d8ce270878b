// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances by heat against known distances.

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Heat_method.h>
#include <CGAL/Intrinsic_triangulations/Tufted_cover.h>
#include <CGAL/Intrinsic_triangulations/Vector_heat_method.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/geodesic_distances.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/refine_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/shortest_path.h>
#include <CGAL/Intrinsic_triangulations/trace_geodesic.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <thread>
#include <type_traits>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Vertex_index;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;
using Point = std::array<double, 3>;
using Points = std::vector<Point>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

constexpr double infinity = std::numeric_limits<double>::infinity();

Triangulation Delaunay(const Points& points, const Triangles& triangles)
{
  Triangulation result(IT::make_Delta_complex_from_triangles(points.size(), triangles), points);
  IT::flip_to_Delaunay(result);
  return result;
}

std::vector<IT::Point_in_triangle> in_triangles(const IT::Delta_complex& complex, const Triangles& triangles,
                                                const std::vector<IT::Surface_point>& points)
{
  std::vector<IT::Point_in_triangle> result;
  for (const IT::Surface_point& p : points) {
    const std::size_t f = complex.face(p.halfedge).idx();
    IT::Halfedge_index h = p.halfedge;
    while (complex.source(h).idx() != triangles[f][0])
      h = complex.next(h);
    result.push_back({f, IT::coordinates_from(complex, p, h)});
  }
  return result;
}

// (columns + 1) (rows + 1) vertices, line by line, on squares cut along one diagonal.
struct Grid
{
  Grid(std::size_t columns, std::size_t rows, double spacing = 1) : columns(columns), rows(rows)
  {
    for (std::size_t y = 0; y <= rows; ++y)
      for (std::size_t x = 0; x <= columns; ++x)
        points.push_back({spacing * double(x), spacing * double(y), 0});
    for (std::size_t y = 0; y < rows; ++y)
      for (std::size_t x = 0; x < columns; ++x) {
        triangles.push_back({number(x, y), number(x + 1, y), number(x + 1, y + 1)});
        triangles.push_back({number(x, y), number(x + 1, y + 1), number(x, y + 1)});
      }
  }
  std::uint32_t number(std::size_t x, std::size_t y) const { return std::uint32_t(y * (columns + 1) + x); }
  Vertex_index vertex(std::size_t x, std::size_t y) const { return Vertex_index(number(x, y)); }
  bool is_border(std::size_t v) const
  {
    const std::size_t x = v % (columns + 1), y = v / (columns + 1);
    return x == 0 || y == 0 || x == columns || y == rows;
  }
  double distance(std::size_t v, double x, double y) const { return std::hypot(points[v][0] - x, points[v][1] - y); }

  std::size_t columns, rows;
  Points points;
  Triangles triangles;
};

void expect_numbers(const std::vector<double>& distances, const std::string& what)
{
  for (double d : distances)
    EXPECT_TRUE(d >= 0 && d < infinity) << what << ": " << d;
}

TEST(Heat_method, is_moved_without_a_copy)
{
  EXPECT_TRUE(std::is_nothrow_move_constructible<IT::Heat_method<>>::value);
  EXPECT_TRUE(std::is_nothrow_move_constructible<IT::Vector_heat_method>::value);
}

TEST(Heat_method, border_of_a_square_as_source)
{
  for (double spacing : {1., 1e-100, 1e100}) {
    constexpr std::size_t n = 24;
    const Grid grid(n, n, spacing);
    IT::Heat_method<> heat(Delaunay(grid.points, grid.triangles));
    for (std::size_t v = 0; v < grid.points.size(); ++v)
      if (grid.is_border(v))
        heat.add_source(Vertex_index(Vertex_index::size_type(v)));
    const std::vector<double>& distances = heat.distances();
    for (std::size_t y = 0; y <= n; ++y)
      for (std::size_t x = 0; x <= n; ++x) {
        const double exact = spacing * double((std::min)({x, y, n - x, n - y})), d = distances[grid.number(x, y)];
        EXPECT_GE(d, 0.95 * exact) << x << ' ' << y;
        EXPECT_LE(d, 1.1 * exact) << x << ' ' << y; // exactly zero at the sources
      }
  }
}

TEST(Heat_method, square_of_two_triangles_after_refinement)
{
  const Points points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  Triangulation triangulation = Delaunay(points, {{0, 1, 2}, {0, 2, 3}});
  IT::refine_Delaunay(triangulation, CGAL::parameters::maximum_edge_length(0.05));
  for (Vertex_index source : {Vertex_index(0), Vertex_index(1)}) {
    IT::Heat_method<> heat(triangulation);
    heat.add_source(source);
    for (std::size_t v = 0; v < 4; ++v) {
      const Point &p = points[v], &q = points[source.idx()];
      EXPECT_NEAR(heat.distances()[v], std::hypot(p[0] - q[0], p[1] - q[1]), 0.02 * std::sqrt(2.)) << v;
    }
  }
}

TEST(Heat_method, one_source_in_a_square)
{
  constexpr std::size_t n = 40;
  const Grid grid(n, n);
  const Triangulation triangulation = Delaunay(grid.points, grid.triangles);
  for (std::size_t at : {std::size_t(0), n / 2}) {
    IT::Heat_method<> heat(triangulation);
    EXPECT_TRUE(heat.add_source(grid.vertex(at, at)));
    const std::vector<double>& distances = heat.distances();
    EXPECT_EQ(heat.number_of_factorizations(), 2);
    EXPECT_EQ(distances[grid.number(at, at)], 0);
    for (std::size_t v = 0; v < distances.size(); ++v)
      EXPECT_NEAR(distances[v], grid.distance(v, double(at), double(at)), 1.5)
        << v; // the error of the method, 4 % of the way
  }
}

TEST(Heat_method, scale_does_not_matter)
{
  const Grid unit(9, 7);
  IT::Heat_method<> heat(Delaunay(unit.points, unit.triangles));
  heat.add_source(unit.vertex(3, 2));
  for (int exponent : {-330, -40, 40, 330}) {
    const double scale = std::ldexp(1., exponent);
    const Grid scaled(9, 7, scale);
    IT::Heat_method<> other(Delaunay(scaled.points, scaled.triangles));
    other.add_source(scaled.vertex(3, 2));
    for (std::size_t v = 0; v < unit.points.size(); ++v)
      EXPECT_NEAR(other.distances()[v] / scale, heat.distances()[v], 1e-12);
  }
}

// The same surface, alone and beside another that is a thousand times as large.
TEST(Heat_method, other_components_do_not_matter)
{
  const samples::Indexed_triangles one = samples::torus(24, 16), other = samples::disk_with_spike();
  Points points = one.points;
  Triangles triangles = one.triangles;
  for (const Point& p : other.points)
    points.push_back({1000 * p[0] + 5000, 1000 * p[1], 1000 * p[2]});
  for (const auto& [i, j, k] : other.triangles)
    triangles.push_back({std::uint32_t(i + one.points.size()), std::uint32_t(j + one.points.size()),
                         std::uint32_t(k + one.points.size())});
  const auto distances = [](const Triangulation& triangulation) {
    IT::Heat_method<> heat(triangulation);
    heat.add_source(Vertex_index(5));
    return heat.distances();
  };
  const std::vector<double> alone = distances(Delaunay(one.points, one.triangles)),
                            beside = distances(Delaunay(points, triangles));
  for (std::size_t v = 0; v < alone.size(); ++v)
    EXPECT_NEAR(beside[v], alone[v], 1e-12 * (1 + alone[v])) << v;
  EXPECT_EQ(beside.back(), infinity);
}

// The points of a grid with another triangulation of the same part of the plane, or about the same.
Triangles shuffled_by_flips(const Grid& grid)
{
  Triangulation triangulation(IT::make_Delta_complex_from_triangles(grid.points.size(), grid.triangles), grid.points);
  const IT::Delta_complex& complex = triangulation.connectivity();
  std::mt19937 random(3);
  for (int i = 0; i < 3000; ++i) {
    const IT::Edge_index e(std::uint32_t(random() % complex.number_of_edges()));
    if (complex.is_flippable(e))
      triangulation.flip(e);
  }
  Triangles result;
  for (IT::Face_index f : complex.faces()) {
    const IT::Halfedge_index h = complex.halfedge(f);
    result.push_back({complex.source(h).idx(), complex.target(h).idx(), complex.target(complex.next(h)).idx()});
  }
  return result;
}

// If the Delaunay triangulation is not unique, positions decide.
TEST(Heat_method, numbers_do_not_matter)
{
  Grid grid(14, 11);
  for (Point& p : grid.points)
    if (int(p[0]) % 3 == 1)
      p[1] += 0.5;
  const std::size_t n = grid.points.size();
  const Triangles triangles = shuffled_by_flips(grid);
  std::vector<std::uint32_t> number(n);
  std::iota(number.begin(), number.end(), 0);
  std::mt19937 random(5);
  std::shuffle(number.begin(), number.end(), random);
  Points others(n);
  for (std::size_t v = 0; v < n; ++v)
    others[number[v]] = grid.points[v];
  Triangles other_triangles;
  for (const auto& [i, j, k] : triangles)
    other_triangles.push_back({number[j], number[k], number[i]});
  std::shuffle(other_triangles.begin(), other_triangles.end(), random);
  const auto expect_same = [&](const auto& distances) {
    const std::vector<double> one = distances(Delaunay(grid.points, triangles), 7),
                              other = distances(Delaunay(others, other_triangles), number[7]);
    const double largest = *std::max_element(one.begin(), one.end());
    for (std::size_t v = 0; v < n; ++v)
      EXPECT_NEAR(other[number[v]], one[v], 1e-12 * largest) << v;
  };
  expect_same([](const Triangulation& t, std::uint32_t source) {
    IT::Heat_method<> heat(t);
    heat.add_source(Vertex_index(source));
    return heat.distances();
  });
  expect_same([](const Triangulation& t, std::uint32_t source) {
    return IT::geodesic_distances(t, {Vertex_index(source)}).distances;
  });
}

TEST(Heat_method, sources_come_and_go)
{
  const Grid grid(12, 12);
  IT::Heat_method<> heat(Delaunay(grid.points, grid.triangles));
  heat.add_source(grid.vertex(1, 1));
  const std::vector<double> one = heat.distances();
  EXPECT_TRUE(heat.add_source(grid.vertex(11, 10)));
  EXPECT_FALSE(heat.add_source(grid.vertex(11, 10)));
  EXPECT_TRUE(heat.add_source(grid.vertex(2, 9)));
  EXPECT_EQ(heat.number_of_sources(), 3);
  const std::vector<double> three = heat.distances();
  for (std::size_t v = 0; v < three.size(); ++v)
    EXPECT_NEAR(three[v], (std::min)({grid.distance(v, 1, 1), grid.distance(v, 11, 10), grid.distance(v, 2, 9)}), 1.2);
  for (std::size_t v : {grid.number(1, 1), grid.number(11, 10), grid.number(2, 9)})
    EXPECT_EQ(three[v], 0);
  EXPECT_TRUE(heat.remove_source(grid.vertex(11, 10)));
  EXPECT_FALSE(heat.remove_source(grid.vertex(11, 10)));
  heat.remove_source(grid.vertex(2, 9));
  EXPECT_EQ(heat.distances(), one);
  heat.clear_sources();
  EXPECT_EQ(heat.distances(), std::vector<double>(one.size(), infinity));
  EXPECT_EQ(heat.number_of_factorizations(), 2); // one of each matrix, for all of this
}

TEST(Heat_method, lines_of_sources)
{
  const Grid grid(30, 30);
  IT::Heat_method<> heat(Delaunay(grid.points, grid.triangles), CGAL::parameters::keeps_ridges(false));
  for (std::size_t i = 0; i <= 30; ++i)
    heat.add_source(grid.vertex(0, i));
  const std::vector<double> one = heat.distances();
  for (std::size_t v = 0; v < one.size(); ++v)
    EXPECT_NEAR(one[v], grid.points[v][0], 0.15);
  EXPECT_EQ(heat.number_of_factorizations(), 2);
  for (std::size_t i = 0; i <= 30; ++i)
    heat.add_source(grid.vertex(30, i));
  for (std::size_t v = 0; v < one.size(); ++v)
    EXPECT_NEAR(heat.distances()[v], (std::min)(grid.points[v][0], 30 - grid.points[v][0]), 0.5);
  EXPECT_EQ(heat.number_of_factorizations(), 4); // that many sources get their own
}

TEST(Heat_method, pinned_values_solve_the_system)
{
  const Grid grid(10, 10);
  const auto triangulation = Delaunay(grid.points, grid.triangles);
  const IT::internal::Heat_surface surface =
    IT::internal::make_heat_surface(triangulation, IT::internal::Row_of_vertex(triangulation.connectivity()));
  const IT::internal::Interruption never;
  using System = IT::internal::Pinned_system<IT::internal::Sparse_Cholesky<>>;
  for (std::uint32_t number : {1, 2, 20, 32, 33, 70}) {
    IT::internal::Pins pins;
    for (std::uint32_t i = 0; i < number; ++i)
      pins[(i * 17) % 121] = 1 + i;
    Eigen::VectorXd b(121);
    for (int i = 0; i < 121; ++i)
      b[i] = i - 60;
    System with_kernel(surface.stiffness, surface.component, "L", never),
      without(IT::internal::with_masses(surface.stiffness, surface), std::vector<bool>(), "M + L", never);
    for (System* system : {&with_kernel, &without}) {
      const Eigen::VectorXd x = system->solve(b, pins), residual = system->matrix() * x - b;
      for (int v = 0; v < 121; ++v) {
        const auto pin = pins.find(std::uint32_t(v));
        if (pin == pins.end()) {
          EXPECT_NEAR(residual[v], 0, 1e-9) << number;
        } else {
          EXPECT_NEAR(x[v], pin->second, 1e-9) << number;
        }
      }
    }
  }
}

// The last columns of the factor have the same rows below them; the first ones do not.
template <class Scalar>
void expect_solutions(const Scalar& weight)
{
  constexpr int n = 12;
  std::vector<Eigen::Triplet<Scalar>> entries;
  for (int v = 0; v < n * n; ++v) {
    entries.emplace_back(v, v, Scalar(5));
    for (int w : {v % n + 1 < n ? v + 1 : v, v + n < n * n ? v + n : v})
      if (w != v) {
        entries.emplace_back(v, w, weight);
        entries.emplace_back(w, v, Eigen::numext::conj(weight));
      }
  }
  Eigen::SparseMatrix<Scalar> matrix(n * n, n * n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const IT::internal::Sparse_Cholesky<Scalar> solver(matrix, "a grid");
  Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> right = decltype(right)::Zero(n * n, 3);
  for (int v = 0; v < n * n; ++v) {
    right(v, 0) = Scalar(v % 7 - 3);
    right(v, 1) = weight * Scalar(v % 5);
  }
  right(50, 2) = 1;
  const decltype(right) x = solver.solve(right);
  EXPECT_LT((matrix * x - right).norm(), 1e-13 * right.norm());
}

TEST(Heat_method, factors_solve_systems_of_numbers_and_of_vectors)
{
  expect_solutions<double>(-1);
  expect_solutions<std::complex<double>>({-0.6, 0.8});
}

const double pi = std::acos(-1.);

// Of the vertices from one, along edges of the input.
std::vector<double> edge_paths(const Points& points, const Triangles& triangles, std::size_t source)
{
  std::vector<double> result(points.size(), std::numeric_limits<double>::infinity());
  result[source] = 0;
  for (bool is_changed = true; is_changed;) {
    is_changed = false;
    for (const auto& t : triangles)
      for (int i = 0; i < 6; ++i) {
        const std::uint32_t a = t[std::size_t(i % 3)], b = t[std::size_t((i + (i < 3 ? 1 : 2)) % 3)];
        const double through =
          result[a] + std::hypot(points[a][0] - points[b][0], points[a][1] - points[b][1], points[a][2] - points[b][2]);
        if (through < result[b]) {
          result[b] = through;
          is_changed = true;
        }
      }
  }
  return result;
}

// Polygons without inner vertices, where heat alone gives anything from 0 to three times the distance.
TEST(Heat_method, stays_between_straight_lines_and_paths_along_edges)
{
  for (std::uint32_t n : {5u, 16u, 64u, 200u}) {
    Points points;
    Triangles triangles;
    for (std::uint32_t i = 0; i < n; ++i)
      points.push_back({10 * std::cos(2 * pi * i / n), 10 * std::sin(2 * pi * i / n), 0.01 * (i % 3)});
    for (std::uint32_t i = 1; i + 1 < n; ++i)
      triangles.push_back({0, i, i + 1});
    IT::Tufted_cover cover = IT::make_tufted_cover(points, triangles);
    IT::flip_to_Delaunay(cover.triangulation);
    for (std::uint32_t source : {0u, 3u}) {
      IT::Heat_method<> on_triangulation(Delaunay(points, triangles)), on_cover(cover);
      const std::vector<double> paths = edge_paths(points, triangles, source);
      for (IT::Heat_method<>* heat : {&on_triangulation, &on_cover}) {
        heat->add_source(Vertex_index(source));
        const std::vector<double>& distances = heat->distances();
        for (std::uint32_t v = 0; v < n; ++v) {
          const auto &p = points[v], &q = points[source];
          EXPECT_GE(distances[v], std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) * (1 - 1e-14)) << n << ' ' << v;
          EXPECT_LE(distances[v], paths[v] * (1 + 1e-14)) << n << ' ' << v;
          EXPECT_EQ(distances[v] == 0, v == source);
        }
        if (n >= 64) {
          EXPECT_GT(heat->number_of_bounded_distances(), 3u) << n << ' ' << source;
        }
      }
    }
  }
}

TEST(Heat_method, rows_are_about_sorted_whatever_the_distances)
{
  std::mt19937 random(1);
  std::uniform_int_distribution<int> number(0, 50);
  std::vector<std::vector<double>> all{{}, {0}, {infinity}, {infinity, 0, infinity}, {0, 0, 0}, {5e-324, 0}};
  for (int i = 0; i < 20; ++i) {
    all.emplace_back();
    for (int k = 0; k < 200; ++k) {
      const int x = number(random);
      all.back().push_back(x == 0 ? infinity : i % 2 == 0 ? x : std::ldexp(1., 40 * (x - 25)));
    }
  }
  all.back().push_back(std::numeric_limits<double>::max());
  for (const std::vector<double>& distances : all) {
    const std::vector<std::uint32_t> order = IT::internal::rows_by_distance(distances);
    EXPECT_EQ(std::set<std::uint32_t>(order.begin(), order.end()).size(), distances.size());
    ASSERT_EQ(order.size(), distances.size());
    double largest = 0, before = 0;
    for (double d : distances)
      if (d < infinity)
        largest = (std::max)(largest, d);
    for (std::uint32_t row : order) {
      const double distance = (std::min)(distances[row], largest);
      EXPECT_GE(distance, before - 8 * largest / double(distances.size()));
      before = (std::max)(before, distance);
    }
  }
}

// For any order of the rows.
TEST(Heat_method, bounds_are_shortest_paths_whatever_the_distances)
{
  const samples::Indexed_triangles surface = samples::bad_torus(20, 20);
  const Triangulation triangulation(IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles),
                                    surface.points);
  const IT::Delta_complex& complex = triangulation.connectivity();
  const IT::internal::Distance_bounds bounds(triangulation, IT::internal::Row_of_vertex(complex));
  const std::map<std::uint32_t, double> sources{{3, 0.}, {200, 0.125}};
  std::vector<double> paths(surface.points.size(), infinity);
  for (const auto& [source, distance] : sources)
    paths[source] = distance;
  for (bool is_changed = true; is_changed;) {
    is_changed = false;
    for (IT::Halfedge_index h : complex.halfedges()) {
      const double path = paths[complex.source(h).idx()] + triangulation.length(complex.edge(h));
      if (path < paths[complex.target(h).idx()] * (1 - 1e-14)) {
        paths[complex.target(h).idx()] = path;
        is_changed = true;
      }
    }
  }
  std::mt19937 random(1);
  for (unsigned round = 0; round < 10; ++round) {
    std::vector<double> distances;
    for (std::size_t v = 0; v < paths.size(); ++v)
      distances.push_back(round == 0 ? infinity : 1e6 + double(random() % (1u << round)));
    bounds.apply(distances, sources);
    for (std::size_t v = 0; v < paths.size(); ++v)
      EXPECT_NEAR(std::ldexp(distances[v], triangulation.unit_exponent()), paths[v], 1e-12) << round << ' ' << v;
  }
}

// Except for some next to the source.
TEST(Heat_method, needs_no_bounds_on_fine_surfaces)
{
  const Grid grid(40, 40);
  IT::Heat_method<> heat(Delaunay(grid.points, grid.triangles));
  heat.add_source(grid.vertex(17, 22));
  heat.distances();
  EXPECT_LE(heat.number_of_bounded_distances(), grid.points.size() / 100);
}

TEST(Heat_method, infinite_where_no_source_is_connected)
{
  // Two triangles apart, a vertex without faces, and a face without area.
  const Points points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0},
                         {5, 1, 0}, {9, 9, 9}, {0, 0, 8}, {1, 0, 8}, {2, 0, 8}};
  const Triangulation triangulation = Delaunay(points, {{0, 1, 2}, {3, 4, 5}, {7, 8, 9}});
  IT::Heat_method<> heat(triangulation);
  heat.add_source(Vertex_index(0));
  EXPECT_EQ(std::vector<double>(heat.distances().begin() + 3, heat.distances().end()),
            std::vector<double>(7, infinity));
  expect_numbers({heat.distances().begin(), heat.distances().begin() + 3}, "with a source");
  heat.add_source(Vertex_index(6));
  heat.add_source(Vertex_index(8));
  EXPECT_EQ(heat.distances()[6], 0);
  EXPECT_EQ(heat.distances()[8], 0);
  EXPECT_EQ(heat.distances()[7], 1); // along an edge of the face without area
  heat.add_source(Vertex_index(4));
  heat.add_source(Vertex_index(5));
  EXPECT_EQ(heat.distances()[4], 0);
  EXPECT_NEAR(heat.distances()[3], 1, 0.2);
  EXPECT_NEAR(heat.distances()[1], 1, 0.2);
}

TEST(Heat_method, faces_without_area)
{
  // One is flipped away; the other lies at the border and cannot be.
  const Points points = {{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, -1, 0}};
  const Triangulation inside = Delaunay(points, {{0, 2, 1}, {0, 1, 3}, {2, 0, 4}, {1, 2, 4}}),
                      border = Delaunay({points.begin(), points.end() - 1}, {{0, 2, 1}, {0, 1, 3}});
  for (const Triangulation* triangulation : {&inside, &border}) {
    IT::Heat_method<> heat(*triangulation);
    heat.add_source(Vertex_index(0));
    expect_numbers(heat.distances(), "a face without area");
    EXPECT_NEAR(heat.distances()[1], 2, 0.2);
  }
}

TEST(Heat_method, thin_faces)
{
  for (int k = 1; k <= 17; ++k) {
    const double h = std::pow(10., -k);
    const Points cap = {{0, 0, 0}, {1, 0, 0}, {0.5, h, 0}, {0.5, 1, 0}},
                 needles = {{0, 0, 0}, {h, 0, 0}, {0.5, 1, 0}, {0.5, -1, 0}, {-1, 0, 0}, {2, 0, 0}};
    IT::Heat_method<> on_cap(Delaunay(cap, {{0, 1, 2}, {1, 3, 2}, {3, 0, 2}})),
      on_needles(Delaunay(needles, {{0, 1, 2}, {1, 0, 3}, {4, 0, 2}, {4, 3, 0}, {5, 2, 1}, {5, 1, 3}}));
    for (IT::Heat_method<>* heat : {&on_cap, &on_needles}) {
      heat->add_source(Vertex_index(0));
      expect_numbers(heat->distances(), "thin faces " + std::to_string(k));
    }
    EXPECT_NEAR(on_cap.distances()[1], 1, 0.3) << k;
    EXPECT_NEAR(on_cap.distances()[3], std::hypot(0.5, 1), 0.3) << k;
    EXPECT_NEAR(on_needles.distances()[5], 2, 0.1) << k;
    EXPECT_NEAR(on_needles.distances()[1], h, 0.3 * h + 2e-9) << k;
  }
}

TEST(Heat_method, prism_and_cap_with_all_ties)
{
  for (const samples::Indexed_triangles& sample : {samples::prism(80), samples::cap(1e-10)}) {
    IT::Heat_method<> heat(Delaunay(sample.points, sample.triangles));
    heat.add_source(Vertex_index(0));
    expect_numbers(heat.distances(), "a sample");
  }
}

TEST(Heat_method, heat_reaches_the_end_of_a_long_strip)
{
  const Grid grid(2500, 3);
  const Triangulation triangulation = Delaunay(grid.points, grid.triangles);
  for (auto boundary : {IT::Heat_boundary::NEUMANN, IT::Heat_boundary::AVERAGED}) {
    IT::Heat_method<> heat(triangulation, CGAL::parameters::heat_boundary(boundary));
    heat.add_source(grid.vertex(0, 1));
    for (std::size_t v = 0; v < grid.points.size(); ++v)
      ASSERT_NEAR(heat.distances()[v], grid.distance(v, 0, 1), 0.6) << v;
  }
  // With both borders cold, much of the heat flows across so narrow a strip, but it reaches the end.
  IT::Heat_method<> heat(triangulation, CGAL::parameters::heat_boundary(IT::Heat_boundary::DIRICHLET));
  heat.add_source(grid.vertex(0, 1));
  for (std::size_t x = 0; x < 2500; ++x)
    ASSERT_GT(heat.distances()[grid.number(x + 1, 1)], heat.distances()[grid.number(x, 1)] + 0.4) << x;
  const std::vector<double> values =
    IT::Heat_method<>(triangulation).extend({{grid.vertex(0, 1), 3.}, {grid.vertex(2500, 1), 7.}});
  EXPECT_NEAR(values[grid.number(1000, 2)], 3, 1e-6);
  EXPECT_NEAR(values[grid.number(1500, 2)], 7, 1e-6);
}

// Heat that starts at the corners of a face is less than that of a vertex, but not less than the heat from their
// neighbors.
TEST(Heat_method, points_and_vertices_as_sources_for_short_times)
{
  const Grid grid(5, 5);
  const Triangulation triangulation = Delaunay(grid.points, grid.triangles);
  const IT::Halfedge_index h = triangulation.connectivity().halfedge(IT::Face_index(0));
  double x = 0, y = 0;
  for (std::uint32_t v : grid.triangles[0]) {
    x += grid.points[v][0] / 3;
    y += grid.points[v][1] / 3;
  }
  for (double coefficient : {1e-2, 1e-4, 1e-8}) {
    IT::Heat_method<> heat(triangulation, CGAL::parameters::time_coefficient(coefficient));
    heat.add_source(grid.vertex(5, 5));
    heat.add_source(triangulation, {h, {1, 1, 1}});
    const std::vector<double>& distances = heat.distances();
    for (std::size_t v = 0; v < distances.size(); ++v)
      EXPECT_GE(distances[v], 0.8 * (std::min)(grid.distance(v, x, y), grid.distance(v, 5, 5)))
        << coefficient << ' ' << v;
  }
}

TEST(Heat_method, boundary_conditions)
{
  // From lengths alone: in space, straight lines would be a bound.
  const Grid grid(20, 20);
  const IT::Delta_complex complex = IT::make_Delta_complex_from_triangles(grid.points.size(), grid.triangles);
  std::vector<double> lengths;
  for (IT::Edge_index e : complex.edges()) {
    const Point &p = grid.points[complex.source(complex.halfedge(e)).idx()],
                &q = grid.points[complex.target(complex.halfedge(e)).idx()];
    lengths.push_back(std::hypot(p[0] - q[0], p[1] - q[1]));
  }
  Triangulation triangulation = Triangulation::from_lengths(complex, lengths);
  IT::flip_to_Delaunay(triangulation);
  std::vector<std::vector<double>> results;
  for (auto boundary : {IT::Heat_boundary::NEUMANN, IT::Heat_boundary::DIRICHLET, IT::Heat_boundary::AVERAGED}) {
    IT::Heat_method<> heat(triangulation,
                           CGAL::parameters::heat_boundary(boundary).time_coefficient(20).keeps_ridges(false));
    heat.add_source(grid.vertex(10, 10));
    results.push_back(heat.distances());
    heat.clear_sources();
    heat.add_source(grid.vertex(0, 0)); // on the border itself, where all neighbours are cold
    EXPECT_NEAR(heat.distances()[grid.number(20, 20)], std::hypot(20, 20), 3);
  }
  // Isolines meet the border at right angles or run along it: the first makes the distance grow too little
  // on the way from the middle of a side to the corner, the second too much on the way to the middle.
  const std::size_t middle = grid.number(10, 0), corner = grid.number(0, 0);
  const auto along = [&](const std::vector<double>& d) { return d[corner] - d[middle]; };
  EXPECT_LT(along(results[1]), along(results[0]));
  const std::size_t beside = grid.number(13, 0); // no edges lead straight there, which would be a bound
  EXPECT_GT((std::max)(results[0][beside], results[1][beside]), results[2][beside]);
  EXPECT_LT((std::min)(results[0][beside], results[1][beside]), results[2][beside]);
}

TEST(Heat_method, sphere)
{
  const samples::Indexed_triangles sphere = samples::latitude_longitude_sphere(60, 30);
  IT::Heat_method<> heat(Delaunay(sphere.points, sphere.triangles));
  std::size_t source = 500;
  heat.add_source(Vertex_index(500));
  double mean = 0;
  const auto& p = sphere.points[source];
  for (std::size_t v = 0; v < sphere.points.size(); ++v) {
    const auto& q = sphere.points[v];
    const double chord = std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]),
                 exact = 2 * std::asin((std::min)(1., chord / 2));
    mean += std::abs(heat.distances()[v] - exact) / double(sphere.points.size());
  }
  EXPECT_LT(mean, 0.03); // the error of the method, 2 % of the mean distance
}

TEST(Heat_method, source_in_a_face)
{
  const Grid grid(20, 20);
  const Triangulation triangulation = Delaunay(grid.points, grid.triangles);
  const IT::Delta_complex& complex = triangulation.connectivity();
  IT::Heat_method<> heat(triangulation);
  for (const std::array<double, 3>& coordinates :
       {std::array<double, 3>{1. / 3, 1. / 3, 1. / 3}, {0.5, 0.5, 0}, {2, 0, 0}, {0, 0.1, 0.9}}) {
    const IT::Halfedge_index h = complex.next(complex.halfedge(IT::Face_index(421)));
    heat.clear_sources();
    heat.add_source(triangulation, {h, coordinates});
    const std::size_t corners[] = {complex.source(h).idx(), complex.target(h).idx(),
                                   complex.target(complex.next(h)).idx()};
    const double sum = coordinates[0] + coordinates[1] + coordinates[2];
    double x = 0, y = 0;
    for (int i = 0; i < 3; ++i) {
      x += coordinates[i] / sum * grid.points[corners[i]][0];
      y += coordinates[i] / sum * grid.points[corners[i]][1];
    }
    for (std::size_t corner : corners)
      EXPECT_NEAR(heat.distances()[corner], grid.distance(corner, x, y), 1e-12);
    for (std::size_t v = 0; v < grid.points.size(); ++v)
      EXPECT_NEAR(heat.distances()[v], grid.distance(v, x, y), 1.2);
  }
  // Beyond a side of the face, the shortest way crosses the side: it does not run through its ends.
  const Grid small(4, 4);
  const Triangulation squares = Delaunay(small.points, small.triangles);
  for (bool keeps_ridges : {true, false}) {
    IT::Heat_method<> near(squares, CGAL::parameters::keeps_ridges(keeps_ridges));
    near.add_source(squares, {squares.connectivity().halfedge(IT::Face_index(0)), {1, 1, 1}});
    for (std::size_t v : {small.number(0, 1), small.number(2, 0), small.number(2, 1)})
      EXPECT_NEAR(near.distances()[v], small.distance(v, 2. / 3, 1. / 3), 0.5) << v << keeps_ridges;
  }
  EXPECT_THROW(heat.add_source(triangulation, {IT::Halfedge_index(), {1, 0, 0}}), IT::Invalid_point_error);
  EXPECT_THROW(heat.add_source(triangulation, {IT::Halfedge_index(0), {0, 0, 0}}), IT::Invalid_point_error);
  EXPECT_THROW(heat.add_source(triangulation, {IT::Halfedge_index(0), {-1, 1, 1}}), IT::Invalid_point_error);
}

TEST(Heat_method, extension_is_nearly_the_value_of_the_nearest_vertex)
{
  const Grid grid(30, 10);
  const IT::Heat_method<> heat(Delaunay(grid.points, grid.triangles));
  const std::vector<double> values = heat.extend({{grid.vertex(2, 5), -4.}, {grid.vertex(28, 5), 10.}});
  EXPECT_EQ(values[grid.number(2, 5)], -4);
  for (std::size_t v = 0; v < values.size(); ++v) {
    EXPECT_GE(values[v], -4 - 1e-9);
    EXPECT_LE(values[v], 10 + 1e-9);
    if (grid.points[v][0] < 11) {
      EXPECT_NEAR(values[v], -4, 0.05);
    }
    if (grid.points[v][0] > 19) {
      EXPECT_NEAR(values[v], 10, 0.05);
    }
  }
}

TEST(Heat_method, on_the_cover_of_any_triangles)
{
  // Three squares at one edge, the last one turned over, and a vertex at the place of another.
  const Points points = {{0, 0, 0},  {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0},
                         {-1, 1, 0}, {0, 0, 1}, {0, 1, 1}, {0, 0, 1}};
  const Triangles triangles = {{0, 2, 3}, {0, 3, 1}, {0, 1, 5}, {0, 5, 4}, {0, 6, 7}, {0, 7, 1}, {6, 8, 7}};
  IT::Tufted_cover cover = IT::make_tufted_cover(points, triangles);
  IT::flip_to_Delaunay(cover.triangulation);
  IT::Heat_method<> heat(cover);
  heat.add_source(Vertex_index(3));
  expect_numbers(heat.distances(), "three squares");
  EXPECT_EQ(heat.distances()[3], 0);
  EXPECT_EQ(heat.distances()[6], heat.distances()[8]);
  EXPECT_NEAR(heat.distances()[5], heat.distances()[7], 1e-9);
  EXPECT_NEAR(heat.distances()[5], 2, 0.4);

  // A closed surface is its own cover.
  const samples::Indexed_triangles torus = samples::torus(20, 12);
  IT::Tufted_cover closed = IT::make_tufted_cover(torus.points, torus.triangles);
  IT::flip_to_Delaunay(closed.triangulation);
  IT::Heat_method<> one(closed), other(Delaunay(torus.points, torus.triangles));
  one.add_source(Vertex_index(7));
  other.add_source(Vertex_index(7));
  for (std::size_t v = 0; v < torus.points.size(); ++v)
    EXPECT_NEAR(one.distances()[v], other.distances()[v], 1e-9);
}

TEST(Heat_method, other_number_types)
{
  const Grid grid(8, 8);
  IT::Intrinsic_triangulation<IT::Edge_length_traits<double>> triangulation(
    IT::make_Delta_complex_from_triangles(grid.points.size(), grid.triangles), grid.points);
  IT::flip_to_Delaunay(triangulation);
  IT::Heat_method<> heat(triangulation);
  heat.add_source(grid.vertex(4, 4));
  for (std::size_t v = 0; v < grid.points.size(); ++v)
    EXPECT_NEAR(heat.distances()[v], grid.distance(v, 4, 4), 1.2);
}

// From points in faces, curves and regions: the method is of first order in the length of the edges.
TEST(Heat_method, from_points_curves_and_regions)
{
  const samples::Indexed_triangles sphere = samples::bumpy_sphere(48, 32),
                                   flat = samples::random_diagonal_grid(40, 40, 3);
  for (const samples::Indexed_triangles& surface : {sphere, flat}) {
    const Triangulation triangulation = Delaunay(surface.points, surface.triangles);
    const IT::Delta_complex& input = triangulation.input();
    IT::Tufted_cover cover = IT::make_tufted_cover(surface.points, surface.triangles);
    IT::flip_to_Delaunay(cover.triangulation);
    const IT::Halfedge_index h = input.halfedge(IT::Face_index(700));
    const IT::Geodesic_source point{{{{h, {0.2, 0.3, 0.5}}}}, 0};
    const IT::Geodesic_source curve{{IT::trace_geodesic(triangulation, {{h, {0.2, 0.3, 0.5}}, {0.3, -0.2}},
                                                        20 * triangulation.length(IT::Edge_index(0)))
                                       .points},
                                    0};
    std::vector<IT::Face_index> faces;
    for (std::uint32_t f = 300; f < 340; ++f)
      faces.push_back(IT::Face_index(f));
    const IT::Geodesic_source region = IT::source_of_region(input, faces);
    const IT::Geodesic_source late{{{{h, {0.2, 0.3, 0.5}}}}, 2 * triangulation.length(IT::Edge_index(0))};
    const IT::Geodesic_source vertex = IT::source_at_vertex(input, input.source(h));
    const std::vector<std::vector<IT::Geodesic_source>> all{{vertex}, {point},         {curve},
                                                            {region}, {point, region}, {late, region}};
    for (const std::vector<IT::Geodesic_source>& sources : all) {
      const auto exact = IT::geodesic_distances_from(triangulation, sources, CGAL::parameters::tolerance(0)).distances;
      IT::Heat_method<> heat(triangulation), on_cover(cover);
      heat.add_sources(triangulation, sources);
      EXPECT_EQ(heat.number_of_sources(), sources.size());
      std::vector<IT::Geodesic_source> of_cover = sources;
      for (IT::Geodesic_source& source : of_cover)
        for (std::vector<IT::Surface_point>& part : source.parts)
          part = IT::sources_on_cover(cover, surface.triangles, {in_triangles(input, surface.triangles, part)})
                   .front()
                   .parts.front();
      on_cover.add_sources(cover, of_cover);
      for (IT::Heat_method<>* method : {&heat, &on_cover}) {
        double sum = 0, most = 0;
        for (std::size_t v = 0; v < exact.size(); ++v) {
          sum += std::abs(method->distances()[v] - exact[v]);
          most = (std::max)(most, std::abs(method->distances()[v] - exact[v]));
          if (exact[v] == 0) {
            EXPECT_EQ(method->distances()[v], 0);
          }
        }
        EXPECT_LT(sum, method->mean_edge_length() * double(exact.size()));
        EXPECT_LT(most, 3 * method->mean_edge_length());
      }
      if (&sources == &all.front()) {
        IT::Heat_method<> from_vertex(triangulation);
        from_vertex.add_source(input.source(h));
        EXPECT_EQ(from_vertex.distances(), heat.distances());
      }
      heat.clear_sources();
      EXPECT_EQ(heat.number_of_sources(), 0u);
      EXPECT_EQ(heat.distances()[5], infinity);
    }
  }
}

TEST(Heat_method, what_it_refuses)
{
  const Grid grid(2, 2);
  const Triangulation triangulation = Delaunay(grid.points, grid.triangles);
  IT::Heat_method<> heat(triangulation);
  EXPECT_THROW(heat.add_source(Vertex_index(9)), IT::Invalid_argument_error);
  EXPECT_THROW(heat.add_source(Vertex_index()), IT::Invalid_argument_error);
  EXPECT_THROW(heat.extend({{Vertex_index(9), 1.}}), IT::Invalid_argument_error);
  const IT::Halfedge_index h = triangulation.input().halfedge(IT::Face_index(0));
  EXPECT_THROW(heat.add_sources(triangulation, {{{{{h, {1, -1, 1}}}}, 0}}), IT::Invalid_point_error);
  EXPECT_THROW(heat.add_sources(triangulation, {{{{{h, {1, 0, 0}}}}, -1}}), IT::Invalid_argument_error);
  EXPECT_EQ(heat.number_of_sources(), 0);
  heat.add_sources(triangulation, {{{{{h, {1, 0, 0}}}}, 0}});
  heat.clear_sources();
  EXPECT_FALSE(heat.remove_source(Vertex_index(9)));
  EXPECT_EQ(heat.number_of_sources(), 0);
  for (double coefficient : {0., -1., infinity, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(IT::Heat_method<>(triangulation, CGAL::parameters::time_coefficient(coefficient)),
                 IT::Invalid_argument_error);
}

TEST(Heat_method, asks_before_each_factorization_and_solution)
{
  const Grid grid(10, 10);
  const Triangulation triangulation = Delaunay(grid.points, grid.triangles);
  bool goes_on = false;
  std::uint64_t questions = 0;
  const auto go_further = [&] {
    ++questions;
    return goes_on;
  };
  const auto options = CGAL::parameters::heat_boundary(IT::Heat_boundary::AVERAGED).visitor(go_further);
  EXPECT_THROW((IT::Heat_method<>(triangulation, options)), IT::Cancelled_error);
  goes_on = true;
  IT::Heat_method<> heat(triangulation, options);
  const auto distances_fail = [&] { EXPECT_THROW(heat.distances(), IT::Cancelled_error); };
  heat.add_source(IT::Vertex_index(0));
  std::this_thread::sleep_for(std::chrono::milliseconds(20)); // it asks a hundred times a second
  goes_on = false;
  distances_fail();
  distances_fail();
  EXPECT_THROW(heat.extend({{IT::Vertex_index(0), 1.}}), IT::Cancelled_error);
  EXPECT_EQ(heat.number_of_factorizations(), 1u); // the others were not begun
  goes_on = true;
  EXPECT_NEAR(heat.distances()[10], 10, 0.5);
  EXPECT_GT(questions, 4u);
}

} // namespace
