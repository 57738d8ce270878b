// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lengths whose squares and products leave the range of double: defects are still refused, and bounds and areas hold.

#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/squared_lengths.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/hinge_formulas.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Defect = IT::Invalid_surface_error::Defect;
using Rational = IT::Rational;

// Two triangles that are not glued: six edges.
IT::Delta_complex two_triangles()
{
  return IT::make_Delta_complex_from_gluing(2, std::vector<std::array<std::uint32_t, 2>>());
}

template <class Traits>
void expect_refused(const std::vector<typename Traits::FT>& lengths, Defect defect, std::size_t element)
{
  try {
    IT::Intrinsic_triangulation<Traits>::from_lengths(two_triangles(), lengths);
    ADD_FAILURE() << "was accepted";
  } catch (const IT::Invalid_surface_error& error) {
    EXPECT_EQ(error.defect(), defect) << error.what();
    EXPECT_EQ(error.element(), element) << error.what();
  }
}

// The area of the second triangle is far below what double holds, beside the first.
TEST(Extreme_lengths, ViolateTheTriangleInequalityWhateverTheirMagnitude)
{
  expect_refused<IT::Filtered_edge_length_traits>({1, 1, 1, 1e-100, 1e-100, 3e-100}, Defect::TRIANGLE_INEQUALITY, 1);
  expect_refused<IT::Edge_length_traits<double>>({1, 1, 1, 1e-100, 1e-100, 3e-100}, Defect::TRIANGLE_INEQUALITY, 1);
  expect_refused<IT::Edge_length_traits<float>>({1, 1, 1, 1e-15f, 1e-15f, 3e-15f}, Defect::TRIANGLE_INEQUALITY, 1);
  EXPECT_TRUE(IT::violate_triangle_inequality(1e-300, 1e-300, 3e-300));
  EXPECT_TRUE(IT::violate_triangle_inequality(0x1p-1074, 0x1p-1074, 0x3p-1074));
  EXPECT_FALSE(IT::violate_triangle_inequality(0x1p-1074, 0x1p-1074, 0x2p-1074));
  EXPECT_TRUE(IT::violate_triangle_inequality(1., 1., 2 + 0x1p-51));
  EXPECT_FALSE(IT::violate_triangle_inequality(1., 1., 2.));
}

TEST(Extreme_lengths, AreRefusedWhereSquaresVanish)
{
  expect_refused<IT::Filtered_edge_length_traits>({1, 1, 1, 1e-200, 1e-200, 1e-200}, Defect::OUT_OF_RANGE, 3);
}

// Four times the area exactly lies between value - error and value + error.
void expect_bound(const IT::Bounded_area& area, const Rational& square)
{
  const Rational value(area.value), error(area.error);
  const Rational low = value > error ? Rational(value - error) : Rational(0), high = value + error;
  EXPECT_LE(low * low, square) << area.value << " " << area.error;
  EXPECT_GE(high * high, square) << area.value << " " << area.error;
}

TEST(Extreme_lengths, AreasStayWithinTheirBoundsWhereProductsUnderflow)
{
  using Point_data = IT::Filtered_edge_length_traits::Point_data;
  const IT::Filtered_edge_length_traits traits;
  for (double scale = 1; scale > 1e-150; scale *= 0x1.8p-3) {
    const double a = 1.25 * scale, b = 1.5 * scale, c = 1.75 * scale;
    expect_bound(
      traits.construct_face_data_object().from_lengths(a, b, c),
      IT::squared_four_areas(Rational(a) * Rational(a), Rational(b) * Rational(b), Rational(c) * Rational(c)));
    // A right angle between sides a and b.
    expect_bound(traits.construct_face_data_object()(Point_data{0, 0, 0}, Point_data{a, 0, 0}, Point_data{0, b, 0}),
                 Rational(4) * Rational(a) * Rational(a) * Rational(b) * Rational(b));
  }
}

// Beside a length of 2^-216 one of 2^-597 is small, but both are far from what underflows once the
// larger is made as large as it may be.
TEST(Extreme_lengths, SmallSurfacesAreScaledUpAsFarAsPossible)
{
  const std::vector<double> lengths{0x1p-216, 0x1p-597, 0x1p-216};
  const auto triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>::from_lengths(
    IT::make_Delta_complex_from_gluing(1, std::vector<std::array<std::uint32_t, 2>>()), lengths);
  const IT::Face_index f(0);
  const double expected = 0x1p-216 * 0x1p-597 / 2;
  EXPECT_NEAR(triangulation.area(f), expected, 1e-9 * expected);
  const IT::Input_metric& metric = IT::internal::engine(triangulation).metric();
  const double in_input = std::ldexp(metric.four_areas_double_double(triangulation.connectivity(), f).hi() / 4,
                                     2 * triangulation.unit_exponent());
  EXPECT_NEAR(in_input, expected, 1e-9 * expected);
}

// The angle at the apex is about 1e-310, and its cotangent no double.
TEST(Extreme_lengths, OfAThinFaceHaveCotangentsThatAreRefusedOrRight)
{
  using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;
  const std::vector<std::array<int, 3>> triangles{{0, 1, 2}, {1, 0, 3}};
  for (double z : {1e-310, 5e-324, 1e-307}) {
    const std::vector<std::array<double, 3>> points{{0, 0, 0}, {1, 0, 0}, {0.5, z, 0}, {0.5, -1, 0.25}};
    const Triangulation t(IT::make_Delta_complex_from_triangles(points.size(), triangles), points);
    for (IT::Face_index f : t.connectivity().faces())
      EXPECT_GE(t.area(f), 0.99 * (z / 2));
    std::size_t refused = 0;
    for (IT::Halfedge_index h : t.connectivity().halfedges()) {
      if (t.connectivity().is_border(h))
        continue;
      try {
        EXPECT_TRUE(std::isfinite(t.cotangent(h)));
      } catch (const IT::Invalid_surface_error& error) {
        EXPECT_EQ(error.defect(), Defect::OUT_OF_RANGE) << error.what();
        EXPECT_EQ(error.element(), 0u) << error.what();
        ++refused;
      }
    }
    EXPECT_EQ(refused, z < 1e-308 ? 3u : 0u);
  }
}

TEST(Extreme_lengths, AsExactSquaresAreRefusedBeyondTheRangeOfDoubleAlone)
{
  using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;
  for (int exponent : {-3000, -2000, -1000, 1000, 2000, 3000}) {
    const Rational unit = exponent < 0 ? Rational(1, IT::internal::Integer(1) << -exponent)
                                       : Rational(IT::internal::Integer(1) << exponent);
    const std::vector<Rational> squared_lengths{unit, unit, 2 * unit, unit, unit, 3 * unit};
    try {
      const Triangulation t =
        Triangulation::from_metric(two_triangles(), IT::metric_from_squared_lengths(squared_lengths));
      EXPECT_LE(std::abs(exponent), 2000);
      EXPECT_EQ(t.length(IT::Edge_index(0)), std::ldexp(1., exponent / 2));
    } catch (const IT::Invalid_surface_error& error) {
      EXPECT_GT(std::abs(exponent), 2000) << error.what();
      EXPECT_EQ(error.defect(), Defect::OUT_OF_RANGE) << error.what();
      EXPECT_EQ(error.element(), 2u) << error.what();
    }
  }
}

// This is the sign of a number far below its rounding errors.
void expect_sign_of_weight(const IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>& t, IT::Edge_index e,
                           CGAL::Sign sign)
{
  EXPECT_EQ(CGAL::sign(t.cotangent_weight(e)), sign);
  EXPECT_EQ(CGAL::sign(IT::cotangent_weights(t)[e.idx()]), sign);
}

// Two angles of one triangle sum to less than π. Flips make such edges where coordinates of all sizes meet.
TEST(Extreme_lengths, The_weight_of_an_edge_with_one_face_on_both_sides_is_positive)
{
  std::mt19937 random(5);
  const auto number = [&](int exponent) { return std::ldexp(double(random() % 2001) / 1000 - 1, exponent); };
  constexpr unsigned n = 4;
  std::size_t number_of_edges = 0;
  for (int round = 0; round < 100; ++round) {
    SCOPED_TRACE(round);
    const int exponent = int(random() % 240);
    std::vector<std::array<double, 3>> points;
    std::vector<std::array<unsigned, 3>> triangles;
    for (unsigned j = 0; j <= n; ++j)
      for (unsigned i = 0; i <= n; ++i) {
        points.push_back({std::ldexp(i + 0.3 * number(0), i % 2 == 0 ? 0 : -exponent),
                          std::ldexp(j + 0.3 * number(0), -exponent), number(-int(random() % 240))});
        const unsigned v = j * (n + 1) + i;
        if (i < n && j < n)
          triangles.insert(triangles.end(), {{v, v + 1, v + n + 1}, {v + 1, v + n + 2, v + n + 1}});
      }
    IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits> t(
      IT::make_Delta_complex_from_triangles(points.size(), triangles), points);
    IT::flip_to_Delaunay(t);
    for (IT::Edge_index e : t.connectivity().edges())
      if (t.connectivity().is_self_glued(e)) {
        ++number_of_edges;
        expect_sign_of_weight(t, e, CGAL::POSITIVE);
      }
  }
  EXPECT_GT(number_of_edges, 20u);
}

TEST(Extreme_lengths, The_weight_of_a_border_edge_opposite_a_right_angle_is_zero)
{
  const IT::Delta_complex hinge =
    IT::make_Delta_complex_from_triangles(4, std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {1, 0, 3}});
  // Thirds are not exact in double.
  std::vector<IT::Rational> squared_lengths(hinge.number_of_edges());
  for (IT::Edge_index e : hinge.edges()) {
    const IT::Halfedge_index h = hinge.halfedge(e);
    const unsigned i = (std::min)(hinge.source(h).idx(), hinge.target(h).idx()),
                   j = hinge.source(h).idx() + hinge.target(h).idx() - i;
    const int thirds = i == 0 ? (j == 1 ? 769 : j == 2 ? 400 : 625) : (j == 2 ? 81 : 144);
    squared_lengths[e.idx()] = IT::Rational(thirds) / 3;
  }
  auto t = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>::from_metric(
    hinge, IT::metric_from_squared_lengths(squared_lengths));
  EXPECT_EQ(IT::flip_to_Delaunay(t).flips, 1u);
  std::size_t number_of_right_angles = 0;
  for (IT::Edge_index e : t.connectivity().edges()) {
    const IT::Halfedge_index h = t.connectivity().halfedge(e);
    // The flip makes the squared length of 2 and 3 225: 400 + 225 = 625.
    if (t.connectivity().source(h).idx() + t.connectivity().target(h).idx() == 3 && t.connectivity().is_border(e) &&
        (std::min)(t.connectivity().source(h).idx(), t.connectivity().target(h).idx()) == 0) {
      ++number_of_right_angles;
      expect_sign_of_weight(t, e, CGAL::ZERO);
    }
  }
  EXPECT_EQ(number_of_right_angles, 1u);
}

} // namespace
