// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangulations that are copied, moved and assigned between flips and queries continue like their sources.

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/verify_Delaunay.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

Triangulation triangulation(const samples::Indexed_triangles& surface)
{
  return {IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles), surface.points};
}

// Queries every edge, to fill all caches.
void ask(Triangulation& t)
{
  for (IT::Edge_index e : t.connectivity().edges())
    if (t.connectivity().is_flippable(e))
      IT::internal::Whole_triangulation<Triangulation::Traits>(t).test_and_recompute(e);
}

void flip_some(Triangulation& t, std::uint64_t number)
{
  IT::flip_to_Delaunay(t, CGAL::parameters::maximum_number(number));
}

// (A copy of t would not do: caches are not copied.)
void expect_same_end(Triangulation& t, Triangulation original)
{
  IT::flip_to_Delaunay(t);
  IT::flip_to_Delaunay(original);
  EXPECT_TRUE(t.connectivity() == original.connectivity());
  EXPECT_TRUE(IT::verify_Delaunay(t).not_Delaunay.empty());
  for (IT::Edge_index e : t.connectivity().edges()) {
    EXPECT_EQ(t.length(e), original.length(e));
    EXPECT_EQ(IT::internal::engine(t).correspondence().coordinates().crossings(e),
              IT::internal::engine(original).correspondence().coordinates().crossings(e));
  }
}

const std::vector<samples::Indexed_triangles>& surfaces()
{
  static const std::vector<samples::Indexed_triangles> all{samples::prism(12, 5), samples::bad_torus(12, 10),
                                                           samples::pillow(30), samples::bumpy_sphere(30, 16)};
  return all;
}

} // namespace

TEST(Assignment, OverATriangulationThatWasAsked)
{
  for (const samples::Indexed_triangles& from : surfaces())
    for (const samples::Indexed_triangles& to : surfaces())
      for (std::uint64_t flips : {0, 3, 1000}) {
        Triangulation source = triangulation(from), target = triangulation(to);
        flip_some(target, 1000);
        ask(target);
        flip_some(source, flips);
        if (flips == 3)
          ask(source);
        target = source;
        expect_same_end(target, source);
        Triangulation moved = triangulation(to);
        ask(moved);
        moved = std::move(target);
        expect_same_end(moved, source);
      }
}

TEST(Assignment, CopiesGoTheirOwnWays)
{
  for (const samples::Indexed_triangles& surface : surfaces()) {
    Triangulation t = triangulation(surface);
    for (int step = 0; step < 6; ++step) {
      const IT::Delta_complex before = t.connectivity();
      Triangulation copy = t;
      flip_some(copy, 2);
      if (step % 2 == 1)
        ask(copy);
      EXPECT_TRUE(t.connectivity() == before);
      Triangulation end = t;
      expect_same_end(end, t);
      end = copy;
      expect_same_end(end, copy);
      t = std::move(copy);
    }
  }
}
