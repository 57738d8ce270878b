// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Ties with up to many hundreds of independent square roots are decided, and so are surfaces
// that differ from one with such a tie by next to nothing: rightly, as a reference in the plane says.

#include "Developed_disk.h"
#include "symmetric_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/squared_lengths.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/verify_Delaunay.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using developed_disk::Developed_disk;
using symmetric_surfaces::connectivity;
using symmetric_surfaces::Rational;
using symmetric_surfaces::squared_lengths;
using symmetric_surfaces::Surface;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

struct Family
{
  const char* name;
  std::function<Surface(int)> make;
  // That finds a tie with many roots, from points and from lengths: these do not tell which triangles are coplanar.
  IT::Stage stage, stage_by_lengths;
};

const std::vector<Family>& families()
{
  constexpr IT::Stage congruence = IT::Stage::CONGRUENCE, modular = IT::Stage::MODULAR;
  static const std::vector<Family> result{
    {"mirrored", [](int folds) { return symmetric_surfaces::mirrored_sheet(folds); }, congruence, congruence},
    {"mirrored, with cuts", [](int folds) { return symmetric_surfaces::mirrored_sheet(folds, true); }, congruence,
     modular},
    {"quarter turns", symmetric_surfaces::quarter_turns, modular, modular},
    {"sixth turns", symmetric_surfaces::sixth_turns, modular, modular},
    {"half turn", symmetric_surfaces::half_turn, modular, modular},
    {"glided", symmetric_surfaces::glided_sheet, modular, modular}};
  return result;
}

Triangulation from_points(const Surface& surface) { return {connectivity(surface), surface.mesh.points}; }

Triangulation from_lengths(const Surface& surface, const std::vector<Rational>& squared_lengths)
{
  return Triangulation::from_metric(connectivity(surface), IT::metric_from_squared_lengths(squared_lengths));
}

CGAL::Sign reference_sign(const Developed_disk& disk, const IT::Delta_complex& complex, IT::Edge_index e)
{
  const IT::Halfedge_index h = complex.halfedge(e), g = complex.opposite(h);
  return disk.sign_of_cotangents(complex.source(h), complex.target(h), complex.target(complex.next(h)),
                                 complex.target(complex.next(g)));
}

void expect_tie(Triangulation t, const Surface& surface, const Developed_disk& disk, IT::Stage stage)
{
  ASSERT_EQ(IT::flip_to_Delaunay(t).status, IT::Flip_status::DELAUNAY);
  const IT::Edge_index e = symmetric_surfaces::diagonal_of_corners(t.connectivity(), surface);
  ASSERT_NE(e, IT::Edge_index());
  EXPECT_EQ(reference_sign(disk, t.connectivity(), e), CGAL::ZERO);
  EXPECT_EQ(t.sign_of_cotangent_weight(e), CGAL::ZERO);
  EXPECT_EQ(t.cotangent_weight(e), 0);
  EXPECT_GE(t.stage_counts()[stage], 1u);
  EXPECT_GE(t.stage_counts().ties, 1u);
  const IT::Delaunay_verification verification = IT::verify_Delaunay(t);
  EXPECT_TRUE(verification.is_Delaunay());
  EXPECT_GE(verification.ties, 1u);
}

TEST(Symmetric_ties, are_decided)
{
  for (const Family& family : families())
    for (int folds : {4, 6, 8, 10, 14, 20, 50, 100, 200}) {
      if (family.stage == IT::Stage::MODULAR && folds > 100) // the hinge crosses four hundred already
        continue;
      SCOPED_TRACE(std::string(family.name) + " " + std::to_string(folds));
      const Surface surface = family.make(folds);
      const Developed_disk disk(connectivity(surface), squared_lengths(surface));
      expect_tie(from_points(surface), surface, disk, family.stage);
      if (folds <= 50)
        expect_tie(from_lengths(surface, squared_lengths(surface)), surface, disk, family.stage_by_lengths);
    }
}

// A wheel whose halves are mirror images, except for the two vertices of the rim between them: where x should be 0, it
// is the rounded cosine of pi / 2. Edges cross many spokes on both sides of one of those.
TEST(Symmetric_ties, of_a_nearly_symmetric_wheel_need_no_finite_field)
{
  constexpr std::uint32_t half = 100;
  samples::Indexed_triangles mesh;
  mesh.points.push_back({0, 0, 1});
  const auto rounded = [](double x) { return std::round(std::ldexp(x, 20)) * 0x1p-20; };
  for (std::uint32_t i = 0; i < 2 * half; ++i) {
    const double angle = std::acos(-1.) * (double((std::min)(i, 2 * half - i)) / half - 0.5),
                 x = i % half == 0 ? 0x1p-54 : rounded(std::cos(angle));
    mesh.points.push_back({i < half ? x : -x, rounded(std::sin(angle)), rounded(0.3 * std::sin(3 * angle))});
    mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % (2 * half)});
  }
  Triangulation t(IT::make_Delta_complex_from_triangles(mesh.points.size(), mesh.triangles), mesh.points);
  ASSERT_EQ(IT::flip_to_Delaunay(t).status, IT::Flip_status::DELAUNAY);
  EXPECT_GT(t.stage_counts()[IT::Stage::CONGRUENCE], 10u);
  EXPECT_EQ(t.stage_counts()[IT::Stage::MODULAR], 0u);
}

// The Delaunay diagonal, and the other one that takes its place when it is flipped.
void expect_signs_of_reference(Triangulation t, const Surface& surface, const std::vector<Rational>& squared_lengths,
                               std::array<int, 2>& number_of_diagonals)
{
  const Developed_disk disk(connectivity(surface), squared_lengths);
  ASSERT_EQ(IT::flip_to_Delaunay(t).status, IT::Flip_status::DELAUNAY);
  EXPECT_TRUE(IT::verify_Delaunay(t).is_Delaunay());
  const IT::Edge_index e = symmetric_surfaces::diagonal_of_corners(t.connectivity(), surface);
  ASSERT_NE(e, IT::Edge_index());
  EXPECT_EQ(reference_sign(disk, t.connectivity(), e), CGAL::POSITIVE);
  EXPECT_EQ(t.sign_of_cotangent_weight(e), CGAL::POSITIVE);
  const IT::Halfedge_index h = t.connectivity().halfedge(e);
  const std::uint32_t end = t.connectivity().source(h).idx();
  ++number_of_diagonals[end == surface.corners[0] || end == surface.corners[2] ? 0 : 1];
  ASSERT_EQ(t.flip(e), Triangulation::Flip_outcome::FLIPPED);
  EXPECT_EQ(reference_sign(disk, t.connectivity(), e), CGAL::NEGATIVE);
  EXPECT_EQ(t.sign_of_cotangent_weight(e), CGAL::NEGATIVE);
  EXPECT_EQ(IT::flip_to_Delaunay(t).flips, 1u);
}

// The vertices in the middle of the list lie at the ends of folds that the hinge crosses.
TEST(Symmetric_ties, are_none_when_a_coordinate_differs_by_the_smallest_amount)
{
  std::array<int, 2> number_of_diagonals{};
  for (const Family& family : families())
    for (int folds : {4, 16})
      for (int axis : {0, 1, 2})
        for (double direction : {-1., 1.}) {
          SCOPED_TRACE(std::string(family.name) + " " + std::to_string(folds) + " " + std::to_string(axis));
          Surface surface = family.make(folds);
          double& x = surface.mesh.points[surface.mesh.points.size() / 2][std::size_t(axis)];
          x = std::nextafter(x, direction * std::numeric_limits<double>::infinity());
          expect_signs_of_reference(from_points(surface), surface, squared_lengths(surface), number_of_diagonals);
        }
  EXPECT_GT(number_of_diagonals[0], 20);
  EXPECT_GT(number_of_diagonals[1], 20);
}

// A fold that the hinge crosses is made longer or shorter.
TEST(Symmetric_ties, are_none_when_a_squared_length_differs_by_next_to_nothing)
{
  std::array<int, 2> number_of_diagonals{};
  for (const Family& family : families())
    for (int folds : {4, 12})
      for (int exponent : {40, 300, 3000})
        for (int direction : {-1, 1}) {
          SCOPED_TRACE(std::string(family.name) + " " + std::to_string(folds) + " " + std::to_string(exponent));
          const Surface surface = family.make(folds);
          std::vector<Rational> s = squared_lengths(surface);
          const IT::Delta_complex complex = connectivity(surface);
          std::size_t e = s.size() / 2;
          while (complex.is_border(IT::Edge_index(e)))
            ++e;
          s[e] += Rational(IT::internal::Integer(direction), IT::internal::Integer(1) << exponent);
          expect_signs_of_reference(from_lengths(surface, s), surface, s, number_of_diagonals);
        }
  EXPECT_GT(number_of_diagonals[0], 20);
  EXPECT_GT(number_of_diagonals[1], 20);
}

} // namespace
