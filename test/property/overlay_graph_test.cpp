// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The overlay is the graph of section 2.3 of the paper, and both triangulations can be read back from it.

#include "insert_random_vertices.h"
#include "overlay_triangulations.h"
#include "property/flip_test_surfaces.h"

#include "library/engine/history/Flip_log.h"
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include "library/engine/history/Crossing_sequence.h"
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <variant>
#include <vector>

namespace {

using namespace test_surfaces;
using IT::Delta_complex;
using IT::Edge_index;
using IT::Face_index;
using IT::Halfedge_index;
using IT::Overlay;
using IT::Segment_label;
using IT::Vertex_index;
using IT::internal::Correspondence;

// Assertions about an overlay; the first failure ends them.
class Overlay_check
{
public:
  Overlay_check(const Delta_complex& intrinsic, const IT::internal::Correspondence& correspondence)
    : intrinsic_(intrinsic), input_(correspondence.input()), correspondence_(correspondence),
      coordinates_(correspondence.coordinates()), overlay_(intrinsic, correspondence)
  {}

  const Overlay& overlay() const { return overlay_; }

  void run() const
  {
    ASSERT_NO_FATAL_FAILURE(check_labels());
    ASSERT_NO_FATAL_FAILURE(check_faces());
    ASSERT_NO_FATAL_FAILURE(check_crossings());
    ASSERT_NO_FATAL_FAILURE(check_intrinsic_edges());
    ASSERT_NO_FATAL_FAILURE(check_input_edges());
    ASSERT_NO_FATAL_FAILURE(check_sequences());
    ASSERT_NO_FATAL_FAILURE(check_sides());
    for (Overlay::Vertex v : overlay_.vertices())
      if (overlay_.halfedge(v).is_valid()) {
        ASSERT_EQ(overlay_.target(overlay_.halfedge(v)), v);
      }
    const Delta_complex intrinsic = intrinsic_triangulation_of(overlay_), input = input_triangulation_of(overlay_);
    EXPECT_TRUE(intrinsic.is_valid(true) && are_same_links(intrinsic, intrinsic_));
    EXPECT_TRUE(input.is_valid(true) && are_same_links(input, input_));
  }

private:
  using Part = Overlay::Halfedge;

  // The parts that leave the vertex in which h ends, counterclockwise from the opposite of h.
  std::vector<Part> around_target(Part h) const
  {
    std::vector<Part> parts;
    Part out = overlay_.opposite(h);
    do {
      parts.push_back(out);
      out = overlay_.next(overlay_.opposite(out)); // clockwise
    } while (out != overlay_.opposite(h) && parts.size() < 10);
    std::reverse(parts.begin() + 1, parts.end());
    return parts;
  }

  void check_labels() const
  {
    for (Part h : overlay_.halfedges()) {
      const Halfedge_index intrinsic = overlay_.intrinsic_halfedge(h), input = overlay_.input_halfedge(h);
      const Segment_label label = overlay_.label(overlay_.segment(h));
      ASSERT_EQ(intrinsic.is_valid(), label != Segment_label::INPUT);
      ASSERT_EQ(input.is_valid(), label != Segment_label::INTRINSIC);
      if (intrinsic.is_valid()) {
        ASSERT_EQ(overlay_.intrinsic_halfedge(overlay_.opposite(h)), intrinsic_.opposite(intrinsic));
        ASSERT_EQ(label == Segment_label::BOTH, coordinates_.is_original(intrinsic_.edge(intrinsic)));
      }
      if (input.is_valid()) {
        ASSERT_EQ(overlay_.input_halfedge(overlay_.opposite(h)), input_.opposite(input));
      }
    }
  }

  void check_faces() const
  {
    std::vector<bool> is_visited(overlay_.number_of_halfedges(), false), is_known(overlay_.number_of_faces(), false);
    std::int64_t number_of_faces = 0;
    for (Part first : overlay_.halfedges()) {
      if (is_visited[first.idx()])
        continue;
      const Overlay::Face f = overlay_.face(first);
      int sides = 0;
      Part h = first;
      do {
        ASSERT_FALSE(is_visited[h.idx()]);
        is_visited[h.idx()] = true;
        ASSERT_EQ(overlay_.face(h), f);
        ASSERT_EQ(overlay_.source(overlay_.next(h)), overlay_.target(h));
        const Halfedge_index intrinsic = overlay_.intrinsic_halfedge(h), input = overlay_.input_halfedge(h);
        if (intrinsic.is_valid()) {
          ASSERT_EQ(intrinsic_.face(intrinsic), f.is_valid() ? overlay_.intrinsic_face(f) : Face_index());
        }
        if (input.is_valid()) {
          ASSERT_EQ(input_.face(input), f.is_valid() ? overlay_.input_face(f) : Face_index());
        }
        ++sides;
        h = overlay_.next(h);
      } while (h != first);
      if (!f.is_valid())
        continue;
      ++number_of_faces;
      ASSERT_GE(sides, 3);
      ASSERT_LE(sides, 6); // two triangles
      ASSERT_FALSE(is_known[f.idx()]);
      is_known[f.idx()] = true;
      ASSERT_EQ(overlay_.face(overlay_.halfedge(f)), f);
    }
    ASSERT_EQ(number_of_faces, overlay_.number_of_faces());
    ASSERT_EQ(std::int64_t(overlay_.number_of_vertices()) - std::int64_t(overlay_.number_of_segments()) +
                number_of_faces,
              std::int64_t(input_.number_of_vertices()) - std::int64_t(input_.number_of_edges()) +
                std::int64_t(input_.number_of_faces()));
  }

  void check_crossings() const
  {
    for (Overlay::Vertex x : overlay_.crossings()) {
      const Part h = overlay_.halfedge(x);
      const std::vector<Part> parts = around_target(h);
      ASSERT_EQ(parts.size(), 4u);
      const auto label = [&](int i) { return overlay_.label(overlay_.segment(parts[i])); };
      for (int i : {0, 2}) {
        ASSERT_EQ(label(i), Segment_label::INTRINSIC);
        ASSERT_EQ(label(i + 1), Segment_label::INPUT);
      }
      const Halfedge_index intrinsic = overlay_.intrinsic_halfedge(h);
      ASSERT_EQ(intrinsic, intrinsic_.halfedge(overlay_.intrinsic_edge(x)));
      ASSERT_EQ(overlay_.intrinsic_halfedge(parts[0]), intrinsic_.opposite(intrinsic));
      ASSERT_EQ(overlay_.intrinsic_halfedge(parts[2]), intrinsic);
      // Counterclockwise from behind: the right, ahead, the left.
      const Halfedge_index input = overlay_.crossing_input_halfedge(x);
      ASSERT_EQ(overlay_.input_halfedge(parts[1]), input_.opposite(input));
      ASSERT_EQ(overlay_.input_halfedge(parts[3]), input);
      ASSERT_EQ(input_.edge(input), overlay_.input_edge(x));
      ASSERT_EQ(*(overlay_.intrinsic_crossings(overlay_.intrinsic_edge(x)).begin() + overlay_.intrinsic_position(x)),
                x);
      ASSERT_EQ(overlay_.input_crossing(overlay_.input_edge(x), overlay_.input_position(x)), x);
    }
  }

  void check_intrinsic_edges() const
  {
    std::size_t crossings = 0;
    for (Edge_index e : intrinsic_.edges()) {
      const Halfedge_index h = intrinsic_.halfedge(e);
      const auto passed = overlay_.intrinsic_crossings(e);
      ASSERT_EQ(std::int64_t(passed.size()), coordinates_.number_of_crossings(e));
      ASSERT_EQ(overlay_.intrinsic_segments(e).size(), passed.size() + 1);
      crossings += passed.size();
      auto x = passed.begin();
      for (Overlay::Segment s : overlay_.intrinsic_segments(e)) {
        const Part part = overlay_.halfedge(s);
        ASSERT_EQ(overlay_.intrinsic_halfedge(part), h);
        ASSERT_EQ(overlay_.source(part).idx(), x == passed.begin() ? intrinsic_.source(h).idx() : (*(x - 1)).idx());
        ASSERT_EQ(overlay_.target(part).idx(), x == passed.end() ? intrinsic_.target(h).idx() : (*x).idx());
        if (x != passed.end())
          ++x;
      }
    }
    ASSERT_EQ(crossings, overlay_.number_of_crossings());
  }

  void check_input_edges() const
  {
    std::size_t crossings = 0;
    for (Edge_index e : input_.edges()) {
      const Halfedge_index h = input_.halfedge(e);
      const std::uint32_t n = overlay_.number_of_input_segments(e);
      crossings += n - 1;
      for (std::uint32_t i = 0; i < n; ++i) {
        const Part part = overlay_.input_part(e, i);
        ASSERT_EQ(overlay_.input_halfedge(part), h);
        ASSERT_EQ(overlay_.source(part).idx(),
                  i == 0 ? input_.source(h).idx() : overlay_.input_crossing(e, i - 1).idx());
        ASSERT_EQ(overlay_.target(part).idx(),
                  i + 1 == n ? input_.target(h).idx() : overlay_.input_crossing(e, i).idx());
      }
    }
    std::size_t inserted_on_edges = 0;
    for (std::uint32_t v = input_.number_of_vertices(); v < intrinsic_.number_of_vertices(); ++v)
      inserted_on_edges += correspondence_.location(Vertex_index(v)).dimension() == 1 ? 1 : 0;
    ASSERT_EQ(crossings, overlay_.number_of_crossings() + inserted_on_edges);
  }

  // The same order as the overlay's, found edge by edge.
  void check_sequences() const
  {
    for (Edge_index e : intrinsic_.edges()) {
      IT::internal::Interruption none;
      const IT::internal::Crossing_sequence sequence(intrinsic_, correspondence_, intrinsic_.halfedge(e), none);
      const auto crossings = overlay_.intrinsic_crossings(e);
      for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
        // From left to right; one of the other two sides of the triangle ahead is next.
        const Halfedge_index crossed =
          input_.opposite(overlay_.crossing_input_halfedge(*(crossings.begin() + std::ptrdiff_t(i))));
        ASSERT_EQ(sequence.turns_left(i) ? input_.prev(crossed) : input_.next(crossed),
                  overlay_.crossing_input_halfedge(*(crossings.begin() + std::ptrdiff_t(i + 1))));
      }
    }
  }

  void check_sides() const
  {
    for (Part h : overlay_.halfedges()) {
      if (overlay_.is_border(h))
        continue;
      const Halfedge_index input = overlay_.input_side(h), intrinsic = overlay_.intrinsic_side(h);
      if (input.is_valid()) {
        ASSERT_EQ(input_.face(input), overlay_.input_face(overlay_.face(h)));
      } else {
        ASSERT_EQ(input_.face(correspondence_.location(overlay_.original_vertex(overlay_.target(h))).halfedge),
                  overlay_.input_face(overlay_.face(h)));
      }
      ASSERT_EQ(intrinsic_.face(intrinsic), overlay_.intrinsic_face(overlay_.face(h)));
      const Overlay::Vertex v = overlay_.target(h);
      if (overlay_.is_crossing(v)) {
        ASSERT_EQ(input_.edge(input), overlay_.input_edge(v));
        ASSERT_EQ(intrinsic_.edge(intrinsic), overlay_.intrinsic_edge(v));
      } else {
        if (!overlay_.is_inserted(v)) {
          ASSERT_EQ(input_.source(input), overlay_.original_vertex(v));
        }
        ASSERT_EQ(intrinsic_.source(intrinsic), overlay_.original_vertex(v));
      }
    }
  }

  const Delta_complex& intrinsic_;
  const Delta_complex& input_;
  const IT::internal::Correspondence& correspondence_;
  const IT::internal::Normal_coordinates& coordinates_;
  Overlay overlay_;
};

// Returns the number of crossings.
std::size_t check_Delaunay_overlay(const Surface& surface)
{
  SCOPED_TRACE(surface.name);
  auto t = triangulation<IT::Filtered_edge_length_traits>(surface);
  IT::flip_to_Delaunay(t);
  const Overlay_check check(t.connectivity(), IT::internal::engine(t).correspondence());
  check.run();
  return check.overlay().number_of_crossings();
}

} // namespace

TEST(Overlay_graph, OfGenericSurfaces)
{
  std::size_t crossings = 0;
  for (bool is_small : {true, false})
    for (const Surface& surface : generic_surfaces(is_small))
      crossings += check_Delaunay_overlay(surface);
  EXPECT_GT(crossings, 500u);
}

TEST(Overlay_graph, OfSampleSurfaces)
{
  for (const samples::Sample& sample : samples::sample_names()) {
    const auto surface = samples::make_sample(sample.name);
    if (std::holds_alternative<samples::Indexed_triangles>(surface))
      check_Delaunay_overlay(from_triangles(sample.name, std::get<samples::Indexed_triangles>(surface)));
    else
      check_Delaunay_overlay(from_gluing(sample.name, std::get<samples::Glued_triangles>(surface)));
  }
}

TEST(Overlay_graph, of_inserted_vertices)
{
  std::mt19937 random(1);
  for (const samples::Sample& sample : samples::sample_names()) {
    SCOPED_TRACE(sample.name);
    const auto surface = samples::make_sample(sample.name);
    if (!std::holds_alternative<samples::Indexed_triangles>(surface))
      continue;
    auto t = triangulation<IT::Filtered_edge_length_traits>(
      from_triangles(sample.name, std::get<samples::Indexed_triangles>(surface)));
    IT::flip_to_Delaunay(t);
    for (unsigned largest_coordinate : {2u, 1000u}) {
      EXPECT_GT(IT::insert_random_vertices(t, 200, largest_coordinate, random), 10u);
      const Overlay_check check(t.connectivity(), IT::internal::engine(t).correspondence());
      check.run();
    }
  }
}

TEST(Overlay_graph, OfUnflippedAndIsolated)
{
  samples::Indexed_triangles triangles = samples::prism(5);
  triangles.points.push_back({9, 9, 9});
  const auto t = triangulation<IT::Filtered_edge_length_traits>(from_triangles("prism", triangles));
  const Overlay_check check(t.connectivity(), IT::internal::engine(t).correspondence());
  check.run();
  EXPECT_EQ(check.overlay().number_of_crossings(), 0u);
  EXPECT_EQ(check.overlay().number_of_segments(), t.connectivity().number_of_edges());
  EXPECT_FALSE(check.overlay().halfedge(Overlay::Vertex(10)).is_valid());
}

// Straight or not, the integers describe a graph.
TEST(Overlay_graph, OfRandomGluingsAfterAnyFlips)
{
  std::size_t crossings = 0;
  for (unsigned seed = 0; seed < 1000 && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    const bool with_boundary = seed % 3 == 0;
    const std::size_t n = with_boundary ? 1 + seed % 13 : 2 + 2 * (seed % 7);
    const auto gluing = samples::random_gluing(n, seed, with_boundary, seed % 2 == 0);
    Delta_complex complex = IT::make_Delta_complex_from_gluing(gluing.number_of_faces, gluing.glued_sides);
    const bool is_followed = seed % 4 < 2; // or else found after the flips
    IT::internal::Correspondence correspondence;
    IT::internal::Flip_log log;
    if (is_followed)
      correspondence.catch_up(complex, log);
    std::mt19937 random(seed);
    for (int i = int(seed % 20); i > 0; --i) {
      const Edge_index e(std::uint32_t(random() % complex.number_of_edges()));
      if (!complex.is_flippable(e))
        continue;
      if (is_followed)
        correspondence.flip(complex, complex.hinge(e));
      else
        log.push_back(complex.hinge(e));
      complex.flip(e);
    }
    if (!is_followed)
      correspondence.catch_up(complex, log);
    const Overlay_check check(complex, correspondence);
    check.run();
    crossings += check.overlay().number_of_crossings();
  }
  EXPECT_GT(crossings, 10000u);
}
