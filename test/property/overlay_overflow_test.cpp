// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// If edges cross too many others, the answer is right or there is a clear error.

#include "samples/sample_surfaces.h"

#include "library/engine/history/Flip_log.h"
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/squared_lengths.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Edge_index;
using IT::Halfedge_index;
using Rational = IT::Rational;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;
using Vector = std::array<std::int64_t, 2>;

// The one-vertex torus of the lattice of u and v, with the edges u, v and u + v: exactly.
Triangulation torus(const Vector& u, const Vector& v)
{
  const auto gluing = samples::one_vertex_torus();
  const auto squared_length = [](std::int64_t x, std::int64_t y) { return Rational(x) * x + Rational(y) * y; };
  return Triangulation::from_metric(
    IT::make_Delta_complex_from_gluing(gluing.number_of_faces, gluing.glued_sides),
    IT::metric_from_squared_lengths(
      {squared_length(u[0], u[1]), squared_length(v[0], v[1]), squared_length(u[0] + v[0], u[1] + v[1])}));
}

// Follows the edges of that torus in the basis (u, v), which determines their crossings.
class Torus_edges
{
public:
  void flip(const IT::Delta_complex& complex, Edge_index e)
  {
    const Halfedge_index h = complex.halfedge(e);
    const Vector il = vector(complex.next(complex.opposite(h))), ki = vector(complex.prev(h));
    vectors_[e.idx()] = {-il[0] - ki[0], -il[1] - ki[1]};
  }

  // It meets the lines along u, v and u + v in this many points, its ends aside.
  std::int64_t crossings(Edge_index e) const
  {
    const auto [x, y] = vectors_[e.idx()];
    const std::int64_t n = std::abs(x) + std::abs(y) + std::abs(x - y) - 3;
    return n < 0 ? -1 : n;
  }

  const Vector& vector(Edge_index e) const { return vectors_[e.idx()]; }

private:
  Vector vector(Halfedge_index h) const
  {
    const Vector& v = vectors_[h.idx() / 2];
    return h.idx() % 2 == 0 ? v : Vector{-v[0], -v[1]};
  }

  std::array<Vector, 3> vectors_{Vector{1, 0}, Vector{0, 1}, Vector{-1, -1}};
};

// The integers of a torus whose edges are flipped in turn: the number of their crossings grows like the Fibonacci
// numbers.
struct Grown_torus
{
  explicit Grown_torus(std::int64_t number)
  {
    const auto gluing = samples::one_vertex_torus();
    complex = IT::make_Delta_complex_from_gluing(gluing.number_of_faces, gluing.glued_sides);
    correspondence.catch_up(complex, IT::internal::Flip_log());
    while (edges.crossings(last) <= number)
      flip();
  }

  void flip()
  {
    const Edge_index e((last.idx() + 1) % 3);
    correspondence.flip(complex, complex.hinge(e));
    edges.flip(complex, e);
    complex.flip(e);
    last = e;
  }

  void expect_right_counts() const
  {
    for (Edge_index e : complex.edges())
      EXPECT_EQ(correspondence.coordinates().crossings(e), edges.crossings(e));
  }

  IT::Delta_complex complex;
  IT::internal::Correspondence correspondence;
  Torus_edges edges;
  Edge_index last{2};
};

} // namespace

TEST(Overlay_overflow, CountsAreRightUpToTheLastOneAndThenAnError)
{
  Grown_torus torus(1000);
  while (torus.edges.crossings(torus.last) < std::int64_t(1) << 59) {
    torus.flip();
    torus.expect_right_counts();
  }
  IT::Delta_complex before;
  const auto flip_twice = [&] {
    for (int i = 0; i < 2; ++i) {
      before = torus.complex;
      torus.flip();
    }
  };
  EXPECT_THROW(flip_twice(), IT::Integer_overflow_error);
  EXPECT_TRUE(torus.complex == before);
  torus.expect_right_counts();
}

// Flips that are only noted cause an error when the integers are read.
TEST(Overlay_overflow, NotesThatLeadBeyondTheLastCountAreAnError)
{
  Grown_torus torus(0);
  IT::Delta_complex complex = torus.complex;
  IT::internal::Correspondence correspondence;
  IT::internal::Flip_log log;
  for (unsigned i = 0; i < 130; ++i) {
    const Edge_index e(i % 3);
    log.push_back(complex.hinge(e));
    complex.flip(e);
  }
  for (int again = 0; again < 2; ++again) {
    EXPECT_THROW(correspondence.catch_up(complex, log), IT::Integer_overflow_error);
    EXPECT_FALSE(correspondence.knows_input());
  }
}

TEST(Overlay_overflow, LargeCountsGiveTheRightOverlay)
{
  const Grown_torus torus(300000);
  const IT::Overlay overlay(torus.complex, torus.correspondence);
  std::int64_t crossings = 0;
  for (Edge_index e : torus.complex.edges()) {
    EXPECT_EQ(std::int64_t(overlay.intrinsic_crossings(e).size()), torus.edges.crossings(e));
    crossings += torus.edges.crossings(e);
  }
  EXPECT_EQ(overlay.number_of_crossings(), crossings);
}

TEST(Overlay_overflow, AnOverlayOfTooManySegmentsIsAnErrorAtOnce)
{
  for (std::int64_t number : {std::int64_t(1) << 31, std::int64_t(1000000000000), std::int64_t(1) << 59}) {
    const Grown_torus torus(number);
    torus.expect_right_counts();
    EXPECT_THROW(IT::Overlay(torus.complex, torus.correspondence), IT::Integer_overflow_error);
  }
}

// Thousands of crossings are laid out; with too many, the flip fails with a message.
TEST(Overlay_overflow, LengthsAreRightOrThereIsAnError)
{
  Triangulation t = torus({3, 1}, {1, 2});
  Torus_edges edges;
  const auto flip_on = [&] {
    for (int i = 0; i < 100; ++i) {
      const Edge_index e(std::uint32_t(i % 3));
      edges.flip(t.connectivity(), e);
      ASSERT_EQ(t.flip(e), Triangulation::Flip_outcome::FLIPPED);
      if (edges.crossings(e) < 20000) {
        const auto [x, y] = edges.vector(e);
        EXPECT_DOUBLE_EQ(t.length(e), std::hypot(double(3 * x + y), double(x + 2 * y)));
        EXPECT_DOUBLE_EQ(t.area(IT::Face_index(0)), 2.5);
      }
    }
  };
  EXPECT_THROW(flip_on(), IT::Undecided_error);
}

TEST(Overlay_overflow, AShearOfATrillionNeedsMoreFlipsThanAllowed)
{
  const std::int64_t shear = 1000000000000, budget = 1000;
  Triangulation t = torus({1, 0}, {shear, 1});
  const IT::Flip_report report = IT::flip_to_Delaunay(t, CGAL::parameters::maximum_number(std::uint64_t(budget)));
  EXPECT_EQ(report.status, IT::Flip_status::BUDGET_EXHAUSTED);
  EXPECT_EQ(report.flips, std::uint64_t(budget));
  // Each flip takes one step back: the edges (1, 0), (shear - 1000, 1) and (shear - 999, 1).
  EXPECT_EQ(t.length(Edge_index(0)), 1);
  std::vector<double> lengths{t.length(Edge_index(1)), t.length(Edge_index(2))};
  std::sort(lengths.begin(), lengths.end());
  EXPECT_EQ(lengths, (std::vector<double>{double(shear - budget), double(shear - budget + 1)}));
  const auto& coordinates = IT::internal::engine(t).correspondence().coordinates();
  // -budget u + v and (1 - budget) u + v
  EXPECT_EQ(std::max(coordinates.crossings(Edge_index(1)), coordinates.crossings(Edge_index(2))), 2 * budget - 1);
  EXPECT_EQ(std::min(coordinates.crossings(Edge_index(1)), coordinates.crossings(Edge_index(2))), 2 * budget - 3);
  EXPECT_EQ(IT::Overlay(t).number_of_crossings(), 4 * budget - 4);
}

TEST(Overlay_overflow, AShearThatFlipsUndo)
{
  Triangulation t = torus({1, 0}, {500, 1});
  EXPECT_EQ(IT::flip_to_Delaunay(t).status, IT::Flip_status::DELAUNAY);
  std::vector<double> lengths;
  for (Edge_index e : t.connectivity().edges())
    lengths.push_back(t.length(e));
  std::sort(lengths.begin(), lengths.end());
  EXPECT_EQ(lengths, (std::vector<double>{1, 1, std::sqrt(2.)}));
}
