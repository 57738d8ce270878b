// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Eight threads query one const triangulation at once, and get the answers of a single thread.

#include "insert_random_vertices.h"
#include "reference/length_interval.h"
#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/Point_location.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include "library/engine/history/Flip_log.h"
#include "library/system/Scratch_pool.h"
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/verify_Delaunay.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

constexpr std::size_t number_of_threads = 8;

struct Named_triangulation
{
  std::string name;
  Triangulation triangulation;
};

Triangulation make(const samples::Indexed_triangles& surface, bool is_Delaunay)
{
  Triangulation t(IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles), surface.points);
  if (is_Delaunay)
    IT::flip_to_Delaunay(t);
  return t;
}

// Few and many flips, ties in space and over strips, faces without area, and lengths alone.
std::vector<Named_triangulation> triangulations()
{
  std::vector<Named_triangulation> result;
  result.push_back({"bumpy sphere", make(samples::bumpy_sphere(12, 20), true)});
  result.push_back({"bad torus, as it came", make(samples::bad_torus(10, 12), false)});
  result.push_back({"bad torus", make(samples::bad_torus(10, 12), true)});
  result.push_back({"pillow", make(samples::pillow(16), true)});
  result.push_back({"prism", make(samples::prism(20, 3), true)});
  result.push_back({"grid", make(samples::random_diagonal_grid(9, 9, 1), false)});
  result.push_back({"cap", make(samples::cap(0), true)});
  const Triangulation source = make(samples::bad_torus(8, 9), false);
  std::vector<double> lengths;
  for (IT::Edge_index e : source.connectivity().edges())
    lengths.push_back(source.length(e));
  Triangulation t = Triangulation::from_lengths(source.connectivity(), lengths);
  IT::flip_to_Delaunay(t);
  result.push_back({"lengths", std::move(t)});
  return result;
}

// All queries, beginning with a different edge in each thread.
std::vector<double> answers(const Triangulation& t, const IT::Point_location* location, std::size_t thread)
{
  const IT::Delta_complex& complex = t.connectivity();
  const IT::internal::Exact_engine& geometry = IT::internal::engine(t);
  std::vector<std::vector<double>> of_edge(complex.number_of_edges()), of_face(complex.number_of_faces());
  for (std::size_t i = 0; i < of_edge.size(); ++i) {
    const std::size_t number = (i + thread * of_edge.size() / number_of_threads) % of_edge.size();
    const IT::Edge_index e{IT::Edge_index::size_type(number)};
    std::vector<double>& a = of_edge[number];
    a = {t.length(e), double(t.squared_length(e)), length_interval(t, e).inf(), double(geometry.has_length_zero(e)),
         double(geometry.correspondence().coordinates().crossings(e))};
    if (!complex.is_flippable(e))
      continue;
    a.push_back(CGAL::certainly(t.is_locally_Delaunay(e)));
    a.push_back(t.sign_of_cotangent_weight(e));
    a.push_back(geometry.is_convex(e));
    using Means = IT::internal::Exact_engine::Means;
    for (const Means means : {Means::ALL, Means::UNFOLDING})
      a.push_back(geometry.test(e, means)->sign);
    for (const auto& test : {geometry.test(e, Means::PLANES), geometry.test(e, Means::SHORT_STRIPS)})
      a.push_back(test ? 10 * double(std::size_t(test->stage)) + test->sign : -1);
    const IT::Halfedge_index h = complex.halfedge(e);
    if (geometry.sign_of_area(complex.face(h)) == CGAL::POSITIVE &&
        geometry.sign_of_area(complex.face(complex.opposite(h))) == CGAL::POSITIVE) {
      a.push_back(t.cotangent(h));
      a.push_back(t.cotangent_weight(e));
    }
  }
  for (std::size_t i = 0; i < of_face.size(); ++i) {
    const std::size_t number = (i + thread * of_face.size() / number_of_threads) % of_face.size();
    const IT::Face_index f{IT::Face_index::size_type(number)};
    of_face[number] = {t.area(f)};
    if (location == nullptr)
      continue;
    const IT::Surface_point point{complex.halfedge(f), {0.25, 0.5, 0.25}};
    for (const IT::Surface_point& p : {location->input_to_intrinsic(point), location->intrinsic_to_input(point)}) {
      of_face[number].push_back(double(p.halfedge.idx()));
      of_face[number].insert(of_face[number].end(), p.coordinates.begin(), p.coordinates.end());
    }
  }
  std::vector<double> result;
  for (const auto* lists : {&of_edge, &of_face})
    for (const std::vector<double>& list : *lists)
      result.insert(result.end(), list.begin(), list.end());
  return result;
}

std::vector<double> positions(const Triangulation& t)
{
  const IT::Common_subdivision subdivision(t);
  const IT::Overlay_positions& positions = subdivision.positions();
  std::vector<double> result;
  for (IT::Edge_index e : t.connectivity().edges())
    for (IT::Overlay::Vertex x : subdivision.overlay().intrinsic_crossings(e))
      result.insert(result.end(), {positions.on_intrinsic_edge(x), positions.on_input_edge(x)});
  return result;
}

// Lets all threads begin at once.
template <class Work>
void run(const Work& work, std::size_t number = number_of_threads)
{
  std::atomic<std::size_t> number_of_ready{0};
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < number; ++i)
    threads.emplace_back([&, i] {
      ++number_of_ready;
      while (number_of_ready < number)
        std::this_thread::yield();
      work(i);
    });
  for (std::thread& thread : threads)
    thread.join();
}

TEST(Const_queries, eight_threads_hear_what_one_hears)
{
  for (const Named_triangulation& named : triangulations()) {
    SCOPED_TRACE(named.name);
    // Before any query, so that the threads also meet where the integers are computed.
    const Triangulation& asked_by_all = named.triangulation;
    const Triangulation asked_by_one = asked_by_all;
    const IT::Common_subdivision subdivision_for_one(asked_by_one);
    const IT::Point_location location(subdivision_for_one);
    const std::vector<double> expected = answers(asked_by_one, &location, 0),
                              expected_positions = positions(asked_by_one);
    EXPECT_GT(expected.size(), 5 * asked_by_one.connectivity().number_of_edges());

    std::array<std::vector<double>, number_of_threads> alone, together, on_edges;
    std::array<std::size_t, number_of_threads> ties{};
    run([&](std::size_t i) { alone[i] = answers(asked_by_all, nullptr, i); });
    const IT::Common_subdivision subdivision_for_all(asked_by_all);
    const IT::Point_location location_for_all(subdivision_for_all);
    run([&](std::size_t i) {
      together[i] = answers(asked_by_all, &location_for_all, i);
      on_edges[i] = positions(asked_by_all);
      ties[i] = IT::verify_Delaunay(asked_by_all).ties;
    });
    for (std::size_t i = 0; i < number_of_threads; ++i) {
      EXPECT_EQ(alone[i], alone[0]);
      EXPECT_EQ(together[i], expected);
      EXPECT_EQ(on_edges[i], expected_positions);
      EXPECT_EQ(ties[i], IT::verify_Delaunay(asked_by_one).ties);
    }
  }
}

TEST(Const_queries, sixty_four_threads_and_ten_thousand_short_ones)
{
  const Triangulation t = make(samples::prism(20, 3), true);
  const std::vector<double> expected = answers(Triangulation(t), nullptr, 0);
  std::array<std::vector<double>, 64> found;
  run([&](std::size_t i) { found[i] = answers(t, nullptr, i % number_of_threads); }, found.size());
  for (const std::vector<double>& answer : found)
    EXPECT_EQ(answer, expected);
  for (std::size_t i = 0; i < 10000; ++i) {
    const IT::Edge_index e(IT::Edge_index::size_type(i % t.connectivity().number_of_edges()));
    double length = 0;
    std::thread([&] { length = t.length(e); }).join();
    ASSERT_EQ(length, t.length(e));
  }
}

// Only as many objects are made as are in use at once, however many threads there are.
TEST(Scratch_pool, no_more_objects_than_in_use_at_once)
{
  IT::internal::Scratch_pool<int> pool;
  std::atomic<std::size_t> number_made{0};
  const auto take = [&] { return pool.take([&] { return new int(int(++number_made)); }); };
  for (int i = 0; i < 10000; ++i)
    std::thread([&] { ++*take(); }).join();
  EXPECT_EQ(number_made, 1u);
  EXPECT_EQ(*take(), 10001);
  for (int round = 0; round < 20; ++round)
    run(
      [&](std::size_t) {
        for (int i = 0; i < 100; ++i)
          ++*take();
      },
      64);
  EXPECT_LE(number_made, 64u);
  EXPECT_EQ(number_made, pool.size());
  std::vector<IT::internal::Scratch_pool<int>::Lease> leases;
  for (int i = 0; i < 200; ++i)
    leases.push_back(take());
  EXPECT_EQ(number_made, 200u);
  std::vector<const int*> objects;
  for (const auto& lease : leases)
    objects.push_back(&*lease);
  std::sort(objects.begin(), objects.end());
  EXPECT_EQ(std::unique(objects.begin(), objects.end()), objects.end());
  leases.clear();
  for (int i = 0; i < 200; ++i)
    leases.push_back(take());
  EXPECT_EQ(number_made, 200u);
}

// The same flips, logged until occasional queries read them, and followed one by one.
TEST(Const_queries, logs_and_flips_one_by_one_lead_to_the_same)
{
  using Whole = IT::internal::Whole_triangulation<IT::Filtered_edge_length_traits>;
  for (const Named_triangulation& named : triangulations())
    for (bool has_inserted_vertices : {false, true}) {
      SCOPED_TRACE(named.name);
      Triangulation logged = named.triangulation;
      std::mt19937 random(3);
      if (has_inserted_vertices)
        IT::insert_random_vertices(logged, 10, 5, random);
      Triangulation followed = logged;
      const IT::Delta_complex& complex = logged.connectivity();
      for (int round = 0; round < 6; ++round) {
        Whole(logged).engine().begin_log();
        for (int i = 0; i < 40 * round; ++i) {
          const IT::Edge_index e(std::uint32_t(random() % complex.number_of_edges()));
          if (!complex.is_flippable(e))
            continue;
          IT::internal::engine(followed).test(e);
          const auto outcome = followed.flip(e);
          if (outcome == Triangulation::Flip_outcome::FLIPPED) {
            if (Whole(logged).flip_not_Delaunay(e) != outcome)
              ADD_FAILURE();
          }
        }
        ASSERT_TRUE(complex == followed.connectivity());
        if (round % 2 == 0)
          logged.length(IT::Edge_index(0));
        if (round % 3 == 2)
          IT::flip_to_Delaunay(logged), IT::flip_to_Delaunay(followed);
        for (Triangulation* t : {&logged, &followed}) // stored numbers depend on the flips
          for (IT::Face_index f : complex.faces())
            Whole(*t).recompute(f);
        ASSERT_EQ(answers(logged, nullptr, 0), answers(followed, nullptr, 0));
        const IT::internal::Correspondence &a = IT::internal::engine(logged).correspondence(),
                                           &b = IT::internal::engine(followed).correspondence();
        for (IT::Halfedge_index h : complex.halfedges())
          ASSERT_EQ(a.input_halfedge(h), b.input_halfedge(h));
      }
    }
}

// A loop of the caller's own threads, one for each block.
void run_blocks(std::size_t n, std::size_t size, const std::function<void(std::size_t, std::size_t)>& f)
{
  std::vector<std::thread> threads;
  for (std::size_t first = 0; first < n; first += size)
    threads.emplace_back(f, first, std::min(first + size, n));
  for (std::thread& thread : threads)
    thread.join();
}

TEST(Const_queries, the_integers_are_computed_while_the_input_is_recovered)
{
  for (const Named_triangulation& named : triangulations()) {
    SCOPED_TRACE(named.name);
    const Triangulation& t = named.triangulation;
    IT::internal::Correspondence one, two;
    IT::internal::Flip_log log;
    IT::Delta_complex complex = t.input();
    for (int repeats = 0; repeats < 3; ++repeats)
      for (IT::Edge_index e : complex.edges()) {
        if (!complex.is_flippable(e))
          continue;
        log.push_back(complex.hinge(e));
        complex.flip(e);
      }
    one.catch_up(complex, log);
    two.catch_up(complex, log, run_blocks);
    EXPECT_TRUE(two.knows_input());
    for (IT::Halfedge_index h : complex.halfedges()) {
      ASSERT_EQ(one.input().next(h), two.input().next(h));
      ASSERT_EQ(one.input().target(h), two.input().target(h));
      ASSERT_EQ(one.input_halfedge(h), two.input_halfedge(h));
      ASSERT_EQ(one.coordinates().crossings(complex.edge(h)), two.coordinates().crossings(complex.edge(h)));
    }
  }
}

TEST(Const_queries, copies_are_made_while_others_ask)
{
  const Triangulation t = make(samples::bad_torus(12, 14), true);
  const std::vector<double> expected = answers(Triangulation(t), nullptr, 0);
  std::array<std::vector<double>, number_of_threads> found;
  run([&](std::size_t i) { found[i] = i % 2 == 0 ? answers(t, nullptr, i) : answers(Triangulation(t), nullptr, i); });
  for (const std::vector<double>& answer : found)
    EXPECT_EQ(answer, expected);
}

} // namespace
