// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lines that become edges: their vertices, their places, and lines that cannot be drawn.

#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/surface_features.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using V = IT::Vertex_index;

// A unit square with the diagonal from 0 to 2.
struct Square
{
  std::vector<std::array<double, 3>> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  IT::Delta_complex complex =
    IT::make_Delta_complex_from_triangles(4, std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {0, 2, 3}});
  IT::Line_divider divider{complex, points};
};

TEST(Line_divider, a_line_from_a_corner_across_the_diagonal_into_a_face)
{
  Square s;
  s.divider.add_point({{V(1), 1}});
  s.divider.add_point({{V(0), 0.75}, {V(2), 0.25}});
  s.divider.add_point({{V(0), 0.25}, {V(2), 0.25}, {V(3), 0.5}});
  ASSERT_EQ(s.complex.number_of_vertices(), 6u);
  EXPECT_EQ(s.complex.number_of_faces(), 6u);
  EXPECT_EQ(s.points[4], (std::array<double, 3>{0.25, 0.25, 0}));
  EXPECT_EQ(s.points[5], (std::array<double, 3>{0.25, 0.75, 0}));
  const std::vector<bool> edges = s.divider.edges();
  std::vector<std::array<std::uint32_t, 2>> ends;
  for (IT::Edge_index e : s.complex.edges())
    if (edges[e.idx()]) {
      const IT::Halfedge_index h = s.complex.halfedge(e);
      ends.push_back({std::min(s.complex.source(h), s.complex.target(h)).idx(),
                      std::max(s.complex.source(h), s.complex.target(h)).idx()});
    }
  std::sort(ends.begin(), ends.end());
  EXPECT_EQ(ends, (std::vector<std::array<std::uint32_t, 2>>{{1, 4}, {4, 5}}));
}

TEST(Line_divider, both_parts_of_a_kept_edge_are_kept)
{
  Square s;
  s.divider.add_edge(V(0), V(2));
  s.divider.add_point({{V(1), 1}});
  s.divider.add_point({{V(0), 0.5}, {V(2), 0.5}});
  const std::vector<bool> edges = s.divider.edges();
  EXPECT_EQ(std::count(edges.begin(), edges.end(), true), 3);
}

// The total length of the edges that lines became.
double length(const Square& s)
{
  const std::vector<bool> edges = s.divider.edges();
  double sum = 0;
  for (IT::Edge_index e : s.complex.edges())
    if (edges[e.idx()]) {
      const auto &p = s.points[s.complex.source(s.complex.halfedge(e)).idx()],
                 &q = s.points[s.complex.target(s.complex.halfedge(e)).idx()];
      sum += std::hypot(q[0] - p[0], q[1] - p[1]);
    }
  return sum;
}

TEST(Line_divider, lines_begin_and_end_in_one_face)
{
  Square s;
  s.divider.add_point({{V(0), 0.6}, {V(1), 0.3}, {V(2), 0.1}});
  s.divider.add_point({{V(2), 0.6}, {V(0), 0.1}, {V(1), 0.3}});
  EXPECT_TRUE(s.complex.is_valid());
  EXPECT_NEAR(length(s), 0.5 * std::sqrt(2.), 1e-15);
}

// Twenty random ones, within faces, along edges, and across the diagonal, and some from vertex to vertex.
TEST(Line_divider, lines_cross_each_other)
{
  std::mt19937 random(5);
  const auto number = [&] { return double(random()) / 4294967296.; };
  for (int i = 0; i < 20; ++i) {
    Square s;
    double sum = 0;
    for (int line = 0; line < 20; ++line) {
      s.divider.begin_line();
      const double x = number(), y = number(), a = number();
      // From (x, x), or a corner, in the lower triangle or the upper one, to a point inside.
      const V third(line % 2 == 0 ? 1 : 3);
      const std::array<double, 2> from{line % 5 == 0 ? 1 : x, line % 5 == 0 ? 1 : x};
      if (line % 5 == 0)
        s.divider.add_point({{V(2), 1}});
      else
        s.divider.add_point({{V(0), 1 - x}, {V(2), x}});
      const double at_third = a * y, at_2 = a - at_third;
      s.divider.add_point({{third, at_third}, {V(2), at_2}, {V(0), 1 - a}});
      const std::array<double, 2> to{at_2 + (third.idx() == 1 ? at_third : 0),
                                     at_2 + (third.idx() == 3 ? at_third : 0)};
      sum += std::hypot(to[0] - from[0], to[1] - from[1]);
      ASSERT_TRUE(s.complex.is_valid());
    }
    EXPECT_NEAR(length(s), sum, 1e-9);
    EXPECT_EQ(s.points.size(), s.complex.number_of_vertices());
    s.divider.add_edge(V(2), V(0)); // which was cut
    EXPECT_NEAR(length(s), sum + std::sqrt(2.), 1e-9);
  }
}

TEST(Line_divider, points_that_differ_by_rounding_are_one)
{
  Square s;
  s.divider.add_point({{V(0), 1}, {V(1), 1e-13}, {V(2), 1e-14}});
  s.divider.add_point({{V(0), 0.5}, {V(2), 0.5}});
  s.divider.begin_line();
  s.divider.add_point({{V(0), 0.5}, {V(2), 0.5 + 1e-14}, {V(3), 1e-14}});
  s.divider.add_point({{V(3), 1}});
  EXPECT_EQ(s.points.size(), 5u);
  EXPECT_NEAR(length(s), std::sqrt(2.), 1e-12);
}

TEST(Line_divider, refuses_what_is_no_line_on_the_surface)
{
  Square s;
  EXPECT_THROW(s.divider.add_edge(V(1), V(3)), IT::Invalid_point_error);
  EXPECT_THROW(s.divider.add_point({{V(1), 0.5}, {V(3), 0.5}}), IT::Invalid_point_error);
  EXPECT_THROW(s.divider.add_point({{V(1), 0.5}, {V(3), 0.25}, {V(0), 0.25}}), IT::Invalid_point_error);
  s.divider.add_point({{V(0), 0.5}, {V(1), 0.5}});
  EXPECT_THROW(s.divider.add_point({{V(3), 1}}), IT::Invalid_point_error);
}

} // namespace
