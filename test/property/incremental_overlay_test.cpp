// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// After every flip, the overlay from the integers equals the one that is updated using only the order along the
// quadrilateral's sides.

#include "property/Incremental_overlay_check.h"
#include "property/flip_test_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Incremental_overlay.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace test_surfaces;
using IT::Delta_complex;
using IT::Edge_index;
using IT::Halfedge_index;
using IT::Incremental_overlay;
using IT::Overlay;
using IT::Segment_label;
using overlay_check::are_same_overlay;
using overlay_check::is_valid;
using Halfedges = std::vector<Halfedge_index>;

// A triangulation without a metric, its integers, and the overlay that is updated.
struct Both_ways
{
  explicit Both_ways(const Delta_complex& input)
    : complex(input), correspondence(input, IT::internal::Normal_coordinates(input), {}), incremental(input)
  {}

  void flip(Edge_index e)
  {
    correspondence.flip(complex, complex.hinge(e));
    complex.flip(e);
    incremental.flip(e);
  }

  Overlay overlay() const { return Overlay(complex, correspondence); }

  Delta_complex complex;
  IT::internal::Correspondence correspondence;
  Incremental_overlay incremental;
};

// Flips an overlay along with a triangulation and compares after each flip.
template <class Traits>
struct Comparing_visitor
{
  explicit Comparing_visitor(const IT::Intrinsic_triangulation<Traits>& t)
    : triangulation(t), incremental(t.connectivity())
  {}

  bool go_further(const IT::Progress&) { return is_same; }
  void after_flip(Edge_index e)
  {
    incremental.flip(e);
    const Overlay overlay(triangulation);
    is_same = is_valid(incremental) && are_same_overlay(overlay, incremental) &&
              overlay.number_of_segments() == incremental.number_of_segments() &&
              are_same_links(incremental.intrinsic(), triangulation.connectivity());
    most_crossings = std::max(most_crossings, overlay.number_of_crossings());
    ++flips;
  }

  const IT::Intrinsic_triangulation<Traits>& triangulation;
  Incremental_overlay incremental;
  bool is_same = true;
  std::uint32_t most_crossings = 0;
  std::size_t flips = 0;
};

struct Flips_and_crossings
{
  std::size_t flips;
  std::uint32_t most_crossings;
};

Flips_and_crossings expect_same_after_every_flip(const Surface& surface)
{
  SCOPED_TRACE(surface.name);
  auto t = triangulation<IT::Filtered_edge_length_traits>(surface);
  Comparing_visitor<IT::Filtered_edge_length_traits> visitor(t);
  const IT::Flip_report report = IT::flip_to_Delaunay(t, CGAL::parameters::visitor(std::ref(visitor)));
  EXPECT_TRUE(visitor.is_same) << "after flip " << visitor.flips;
  EXPECT_EQ(report.status, IT::Flip_status::DELAUNAY);
  EXPECT_EQ(report.flips, visitor.flips);
  return {visitor.flips, visitor.most_crossings};
}

// The square with the corners 0, 1, 2, 3 and the diagonal from 0 to 2.
Delta_complex square()
{
  return IT::make_Delta_complex_from_triangles(4, std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 2, 3}});
}

// The halfedge from v to w in a complex with one edge at most between two vertices.
Halfedge_index halfedge(const Delta_complex& c, std::uint32_t v, std::uint32_t w)
{
  for (Halfedge_index h : c.halfedges())
    if (c.source(h).idx() == v && c.target(h).idx() == w)
      return h;
  return Halfedge_index();
}

// Flips random edges for which `flip` is willing. About every other flip is undone by three more.
template <class Flip, class Compare>
void flip_at_random(const Delta_complex& complex, unsigned seed, int number_of_flips, const Flip& flip,
                    const Compare& is_same)
{
  std::mt19937 random(seed);
  std::vector<Edge_index> to_undo;
  for (int i = 0; i < number_of_flips; ++i) {
    const bool undoes = !to_undo.empty() && random() % 2 == 0;
    const Edge_index e = undoes ? to_undo.back() : Edge_index(std::uint32_t(random() % complex.number_of_edges()));
    if (!complex.is_flippable(e))
      continue;
    if (undoes)
      to_undo.pop_back();
    for (int turn = undoes ? 3 : 1; turn > 0; --turn) {
      if (!flip(e))
        break;
      if (!undoes)
        to_undo.push_back(e);
      ASSERT_TRUE(is_same()) << "step " << i;
    }
  }
}

} // namespace

// Figure 5 of the paper: the label of the diagonal goes from oc to c and back, and the edges that it leaves or lands on
// are labelled o in between.
TEST(Incremental_overlay, LabelsOfAFlippedDiagonal)
{
  const Delta_complex input = square();
  const Halfedge_index diagonal = halfedge(input, 0, 2);
  const Edge_index e = input.edge(diagonal);
  Incremental_overlay overlay(input);
  EXPECT_TRUE(is_valid(overlay));
  EXPECT_EQ(overlay.number_of_crossings(), 0u);
  for (Halfedge_index h : input.halfedges()) {
    EXPECT_EQ(overlay.label(overlay.first_part(h)), Segment_label::BOTH);
    EXPECT_EQ(overlay.input_halfedge(overlay.first_part(h)), h);
  }

  for (int turn = 1; turn <= 4; ++turn) {
    SCOPED_TRACE(turn);
    overlay.flip(e);
    EXPECT_TRUE(is_valid(overlay));
    const Halfedge_index h = overlay.intrinsic().halfedge(e);
    if (turn % 2 == 1) {
      EXPECT_EQ(overlay.number_of_crossings(), 1u);
      EXPECT_EQ(overlay.number_of_segments(), 8u);
      EXPECT_EQ(overlay.label(overlay.first_part(h)), Segment_label::INTRINSIC);
      EXPECT_EQ(overlay.label(overlay.first_part_in_input(diagonal)), Segment_label::INPUT);
      // From 1 to 3, what comes from the right goes from 2 to 0.
      const bool leads_to_3 = overlay.intrinsic().target(h).idx() == 3;
      const Halfedge_index from_1_to_3 = leads_to_3 ? h : overlay.intrinsic().opposite(h);
      const Halfedge_index from_2_to_0 = input.opposite(diagonal);
      EXPECT_EQ(overlay.crossing_input_halfedges(from_1_to_3), Halfedges{from_2_to_0});
      EXPECT_EQ(overlay.crossing_intrinsic_halfedges(diagonal), Halfedges{from_1_to_3});
    } else {
      EXPECT_EQ(overlay.number_of_crossings(), 0u);
      EXPECT_EQ(overlay.number_of_segments(), 5u);
      EXPECT_EQ(overlay.label(overlay.first_part(h)), Segment_label::BOTH);
      EXPECT_EQ(overlay.input_halfedge(overlay.first_part(h)), turn == 2 ? input.opposite(h) : h);
    }
  }
}

// With the input edges (1, 0), (0, 1) and (1, 1) of a lattice, the edge (x, y) crosses |y| - 1,
// |x| - 1 and |x - y| - 1 of them, unless it is one of them.
TEST(Incremental_overlay, CrossingsOnATorus)
{
  using Vector = std::array<long, 2>;
  const auto gluing = samples::one_vertex_torus();
  const Delta_complex input = IT::make_Delta_complex_from_gluing(gluing.number_of_faces, gluing.glued_sides);
  // Sides 0, 1, 2 of a face close up: u, v, -u - v. Here u = (1, 0) and v = (0, 1).
  std::vector<Vector> vectors{{1, 0}, {0, 1}, {-1, -1}};
  Incremental_overlay overlay(input);
  std::mt19937 random(1);
  for (int i = 0; i < 300; ++i) {
    const Edge_index e(random() % 3);
    const Delta_complex& intrinsic = overlay.intrinsic();
    const Halfedge_index h = intrinsic.halfedge(e);
    const auto vector = [&](Halfedge_index g) {
      const Vector v = vectors[g.idx() / 2];
      return g.idx() % 2 == 0 ? v : Vector{-v[0], -v[1]};
    };
    // From l to k: back along il, and back along ki.
    const Vector il = vector(intrinsic.next(intrinsic.opposite(h))), ki = vector(intrinsic.prev(h));
    const Vector lk{-il[0] - ki[0], -il[1] - ki[1]};
    if (std::max(std::abs(lk[0]), std::abs(lk[1])) > 200)
      continue;
    vectors[e.idx()] = lk;
    overlay.flip(e);
    for (Edge_index edge : intrinsic.edges()) {
      const auto [x, y] = vectors[edge.idx()];
      const long steps = std::abs(x) + std::abs(y) + std::abs(x - y);
      const auto crossed = overlay.crossing_input_halfedges(intrinsic.halfedge(edge));
      EXPECT_EQ(long(crossed.size()), steps == 2 ? 0 : steps - 3);
    }
  }
}

TEST(Incremental_overlay, IsTheOtherOverlayAfterEveryFlipOfGenericSurfaces)
{
  std::size_t flips = 0;
  for (bool is_small : {true, false})
    for (const Surface& surface : generic_surfaces(is_small))
      flips += expect_same_after_every_flip(surface).flips;
  EXPECT_GT(flips, 400u);
}

TEST(Incremental_overlay, IsTheOtherOverlayAfterEveryFlipOfSampleSurfaces)
{
  const std::vector<Surface> surfaces{from_triangles("prism", samples::prism(40)),
                                      from_triangles("turned prism", samples::prism(15, 1)),
                                      from_triangles("cap", samples::cap()),
                                      from_triangles("flat cap", samples::cap(0)),
                                      from_triangles("Schwarz lantern", samples::Schwarz_lantern()),
                                      from_triangles("pillow", samples::pillow(40)),
                                      from_triangles("strip", samples::strip(60, 20)),
                                      from_triangles("sheared grid", samples::sheared_grid(8, 8)),
                                      from_triangles("bad torus", samples::bad_torus(14, 12)),
                                      from_triangles("sphere", samples::latitude_longitude_sphere(16, 8)),
                                      from_triangles("disk with spike", samples::disk_with_spike(10, 9)),
                                      from_gluing("torus", samples::one_vertex_torus(3, 4, 5)),
                                      from_gluing("torus", samples::sheared_one_vertex_torus(100)),
                                      from_gluing("cone", samples::self_glued_triangle()),
                                      from_gluing("cones", samples::self_glued_sphere()),
                                      from_gluing("wide cones", samples::self_glued_sphere(1, 100, 1))};
  std::size_t flips = 0;
  for (const Surface& surface : surfaces)
    flips += expect_same_after_every_flip(surface).flips;
  EXPECT_GT(flips, 2500u);
}

TEST(Incremental_overlay, IsTheOtherOverlayAfterEveryFlipOfHelicalTubes)
{
  std::uint32_t most_crossings = 0;
  for (std::size_t n : {4, 5, 7, 12, 40})
    for (double pitch : {1., 7., 30., 200.})
      most_crossings =
        std::max(most_crossings,
                 expect_same_after_every_flip(from_triangles("tube", samples::helical_tube(n, pitch))).most_crossings);
  EXPECT_GT(most_crossings, 100u);
}

TEST(Incremental_overlay, IsTheOtherOverlayAfterEveryFlipOfRandomGluings)
{
  std::size_t flips = 0;
  for (std::uint64_t seed = 0; seed < 600 && !HasFailure(); ++seed) {
    const std::size_t n = 1 + seed % 37;
    const bool with_boundary = n % 2 == 1 || seed % 3 == 0;
    flips += expect_same_after_every_flip(
               from_gluing(std::to_string(seed), samples::random_gluing(n, seed, with_boundary, seed % 2 == 0)))
               .flips;
  }
  EXPECT_GT(flips, 300u);
}

// With a metric: back and forth between triangulations by straight edges.
TEST(Incremental_overlay, IsTheOtherOverlayAfterRandomFlipsOfConvexHinges)
{
  using Traits = IT::Edge_length_traits<double>;
  std::uint32_t most_crossings = 0;
  std::size_t flips = 0;
  for (const Surface& surface : generic_surfaces(true))
    for (unsigned seed = 0; seed < 3; ++seed) {
      SCOPED_TRACE(surface.name);
      auto t = triangulation<Traits>(surface);
      t.keep_input(surface.points.empty()
                     ? IT::Input_metric::from_lengths({surface.lengths.begin(), surface.lengths.end()})
                     : IT::Input_metric::from_points([&] {
                         IT::Input_metric::Point_vector points;
                         for (const auto& p : surface.points)
                           points.push_back({p[0], p[1], p[2]});
                         return points;
                       }()));
      Comparing_visitor<Traits> comparison(t);
      flip_at_random(
        t.connectivity(), seed, 600,
        [&](Edge_index e) {
          if (comparison.most_crossings > 20000 ||
              t.flip(e) != IT::Intrinsic_triangulation<Traits>::Flip_outcome::FLIPPED)
            return false;
          comparison.after_flip(e);
          return true;
        },
        [&] { return comparison.is_same; });
      most_crossings = std::max(most_crossings, comparison.most_crossings);
      flips += comparison.flips;
    }
  EXPECT_GT(most_crossings, 500u);
  EXPECT_GT(flips, 5000u);
}

// Neither way uses lengths, so that any edge between two faces can be flipped.
TEST(Incremental_overlay, IsTheOtherOverlayAfterAnyFlips)
{
  std::size_t coincidences = 0, flips = 0;
  for (unsigned seed = 0; seed < 400 && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    const bool with_boundary = seed % 3 == 0;
    const std::size_t n = with_boundary ? 1 + seed % 9 : 2 + 2 * (seed % 5);
    const auto gluing = samples::random_gluing(n, seed, with_boundary, seed % 2 == 0);
    Both_ways both(IT::make_Delta_complex_from_gluing(gluing.number_of_faces, gluing.glued_sides));
    std::uint32_t crossings = 0;
    flip_at_random(
      both.complex, seed, 80,
      [&](Edge_index e) {
        if (crossings > 2000)
          return false;
        const bool was_original = both.correspondence.coordinates().is_original(e);
        both.flip(e);
        coincidences += !was_original && both.correspondence.coordinates().is_original(e);
        return true;
      },
      [&] {
        ++flips;
        crossings = both.incremental.number_of_crossings();
        return is_valid(both.incremental) && are_same_overlay(both.overlay(), both.incremental);
      });
  }
  EXPECT_GT(coincidences, 1000u); // edges that landed on an input edge
  EXPECT_GT(flips, 10000u);
}

TEST(Incremental_overlay, ListsWhatCrossesAnEdge)
{
  for (const Surface& surface : generic_surfaces(false)) {
    SCOPED_TRACE(surface.name);
    auto t = triangulation<IT::Filtered_edge_length_traits>(surface);
    Incremental_overlay incremental(t.connectivity());
    IT::flip_to_Delaunay(t, CGAL::parameters::visitor(std::ref(incremental)));
    const Overlay overlay(t);
    const auto reversed = [](Halfedges list) {
      std::reverse(list.begin(), list.end());
      for (Halfedge_index& h : list)
        h = Halfedge_index(h.idx() ^ 1);
      return list;
    };
    for (Edge_index e : t.connectivity().edges()) {
      Halfedges expected;
      for (Overlay::Vertex x : overlay.intrinsic_crossings(e))
        expected.push_back(overlay.crossing_input_halfedge(x));
      const Halfedge_index h = t.connectivity().halfedge(e);
      EXPECT_EQ(incremental.crossing_input_halfedges(h), expected);
      EXPECT_EQ(incremental.crossing_input_halfedges(t.connectivity().opposite(h)), reversed(expected));
    }
    for (Edge_index e : incremental.input().edges()) {
      Halfedges expected;
      for (std::uint32_t i = 0; i + 1 < overlay.number_of_input_segments(e); ++i)
        expected.push_back(overlay.intrinsic_halfedge(overlay.next(overlay.input_part(e, i))));
      const Halfedge_index h = incremental.input().halfedge(e);
      EXPECT_EQ(incremental.crossing_intrinsic_halfedges(h), expected);
      EXPECT_EQ(incremental.crossing_intrinsic_halfedges(incremental.input().opposite(h)), reversed(expected));
    }
  }
}

// The comparison must be able to fail.
TEST(Incremental_overlay, DiffersFromTheOverlayOfOtherFlips)
{
  const auto gluing = samples::random_gluing(8, 3);
  Both_ways both(IT::make_Delta_complex_from_gluing(gluing.number_of_faces, gluing.glued_sides));
  const Incremental_overlay before = both.incremental;
  const Edge_index e(0);
  ASSERT_TRUE(both.complex.is_flippable(e));
  both.flip(e);
  EXPECT_TRUE(are_same_overlay(both.overlay(), both.incremental));
  EXPECT_FALSE(are_same_overlay(both.overlay(), before));
  // Two flips more: the same triangulation with edge e the other way round.
  Incremental_overlay turned = both.incremental;
  turned.flip(e);
  turned.flip(e);
  EXPECT_TRUE(is_valid(turned));
  EXPECT_FALSE(are_same_overlay(both.overlay(), turned));
}
