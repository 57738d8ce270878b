// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Long computations report progress, in order and to the end, and stop on request at any time.

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

Triangulation Delaunay_triangulation(const samples::Indexed_triangles& surface)
{
  Triangulation t(IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles), surface.points,
                  IT::Filtered_edge_length_traits());
  IT::flip_to_Delaunay(t);
  return t;
}

// \param compute function(progress) that makes the computation
// \param number how often it asks at least
template <class Compute>
void expect_progress(const Compute& compute, std::size_t number)
{
  std::vector<double> fractions;
  compute([&](double fraction) {
    fractions.push_back(fraction);
    return true;
  });
  ASSERT_GE(fractions.size(), number);
  EXPECT_EQ(fractions.front(), 0);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_LE(fractions.back(), 1);
  for (std::size_t stop = 1; stop <= fractions.size(); ++stop) {
    std::size_t asked = 0;
    EXPECT_THROW(compute([&](double) { return ++asked < stop; }), IT::Cancelled_error);
    EXPECT_EQ(asked, stop);
  }
}

TEST(Progress, overlay)
{
  const Triangulation t = Delaunay_triangulation(samples::bad_torus(60, 60));
  ASSERT_GT(t.connectivity().number_of_edges(), 10000u);
  const IT::Overlay overlay(t);
  expect_progress([&](const IT::Progress_function& progress) { IT::Overlay(t, CGAL::parameters::visitor(progress)); },
                  8);
  const auto find_positions = [&](const IT::Progress_function& progress) {
    IT::Overlay_positions(IT::internal::engine(t), overlay, progress);
  };
  expect_progress(find_positions, 3);
  expect_progress(
    [&](const IT::Progress_function& progress) { IT::Common_subdivision(t, CGAL::parameters::visitor(progress)); }, 11);
}

} // namespace
