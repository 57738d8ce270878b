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
#include <cstdint>
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

TEST(Line_divider, refuses_what_is_no_line_on_the_surface)
{
  Square s;
  EXPECT_THROW(s.divider.add_edge(V(1), V(3)), IT::Invalid_point_error);
  EXPECT_THROW(s.divider.add_point({{V(1), 0.5}, {V(3), 0.5}}), IT::Invalid_point_error);
  s.divider.add_point({{V(0), 0.5}, {V(2), 0.5}});
  EXPECT_THROW(s.divider.add_point({{V(0), 0.25}, {V(2), 0.75}}), IT::Invalid_point_error);
  s.divider.begin_line();
  EXPECT_THROW(s.divider.add_point({{V(0), 0.25}, {V(1), 0.25}, {V(2), 0.5}}), IT::Invalid_point_error);
}

} // namespace
