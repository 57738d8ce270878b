// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Edges that cross hundreds of input edges: their caches, and proofs across parallel folds.

#include "insert_random_vertices.h"
#include "reference/length_interval.h"
#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Geodesic_path_network.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/geodesic_path.h>
#include <CGAL/Intrinsic_triangulations/insert_vertex.h>
#include "library/engine/history/Crossing_sequence.h"
#include "library/engine/decide/Exact_fallback.h"
#include "library/engine/history/Long_crossings.h"
#include "library/engine/decide/Parallel_folds.h"
#include "library/engine/layout/Unfolding.h"
#include "library/engine/layout/Vertex_positions.h"
#include "library/engine/layout/metric_images.h"
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/refine_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/verify_Delaunay.h>

#include <CGAL/property_map.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;
using Point = std::array<double, 3>;
using Triangle = std::array<std::uint32_t, 3>;

using Surface = samples::Indexed_triangles;

Triangulation triangulation_of(const Surface& s)
{
  return Triangulation(IT::make_Delta_complex_from_triangles(s.points.size(), s.triangles), s.points);
}

Triangulation triangulation_of(const samples::Glued_triangles& s)
{
  const IT::Delta_complex complex = IT::make_Delta_complex_from_gluing(s.number_of_faces, s.glued_sides);
  std::vector<double> lengths(complex.number_of_edges());
  for (std::uint32_t side = 0; side < s.side_lengths.size(); ++side) {
    const IT::Halfedge_index h = complex.halfedge(IT::Face_index(side / 3));
    const IT::Halfedge_index sides[] = {h, complex.next(h), complex.prev(h)};
    lengths[complex.edge(sides[side % 3]).idx()] = s.side_lengths[side];
  }
  return Triangulation::from_lengths(complex, lengths);
}

Point rotated(double x, double y, double z)
{
  const double u = std::cos(0.7) * x - std::sin(0.7) * y, v = std::sin(0.7) * x + std::cos(0.7) * y;
  return {u, std::cos(1.1) * v - std::sin(1.1) * z, std::sin(1.1) * v + std::cos(1.1) * z};
}

// A box of length `length` with k points along each long edge, whose sides are cut into fans from their ends.
Surface fan_box(std::uint32_t k, double length)
{
  Surface s;
  for (const auto& [y, z] : {std::pair(0., 0.), std::pair(1., 0.), std::pair(1., 1.), std::pair(0., 1.)})
    for (std::uint32_t i = 0; i <= k; ++i)
      s.points.push_back(rotated(length * i / k, y, z));
  const auto at = [k](std::uint32_t c, std::uint32_t i) { return c % 4 * (k + 1) + i; };
  for (std::uint32_t c = 0; c < 4; ++c)
    for (std::uint32_t i = 0; i < k; ++i) {
      s.triangles.push_back({at(c, 0), at(c + 1, i + 1), at(c + 1, i)});
      s.triangles.push_back({at(c + 1, k), at(c, i), at(c, i + 1)});
    }
  for (const Triangle& t : {Triangle{at(0, 0), at(1, 0), at(2, 0)}, Triangle{at(0, 0), at(2, 0), at(3, 0)},
                            Triangle{at(0, k), at(2, k), at(1, k)}, Triangle{at(0, k), at(3, k), at(2, k)}})
    s.triangles.push_back(t);
  return s;
}

// n rectangles of height 1 in a row, folded by random angles along parallel edges. Vertex 2i lies below vertex 2i + 1.
Surface folded_strip(std::uint32_t n, double& length)
{
  std::mt19937 random(1);
  Surface s;
  double x = 0, y = 0;
  length = 0;
  for (std::uint32_t i = 0;; ++i) {
    s.points.push_back({x, y, 0});
    s.points.push_back({x, y, 1});
    if (i == n)
      break;
    const double dx = (1 + random() % 90) / 1024., dy = double(random() % 61) / 1024. - 30 / 1024.; // exact
    length += std::hypot(dx, dy);
    x += dx;
    y += dy;
    s.triangles.push_back({2 * i, 2 * i + 2, 2 * i + 3});
    s.triangles.push_back({2 * i, 2 * i + 3, 2 * i + 1});
  }
  return s;
}

// Compares cached sequences with those found by following input edges. Returns the number of cached ones.
std::size_t check_kept_crossings(const Triangulation& t)
{
  const IT::Delta_complex& complex = t.connectivity();
  const IT::internal::Correspondence &correspondence = IT::internal::engine(t).correspondence(),
                                     copy = correspondence; // copies keep nothing
  EXPECT_TRUE(copy.kept_crossings().is_empty());
  const IT::internal::Interruption none;
  std::size_t result = 0;
  for (IT::Halfedge_index h : complex.halfedges()) {
    const auto n = std::size_t(correspondence.coordinates().number_of_crossings(complex.edge(h)));
    const auto kept = correspondence.kept_crossings().find(h, n);
    if (!kept)
      continue;
    if (n == 0) {
      ADD_FAILURE() << "edge " << complex.edge(h).idx() << " crosses nothing";
      continue;
    }
    ++result;
    const IT::internal::Crossed_halfedges followed(complex, copy, h, none);
    for (std::size_t i = 0; i < n; ++i)
      if (followed[i] != (*kept)[i]) {
        ADD_FAILURE() << "edge " << complex.edge(h).idx() << ", crossing " << i << " of " << n;
        break;
      }
  }
  return result / 2;
}

void flip_some_edges(Triangulation& t, std::size_t number, std::mt19937& random)
{
  for (std::size_t i = 0; i < number; ++i) {
    const IT::Edge_index e(std::uint32_t(random() % t.connectivity().number_of_edges()));
    if (t.connectivity().is_flippable(e))
      t.flip(e);
  }
}

void remove_some_vertices(Triangulation& t, std::size_t number)
{
  for (std::size_t i = 0; i < number; ++i)
    try {
      IT::remove_vertex(t, IT::Vertex_index(t.connectivity().number_of_vertices() - 1 - std::uint32_t(i % 3)));
    } catch (const IT::Invalid_removal_error&) { // edges from a vertex back to itself
    }
}

std::size_t check_random_changes(Triangulation t, std::mt19937& random)
{
  std::size_t kept = 0;
  IT::flip_to_Delaunay(t);
  for (int round = 0; round < 3 && !::testing::Test::HasFailure(); ++round) {
    insert_random_vertices(t, 12, 100, random);
    kept += check_kept_crossings(t);
    flip_some_edges(t, 200, random);
    kept += check_kept_crossings(t);
    remove_some_vertices(t, 5);
    check_kept_crossings(t);
    IT::flip_to_Delaunay(t); // logs its flips, and keeps no earlier caches
    check_kept_crossings(t);
  }
  return kept;
}

TEST(Long_strips, what_edges_cross_is_kept_through_flips_insertions_and_removals)
{
  std::mt19937 random(7);
  std::size_t kept = 0;
  for (const Surface& surface : {fan_box(12, 40), fan_box(30, 30), samples::strip(60, 30), samples::Schwarz_lantern(),
                                 samples::pillow(60), samples::sheared_grid()})
    kept += check_random_changes(triangulation_of(surface), random);
  EXPECT_GT(kept, 2000u);
}

TEST(Long_strips, what_edges_cross_is_kept_where_faces_are_glued_to_themselves)
{
  std::mt19937 random(3);
  const std::size_t kept = check_random_changes(triangulation_of(samples::helical_tube()), random) +
                           check_random_changes(triangulation_of(samples::sheared_one_vertex_torus(20)), random);
  EXPECT_GT(kept, 300u);
}

TEST(Long_strips, what_edges_cross_is_not_followed_without_end)
{
  IT::Delta_complex complex = triangulation_of(samples::sheared_one_vertex_torus(1)).connectivity();
  IT::internal::Correspondence correspondence(complex, IT::internal::Normal_coordinates(complex), {});
  for (std::uint32_t i = 0; i < 60; ++i) {
    const IT::Hinge_halfedges around = complex.hinge(IT::Edge_index(i % 3));
    correspondence.flip(complex, around);
    complex.flip(around);
  }
  EXPECT_GT(correspondence.coordinates().number_of_crossings(IT::Edge_index(0)), std::int64_t(1) << 36);
  IT::internal::Long_crossings(complex, correspondence, IT::internal::Interruption()).keep();
  EXPECT_TRUE(correspondence.kept_crossings().is_empty());
}

TEST(Long_strips, what_edges_cross_is_kept_as_long_as_nothing_flips)
{
  Triangulation t = triangulation_of(fan_box(40, 320));
  IT::flip_to_Delaunay(t);
  const auto& engine = IT::internal::engine(t);
  IT::internal::Long_crossings(engine.connectivity(), engine.correspondence(), engine.decisions().interruption).keep();
  const std::size_t kept = check_kept_crossings(t);
  EXPECT_GT(kept, 100u);
  Triangulation moved = std::move(t);
  IT::flip_to_Delaunay(moved, CGAL::parameters::edge_is_constrained_map(
                                CGAL::Static_boolean_property_map<IT::Edge_index, true>())); // tests nothing
  EXPECT_EQ(check_kept_crossings(moved), kept);
}

TEST(Long_strips, what_all_edges_cross_is_found_at_once_when_many_are_asked_for)
{
  Triangulation t = triangulation_of(fan_box(40, 320));
  IT::flip_to_Delaunay(t);
  const auto edges = t.connectivity().edges();
  const auto number_of_edges_that_cross =
    std::count_if(edges.begin(), edges.end(), [&](IT::Edge_index e) { return t.number_of_crossings(e) > 0; });
  std::int64_t asked_for = 0;
  std::vector<double> lengths;
  for (IT::Edge_index e : edges) {
    lengths.push_back(t.length(e));
    asked_for += t.number_of_crossings(e);
    if (asked_for < 100) {
      EXPECT_LT(check_kept_crossings(t), number_of_edges_that_cross / 2);
    }
  }
  EXPECT_GT(asked_for, 4 * std::int64_t(lengths.size()));
  EXPECT_EQ(check_kept_crossings(t), number_of_edges_that_cross);
  for (IT::Edge_index e : edges) {
    const CGAL::Interval_nt<> length = length_interval(t, e);
    EXPECT_TRUE(std::nextafter(length.inf(), 0) <= lengths[e.idx()] &&
                lengths[e.idx()] <= std::nextafter(length.sup(), 1e300));
    EXPECT_EQ(t.length(e), lengths[e.idx()]); // whether the crossings were followed or kept
  }
}

// A few edges take less.
TEST(Long_strips, what_all_edges_cross_is_not_found_for_a_few_of_them)
{
  Triangulation t = triangulation_of(samples::sheared_grid(400, 1, 200));
  IT::flip_to_Delaunay(t);
  const auto edges = t.connectivity().edges();
  std::int64_t asked_for = 0;
  std::size_t number_of_queries = 0;
  for (auto e = edges.begin(); asked_for < 2 * std::int64_t(edges.size()); ++e)
    if (t.number_of_crossings(*e) > 100) {
      t.length(*e);
      asked_for += t.number_of_crossings(*e);
      ++number_of_queries;
    }
  EXPECT_LT(number_of_queries, 30u);
  EXPECT_EQ(check_kept_crossings(t), number_of_queries);
}

// The squared lengths and areas after flips and insertions are within their bounds, however they were carried.
TEST(Long_strips, numbers_that_are_carried_keep_their_bounds)
{
  Triangulation t = triangulation_of(fan_box(40, 320));
  IT::flip_to_Delaunay(t);
  const auto check = [&] {
    const IT::Delta_complex& complex = t.connectivity();
    std::size_t long_edges = 0;
    for (IT::Edge_index e : complex.edges()) {
      const IT::Face_index f = complex.face(complex.halfedge(e));
      const CGAL::Interval_nt<> length = length_interval(t, e), squared = square(length);
      const double error = t.face_data(f).error, stored = t.squared_length(e);
      ASSERT_LE(squared.inf(), stored + error);
      ASSERT_GE(squared.sup(), stored - error);
      long_edges += t.number_of_crossings(e) > 20 ? 1 : 0;
    }
    ASSERT_GT(long_edges, 20u);
    for (IT::Face_index f : complex.faces())
      ASSERT_LE(std::abs(4 * t.area(f) - t.face_data(f).value), t.face_data(f).error + 1e-14 * t.area(f));
    ASSERT_TRUE(IT::verify_Delaunay(t).is_Delaunay());
  };
  check();
  EXPECT_EQ(IT::refine_Delaunay(t, CGAL::parameters::minimum_angle(25)).status, IT::Refinement_status::REFINED);
  EXPECT_GT(t.connectivity().number_of_vertices(), 200u);
  check();
}

// A bent strip, whose long sides are fans from its ends.
Surface strip_of_fans(std::uint32_t n)
{
  Surface s;
  s.points = {{0, 0, 0}, {double(n), 0, 0}};
  for (double side : {1., -1.})
    for (std::uint32_t k = 0; k < n; ++k)
      s.points.push_back(
        {k + 0.4 * std::sin(7. * k * k), side * (1 + 0.01 * std::sin(0.3 * k)), 0.1 + 0.01 * std::cos(0.7 * k)});
  for (std::uint32_t k = 0; k + 1 < n; ++k) {
    s.triangles.push_back({0, k + 3, k + 2});
    s.triangles.push_back({1, n + 2 + k, n + 3 + k});
  }
  s.triangles.push_back({0, 1, n + 1});
  s.triangles.push_back({1, 0, n + 2});
  return s;
}

// Close calls do not lay out what each edge crosses: faces are carried along from the first flip on.
TEST(Long_strips, close_calls_do_not_lay_out_all_edges)
{
  Triangulation t = triangulation_of(strip_of_fans(1500));
  EXPECT_EQ(IT::flip_to_Delaunay(t).status, IT::Flip_status::DELAUNAY);
  const auto edges = t.connectivity().edges();
  const auto number_of_long_edges =
    std::count_if(edges.begin(), edges.end(), [&](IT::Edge_index e) { return t.number_of_crossings(e) > 100; });
  EXPECT_GT(number_of_long_edges, 1000);
  EXPECT_LT(check_kept_crossings(t), number_of_long_edges / 10);
  const std::vector<double> lengths = IT::edge_lengths(t);
  EXPECT_LT(check_kept_crossings(t), number_of_long_edges / 10);
  std::size_t number = 0;
  for (IT::Edge_index e : edges)
    if (++number % 97 == 0) {
      const CGAL::Interval_nt<> length = length_interval(t, e);
      EXPECT_TRUE(std::nextafter(length.inf(), 0) <= lengths[e.idx()] &&
                  lengths[e.idx()] <= std::nextafter(length.sup(), 1e300));
    }
  EXPECT_TRUE(IT::verify_Delaunay(t).is_Delaunay());
}

// Across 24 folds with independent roots no other proof of an angle of π is possible.
TEST(Long_strips, lines_across_parallel_folds_are_proven_to_be_straight)
{
  constexpr std::uint32_t n = 24;
  double length = 0;
  Triangulation t = triangulation_of(folded_strip(n, length));
  t.set_tie_proof(IT::Tie_proof::PROVEN);
  IT::Geodesic_path_network<IT::Filtered_edge_length_traits> network(t);
  const auto add = [&](std::uint32_t from, std::uint32_t to) {
    return network.add_path(IT::shortest_edge_path(t, IT::Vertex_index(from), IT::Vertex_index(to)));
  };
  const std::size_t across = add(0, 2 * n + 1);
  EXPECT_EQ(network.shorten().status, IT::Geodesic_status::GEODESIC);
  EXPECT_TRUE(network.is_geodesic());
  EXPECT_NEAR(network.length(across), std::hypot(length, 1), 1e-14);
}

TEST(Long_strips, points_are_proven_to_lie_on_lines_across_parallel_folds)
{
  constexpr std::uint32_t n = 24;
  double length = 0;
  Triangulation t = triangulation_of(folded_strip(n, length));
  const auto point_of = [&](std::uint32_t i, double height) { // in the lower triangle of rectangle i
    const IT::Halfedge_index h = t.input().halfedge(IT::Face_index(2 * i));
    IT::Surface_point result{h, {0, 0, 0}};
    for (std::size_t c = 0; c < 3; ++c, result.halfedge = t.input().next(result.halfedge))
      result.coordinates[c] = t.input().source(result.halfedge).idx() == 2 * i + 3 ? height : (1 - height) / 2;
    return result;
  };
  const IT::Vertex_index from = IT::insert_vertex(t, point_of(0, 0.5)), to = IT::insert_vertex(t, point_of(n - 1, 0.5));
  t.set_tie_proof(IT::Tie_proof::PROVEN);
  IT::Geodesic_path_network<IT::Filtered_edge_length_traits> network(t);
  const std::size_t line = network.add_path(IT::shortest_edge_path(t, from, to));
  ASSERT_EQ(network.shorten().status, IT::Geodesic_status::GEODESIC);
  ASSERT_EQ(network.halfedges(line).size(), 1u);
  const IT::Halfedge_index h = network.halfedges(line).front();
  ASSERT_EQ(t.number_of_crossings(t.connectivity().edge(h)), 2 * (n - 1));
  const auto& engine = IT::internal::engine(t);
  const auto surface = engine.input_surface();
  IT::internal::Parallel_folds level(t.connectivity(), engine.correspondence(), *surface);
  const IT::internal::Vertex_positions::Inserted none;
  const IT::internal::Vertex_positions positions(t.input(), engine.metric().points(),
                                                 engine.correspondence().locations(), none);
  for (std::uint32_t i = 1; i + 1 < n; ++i) {
    const IT::Surface_point on_line = point_of(i, 0.5), above = point_of(i, 0.5 + 0x1p-53);
    EXPECT_TRUE(level.contains(h, positions, on_line));
    EXPECT_FALSE(level.contains(h, positions, above));
    EXPECT_EQ(engine.side_of(h, 2 * i, on_line), CGAL::ZERO);
    EXPECT_EQ(engine.side_of(h, 2 * i, above), CGAL::POSITIVE);
  }
}

// Two segments in the outermost rectangles of a high folded strip, along the folds: from `low` to `high`, as parts of
// its height.
struct Trapezoid
{
  double low_left, high_left, low_right, high_right;
};

// The number of edges between the corners that are proven to be ties, like the diagonal of a trapezoid, once all edges
// are Delaunay.
std::size_t number_of_ties_along_folds(const Trapezoid& corners, IT::Stage_counts& stages)
{
  double length = 0;
  Surface strip = folded_strip(24, length);
  for (Point& p : strip.points)
    p[2] *= 16;
  Triangulation t = triangulation_of(strip);
  t.set_tie_proof(IT::Tie_proof::PROVEN);
  const auto insert = [&](std::uint32_t rectangle, double part_of_width, double part_of_height) {
    // In the lower triangle, whose corners are on the left, on the right, and above that.
    const IT::Halfedge_index h = t.input().halfedge(IT::Face_index(2 * rectangle));
    IT::insert_vertex(t, {h, {1 - part_of_width, part_of_width - part_of_height, part_of_height}});
  };
  insert(0, 0.75, corners.low_left);
  insert(0, 0.75, corners.high_left);
  insert(23, 0.625, corners.low_right);
  insert(23, 0.625, corners.high_right);
  IT::flip_to_Delaunay(t);
  stages = t.stage_counts();
  EXPECT_TRUE(IT::verify_Delaunay(t).is_Delaunay());
  const IT::Delta_complex& complex = t.connectivity();
  const auto& engine = IT::internal::engine(t);
  const auto surface = engine.input_surface();
  std::size_t result = 0;
  for (IT::Edge_index e : complex.edges())
    if (!complex.is_border(e) &&
        IT::internal::Parallel_folds(complex, engine.correspondence(), *surface).is_trapezoid(e)) {
      EXPECT_GT(t.number_of_crossings(e), 40);
      IT::internal::Mpfr_metric metric(*surface, {1024});
      const auto [k, l] =
        unfolded_corners(IT::internal::Unfolding<IT::internal::Mpfr_metric>(complex, engine.correspondence(), metric),
                         IT::internal::corners_beside(complex, e));
      const IT::internal::Mpfr_interval sum = k.p * l.four_areas + l.p * k.four_areas;
      EXPECT_LT((std::max)(std::abs(sum.lower_double()), std::abs(sum.upper_double())), 1e-200);
      ++result;
    }
  return result;
}

// In 24 planes, whose widths are independent roots.
TEST(Long_strips, trapezoids_along_parallel_folds_are_proven_to_be_ties)
{
  IT::Stage_counts stages;
  for (const Trapezoid& corners : {Trapezoid{0.4375, 0.5, 0.4375, 0.5}, Trapezoid{0.4375, 0.5, 0.453125, 0.484375}}) {
    EXPECT_EQ(number_of_ties_along_folds(corners, stages), 1u);
    EXPECT_GT(stages[IT::Stage::CONGRUENCE], 0u);
    EXPECT_EQ(stages[IT::Stage::MODULAR], 0u);
  }
  for (double difference : {0x1p-10, -0x1p-50}) {
    EXPECT_EQ(number_of_ties_along_folds({0.4375, 0.5, 0.4375, 0.5 + difference}, stages), 0u);
    EXPECT_EQ(number_of_ties_along_folds({0.4375, 0.5, 0.4375 + difference, 0.5 + difference}, stages), 0u);
  }
}

// In space, edges that wind once around a tube seem to run along its folds.
TEST(Long_strips, parallelograms_that_wind_around_a_tube_are_no_trapezoids)
{
  Surface tube;
  for (double z : {0., 1.})
    for (const auto& [x, y] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)})
      tube.points.push_back({double(x), double(y), z});
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t next = (i + 1) % 4;
    tube.triangles.push_back({i, next, 4 + next});
    tube.triangles.push_back({i, 4 + next, 4 + i});
  }
  Triangulation t = triangulation_of(tube);
  const IT::Delta_complex& complex = t.connectivity();
  std::array<std::vector<IT::Edge_index>, 2> by_winding; // by 0 and by 1 of 4 sides; a flip adds 2
  for (IT::Edge_index e : complex.edges())
    if (!complex.is_border(e)) {
      const IT::Halfedge_index h = complex.halfedge(e);
      by_winding[complex.source(h).idx() % 4 == complex.target(h).idx() % 4 ? 0 : 1].push_back(e);
    }
  for (int winding = 0; winding < 5; ++winding) {
    ASSERT_EQ(by_winding[winding % 2].size(), 4u);
    for (IT::Edge_index e : by_winding[winding % 2])
      ASSERT_EQ(t.flip(e), Triangulation::Flip_outcome::FLIPPED);
    const auto& engine = IT::internal::engine(t);
    const auto surface = engine.input_surface();
    IT::internal::Parallel_folds folds(complex, engine.correspondence(), *surface);
    for (IT::Edge_index e : complex.edges())
      EXPECT_FALSE(!complex.is_border(e) && folds.is_trapezoid(e)) << winding;
  }
}

// What crosses a hinge may be laid out although its diagonal crosses too many input edges. On a tetrahedron of four
// congruent faces, all hinges are convex.
TEST(Long_strips, diagonals_that_cross_too_many_input_edges_are_not_asked_for_folds)
{
  const Surface tetrahedron{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                            {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
  IT::Delta_complex complex = triangulation_of(tetrahedron).connectivity();
  IT::internal::Correspondence correspondence(complex, IT::internal::Normal_coordinates(complex), {});
  std::array<std::vector<IT::Edge_index>, 3> opposite_edges; // one of two is at vertex 0
  for (IT::Edge_index e : complex.edges()) {
    const std::uint32_t i = complex.source(complex.halfedge(e)).idx(), j = complex.target(complex.halfedge(e)).idx();
    opposite_edges[i == 0 || j == 0 ? i + j - 1 : 5 - i - j].push_back(e);
  }
  const auto number_of_crossings = [&](IT::Edge_index e) {
    return correspondence.coordinates().number_of_crossings(e);
  };
  IT::Edge_index last;
  for (std::size_t i = 0; i == 0 || number_of_crossings(last) <= IT::internal::Crossing_sequence::largest_number; ++i)
    for (IT::Edge_index e : opposite_edges[i % 3]) {
      const IT::Hinge_halfedges around = complex.hinge(e);
      correspondence.flip(complex, around);
      complex.flip(around);
      last = e;
    }
  for (IT::Halfedge_index side : {complex.hinge(last).jk, complex.hinge(last).ki})
    EXPECT_LE(number_of_crossings(complex.edge(side)), IT::internal::Crossing_sequence::largest_number);
  const IT::Input_metric metric = IT::Input_metric::from_points({tetrahedron.points.begin(), tetrahedron.points.end()});
  const IT::internal::Decisions decisions;
  IT::internal::Input_properties properties(correspondence.input(), metric);
  IT::internal::Input_surface surface(correspondence.input(), metric, decisions, properties);
  EXPECT_FALSE(IT::internal::Parallel_folds(complex, correspondence, surface).is_trapezoid(last));
}

// Two edges are left at a vertex, so that two corners sum to the total angle: nearly π, except at the last vertex.
TEST(Long_strips, all_angles_at_a_vertex_are_not_taken_for_none)
{
  for (double height : {0x1p-10, -0x1p-10, 0x1p-130, -0x1p-130}) {
    const Surface surface{{{6, 6, 0}, {6, 0, -6}, {0, 6, -6}, {0, 0, height}, {2, 2, -4}},
                          {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {2, 1, 4}, {3, 2, 4}, {1, 3, 4}}};
    Triangulation t = triangulation_of(surface);
    const auto edge = [&](std::uint32_t from, std::uint32_t to) {
      for (IT::Halfedge_index h : t.connectivity().halfedges())
        if (t.connectivity().source(h).idx() == from && t.connectivity().target(h).idx() == to)
          return t.connectivity().edge(h);
      return IT::Edge_index();
    };
    for (const auto& [from, to] : {std::pair(1u, 2u), std::pair(0u, 1u), std::pair(0u, 2u)})
      ASSERT_EQ(t.flip(edge(from, to)), Triangulation::Flip_outcome::FLIPPED);
    for (std::uint32_t to : {3u, 4u})
      EXPECT_EQ(IT::internal::engine(t).is_convex(edge(0, to)), height < 0) << height << ' ' << to;
  }
}

bool is_proven_to_be_straight(const Surface& surface)
{
  const Triangulation t = triangulation_of(surface);
  const IT::Delta_complex& complex = t.connectivity();
  IT::Halfedge_index left, right;
  for (IT::Halfedge_index h : complex.halfedges())
    if (complex.source(h).idx() == 2 && complex.target(h).idx() % 2 == 0)
      (complex.is_border(h) ? left : right) = h;
  const auto& geometry = IT::internal::engine(t);
  const auto input = geometry.input_surface();
  return IT::internal::Parallel_folds(complex, geometry.correspondence(), *input).are_level(right, left);
}

TEST(Long_strips, lines_are_not_proven_to_be_straight_where_they_bend)
{
  double length = 0;
  const Surface level = folded_strip(2, length);
  EXPECT_TRUE(is_proven_to_be_straight(level));
  for (std::size_t moved : {0, 4}) { // an end that is not level
    Surface bent = level;
    bent.points[moved][2] = 0x1p-50;
    EXPECT_FALSE(is_proven_to_be_straight(bent));
  }
  Surface bent = level; // a fold that is not vertical
  bent.points[3][0] += 0x1p-50;
  EXPECT_FALSE(is_proven_to_be_straight(bent));
}

} // namespace
