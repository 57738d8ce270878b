// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Images of corners in finite fields, carried along by the flips, find exactly the ties among near ties, as points in
// the plane confirm.

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include "library/engine/layout/metric_images.h"
#include <CGAL/Intrinsic_triangulations/intrinsic_Delaunay_triangulation.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/squared_lengths.h>
#include <CGAL/Intrinsic_triangulations/verify_Delaunay.h>

#include <CGAL/enum.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

using IT::internal::Integer;
using IT::internal::Rational;

// A sheared grid in the plane, whose Delaunay triangulation has unit squares: their diagonals are ties. Some of its
// points are moved by so little that double-doubles do not see it. It is given by lengths alone, so that its flatness
// is not known, and all areas are rational.
class Nearly_square_grid
{
public:
  Nearly_square_grid(std::uint32_t n, std::uint32_t seed)
  {
    std::mt19937 random(seed);
    for (std::uint32_t j = 0; j <= n; ++j)
      for (std::uint32_t i = 0; i <= n; ++i) {
        points_.push_back({Rational(i + 3 * j), Rational(j)});
        if (random() % 6 == 0)
          points_.back()[random() % 2] +=
            Rational(Integer(random() % 2 == 0 ? 1 : -1), Integer(1) << (110 + random() % 200));
      }
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (std::uint32_t j = 0; j < n; ++j)
      for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t v = (n + 1) * j + i;
        triangles.push_back({v, v + 1, v + n + 2});
        triangles.push_back({v, v + n + 2, v + n + 1});
      }
    complex_ = IT::make_Delta_complex_from_triangles(points_.size(), triangles);
  }

  Triangulation triangulation() const
  {
    std::vector<Rational> squared_lengths;
    for (IT::Edge_index e : complex_.edges()) {
      const Vector u = difference(complex_.source(complex_.halfedge(e)), complex_.target(complex_.halfedge(e)));
      squared_lengths.push_back(u[0] * u[0] + u[1] * u[1]);
    }
    return Triangulation::from_metric(complex_, IT::metric_from_squared_lengths(squared_lengths));
  }

  // Decided from the points.
  CGAL::Sign sign_of_cotangents(const IT::Delta_complex& complex, IT::Edge_index e) const
  {
    const IT::Halfedge_index h = complex.halfedge(e);
    const Corner k = corner(complex, h), l = corner(complex, complex.opposite(h));
    EXPECT_TRUE(k.area > 0 && l.area > 0);
    return CGAL::sign(int((k.product * l.area + l.product * k.area).sign()));
  }

private:
  using Vector = std::array<Rational, 2>;
  struct Corner
  {
    Rational product, area;
  };

  Vector difference(IT::Vertex_index v, IT::Vertex_index w) const
  {
    return {points_[w.idx()][0] - points_[v.idx()][0], points_[w.idx()][1] - points_[v.idx()][1]};
  }
  Corner corner(const IT::Delta_complex& complex, IT::Halfedge_index h) const
  {
    const IT::Vertex_index k = complex.target(complex.next(h));
    const Vector u = difference(k, complex.source(h)), v = difference(k, complex.target(h));
    return {u[0] * v[0] + u[1] * v[1], u[0] * v[1] - u[1] * v[0]};
  }

  std::vector<Vector> points_;
  IT::Delta_complex complex_;
};

TEST(Carried_images, are_zero_at_ties_alone)
{
  std::uint64_t by_images = 0, near_ties = 0;
  std::size_t ties = 0;
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE(seed);
    const Nearly_square_grid grid(12, seed);
    Triangulation t = grid.triangulation();
    ASSERT_EQ(IT::flip_to_Delaunay(t).status, IT::Flip_status::DELAUNAY);
    std::size_t ties_of_points = 0;
    for (IT::Edge_index e : t.connectivity().edges())
      if (t.connectivity().is_flippable(e)) {
        const CGAL::Sign sign = grid.sign_of_cotangents(t.connectivity(), e);
        EXPECT_NE(sign, CGAL::NEGATIVE);
        EXPECT_EQ(t.sign_of_cotangent_weight(e), sign);
        ties_of_points += sign == CGAL::ZERO;
      }
    EXPECT_EQ(IT::verify_Delaunay(t).ties, ties_of_points);
    ties += ties_of_points;
    by_images += t.stage_counts()[IT::Stage::MODULAR];
    near_ties += t.stage_counts()[IT::Stage::ALGEBRAIC] + t.stage_counts()[IT::Stage::MULTIPRECISION];
  }
  EXPECT_GT(by_images, 1000u);
  EXPECT_GT(near_ties, 1000u);
  EXPECT_GT(ties, 1000u);
}

// The bound on the error knows how long the numbers of this surface are: with that for any doubles, images would not be
// believed where an edge crosses more than some 2,000 input edges, and each tie would need a proof in rational numbers.
TEST(Carried_images, are_believed_where_thousands_of_edges_are_crossed)
{
  const samples::Indexed_triangles pillow = samples::pillow(1000);
  Triangulation t = IT::intrinsic_Delaunay_triangulation(pillow.points, pillow.triangles).triangulation;
  std::int64_t most_crossings = 0;
  for (IT::Edge_index e : t.connectivity().edges())
    most_crossings = (std::max)(most_crossings, t.number_of_crossings(e));
  EXPECT_GT(most_crossings, 1000);
  EXPECT_GT(t.stage_counts()[IT::Stage::MODULAR], 500u);
  EXPECT_LT(t.stage_counts()[IT::Stage::ALGEBRAIC], 10u);
}

// The coordinates of points on the input are any doubles.
TEST(Carried_images, points_make_longer_numbers)
{
  const samples::Indexed_triangles square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  const IT::Delta_complex complex = IT::make_Delta_complex_from_triangles(square.points.size(), square.triangles);
  const auto metric = IT::Input_metric::from_points({square.points.begin(), square.points.end()});
  const IT::internal::Decisions decisions;
  IT::internal::Input_properties properties(complex, metric);
  IT::internal::Input_surface surface(complex, metric, decisions, properties);
  IT::internal::Residue_rings rings(surface.prime_fields(0), decisions.interruption);
  IT::internal::Residue_metric image(surface, {rings});
  image.constant(0);
  image.constant(1);
  EXPECT_LT(image.largest_size(), 1000);
  image.constant(0.1);
  EXPECT_GT(image.largest_size(), 2 * 2 * 1074);
}

} // namespace
