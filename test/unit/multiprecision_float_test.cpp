// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Floats of Boost.Multiprecision: of 50 digits, with and without expression templates, and in single precision.

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/mpfr.hpp>

#include <gtest/gtest.h>

namespace {
using Mpfr_float_50_without_expressions =
  boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<50>, boost::multiprecision::et_off>;
using Number_types = testing::Types<boost::multiprecision::cpp_bin_float_50, boost::multiprecision::mpfr_float_50,
                                    Mpfr_float_50_without_expressions>;
} // namespace

#include "float_type_tests.h"

namespace {

// The squares and products of such numbers leave their range, as those of `float` do.
TEST(Multiprecision_float, of_a_narrow_exponent_range_takes_large_and_small_surfaces)
{
  namespace IT = CGAL::Intrinsic_triangulations;
  using FT = boost::multiprecision::cpp_bin_float_single;
  static_assert(std::numeric_limits<FT>::max_exponent <= 128, "as narrow as that of float");
  const std::vector<std::array<int, 3>> triangles{{0, 1, 2}, {1, 0, 3}};
  for (int exponent : {-90, -40, 0, 40, 100}) {
    const double unit = std::ldexp(1., exponent);
    const std::vector<std::array<double, 3>> points{
      {0, 0, 0}, {4 * unit, 0, 0}, {2 * unit, unit, 0}, {2 * unit, 0, unit}};
    IT::Intrinsic_triangulation<IT::Edge_length_traits<FT>> triangulation(
      IT::make_Delta_complex_from_triangles(points.size(), triangles), points);
    EXPECT_EQ(IT::flip_to_Delaunay(triangulation).flips, 1u);
    EXPECT_EQ(triangulation.length(IT::Edge_index(0)), FT(2 * unit));
    EXPECT_EQ(triangulation.cotangent_weight(IT::Edge_index(0)), FT(1.5));
  }
}

} // namespace
