// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The proof of a tie by congruence finds the ties of mirrored surfaces, and nothing that finite fields
// show to be no tie.

#include "symmetric_surfaces.h"

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Residues.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/decide/Exact_fallback.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/decide/Mirror_symmetry.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Input_metric.h>

#include <gtest/gtest.h>

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

// Other symmetries make ties that are not seen by this proof.
TEST(Mirror_symmetry, of_the_triangles_is_needed)
{
  for (const Surface& surface :
       {symmetric_surfaces::mirrored_sheet(5, true), symmetric_surfaces::quarter_turns(5),
        symmetric_surfaces::sixth_turns(5), symmetric_surfaces::half_turn(5), symmetric_surfaces::glided_sheet(5)}) {
    Triangulation t(connectivity(surface), surface.mesh.points);
    IT::flip_to_Delaunay(t);
    const IT::Edge_index e = diagonal_of_corners(t.connectivity(), surface);
    EXPECT_FALSE(is_symmetric(t, e));
    EXPECT_TRUE(is_zero_in_finite_fields(t, e));
  }
}

// Each edge in turn is made longer by next to nothing. Where the hinge crosses a triangle at that edge, the symmetry
// is lost, and so is the tie; but not if one half of the sheet is merely turned about an end of the fold
// in the middle, by one of the two edges that make up a triangle with it and are not crossed.
TEST(Mirror_symmetry, is_lost_with_any_length_that_matters)
{
  for (int folds : {2, 3, 6}) {
    SCOPED_TRACE(folds);
    const Surface surface = symmetric_surfaces::mirrored_sheet(folds);
    const std::vector<Rational> squared_lengths = symmetric_surfaces::squared_lengths(surface);
    int lost = 0, kept = 0, turned = 0;
    for (std::size_t i = 0; i < squared_lengths.size(); ++i) {
      std::vector<Rational> changed = squared_lengths;
      changed[i] += Rational(Integer(1), Integer(1) << 200);
      Triangulation t = Triangulation::from_metric(connectivity(surface), IT::metric_from_squared_lengths(changed));
      IT::flip_to_Delaunay(t);
      const IT::Edge_index e = diagonal_of_corners(t.connectivity(), surface);
      ASSERT_NE(e, IT::Edge_index());
      const bool is_found = is_symmetric(t, e), is_tie = is_zero_in_finite_fields(t, e);
      EXPECT_TRUE(is_tie || !is_found) << "input edge " << i;
      ++(is_found ? kept : is_tie ? turned : lost);
    }
    EXPECT_EQ(turned, 2);
    EXPECT_EQ(kept, 1); // the fold in the middle, which belongs to both halves
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

} // namespace
