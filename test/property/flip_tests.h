// SPDX-License-Identifier: GPL-3.0-or-later
//
// The flip algorithm with the number type Number_type: what it must reach, what it must not
// change, and how it ends where the number type cannot get there.

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
constexpr bool is_interval =
  std::is_same<IT::Edge_length_traits<Number_type>::Boolean, CGAL::Uncertain<bool>>::value;
constexpr double tolerance = is_float ? 1e-3 : 1e-9;

// Remembers the flips and checks what it is told.
struct Recorder
{
  bool go_further(std::uint64_t tests, std::uint64_t number_of_flips)
  {
    EXPECT_EQ(tests, calls);
    EXPECT_EQ(number_of_flips, flips.size());
    return ++calls <= limit;
  }
  void after_flip(IT::Edge_index e) { flips.push_back(e); }

  std::uint64_t limit = (std::numeric_limits<std::uint64_t>::max)();
  std::uint64_t calls = 0;
  std::vector<IT::Edge_index> flips;
};

void expect_equal(const Invariants& a, const Invariants& b)
{
  EXPECT_EQ(a.euler_characteristic, b.euler_characteristic);
  EXPECT_EQ(a.border_halfedges, b.border_halfedges);
  EXPECT_NEAR(a.area, b.area, tolerance * b.area);
  ASSERT_EQ(a.cone_angles.size(), b.cone_angles.size());
  for (std::size_t v = 0; v < a.cone_angles.size(); ++v)
    EXPECT_NEAR(a.cone_angles[v], b.cone_angles[v], tolerance * b.cone_angles[v]) << "vertex " << v;
}

// Whether the report says the truth about the triangulation.
template <class Triangulation>
void expect_truth(const Flip_report& report, const Triangulation& t)
{
  EXPECT_TRUE(t.connectivity().is_valid(true));
  for (IT::Edge_index e : report.not_flippable)
    EXPECT_FALSE(CGAL::possibly(t.is_locally_Delaunay(e)));
  for (IT::Edge_index e : report.undecided)
    EXPECT_FALSE(CGAL::certainly(t.is_locally_Delaunay(e)));
  if (report.status == Flip_status::DELAUNAY) {
    EXPECT_TRUE(report.not_flippable.empty());
    EXPECT_TRUE(report.undecided.empty());
    for (IT::Edge_index e : t.connectivity().edges())
      EXPECT_TRUE(CGAL::certainly(t.is_locally_Delaunay(e))) << e;
  }
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
    EXPECT_EQ(report.tests, recorder.calls);
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
      const double length = CGAL::to_double(t.length(e));
      auto turned = t;
      if (turned.flip(e) != Outcome::FLIPPED)
        continue;
      const auto faces_of = [&](const auto& triangulation) {
        const IT::Halfedge_index h = triangulation.connectivity().halfedge(e);
        return std::minmax({CGAL::to_double(triangulation.area(triangulation.connectivity().face(h))),
                            CGAL::to_double(triangulation.area(
                              triangulation.connectivity().face(triangulation.connectivity().opposite(h))))});
      };
      // Where a face nearly vanishes, rounding decides whether the way back exists.
      if (faces_of(turned).first < 1e-2 * faces_of(turned).second)
        continue;
      ++flipped;
      const double diagonal = CGAL::to_double(turned.length(e));
      expect_equal(invariants(turned), before);
      for (double expected : {length, diagonal, length}) {
        ASSERT_EQ(turned.flip(e), Outcome::FLIPPED);
        EXPECT_NEAR(CGAL::to_double(turned.length(e)), expected, 10 * tolerance * expected);
      }
      EXPECT_TRUE(are_same_links(turned.connectivity(), surface.connectivity));
      EXPECT_NEAR(faces_of(turned).first, faces_of(t).first, 10 * tolerance * faces_of(t).second);
      EXPECT_NEAR(faces_of(turned).second, faces_of(t).second, 10 * tolerance * faces_of(t).second);
    }
  });
  EXPECT_GT(flipped, 100);
}

TYPED_TEST(Flip, leaves_constrained_edges_alone)
{
  std::size_t number_of_constraints = 0;
  this->for_each_generic_surface([&](const Surface&, auto t) {
    const IT::Delta_complex& c = t.connectivity();
    // Every other edge that the algorithm would like to flip, and some that it need not.
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
    const auto map = boost::make_function_property_map<IT::Edge_index>(
      [&](IT::Edge_index e) { return is_constrained[e.idx()] != 0; });
    const auto unflipped = t;
    Recorder recorder;
    const Flip_report report =
      IT::flip_to_Delaunay(t, visitor(std::ref(recorder)).edge_is_constrained_map(map));
    EXPECT_EQ(report.status, Flip_status::DELAUNAY);
    for (IT::Edge_index e : recorder.flips)
      EXPECT_FALSE(is_constrained[e.idx()]);
    for (IT::Edge_index e : c.edges())
      if (!is_constrained[e.idx()])
        EXPECT_TRUE(CGAL::certainly(t.is_locally_Delaunay(e)));
      else {
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
    for (std::uint64_t limit : {std::uint64_t(0), complete.tests / 2, complete.tests}) {
      auto cancelled = t;
      Recorder recorder;
      recorder.limit = limit;
      const Flip_report report = IT::flip_to_Delaunay(cancelled, visitor(std::ref(recorder)));
      EXPECT_EQ(report.status, limit < complete.tests ? Flip_status::CANCELLED : Flip_status::DELAUNAY);
      EXPECT_EQ(report.tests, limit);
      EXPECT_EQ(report.flips, recorder.flips.size());
      expect_truth(report, cancelled);
      const Flip_report rest = IT::flip_to_Delaunay(cancelled);
      EXPECT_EQ(rest.status, Flip_status::DELAUNAY);
      EXPECT_TRUE(are_same_edges(edge_records(cancelled), edge_records(finished), tolerance))
        << surface.name;
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

// Traits by which no hinge has another diagonal, or for which this is uncertain.
template <class Base, bool is_certain>
struct Traits_without_flips : Base
{
  struct Construct_flipped_hinge
  {
    typename Base::Boolean operator()(const typename Base::Hinge_data&,
                                      typename Base::Flipped_hinge_data&) const
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

// Ties that rounding has broken: an interval cannot decide them, and rounded decisions
// may go round in circles. Whatever happens, the run ends and says so.
TYPED_TEST(Flip, ends_on_ties)
{
  if (is_exact)
    GTEST_SKIP() << "proofs of zero take too long";
  const std::vector<Surface> surfaces{
    from_triangles("prism", IT::prism(80)), from_triangles("turned prism", IT::prism(12, 3)),
    from_triangles("turned grid", IT::random_diagonal_grid(6, 6, 1, 7)),
    from_triangles("torus", IT::torus(12, 8)), from_triangles("Schwarz lantern", IT::Schwarz_lantern(6, 20)),
    from_triangles("cap", IT::cap()), from_triangles("sheared grid", IT::sheared_grid(5, 5, 3)),
    from_triangles("sphere", IT::latitude_longitude_sphere(12, 6)),
    from_gluing("square torus", IT::sheared_one_vertex_torus(10))};
  const std::uint64_t budget = 5000;
  for (const Surface& surface : surfaces) {
    SCOPED_TRACE(surface.name);
    auto t = triangulation<TypeParam>(surface);
    const Flip_report report = IT::flip_to_Delaunay(t, maximum_number(budget));
    expect_truth(report, t);
    EXPECT_LE(report.flips, budget);
    EXPECT_EQ(report.status == Flip_status::BUDGET_EXHAUSTED, report.flips == budget);
    EXPECT_EQ(report.status == Flip_status::NOT_FLIPPABLE,
              !report.not_flippable.empty() && report.undecided.empty() && report.flips < budget);
    if (getenv("SHOW")) printf("%s %s: %d flips %d nf %d und %d\n", surface.name.c_str(), testing::internal::GetTypeName<TypeParam>().c_str(), int(report.status), int(report.flips), int(report.not_flippable.size()), int(report.undecided.size()));
  }
}

} // namespace flip_tests
