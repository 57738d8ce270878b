// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Several threads: the same result for any number of them, and the same Delaunay tessellation as
// with one after the other. Surfaces have some blocks of 2^16 edges.

#include "samples/sample_surfaces.h"

#include "library/engine/history/Flip_log.h"
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Delaunay_tessellation.h>
#include <CGAL/Intrinsic_triangulations/verify_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Half_angle_traits.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/intrinsic_Delaunay_triangulation.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <tbb/global_control.h>

#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Filtered = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;
using CGAL::Parallel_tag;
using CGAL::Sequential_tag;
using IT::Flip_report;
using IT::Flip_status;

Mesh mesh_of(const samples::Indexed_triangles& triangles)
{
  Mesh mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(triangles.points, triangles.triangles, mesh);
  return mesh;
}

// Few hinges lie in one block.
samples::Indexed_triangles shuffled(samples::Indexed_triangles triangles)
{
  std::shuffle(triangles.triangles.begin(), triangles.triangles.end(), std::mt19937(1));
  return triangles;
}

template <class Traits, class ConcurrencyTag>
auto flipped(const Mesh& mesh, int number_of_threads)
{
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, std::size_t(number_of_threads));
  return IT::intrinsic_Delaunay_triangulation<ConcurrencyTag>(mesh, CGAL::parameters::geom_traits(Traits()));
}

// The cells by their vertices, in an order of their own.
template <class Triangulation>
std::vector<std::vector<std::uint32_t>> cells(const Triangulation& t)
{
  const IT::Delaunay_tessellation tessellation(t);
  std::vector<std::vector<std::uint32_t>> result(tessellation.number_of_cells());
  for (IT::Face_index f : t.connectivity().faces()) {
    IT::Halfedge_index h = t.connectivity().halfedge(f);
    for (int i = 0; i < 3; ++i, h = t.connectivity().next(h))
      result[tessellation.cell(f)].push_back(t.connectivity().target(h).idx());
  }
  for (std::vector<std::uint32_t>& cell : result) {
    std::sort(cell.begin(), cell.end());
    cell.erase(std::unique(cell.begin(), cell.end()), cell.end());
  }
  std::sort(result.begin(), result.end());
  return result;
}

// The input is found again from the logs of the blocks.
void expect_input(const Filtered& t, const Mesh& mesh)
{
  const IT::Delta_complex expected = IT::make_Delta_complex(mesh), &input = t.input();
  for (IT::Halfedge_index h : expected.halfedges()) {
    ASSERT_EQ(input.next(h), expected.next(h));
    ASSERT_EQ(input.target(h), expected.target(h));
    ASSERT_EQ(input.face(h), expected.face(h));
  }
}

void expect_same_numbers(const Filtered& several, const Filtered& one)
{
  const IT::internal::Correspondence &a = IT::internal::engine(several).correspondence(),
                                     &b = IT::internal::engine(one).correspondence();
  for (IT::Edge_index e : one.connectivity().edges()) {
    const IT::Halfedge_index h = one.connectivity().halfedge(e);
    ASSERT_EQ(a.coordinates().crossings(e), b.coordinates().crossings(e));
    ASSERT_EQ(a.input_halfedge(h), b.input_halfedge(h));
    ASSERT_EQ(several.edge_data(e), one.edge_data(e));
  }
}

// Returns how the tests were decided.
IT::Stage_counts expect_same_with_any_number_of_threads(const samples::Indexed_triangles& triangles)
{
  const Mesh mesh = mesh_of(triangles);
  const auto sequential = flipped<IT::Filtered_edge_length_traits, Sequential_tag>(mesh, 1).triangulation;
  const auto [one, report_of_one] = flipped<IT::Filtered_edge_length_traits, Parallel_tag>(mesh, 1);
  const auto expected = cells(sequential);
  EXPECT_TRUE(cells(one) == expected);
  EXPECT_TRUE(one.connectivity().is_valid(true));
  EXPECT_TRUE(IT::verify_Delaunay(one).is_Delaunay());
  const auto& decided = one.stage_counts().decided;
  EXPECT_EQ(std::accumulate(decided.begin(), decided.end(), std::uint64_t(0)), report_of_one.tests);
  expect_input(one, mesh);
  for (int threads : {2, 3, 8}) {
    const auto [several, report] = flipped<IT::Filtered_edge_length_traits, Parallel_tag>(mesh, threads);
    EXPECT_EQ(report.status, Flip_status::DELAUNAY);
    EXPECT_EQ(report.flips, report_of_one.flips);
    EXPECT_EQ(report.tests, report_of_one.tests);
    EXPECT_EQ(several.stage_counts().decided, decided);
    EXPECT_EQ(several.stage_counts().ties, one.stage_counts().ties);
    EXPECT_TRUE(several.connectivity() == one.connectivity()) << threads << " threads";
    expect_input(several, mesh);
    expect_same_numbers(several, one);
  }
  return one.stage_counts();
}

TEST(Parallel, torus) { expect_same_with_any_number_of_threads(samples::bad_torus(300, 300)); }

TEST(Parallel, faces_in_any_order) { expect_same_with_any_number_of_threads(shuffled(samples::bad_torus(200, 200))); }

TEST(Parallel, boundary_and_many_flips)
{
  expect_same_with_any_number_of_threads(samples::sheared_grid(200, 150, 5.25));
}

TEST(Parallel, ties) { expect_same_with_any_number_of_threads(samples::random_diagonal_grid(200, 150, 1, 7)); }

// With earlier queries, flips and insertions: as many tests and flips in blocks, and none of them followed one by one.
TEST(Parallel, after_queries_as_without)
{
  const samples::Indexed_triangles surface = samples::bad_torus(200, 150);
  Filtered start(IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles), surface.points);
  Filtered asked = start;
  asked.length(IT::Edge_index(0));
  asked.cotangent_weight(IT::Edge_index(1));
  for (int round = 0; round < 2; ++round) {
    Filtered one = start, other = asked;
    const auto expect_same = [&](const Flip_report& a, const Flip_report& b) {
      EXPECT_EQ(a.flips, b.flips);
      EXPECT_EQ(a.tests, b.tests);
      EXPECT_EQ(one.stage_counts().decided, other.stage_counts().decided);
      EXPECT_TRUE(one.connectivity() == other.connectivity());
    };
    expect_same(IT::flip_to_Delaunay<Parallel_tag>(one), IT::flip_to_Delaunay<Parallel_tag>(other));
    using Whole = IT::internal::Whole_triangulation<IT::Filtered_edge_length_traits>;
    using Log = IT::internal::Flip_log;
    const Log &log = Whole(one).engine().log(), &other_log = Whole(other).engine().log();
    for (Log::Reader reader : {Log::INTEGERS, Log::FACES}) {
      EXPECT_EQ(log.number_of_unread(reader), other_log.number_of_unread(reader));
      EXPECT_EQ(log.is_followed_by(reader), other_log.is_followed_by(reader));
    }
    expect_same_numbers(other, one);
    EXPECT_TRUE(IT::verify_Delaunay(other).is_Delaunay());
    // Now flips that are followed.
    for (std::uint32_t i = 0; i < 60000; i += 7)
      if (other.connectivity().is_flippable(IT::Edge_index(i)))
        other.flip(IT::Edge_index(i));
    start = asked = std::move(other);
    asked.cotangent_weight(IT::Edge_index(1));
  }
}

// Stairs of unit squares, with a diagonal each that is a tie: nothing is flipped, and the stages after the filter
// decide all.
samples::Indexed_triangles stairs(std::size_t columns, std::size_t rows)
{
  samples::Indexed_triangles result = samples::random_diagonal_grid(columns, rows);
  for (std::array<double, 3>& p : result.points)
    p = {std::ceil(p[0] / 2), p[1], std::floor(p[0] / 2)};
  return result;
}

TEST(Parallel, ties_in_planes)
{
  const IT::Stage_counts counts = expect_same_with_any_number_of_threads(stairs(200, 150));
  EXPECT_EQ(counts.ties, 30000u);
  EXPECT_EQ(counts[IT::Stage::COPLANAR], 30000u);
  EXPECT_EQ(expect_same_with_any_number_of_threads(shuffled(stairs(160, 150))).ties, 24000u);
}

samples::Indexed_triangles together(const std::vector<samples::Indexed_triangles>& parts)
{
  samples::Indexed_triangles result;
  for (const samples::Indexed_triangles& part : parts) {
    const std::uint32_t first = std::uint32_t(result.points.size());
    result.points.insert(result.points.end(), part.points.begin(), part.points.end());
    for (std::array<std::uint32_t, 3> t : part.triangles)
      result.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  return result;
}

TEST(Parallel, every_stage)
{
  // The angles opposite to the fold sum to pi, and it takes rational numbers to tell so.
  std::vector<samples::Indexed_triangles> parts(
    5000, {{{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, 0, 0.25}}, {{0, 1, 2}, {1, 0, 3}}});
  const IT::Stage_counts folds = expect_same_with_any_number_of_threads(together(parts));
  EXPECT_EQ(folds[IT::Stage::ALGEBRAIC] + folds[IT::Stage::MODULAR], 5000u);
  samples::Indexed_triangles pillow = samples::pillow(60); // ties across long strips
  for (auto& p : pillow.points)
    p[2] = p[1];
  for (const samples::Indexed_triangles& part : {samples::bad_torus(100, 100), pillow, samples::prism(200, 1),
                                                 stairs(50, 40), samples::random_diagonal_grid(50, 40, 1, 1)})
    parts.push_back(part);
  const IT::Stage_counts counts = expect_same_with_any_number_of_threads(together(parts));
  EXPECT_GE(counts[IT::Stage::ALGEBRAIC] + counts[IT::Stage::MODULAR], 5000u);
  EXPECT_GT(counts[IT::Stage::COPLANAR], 2000u);
  EXPECT_GT(counts[IT::Stage::UNFOLDING], 500u);
  EXPECT_GT(counts[IT::Stage::ALGEBRAIC], 0u);
}

TEST(Parallel, components_and_isolated_vertices)
{
  samples::Indexed_triangles triangles = samples::bad_torus(150, 150);
  const std::size_t n = triangles.points.size(), m = triangles.triangles.size();
  triangles.points.push_back({0, 0, 9});
  for (std::size_t v = 0; v < n; ++v) {
    std::array<double, 3> p = triangles.points[v];
    p[2] += 10;
    triangles.points.push_back(p);
  }
  for (std::size_t f = 0; f < m; ++f) {
    std::array<std::uint32_t, 3> t = triangles.triangles[f];
    for (std::uint32_t& v : t)
      v += std::uint32_t(n) + 1;
    triangles.triangles.push_back(t);
  }
  expect_same_with_any_number_of_threads(triangles);
}

TEST(Parallel, rounded_decisions)
{
  const Mesh mesh = mesh_of(samples::bad_torus(200, 200));
  const auto one = flipped<IT::Edge_length_traits<double>, Sequential_tag>(mesh, 1).triangulation;
  for (int threads : {1, 2}) {
    const auto [several, report] = flipped<IT::Edge_length_traits<double>, Parallel_tag>(mesh, threads);
    EXPECT_EQ(report.status, Flip_status::DELAUNAY);
    std::vector<double> a, b;
    for (IT::Edge_index e : one.connectivity().edges()) {
      a.push_back(one.length(e));
      b.push_back(several.length(e));
    }
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    for (std::size_t i = 0; i < a.size(); ++i)
      ASSERT_NEAR(a[i], b[i], 1e-12);
  }
}

// Numbers that threads cannot share are left to one thread; the tag is allowed.
TEST(Parallel, other_traits)
{
  const samples::Indexed_triangles torus = samples::bad_torus(160, 160);
  const Mesh mesh = mesh_of(torus);
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 2);
  const auto expect_Delaunay = [&](auto traits) {
    auto t = IT::intrinsic_triangulation<Parallel_tag>(mesh, CGAL::parameters::geom_traits(traits));
    t.keep_input(IT::Input_metric::from_points({torus.points.begin(), torus.points.end()}));
    const Flip_report report = IT::flip_to_Delaunay<Parallel_tag>(t);
    EXPECT_EQ(report.status, Flip_status::DELAUNAY);
    EXPECT_GT(report.flips, 10000u);
    EXPECT_TRUE(IT::verify_Delaunay(t).is_Delaunay());
  };
  expect_Delaunay(IT::Edge_length_traits<long double>());
  expect_Delaunay(IT::Half_angle_traits<double>());
}

TEST(Parallel, construction_is_the_same)
{
  const Mesh mesh = mesh_of(shuffled(samples::sheared_grid(200, 150, 0.3)));
  const auto a = IT::intrinsic_triangulation<Sequential_tag>(mesh);
  const auto b = IT::intrinsic_triangulation<Parallel_tag>(mesh);
  EXPECT_TRUE(a.connectivity() == b.connectivity());
  for (IT::Vertex_index v : a.connectivity().vertices())
    ASSERT_EQ(a.connectivity().halfedge(v), b.connectivity().halfedge(v));
  for (IT::Edge_index e : a.connectivity().edges())
    ASSERT_EQ(a.edge_data(e), b.edge_data(e));
  for (IT::Face_index f : a.connectivity().faces()) {
    ASSERT_EQ(a.face_data(f).value, b.face_data(f).value);
    ASSERT_EQ(a.face_data(f).error, b.face_data(f).error);
  }
}

TEST(Parallel, bad_input_is_refused)
{
  Mesh mesh = mesh_of(samples::bad_torus(150, 150));
  const auto expect = [&](IT::Invalid_surface_error::Defect defect, std::size_t element) {
    try {
      IT::intrinsic_triangulation<Parallel_tag>(mesh);
      FAIL() << "was accepted";
    } catch (const IT::Invalid_surface_error& error) {
      EXPECT_EQ(error.defect(), defect);
      EXPECT_EQ(error.element(), element);
    }
  };
  const Mesh::Vertex_index v(20000);
  const auto p = mesh.point(v);
  mesh.point(v) = {0, std::numeric_limits<double>::quiet_NaN(), 0};
  expect(IT::Invalid_surface_error::Defect::NOT_FINITE, 20000);
  mesh.point(v) = mesh.point(mesh.target(mesh.next(mesh.halfedge(v))));
  try {
    IT::intrinsic_triangulation<Parallel_tag>(mesh);
    FAIL() << "was accepted";
  } catch (const IT::Invalid_surface_error& error) {
    EXPECT_EQ(error.defect(), IT::Invalid_surface_error::Defect::ZERO_LENGTH_EDGE);
  }
  mesh.point(v) = p;
  mesh.remove_face(Mesh::Face_index(7)); // leaves garbage
  EXPECT_NO_THROW(IT::intrinsic_triangulation<Parallel_tag>(mesh));

  Mesh with_polygon = mesh_of(samples::bad_torus(150, 150));
  std::vector<Mesh::Vertex_index> corners;
  for (int i = 0; i < 4; ++i)
    corners.push_back(with_polygon.add_vertex({double(i), double(i * i), 9}));
  const Mesh::Face_index f = with_polygon.add_face(corners);
  mesh = with_polygon;
  expect(IT::Invalid_surface_error::Defect::NOT_A_TRIANGLE, f);
}

TEST(Parallel, constraints)
{
  const Mesh mesh = mesh_of(samples::bad_torus(200, 200));
  Filtered t = IT::intrinsic_triangulation<Parallel_tag>(mesh);
  const IT::Delta_complex input = t.connectivity();
  const auto is_constrained =
    boost::make_function_property_map<IT::Edge_index>([](IT::Edge_index e) { return e.idx() % 7 == 0; });
  const Flip_report report =
    IT::flip_to_Delaunay<Parallel_tag>(t, CGAL::parameters::edge_is_constrained_map(is_constrained));
  EXPECT_EQ(report.status, Flip_status::DELAUNAY);
  std::size_t not_Delaunay = 0;
  for (IT::Edge_index e : t.connectivity().edges()) {
    if (e.idx() % 7 == 0) {
      const IT::Halfedge_index h = input.halfedge(e);
      ASSERT_EQ(t.connectivity().target(h), input.target(h));
      ASSERT_EQ(t.connectivity().source(h), input.source(h));
    }
    const bool is_Delaunay = CGAL::certainly(t.is_locally_Delaunay(e));
    not_Delaunay += !is_Delaunay;
    EXPECT_TRUE(is_Delaunay || e.idx() % 7 == 0);
  }
  EXPECT_GT(not_Delaunay, 100u);
}

TEST(Parallel, budget_is_kept)
{
  const Mesh mesh = mesh_of(samples::bad_torus(200, 200));
  Filtered t = IT::intrinsic_triangulation<Parallel_tag>(mesh);
  for (std::uint64_t budget : {std::uint64_t(0), std::uint64_t(1), std::uint64_t(10000)}) {
    Filtered copy = t;
    const Flip_report report = IT::flip_to_Delaunay<Parallel_tag>(copy, CGAL::parameters::maximum_number(budget));
    EXPECT_EQ(report.status, Flip_status::BUDGET_EXHAUSTED);
    EXPECT_EQ(report.flips, budget);
    EXPECT_TRUE(copy.connectivity().is_valid(true));
    expect_input(copy, mesh);
    // A second run does the rest.
    EXPECT_EQ(IT::flip_to_Delaunay<Parallel_tag>(copy).status, Flip_status::DELAUNAY);
    EXPECT_TRUE(IT::verify_Delaunay(copy).is_Delaunay());
  }
}

struct Counter
{
  bool go_further(const IT::Progress& progress)
  {
    EXPECT_GE(progress.tests, last_tests);
    last_tests = progress.tests;
    return progress.flips < limit;
  }
  void after_flip(IT::Edge_index)
  {
    if (++flips == throw_at)
      throw std::runtime_error("enough");
  }
  std::uint64_t limit = ~std::uint64_t(0), throw_at = 0, flips = 0, last_tests = 0;
};

TEST(Parallel, visitor_is_told_of_each_flip)
{
  Filtered t = IT::intrinsic_triangulation<Parallel_tag>(mesh_of(samples::bad_torus(200, 200)));
  Counter counter;
  const Flip_report report = IT::flip_to_Delaunay<Parallel_tag>(t, CGAL::parameters::visitor(std::ref(counter)));
  EXPECT_EQ(report.status, Flip_status::DELAUNAY);
  EXPECT_EQ(counter.flips, report.flips);
  EXPECT_LE(counter.last_tests, report.tests);
}

// Stops after the given number of tests; checks that one thread at a time asks it.
struct Test_limit
{
  bool go_further(const IT::Progress& progress)
  {
    const std::uint64_t tests = progress.tests;
    EXPECT_FALSE(is_asked.exchange(true));
    EXPECT_GE(tests, last_tests);
    last_tests = tests;
    EXPECT_TRUE(is_asked.exchange(false));
    if (tests >= limit && throws)
      throw std::runtime_error("enough");
    return tests < limit;
  }
  std::uint64_t limit, last_tests = 0;
  bool throws = false;
  std::atomic<bool> is_asked{false};
};

// All but the 40,000 ties are settled in blocks.
TEST(Parallel, visitor_stops_the_tests_that_were_left_open)
{
  const Filtered input = IT::intrinsic_triangulation<Parallel_tag>(mesh_of(stairs(200, 200)));
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 3);
  for (std::uint64_t limit : {80000, 90000, 115000}) {
    Filtered t = input;
    Test_limit visitor{limit};
    EXPECT_THROW(IT::flip_to_Delaunay<Parallel_tag>(t, CGAL::parameters::visitor(std::ref(visitor))),
                 IT::Cancelled_error);
    EXPECT_GE(visitor.last_tests, limit);
    EXPECT_LT(visitor.last_tests, limit + 4000);
    EXPECT_TRUE(t.connectivity() == input.connectivity());
    EXPECT_EQ(IT::flip_to_Delaunay<Parallel_tag>(t).status, Flip_status::DELAUNAY);

    t = input;
    Test_limit thrower{limit};
    thrower.throws = true;
    EXPECT_THROW(IT::flip_to_Delaunay<Parallel_tag>(t, CGAL::parameters::visitor(std::ref(thrower))),
                 std::runtime_error);
    EXPECT_EQ(IT::flip_to_Delaunay<Parallel_tag>(t).status, Flip_status::DELAUNAY);
  }
}

TEST(Parallel, interruption_stops_the_tests_that_were_left_open)
{
  Filtered t = IT::intrinsic_triangulation<Parallel_tag>(mesh_of(stairs(200, 200)));
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 3);
  bool goes_further = false;
  t.set_interruption([&] { return goes_further; });
  EXPECT_THROW(IT::flip_to_Delaunay<Parallel_tag>(t), IT::Cancelled_error);
  EXPECT_THROW(IT::verify_Delaunay<Parallel_tag>(t), IT::Cancelled_error); // afterwards, others ask it, too
  goes_further = true;
  EXPECT_EQ(IT::flip_to_Delaunay<Parallel_tag>(t).status, Flip_status::DELAUNAY);
}

TEST(Parallel, visitor_cancels)
{
  const Mesh mesh = mesh_of(samples::bad_torus(200, 200));
  Filtered t = IT::intrinsic_triangulation<Parallel_tag>(mesh);
  Counter counter;
  counter.limit = 5000;
  EXPECT_THROW(IT::flip_to_Delaunay<Parallel_tag>(t, CGAL::parameters::visitor(std::ref(counter))),
               IT::Cancelled_error);
  EXPECT_GE(counter.flips, 5000u);
  EXPECT_LT(counter.flips, 15000u);
  EXPECT_TRUE(t.connectivity().is_valid(true));
  expect_input(t, mesh);
}

TEST(Parallel, exception_of_a_visitor_leaves_a_valid_triangulation)
{
  const Mesh mesh = mesh_of(samples::bad_torus(200, 200));
  Filtered t = IT::intrinsic_triangulation<Parallel_tag>(mesh);
  Counter counter;
  counter.throw_at = 3000;
  EXPECT_THROW(IT::flip_to_Delaunay<Parallel_tag>(t, CGAL::parameters::visitor(std::ref(counter))), std::runtime_error);
  EXPECT_TRUE(t.connectivity().is_valid(true));
  expect_input(t, mesh);
  EXPECT_EQ(IT::flip_to_Delaunay<Parallel_tag>(t).status, Flip_status::DELAUNAY);
  EXPECT_TRUE(IT::verify_Delaunay(t).is_Delaunay());
}

} // namespace
