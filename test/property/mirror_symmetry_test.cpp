// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The proof of a tie by congruence finds the ties of mirrored surfaces, and none that finite fields disprove.

#include "symmetric_surfaces.h"

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include "library/arithmetic/Residues.h"
#include "library/engine/decide/Exact_fallback.h"
#include "library/engine/decide/Mirror_symmetry.h"
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/squared_lengths.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using namespace IT::internal;
using symmetric_surfaces::connectivity;
using symmetric_surfaces::diagonal_of_corners;
using symmetric_surfaces::Surface;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

bool is_symmetric(const Triangulation& t, IT::Edge_index e)
{
  const IT::internal::Exact_engine& engine = IT::internal::engine(t);
  const auto surface = engine.input_surface();
  return Mirror_symmetry(t.connectivity(), engine.correspondence(), *surface)(e);
}

bool is_zero_in_finite_fields(const Triangulation& t, IT::Edge_index e)
{
  const IT::internal::Exact_engine& engine = IT::internal::engine(t);
  const auto lease = engine.input_surface();
  Input_surface& surface = *lease;
  Residue_rings rings(random_prime_fields(e.idx()), surface.interruption());
  Residue_metric metric(surface, {rings});
  const auto c =
    unfolded_corners(IT::internal::Unfolding<Residue_metric>(t.connectivity(), engine.correspondence(), metric),
                     corners_beside(t.connectivity(), e));
  const bool is_zero = (c.k.p * c.l.four_areas + c.l.p * c.k.four_areas).is_zero();
  EXPECT_TRUE(rings.is_defined());
  return is_zero;
}

IT::Edge_index edge_between(const IT::Delta_complex& complex, std::uint32_t p, std::uint32_t q)
{
  for (IT::Edge_index e : complex.edges())
    if (const auto h = complex.halfedge(e);
        std::minmax({complex.source(h).idx(), complex.target(h).idx()}) == std::minmax({p, q}))
      return e;
  return {};
}

struct Counts
{
  int symmetric = 0, other_ties = 0, bent = 0;
};

// At all edges between two faces.
void expect_agreement(const Triangulation& t, Counts& counts)
{
  for (IT::Edge_index e : t.connectivity().edges()) {
    if (!t.connectivity().is_flippable(e))
      continue;
    const bool is_tie = is_zero_in_finite_fields(t, e);
    if (is_symmetric(t, e)) {
      EXPECT_TRUE(is_tie) << "edge " << e.idx();
      ++counts.symmetric;
    } else
      ++(is_tie ? counts.other_ties : counts.bent);
  }
}

void flip_at_random(Triangulation& t, std::size_t number, std::mt19937& random)
{
  for (std::size_t i = 0; i < number; ++i) {
    const IT::Edge_index e(random() % t.connectivity().number_of_edges());
    if (t.connectivity().is_flippable(e))
      t.flip(e);
  }
}

TEST(Mirror_symmetry, is_found_across_any_number_of_folds)
{
  for (int folds : {1, 2, 3, 4, 6, 8, 10, 14, 20, 50, 100, 200}) {
    SCOPED_TRACE(folds);
    const Surface surface = symmetric_surfaces::mirrored_sheet(folds);
    Triangulation t(connectivity(surface), surface.mesh.points);
    IT::flip_to_Delaunay(t);
    const IT::Edge_index e = diagonal_of_corners(t.connectivity(), surface);
    EXPECT_TRUE(is_symmetric(t, e));
    EXPECT_TRUE(is_zero_in_finite_fields(t, e));
    ASSERT_EQ(t.flip(e), Triangulation::Flip_outcome::FLIPPED); // to the other diagonal
    EXPECT_TRUE(is_symmetric(t, e));
  }
}

// The folds of both halves are mirror images, the cuts in their planes are not.
TEST(Mirror_symmetry, does_not_depend_on_cuts_in_planes)
{
  for (int folds : {1, 2, 3, 5, 20}) {
    SCOPED_TRACE(folds);
    const Surface surface = symmetric_surfaces::mirrored_sheet(folds, true);
    Triangulation t(connectivity(surface), surface.mesh.points);
    IT::flip_to_Delaunay(t);
    const IT::Edge_index e = diagonal_of_corners(t.connectivity(), surface);
    EXPECT_TRUE(is_symmetric(t, e));
    ASSERT_EQ(t.flip(e), Triangulation::Flip_outcome::FLIPPED);
    EXPECT_TRUE(is_symmetric(t, e));
    // With lengths alone, planes are not known.
    Triangulation by_lengths = Triangulation::from_metric(
      connectivity(surface), IT::metric_from_squared_lengths(symmetric_surfaces::squared_lengths(surface)));
    IT::flip_to_Delaunay(by_lengths);
    EXPECT_FALSE(is_symmetric(by_lengths, diagonal_of_corners(by_lengths.connectivity(), surface)));
  }
}

// This proof does not see ties from other symmetries.
TEST(Mirror_symmetry, is_the_only_one_that_is_found)
{
  for (const Surface& surface : {symmetric_surfaces::quarter_turns(5), symmetric_surfaces::sixth_turns(5),
                                 symmetric_surfaces::half_turn(5), symmetric_surfaces::glided_sheet(5)}) {
    Triangulation t(connectivity(surface), surface.mesh.points);
    IT::flip_to_Delaunay(t);
    const IT::Edge_index e = diagonal_of_corners(t.connectivity(), surface);
    EXPECT_FALSE(is_symmetric(t, e));
    EXPECT_TRUE(is_zero_in_finite_fields(t, e));
  }
}

// Each edge in turn is made longer by next to nothing. Where the hinge crosses a triangle at that edge, the symmetry
// is lost, and so is the tie; but not where one half of the sheet is merely turned about an end of the fold in the
// middle, by one of the two edges that make up a triangle with it and are not crossed.
TEST(Mirror_symmetry, is_lost_with_any_length_that_matters)
{
  for (int folds : {2, 3, 6}) {
    SCOPED_TRACE(folds);
    const Surface surface = symmetric_surfaces::mirrored_sheet(folds);
    const std::vector<Rational> squared_lengths = symmetric_surfaces::squared_lengths(surface);
    int lost = 0, kept = 0;
    for (std::size_t i = 0; i < squared_lengths.size(); ++i) {
      std::vector<Rational> changed = squared_lengths;
      changed[i] += Rational(Integer(1), Integer(1) << 200);
      Triangulation t = Triangulation::from_metric(connectivity(surface), IT::metric_from_squared_lengths(changed));
      IT::flip_to_Delaunay(t);
      const IT::Edge_index e = diagonal_of_corners(t.connectivity(), surface);
      ASSERT_NE(e, IT::Edge_index());
      const bool is_found = is_symmetric(t, e);
      EXPECT_EQ(is_found, is_zero_in_finite_fields(t, e)) << "input edge " << i;
      ++(is_found ? kept : lost);
    }
    EXPECT_EQ(kept, 3); // these two, and the fold in the middle, which belongs to both halves
    EXPECT_EQ(lost, 8 * folds + 6);
  }
}

TEST(Mirror_symmetry, agrees_with_finite_fields_after_random_flips)
{
  std::mt19937 random(1);
  Counts counts;
  for (int folds : {2, 4, 7})
    for (int i = 0; i < 6; ++i) {
      const Surface surface = symmetric_surfaces::mirrored_sheet(folds);
      Triangulation t(connectivity(surface), surface.mesh.points);
      flip_at_random(t, std::size_t(5 * i) * surface.mesh.triangles.size(), random);
      expect_agreement(t, counts);
      IT::flip_to_Delaunay(t);
      expect_agreement(t, counts);
    }
  EXPECT_GE(counts.symmetric, 18); // one after each run
  EXPECT_GT(counts.bent, 300);
}

// Few lengths, so that many triangles are congruent, many hinges are squares and rhombi, and parts of strips and of
// fans equal each other by chance.
TEST(Mirror_symmetry, agrees_with_finite_fields_where_lengths_coincide)
{
  std::mt19937 random(2);
  Counts counts;
  for (std::uint64_t seed = 0; seed < 4000 && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    const samples::Glued_triangles gluing = samples::random_gluing(2 + 2 * (seed % 5), seed, seed % 3 == 0);
    IT::Delta_complex complex = IT::make_Delta_complex_from_gluing(gluing.number_of_faces, gluing.glued_sides);
    std::vector<Rational> squared_lengths(complex.number_of_edges());
    for (Rational& s : squared_lengths)
      s = random() % 3 == 0 ? 2 : 1;
    Triangulation t = Triangulation::from_metric(std::move(complex), IT::metric_from_squared_lengths(squared_lengths));
    expect_agreement(t, counts);
    for (int i = 0; i < 3; ++i) {
      flip_at_random(t, 3, random);
      expect_agreement(t, counts);
    }
  }
  EXPECT_GT(counts.symmetric, 150);
  EXPECT_GT(counts.other_ties, 1000);
  EXPECT_GT(counts.bent, 10000);
}

// Fans whose triangles are of few kinds, in any order: with few lengths of spokes and of rim edges.
TEST(Mirror_symmetry, agrees_with_finite_fields_in_fans)
{
  std::mt19937 random(3);
  Counts counts;
  for (unsigned run = 0; run < 300 && !HasFailure(); ++run) {
    SCOPED_TRACE(run);
    const std::uint32_t size = 6 + random() % 12;
    const bool is_closed = run % 2 == 1;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (std::uint32_t i = 0; i < size; ++i)
      triangles.push_back({0, 1 + i, is_closed && i + 1 == size ? 1 : 2 + i});
    IT::Delta_complex complex = IT::make_Delta_complex_from_triangles(is_closed ? size + 1 : size + 2, triangles);
    std::vector<Rational> squared_lengths;
    for (IT::Edge_index e : complex.edges()) {
      const IT::Halfedge_index h = complex.halfedge(e);
      const bool is_spoke = complex.source(h).idx() == 0 || complex.target(h).idx() == 0;
      squared_lengths.emplace_back(is_spoke ? 9 + random() % 2 : 1 + random() % (2 + run % 3));
    }
    Triangulation t = Triangulation::from_metric(std::move(complex), IT::metric_from_squared_lengths(squared_lengths));
    for (int i = 0; i < 6; ++i) {
      flip_at_random(t, 4, random);
      expect_agreement(t, counts);
    }
  }
  EXPECT_GT(counts.symmetric, 100);
  EXPECT_GT(counts.other_ties, 300);
  EXPECT_GT(counts.bent, 10000);
}

// Grids with few heights, and with either diagonal in each of their rectangles: edges cross the polygons of planes, in
// which few diagonals are mirror images. In every second grid the folds are parallel.
TEST(Mirror_symmetry, agrees_with_finite_fields_across_planes)
{
  std::mt19937 random(4);
  Counts counts;
  for (unsigned run = 0; run < 200 && !HasFailure(); ++run) {
    SCOPED_TRACE(run);
    const std::uint32_t rows = 2 + random() % 3, columns = 2 + random() % 5, number_of_heights = 1 + run % 3;
    const double width = 1 + random() % 3, height = 1 + random() % 2;
    samples::Indexed_triangles mesh;
    const auto vertex = [&](std::uint32_t i, std::uint32_t j) { return j * (columns + 1) + i; };
    for (std::uint32_t j = 0; j <= rows; ++j)
      for (std::uint32_t i = 0; i <= columns; ++i) {
        const double z = run % 2 == 0 && j > 0 ? mesh.points[i][2] : double(random() % number_of_heights);
        mesh.points.push_back({width * i, height * j, z});
      }
    for (std::uint32_t j = 0; j < rows; ++j)
      for (std::uint32_t i = 0; i < columns; ++i) {
        const std::uint32_t a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1), d = vertex(i, j + 1);
        const bool is_rising = random() % 2 == 0;
        mesh.triangles.push_back({a, b, is_rising ? c : d});
        mesh.triangles.push_back({is_rising ? a : b, c, d});
      }
    Triangulation t(IT::make_Delta_complex_from_triangles(mesh.points.size(), mesh.triangles), mesh.points);
    for (int i = 0; i < 6; ++i) {
      flip_at_random(t, 6, random);
      expect_agreement(t, counts);
    }
  }
  EXPECT_GT(counts.symmetric, 5000);
  EXPECT_GT(counts.other_ties, 100);
  EXPECT_GT(counts.bent, 10000);
}

// Four folds, and between the first two and the last two of them a quadrilateral. A corner of the eastern one is as
// much above π as it would be below it if that was the mirror image of the western one: the cosine is the same.
Surface sheet_with_quadrilaterals(bool is_mirrored)
{
  const double turn = is_mirrored ? -0.5 : 0.5;
  symmetric_surfaces::Sheet sheet;
  // Of the folds, from west to east:
  const std::array<std::uint32_t, 4> top{sheet.add({-1, 64, 0}), sheet.add({-1, 128, 0}), sheet.add({1, 128, 0}),
                                         sheet.add({1, 64, 0})};
  const std::array<std::uint32_t, 4> bottom{sheet.add({-0.5, -64, -0.125}), sheet.add({-0.25, -64, -0.1875}),
                                            sheet.add({0.25, -64, -0.1875}), sheet.add({1 + turn, -64, turn / 4})};
  // The triangles at both ends are congruent. (Where they lie in space does not matter to the layout.)
  const double east = is_mirrored ? -1 : 1;
  const std::array<std::uint32_t, 4> corners{
    sheet.add({-1 + 0.75, 64 - 63.6875, -0.25}), sheet.add({-1 + 0.75, 64 - 64.3125, -0.5}),
    sheet.add({1 + east * 0.75, 64 - 64.3125, east * 0.5}), sheet.add({1 + east * 0.75, 64 - 63.6875, east * 0.25})};
  sheet.add_triangle(corners[1], top[0], corners[0]);
  sheet.add_triangle(corners[1], bottom[0], top[0]);
  sheet.add_triangle(top[0], bottom[0], bottom[1]);
  sheet.add_triangle(top[0], bottom[1], top[1]);
  sheet.add_triangle(top[1], bottom[1], top[2]);
  sheet.add_triangle(bottom[1], bottom[2], top[2]);
  sheet.add_triangle(top[2], bottom[2], top[3]);
  sheet.add_triangle(bottom[2], bottom[3], top[3]);
  sheet.add_triangle(top[3], bottom[3], corners[2]);
  sheet.add_triangle(top[3], corners[2], corners[3]);
  return sheet.finish(corners);
}

TEST(Mirror_symmetry, distinguishes_angles_with_the_same_cosine)
{
  for (bool is_mirrored : {true, false}) {
    const Surface surface = sheet_with_quadrilaterals(is_mirrored);
    Triangulation t(connectivity(surface), surface.mesh.points);
    IT::flip_to_Delaunay(t);
    const IT::Edge_index e = diagonal_of_corners(t.connectivity(), surface);
    ASSERT_TRUE(e.is_valid());
    EXPECT_EQ(is_symmetric(t, e), is_mirrored);
    EXPECT_EQ(is_zero_in_finite_fields(t, e), is_mirrored);
  }
}

// Spokes of two lengths in turn, so that triangles can be in any order. Between vertices 0, 3, 5 and 8 of the rim there
// are three triangles, two and three.
Triangulation fan(const std::array<int, 8>& squared_lengths_of_rim)
{
  constexpr std::uint32_t hub = 9;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::uint32_t i = 0; i < 8; ++i)
    triangles.push_back({hub, i, i + 1});
  IT::Delta_complex complex = IT::make_Delta_complex_from_triangles(hub + 1, triangles);
  std::vector<Rational> squared_lengths;
  for (IT::Edge_index e : complex.edges()) {
    const IT::Halfedge_index h = complex.halfedge(e);
    const auto [i, j] = std::minmax({complex.source(h).idx(), complex.target(h).idx()});
    squared_lengths.emplace_back(j == hub ? 900 + int(i % 2) : squared_lengths_of_rim[i]);
  }
  Triangulation t = Triangulation::from_metric(std::move(complex), IT::metric_from_squared_lengths(squared_lengths));
  for (std::uint32_t i : {1, 2, 4, 6, 7, 3, 5}) // from the spokes of a polygon to 0-3, 3-5, 5-8, 0-5, 0-8
    EXPECT_EQ(t.flip(edge_between(t.connectivity(), i, hub)), Triangulation::Flip_outcome::FLIPPED);
  return t;
}

TEST(Mirror_symmetry, of_an_angle_does_not_depend_on_the_order_of_its_parts)
{
  const auto is_found = [](const std::array<int, 8>& squared_lengths_of_rim) {
    const Triangulation t = fan(squared_lengths_of_rim);
    const IT::Edge_index e = edge_between(t.connectivity(), 0, 5);
    const bool result = is_symmetric(t, e);
    EXPECT_EQ(result, is_zero_in_finite_fields(t, e));
    return result;
  };
  EXPECT_TRUE(is_found({11, 13, 17, 19, 23, 17, 13, 11})); // as in a mirror
  EXPECT_TRUE(is_found({11, 13, 17, 19, 23, 11, 13, 17}));
  EXPECT_TRUE(is_found({11, 11, 17, 19, 23, 11, 17, 11}));
  EXPECT_FALSE(is_found({11, 11, 17, 19, 23, 11, 17, 17}));
  EXPECT_FALSE(is_found({11, 13, 17, 19, 23, 11, 13, 19}));
}

} // namespace
