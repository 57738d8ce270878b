// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The cotangents and areas of faces laid out in doubles: within their bounds of those laid out in double-doubles.

#include "flip_test_surfaces.h"
#include "insert_random_vertices.h"
#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/internal/engine/Engine_numbers.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace {

using namespace test_surfaces;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

// Counts over all faces.
struct Count
{
  std::size_t known = 0, precise = 0, areas = 0, all = 0; // three cotangents for each area
};

void expect_bounds_that_hold(const Triangulation& t, Count& count)
{
  const IT::Delta_complex& complex = t.connectivity();
  const IT::internal::Engine_numbers numbers(IT::internal::engine(t));
  for (IT::Face_index f : complex.faces()) {
    IT::internal::Engine_numbers::Rounded_face_cotangents rounded;
    IT::internal::Engine_numbers::Face_cotangents precise;
    numbers.find_cotangents(f, rounded);
    numbers.find_cotangents(f, precise);
    const auto area = numbers.rounded_four_areas(f);
    const auto precise_area = numbers.corner(complex.halfedge(f)).four_areas;
    count.areas += area.error() < 0x1p-32 * area.hi();
    const double area_difference = (area.hi() - precise_area.hi()) - precise_area.lo();
    ASSERT_LE(std::abs(area_difference), 1.0001 * (area.error() + precise_area.error())) << f;
    for (std::size_t i = 0; i < 3; ++i) {
      ++count.all;
      if (!std::isfinite(rounded[i].error()) || !std::isfinite(precise[i].error()))
        continue;
      ++count.known;
      count.precise += rounded[i].error() < 0x1p-34 * (1 + std::abs(rounded[i].hi()));
      const double difference = (rounded[i].hi() - precise[i].hi()) - precise[i].lo();
      ASSERT_LE(std::abs(difference), 1.0001 * (rounded[i].error() + precise[i].error())) << f << ' ' << i;
    }
  }
}

std::vector<Surface> surfaces()
{
  std::vector<Surface> result = generic_surfaces(false);
  for (Surface& surface : std::vector<Surface>{
         from_triangles("sliver sheet", samples::sliver_sheet(12)), from_triangles("pillow", samples::pillow(30)),
         from_triangles("strip", samples::strip(100, 20)), from_triangles("prism", samples::prism()),
         from_triangles("twisted dome", samples::bumpy_dome()), from_triangles("cap", samples::cap(0x1p-30)),
         from_triangles("grid", samples::random_diagonal_grid(12, 9, 1, 1))})
    result.push_back(std::move(surface));
  return result;
}

TEST(Rounded_cotangents, bounds_hold)
{
  Count count;
  for (const Surface& surface : surfaces()) {
    SCOPED_TRACE(surface.name);
    auto t = triangulation<IT::Filtered_edge_length_traits>(surface);
    ASSERT_NO_FATAL_FAILURE(expect_bounds_that_hold(t, count)); // of input faces
    IT::flip_to_Delaunay(t);
    ASSERT_NO_FATAL_FAILURE(expect_bounds_that_hold(t, count));
  }
  EXPECT_GT(count.known, count.all * 9 / 10); // an infinite error would be a bound, too
  EXPECT_GT(count.precise, count.all * 9 / 10);
  EXPECT_GT(count.areas, count.all * 3 / 10);
}

TEST(Rounded_cotangents, bounds_hold_with_inserted_vertices)
{
  Count count;
  std::mt19937 random(3);
  for (const Surface& surface : surfaces()) {
    SCOPED_TRACE(surface.name);
    auto t = triangulation<IT::Filtered_edge_length_traits>(surface);
    IT::flip_to_Delaunay(t);
    IT::insert_random_vertices(t, 20, 1000, random);
    IT::flip_to_Delaunay(t);
    ASSERT_NO_FATAL_FAILURE(expect_bounds_that_hold(t, count));
  }
  EXPECT_GT(count.precise, count.all / 2);
}

} // namespace
