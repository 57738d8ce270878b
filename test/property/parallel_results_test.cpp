// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// With several threads, integers, verifications, overlays, positions, weights and matrices equal the results of one
// thread, bit for bit. Most surfaces have some blocks of 2^14 elements.

#include "samples/sample_gluings.h"
#include "samples/sample_surfaces.h"

#include "library/engine/history/Flip_log.h"
#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/Laplace_Beltrami.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/internal/system/for_each_block.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/verify_Delaunay.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <Eigen/SparseCore>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using CGAL::Parallel_tag;
using Filtered = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;
using Matrix = Eigen::SparseMatrix<double>;

template <class Traits = IT::Filtered_edge_length_traits>
IT::Intrinsic_triangulation<Traits> triangulation(const samples::Indexed_triangles& s)
{
  return {IT::make_Delta_complex_from_triangles(s.points.size(), s.triangles), s.points};
}

Filtered Delaunay(const samples::Indexed_triangles& s)
{
  Filtered t = triangulation(s);
  EXPECT_EQ(IT::flip_to_Delaunay(t).status, IT::Flip_status::DELAUNAY);
  return t;
}

// Edges with the same ends, loops, faces glued to themselves.
Filtered Delaunay(const samples::Glued_triangles& s)
{
  IT::Delta_complex complex = IT::make_Delta_complex_from_gluing(s.number_of_faces, s.glued_sides);
  std::vector<double> lengths(complex.number_of_edges());
  for (IT::Face_index f : complex.faces()) {
    IT::Halfedge_index h = complex.halfedge(f);
    for (std::size_t i = 0; i < 3; ++i, h = complex.next(h))
      lengths[complex.edge(h).idx()] = s.side_lengths[3 * f.idx() + i];
  }
  Filtered t = Filtered::from_lengths(std::move(complex), std::move(lengths));
  EXPECT_EQ(IT::flip_to_Delaunay(t).status, IT::Flip_status::DELAUNAY);
  return t;
}

samples::Indexed_triangles shuffled(samples::Indexed_triangles triangles)
{
  std::shuffle(triangles.triangles.begin(), triangles.triangles.end(), std::mt19937(1));
  return triangles;
}

std::vector<std::pair<std::string, Filtered>> surfaces()
{
  samples::Indexed_triangles with_isolated_vertices = samples::bad_torus(20, 20);
  with_isolated_vertices.points.insert(with_isolated_vertices.points.end(), 20000, {0, 0, 9});
  std::vector<std::pair<std::string, Filtered>> result;
  result.emplace_back("torus", Delaunay(samples::bad_torus(150, 150)));
  result.emplace_back("shuffled torus", Delaunay(shuffled(samples::bad_torus(120, 120))));
  result.emplace_back("with border, long edges", Delaunay(samples::sheared_grid(150, 120, 5.25)));
  result.emplace_back("shuffled, with border", Delaunay(shuffled(samples::random_diagonal_grid(150, 120, 1, 7))));
  result.emplace_back("prism, high degree", Delaunay(samples::prism(9000)));
  result.emplace_back("pillow", Delaunay(samples::pillow(200)));
  result.emplace_back("isolated vertices", Delaunay(with_isolated_vertices));
  result.emplace_back("large gluing", Delaunay(samples::random_gluing(20000, 3)));
  result.emplace_back("open gluing", Delaunay(samples::random_gluing(300, 6, true)));
  result.emplace_back("one-vertex torus", Delaunay(samples::sheared_one_vertex_torus(7.3)));
  result.emplace_back("glued to itself", Delaunay(samples::self_glued_triangle()));
  return result;
}

void expect_same_overlay(const IT::Overlay& a, const IT::Overlay& b)
{
  ASSERT_EQ(a.number_of_vertices(), b.number_of_vertices());
  ASSERT_EQ(a.number_of_segments(), b.number_of_segments());
  ASSERT_EQ(a.number_of_faces(), b.number_of_faces());
  for (IT::Overlay::Halfedge h : a.halfedges()) {
    ASSERT_EQ(a.next(h), b.next(h));
    ASSERT_EQ(a.target(h), b.target(h));
    ASSERT_EQ(a.face(h), b.face(h));
    ASSERT_EQ(a.input_halfedge(h), b.input_halfedge(h));
    ASSERT_EQ(a.intrinsic_halfedge(h), b.intrinsic_halfedge(h));
  }
  for (IT::Overlay::Vertex v : a.vertices())
    ASSERT_EQ(a.halfedge(v), b.halfedge(v));
  for (IT::Overlay::Face f : a.faces()) {
    ASSERT_EQ(a.halfedge(f), b.halfedge(f));
    ASSERT_EQ(a.input_face(f), b.input_face(f));
    ASSERT_EQ(a.intrinsic_face(f), b.intrinsic_face(f));
  }
  for (std::uint32_t e = 0; e < a.number_of_input_edges(); ++e) {
    const IT::Edge_index edge(e);
    ASSERT_EQ(a.number_of_input_segments(edge), b.number_of_input_segments(edge));
    ASSERT_EQ(a.input_part(edge, 0), b.input_part(edge, 0));
    ASSERT_EQ(*a.intrinsic_segments(edge).begin(), *b.intrinsic_segments(edge).begin());
  }
}

bool are_same(const std::vector<double>& a, const std::vector<double>& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

void expect_same_matrix(const Matrix& a, const Matrix& b)
{
  ASSERT_EQ(a.rows(), b.rows());
  ASSERT_EQ(a.nonZeros(), b.nonZeros());
  ASSERT_TRUE(b.isCompressed());
  EXPECT_TRUE(std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.cols() + 1, b.outerIndexPtr()));
  EXPECT_TRUE(std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr()));
  EXPECT_EQ(std::memcmp(a.valuePtr(), b.valuePtr(), std::size_t(a.nonZeros()) * sizeof(double)), 0);
}

template <class Function>
void for_each_number_of_threads(const Function& function)
{
  for (std::size_t threads : {1, 2, 3, 8}) {
    SCOPED_TRACE(std::to_string(threads) + " threads");
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    function();
  }
}

void expect_same_verification(const IT::Delaunay_verification& a, const IT::Delaunay_verification& b)
{
  EXPECT_EQ(a.tests, b.tests);
  EXPECT_EQ(a.ties, b.ties);
  EXPECT_EQ(a.not_Delaunay, b.not_Delaunay);
  EXPECT_EQ(a.inverted, b.inverted);
}

void expect_same_correspondence(const IT::Delta_complex& complex, const IT::internal::Correspondence& a,
                                const IT::internal::Correspondence& b)
{
  ASSERT_TRUE(a.input() == b.input());
  for (IT::Vertex_index v : complex.vertices())
    ASSERT_EQ(a.input().halfedge(v), b.input().halfedge(v));
  for (IT::Halfedge_index h : complex.halfedges()) {
    ASSERT_EQ(a.input_halfedge(h), b.input_halfedge(h));
    ASSERT_EQ(a.coordinates().crossings(complex.edge(h)), b.coordinates().crossings(complex.edge(h)));
    ASSERT_LE(b.coordinates().roundabout(h).steps, 16u); // others were replaced
  }
}

TEST(Parallel_results, integers_and_input)
{
  for (const auto& [name, t] : surfaces()) {
    SCOPED_TRACE(name);
    const Filtered asked = t; // only a copy: t still has the log of its flips
    for_each_number_of_threads([&, &t = t] {
      const Filtered copy = t;
      expect_same_correspondence(t.connectivity(), IT::internal::engine(asked).correspondence(),
                                 IT::internal::engine<Parallel_tag>(copy).correspondence());
    });
  }
}

// Each edge is flipped several times, so that there are long walks around vertices.
TEST(Parallel_results, integers_of_many_flips)
{
  IT::Delta_complex complex = triangulation(samples::bad_torus(100, 100)).connectivity();
  const IT::Delta_complex input = complex;
  IT::internal::Flip_log log;
  for (int round = 0; round < 7; ++round)
    for (IT::Edge_index e : complex.edges()) {
      if (!complex.is_flippable(e))
        continue;
      log.push_back(complex.hinge(e));
      complex.flip(e);
    }
  IT::internal::Correspondence expected;
  expected.catch_up(complex, log);
  for (IT::Halfedge_index h : input.halfedges()) {
    ASSERT_EQ(expected.input().next(h), input.next(h));
    ASSERT_EQ(expected.input().target(h), input.target(h));
  }
  for_each_number_of_threads([&] {
    IT::internal::Correspondence found;
    found.catch_up(complex, log, IT::internal::block_runner<Parallel_tag>());
    expect_same_correspondence(complex, expected, found);
  });
}

// The number of crossings grows like the Fibonacci numbers.
TEST(Parallel_results, integers_that_are_too_large_are_an_error)
{
  const samples::Glued_triangles torus = samples::one_vertex_torus();
  IT::internal::Exact_engine engine(IT::make_Delta_complex_from_gluing(torus.number_of_faces, torus.glued_sides));
  engine.keep_input(IT::Input_metric::from_normalized_lengths({1, 1, 1}, 0));
  const IT::Delta_complex& complex = engine.connectivity();
  for (unsigned i = 0; i < 20; ++i) { // below the number at which it recovers the input on its own
    const IT::Edge_index e(i % 3);
    engine.flip(complex.hinge(e));
  }
  {
    IT::internal::Exact_engine::Logs logs(engine, 1);
    IT::internal::Exact_engine::Logs::Log& log = logs.next();
    for (unsigned i = 20; i < 130; ++i)
      log.flip(complex.hinge(IT::Edge_index(i % 3)));
  }
  for_each_number_of_threads([&] {
    EXPECT_THROW(engine.prepare<Parallel_tag>(), IT::Integer_overflow_error);
    EXPECT_FALSE(engine.log().is_followed());
    EXPECT_EQ(engine.log().size(), 130u);
  });
  EXPECT_THROW(engine.prepare(), IT::Integer_overflow_error);
}

// A thread that waits within the loop must not begin other work, which could ask for a lock that it holds.
TEST(Parallel_results, a_loop_begins_no_other_work)
{
  static thread_local int loop_of_thread = 0;
  const IT::internal::Block_runner run = IT::internal::block_runner<Parallel_tag>();
  for_each_number_of_threads([&] {
    std::atomic<int> number_of_blocks{0};
    const auto loops = [&](int loop) {
      EXPECT_EQ(loop_of_thread, 0);
      loop_of_thread = loop;
      run(10, 1, [&](std::size_t first, std::size_t last) {
        EXPECT_TRUE(loop_of_thread == 0 || loop_of_thread == loop);
        std::this_thread::sleep_for(std::chrono::milliseconds(1 + int(first) % 2));
        number_of_blocks += int(last - first);
      });
      loop_of_thread = 0;
    };
    tbb::task_arena arena(int(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism)));
    arena.execute([&] { tbb::parallel_for(1, 9, loops, tbb::simple_partitioner()); });
    EXPECT_EQ(number_of_blocks, 80);
  });
}

TEST(Parallel_results, tasks_ask_for_the_integers)
{
  const Filtered t = Delaunay(samples::bad_torus(150, 150));
  for_each_number_of_threads([&] {
    const Filtered copy = t;
    std::atomic<int> number_of_answers{0};
    tbb::parallel_for(0, 64, [&](int) {
      number_of_answers += IT::internal::engine<Parallel_tag>(copy).correspondence().knows_input();
    });
    EXPECT_EQ(number_of_answers, 64);
  });
}

TEST(Parallel_results, verifications)
{
  const auto verify = [](const Filtered& t) {
    const IT::Delaunay_verification expected = IT::verify_Delaunay(t);
    for_each_number_of_threads([&] { expect_same_verification(IT::verify_Delaunay<Parallel_tag>(t), expected); });
    return expected;
  };
  const samples::Indexed_triangles torus = shuffled(samples::bad_torus(60, 60));
  EXPECT_GT(verify(triangulation(torus)).not_Delaunay.size(), 1000u);
  EXPECT_TRUE(verify(Delaunay(torus)).is_Delaunay());
  EXPECT_GT(verify(Delaunay(samples::sheared_grid(60, 50, 0))).ties, 1000u);
  EXPECT_TRUE(verify(Delaunay(samples::random_gluing(3000, 3))).is_Delaunay());
  EXPECT_TRUE(verify(Delaunay(samples::self_glued_triangle())).is_Delaunay());
}

// Flips of any hinges, as by a number type that decides wrongly.
struct Flipped_anyhow
{
  explicit Flipped_anyhow(const Filtered& t) : engine_(IT::internal::engine(t))
  {
    const IT::Delta_complex& complex = connectivity();
    std::mt19937 random(1);
    for (std::uint32_t i = 0; i < complex.number_of_edges(); ++i) {
      const IT::Edge_index e(i);
      if (random() % 8 != 0 || !complex.is_flippable(e))
        continue;
      engine_.flip(complex.hinge(e));
    }
  }
  const IT::Delta_complex& connectivity() const { return engine_.connectivity(); }

  IT::internal::Exact_engine engine_;
};

TEST(Parallel_results, faces_inside_out)
{
  const Flipped_anyhow t(triangulation(samples::random_diagonal_grid(60, 50, 1, 7)));
  const IT::Delaunay_verification expected = IT::verify_Delaunay(t);
  EXPECT_GT(expected.inverted.size(), 100u);
  for_each_number_of_threads([&] { expect_same_verification(IT::verify_Delaunay<Parallel_tag>(t), expected); });
}

// A property map that fails for many edges.
struct Failing_map
{
  using key_type = IT::Edge_index;
  using value_type = bool;
  using reference = bool;
  using category = boost::readable_property_map_tag;
  friend bool get(const Failing_map&, IT::Edge_index e)
  {
    if (e.idx() % 1000 == 700 && e.idx() > 9000)
      throw std::out_of_range(std::to_string(e.idx()));
    return false;
  }
};

TEST(Parallel_results, the_first_failure_of_a_verification_is_told)
{
  const Filtered t = Delaunay(samples::bad_torus(100, 100));
  for_each_number_of_threads([&] {
    try {
      IT::verify_Delaunay<Parallel_tag>(t, CGAL::parameters::edge_is_constrained_map(Failing_map()));
      ADD_FAILURE() << "nothing was thrown";
    } catch (const std::out_of_range& error) {
      EXPECT_STREQ(error.what(), "9700");
    }
  });
}

TEST(Parallel_results, verifications_can_be_cancelled)
{
  Filtered t = Delaunay(samples::bad_torus(150, 150));
  for (int calls : {0, 1, 2})
    for_each_number_of_threads([&] {
      std::atomic<int> left = calls;
      t.set_interruption([&left] { return left-- != 0; }); // says so once
      EXPECT_THROW(IT::verify_Delaunay<Parallel_tag>(t), IT::Cancelled_error);
    });
  t.set_interruption({});
  EXPECT_TRUE(IT::verify_Delaunay<Parallel_tag>(t).is_Delaunay());
}

TEST(Parallel_results, overlays_and_positions)
{
  for (const auto& [name, t] : surfaces()) {
    SCOPED_TRACE(name);
    const IT::Overlay expected(t);
    const IT::Overlay_positions expected_positions(IT::internal::engine(t), expected);
    for_each_number_of_threads([&, &t = t] {
      const IT::Common_subdivision subdivision = IT::make_common_subdivision<Parallel_tag>(t);
      expect_same_overlay(expected, subdivision.overlay());
      const IT::Overlay_positions& positions = subdivision.positions();
      for (IT::Overlay::Vertex x : expected.crossings()) {
        ASSERT_EQ(positions.on_input_edge(x), expected_positions.on_input_edge(x));
        ASSERT_EQ(positions.on_intrinsic_edge(x), expected_positions.on_intrinsic_edge(x));
      }
    });
  }
}

TEST(Parallel_results, weights_areas_and_matrices)
{
  for (const auto& [name, t] : surfaces()) {
    SCOPED_TRACE(name);
    const std::vector<double> weights = IT::cotangent_weights(t), areas = IT::face_areas(t),
                              cotangents = IT::cotangents(t);
    const IT::Element_numbers numbers = IT::element_numbers(t);
    const Matrix stiffness = IT::stiffness_matrix(t), lumped = IT::lumped_mass_matrix(t),
                 Galerkin = IT::Galerkin_mass_matrix(t);
    for_each_number_of_threads([&, &t = t] {
      EXPECT_TRUE(are_same(IT::cotangent_weights<Parallel_tag>(t), weights));
      EXPECT_TRUE(are_same(IT::face_areas<Parallel_tag>(t), areas));
      EXPECT_TRUE(are_same(IT::cotangents<Parallel_tag>(t), cotangents));
      const IT::Element_numbers parallel = IT::element_numbers<Parallel_tag>(t);
      EXPECT_TRUE(are_same(parallel.lengths, numbers.lengths));
      EXPECT_TRUE(are_same(parallel.areas, numbers.areas));
      EXPECT_TRUE(are_same(parallel.cotangent_weights, numbers.cotangent_weights));
      expect_same_matrix(stiffness, IT::stiffness_matrix<Parallel_tag>(t));
      expect_same_matrix(lumped, IT::lumped_mass_matrix<Parallel_tag>(t));
      expect_same_matrix(Galerkin, IT::Galerkin_mass_matrix<Parallel_tag>(t));
    });
  }
}

TEST(Parallel_results, rounded_numbers)
{
  auto t = triangulation<IT::Edge_length_traits<double>>(samples::bad_torus(120, 120));
  IT::flip_to_Delaunay(t);
  for_each_number_of_threads([&] {
    EXPECT_TRUE(are_same(IT::cotangent_weights<Parallel_tag>(t), IT::cotangent_weights(t)));
    EXPECT_TRUE(are_same(IT::face_areas<Parallel_tag>(t), IT::face_areas(t)));
    expect_same_matrix(IT::stiffness_matrix(t), IT::stiffness_matrix<Parallel_tag>(t));
  });
}

// Whichever thread finds them, the first face without area is named.
TEST(Parallel_results, the_first_bad_element_is_named)
{
  samples::Indexed_triangles s = samples::sheared_grid(150, 120, 0);
  for (std::array<std::uint32_t, 3> face : {s.triangles[20000], s.triangles[30000]}) {
    const std::array<double, 3> p = s.points[face[0]], q = s.points[face[1]];
    s.points[face[2]] = {(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2};
  }
  const auto element = [](const auto& function) {
    try {
      function();
    } catch (const IT::Invalid_surface_error& error) {
      EXPECT_EQ(error.defect(), IT::Invalid_surface_error::Defect::DEGENERATE_FACE);
      return error.element();
    }
    return std::size_t(0);
  };
  const auto expect = [&](const auto& t) {
    const std::size_t expected = element([&] { IT::cotangent_weights(t); });
    EXPECT_GT(expected, 10000u);
    for_each_number_of_threads([&] {
      EXPECT_EQ(element([&] { IT::cotangent_weights<Parallel_tag>(t); }), expected);
      EXPECT_EQ(element([&] { IT::stiffness_matrix<Parallel_tag>(t); }), expected);
    });
  };
  expect(triangulation(s));
  expect(triangulation<IT::Edge_length_traits<double>>(s));
}

TEST(Parallel_results, can_be_cancelled)
{
  const Filtered t = Delaunay(samples::bad_torus(100, 100));
  const IT::Overlay overlay(t);
  for (int calls : {0, 1, 2}) {
    int left = calls;
    const IT::Progress_function progress = [&left](double fraction) {
      EXPECT_TRUE(fraction >= 0 && fraction <= 1);
      return left-- > 0;
    };
    EXPECT_THROW(IT::make_overlay<Parallel_tag>(t, CGAL::parameters::visitor(progress)), IT::Cancelled_error);
  }
  EXPECT_THROW(IT::Overlay_positions(
                 IT::internal::engine(t), overlay, [](double) { return false; }, IT::internal::threads<Parallel_tag>()),
               IT::Cancelled_error);
}

} // namespace
