// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Refinement to sizes that change from place to place, and beside edges that stay whole.

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/refine_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/verify_Delaunay.h>

#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

Triangulation triangulation_of(const samples::Indexed_triangles& surface)
{
  return Triangulation(IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles), surface.points);
}

// A unit square whose sides are divided into n parts.
samples::Indexed_triangles square(std::uint32_t n)
{
  samples::Indexed_triangles result;
  result.points.push_back({0.5, 0.5, 0});
  for (std::uint32_t i = 0; i < 4 * n; ++i) {
    const double t = double(i % n) / n;
    const std::array<std::array<double, 3>, 4> places = {{{t, 0, 0}, {1, t, 0}, {1 - t, 1, 0}, {0, 1 - t, 0}}};
    result.points.push_back(places[i / n]);
    result.triangles.push_back({0, i + 1, (i + 1) % (4 * n) + 1});
  }
  return result;
}

auto flags(const std::vector<bool>& is_set)
{
  return boost::make_function_property_map<IT::Edge_index, bool>(
    [&is_set](IT::Edge_index e) { return bool(is_set[e.idx()]); });
}

std::vector<bool> border_of(const Triangulation& triangulation)
{
  std::vector<bool> result;
  for (IT::Edge_index e : triangulation.connectivity().edges())
    result.push_back(triangulation.connectivity().is_border(e));
  return result;
}

bool has_small_angle(const Triangulation& triangulation, IT::Face_index f)
{
  const IT::Delta_complex& complex = triangulation.connectivity();
  const IT::Halfedge_index h = complex.halfedge(f);
  for (IT::Halfedge_index side : {h, complex.next(h), complex.prev(h)})
    if (IT::angle(triangulation, side) * 180 / CGAL_PI < 25 * (1 - 1e-12))
      return true;
  return false;
}

// Vertices that are evenly spaced on the border lack none, and refinement goes on inside.
TEST(Whole_edges, stay_on_the_border)
{
  for (const samples::Indexed_triangles& surface : {square(10), square(20), samples::bumpy_dome()}) {
    Triangulation triangulation = triangulation_of(surface);
    const std::vector<bool> is_whole = border_of(triangulation);
    const std::vector<double> lengths = IT::edge_lengths(triangulation);
    const auto report =
      IT::refine_Delaunay(triangulation, CGAL::parameters::maximum_edge_length(0.15).whole_edges_map(flags(is_whole)));
    EXPECT_EQ(report.status, IT::Refinement_status::REFINED);
    EXPECT_GT(report.insertions, 20u);
    EXPECT_EQ(report.segment_splits, 0u);
    const IT::Delta_complex& complex = triangulation.connectivity();
    for (std::uint32_t e = 0; e < is_whole.size(); ++e)
      if (is_whole[e]) {
        EXPECT_TRUE(complex.is_border(IT::Edge_index(e)));
        EXPECT_NEAR(triangulation.length(IT::Edge_index(e)), lengths[e], 1e-15);
      }
    std::set<IT::Face_index> listed;
    for (const IT::Unrefined_face& left : report.unrefined) {
      EXPECT_EQ(left.reason, IT::Refinement_obstacle::WHOLE_EDGE);
      listed.insert(left.face);
    }
    EXPECT_LE(listed.size(), surface.points.size() / 10);
    for (IT::Face_index f : complex.faces())
      EXPECT_TRUE(listed.count(f) != 0 || !has_small_angle(triangulation, f)) << f.idx();
    EXPECT_TRUE(IT::verify_Delaunay(triangulation).is_Delaunay());
  }
}

// A vertex close to the middle of a long edge: without a vertex on it, two angles stay small. The other edges are
// split.
TEST(Whole_edges, are_named_where_they_leave_small_angles)
{
  Triangulation triangulation = triangulation_of(
    {{{0, 0, 0}, {1, 0, 0}, {0.5, 0.05, 0}, {0.5, 1, 0}, {0.5, -1, 0}}, {{0, 1, 2}, {1, 3, 2}, {3, 0, 2}, {1, 0, 4}}});
  const IT::Delta_complex& complex = triangulation.connectivity();
  std::vector<bool> is_whole(complex.number_of_edges());
  IT::Edge_index whole;
  for (IT::Edge_index e : complex.edges())
    if (complex.source(complex.halfedge(e)).idx() + complex.target(complex.halfedge(e)).idx() == 1) {
      whole = e;
      is_whole[e.idx()] = true;
    }
  Triangulation other = triangulation;
  const auto report = IT::refine_Delaunay(triangulation, CGAL::parameters::whole_edges_map(flags(is_whole)));
  EXPECT_EQ(std::minmax(complex.source(complex.halfedge(whole)).idx(), complex.target(complex.halfedge(whole)).idx()),
            std::minmax(0u, 1u));
  EXPECT_GE(report.unrefined.size(), 1u);
  EXPECT_LE(report.unrefined.size(), 4u);
  EXPECT_EQ(report.numbers_by_reason()[std::size_t(IT::Refinement_obstacle::WHOLE_EDGE)], report.unrefined.size());
  EXPECT_FALSE(report.is_refined());
  for (std::uint32_t v = 5; v < complex.number_of_vertices(); ++v)
    if (triangulation.location(IT::Vertex_index(v)).dimension() == 1) {
      EXPECT_NE(triangulation.input().edge(
                  IT::internal::side_of(triangulation.input(), triangulation.location(IT::Vertex_index(v)))),
                whole);
    }
  EXPECT_TRUE(IT::refine_Delaunay(other, CGAL::parameters::edge_is_constrained_map(flags(is_whole))).is_refined());
}

double size_at(const std::array<double, 3>& p) { return 0.01 + 0.3 * std::hypot(p[0] - 0.5, p[1] - 0.5); }

// A small size at the center, and none elsewhere: edges grow with the distance from it, and no faster.
TEST(Edge_sizes, grow_with_the_distance)
{
  const samples::Indexed_triangles surface = square(8);
  Triangulation triangulation = triangulation_of(surface);
  const auto size = [](IT::Vertex_index v) { return v.idx() == 0 ? 0.01 : std::numeric_limits<double>::infinity(); };
  const auto size_map = boost::make_function_property_map<IT::Vertex_index, double>(size);
  const auto report = IT::refine_Delaunay(triangulation, CGAL::parameters::size_map(size_map));
  EXPECT_TRUE(report.is_refined());
  const IT::Delta_complex& complex = triangulation.connectivity();
  const auto place = [&](IT::Vertex_index v) {
    return triangulation.is_inserted(v)
             ? IT::point_in_space(triangulation.input(), triangulation.input_metric().points(),
                                  triangulation.location(v))
             : surface.points[v.idx()];
  };
  double largest = 0;
  for (IT::Edge_index e : complex.edges()) {
    const IT::Halfedge_index h = complex.halfedge(e);
    const double bound = (size_at(place(complex.source(h))) + size_at(place(complex.target(h)))) / 2;
    EXPECT_LE(triangulation.length(e), bound * 1.01); // interpolated between rays
    largest = (std::max)(largest, triangulation.length(e));
  }
  EXPECT_GT(largest, 0.1);
  EXPECT_GT(complex.number_of_vertices(), 100u);
  EXPECT_LT(complex.number_of_vertices(), 1000u); // 0.01 everywhere takes 20,000
  // With a steeper gradation there are fewer.
  Triangulation other = triangulation_of(surface);
  IT::refine_Delaunay(other, CGAL::parameters::size_map(size_map).size_gradation(1));
  EXPECT_LT(other.connectivity().number_of_vertices(), complex.number_of_vertices() / 2);
}

// Around a prism of 24 sides, an edge of a third of a side turns by 5 degrees.
TEST(Edge_sizes, follow_the_normals)
{
  samples::Indexed_triangles pipe;
  for (std::uint32_t i = 0; i < 24; ++i) {
    const double angle = 2 * CGAL_PI * i / 24;
    for (double z : {0., 2.})
      pipe.points.push_back({std::cos(angle), std::sin(angle), z});
    const std::uint32_t j = (i + 1) % 24;
    pipe.triangles.push_back({2 * i, 2 * j, 2 * j + 1});
    pipe.triangles.push_back({2 * i, 2 * j + 1, 2 * i + 1});
  }
  Triangulation triangulation = triangulation_of(pipe), other = triangulation;
  IT::refine_Delaunay(triangulation, CGAL::parameters::maximum_normal_angle(5));
  const std::vector<double> lengths = IT::edge_lengths(triangulation);
  const double longest = *std::max_element(lengths.begin(), lengths.end());
  EXPECT_LE(longest, 2 * std::sin(CGAL_PI / 24) / 3 * (1 + 1e-9));
  EXPECT_GE(longest, 2 * std::sin(CGAL_PI / 24) / 4);
  // All its edges are sharper than 10 degrees.
  IT::refine_Delaunay(other, CGAL::parameters::maximum_normal_angle(5).sharp_edge_angle(10));
  EXPECT_LT(other.connectivity().number_of_vertices(), triangulation.connectivity().number_of_vertices() / 4);
}

// The estimate is within a third of the number that is needed, and refuses what would never end.
TEST(Edge_sizes, are_refused_where_they_need_too_many_vertices)
{
  const auto estimate = [](const samples::Indexed_triangles& surface, double length) -> double {
    Triangulation triangulation = triangulation_of(surface);
    try {
      IT::refine_Delaunay(triangulation, CGAL::parameters::maximum_edge_length(length));
    } catch (const IT::Too_many_vertices_error& error) {
      EXPECT_NE(std::string(error.what()).find(std::to_string(error.number())), std::string::npos);
      EXPECT_TRUE(triangulation.connectivity().number_of_vertices() == surface.points.size());
      return double(error.number());
    }
    return 0;
  };
  for (const samples::Indexed_triangles& surface : {square(1), samples::torus(8, 8)}) {
    const double by_estimate = estimate(surface, 1e-4) * 1e-8 / (0.02 * 0.02);
    Triangulation triangulation = triangulation_of(surface);
    const auto report = IT::refine_Delaunay(triangulation, CGAL::parameters::maximum_edge_length(0.02));
    const double needed = double(report.insertions + report.segment_splits);
    EXPECT_GT(by_estimate, needed / 1.33);
    EXPECT_LT(by_estimate, needed * 1.33);
  }
  Triangulation triangulation = triangulation_of(square(1));
  EXPECT_EQ(IT::refine_Delaunay(triangulation, CGAL::parameters::maximum_edge_length(1e-4).maximum_number(100)).status,
            IT::Refinement_status::BUDGET_EXHAUSTED);
}

TEST(Edge_sizes, are_checked)
{
  Triangulation triangulation = triangulation_of(square(1));
  for (double bad : {0., -1., std::nan("")}) {
    const auto sizes =
      boost::make_function_property_map<IT::Vertex_index, double>([bad](IT::Vertex_index) { return bad; });
    EXPECT_THROW(IT::refine_Delaunay(triangulation, CGAL::parameters::size_map(sizes)), IT::Invalid_argument_error);
    EXPECT_THROW(IT::refine_Delaunay(triangulation, CGAL::parameters::size_gradation(bad)), IT::Invalid_argument_error);
    EXPECT_THROW(IT::refine_Delaunay(triangulation, CGAL::parameters::maximum_normal_angle(bad)),
                 IT::Invalid_argument_error);
  }
  IT::Delta_complex complex =
    IT::make_Delta_complex_from_triangles(3, std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}});
  Triangulation lengths = Triangulation::from_lengths(std::move(complex), std::vector<double>{1, 1, 1});
  EXPECT_THROW(IT::refine_Delaunay(lengths, CGAL::parameters::maximum_normal_angle(5)), IT::Invalid_argument_error);
}

} // namespace
