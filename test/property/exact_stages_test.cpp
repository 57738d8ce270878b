// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each stage of the exact Delaunay test decides something here, and correctly: the verification, which uses only the
// unfolding, and the tessellation agree.

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Delaunay_tessellation.h>
#include <CGAL/Intrinsic_triangulations/verify_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include "library/engine/history/Flip_log.h"
#include "library/engine/decide/Exact_fallback.h"
#include <CGAL/Intrinsic_triangulations/internal/flips/Whole_triangulation.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/squared_lengths.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

Triangulation make_Delaunay(const samples::Indexed_triangles& surface)
{
  Triangulation t(IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles), surface.points);
  EXPECT_EQ(IT::flip_to_Delaunay(t).status, IT::Flip_status::DELAUNAY);
  return t;
}

void expect_agreement(const Triangulation& t)
{
  const IT::Delaunay_verification verification = IT::verify_Delaunay(t);
  EXPECT_TRUE(verification.is_Delaunay());
  const IT::Delaunay_tessellation tessellation(t);
  std::size_t ties = 0;
  for (IT::Edge_index e : t.connectivity().edges())
    ties += tessellation.is_tie(e);
  EXPECT_EQ(ties, verification.ties);
}

TEST(Exact_stages, the_filter_decides_nearly_all_of_an_ordinary_surface)
{
  const Triangulation t = make_Delaunay(samples::bumpy_sphere());
  const IT::Stage_counts counts = t.stage_counts();
  EXPECT_GT(counts[IT::Stage::FILTER], 15000u);
  EXPECT_LT(counts[IT::Stage::UNFOLDING], 100u);
  expect_agreement(t);
}

TEST(Exact_stages, double_doubles_decide_near_ties_across_edges_that_are_nearly_flat)
{
  const Triangulation t = make_Delaunay(samples::random_diagonal_grid(30, 30, 1, 1));
  EXPECT_GT(t.stage_counts()[IT::Stage::UNFOLDING], 100u);
  expect_agreement(t);
}

TEST(Exact_stages, ties_of_an_integer_grid_are_decided_in_the_plane)
{
  const Triangulation t = make_Delaunay(samples::random_diagonal_grid(30, 30, 1, 0));
  EXPECT_EQ(t.stage_counts()[IT::Stage::COPLANAR], 900u);
  EXPECT_EQ(t.stage_counts().ties, 900u);
  EXPECT_EQ(IT::Delaunay_tessellation(t).number_of_cells(), 900u);
  expect_agreement(t);
}

// A face beside each edge that is flipped is known to have area, so that the new edge has length: the exact geometry,
// for which all flips are repeated, is not asked.
TEST(Exact_stages, long_chains_of_flips_in_a_plane_need_no_correspondence)
{
  Triangulation t = make_Delaunay(samples::sheared_grid(60, 60, 20.3));
  EXPECT_GT(t.stage_counts()[IT::Stage::COPLANAR], 0u);
  using Whole = IT::internal::Whole_triangulation<IT::Filtered_edge_length_traits>;
  EXPECT_FALSE(Whole(t).engine().log().is_followed_by(IT::internal::Flip_log::INTEGERS));
  expect_agreement(t);
}

// The caps lie in planes z = const, their corners nearly on a circle. Chains of flips cross them.
TEST(Exact_stages, near_ties_of_flipped_faces_are_decided_in_the_plane)
{
  const Triangulation t = make_Delaunay(samples::prism(200));
  EXPECT_GT(t.stage_counts()[IT::Stage::COPLANAR], 500u);
  EXPECT_EQ(t.stage_counts()[IT::Stage::UNFOLDING], 0u);
  expect_agreement(t);
}

// After the rotation hardly any two faces lie in one plane: the faces of the caps are laid out
// once and carried along by the flips.
TEST(Exact_stages, near_ties_of_bent_faces_are_decided_by_faces_carried_along)
{
  for (std::uint64_t rotation_seed : {1, 2, 3}) {
    const Triangulation t = make_Delaunay(samples::prism(200, rotation_seed));
    EXPECT_GT(t.stage_counts()[IT::Stage::UNFOLDING], 500u);
    expect_agreement(t);
  }
}

// A fold, the angles opposite to it are α and π − α: the cotangents are 3/4 and -3/4.
TEST(Exact_stages, rational_numbers_decide_ties_where_areas_are_rational)
{
  const Triangulation t = make_Delaunay({{{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, 0, 0.25}}, {{0, 1, 2}, {1, 0, 3}}});
  EXPECT_EQ(t.stage_counts()[IT::Stage::ALGEBRAIC], 1u);
  EXPECT_EQ(t.stage_counts().ties, 1u);
  expect_agreement(t);
}

// The same with the cotangents 7/8 √2 and -7/8 √2.
TEST(Exact_stages, a_multiquadratic_field_decides_ties_where_areas_have_roots)
{
  const Triangulation t =
    make_Delaunay({{{0, 0, 0}, {1, 0, 0}, {0.5, 1, 1}, {0.5, -0.125, 0.125}}, {{0, 1, 2}, {1, 0, 3}}});
  EXPECT_EQ(t.stage_counts()[IT::Stage::ALGEBRAIC], 1u);
  EXPECT_EQ(t.stage_counts().ties, 1u);
  expect_agreement(t);
}

// Coordinates of very different magnitude: a double-double does not hold their difference.
TEST(Exact_stages, multiple_precision_decides_where_magnitudes_differ)
{
  samples::Indexed_triangles surface = samples::torus(4, 3);
  for (auto& p : surface.points)
    p[0] = std::ldexp(p[0], 60);
  const Triangulation t = make_Delaunay(surface);
  EXPECT_GT(t.stage_counts()[IT::Stage::MULTIPRECISION], 0u);
  expect_agreement(t);
}

// All areas are rational, or all are rational multiples of the root of two. Then symmetry is noticed.
TEST(Exact_stages, ties_across_bent_edges_are_proven_in_the_rationals_or_by_symmetry)
{
  for (double slope : {0, 1}) {
    samples::Indexed_triangles surface = samples::pillow(60);
    for (auto& p : surface.points)
      p[2] = slope * p[1];
    const Triangulation t = make_Delaunay(surface);
    EXPECT_GT(t.stage_counts()[slope == 0 ? IT::Stage::ALGEBRAIC : IT::Stage::CONGRUENCE], 0u);
    EXPECT_GT(IT::verify_Delaunay(t).ties, 0u);
    expect_agreement(t);
  }
}

// Without a root, the rationals decide everything.
TEST(Exact_stages, the_rationals_decide_where_no_area_has_a_root)
{
  const samples::Indexed_triangles surface = samples::pillow(20);
  const Triangulation input(IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles),
                            surface.points);
  std::array<int, 3> number_of_signs{};
  for (const Triangulation& t : {input, make_Delaunay(surface)}) {
    const IT::internal::Exact_engine& geometry = IT::internal::engine(t);
    const auto input_surface = geometry.input_surface();
    IT::internal::Exact_fallback exact_fallback(t.connectivity(), geometry.correspondence(), *input_surface);
    IT::internal::Double_double_metric metric(*input_surface);
    const IT::internal::Unfolding<IT::internal::Double_double_metric> unfolding(t.connectivity(),
                                                                                geometry.correspondence(), metric);
    for (IT::Edge_index e : t.connectivity().edges()) {
      if (!t.connectivity().is_flippable(e))
        continue;
      const IT::internal::Two_corners corners = IT::internal::corners_beside(t.connectivity(), e);
      const auto decision =
        exact_fallback.sign_of_cotangents(corners, IT::internal::unfolded_corners(unfolding, corners));
      EXPECT_EQ(decision.stage, IT::Stage::ALGEBRAIC);
      EXPECT_EQ(decision.sign, CGAL::sign(t.cotangent_weight(e)));
      ++number_of_signs[std::size_t(1 + decision.sign)];
    }
  }
  for (int n : number_of_signs)
    EXPECT_GT(n, 0);
}

// Where both areas are zero, so is the number, whatever the angles are. Only if both are pi, the edge is not Delaunay.
TEST(Exact_stages, flat_faces_are_told_by_their_angles)
{
  // Edge 0-1 from 0 to 4, and the third corners.
  const auto sign = [](double x, double y) {
    const std::vector<std::array<double, 3>> points{{0, 0, 0}, {4, 0, 0}, {x, 0, 0}, {y, 0, 0}};
    const Triangulation t(
      IT::make_Delta_complex_from_triangles(4, std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {1, 0, 3}}),
      points);
    const IT::internal::Exact_engine& geometry = IT::internal::engine(t);
    const auto surface = geometry.input_surface();
    IT::internal::Double_double_metric metric(*surface);
    const IT::internal::Unfolding<IT::internal::Double_double_metric> unfolding(t.connectivity(),
                                                                                geometry.correspondence(), metric);
    for (IT::Edge_index e : t.connectivity().edges())
      if (!t.connectivity().is_border(e)) {
        const IT::internal::Two_corners corners = IT::internal::corners_beside(t.connectivity(), e);
        return IT::internal::Exact_fallback(t.connectivity(), geometry.correspondence(), *surface)
          .sign_of_cotangents(corners, IT::internal::unfolded_corners(unfolding, corners))
          .sign;
      }
    throw std::logic_error("no edge has two faces");
  };
  EXPECT_EQ(sign(1, 2), CGAL::NEGATIVE);
  EXPECT_EQ(sign(1, 6), CGAL::ZERO);
  EXPECT_EQ(sign(5, 6), CGAL::ZERO);
}

// Optionally, Delaunay edges are flipped, too: then the hinge may have no other diagonal.
TEST(Exact_stages, hinges_that_are_not_convex_are_not_flipped)
{
  using Outcome = Triangulation::Flip_outcome;
  const auto flip = [](const std::array<double, 3>& l) {
    const samples::Indexed_triangles hinge{{{0, 0, 0}, {1, 0, 0}, {3, 1, 0}, l}, {{0, 1, 2}, {1, 0, 3}}};
    Triangulation t(IT::make_Delta_complex_from_triangles(4, hinge.triangles), hinge.points);
    for (IT::Edge_index e : t.connectivity().edges())
      if (t.connectivity().is_flippable(e)) {
        const IT::Delta_complex before = t.connectivity();
        const Outcome outcome = t.flip(e);
        EXPECT_EQ(outcome == Outcome::FLIPPED, t.connectivity() != before);
        EXPECT_NEAR(t.area(IT::Face_index(0)) + t.area(IT::Face_index(1)), 0.5 - l[1] / 2, 1e-15);
        return outcome;
      }
    return Outcome::UNDECIDED;
  };
  EXPECT_EQ(flip({3, -1, 0}), Outcome::NOT_CONVEX);
  EXPECT_EQ(flip({-2, -1, 0}), Outcome::FLIPPED);
  // From (3, 1) through (1, 0): straight at (-1, -1), and bent by the smallest amount beside it.
  EXPECT_EQ(flip({-1, -1, 0}), Outcome::NOT_CONVEX);
  EXPECT_EQ(flip({std::nextafter(-1, -2), -1, 0}), Outcome::FLIPPED);
  EXPECT_EQ(flip({std::nextafter(-1, 0), -1, 0}), Outcome::NOT_CONVEX);
}

// Nearly a square: both opposite angles are nearly right ones, and their cotangents are 2^-n / 2.
TEST(Exact_stages, weights_near_ties_are_small_and_not_zero)
{
  using Rational = IT::Rational;
  const std::vector<std::array<std::uint32_t, 3>> triangles{{0, 1, 2}, {1, 0, 3}};
  for (const int n : {40, 120, 400, 1000, 1500})
    for (const int sign : {1, -1}) {
      IT::Delta_complex complex = IT::make_Delta_complex_from_triangles(4, triangles);
      std::vector<Rational> squared_lengths(complex.number_of_edges(), 1);
      std::vector<IT::Edge_index> diagonals;
      for (IT::Edge_index e : complex.edges())
        if (complex.is_flippable(e))
          diagonals.push_back(e);
      ASSERT_EQ(diagonals.size(), 1u);
      const Rational epsilon(IT::internal::Integer(1), IT::internal::Integer(1) << n);
      squared_lengths[diagonals[0].idx()] = 2 - sign * epsilon;
      const Triangulation t =
        Triangulation::from_metric(std::move(complex), IT::metric_from_squared_lengths(std::move(squared_lengths)));
      const double smallest = 0x1p-1074;
      const double expected = sign * (std::max)(std::ldexp(1., -n), smallest);
      EXPECT_NEAR(t.cotangent_weight(diagonals[0]), expected, 1e-14 * std::abs(expected)) << n;
      EXPECT_EQ(t.sign_of_cotangent_weight(diagonals[0]), CGAL::sign(sign));
    }
}

// However many bits are taken, the interval around such a length has two ends beside it.
TEST(Exact_stages, a_length_that_is_a_double_is_found_by_multiple_precision)
{
  const samples::Indexed_triangles grid = samples::random_diagonal_grid(3, 3, 1);
  const Triangulation t(IT::make_Delta_complex_from_triangles(grid.points.size(), grid.triangles), grid.points);
  const IT::internal::Exact_engine& geometry = IT::internal::engine(t);
  const auto input_surface = geometry.input_surface();
  IT::internal::Exact_fallback exact_fallback(t.connectivity(), geometry.correspondence(), *input_surface);
  for (IT::Edge_index e : t.connectivity().edges())
    EXPECT_NEAR(std::ldexp(exact_fallback.length(e), t.unit_exponent()), t.length(e), 0x1p-52 * t.length(e));
}

TEST(Exact_stages, triangulations_in_two_threads_do_not_meet)
{
  const auto work = [] {
    expect_agreement(make_Delaunay(samples::pillow(40)));
    expect_agreement(make_Delaunay(samples::prism(40, 1)));
  };
  std::thread other(work);
  work();
  other.join();
}

} // namespace
