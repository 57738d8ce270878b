// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Refinement of difficult surfaces: it ends, nothing is rounded, and faces below the bound are listed.

#include "refined_surface.h"
#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/refine_Delaunay.h>

#include <CGAL/number_type_config.h>

#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = Refined_triangulation;

Triangulation triangulation_of(const samples::Indexed_triangles& surface)
{
  return Triangulation(IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles), surface.points);
}

// Whether an edge is a part of a flagged edge of the input.
bool is_part(const Triangulation& t, IT::Edge_index e, const std::vector<bool>& flags)
{
  const IT::internal::Correspondence& correspondence = IT::internal::engine(t).correspondence();
  if (flags.empty() || !correspondence.coordinates().is_original(e))
    return false;
  return flags[correspondence.input().edge(correspondence.input_halfedge(t.connectivity().halfedge(e))).idx()];
}

// Refines and checks. Returns the report.
IT::Refinement_report refine(Triangulation t, const std::vector<bool>& is_constrained = {})
{
  const double area = total_area(t);
  const IT::Delta_complex& complex = t.connectivity();
  const std::size_t number_of_input_vertices = complex.number_of_vertices();
  const auto flags = boost::make_function_property_map<IT::Edge_index, bool>(
    [&](IT::Edge_index e) { return e.idx() < is_constrained.size() && is_constrained[e.idx()]; });
  const IT::Refinement_report report =
    IT::refine_Delaunay(t, CGAL::parameters::minimum_size(0.).edge_is_constrained_map(flags).maximum_number(100000));
  EXPECT_EQ(report.status, IT::Refinement_status::REFINED);
  EXPECT_TRUE(complex.is_valid());
  EXPECT_NEAR(total_area(t) / area, 1, 1e-13);
  for (IT::Edge_index e : complex.edges())
    if (complex.is_flippable(e) && !is_part(t, e, is_constrained)) {
      EXPECT_NE(IT::internal::engine(t).test(e, IT::internal::Exact_engine::Means::UNFOLDING)->sign, CGAL::NEGATIVE)
        << e.idx();
    }
  for (std::size_t v = number_of_input_vertices; v < complex.number_of_vertices(); ++v)
    EXPECT_TRUE(is_exactly_flat(t, IT::Vertex_index(v))) << v;
  std::vector<bool> is_listed(complex.number_of_faces());
  for (const IT::Unrefined_face& f : report.unrefined) {
    EXPECT_NE(f.reason, IT::Refinement_obstacle::BUDGET);
    is_listed[f.face.idx()] = true;
  }
  for (IT::Halfedge_index h : complex.halfedges())
    if (!complex.is_border(h)) {
      const bool is_small = IT::angle(t, h) * 180 / CGAL_PI < 25 * (1 - 1e-12);
      EXPECT_FALSE(is_small && !is_listed[complex.face(h).idx()]) << h.idx();
    }
  return report;
}

std::size_t count(const IT::Refinement_report& report, IT::Refinement_obstacle reason)
{
  std::size_t result = 0;
  for (const IT::Unrefined_face& f : report.unrefined)
    result += f.reason == reason;
  return result;
}
std::size_t count_at_small_input_angles(const IT::Refinement_report& report)
{
  return count(report, IT::Refinement_obstacle::SMALL_INPUT_ANGLE) +
         count(report, IT::Refinement_obstacle::BESIDE_SMALL_INPUT_ANGLE);
}

// A closed box; the circumcenters of its faces are the midpoints of edges.
samples::Indexed_triangles box(double x, double y, double z)
{
  samples::Indexed_triangles result;
  for (int i = 0; i < 8; ++i)
    result.points.push_back({i & 1 ? x : 0, i & 2 ? y : 0, i & 4 ? z : 0});
  for (const std::array<std::uint32_t, 4>& side : {std::array<std::uint32_t, 4>{0, 2, 3, 1},
                                                   {4, 5, 7, 6},
                                                   {0, 1, 5, 4},
                                                   {2, 6, 7, 3},
                                                   {0, 4, 6, 2},
                                                   {1, 3, 7, 5}}) {
    result.triangles.push_back({side[0], side[1], side[2]});
    result.triangles.push_back({side[0], side[2], side[3]});
  }
  return result;
}

TEST(Refined_families, caps_down_to_the_precision_of_double)
{
  for (int k = 1; k <= 17; ++k) {
    SCOPED_TRACE(k);
    const double h = std::pow(10., -k);
    // A vertex next to a border edge.
    const IT::Refinement_report report =
      refine(triangulation_of({{{0, 0, 0}, {1, 0, 0}, {0.5, h, 0}, {0.5, 0, 1}}, {{0, 1, 2}, {1, 3, 2}, {3, 0, 2}}}));
    EXPECT_GE(report.segment_splits, std::size_t(k));
  }
  for (double bulge : {1e-1, 1e-3, 1e-10, 0.})
    refine(triangulation_of(samples::cap(bulge)));
}

// Vertices 2 and 4 lie on the edge from 0 to 1, in two faces without area that stay at the border, or if that edge is
// constrained.
TEST(Refined_families, faces_without_area)
{
  samples::Indexed_triangles surface;
  surface.points = {{{0, 0, 0}}, {{4, 0, 0}}, {{1, 0, 0}}, {{2, 3, 0}}, {{2, 0, 0}}};
  surface.triangles = {{0, 2, 3}, {2, 4, 3}, {4, 1, 3}, {0, 4, 2}, {0, 1, 4}};
  const IT::Refinement_report report = refine(triangulation_of(surface));
  EXPECT_EQ(report.unrefined.size(),
            count_at_small_input_angles(report) + count(report, IT::Refinement_obstacle::UNREPRESENTABLE));
  surface.points.push_back({2, -0.1, 0});
  surface.triangles.push_back({0, 5, 1});
  EXPECT_TRUE(refine(triangulation_of(surface)).unrefined.empty());
  const Triangulation t = triangulation_of(surface);
  std::vector<bool> is_constrained(t.connectivity().number_of_edges());
  for (IT::Edge_index e : t.connectivity().edges())
    if (t.length(e) == 4)
      is_constrained[e.idx()] = true;
  refine(t, is_constrained);
}

TEST(Refined_families, boxes_and_prisms)
{
  for (const samples::Indexed_triangles& surface : {box(1, 1, 1), box(1, 2, 3), box(1, 7, 0.1), samples::prism(4),
                                                    samples::prism(6), samples::prism(24), samples::prism(24, 3)}) {
    const IT::Refinement_report report = refine(triangulation_of(surface));
    EXPECT_TRUE(report.unrefined.empty()); // the sums of the angles at their vertices are large
  }
}

TEST(Refined_families, lantern_and_needles)
{
  EXPECT_TRUE(refine(triangulation_of(samples::Schwarz_lantern(8, 24))).unrefined.empty());
  refine(triangulation_of(samples::pillow(30)));
  EXPECT_TRUE(refine(triangulation_of(samples::bad_torus(20, 20))).unrefined.empty());
}

TEST(Refined_families, a_surface_of_one_vertex)
{
  for (const samples::Glued_triangles& torus : {samples::one_vertex_torus(), samples::sheared_one_vertex_torus(50)}) {
    const IT::Delta_complex complex = IT::make_Delta_complex_from_gluing(torus.number_of_faces, torus.glued_sides);
    std::vector<double> lengths(complex.number_of_edges());
    for (std::size_t f = 0; f < torus.number_of_faces; ++f) {
      IT::Halfedge_index h = complex.halfedge(IT::Face_index(IT::Face_index::size_type(f)));
      for (int i = 0; i < 3; ++i, h = complex.next(h))
        lengths[complex.edge(h).idx()] = torus.side_lengths[3 * f + i];
    }
    EXPECT_TRUE(refine(Triangulation::from_lengths(complex, lengths)).unrefined.empty());
  }
}

TEST(Refined_families, mirror_symmetric_surfaces)
{
  for (const samples::Indexed_triangles& surface :
       {samples::torus(16, 8), samples::latitude_longitude_sphere(18, 10), samples::random_diagonal_grid(8, 8)})
    EXPECT_TRUE(refine(triangulation_of(surface)).unrefined.empty());
}

// Flips put the same face on both sides of one of the constrained edges.
TEST(Refined_families, constrained_edges_that_end_in_spikes)
{
  const samples::Indexed_triangles spikes{{{-2.1, 3.4, 0},
                                           {0.5, 0.9, 0},
                                           {-0.5, -0.9, 0},
                                           {9.8, -15.8, 0},
                                           {0, -0.5, 0.9},
                                           {0, 5.3, 8.5},
                                           {0, -0.5, -0.9},
                                           {0, 0.5, -0.9},
                                           {0.9, 0, -0.5},
                                           {4.2, 0, 2.6},
                                           {-0.9, 0, -0.5},
                                           {-0.9, 0, 0.5}},
                                          {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                           {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                           {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                           {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}}};
  const Triangulation t = triangulation_of(spikes);
  const IT::Delta_complex& complex = t.connectivity();
  std::vector<bool> is_constrained(complex.number_of_edges());
  for (IT::Edge_index e : complex.edges()) {
    const auto ends =
      std::minmax({complex.source(complex.halfedge(e)).idx(), complex.target(complex.halfedge(e)).idx()});
    for (const auto& pair : {std::pair(3u, 9u), std::pair(5u, 9u), std::pair(0u, 5u)})
      is_constrained[e.idx()] = is_constrained[e.idx()] || (ends.first == pair.first && ends.second == pair.second);
  }
  EXPECT_TRUE(refine(t, is_constrained).unrefined.empty());
}

// Of two points on one edge none hides the other, however far they are from a small corner.
TEST(Refined_families, a_vertex_next_to_a_side_at_a_small_corner)
{
  for (double distance : {1e-10, 1e-11}) {
    const IT::Refinement_report report =
      refine(triangulation_of({{{0, 0, 0}, {1, 0, 0}, {std::cos(0.9), std::sin(0.9), 0}, {0.7, distance, 0}},
                               {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}}}));
    EXPECT_TRUE(report.unrefined.empty()) << distance;
  }
}

// A fan whose corners at the border are all small.
TEST(Refined_families, many_small_corners_at_one_vertex_of_the_border)
{
  for (double degrees : {1., 8., 20.}) {
    samples::Indexed_triangles fan;
    fan.points.push_back({0, 0, 0});
    for (int i = 0; i < 4; ++i) { // four separate triangles, which touch in the vertex at most
      const double angle = i * CGAL_PI / 2, turn = degrees * CGAL_PI / 180;
      fan.points.push_back({std::cos(angle), std::sin(angle), 0});
      fan.points.push_back({0.7 * std::cos(angle + turn), 0.7 * std::sin(angle + turn), 0});
      fan.points.push_back({0, 0, 0});
      const std::uint32_t first = 3 * std::uint32_t(i);
      fan.triangles.push_back({first, first + 1, first + 2});
    }
    const IT::Refinement_report report = refine(triangulation_of(fan));
    EXPECT_EQ(report.unrefined.size(), count_at_small_input_angles(report));
    EXPECT_EQ(count(report, IT::Refinement_obstacle::SMALL_INPUT_ANGLE), 4u); // one for each corner
  }
}

// Constrained edges inside of a disk that meet at 45 degrees and less.
TEST(Refined_families, a_disk_with_41_constrained_edges)
{
  std::mt19937 random(3);
  for (double shear : {0., 0.7, 3.}) {
    SCOPED_TRACE(shear);
    const Triangulation t = triangulation_of(samples::sheared_grid(9, 9, shear));
    const IT::Delta_complex& complex = t.connectivity();
    std::vector<IT::Edge_index> inner;
    for (IT::Edge_index e : complex.edges())
      if (complex.is_flippable(e))
        inner.push_back(e);
    std::shuffle(inner.begin(), inner.end(), random);
    std::vector<bool> is_constrained(complex.number_of_edges());
    for (std::size_t i = 0; i < 41; ++i)
      is_constrained[inner[i].idx()] = true;
    const IT::Refinement_report report = refine(t, is_constrained);
    EXPECT_EQ(report.unrefined.size(), count_at_small_input_angles(report));
  }
}

} // namespace
