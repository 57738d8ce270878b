// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Positions of crossings from points and from exact squared lengths: two ways to compute them,
// which must agree to the last two units, relative to each position.

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include "library/positions/Crossing_locator.h"
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/squared_lengths.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;
using Rational = IT::Rational;

IT::Delta_complex complex_of(const samples::Indexed_triangles& surface)
{
  return IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles);
}

// Knows no points, so that positions come from bounded double-doubles and MPFR.
Triangulation from_squared_lengths(const samples::Indexed_triangles& surface)
{
  const IT::Delta_complex complex = complex_of(surface);
  std::vector<Rational> squared_lengths;
  for (IT::Edge_index e : complex.edges()) {
    const IT::Halfedge_index h = complex.halfedge(e);
    const auto &p = surface.points[complex.source(h).idx()], &q = surface.points[complex.target(h).idx()];
    Rational s(0);
    for (int i = 0; i < 3; ++i)
      s += (Rational(q[i]) - Rational(p[i])) * (Rational(q[i]) - Rational(p[i]));
    squared_lengths.push_back(s);
  }
  return Triangulation::from_metric(complex, IT::metric_from_squared_lengths(squared_lengths));
}

Triangulation triangulated(const samples::Indexed_triangles& surface)
{
  Triangulation t(complex_of(surface), surface.points);
  IT::flip_to_Delaunay(t);
  return t;
}

std::vector<std::pair<std::string, samples::Indexed_triangles>> surfaces()
{
  std::vector<std::pair<std::string, samples::Indexed_triangles>> result{
    {"prism", samples::prism(60)},
    {"rotated prism", samples::prism(60, 1)},
    {"bad torus", samples::bad_torus(30, 30)},
    {"helical tube", samples::helical_tube()},
    {"sheared grid", samples::sheared_grid(10, 10, 7)},
    {"cap", samples::cap(1e-6)},
    {"sliver sheet", samples::sliver_sheet(12, 1e-4, 1e-4)},
    {"bumpy sphere", samples::bumpy_sphere(40, 21)}};
  // Planes that are parallel to no axis; sums and differences of small integers are exact.
  samples::Indexed_triangles tilted = samples::sheared_grid(10, 10, 7);
  for (auto& p : tilted.points)
    p = {p[0] + p[1], p[0] - p[1], 3 * p[1] - 2 * p[0]};
  result.emplace_back("tilted grid", tilted);
  samples::Indexed_triangles tiny = result[2].second; // squared lengths are still in range
  for (auto& p : tiny.points)
    for (double& x : p)
      x = std::ldexp(x + 3, -300);
  result.emplace_back("tiny torus far from the origin", tiny);
  return result;
}

} // namespace

TEST(Overlay_positions, agree_with_those_from_exact_squared_lengths)
{
  for (const auto& [name, surface] : surfaces()) {
    SCOPED_TRACE(name);
    Triangulation a(complex_of(surface), surface.points), b = from_squared_lengths(surface);
    IT::flip_to_Delaunay(a);
    IT::flip_to_Delaunay(b);
    ASSERT_EQ(a.connectivity(), b.connectivity());
    const IT::Overlay overlay(a), same(b);
    ASSERT_GT(overlay.number_of_crossings(), 0u);
    ASSERT_EQ(overlay.number_of_crossings(), same.number_of_crossings());
    const IT::Overlay_positions positions(IT::internal::engine(a), overlay), expected(IT::internal::engine(b), same);
    for (IT::Overlay::Vertex x : overlay.crossings()) {
      const double t = expected.on_intrinsic_edge(x), u = expected.on_input_edge(x);
      EXPECT_NEAR(positions.on_intrinsic_edge(x), t, 0x1p-51 * t) << x;
      EXPECT_NEAR(positions.on_input_edge(x), u, 0x1p-51 * u) << x;
    }
  }
}

// Points on a line, a zigzag of triangles of zero area between them, and a body that this closes.
samples::Indexed_triangles points_on_line(std::uint32_t n)
{
  samples::Indexed_triangles surface;
  for (std::uint32_t k = 0; k <= n; ++k)
    surface.points.push_back({double(k), 0, 0});
  surface.points.push_back({double(n) / 2, double(n), 0});
  surface.points.push_back({double(n) / 2, -double(n), 1});
  for (std::uint32_t low = 0, high = n; high - low > 1;) {
    surface.triangles.push_back({high, low + 1, low});
    if (++low, high - low > 1) {
      surface.triangles.push_back({high, high - 1, low});
      --high;
    }
  }
  for (std::uint32_t k = 0; k < n; ++k)
    surface.triangles.push_back({k, k + 1, n + 1});
  surface.triangles.push_back({n, 0, n + 2});
  return surface;
}

// Such triangles are crossed in one point, an end of the edge. Where that lies on the line is a quotient of integers,
// which must be rounded once, as others are.
TEST(Overlay_positions, behind_triangles_of_zero_area_are_those_of_an_end)
{
  const samples::Indexed_triangles surface = points_on_line(30);
  const Triangulation t = triangulated(surface);
  const IT::Overlay overlay(t);
  const IT::Overlay_positions positions(IT::internal::engine(t), overlay);
  const IT::Delta_complex &input = t.input(), &intrinsic = t.connectivity();
  const auto is_on_line = [](IT::Vertex_index v) { return v.idx() <= 30; };
  std::size_t at_source = 0;
  for (IT::Overlay::Vertex x : overlay.crossings()) {
    const IT::Halfedge_index ij = input.halfedge(overlay.input_edge(x)),
                             g = intrinsic.halfedge(overlay.intrinsic_edge(x));
    if (!is_on_line(input.source(ij)) || !is_on_line(input.target(ij)))
      continue;
    const bool is_at_source = is_on_line(intrinsic.source(g));
    ASSERT_NE(is_at_source, is_on_line(intrinsic.target(g)));
    EXPECT_EQ(positions.on_intrinsic_edge(x), is_at_source ? 0 : 1);
    const auto place = [&](IT::Vertex_index v) { return surface.points[v.idx()][0]; };
    const double from = place(input.source(ij)), to = place(input.target(ij));
    EXPECT_EQ(positions.on_input_edge(x),
              (place(is_at_source ? intrinsic.source(g) : intrinsic.target(g)) - from) / (to - from));
    at_source += is_at_source;
  }
  EXPECT_GT(at_source, 100u);
}

// Whether one bound for all errors does for this strip.
template <class Frame>
bool is_known(const IT::Delta_complex& input, const IT::internal::Points& points,
              const IT::internal::Crossed_edges& crossed)
{
  IT::internal::Strip<Frame> strip(input, Frame(input, points));
  std::vector<IT::internal::Position_on_edges> positions;
  if (!IT::internal::locate_crossings(strip, crossed, positions))
    return false;
  EXPECT_EQ(positions.size(), crossed.size());
  return true;
}

// If it gives up, others take over, which must be rare.
template <class Frame>
void expect_most_positions_known(const Triangulation& t)
{
  const IT::Overlay overlay(t);
  const IT::Delta_complex& input = t.input();
  std::size_t asked = 0, known = 0;
  for (IT::Edge_index e : t.connectivity().edges()) {
    if (overlay.intrinsic_crossings(e).empty())
      continue;
    IT::internal::Crossed_edges crossed;
    IT::internal::find_crossed_edges(overlay, input, overlay.intrinsic_crossings(e), crossed);
    ++asked;
    known += is_known<Frame>(input, IT::internal::engine(t).metric().points(), crossed);
  }
  EXPECT_GT(asked, 50u);
  EXPECT_GT(known, 0.99 * double(asked));
}

TEST(Space_frame, knows_most_positions)
{
  expect_most_positions_known<IT::internal::Space_frame>(triangulated(samples::bad_torus(60, 60)));
}

// The caps of a prism are flat, and its sides need no flip.
TEST(Plane_frame, knows_most_positions)
{
  expect_most_positions_known<IT::internal::Plane_frame>(triangulated(samples::prism(120)));
}

// In a strip of zero area no position is the right one.
template <class Frame>
void expect_nothing_without_area()
{
  const samples::Indexed_triangles flat{{{0, 0, 0}, {4, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}, {1, 0, 3}}};
  const IT::Delta_complex input = complex_of(flat);
  const IT::internal::Points points(flat.points.begin(), flat.points.end());
  for (IT::Halfedge_index h : input.halfedges())
    if (!input.is_border(input.edge(h))) {
      IT::internal::Crossed_edges crossed;
      crossed.push_back(h);
      EXPECT_FALSE(is_known<Frame>(input, points, crossed));
    }
}

TEST(Space_frame, gives_up_without_area) { expect_nothing_without_area<IT::internal::Space_frame>(); }

TEST(Plane_frame, gives_up_without_area) { expect_nothing_without_area<IT::internal::Plane_frame>(); }

// A strip asked for all of its corners ends where one asked only for its end does, in exact numbers: across bent edges
// and inside flat parts.
TEST(Strip, ends_in_the_same_place_with_and_without_corners)
{
  using Metric = IT::internal::Mpfr_metric;
  using Frame = IT::internal::Metric_frame<Metric>;
  for (const auto& [name, surface] : surfaces()) {
    SCOPED_TRACE(name);
    const Triangulation t = triangulated(surface);
    const IT::Overlay overlay(t);
    const IT::Delta_complex& input = t.input();
    const auto surface_lease = IT::internal::engine(t).input_surface();
    Metric metric(*surface_lease, {512});
    const IT::internal::Unfolding<Metric> unfolding(t.connectivity(), IT::internal::engine(t).correspondence(), metric);
    std::size_t compared = 0;
    for (IT::Edge_index e : t.connectivity().edges()) {
      if (overlay.intrinsic_crossings(e).empty() || compared == 200)
        continue;
      ++compared;
      IT::internal::Crossed_edges crossed;
      IT::internal::find_crossed_edges(overlay, input, overlay.intrinsic_crossings(e), crossed);
      IT::internal::Strip<Frame> strip(input, Frame(input, metric));
      strip.lay_out(crossed);
      EXPECT_EQ(strip.number_of_edges(), crossed.size());
      const auto vector = unfolding.edge_vector(t.connectivity().halfedge(e));
      EXPECT_EQ(vector.reference, Frame::reference(input, crossed.front()));
      const auto difference = squared_norm(strip.target() - vector.vector) / squared_norm(vector.vector);
      EXPECT_LT(difference.upper_double(), 0x1p-200) << e;
      // The target lies behind the last edge.
      const auto last = strip.triangle_behind(crossed.size() - 1);
      EXPECT_LT(squared_norm(last.apex - strip.target()).upper_double(), 0x1p-200);
    }
    EXPECT_GT(compared, 0u);
  }
}
