// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Inserted vertices are removed again, which restores the triangulation.

#include "insert_random_vertices.h"
#include "samples/sample_gluings.h"
#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/Point_location.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/insert_vertex.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/reports.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

Triangulation Delaunay_triangulation_of(const samples::Indexed_triangles& surface)
{
  Triangulation result(IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles), surface.points);
  IT::flip_to_Delaunay(result);
  return result;
}

// Ends, length and crossings of all edges. Edges between ties are left out: another one may be there.
using Edge_set = std::vector<std::tuple<std::uint32_t, std::uint32_t, double, std::int64_t>>;
Edge_set edges_without_ties(const Triangulation& triangulation)
{
  const IT::Delta_complex& complex = triangulation.connectivity();
  const IT::internal::Normal_coordinates& coordinates =
    IT::internal::engine(triangulation).correspondence().coordinates();
  Edge_set result;
  for (IT::Edge_index e : complex.edges()) {
    if (complex.is_flippable(e) && triangulation.sign_of_cotangent_weight(e) == CGAL::ZERO)
      continue;
    const std::uint32_t a = complex.source(complex.halfedge(e)).idx(), b = complex.target(complex.halfedge(e)).idx();
    result.emplace_back((std::min)(a, b), (std::max)(a, b), triangulation.length(e), coordinates.crossings(e));
  }
  std::sort(result.begin(), result.end());
  return result;
}

void expect_consistent(const Triangulation& triangulation)
{
  const IT::Delta_complex& complex = triangulation.connectivity();
  ASSERT_TRUE(complex.is_valid(true));
  const IT::internal::Exact_engine& geometry = IT::internal::engine(triangulation);
  for (IT::Edge_index e : complex.edges()) {
    if (complex.is_flippable(e)) {
      ASSERT_NE(geometry.test(e, IT::internal::Exact_engine::Means::UNFOLDING)->sign, CGAL::NEGATIVE) << e;
    }
  }
  for (IT::Face_index f : complex.faces()) {
    ASSERT_EQ(geometry.sign_of_area(f), CGAL::POSITIVE) << f;
  }
}

// Its Euler characteristic is that of the triangulation, and each edge has as many crossings as the integers say.
void expect_overlay(const Triangulation& triangulation)
{
  const IT::Delta_complex& complex = triangulation.connectivity();
  const IT::Overlay overlay(triangulation);
  EXPECT_EQ(std::int64_t(overlay.number_of_vertices()) - overlay.number_of_segments() + overlay.number_of_faces(),
            std::int64_t(complex.number_of_vertices()) - complex.number_of_edges() + complex.number_of_faces());
  std::size_t crossings = 0;
  for (IT::Edge_index e : complex.edges())
    crossings += std::size_t(triangulation.number_of_crossings(e));
  EXPECT_EQ(overlay.number_of_vertices(), complex.number_of_vertices() + crossings);
}

std::size_t number_of_inserted_vertices(const Triangulation& triangulation)
{
  return IT::internal::engine(triangulation).correspondence().number_of_inserted_vertices();
}

IT::Vertex_index random_inserted_vertex(const Triangulation& triangulation, std::mt19937& random)
{
  const std::size_t n = number_of_inserted_vertices(triangulation);
  return IT::Vertex_index(std::uint32_t(triangulation.connectivity().number_of_vertices() - 1 - random() % n));
}

TEST(Remove_vertex, undoes_insertions_in_any_order)
{
  std::mt19937 random(1);
  for (const samples::Indexed_triangles& surface :
       {samples::sheared_grid(), samples::random_diagonal_grid(), samples::torus(), samples::bad_torus(30, 30),
        samples::bumpy_dome(), samples::disk_with_spike(), samples::Schwarz_lantern(), samples::cap(), samples::cap(0),
        samples::prism(16), samples::pillow(60), samples::sliver_sheet(12), samples::helical_tube()})
    for (unsigned largest_coordinate : {1u, 1000u}) {
      Triangulation triangulation = Delaunay_triangulation_of(surface);
      const Edge_set before = edges_without_ties(triangulation);
      EXPECT_GT(IT::insert_random_vertices(triangulation, 40, largest_coordinate, random), 10u);
      while (number_of_inserted_vertices(triangulation) > 0)
        IT::remove_vertex(triangulation, random_inserted_vertex(triangulation, random));
      expect_consistent(triangulation);
      expect_overlay(triangulation);
      EXPECT_EQ(edges_without_ties(triangulation), before);
    }
}

// The straight line runs from one side of a fold to the other, so the faces that are left are bent.
TEST(Remove_vertex, on_a_line_across_a_fold)
{
  samples::Indexed_triangles kite;
  kite.points = {{{-1, 0, 1}}, {{1, 0, 1}}, {{0, 1, 0}}, {{0, -1, 0}}};
  kite.triangles = {{0, 3, 2}, {1, 2, 3}};
  Triangulation triangulation = Delaunay_triangulation_of(kite);
  const IT::Delta_complex& complex = triangulation.connectivity();
  IT::Halfedge_index fold(0);
  while (complex.is_border(complex.edge(fold)))
    fold = IT::Halfedge_index(fold.idx() + 2);
  const IT::Vertex_index v = IT::insert_vertex(triangulation, {fold, {1, 1, 0}});
  IT::Halfedge_index h = complex.halfedge(v);
  while (complex.source(h).idx() > 1)
    h = complex.next_around_target(h);
  const IT::Edge_index line = complex.edge(h);
  const IT::Removed_elements removed =
    IT::internal::Whole_triangulation<IT::Filtered_edge_length_traits>(triangulation).unsplit_edge(h);
  EXPECT_DOUBLE_EQ(triangulation.squared_length(removed.edge_after(line)), 8);
  EXPECT_DOUBLE_EQ(triangulation.length(removed.edge_after(line)), std::sqrt(8.));
}

// Decisions from positions in space, after flips and splits, equal those of the unfolding alone: on surfaces with flat
// parts, where faces stay straight or become straight again, and with ties everywhere.
TEST(Remove_vertex, flat_parts_are_decided_as_by_unfolding)
{
  std::mt19937 random(7);
  std::uint64_t in_planes = 0;
  std::size_t ties = 0;
  for (const samples::Indexed_triangles& surface :
       {samples::prism(8), samples::prism(12, 1), samples::sheared_grid(6, 6), samples::random_diagonal_grid(6),
        samples::cap(), samples::cap(0)})
    for (unsigned largest_coordinate : {1u, 3u, 1000000u}) {
      Triangulation triangulation = Delaunay_triangulation_of(surface);
      const IT::Delta_complex& complex = triangulation.connectivity();
      for (int i = 0; i < 6; ++i) {
        IT::insert_random_vertices(triangulation, 10, largest_coordinate, random);
        for (std::size_t n = random() % 8; n > 0 && number_of_inserted_vertices(triangulation) > 0; --n)
          IT::remove_vertex(triangulation, random_inserted_vertex(triangulation, random));
        const IT::internal::Exact_engine& geometry = IT::internal::engine(triangulation);
        for (IT::Edge_index e : complex.edges())
          if (complex.is_flippable(e)) {
            const CGAL::Sign sign = geometry.test(e)->sign;
            ASSERT_EQ(sign, geometry.test(e, IT::internal::Exact_engine::Means::UNFOLDING)->sign) << e;
            ties += sign == CGAL::ZERO ? 1 : 0;
          }
      }
      in_planes += triangulation.stage_counts()[IT::Stage::COPLANAR];
    }
  EXPECT_GT(ties, 200u);
  EXPECT_GT(in_planes, 1000u);
}

TEST(Remove_vertex, between_insertions)
{
  std::mt19937 random(2);
  for (const samples::Indexed_triangles& surface :
       {samples::torus(8, 6), samples::bumpy_dome(), samples::pillow(20), samples::helical_tube()}) {
    Triangulation triangulation = Delaunay_triangulation_of(surface);
    const Edge_set before = edges_without_ties(triangulation);
    for (int i = 0; i < 30; ++i) {
      IT::insert_random_vertices(triangulation, random() % 6, 5, random);
      for (std::size_t n = random() % 5; n > 0 && number_of_inserted_vertices(triangulation) > 0; --n)
        IT::remove_vertex(triangulation, random_inserted_vertex(triangulation, random));
      ASSERT_TRUE(triangulation.connectivity().is_valid(true));
    }
    expect_consistent(triangulation);
    expect_overlay(triangulation);
    while (number_of_inserted_vertices(triangulation) > 0)
      IT::remove_vertex(triangulation, random_inserted_vertex(triangulation, random));
    expect_consistent(triangulation);
    EXPECT_EQ(edges_without_ties(triangulation), before);
  }
}

// By input edges: a half of a constrained edge coincides with it, and nothing else does.
bool is_constrained(const Triangulation& triangulation, IT::Edge_index e)
{
  const IT::internal::Correspondence& correspondence = IT::internal::engine(triangulation).correspondence();
  const IT::Halfedge_index h = triangulation.connectivity().halfedge(e);
  return correspondence.coordinates().is_original(e) &&
         correspondence.input().edge(correspondence.input_halfedge(h)).idx() % 3 == 0;
}

std::size_t number_of_constrained(const Triangulation& triangulation)
{
  std::size_t result = 0;
  for (IT::Edge_index e : triangulation.connectivity().edges())
    result += is_constrained(triangulation, e) ? 1 : 0;
  return result;
}

TEST(Remove_vertex, joins_the_parts_of_border_and_constrained_edges)
{
  std::mt19937 random(3);
  for (const samples::Indexed_triangles& surface : {samples::bumpy_dome(), samples::torus(8, 6), samples::cap()}) {
    Triangulation triangulation(IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles),
                                surface.points);
    const IT::Delta_complex input = triangulation.connectivity();
    const auto fixed =
      CGAL::parameters::edge_is_constrained_map(boost::make_function_property_map<IT::Edge_index, bool>(
        [&](IT::Edge_index e) { return is_constrained(triangulation, e); }));
    IT::internal::engine(triangulation);
    IT::flip_to_Delaunay(triangulation, fixed);
    const std::size_t before = number_of_constrained(triangulation);
    std::size_t inserted = 0;
    for (int i = 0; i < 60; ++i) {
      const IT::Edge_index e(std::uint32_t(random() % input.number_of_edges()));
      IT::Halfedge_index h = input.halfedge(e);
      if (input.is_border(h))
        h = input.opposite(h);
      if (e.idx() % 3 != 0 && !input.is_border(e))
        continue;
      try {
        IT::insert_vertex(triangulation, {h, {double(1 + random() % 9), double(1 + random() % 9), 0}}, fixed);
        ++inserted;
      } catch (const IT::Invalid_point_error&) { // the same one again
      }
    }
    EXPECT_GT(inserted, 5u);
    EXPECT_GT(number_of_constrained(triangulation), before);
    while (number_of_inserted_vertices(triangulation) > 0) {
      std::vector<bool> before_removal;
      for (IT::Edge_index e : triangulation.connectivity().edges())
        before_removal.push_back(is_constrained(triangulation, e));
      IT::remove_vertex(
        triangulation, random_inserted_vertex(triangulation, random),
        CGAL::parameters::edge_is_constrained_map(boost::make_function_property_map<IT::Edge_index, bool>(
          [&](IT::Edge_index e) { return before_removal[e.idx()]; })));
      ASSERT_TRUE(triangulation.connectivity().is_valid(true));
    }
    EXPECT_EQ(number_of_constrained(triangulation), before);
    expect_overlay(triangulation);
  }
}

// A vertex on the diagonal of a square is left by four edges that form two straight lines. Either may be joined: the
// diagonal, or the line that crosses it.
TEST(Remove_vertex, in_the_middle_of_a_square)
{
  std::mt19937 random(6);
  std::size_t crossed = 0;
  for (int i = 0; i < 100; ++i) {
    const samples::Indexed_triangles square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
    Triangulation triangulation = Delaunay_triangulation_of(square);
    const IT::Delta_complex input = triangulation.connectivity();
    for (IT::Edge_index e : input.edges())
      if (!input.is_border(e))
        IT::insert_vertex(triangulation, {input.halfedge(e), {1, 1, 0}});
    IT::insert_random_vertices(triangulation, 3, 9, random);
    while (number_of_inserted_vertices(triangulation) > 0)
      IT::remove_vertex(triangulation, IT::Vertex_index(triangulation.connectivity().number_of_vertices() - 1));
    expect_consistent(triangulation);
    expect_overlay(triangulation);
    const IT::internal::Normal_coordinates& coordinates =
      IT::internal::engine(triangulation).correspondence().coordinates();
    for (IT::Edge_index e : triangulation.connectivity().edges()) {
      EXPECT_EQ(coordinates.number_of_crossings(e), coordinates.is_original(e) ? 0 : 1);
      crossed += coordinates.is_original(e) ? 0 : 1;
    }
  }
  EXPECT_GT(crossed, 0u);
}

// All edges are loops, so that edges lead from inserted vertices back to themselves, too.
TEST(Remove_vertex, of_a_torus_with_one_vertex)
{
  std::mt19937 random(4);
  for (const samples::Glued_triangles& gluing :
       {samples::one_vertex_torus(), samples::sheared_one_vertex_torus(20), samples::one_vertex_torus(1, 10, 10)}) {
    IT::Delta_complex input = IT::make_Delta_complex_from_gluing(gluing.number_of_faces, gluing.glued_sides);
    const std::vector<double> lengths(gluing.side_lengths.begin(), gluing.side_lengths.begin() + 3);
    Triangulation triangulation = Triangulation::from_lengths(std::move(input), lengths);
    IT::flip_to_Delaunay(triangulation);
    const Edge_set before = edges_without_ties(triangulation);
    std::size_t refused = 0;
    for (int i = 0; i < 40; ++i) {
      IT::insert_random_vertices(triangulation, 1 + random() % 4, 7, random);
      for (int attempts = 0; attempts < 20 && number_of_inserted_vertices(triangulation) > 0; ++attempts)
        try {
          IT::remove_vertex(triangulation, random_inserted_vertex(triangulation, random));
        } catch (const IT::Invalid_removal_error&) {
          ++refused;
        }
      expect_consistent(triangulation);
    }
    EXPECT_EQ(refused, 0u);
    EXPECT_EQ(edges_without_ties(triangulation), before);
  }
}

TEST(Remove_vertex, then_points_are_located_there_and_back)
{
  std::mt19937 random(5);
  Triangulation triangulation = Delaunay_triangulation_of(samples::bumpy_dome());
  IT::insert_random_vertices(triangulation, 60, 9, random);
  for (int i = 0; i < 30; ++i)
    IT::remove_vertex(triangulation, random_inserted_vertex(triangulation, random));
  const IT::Common_subdivision subdivision(triangulation);
  const IT::Point_location location(subdivision);
  for (IT::Face_index f : subdivision.input().faces()) {
    const IT::Surface_point p{subdivision.input().halfedge(f), {.5, .3, .2}};
    const IT::Surface_point q = location.intrinsic_to_input(location.input_to_intrinsic(p));
    ASSERT_EQ(subdivision.input().face(q.halfedge), f);
    IT::Halfedge_index h = q.halfedge;
    for (std::size_t i = 0; i < 3; ++i, h = subdivision.input().next(h))
      for (std::size_t j = 0, k = p.halfedge == h ? i : 3; j < 3 && k < 3; ++j)
        EXPECT_NEAR(q.coordinates[(k + j) % 3], p.coordinates[j], 1e-12);
  }
}

TEST(Remove_vertex, refuses_vertices_of_the_input)
{
  Triangulation triangulation = Delaunay_triangulation_of(samples::torus(8, 6));
  const IT::Delta_complex before = triangulation.connectivity();
  EXPECT_THROW(IT::remove_vertex(triangulation, IT::Vertex_index(0)), IT::Invalid_removal_error);
  EXPECT_THROW(IT::remove_vertex(triangulation, IT::Vertex_index(before.number_of_vertices())),
               IT::Invalid_removal_error);
  EXPECT_EQ(triangulation.connectivity(), before);
}

} // namespace
