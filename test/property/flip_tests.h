// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The flip algorithm with the number type Number_type: its result, its invariants, and how it ends if the number type
// cannot get there.

#include "property/flip_test_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Half_angle_traits.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>

#include <CGAL/Uncertain.h>
#include <CGAL/number_utils.h>

#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace flip_tests {

using namespace test_surfaces;
using CGAL::parameters::edge_is_constrained_map;
using CGAL::parameters::maximum_number;
using CGAL::parameters::visitor;
using IT::Flip_report;
using IT::Flip_status;

// Exact numbers grow with every flip: their surfaces are small, and without ties, since a
// proof of zero takes them too long.
constexpr bool is_exact = CGAL::Algebraic_structure_traits<Number_type>::Is_exact::value;
constexpr bool is_float = std::is_same<Number_type, float>::value;
constexpr bool is_interval = std::is_same<IT::Edge_length_traits<Number_type>::Boolean, CGAL::Uncertain<bool>>::value;
constexpr double tolerance = is_float ? 1e-3 : is_interval ? 1e-6 : 1e-9; // of an interval, the middle

// Remembers the flips and checks all calls.
struct Recorder
{
  bool go_further(const IT::Progress& progress)
  {
    EXPECT_EQ(progress.tests + progress.flips, calls); // before each of both
    EXPECT_EQ(progress.flips, flips.size());
    last = progress;
    return ++calls <= limit;
  }
  void after_flip(IT::Edge_index e) { flips.push_back(e); }

  std::uint64_t limit = (std::numeric_limits<std::uint64_t>::max)();
  std::uint64_t calls = 0;
  IT::Progress last;
  std::vector<IT::Edge_index> flips;
};

inline void expect_close(const Number_type& x, const Number_type& expected)
{
  if constexpr (is_interval)
    EXPECT_TRUE(CGAL::possibly(x == expected)) << x << " " << expected;
  else
    EXPECT_NEAR(CGAL::to_double(x), CGAL::to_double(expected), 10 * tolerance * CGAL::to_double(expected));
}

inline void expect_equal(const Invariants& a, const Invariants& b)
{
  EXPECT_EQ(a.euler_characteristic, b.euler_characteristic);
  EXPECT_EQ(a.border_halfedges, b.border_halfedges);
  EXPECT_NEAR(a.area, b.area, tolerance * b.area);
  ASSERT_EQ(a.cone_angles.size(), b.cone_angles.size());
  for (std::size_t v = 0; v < a.cone_angles.size(); ++v)
    EXPECT_NEAR(a.cone_angles[v], b.cone_angles[v], tolerance * b.cone_angles[v]) << "vertex " << v;
}

// Whether the report is right about the triangulation.
template <class Triangulation>
void expect_truth(const Flip_report& report, const Triangulation& t)
{
  EXPECT_TRUE(t.connectivity().is_valid(true));
  for (IT::Edge_index e : report.not_flippable)
    EXPECT_FALSE(CGAL::possibly(t.is_locally_Delaunay(e)));
  for (IT::Edge_index e : report.inconsistent)
    EXPECT_FALSE(CGAL::possibly(t.is_locally_Delaunay(e)));
  for (IT::Edge_index e : report.undecided)
    EXPECT_FALSE(CGAL::certainly(t.is_locally_Delaunay(e)));
  if (report.status == Flip_status::BUDGET_EXHAUSTED)
    return;
  EXPECT_EQ(report.status, !report.undecided.empty()       ? Flip_status::UNDECIDED
                           : !report.not_flippable.empty() ? Flip_status::NOT_FLIPPABLE
                           : !report.inconsistent.empty()  ? Flip_status::INCONSISTENT
                                                           : Flip_status::DELAUNAY);
  // Each edge that is not Delaunay is named.
  std::vector<IT::Edge_index> expected, named;
  for (IT::Edge_index e : t.connectivity().edges())
    if (!CGAL::certainly(t.is_locally_Delaunay(e)))
      expected.push_back(e);
  for (const auto* list : {&report.not_flippable, &report.inconsistent, &report.undecided})
    named.insert(named.end(), list->begin(), list->end());
  std::sort(named.begin(), named.end());
  EXPECT_EQ(named, expected);
}

template <class Traits>
class Flip : public testing::Test
{
protected:
  using Triangulation = IT::Intrinsic_triangulation<Traits>;

  template <class Check>
  void for_each_generic_surface(const Check& check)
  {
    for (const Surface& surface : generic_surfaces(is_exact)) {
      SCOPED_TRACE(surface.name);
      check(surface, triangulation<Traits>(surface));
      if (this->HasFatalFailure())
        return;
    }
  }
};

using All_traits = testing::Types<IT::Edge_length_traits<Number_type>, IT::Half_angle_traits<Number_type>>;

struct Traits_names
{
  template <class Traits>
  static std::string GetName(int)
  {
    return std::is_same<Traits, IT::Half_angle_traits<Number_type>>::value ? "Half_angle" : "Edge_length";
  }
};
TYPED_TEST_SUITE(Flip, All_traits, Traits_names);

TYPED_TEST(Flip, makes_generic_surfaces_Delaunay_and_keeps_what_is_intrinsic)
{
  std::uint64_t flips = 0;
  this->for_each_generic_surface([&](const Surface& surface, auto t) {
    const Invariants before = invariants(t);
    Recorder recorder;
    const Flip_report report = IT::flip_to_Delaunay(t, visitor(std::ref(recorder)));
    EXPECT_EQ(report.status, Flip_status::DELAUNAY);
    EXPECT_EQ(report.flips, recorder.flips.size());
    EXPECT_EQ(report.tests + report.flips, recorder.calls);
    expect_truth(report, t);
    expect_equal(invariants(t), before);
    flips += report.flips;

    // Three more flips of each edge, the last one first, lead back.
    IT::Delta_complex c = t.connectivity();
    for (std::size_t i = recorder.flips.size(); i-- > 0;)
      for (int turn = 0; turn < 3; ++turn)
        c.flip(recorder.flips[i]);
    EXPECT_TRUE(are_same_links(c, surface.connectivity));
    const Flip_report again = IT::flip_to_Delaunay(t);
    EXPECT_EQ(again.flips, 0u);
    EXPECT_LE(again.tests, t.connectivity().number_of_edges());
  });
  EXPECT_GT(flips, is_exact ? 50u : 400u);
}

// Exact decisions are the reference for each number type.
TYPED_TEST(Flip, agrees_with_exact_decisions_on_generic_surfaces)
{
  this->for_each_generic_surface([&](const Surface& surface, auto t) {
    auto exact = triangulation<IT::Filtered_edge_length_traits>(surface);
    const Flip_report expected = IT::flip_to_Delaunay(exact);
    const Flip_report report = IT::flip_to_Delaunay(t);
    EXPECT_EQ(report.flips, expected.flips);
    EXPECT_EQ(report.tests, expected.tests);
    EXPECT_TRUE(t.connectivity() == exact.connectivity());
    EXPECT_TRUE(are_same_edges(edge_records(t), edge_records(exact), tolerance));
  });
}

TYPED_TEST(Flip, four_times_is_the_identity)
{
  using Outcome = typename TestFixture::Triangulation::Flip_outcome;
  int flipped = 0;
  this->for_each_generic_surface([&](const Surface& surface, auto t) {
    const Invariants before = invariants(t);
    for (IT::Edge_index e : t.connectivity().edges()) {
      if (!t.connectivity().is_flippable(e))
        continue;
      const IT::Halfedge_index h = t.connectivity().halfedge(e);
      const std::array<IT::Face_index, 2> faces{t.connectivity().face(h),
                                                t.connectivity().face(t.connectivity().opposite(h))};
      auto turned = t;
      if (turned.flip(e) != Outcome::FLIPPED)
        continue;
      // If a face nearly vanishes, rounding decides whether the reverse flip exists.
      const auto areas = std::minmax({CGAL::to_double(turned.area(faces[0])), CGAL::to_double(turned.area(faces[1]))});
      if (areas.first < 1e-2 * areas.second)
        continue;
      ++flipped;
      const auto diagonal = turned.length(e);
      expect_equal(invariants(turned), before);
      for (const auto& expected : {t.length(e), diagonal, t.length(e)}) {
        ASSERT_EQ(turned.flip(e), Outcome::FLIPPED);
        expect_close(turned.length(e), expected);
      }
      EXPECT_TRUE(are_same_links(turned.connectivity(), surface.connectivity));
      for (IT::Face_index f : faces)
        expect_close(turned.area(f), t.area(f));
    }
  });
  EXPECT_GT(flipped, 100);
}

TYPED_TEST(Flip, leaves_constrained_edges_alone)
{
  std::size_t number_of_constraints = 0;
  this->for_each_generic_surface([&](const Surface&, auto t) {
    const IT::Delta_complex& c = t.connectivity();
    // Every other edge that the algorithm would flip, and some that it would not.
    std::vector<char> is_constrained(c.number_of_edges(), 0);
    bool is_next = true;
    for (IT::Edge_index e : c.edges())
      if (CGAL::certainly(t.is_locally_Delaunay(e)))
        is_constrained[e.idx()] = e.idx() % 7 == 0;
      else {
        is_constrained[e.idx()] = is_next;
        number_of_constraints += is_next;
        is_next = !is_next;
      }
    const auto map =
      boost::make_function_property_map<IT::Edge_index>([&](IT::Edge_index e) { return is_constrained[e.idx()] != 0; });
    const auto unflipped = t;
    Recorder recorder;
    const Flip_report report = IT::flip_to_Delaunay(t, visitor(std::ref(recorder)).edge_is_constrained_map(map));
    EXPECT_EQ(report.status, Flip_status::DELAUNAY);
    for (IT::Edge_index e : recorder.flips)
      EXPECT_FALSE(is_constrained[e.idx()]);
    for (IT::Edge_index e : c.edges())
      if (!is_constrained[e.idx()]) {
        EXPECT_TRUE(CGAL::certainly(t.is_locally_Delaunay(e)));
      } else {
        EXPECT_EQ(CGAL::to_double(t.length(e)), CGAL::to_double(unflipped.length(e)));
        EXPECT_EQ(c.source(c.halfedge(e)), unflipped.connectivity().source(c.halfedge(e)));
        EXPECT_EQ(c.target(c.halfedge(e)), unflipped.connectivity().target(c.halfedge(e)));
      }
    expect_equal(invariants(t), invariants(unflipped));
  });
  EXPECT_GT(number_of_constraints, is_exact ? 20u : 150u);
}

TYPED_TEST(Flip, stops_when_the_visitor_cancels_and_can_be_resumed)
{
  this->for_each_generic_surface([&](const Surface& surface, auto t) {
    auto finished = t;
    const Flip_report complete = IT::flip_to_Delaunay(finished);
    const std::uint64_t steps = complete.tests + complete.flips;
    for (std::uint64_t limit : {std::uint64_t(0), steps / 2, steps}) {
      auto cancelled = t;
      Recorder recorder;
      recorder.limit = limit;
      if (limit < steps) {
        EXPECT_THROW(IT::flip_to_Delaunay(cancelled, visitor(std::ref(recorder))), IT::Cancelled_error);
        EXPECT_EQ(recorder.last.tests + recorder.last.flips, limit);
        EXPECT_TRUE(cancelled.connectivity().is_valid(true));
      } else {
        const Flip_report report = IT::flip_to_Delaunay(cancelled, visitor(std::ref(recorder)));
        EXPECT_EQ(report.status, Flip_status::DELAUNAY);
        EXPECT_EQ(report.tests + report.flips, limit);
        EXPECT_EQ(report.flips, recorder.flips.size());
        expect_truth(report, cancelled);
      }
      const Flip_report rest = IT::flip_to_Delaunay(cancelled);
      EXPECT_EQ(rest.status, Flip_status::DELAUNAY);
      EXPECT_TRUE(are_same_edges(edge_records(cancelled), edge_records(finished), tolerance)) << surface.name;
    }
  });
}

TYPED_TEST(Flip, stops_when_the_budget_is_spent)
{
  this->for_each_generic_surface([&](const Surface&, auto t) {
    auto finished = t;
    const std::uint64_t flips = IT::flip_to_Delaunay(finished).flips;
    if (flips == 0)
      return;
    for (std::uint64_t budget : {std::uint64_t(0), flips / 2, flips - 1, flips}) {
      auto stopped = t;
      const Flip_report report = IT::flip_to_Delaunay(stopped, maximum_number(budget));
      EXPECT_EQ(report.status, budget < flips ? Flip_status::BUDGET_EXHAUSTED : Flip_status::DELAUNAY);
      EXPECT_EQ(report.flips, budget);
      expect_truth(report, stopped);
    }
  });
}

// Traits for which no hinge has another diagonal, or for which this is uncertain.
template <class Base, bool is_certain>
struct Traits_without_flips : Base
{
  struct Construct_flipped_hinge
  {
    typename Base::Boolean operator()(const typename Base::Hinge_data&, typename Base::Flipped_hinge_data&) const
    {
      if constexpr (is_certain)
        return false;
      else
        return CGAL::Uncertain<bool>::indeterminate();
    }
  };
  Construct_flipped_hinge construct_flipped_hinge_object() const { return {}; }
};

TYPED_TEST(Flip, reports_edges_that_have_no_other_diagonal)
{
  using Traits = Traits_without_flips<TypeParam, true>;
  const Surface surface = generic_surfaces(true)[1];
  auto t = triangulation<Traits>(surface);
  const Flip_report report = IT::flip_to_Delaunay(t);
  EXPECT_EQ(report.status, Flip_status::NOT_FLIPPABLE);
  EXPECT_EQ(report.flips, 0u);
  EXPECT_TRUE(report.undecided.empty());
  expect_truth(report, t);
  std::size_t number_of_bad_edges = 0;
  for (IT::Edge_index e : t.connectivity().edges())
    number_of_bad_edges += !CGAL::possibly(t.is_locally_Delaunay(e));
  EXPECT_EQ(report.not_flippable.size(), number_of_bad_edges);
  EXPECT_TRUE(t.connectivity() == surface.connectivity);

  if constexpr (is_interval) {
    auto uncertain = triangulation<Traits_without_flips<TypeParam, false>>(surface);
    const Flip_report undecided = IT::flip_to_Delaunay(uncertain);
    EXPECT_EQ(undecided.status, Flip_status::UNDECIDED);
    EXPECT_EQ(undecided.undecided.size(), number_of_bad_edges);
    expect_truth(undecided, uncertain);
  }
}

// Ties, some of which rounding has broken: an interval cannot decide them, and rounded
// decisions may contradict each other. Whatever happens, the run ends and says so.
TYPED_TEST(Flip, ends_on_ties)
{
  std::vector<Surface> surfaces{from_triangles("grid", samples::random_diagonal_grid(2, 2)),
                                from_triangles("sheared grid", samples::sheared_grid(2, 2, 1))};
  if (!is_exact) // the proofs of zero take too long
    for (const Surface& surface :
         {from_triangles("prism", samples::prism(80)), from_triangles("turned prism", samples::prism(12, 3)),
          from_triangles("turned grid", samples::random_diagonal_grid(6, 6, 1, 7)),
          from_triangles("torus", samples::torus(12, 8)),
          from_triangles("Schwarz lantern", samples::Schwarz_lantern(6, 20)), from_triangles("cap", samples::cap()),
          from_triangles("large sheared grid", samples::sheared_grid(5, 5, 3)),
          from_triangles("sphere", samples::latitude_longitude_sphere(12, 6)),
          from_gluing("square torus", samples::sheared_one_vertex_torus(10))})
      surfaces.push_back(surface);
  const std::uint64_t budget = 5000;
  bool is_every_run_complete = true;
  for (const Surface& surface : surfaces) {
    SCOPED_TRACE(surface.name);
    auto t = triangulation<TypeParam>(surface);
    const Flip_report report = IT::flip_to_Delaunay(t, maximum_number(budget));
    expect_truth(report, t);
    EXPECT_LE(report.flips, budget);
    EXPECT_EQ(report.status == Flip_status::BUDGET_EXHAUSTED, report.flips == budget);
    is_every_run_complete = is_every_run_complete && report.status == Flip_status::DELAUNAY;
    if (is_interval && surface.name == "prism") {
      EXPECT_EQ(report.status, Flip_status::UNDECIDED);
      EXPECT_GT(report.undecided.size(), 10u);
    }
  }
  if (is_exact) {
    EXPECT_TRUE(is_every_run_complete);
  } else if (!std::is_same<Number_type, long double>::value) {
    EXPECT_FALSE(is_every_run_complete); // otherwise the test would prove nothing
  }
}

} // namespace flip_tests
