// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sharp edges: those of a box, one where a sliver lies between two sides, and no chain that is too short to matter.

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/surface_features.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Points = std::vector<std::array<double, 3>>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

struct Sharp_edges
{
  std::size_t number = 0;
  double length = 0;
};

Sharp_edges sharp_edges(const Points& points, const Triangles& triangles, double degrees, double minimum_size = 0)
{
  const IT::Delta_complex complex = IT::make_Delta_complex_from_triangles(points.size(), triangles);
  const std::vector<bool> is_sharp = IT::sharp_edges(complex, points, degrees, minimum_size);
  Sharp_edges result;
  for (IT::Edge_index e : complex.edges())
    if (is_sharp[e.idx()]) {
      const auto &p = points[complex.source(complex.halfedge(e)).idx()],
                 &q = points[complex.target(complex.halfedge(e)).idx()];
      ++result.number;
      result.length += std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    }
  return result;
}

// A horizontal and a vertical side of a part, each a strip of n squares 1 wide, and between them a strip of slivers of
// this width that stands at a random angle, as far as its coordinates let it.
void make_seam(std::uint32_t n, double width, Points& points, Triangles& triangles)
{
  points.clear();
  triangles.clear();
  const std::array<std::array<double, 2>, 4> profile = {{{-1, 0}, {0, 0}, {width, -width / 3}, {width, -1}}}; // y and z
  for (std::uint32_t i = 0; i <= n; ++i)
    for (std::size_t row = 0; row < 4; ++row)
      points.push_back({double(i), profile[row][0] - (row == 2 && i % 2 == 1 ? width : 0), profile[row][1]});
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t row = 0; row < 3; ++row) {
      const std::uint32_t a = 4 * i + row, b = a + 4;
      triangles.push_back({a, b, b + 1});
      triangles.push_back({a, b + 1, a + 1});
    }
}

TEST(Sharp_edges, are_those_of_a_box)
{
  Points points;
  for (int i = 0; i < 8; ++i)
    points.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2)});
  const Triangles triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                               {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  EXPECT_EQ(sharp_edges(points, triangles, 89).number, 12u);
  EXPECT_EQ(sharp_edges(points, triangles, 91).number, 0u);
  EXPECT_EQ(sharp_edges(points, triangles, 0).number, 12u);
  // Neither large nor small numbers overflow.
  for (double scale : {1e-300, 1e300}) {
    Points scaled = points;
    for (auto& p : scaled)
      for (double& x : p)
        x *= scale;
    EXPECT_EQ(sharp_edges(scaled, triangles, 30).number, 12u);
  }
}

TEST(Sharp_edges, lie_on_one_side_of_slivers)
{
  Points points;
  Triangles triangles;
  make_seam(10, 0x1p-10, points, triangles);
  // Wide enough to have directions of their own.
  EXPECT_GT(sharp_edges(points, triangles, 30).length, 15);
  const Sharp_edges sharp = sharp_edges(points, triangles, 30, 0.01);
  EXPECT_NEAR(sharp.length, 10, 0.05);
}

// Without a smallest size, a few units in the last place do not count as a width.
TEST(Sharp_edges, ignore_normals_that_rounding_made)
{
  Points points;
  Triangles triangles;
  make_seam(10, 0x1p-21, points, triangles);
  for (auto& p : points)
    for (double& x : p)
      x = double(float(x));
  EXPECT_EQ(IT::coordinate_spacing(points), 0x1p-20); // coordinates up to 10
  EXPECT_NEAR(sharp_edges(points, triangles, 30).length, 10, 1e-3);
  // In doubles, that is a width as any other.
  for (auto& p : points)
    for (double& x : p)
      x *= 1.1;
  EXPECT_EQ(IT::coordinate_spacing(points), 0x1p-49);
  EXPECT_GT(sharp_edges(points, triangles, 30).length, 15);
}

// Two sides at a right angle that touch along an edge of length 0.01.
TEST(Sharp_edges, have_chains_that_matter)
{
  const Points points = {{0, 0, 0}, {0.01, 0, 0}, {0, -1, 0}, {-1, -0.5, 0}, {0, 0, 1}, {-1, 0, 0.5}};
  const Triangles triangles = {{1, 0, 2}, {0, 3, 2}, {0, 1, 4}, {0, 4, 5}};
  EXPECT_EQ(sharp_edges(points, triangles, 30).number, 1u);
  EXPECT_EQ(sharp_edges(points, triangles, 30, 0.005).number, 1u);
  EXPECT_EQ(sharp_edges(points, triangles, 30, 0.1).number, 0u);
}

TEST(Sharp_edges, need_directions)
{
  // Faces without area, and nothing else.
  const Points points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  EXPECT_EQ(sharp_edges(points, {{0, 1, 2}, {1, 0, 3}}, 0).number, 0u);
  EXPECT_EQ(IT::coordinate_spacing({}), 0);
  EXPECT_EQ(IT::coordinate_spacing({{0, 0, 0}}), 0);
}

} // namespace
