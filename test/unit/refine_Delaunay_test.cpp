// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Refinement: faces below the bound are listed with a reason.

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/straight_walk.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/refine_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/surface_features.h>
#include <CGAL/Intrinsic_triangulations/verify_Delaunay.h>

#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

Triangulation triangulation_of(const samples::Indexed_triangles& surface)
{
  return Triangulation(IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles), surface.points);
}

void expect_refined(const Triangulation& triangulation, const IT::Refinement_report& report, double minimum_angle = 25,
                    double maximum_edge_length = std::numeric_limits<double>::infinity())
{
  EXPECT_EQ(report.status, IT::Refinement_status::REFINED);
  const IT::Delta_complex& complex = triangulation.connectivity();
  ASSERT_TRUE(complex.is_valid());
  for (IT::Edge_index e : complex.edges()) {
    if (complex.is_flippable(e)) {
      ASSERT_NE(IT::internal::engine(triangulation).test(e, IT::internal::Exact_engine::Means::UNFOLDING)->sign,
                CGAL::NEGATIVE);
    }
  }
  std::set<IT::Face_index> listed;
  for (const IT::Unrefined_face& f : report.unrefined) {
    EXPECT_NE(f.reason, IT::Refinement_obstacle::BUDGET);
    listed.insert(f.face);
  }
  for (IT::Face_index f : complex.faces()) {
    if (listed.count(f) != 0)
      continue;
    const IT::Halfedge_index h = complex.halfedge(f);
    for (IT::Halfedge_index side : {h, complex.next(h), complex.prev(h)}) {
      EXPECT_GE(IT::angle(triangulation, side) * 180 / CGAL_PI, minimum_angle * (1 - 1e-12));
      EXPECT_LE(triangulation.length(complex.edge(side)), maximum_edge_length);
    }
  }
}

TEST(Refine_Delaunay, leaves_no_thin_triangle)
{
  for (const samples::Indexed_triangles& surface :
       {samples::torus(), samples::bad_torus(30, 30), samples::bumpy_dome(), samples::disk_with_spike(),
        samples::Schwarz_lantern(), samples::cap(1e-17), samples::cap(0.1), samples::prism(), samples::pillow(60),
        samples::strip(200, 30)}) {
    Triangulation triangulation = triangulation_of(surface);
    const IT::Refinement_report report = IT::refine_Delaunay(triangulation);
    expect_refined(triangulation, report);
    EXPECT_TRUE(report.unrefined.empty());
  }
}

// geometry-central needs as many for the same surfaces, by circumcenters.
TEST(Refine_Delaunay, needs_few_vertices)
{
  for (const auto& [surface, others] :
       {std::pair(samples::bad_torus(), std::size_t(6101)), std::pair(samples::prism(), std::size_t(379)),
        std::pair(samples::bumpy_dome(), std::size_t(149))}) {
    Triangulation triangulation = triangulation_of(surface);
    EXPECT_LT(IT::refine_Delaunay(triangulation).insertions, others * 4 / 5);
  }
}

// On a closed surface whose cones are not small, new vertices keep away from all others (doc/termination.md).
TEST(Refine_Delaunay, makes_no_edge_shorter_than_all)
{
  for (double degrees : {15., 25., 30.})
    for (const samples::Indexed_triangles& surface :
         {samples::bumpy_sphere(), samples::bad_torus(30, 30), samples::pillow(60), samples::prism()}) {
      Triangulation triangulation = triangulation_of(surface);
      IT::flip_to_Delaunay(triangulation);
      const auto shortest = [&] {
        const std::vector<double> lengths = IT::edge_lengths(triangulation);
        return *std::min_element(lengths.begin(), lengths.end());
      };
      const double before = shortest();
      IT::refine_Delaunay(triangulation, CGAL::parameters::minimum_angle(degrees));
      EXPECT_GE(shortest(), before * (1 - 1e-12));
    }
}

// Flips before the refinement count like flips within it.
TEST(Refine_Delaunay, counts_all_flips)
{
  Triangulation triangulation = triangulation_of(samples::pillow(60)), other = triangulation;
  const std::uint64_t flips = IT::flip_to_Delaunay(other).flips;
  EXPECT_GT(flips, 1000u);
  EXPECT_EQ(IT::refine_Delaunay(triangulation).flips, flips + IT::refine_Delaunay(other).flips);
}
TEST(Refine_Delaunay, makes_large_triangles_small)
{
  Triangulation triangulation =
    triangulation_of({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}});
  const IT::Refinement_report report = IT::refine_Delaunay(triangulation, CGAL::parameters::maximum_edge_length(0.05));
  expect_refined(triangulation, report, 25, 0.05);
  EXPECT_TRUE(report.unrefined.empty());
  EXPECT_GT(report.insertions, 300u);
}

// An open one, whose sides are 1 long.
samples::Indexed_triangles cone(double degrees)
{
  samples::Indexed_triangles result;
  const double radius = degrees / 360, height = std::sqrt(1 - radius * radius);
  const std::uint32_t n = 12;
  result.points.push_back({0, 0, height});
  for (std::uint32_t i = 0; i < n; ++i) {
    result.points.push_back({radius * std::cos(2 * CGAL_PI * i / n), radius * std::sin(2 * CGAL_PI * i / n), 0});
    result.triangles.push_back({0, i + 1, (i + 1) % n + 1});
  }
  return result;
}

// A needle of 5 degrees: its tip is left, and nothing else.
TEST(Refine_Delaunay, protects_small_cones)
{
  for (double degrees : {5., 20., 59.}) {
    Triangulation triangulation = triangulation_of(cone(degrees));
    const IT::Refinement_report report = IT::refine_Delaunay(triangulation);
    expect_refined(triangulation, report);
    EXPECT_EQ(report.unrefined.size(), degrees < 25 ? 1u : 0u) << degrees;
    for (const IT::Unrefined_face& f : report.unrefined)
      EXPECT_EQ(f.reason, IT::Refinement_obstacle::CONE);
  }
}

// No edge at the tip is longer than others may be, nor a circumcircle larger.
TEST(Refine_Delaunay, keeps_sizes_at_small_cones)
{
  for (double degrees : {1., 5., 20., 59.})
    for (double size : {0.5, 0.1, 0.02}) {
      const auto size_at_tip = boost::make_function_property_map<IT::Vertex_index, double>(
        [size](IT::Vertex_index v) { return v.idx() == 0 ? size : std::numeric_limits<double>::infinity(); });
      Triangulation by_length = triangulation_of(cone(degrees)), by_radius = by_length, by_sizes = by_length;
      const IT::Refinement_report report = IT::refine_Delaunay(by_length, CGAL::parameters::maximum_edge_length(size));
      expect_refined(by_length, report, 25, size);
      for (double length : IT::edge_lengths(by_length))
        EXPECT_LE(length, size);
      IT::refine_Delaunay(by_radius, CGAL::parameters::maximum_circumradius(size));
      for (IT::Face_index f : by_radius.connectivity().faces()) {
        double product = 1;
        IT::Halfedge_index h = by_radius.connectivity().halfedge(f);
        for (int i = 0; i < 3; ++i, h = by_radius.connectivity().next(h))
          product *= by_radius.length(by_radius.connectivity().edge(h));
        EXPECT_LE(product / (4 * by_radius.area(f)), size * (1 + 1e-12));
      }
      IT::refine_Delaunay(by_sizes, CGAL::parameters::size_map(size_at_tip));
      const IT::Delta_complex& complex = by_sizes.connectivity();
      for (IT::Halfedge_index h : IT::internal::Halfedges_around(complex, IT::Vertex_index(0)))
        EXPECT_LE(by_sizes.length(complex.edge(h)), size * 1.3);
    }
}

// A triangle with a corner of one degree between border edges.
TEST(Refine_Delaunay, leaves_small_corners_of_the_border)
{
  Triangulation triangulation =
    triangulation_of({{{0, 0, 0}, {1, 0, 0}, {std::cos(CGAL_PI / 180), std::sin(CGAL_PI / 180), 0}}, {{0, 1, 2}}});
  const IT::Refinement_report report = IT::refine_Delaunay(triangulation);
  expect_refined(triangulation, report);
  std::size_t at_corner = 0;
  for (const IT::Unrefined_face& f : report.unrefined) {
    at_corner += f.reason == IT::Refinement_obstacle::SMALL_INPUT_ANGLE;
    EXPECT_TRUE(f.reason == IT::Refinement_obstacle::SMALL_INPUT_ANGLE ||
                f.reason == IT::Refinement_obstacle::BESIDE_SMALL_INPUT_ANGLE);
  }
  EXPECT_EQ(at_corner, 1u);
}

// Two sides of a box, much closer to each other than the smallest size.
TEST(Refine_Delaunay, leaves_what_is_too_small)
{
  samples::Indexed_triangles plate;
  for (double z : {0., 1e-5})
    for (const auto& [x, y] : {std::pair(0., 0.), std::pair(1., 0.), std::pair(1., 1.), std::pair(0., 1.)})
      plate.points.push_back({x, y, z});
  plate.triangles = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}};
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t j = (i + 1) % 4;
    plate.triangles.push_back({i, j, j + 4});
    plate.triangles.push_back({i, j + 4, i + 4});
  }
  Triangulation triangulation = triangulation_of(plate);
  const IT::Refinement_report report =
    IT::refine_Delaunay(triangulation, CGAL::parameters::minimum_size(0.01).maximum_edge_length(0.3));
  EXPECT_EQ(report.status, IT::Refinement_status::REFINED);
  EXPECT_LT(report.insertions + report.segment_splits, 2000u);
  EXPECT_FALSE(report.unrefined.empty());
  const IT::Delta_complex& complex = triangulation.connectivity();
  std::set<IT::Face_index> listed;
  for (const IT::Unrefined_face& f : report.unrefined) {
    const IT::Halfedge_index h = complex.halfedge(f.face);
    double shortest = std::numeric_limits<double>::infinity();
    for (IT::Halfedge_index side : {h, complex.next(h), complex.prev(h)})
      shortest = (std::min)(shortest, triangulation.length(complex.edge(side)));
    EXPECT_TRUE(f.reason == IT::Refinement_obstacle::TOO_SMALL && shortest < 0.01) << f.face.idx();
    listed.insert(f.face);
  }
  for (IT::Face_index f : complex.faces()) {
    const IT::Halfedge_index h = complex.halfedge(f);
    for (IT::Halfedge_index side : {h, complex.next(h), complex.prev(h)})
      EXPECT_TRUE(listed.count(f) != 0 || IT::angle(triangulation, side) * 180 / CGAL_PI > 25 * (1 - 1e-12));
  }
}

// A face at the border that is low, but has no short side.
const samples::Indexed_triangles low_cap = {{{0, 0, 0}, {2, 0, 0}, {1.001, 5e-7, 0}, {2, 1, 0}},
                                            {{0, 1, 2}, {2, 1, 3}}};

TEST(Refine_Delaunay, leaves_what_is_too_low)
{
  for (const double size : {1e-6, 1e-3}) {
    Triangulation triangulation = triangulation_of(low_cap);
    const IT::Refinement_report report = IT::refine_Delaunay(triangulation, CGAL::parameters::minimum_size(size));
    EXPECT_EQ(report.minimum_size, size);
    EXPECT_EQ(report.insertions + report.segment_splits, 0u);
    ASSERT_EQ(report.unrefined.size(), 1u);
  }
  // Its long edges are split all the same.
  Triangulation triangulation = triangulation_of(low_cap);
  EXPECT_GT(
    IT::refine_Delaunay(triangulation, CGAL::parameters::minimum_size(1e-6).maximum_edge_length(0.25)).segment_splits,
    5u);
}

struct Noting_visitor
{
  bool go_further(const IT::Progress&) { return true; }
  void before_step(const IT::Refinement_progress& progress) { is_on_trial = is_on_trial || progress.is_on_trial; }
  void after_insertion(IT::Vertex_index v) { vertices.push_back(v.idx()); }
  bool is_on_trial = false;
  std::vector<std::size_t> vertices;
};

// 0 needs thousands of vertices. Earlier trials leave no trace except in the stage counts.
TEST(Refine_Delaunay, chooses_a_smallest_size)
{
  Triangulation all = triangulation_of(low_cap);
  EXPECT_GT(IT::refine_Delaunay(all, CGAL::parameters::minimum_size(0.).maximum_number(2000)).segment_splits, 1000u);
  // The cap beside a disk that needs vertices, too.
  samples::Indexed_triangles surface = samples::bumpy_dome();
  const auto first = std::uint32_t(surface.points.size());
  for (const auto& p : low_cap.points)
    surface.points.push_back({p[0] + 10, p[1], p[2]});
  for (const auto& t : low_cap.triangles)
    surface.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  Triangulation t = triangulation_of(surface), u = t;
  int questions = 0;
  t.set_interruption([&questions] { return ++questions > 0; });
  Noting_visitor visitor;
  const IT::Refinement_report report = IT::refine_Delaunay(t, CGAL::parameters::visitor(std::ref(visitor)));
  EXPECT_TRUE(visitor.is_on_trial);
  EXPECT_GT(report.minimum_size, 5e-7);
  EXPECT_LT(report.minimum_size, 1e-3);
  EXPECT_EQ(report.unrefined.size(), 1u);
  EXPECT_TRUE(bool(t.set_interruption({})));
  std::vector<std::size_t> expected;
  for (std::size_t v = surface.points.size(); v < t.connectivity().number_of_vertices(); ++v)
    expected.push_back(v);
  EXPECT_FALSE(expected.empty());
  EXPECT_EQ(visitor.vertices, expected);
  EXPECT_EQ(report.insertions + report.segment_splits, expected.size());
  const IT::Refinement_report again =
    IT::refine_Delaunay(u, CGAL::parameters::minimum_size(std::optional<double>(report.minimum_size)));
  EXPECT_TRUE(t.connectivity() == u.connectivity());
  EXPECT_EQ(again.flips, report.flips);
  for (double bad : {-1., std::nan("")})
    EXPECT_THROW(IT::refine_Delaunay(u, CGAL::parameters::minimum_size(bad)), IT::Invalid_argument_error);
}

struct Limited_visitor
{
  bool go_further(const IT::Progress& progress) { return progress.insertions < 10; }
  void after_insertion(IT::Vertex_index) { ++insertions; }
  int insertions = 0;
};

TEST(Refine_Delaunay, ends_early_where_told_to)
{
  Triangulation triangulation = triangulation_of(samples::bad_torus(30, 30));
  Limited_visitor visitor;
  EXPECT_THROW(IT::refine_Delaunay(triangulation, CGAL::parameters::visitor(std::ref(visitor))), IT::Cancelled_error);
  EXPECT_EQ(visitor.insertions, 10);
  const IT::Refinement_report exhausted = IT::refine_Delaunay(triangulation, CGAL::parameters::maximum_number(5));
  EXPECT_EQ(exhausted.status, IT::Refinement_status::BUDGET_EXHAUSTED);
  EXPECT_EQ(exhausted.insertions, 5u);
  EXPECT_FALSE(exhausted.unrefined.empty());
  expect_refined(triangulation, IT::refine_Delaunay(triangulation));
}

struct Progress_visitor : IT::Default_visitor
{
  void before_step(const IT::Refinement_progress& progress)
  {
    EXPECT_GE(progress.points, last.points);
    EXPECT_GT(progress.waiting_faces, 0u);
    EXPECT_GT(progress.size, 0);
    EXPECT_TRUE(progress.face.is_valid());
    if (progress.estimated_points != last.estimated_points && first_estimate == 0)
      first_estimate = progress.points + progress.estimated_points;
    last = progress;
  }
  IT::Refinement_progress last;
  std::uint64_t first_estimate = 0;
};

TEST(Refine_Delaunay, estimates_how_many_vertices_are_needed)
{
  const samples::Indexed_triangles square = {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  // A tube around which triangles cannot be longer than it is wide.
  const samples::Indexed_triangles tube = {
    {{0, 0, 0}, {1, 0, 0}, {0, 1e-4, 0}, {1, 1e-4, 0}, {0, 0, 1e-4}, {1, 0, 1e-4}},
    {{0, 1, 3}, {0, 3, 2}, {2, 3, 5}, {2, 5, 4}, {4, 5, 1}, {4, 1, 0}}};
  const double infinity = std::numeric_limits<double>::infinity();
  for (const auto& [surface, edge, circumradius] :
       {std::tuple{square, 0.02, infinity}, std::tuple{square, infinity, 0.012},
        std::tuple{tube, infinity, infinity}}) {
    Triangulation triangulation = triangulation_of(surface);
    Progress_visitor visitor;
    const IT::Refinement_report report = IT::refine_Delaunay(
      triangulation,
      CGAL::parameters::maximum_edge_length(edge).maximum_circumradius(circumradius).visitor(std::ref(visitor)));
    const double needed = double(report.insertions + report.segment_splits);
    EXPECT_EQ(report.status, IT::Refinement_status::REFINED);
    EXPECT_GT(double(visitor.first_estimate), 0.5 * needed);
    EXPECT_LT(double(visitor.first_estimate), 2 * needed);
    EXPECT_LE(visitor.last.points, report.insertions + report.segment_splits);
  }
}

// Fifty pairs of vertices close to each other need many close vertices, but few for the whole surface.
TEST(Refine_Delaunay, takes_no_smallest_size_where_all_faces_need_few_vertices)
{
  constexpr std::uint32_t n = 40;
  samples::Indexed_triangles sheet;
  for (std::uint32_t y = 0; y <= n; ++y)
    for (std::uint32_t x = 0; x <= n; ++x)
      sheet.points.push_back({double(x), double(y), 0});
  for (std::uint32_t y = 0; y < n; ++y)
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t i = y * (n + 1) + x, j = i + 1, k = j + n + 1, l = k - 1;
      if ((x * n + y) % 32 != 0) {
        sheet.triangles.insert(sheet.triangles.end(), {{i, j, k}, {i, k, l}});
        continue;
      }
      const auto a = std::uint32_t(sheet.points.size()), b = a + 1;
      sheet.points.push_back({x + 0.5 - 5e-5, y + 0.5, 0});
      sheet.points.push_back({x + 0.5 + 5e-5, y + 0.5, 0});
      sheet.triangles.insert(sheet.triangles.end(), {{i, j, b}, {i, b, a}, {j, k, b}, {k, l, a}, {k, a, b}, {l, i, a}});
    }
  Triangulation triangulation = triangulation_of(sheet);
  const IT::Refinement_report report = IT::refine_Delaunay(triangulation);
  EXPECT_EQ(report.minimum_size, 0);
  EXPECT_TRUE(report.unrefined.empty());
  EXPECT_GT(report.insertions, 1000u);
}

// A smallest size also ends the splitting of edges for their own sake.
TEST(Refine_Delaunay, splits_no_edge_below_the_smallest_size)
{
  const samples::Indexed_triangles needle = {{{0, 0, 0}, {1, 0, 0}, {0.6, 1e-5, 0}, {0.3, 1e-5, 0}},
                                             {{0, 1, 2}, {0, 2, 3}}};
  Triangulation triangulation = triangulation_of(needle);
  const IT::Refinement_report report =
    IT::refine_Delaunay(triangulation, CGAL::parameters::minimum_size(1e-3).splits_encroached_edges(true));
  expect_refined(triangulation, report);
  EXPECT_GT(report.segment_splits, 100u);
  EXPECT_LT(report.segment_splits, 3000u);
  for (IT::Edge_index e : triangulation.connectivity().edges()) {
    if (triangulation.connectivity().is_border(e) && triangulation.length(e) > 1e-4) {
      EXPECT_GE(triangulation.length(e), 0.6e-3); // beside small corners, two thirds are split off
    }
  }
}

// Stops after the given number of questions.
struct Counting_visitor
{
  bool go_further(const IT::Progress& progress)
  {
    insertions = progress.insertions;
    return number-- > 0;
  }
  int number;
  std::uint64_t insertions = 0;
};

TEST(Refine_Delaunay, asks_while_edges_are_flipped_at_first)
{
  for (int number : {0, 100}) {
    Triangulation triangulation = triangulation_of(samples::bad_torus(30, 30));
    Counting_visitor visitor{number};
    EXPECT_THROW(IT::refine_Delaunay(triangulation, CGAL::parameters::visitor(std::ref(visitor))), IT::Cancelled_error);
    EXPECT_EQ(visitor.insertions, 0u);
    EXPECT_EQ(triangulation.connectivity().number_of_vertices(), 900u);
    EXPECT_FALSE(IT::verify_Delaunay(triangulation).is_Delaunay());
  }
}

// A vertex that is far away makes needles whose corners there are smaller than what doubles resolve. A line that is
// followed in doubles then goes round and round.
// Around a needle: where the walk stops, the line to the middle of its part in the same triangle ends, too.
TEST(Straight_walk, stops_where_it_is_too_long)
{
  const std::vector<std::array<double, 3>> points{{0, 0, 0}, {1, 0, 0}, {0.5, 1e-4, 0}, {0.5, 0, 2e-4}};
  const IT::Delta_complex complex = IT::make_Delta_complex_from_triangles(
    4, std::vector<std::array<std::size_t, 3>>{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
  const auto length = [&](IT::Halfedge_index h) {
    const auto &p = points[complex.source(h).idx()], &q = points[complex.target(h).idx()];
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  };
  const auto apex = [&](IT::Halfedge_index h) {
    return IT::internal::third_corner(length(h), length(complex.next(h)), length(complex.prev(h)));
  };
  IT::Halfedge_index h = complex.halfedge(IT::Face_index(0));
  while (length(h) < 0.9)
    h = complex.next(h);
  const auto walk = [&](double distance, std::size_t most_edges) {
    return IT::internal::walk_straight(
      complex, h, 0.5, {0.5, distance}, false, apex, [](IT::Edge_index) { return false; }, most_edges);
  };
  constexpr std::size_t most_edges = 200, unlimited = std::size_t(1) << 20;
  const auto stopped = walk(1, most_edges);
  EXPECT_EQ(stopped.number_of_crossed_edges, most_edges + 1);
  // Where the line enters the triangle in which it stopped, and where it leaves it.
  const auto first_beyond = [&](std::size_t crossed) {
    double below = 0, beyond = 1;
    for (int i = 0; i < 60; ++i) {
      const double middle = (below + beyond) / 2;
      (walk(middle, unlimited).number_of_crossed_edges < crossed ? below : beyond) = middle;
    }
    return beyond;
  };
  const auto expected = walk((first_beyond(most_edges + 1) + first_beyond(most_edges + 2)) / 2, unlimited);
  EXPECT_EQ(expected.number_of_crossed_edges, most_edges + 1);
  EXPECT_EQ(stopped.halfedge, expected.halfedge);
  EXPECT_FALSE(stopped.barrier.is_valid());
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(stopped.weights[i], expected.weights[i], 1e-6);
}

TEST(Refine_Delaunay, ends_at_the_tips_of_needles)
{
  samples::Indexed_triangles surface;
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x)
      surface.points.push_back({double(x), double(y), 0});
  surface.points[10][0] = 2147483648.;
  for (std::uint32_t y = 0; y < 3; ++y)
    for (std::uint32_t x = 0; x < 3; ++x) {
      const std::uint32_t a = 4 * y + x, b = a + 1, c = a + 5, d = a + 4;
      surface.triangles.push_back({a, b, c});
      surface.triangles.push_back({a, c, d});
    }
  for (int step : {1, 2, 3, 5}) {
    Triangulation triangulation = triangulation_of(surface);
    std::vector<bool> is_constrained(triangulation.connectivity().number_of_edges());
    for (std::size_t e = 0; e < is_constrained.size(); e += std::size_t(step))
      is_constrained[e] = true;
    const auto map = boost::make_function_property_map<IT::Edge_index, bool>(
      [&](IT::Edge_index e) { return is_constrained[e.idx()]; });
    IT::refine_Delaunay(triangulation, CGAL::parameters::edge_is_constrained_map(map).maximum_number(200));
    EXPECT_TRUE(triangulation.connectivity().is_valid());
  }
}

// A roof with a sliver along its ridge, which has one sharp edge or two, depending on the smallest size.
const samples::Indexed_triangles roof = {
  {{0, -1, 0}, {4, -1, 0}, {0, 0, 1}, {4, 0, 1}, {0, 1e-6, 1}, {4, 1e-6, 1}, {0, 1, 0}, {4, 1, 0}},
  {{0, 1, 3}, {0, 3, 2}, {2, 3, 5}, {2, 5, 4}, {4, 5, 7}, {4, 7, 6}}};

TEST(Refine_Delaunay, keeps_sharp_edges_for_the_smallest_size)
{
  Triangulation t = triangulation_of(roof), u = t;
  const IT::Refinement_report report = IT::refine_Delaunay(t, CGAL::parameters::sharp_edge_angle(30.));
  EXPECT_GT(report.minimum_size, 1e-6);
  const std::vector<bool> is_sharp = IT::sharp_edges(u.connectivity(), roof.points, 30, report.minimum_size);
  EXPECT_EQ(std::count(is_sharp.begin(), is_sharp.end(), true), 1);
  const auto map =
    boost::make_function_property_map<IT::Edge_index, bool>([&](IT::Edge_index e) { return bool(is_sharp[e.idx()]); });
  const IT::Refinement_report again =
    IT::refine_Delaunay(u, CGAL::parameters::minimum_size(report.minimum_size).edge_is_constrained_map(map));
  EXPECT_TRUE(t.connectivity() == u.connectivity());
  EXPECT_EQ(again.flips, report.flips);
  // Another call continues, with parts of sharp edges.
  EXPECT_GT(IT::refine_Delaunay(
              t, CGAL::parameters::sharp_edge_angle(30.).minimum_size(report.minimum_size).maximum_edge_length(0.5))
              .insertions,
            0u);
}

TEST(Refine_Delaunay, names_a_sharp_edge_that_was_flipped)
{
  const samples::Indexed_triangles fold = {{{0, 0, 0}, {4, 0, 0}, {2, 1, 0}, {2, 0, 1}}, {{0, 1, 2}, {1, 0, 3}}};
  Triangulation t = triangulation_of(fold);
  IT::flip_to_Delaunay(t);
  EXPECT_THROW(IT::refine_Delaunay(t, CGAL::parameters::sharp_edge_angle(30.)), IT::Invalid_argument_error);
  EXPECT_EQ(IT::refine_Delaunay(t, CGAL::parameters::sharp_edge_angle(100.)).unrefined.size(), 0u);
  Triangulation u = triangulation_of(fold);
  for (const double bad : {-1., 181., std::nan("")})
    EXPECT_THROW(IT::refine_Delaunay(u, CGAL::parameters::sharp_edge_angle(bad)), IT::Invalid_argument_error);
  IT::refine_Delaunay(u, CGAL::parameters::sharp_edge_angle(30.));
  double on_fold = 0;
  for (IT::Edge_index e : u.connectivity().edges())
    if (u.is_input_edge(e) && u.input().edge(u.input_halfedge(u.connectivity().halfedge(e))).idx() == 0)
      on_fold += u.length(e);
  EXPECT_NEAR(on_fold, 4, 1e-14);
}

} // namespace
