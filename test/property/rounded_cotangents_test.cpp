// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The cotangents and areas of faces laid out in doubles, and those found by repeating all flips: within their bounds of
// those laid out in double-doubles.

#include "flip_test_surfaces.h"
#include "insert_random_vertices.h"
#include "library/engine/Repeated_flips.h"
#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/internal/engine/Engine_numbers.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/insert_vertex.h>
#include <CGAL/Intrinsic_triangulations/triangulation_io.h>

#include <CGAL/property_map.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <sstream>
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

// A bent sheet of stretched triangles: most edges are flipped, some many times, until stored numbers tell little.
Surface stretched_sheet(std::size_t n)
{
  samples::Indexed_triangles sheet = samples::random_diagonal_grid(n, n);
  std::mt19937 random(5);
  for (auto& p : sheet.points) {
    const double x = p[0] + 0x1p-34 * random(), y = p[1] + 0x1p-34 * random();
    p = {200 * x, y, 3 * std::sin(x / 4) * std::cos(y / 4)};
  }
  return from_triangles("stretched sheet", sheet);
}

TEST(Rounded_cotangents, repeated_flips_give_the_numbers_of_layouts)
{
  std::size_t known = 0;
  std::vector<Surface> all = surfaces();
  all.push_back(stretched_sheet(30));
  for (const Surface& surface : all) {
    SCOPED_TRACE(surface.name);
    auto t = triangulation<IT::Filtered_edge_length_traits>(surface);
    IT::flip_to_Delaunay(t);
    const IT::internal::Exact_engine& engine = IT::internal::engine(t);
    const IT::Delta_complex& complex = t.connectivity();
    const IT::internal::Repeated_flips flips(complex, engine.log(), engine.metric(), engine.decisions().interruption);
    for (IT::Halfedge_index h : complex.halfedges()) {
      const auto found = complex.is_border(h) ? std::nullopt : flips.corner(complex, h, 0x1p-40);
      if (!found)
        continue;
      ++known;
      const auto expected = IT::internal::Engine_numbers(engine).corner(h);
      const auto expect_same = [](const auto& a, const auto& b) {
        EXPECT_LE(std::abs((a - b).hi()), 1.0001 * (a - b).error());
      };
      expect_same(found->p, expected.p);
      expect_same(found->four_areas, expected.four_areas);
      expect_same(found->s_first, expected.s_first);
      expect_same(found->s_second, expected.s_second);
      expect_same(found->s_opposite, expected.s_opposite);
    }
  }
  EXPECT_GT(known, 4000u);
}

// Flips that follow, and vertices that are inserted, do not meet numbers of before.
TEST(Rounded_cotangents, weights_and_areas_follow_each_change)
{
  auto t = triangulation<IT::Filtered_edge_length_traits>(stretched_sheet(20));
  std::mt19937 random(1);
  const auto expect_right = [&] {
    const std::vector<double> weights = IT::cotangent_weights(t), areas = IT::face_areas(t);
    for (IT::Edge_index e : t.connectivity().edges())
      EXPECT_NEAR(weights[e.idx()], t.cotangent_weight(e), 0x1p-31 * (1 + std::abs(t.cotangent_weight(e)))) << e;
    for (IT::Face_index f : t.connectivity().faces())
      EXPECT_NEAR(areas[f.idx()], t.area(f), 0x1p-32 * t.area(f)) << f;
  };
  IT::flip_to_Delaunay(t);
  expect_right();
  for (unsigned i = 0; i < 40; ++i) {
    const IT::Edge_index e(unsigned(random() % t.connectivity().number_of_edges()));
    if (t.connectivity().is_flippable(e))
      t.flip(e);
    if (i % 8 == 0)
      expect_right();
  }
  const auto copy = t;
  IT::flip_to_Delaunay(t);
  expect_right();
  IT::element_numbers(t);
  // No flip follows, which would make it forget as well.
  IT::insert_vertex(
    t, {t.input().halfedge(IT::Face_index(7)), {1, 1, 1}},
    CGAL::parameters::edge_is_constrained_map(CGAL::Static_boolean_property_map<IT::Edge_index, true>()));
  std::stringstream file;
  IT::write_triangulation(file, t);
  EXPECT_EQ(IT::face_areas(t), IT::face_areas(IT::read_triangulation(file)));
  expect_right();
  IT::insert_random_vertices(t, 5, 1000, random);
  expect_right();
  t = copy;
  expect_right();
}

} // namespace
