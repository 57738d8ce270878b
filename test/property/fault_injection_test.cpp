// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every operation is interrupted at each question that it asks, and at each of its allocations. Then the triangulation
// is checked exactly, and the operation continues.
//
// Allocations of GMP and MPFR never fail here, as these libraries would end the program. Nor do those of CGAL::Mpzf,
// which would free memory that it does not own.

#include "samples/sample_exact_gluings.h"
#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Delaunay_tessellation.h>
#include <CGAL/Intrinsic_triangulations/verify_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Geodesic_path_network.h>
#include <CGAL/Intrinsic_triangulations/Heat_method.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/geodesic_path.h>
#include <CGAL/Intrinsic_triangulations/insert_vertex.h>
#include "library/engine/history/Long_crossings.h"
#include "library/system/time_between_questions.h"
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/refine_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/trace_geodesic.h>
#include <CGAL/Intrinsic_triangulations/untwist.h>

#include <boost/config.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <limits>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

// ---------------------------------------------------------------- faults

enum class Fault {
  NONE,
  ANSWER,    // a question is answered by `false`
  EXCEPTION, // a question is answered by an exception
  MEMORY     // an allocation fails
};
constexpr const char* names_of_faults[] = {"none", "answer", "exception", "memory"};

struct Injected_error : std::runtime_error
{
  Injected_error() : std::runtime_error("injected") {}
};

std::atomic<Fault> fault{Fault::NONE};
std::atomic<std::int64_t> position{0}; // of the fault
std::atomic<std::int64_t> number_of_questions{0}, number_of_allocations{0};
std::atomic<bool> is_counting{false};

bool may_allocate()
{
  if (!is_counting.load(std::memory_order_relaxed))
    return true;
  const std::int64_t number = ++number_of_allocations;
  return !(fault.load(std::memory_order_relaxed) == Fault::MEMORY && number == position);
}

bool goes_further()
{
  const bool is_at_position = ++number_of_questions == position;
  if (fault == Fault::EXCEPTION && is_at_position)
    throw Injected_error();
  return !(fault == Fault::ANSWER && is_at_position);
}

// Faults happen while it lives.
class Fault_scope
{
public:
  Fault_scope(Fault kind, std::int64_t at)
  {
    fault = kind;
    position = at;
    number_of_questions = number_of_allocations = 0;
    is_counting = true;
  }
  Fault_scope(const Fault_scope&) = delete;
  Fault_scope& operator=(const Fault_scope&) = delete;
  ~Fault_scope() { is_counting = false; }
};

// Asks `goes_further()` at each opportunity, instead of a hundred times a second.
class Faults : public ::testing::Test
{
protected:
  void SetUp() override { IT::internal::time_between_questions = std::chrono::nanoseconds(0); }
  void TearDown() override
  {
    IT::internal::time_between_questions = std::chrono::milliseconds(10);
    std::cout << operations_ << " operations, " << points_ << " points of interruption, " << interruptions_
              << " interruptions by an exception, " << failures_ << " failures in total" << std::endl;
    RecordProperty("operations", operations_);
    RecordProperty("points", points_);
    RecordProperty("failures", failures_);
  }

  // Interrupts `run(state)` at each point, or, if there are more, at about `most` of each kind. `check(state, whole)`
  // is called after each, with the state after a run that was not interrupted. The operation ends with its first
  // failure.
  template <class Make, class Run, class Check>
  void sweep(const std::string& name, const Make& make, const Run& run, const Check& check)
  {
    const int points_before = points_, failures_before = failures_;
    ++operations_;
    interrupt_everywhere(name, make, run, check);
    std::cout << name << ": " << points_ - points_before << " points, " << failures_ - failures_before << " failures"
              << std::endl;
  }

  void set_most(std::int64_t most) { most_ = most; }

private:
  template <class Make, class Run, class Check>
  void interrupt_everywhere(const std::string& name, const Make& make, const Run& run, const Check& check)
  {
    auto whole = make();
    std::int64_t questions, allocations;
    {
      const Fault_scope scope(Fault::NONE, 0);
      run(whole);
      questions = number_of_questions;
      allocations = number_of_allocations;
    }
    for (Fault kind : {Fault::ANSWER, Fault::EXCEPTION, Fault::MEMORY}) {
      const std::int64_t n = kind == Fault::MEMORY ? allocations : questions,
                         step = (std::max)(std::int64_t(1), n / most_);
      for (std::int64_t k = 1; k <= n; k += step) {
        SCOPED_TRACE(name + ", " + names_of_faults[int(kind)] + " " + std::to_string(k) + " of " + std::to_string(n));
        auto state = make();
        ++points_;
        const int messages = number_of_messages();
        try {
          const Fault_scope scope(kind, k);
          run(state);
        } catch (const IT::Cancelled_error&) {
          ++interruptions_;
        } catch (const Injected_error&) {
          ++interruptions_;
        } catch (const std::bad_alloc&) {
          ++interruptions_;
        }
        fault = Fault::NONE;
        try {
          check(state, whole);
        } catch (const std::exception& error) {
          ADD_FAILURE() << error.what();
        }
        if (number_of_messages() != messages) {
          ++failures_;
          return;
        }
      }
    }
  }

  // of failures
  static int number_of_messages()
  {
    return ::testing::UnitTest::GetInstance()->current_test_info()->result()->total_part_count();
  }

  std::int64_t most_ = 25;
  int operations_ = 0, points_ = 0, interruptions_ = 0, failures_ = 0;
};

// ---------------------------------------------------------------- checks

Triangulation triangulation_of(const samples::Indexed_triangles& surface)
{
  return Triangulation(IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles), surface.points);
}
Triangulation triangulation_of(const samples::Glued_triangles& gluing)
{
  IT::Delta_complex complex = IT::make_Delta_complex_from_gluing(gluing.side_lengths.size() / 3, gluing.glued_sides);
  std::vector<double> lengths(complex.number_of_edges());
  for (IT::Face_index f : complex.faces()) {
    IT::Halfedge_index h = complex.halfedge(f);
    for (std::size_t i = 0; i < 3; ++i, h = complex.next(h))
      lengths[complex.edge(h).idx()] = gluing.side_lengths[3 * f.idx() + i];
  }
  return Triangulation::from_lengths(std::move(complex), std::move(lengths));
}

void expect_input(const Triangulation& t, const IT::Delta_complex& input)
{
  const IT::Delta_complex& recovered = t.input();
  ASSERT_EQ(recovered.number_of_edges(), input.number_of_edges());
  for (IT::Halfedge_index h : input.halfedges()) {
    ASSERT_EQ(recovered.next(h), input.next(h));
    ASSERT_EQ(recovered.target(h), input.target(h));
    ASSERT_EQ(recovered.face(h), input.face(h));
  }
}

// Connectivity and integers form a triangulation of the surface; stored numbers are as close to the exact ones as their
// bounds say, and their implications are right.
void expect_valid(Triangulation& t, const IT::Delta_complex& input)
{
  t.set_interruption({});
  const IT::Delta_complex& complex = t.connectivity();
  ASSERT_TRUE(complex.is_valid(true));
  expect_input(t, input);
  Triangulation afresh = t; // no memory of earlier decisions
  const IT::internal::Exact_engine& geometry = IT::internal::engine(afresh);
  const IT::internal::Whole_triangulation<IT::Filtered_edge_length_traits> whole(afresh);
  const auto number = [](const IT::internal::Bounded_double_double& x) { return x.hi(); };
  for (IT::Face_index f : complex.faces()) {
    ASSERT_NE(geometry.sign_of_area(f), CGAL::NEGATIVE) << "face " << f.idx();
    const IT::Halfedge_index h = complex.halfedge(f);
    const IT::internal::Exact_engine::Corner c = IT::internal::Engine_numbers(geometry).corner(h);
    const IT::Bounded_area stored = t.face_data(f);
    if (!(stored.error < std::numeric_limits<double>::infinity()))
      continue;
    const double sum = std::abs(t.edge_data(complex.edge(h)) - number(c.s_opposite)) +
                       std::abs(t.edge_data(complex.edge(complex.next(h))) - number(c.s_second)) +
                       std::abs(t.edge_data(complex.edge(complex.prev(h))) - number(c.s_first));
    ASSERT_LE(1.5 * sum, stored.error) << "sides of face " << f.idx();
    ASSERT_LE(1.5 * std::abs(stored.value - number(c.four_areas)), stored.error * (1 + 1e-9))
      << "area of face " << f.idx();
  }
  for (IT::Edge_index e : complex.edges())
    if (complex.is_flippable(e)) {
      const CGAL::Sign sign = geometry.test(e, IT::internal::Exact_engine::Means::UNFOLDING)->sign;
      ASSERT_EQ(t.sign_of_cotangent_weight(e), sign) << "edge " << e.idx();
      ASSERT_EQ(geometry.test(e)->sign, sign) << "edge " << e.idx();
      ASSERT_FALSE(whole.is_known_Delaunay(e) && sign == CGAL::NEGATIVE) << "edge " << e.idx();
    }
  const IT::Overlay overlay(complex, geometry.correspondence());
  std::int64_t crossings = 0;
  for (IT::Edge_index e : complex.edges())
    crossings += geometry.correspondence().coordinates().number_of_crossings(e);
  ASSERT_EQ(std::int64_t(overlay.number_of_crossings()), crossings);
}

// Nothing at all changes.
void expect_same(const Triangulation& t, const Triangulation& before)
{
  ASSERT_TRUE(t.connectivity() == before.connectivity());
  for (IT::Edge_index e : t.connectivity().edges()) {
    ASSERT_EQ(t.edge_data(e), before.edge_data(e));
    ASSERT_EQ(IT::internal::engine(t).correspondence().coordinates().crossings(e),
              IT::internal::engine(before).correspondence().coordinates().crossings(e));
    for (IT::Halfedge_index h : {t.connectivity().halfedge(e), t.connectivity().opposite(t.connectivity().halfedge(e))})
      ASSERT_EQ(IT::internal::engine(t).correspondence().input_halfedge(h),
                IT::internal::engine(before).correspondence().input_halfedge(h));
  }
  for (IT::Face_index f : t.connectivity().faces())
    ASSERT_EQ(t.face_data(f).value, before.face_data(f).value);
}

// The cells by their vertices, in an order of their own.
std::vector<std::vector<std::uint32_t>> cells(const Triangulation& t)
{
  const IT::Delaunay_tessellation tessellation(t);
  std::vector<std::vector<std::uint32_t>> result(tessellation.number_of_cells());
  for (IT::Halfedge_index h : t.connectivity().halfedges())
    if (!t.connectivity().is_border(h))
      result[tessellation.cell(t.connectivity().face(h))].push_back(t.connectivity().target(h).idx());
  for (std::vector<std::uint32_t>& cell : result) {
    std::sort(cell.begin(), cell.end());
    cell.erase(std::unique(cell.begin(), cell.end()), cell.end());
  }
  std::sort(result.begin(), result.end());
  return result;
}

void expect_Delaunay(Triangulation& t, const IT::Delta_complex& input)
{
  expect_valid(t, input);
  ASSERT_TRUE(IT::verify_Delaunay(t).is_Delaunay());
}

// ---------------------------------------------------------------- operations

struct Visitor : IT::Default_visitor
{
  bool go_further(const IT::Progress&) { return goes_further(); }
};

// Points inside faces, and on edges that are edges of the triangulation.
std::vector<IT::Surface_point> points_to_insert(const Triangulation& t, std::size_t number)
{
  const IT::internal::Exact_engine& geometry = IT::internal::engine(t);
  const IT::Delta_complex& input = geometry.correspondence().input();
  std::vector<IT::Surface_point> result;
  for (std::size_t i = 0; result.size() < number && i < input.number_of_faces(); ++i) {
    const IT::Face_index f(std::uint32_t(i * 7919 % input.number_of_faces()));
    if (geometry.metric().has_area(input, f))
      result.push_back({input.halfedge(f), {3, 2, 1 + double(i)}});
  }
  for (IT::Edge_index e : input.edges())
    if (result.size() < number + 2 && geometry.correspondence().coordinates().is_original(e) && input.is_flippable(e) &&
        t.connectivity().is_flippable(e))
      result.push_back({input.halfedge(e), {1, 2, 0}});
  return result;
}
void insert(Triangulation& t, const std::vector<IT::Surface_point>& points)
{
  for (const IT::Surface_point& p : points)
    try {
      IT::insert_vertex(t, p);
    } catch (const IT::Invalid_point_error&) {
    }
}
void remove_all(Triangulation& t)
{
  const std::size_t n = t.input().number_of_vertices();
  for (std::size_t v = t.connectivity().number_of_vertices(); v-- > n;)
    try {
      IT::remove_vertex(t, IT::Vertex_index(std::uint32_t(v)));
    } catch (const IT::Invalid_removal_error&) {
    }
}

class Operations : public Faults
{
protected:
  template <class Surface>
  void flips(const std::string& name, const Surface& surface)
  {
    const Triangulation start = triangulation_of(surface);
    const IT::Delta_complex input = start.connectivity();
    Triangulation asked = start;
    asked.length(IT::Edge_index(0));
    Triangulation Delaunay = start;
    IT::flip_to_Delaunay(Delaunay);
    const auto expected = cells(Delaunay);
    const auto check = [&](Triangulation& t, Triangulation&) {
      expect_valid(t, input);
      IT::flip_to_Delaunay(t);
      expect_Delaunay(t, input);
      EXPECT_TRUE(cells(t) == expected);
    };
    for (bool has_visitor : {false, true})
      sweep(
        name + ": flips" + (has_visitor ? " with a visitor" : ""), [&] { return start; },
        [&](Triangulation& t) {
          t.set_interruption(goes_further);
          if (has_visitor)
            IT::flip_to_Delaunay(t, CGAL::parameters::visitor(Visitor()));
          else
            IT::flip_to_Delaunay(t);
        },
        check);
    // One by one, from the triangulation and after a question.
    for (const Triangulation* from : {&start, &std::as_const(asked)})
      sweep(
        name + ": single flips" + (from == &asked ? " after a question" : ""), [&] { return *from; },
        [&](Triangulation& t) {
          t.set_interruption(goes_further);
          for (int round = 0; round < 3; ++round)
            for (IT::Edge_index e : t.connectivity().edges())
              if (t.connectivity().is_flippable(e) && !certainly(t.is_locally_Delaunay(e)))
                t.flip(e);
        },
        check);
  }

  template <class Surface>
  void vertices(const std::string& name, const Surface& surface, std::size_t number)
  {
    Triangulation start = triangulation_of(surface);
    const IT::Delta_complex input = start.connectivity();
    IT::flip_to_Delaunay(start);
    const std::vector<IT::Surface_point> points = points_to_insert(start, number);
    Triangulation inserted = start;
    insert(inserted, points);
    ASSERT_GT(inserted.connectivity().number_of_vertices(), input.number_of_vertices());
    sweep(
      name + ": insertions", [&] { return start; },
      [&](Triangulation& t) {
        t.set_interruption(goes_further);
        insert(t, points);
      },
      [&](Triangulation& t, Triangulation& whole) {
        expect_valid(t, input);
        IT::flip_to_Delaunay(t);
        insert(t, points);
        expect_Delaunay(t, input);
        EXPECT_EQ(t.connectivity().number_of_faces(), whole.connectivity().number_of_faces());
      });
    sweep(
      name + ": removals", [&] { return inserted; },
      [&](Triangulation& t) {
        t.set_interruption(goes_further);
        remove_all(t);
      },
      [&](Triangulation& t, Triangulation& whole) {
        expect_valid(t, input);
        IT::flip_to_Delaunay(t);
        remove_all(t);
        expect_Delaunay(t, input);
        if (whole.connectivity().number_of_vertices() == input.number_of_vertices() &&
            t.connectivity().number_of_vertices() == input.number_of_vertices()) {
          EXPECT_TRUE(cells(t) == cells(whole));
        }
      });
    // Splits and their reversal are strong: nothing at all is changed.
    const std::uint32_t n = start.connectivity().number_of_vertices();
    for (const IT::Surface_point& p : {points.front(), points.back()})
      sweep(
        name + ": a split", [&] { return start; },
        [&](Triangulation& t) {
          t.set_interruption(goes_further);
          const IT::internal::Exact_engine& engine = IT::internal::engine(t);
          IT::internal::Whole_triangulation<Triangulation::Traits> whole(t);
          if (p.dimension() == 2) {
            const IT::internal::Triangle_piece at =
              IT::internal::piece_at_source(t.connectivity(), engine.correspondence(), p.halfedge);
            whole.split_face(IT::internal::piece_of_point(engine, at, p), p);
          } else {
            whole.split_edge(*IT::internal::halfedge_along(engine, p), p);
          }
        },
        [&](Triangulation& t, Triangulation& whole) {
          expect_valid(t, input);
          expect_same(t, t.connectivity().number_of_vertices() == n ? start : whole);
        });
  }

  void refinement(const std::string& name, const samples::Indexed_triangles& surface)
  {
    const Triangulation start = triangulation_of(surface);
    const IT::Delta_complex input = start.connectivity();
    sweep(
      name + ": refinement", [&] { return start; },
      [&](Triangulation& t) { IT::refine_Delaunay(t, CGAL::parameters::visitor(Visitor()).maximum_number(40)); },
      [&](Triangulation& t, Triangulation&) {
        expect_valid(t, input);
        IT::refine_Delaunay(t, CGAL::parameters::maximum_number(10));
        expect_Delaunay(t, input);
      });
  }

  // Paths between far vertices, and closed curves around vertices, in a triangulation that was flipped before or not.
  void geodesics(const std::string& name, const samples::Indexed_triangles& surface)
  {
    using Network = IT::Geodesic_path_network<IT::Filtered_edge_length_traits>;
    struct State
    {
      explicit State(const Triangulation& t)
        : triangulation(std::make_unique<Triangulation>(t)), network(*triangulation)
      {}
      std::unique_ptr<Triangulation> triangulation;
      Network network;
    };
    const Triangulation start = triangulation_of(surface);
    const IT::Delta_complex& input = start.connectivity();
    const auto add_paths = [&](State& state) {
      const std::uint32_t n = input.number_of_vertices();
      state.network.add_path(IT::shortest_edge_path(start, IT::Vertex_index(0), IT::Vertex_index(n / 2)));
      for (std::uint32_t v : {n / 3, n - 1}) { // around a vertex
        std::vector<IT::Halfedge_index> curve;
        const IT::Halfedge_index first = input.opposite(input.halfedge(IT::Vertex_index(v)));
        IT::Halfedge_index h = first;
        do {
          if (input.is_border(h))
            break;
          curve.push_back(input.next(h));
          h = input.next_around_source(h);
        } while (h != first);
        if (h == first)
          state.network.add_closed_path(curve);
      }
    };
    const auto make = [&] {
      auto state = std::make_unique<State>(start);
      add_paths(*state);
      return state;
    };
    const auto length = [](const State& state) {
      double sum = 0;
      for (std::size_t p = 0; p < state.network.number_of_paths(); ++p)
        sum += state.network.length(p);
      return sum;
    };
    const double length_before = length(*make());
    // At first, and when the network was rewound in between: then it can still be rewound.
    for (const bool is_rewound : {false, true})
      sweep(
        name + ": geodesics" + (is_rewound ? " after others" : ""), make,
        [&](auto& state) {
          state->network.shorten(CGAL::parameters::visitor(Visitor()));
          if (!is_rewound)
            return;
          state->network.rewind();
          add_paths(*state);
          state->network.shorten(CGAL::parameters::visitor(Visitor()));
        },
        [&](auto& state, auto&) {
          expect_valid(*state->triangulation, input);
          const IT::Delta_complex& complex = state->triangulation->connectivity();
          for (std::size_t p = 0; p < state->network.number_of_paths(); ++p) {
            const auto halfedges = state->network.halfedges(p);
            for (std::size_t i = 1; i < halfedges.size(); ++i)
              ASSERT_EQ(complex.target(halfedges[i - 1]), complex.source(halfedges[i]));
          }
          EXPECT_LE(length(*state), length_before * (1 + 1e-12));
          const IT::Geodesic_status status = state->network.shorten().status;
          EXPECT_EQ(state->network.is_geodesic(),
                    status == IT::Geodesic_status::GEODESIC || status == IT::Geodesic_status::CONTRACTIBLE);
          expect_valid(*state->triangulation, input);
          state->network.rewind();
          expect_same(*state->triangulation, start);
        });

    Triangulation flipped = start;
    IT::flip_to_Delaunay(flipped);
    const double far = 3 * length_before;
    struct Traced
    {
      Triangulation triangulation;
      std::vector<double> lengths;
    };
    const auto trace = [&](Traced& traced) {
      traced.lengths.clear();
      traced.triangulation.set_interruption(goes_further);
      for (std::uint32_t f : {0u, input.number_of_faces() / 2}) {
        const IT::Surface_direction direction{{input.halfedge(IT::Face_index(f)), {1, 1, 1}}, {0.3, 0.1}};
        traced.lengths.push_back(
          IT::trace_geodesic(traced.triangulation, direction, far, CGAL::parameters::maximum_number(200)).length);
        traced.lengths.push_back(IT::trace_geodesic_in_triangulation(traced.triangulation, direction, far,
                                                                     CGAL::parameters::maximum_number(200))
                                   .length);
      }
    };
    sweep(
      name + ": lines",
      [&] {
        return Traced{flipped, {}};
      },
      trace,
      [&](Traced& traced, Traced& whole) {
        traced.triangulation.set_interruption({});
        trace(traced);
        EXPECT_EQ(traced.lengths, whole.lengths);
      });
  }

  void untwisting(const std::string& name, const IT::Exact_gluing& gluing)
  {
    struct State
    {
      IT::Delta_complex complex;
      std::vector<IT::Rational> squared_lengths;
      IT::Untwisting untwisting;
    };
    const State start{gluing.complex, gluing.squared_lengths, {}};
    const auto is_same = [](const State& a, const State& b) {
      return a.complex == b.complex && a.squared_lengths == b.squared_lengths;
    };
    sweep(
      name + ": untwisting", [&] { return start; },
      [](State& s) { s.untwisting = IT::untwist(s.complex, s.squared_lengths, CGAL::parameters::visitor(Visitor())); },
      [&](State& s, State& whole) {
        if (s.untwisting.crossings.number_of_edges() == 0) { // an exception
          EXPECT_TRUE(is_same(s, start));
        }
        IT::untwist(s.complex, s.squared_lengths);
        EXPECT_TRUE(is_same(s, whole));
      });
  }

  void heat(const std::string& name, const samples::Indexed_triangles& surface)
  {
    Triangulation t = triangulation_of(surface);
    IT::flip_to_Delaunay(t);
    const IT::Delta_complex input = triangulation_of(surface).connectivity();
    const auto distances = [&] {
      IT::Heat_method<> heat(t, CGAL::parameters::visitor(&goes_further));
      heat.add_source(IT::Vertex_index(0));
      return std::vector<double>(heat.distances());
    };
    struct State
    {
      std::vector<double> distances;
    };
    sweep(
      name + ": heat", [] { return State(); }, [&](State& s) { s.distances = distances(); },
      [&](State&, State& whole) {
        expect_Delaunay(t, input);
        EXPECT_EQ(distances(), whole.distances);
      });
  }

#ifdef CGAL_LINKED_WITH_TBB
  // In blocks, on several threads.
  void parallel_flips()
  {
    const Triangulation start = triangulation_of(samples::bad_torus(160, 150));
    const IT::Delta_complex input = start.connectivity();
    for (bool has_visitor : {false, true})
      sweep(
        std::string("parallel flips") + (has_visitor ? " with a visitor" : ""), [&] { return start; },
        [&](Triangulation& t) {
          t.set_interruption(goes_further);
          if (has_visitor)
            IT::flip_to_Delaunay<CGAL::Parallel_tag>(t, CGAL::parameters::visitor(Visitor()));
          else
            IT::flip_to_Delaunay<CGAL::Parallel_tag>(t);
        },
        [&](Triangulation& t, Triangulation& whole) {
          t.set_interruption({});
          IT::flip_to_Delaunay(t);
          ASSERT_TRUE(t.connectivity().is_valid(true));
          ASSERT_TRUE(IT::verify_Delaunay(t).is_Delaunay());
          expect_input(t, input);
          EXPECT_TRUE(cells(t) == cells(whole));
        });
  }
#endif

  void all(bool is_large)
  {
    const std::size_t factor = is_large ? 3 : 1;
    flips("prism", samples::prism(16 * factor));
    flips("cap", samples::cap());
    flips("pillow", samples::pillow(20 * factor));
    flips("helical tube", samples::helical_tube(20 * factor));
    flips("torus with one vertex", samples::sheared_one_vertex_torus(double(100 * factor)));
    flips("gluing", samples::random_gluing(12 * factor, 5));
    vertices("prism", samples::prism(12 * factor), 3 * factor);
    vertices("pillow", samples::pillow(24 * factor), 3 * factor);
    vertices("sheared grid", samples::sheared_grid(6 * factor, 5, 3), 3 * factor);
    vertices("torus with one vertex", samples::sheared_one_vertex_torus(double(100 * factor)), 2);
    refinement("pillow", samples::pillow(16 * factor));
    refinement("dome", samples::bumpy_dome(6 * factor, 5));
    geodesics("helical tube", samples::helical_tube(24 * factor));
    geodesics("torus", samples::bad_torus(6 * factor, 6));
    geodesics("pillow", samples::pillow(16 * factor));
    untwisting("Fibonacci torus", samples::Fibonacci_torus(20 * factor));
    untwisting("genus two", samples::sheared_genus_two(1000, 12345));
    heat("torus", samples::bad_torus(6 * factor, 6));
#ifdef CGAL_LINKED_WITH_TBB
    if (is_large)
      parallel_flips();
#endif
  }
};

TEST_F(Operations, at_some_points)
{
  set_most(3);
  all(false);
}

#ifdef CGAL_LINKED_WITH_TBB
TEST_F(Operations, on_several_threads)
{
  set_most(1);
  parallel_flips();
}
#endif

// Caches are not kept if memory is short; queries work without them.
TEST(Long_crossings, do_without_memory)
{
  Triangulation t = triangulation_of(samples::pillow(40));
  IT::flip_to_Delaunay(t);
  const auto keep = [&](Fault kind, std::int64_t at) {
    const Triangulation copy = t; // without caches
    const auto& engine = IT::internal::engine(copy);
    IT::internal::Long_crossings all(engine.connectivity(), engine.correspondence(), engine.decisions().interruption);
    {
      const Fault_scope scope(kind, at);
      all.keep();
    }
    return !engine.correspondence().kept_crossings().is_empty();
  };
  ASSERT_TRUE(keep(Fault::NONE, 0));
  std::int64_t not_kept = 0;
  const std::int64_t n = number_of_allocations;
  for (std::int64_t k = 1; k <= n; ++k)
    if (!keep(Fault::MEMORY, k))
      ++not_kept;
  EXPECT_GT(not_kept, 1);
}

// These take many minutes: `scripts/test --all` runs them.
TEST_F(Operations, DISABLED_at_all_points_of_small_surfaces)
{
  set_most(std::numeric_limits<std::int64_t>::max());
  all(false);
}

TEST_F(Operations, DISABLED_at_many_points_of_larger_surfaces)
{
  set_most(300);
  all(true);
}

} // namespace

// ---------------------------------------------------------------- memory

// If GCC inlines them, it warns of mismatched pairs.
BOOST_NOINLINE void* operator new(std::size_t size)
{
  if (void* const p = may_allocate() ? std::malloc(size != 0 ? size : 1) : nullptr)
    return p;
  throw std::bad_alloc();
}
BOOST_NOINLINE void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
  return may_allocate() ? std::malloc(size != 0 ? size : 1) : nullptr;
}
BOOST_NOINLINE void* operator new[](std::size_t size, const std::nothrow_t& none) noexcept
{
  return operator new(size, none);
}
// The numbers of CGAL::Mpzf, and hardly anything else.
BOOST_NOINLINE void* operator new[](std::size_t size)
{
  if (void* const p = std::malloc(size != 0 ? size : 1))
    return p;
  throw std::bad_alloc();
}
BOOST_NOINLINE void operator delete[](void* p) noexcept { std::free(p); }
BOOST_NOINLINE void operator delete[](void* p, std::size_t) noexcept { std::free(p); }
BOOST_NOINLINE void operator delete(void* p) noexcept { std::free(p); }
BOOST_NOINLINE void operator delete(void* p, std::size_t) noexcept { std::free(p); }
