// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// If a proof is demanded for each tie, one that takes too long ends in an error, and a long one can be ended from
// outside. Afterwards the triangulation is as before, and the work can continue.

#include "symmetric_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/squared_lengths.h>
#include <CGAL/Intrinsic_triangulations/verify_Delaunay.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
namespace params = CGAL::parameters;
using IT::Flip_status;
using IT::Stage;
using IT::Tie_proof;
using symmetric_surfaces::Surface;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

Triangulation triangulation(const Surface& surface)
{
  return {symmetric_surfaces::connectivity(surface), surface.mesh.points};
}

// From lengths alone, which do not tell that folds are parallel.
Triangulation triangulation_by_lengths(const Surface& surface)
{
  return Triangulation::from_metric(symmetric_surfaces::connectivity(surface),
                                    IT::metric_from_squared_lengths(symmetric_surfaces::squared_lengths(surface)));
}

// Its tie has so many roots that an expansion is given up.
Surface costly_surface() { return symmetric_surfaces::quarter_turns(12); }

// Strips of different widths between parallel folds: each has a root, but no product of roots arises, so that
// the expansion is short. The corners form a rectangle, but the folds end at other distances from its middle.
Surface parallel_folds(int number_of_strips)
{
  constexpr double end = 10000;
  symmetric_surfaces::Sheet sheet;
  double x = 0;
  symmetric_surfaces::Column last{sheet.add({x, -end, 0}), sheet.add({x, end, 0})};
  std::array<std::uint32_t, 4> corners;
  corners[2] = sheet.add({-1, 0, 0});
  corners[1] = sheet.add({-1, 1, 0});
  sheet.add_triangle(last.bottom, last.top, corners[1]);
  sheet.add_triangle(corners[2], last.bottom, corners[1]);
  for (int i = 1; i <= number_of_strips; ++i) {
    x += i;
    const double z = i % 2;
    const symmetric_surfaces::Column next{sheet.add({x, -end, z}), sheet.add({x, end, z})};
    sheet.add_strip(last, next, symmetric_surfaces::Sheet::Diagonal::RISING);
    last = next;
  }
  const double z = number_of_strips % 2;
  corners[3] = sheet.add({x + 1, 0, z});
  corners[0] = sheet.add({x + 1, 1, z});
  sheet.add_triangle(last.top, last.bottom, corners[0]);
  sheet.add_triangle(last.bottom, corners[3], corners[0]);
  return sheet.finish(corners);
}

// The pairs of vertices that edges join, without the ties, of which either diagonal may be there.
std::vector<std::array<std::uint32_t, 2>> edges_of_tessellation(const Triangulation& t)
{
  const IT::Delta_complex& complex = t.connectivity();
  std::vector<std::array<std::uint32_t, 2>> result;
  for (IT::Edge_index e : complex.edges()) {
    if (complex.is_flippable(e) && t.sign_of_cotangent_weight(e) == CGAL::ZERO)
      continue;
    const std::uint32_t p = complex.source(complex.halfedge(e)).idx(), q = complex.target(complex.halfedge(e)).idx();
    result.push_back({(std::min)(p, q), (std::max)(p, q)});
  }
  std::sort(result.begin(), result.end());
  return result;
}

void expect_same_result(const Triangulation& t, const Triangulation& uninterrupted)
{
  const IT::Delaunay_verification verification = IT::verify_Delaunay(t);
  EXPECT_TRUE(verification.is_Delaunay());
  EXPECT_EQ(verification.ties, 1u);
  EXPECT_EQ(edges_of_tessellation(t), edges_of_tessellation(uninterrupted));
  for (IT::Edge_index e : t.connectivity().edges())
    if (t.connectivity().is_flippable(e)) {
      EXPECT_GE(t.cotangent_weight(e), 0);
    }
}

Triangulation made_Delaunay(const Surface& surface)
{
  Triangulation t = triangulation(surface);
  EXPECT_EQ(IT::flip_to_Delaunay(t).status, Flip_status::DELAUNAY);
  return t;
}

// Cancels when it is asked several times without a test between.
struct Impatient_visitor
{
  bool go_further(const IT::Progress& progress)
  {
    const bool is_equal = progress.tests == last.tests && progress.flips == last.flips;
    number_of_equal_questions = is_equal ? number_of_equal_questions + 1 : 0;
    last = progress;
    return number_of_equal_questions < 10;
  }

  IT::Progress last;
  int number_of_equal_questions = 0;
};

TEST(Tie_proof, a_visitor_cancels_within_a_decision)
{
  const Triangulation uninterrupted = made_Delaunay(costly_surface());
  EXPECT_GE(uninterrupted.stage_counts()[Stage::MODULAR], 1u);
  Triangulation t = triangulation(costly_surface());
  Impatient_visitor visitor;
  EXPECT_THROW(IT::flip_to_Delaunay(t, params::tie_proof(Tie_proof::PROVEN).visitor(std::ref(visitor))),
               IT::Cancelled_error);
  EXPECT_EQ(visitor.number_of_equal_questions, 10);
  // It would be cancelled again, any number of times.
  EXPECT_THROW(IT::flip_to_Delaunay(t, params::visitor(Impatient_visitor())), IT::Cancelled_error);
  EXPECT_EQ(IT::flip_to_Delaunay(t, params::tie_proof(Tie_proof::PROBABLE_IF_COSTLY)).status, Flip_status::DELAUNAY);
  EXPECT_GE(t.stage_counts()[Stage::MODULAR], 1u);
  expect_same_result(t, uninterrupted);
}

// Asked without a visitor, and beside one.
TEST(Tie_proof, a_function_ends_a_decision)
{
  const Triangulation uninterrupted = made_Delaunay(costly_surface());
  Triangulation t = triangulation(costly_surface());
  int questions = 0;
  t.set_interruption([&questions] { return ++questions < 5; });
  EXPECT_THROW(IT::flip_to_Delaunay(t, params::tie_proof(Tie_proof::PROVEN).visitor(Impatient_visitor())),
               IT::Cancelled_error);
  EXPECT_EQ(questions, 5);
  const std::function<bool()> function = t.set_interruption({}); // the visitor was taken away, and it stayed
  ASSERT_TRUE(function);
  EXPECT_FALSE(function());
  EXPECT_EQ(questions, 6);
  EXPECT_EQ(IT::flip_to_Delaunay(t, params::tie_proof(Tie_proof::PROBABLE_IF_COSTLY)).status, Flip_status::DELAUNAY);
  expect_same_result(t, uninterrupted);

  t.set_tie_proof(Tie_proof::PROVEN);
  std::vector<IT::Edge_index> ended;
  t.set_interruption([] { return false; });
  for (IT::Edge_index e : t.connectivity().edges())
    if (t.connectivity().is_flippable(e)) {
      try {
        t.sign_of_cotangent_weight(e);
      } catch (const IT::Cancelled_error&) {
        ended.push_back(e);
      }
    }
  ASSERT_FALSE(ended.empty());
  EXPECT_FALSE(t.set_interruption({})());
  EXPECT_FALSE(t.set_interruption({})); // it was taken away
  t.set_tie_proof(Tie_proof::PROBABLE_IF_COSTLY);
  int number_of_ties = 0;
  for (IT::Edge_index e : ended)
    number_of_ties += t.sign_of_cotangent_weight(e) == CGAL::ZERO;
  EXPECT_EQ(number_of_ties, 1);
  expect_same_result(t, uninterrupted);
}

// Whenever a run is ended, the next one finishes the work.
TEST(Tie_proof, a_run_can_be_ended_at_any_question)
{
  struct Visitor
  {
    bool go_further(const IT::Progress&) { return questions++ < last; }
    int last, questions = 0;
  };
  const Surface surface = symmetric_surfaces::quarter_turns(5);
  const Triangulation uninterrupted = made_Delaunay(surface);
  for (int last = 0;; ++last) {
    Triangulation t = triangulation(surface);
    try {
      EXPECT_EQ(IT::flip_to_Delaunay(t, params::visitor(Visitor{last})).status, Flip_status::DELAUNAY);
      EXPECT_GT(last, 30);
      break;
    } catch (const IT::Cancelled_error&) {
    }
    EXPECT_EQ(IT::flip_to_Delaunay(t).status, Flip_status::DELAUNAY);
    expect_same_result(t, uninterrupted);
  }
}

TEST(Tie_proof, a_proof_is_found_or_an_error_says_that_there_is_none)
{
  for (int strips : {6, 20, 50}) {
    const Surface surface = parallel_folds(strips);
    for (const auto& [start, stage] : {std::pair(triangulation_by_lengths(surface), Stage::ALGEBRAIC),
                                       std::pair(triangulation(surface), Stage::CONGRUENCE)}) {
      Triangulation t = start;
      EXPECT_EQ(IT::flip_to_Delaunay(t, params::tie_proof(Tie_proof::PROVEN)).status, Flip_status::DELAUNAY);
      EXPECT_GE(t.stage_counts()[stage], 1u);
      EXPECT_EQ(t.stage_counts()[Stage::MODULAR], 0u);
      EXPECT_EQ(IT::verify_Delaunay(t).ties, 1u);
    }
  }
  // More roots than a proof can have.
  const Surface surface = parallel_folds(100);
  Triangulation t = triangulation_by_lengths(surface);
  try {
    IT::flip_to_Delaunay(t, params::tie_proof(Tie_proof::PROVEN));
    ADD_FAILURE() << "no proof was missed";
  } catch (const IT::Undecided_error& error) {
    EXPECT_NE(std::string(error.what()).find("cannot be proven"), std::string::npos) << error.what();
  }
  EXPECT_EQ(t.stage_counts()[Stage::MODULAR], 0u);
  // The demand stays until it is changed, and a copy takes it over.
  EXPECT_THROW(IT::flip_to_Delaunay(t), IT::Undecided_error);
  Triangulation copy = t;
  EXPECT_THROW(IT::flip_to_Delaunay(copy), IT::Undecided_error);
  for (Triangulation* each : {&t, &copy}) {
    EXPECT_EQ(IT::flip_to_Delaunay(*each, params::tie_proof(Tie_proof::PROBABLE_IF_COSTLY)).status,
              Flip_status::DELAUNAY);
    EXPECT_GE(each->stage_counts()[Stage::MODULAR], 1u);
    expect_same_result(*each, made_Delaunay(surface));
  }
  t.set_tie_proof(Tie_proof::PROVEN);
  EXPECT_THROW(IT::verify_Delaunay(t), IT::Undecided_error);
}

// Near ties need no proof of zero, however close they are.
TEST(Tie_proof, a_sign_other_than_zero_is_always_proven)
{
  const Surface surface = parallel_folds(100);
  std::vector<symmetric_surfaces::Rational> squared_lengths = symmetric_surfaces::squared_lengths(surface);
  squared_lengths.back() += symmetric_surfaces::Rational(1, IT::internal::Integer(1) << 200);
  Triangulation t = Triangulation::from_metric(symmetric_surfaces::connectivity(surface),
                                               IT::metric_from_squared_lengths(squared_lengths));
  EXPECT_EQ(IT::flip_to_Delaunay(t, params::tie_proof(Tie_proof::PROVEN)).status, Flip_status::DELAUNAY);
  EXPECT_GE(t.stage_counts()[Stage::MULTIPRECISION], 1u);
  EXPECT_EQ(IT::verify_Delaunay(t).ties, 0u);
}

} // namespace
