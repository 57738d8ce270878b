// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The formulas of one hinge: against whole coordinates, where double is exact, and against
// the laws of sines and cosines with 200 bits, slivers included.

#include <CGAL/Intrinsic_triangulations/internal/measures/hinge_formulas.h>

#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Half_angle_traits.h>
#include <CGAL/Intrinsic_triangulations/Mpfr_float.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/triangle_formulas_3.h>

#include <boost/multiprecision/mpfr.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Real = IT::Mpfr_float;

namespace {

constexpr double u = 0x1p-53;

// The hinge ij of the triangles (i, j, k) and (j, i, l), in FT.
template <class FT>
struct Numbers
{
  FT s_ij, s_jk, s_ki, s_il, s_lj, a_ijk, a_jil;

  template <class To>
  Numbers<To> to() const
  {
    return {To(s_ij), To(s_jk), To(s_ki), To(s_il), To(s_lj), To(a_ijk), To(a_jil)};
  }
};

template <class FT>
struct Flipped
{
  FT s_kl, a_ilk, a_jkl;
};

template <class FT>
Flipped<FT> flipped(const Numbers<FT>& n)
{
  Flipped<FT> f;
  IT::flip_hinge(n.s_ij, n.s_jk, n.s_ki, n.s_il, n.s_lj, n.a_ijk, n.a_jil, f.s_kl, f.a_ilk, f.a_jkl);
  return f;
}

template <class FT>
FT value(const Numbers<FT>& n)
{
  return IT::Delaunay_value(IT::twice_scalar_product(n.s_jk, n.s_ki, n.s_ij), n.a_ijk,
                            IT::twice_scalar_product(n.s_il, n.s_lj, n.s_ij), n.a_jil);
}

// Lengths of the five edges in the order ij, jk, ki, il, lj, and the squared lengths with
// areas by Heron's product.
using Lengths = std::array<Real, 5>;
Real heron(const Real& a, const Real& b, const Real& c)
{
  return sqrt((a + b + c) * (a + b - c) * (a - b + c) * (b + c - a));
}
Numbers<Real> squares(const Lengths& l)
{
  return {
    l[0] * l[0], l[1] * l[1], l[2] * l[2], l[3] * l[3], l[4] * l[4], heron(l[0], l[1], l[2]), heron(l[0], l[3], l[4])};
}

// The angle between the sides b and c of a triangle, by half angles: no cancellation.
Real angle(const Real& a, const Real& b, const Real& c)
{
  return 2 * atan2(Real(sqrt((a - b + c) * (a + b - c))), Real(sqrt((a + b + c) * (b + c - a))));
}

// Random hinges: lengths of triangles in space, and slivers of both kinds, needles and caps.
std::vector<Lengths> random_hinges(std::size_t n, bool slivers)
{
  std::mt19937_64 random(n);
  std::uniform_real_distribution<double> uniform(0, 1), exponent(-9, -1);
  std::vector<Lengths> hinges;
  while (hinges.size() < n) {
    const double thin = slivers ? std::pow(10, exponent(random)) : 1;
    const auto point = [&] {
      return std::array<Real, 3>{Real(uniform(random)), Real(thin * uniform(random)), Real(thin * uniform(random))};
    };
    const auto i = point(), j = point(), k = point(), l = point();
    const auto length = [](const auto& p, const auto& q) { return Real(sqrt(IT::internal::squared_distance_3(p, q))); };
    hinges.push_back({length(i, j), length(j, k), length(k, i), length(i, l), length(l, j)});
  }
  return hinges;
}

double relative_error(const Real& x, const Real& reference, const Real& scale)
{
  return Real(abs(x - reference) / scale).convert_to<double>();
}

} // namespace

// Points with small integer coordinates: except for the division, every number in the formulas is an integer below
// 2^53, so double must be exact.
TEST(Hinge_formulas, are_exact_on_small_whole_coordinates)
{
  std::mt19937_64 random(1);
  std::uniform_int_distribution<std::int64_t> coordinate(-2000, 2000);
  int ties = 0;
  for (int n = 0; n < 20000; ++n) {
    // Every other hinge is a parallelogram or has its corners on a circle about the origin.
    std::array<std::int64_t, 2> i{coordinate(random), coordinate(random)}, j, k, l;
    if (n % 2 == 0) {
      j = {coordinate(random), coordinate(random)};
      k = {coordinate(random), coordinate(random)};
      l = {i[0] + j[0] - k[0], i[1] + j[1] - k[1]};
    } else {
      j = {-i[0], -i[1]};
      k = {-i[1], i[0]};
      l = {i[0], -i[1]};
    }
    const auto cross = [](const auto& p, const auto& q, const auto& r) {
      return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
    };
    const auto s = [](const auto& p, const auto& q) {
      return (q[0] - p[0]) * (q[0] - p[0]) + (q[1] - p[1]) * (q[1] - p[1]);
    };
    if (cross(i, j, k) < 0)
      std::swap(k, l);
    if (cross(i, j, k) <= 0 || cross(j, i, l) <= 0)
      continue;
    const Numbers<std::int64_t> whole{s(i, j),           s(j, k), s(k, i), s(i, l), s(l, j), 2 * cross(i, j, k),
                                      2 * cross(j, i, l)};
    const Numbers<double> numbers = whole.to<double>();
    const Flipped<double> f = flipped(numbers);
    // Two roundings: of the reciprocal and of the product with it.
    EXPECT_NEAR(f.s_kl, double(s(k, l)), 4 * u * f.s_kl);
    EXPECT_NEAR(f.a_ilk, 2. * cross(i, l, k), 4 * u * std::abs(f.a_ilk));
    EXPECT_NEAR(f.a_jkl, 2. * cross(j, k, l), 4 * u * std::abs(f.a_jkl));
    EXPECT_EQ(IT::squared_four_areas(numbers.s_ij, numbers.s_jk, numbers.s_ki), numbers.a_ijk * numbers.a_ijk);

    // The sign of the incircle determinant of i, j, k and l, in 128 bits.
    using Wide = boost::multiprecision::int128_t;
    const auto row = [&l](const auto& p) {
      const Wide x = p[0] - l[0], y = p[1] - l[1];
      return std::array<Wide, 3>{x, y, x * x + y * y};
    };
    const auto a = row(i), b = row(j), c = row(k);
    const Wide determinant =
      a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
    EXPECT_EQ(int(CGAL::sign(value(numbers))), -determinant.sign());
    ties += determinant.is_zero();
  }
  EXPECT_GT(ties, 1000);
}

TEST(Hinge_formulas, agree_with_trigonometry_in_200_bits)
{
  const IT::Mpfr_precision guard(200);
  for (bool slivers : {false, true})
    for (const Lengths& l : random_hinges(1000, slivers)) {
      const Numbers<Real> n = squares(l);
      const Flipped<Real> f = flipped(n);
      const Real at_i = angle(l[1], l[0], l[2]) + angle(l[4], l[0], l[3]);
      const Real at_j = angle(l[2], l[0], l[1]) + angle(l[3], l[0], l[4]);
      const Real scale = n.s_ki + n.s_il + n.s_jk + n.s_lj;
      // The digits that slivers lose are those of the areas, at most 18 of 60.
      EXPECT_LT(relative_error(f.s_kl, n.s_ki + n.s_il - 2 * l[2] * l[3] * cos(at_i), scale), 1e-38);
      EXPECT_LT(relative_error(f.a_ilk, 2 * l[2] * l[3] * sin(at_i), scale), 1e-38);
      EXPECT_LT(relative_error(f.a_jkl, 2 * l[1] * l[4] * sin(at_j), scale), 1e-38);
      EXPECT_LT(relative_error(f.a_ilk + f.a_jkl, n.a_ijk + n.a_jil, scale), 1e-55);
      const Real cotangents = 1 / tan(angle(l[0], l[1], l[2])) + 1 / tan(angle(l[0], l[3], l[4]));
      EXPECT_LT(relative_error(value(n), cotangents * n.a_ijk * n.a_jil, scale * scale), 1e-38);
      EXPECT_EQ(CGAL::sign(value(n)), CGAL::sign(cotangents));
    }
}

TEST(Hinge_formulas, lose_a_few_roundings_in_double)
{
  const IT::Mpfr_precision guard(200);
  for (bool slivers : {false, true})
    for (const Lengths& l : random_hinges(1000, slivers)) {
      // Both start from the same doubles; only the rounding of the formulas differs.
      const Numbers<double> n = squares(l).to<double>();
      const Numbers<Real> exact = n.to<Real>();
      const Flipped<double> f = flipped(n);
      const Flipped<Real> reference = flipped(exact);
      const Real e_k = exact.s_jk + exact.s_ki + exact.s_ij, e_l = exact.s_il + exact.s_lj + exact.s_ij;
      const Real along = e_k + e_l, across = exact.a_ijk + exact.a_jil;
      const Real s_scale = (along * along + across * across) / exact.s_ij;
      const Real a_scale = (e_k * exact.a_jil + e_l * exact.a_ijk) / exact.s_ij;
      EXPECT_LT(relative_error(Real(f.s_kl), reference.s_kl, s_scale), 4 * u);
      EXPECT_LT(relative_error(Real(f.a_ilk), reference.a_ilk, a_scale), 4 * u);
      EXPECT_LT(relative_error(Real(f.a_jkl), reference.a_jkl, a_scale), 4 * u);
      EXPECT_LT(relative_error(Real(value(n)), value(exact), a_scale * exact.s_ij), 4 * u);
    }
}

// Half_angle_traits computes the same from lengths alone.
TEST(Hinge_formulas, agree_with_half_angles)
{
  const IT::Mpfr_precision guard(200);
  using Traits = IT::Half_angle_traits<Real>;
  const Traits traits;
  const Traits::Face_data none;
  int convex = 0;
  for (bool slivers : {false, true})
    for (const Lengths& l : random_hinges(1000, slivers)) {
      const Numbers<Real> n = squares(l);
      const Flipped<Real> f = flipped(n);
      const Traits::Hinge_data hinge{l[0], l[1], l[2], l[3], l[4], none, none};
      EXPECT_EQ(traits.is_locally_Delaunay_object()(hinge), value(n) >= 0);
      EXPECT_LT(relative_error(traits.compute_cotangent_object()(none, l[0], l[1], l[2]) * n.a_ijk,
                               IT::twice_scalar_product(n.s_jk, n.s_ki, n.s_ij), n.s_jk + n.s_ki),
                1e-38);
      Traits::Flipped_hinge_data flipped_hinge;
      const bool is_convex = traits.construct_flipped_hinge_object()(hinge, flipped_hinge);
      EXPECT_EQ(is_convex, f.a_ilk > 0 && f.a_jkl > 0);
      if (!is_convex)
        continue;
      ++convex;
      EXPECT_LT(relative_error(flipped_hinge.kl * flipped_hinge.kl, f.s_kl, n.s_ki + n.s_il), 1e-38);
    }
  EXPECT_GT(convex, 200);
  EXPECT_LT(convex, 1900);
}

// No circle through flat triangles: an edge between two caps is flipped, others stay.
TEST(Hinge_formulas, decide_on_faces_without_area)
{
  const IT::Edge_length_traits<double> traits;
  const auto is_Delaunay = [&](double s_ij, double s_jk, double s_ki, double s_il, double s_lj, double a, double b) {
    return traits.is_locally_Delaunay_object()({s_ij, s_jk, s_ki, s_il, s_lj, a, b});
  };
  EXPECT_FALSE(is_Delaunay(16, 4, 4, 9, 1, 0, 0));                // k and l between i and j
  EXPECT_TRUE(is_Delaunay(4, 16, 4, 1, 1, 0, 0));                 // k beyond i
  EXPECT_TRUE(is_Delaunay(4, 16, 4, 9, 1, 0, 0));                 // k beyond i, l beyond j
  EXPECT_FALSE(is_Delaunay(4, 1, 1, 9, 9, 0, 4 * std::sqrt(8.))); // k between i and j
  EXPECT_TRUE(is_Delaunay(4, 16, 4, 9, 9, 0, 4 * std::sqrt(8.)));
}

TEST(Kahan_formula, has_the_sign_of_the_triangle_inequality)
{
  const IT::Mpfr_precision guard(200);
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> uniform(0, 1), exponent(-20, 0);
  std::uniform_int_distribution<int> step(-3, 3);
  int signs[3] = {0, 0, 0};
  for (int n = 0; n < 100000; ++n) {
    // The longest side is as long as the others together, up to a few units in its last place.
    const double b = uniform(random), c = uniform(random) * std::pow(2, exponent(random));
    double a = b + c;
    for (int steps = step(random); steps != 0; steps += steps > 0 ? -1 : 1)
      a = std::nextafter(a, steps > 0 ? 4. : 0.);
    const int sign = CGAL::sign(Real(b) + Real(c) - Real(a)); // exact: fewer than 200 bits
    ++signs[sign + 1];
    for (const std::array<double, 3>& l :
         {std::array<double, 3>{a, b, c}, {a, c, b}, {b, a, c}, {b, c, a}, {c, a, b}, {c, b, a}})
      ASSERT_EQ(int(CGAL::sign(IT::squared_four_areas_from_lengths(l[0], l[1], l[2]))), sign)
        << a << " " << b << " " << c;
  }
  for (int count : signs)
    EXPECT_GT(count, 500);
  // Far from a triangle, where the difference of the longest and the next is rounded.
  EXPECT_LT(IT::squared_four_areas_from_lengths(1., 1e-30, 1e-40), 0);
  EXPECT_LT(IT::squared_four_areas_from_lengths(3.f, 1.f, 1.f), 0);
  EXPECT_EQ(IT::squared_four_areas_from_lengths(2., 1., 1.), 0);
}

TEST(Kahan_formula, is_accurate_for_slivers)
{
  const IT::Mpfr_precision guard(200);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(0, 1), exponent(-40, 0);
  for (int n = 0; n < 10000; ++n) {
    const double b = uniform(random), c = uniform(random) * std::pow(2, exponent(random));
    // Between needles and caps.
    const double a = std::abs(b - c) + uniform(random) * (b + c - std::abs(b - c));
    const Real area = heron(Real(a), Real(b), Real(c));
    if (!(area > 0)) // not a triangle after rounding
      continue;
    EXPECT_LT(relative_error(Real(IT::squared_four_areas_from_lengths(a, b, c)), area * area, area * area), 12 * u);
  }
}
