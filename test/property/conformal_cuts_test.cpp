// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where conformal maps are cut open, whether they overlap themselves, and whether what they state of sums of angles is
// true.

#include "conformal_claims.h"

#include <CGAL/number_type_config.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace conformal_claims;
using IT::Vertex_index;
using samples::Indexed_triangles;

bool is_cut(const Conformal_map& map)
{
  return std::any_of(map.is_cut.begin(), map.is_cut.end(),
                     [](const std::array<bool, 3>& sides) { return sides[0] || sides[1] || sides[2]; });
}

TEST(Conformal_cuts, says_whether_it_overlaps_itself)
{
  // A flat spiral ramp of one and a half turns covers itself; of three quarters of a turn it does not.
  for (double turns : {0.75, 1.5}) {
    Indexed_triangles ramp;
    const std::uint32_t n = 60;
    for (std::uint32_t i = 0; i <= n; ++i)
      for (double r : {1., 1.4, 2.}) {
        const double a = 2 * CGAL_PI * turns * i / n;
        ramp.points.push_back({r * std::cos(a), r * std::sin(a), 1e-3 * a});
      }
    for (std::uint32_t i = 0; i < n; ++i)
      for (std::uint32_t k = 0; k < 2; ++k) {
        ramp.triangles.push_back({3 * i + k, 3 * i + k + 1, 3 * i + k + 4});
        ramp.triangles.push_back({3 * i + k, 3 * i + k + 4, 3 * i + k + 3});
      }
    const Triangulation t = triangulation_of(ramp);
    const Conformal_map map = IT::conformal_parameterization(t);
    EXPECT_EQ(defect(map, t), "");
    EXPECT_EQ(map.overlaps, turns > 1);
    EXPECT_TRUE(map.turned_input.empty());
    EXPECT_TRUE(map.divided_input.empty());
    for (const auto& sides : map.is_cut)
      EXPECT_FALSE(sides[0] || sides[1] || sides[2]) << "nothing has to be cut";
  }
}

// A slit into a flat square: both sides of the cut have the same image, up to rounding.
TEST(Conformal_cuts, does_not_overlap_along_a_slit)
{
  Indexed_triangles square;
  const std::uint32_t n = 8;
  for (std::uint32_t i = 0; i <= n; ++i)
    for (std::uint32_t k = 0; k <= n; ++k)
      square.points.push_back({0.1 * i + 0.01 * std::sin(7. * k * i), 0.1 * k + 0.01 * std::cos(5. * i + k), 0});
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t k = 0; k < n; ++k) {
      const std::uint32_t v = i * (n + 1) + k;
      square.triangles.push_back({v, v + n + 1, v + n + 2});
      square.triangles.push_back({v, v + n + 2, v + 1});
    }
  const Triangulation t = triangulation_of(square);
  for (std::size_t cones : {1u, 2u, 5u}) {
    const Conformal_map map = IT::conformal_parameterization(t, CGAL::parameters::number_of_cones(cones));
    EXPECT_EQ(defect(map, t), "");
    EXPECT_FALSE(map.overlaps) << cones;
  }
}

// Laid out around the hole, it meets itself up to rounding: the map is continuous there.
TEST(Conformal_cuts, of_a_flat_annulus_in_space_are_closed)
{
  std::mt19937 random(7);
  const auto number = [&] { return double(random()) / 0x1p32; };
  for (std::uint32_t n = 12; n < 30; n += 3) {
    Indexed_triangles annulus;
    const double a = number(), b = number();
    for (std::uint32_t ring = 0; ring < 3; ++ring)
      for (std::uint32_t i = 0; i < n; ++i) {
        const double angle = 2 * CGAL_PI * i / n, r = 1 + ring / 2. + 0.1 * number(), x = r * std::cos(angle),
                     y = r * std::sin(angle);
        annulus.points.push_back({x * std::cos(a) - y * std::sin(a) * std::cos(b),
                                  x * std::sin(a) + y * std::cos(a) * std::cos(b), y * std::sin(b)});
      }
    for (std::uint32_t v = 0; v < 2 * n; ++v) {
      const std::uint32_t next = v % n + 1 == n ? v + 1 - n : v + 1;
      annulus.triangles.push_back({v, v + n, next + n});
      annulus.triangles.push_back({v, next + n, next});
    }
    const Triangulation t = triangulation_of(annulus);
    const Conformal_map map = IT::conformal_parameterization(t);
    EXPECT_EQ(defect(map, t), "");
    EXPECT_FALSE(map.overlaps);
    EXPECT_FALSE(is_cut(map)) << n;
    EXPECT_EQ(map.seam, 0);
    EXPECT_TRUE(map.divided_input.empty());
  }
}

// The image turns around such a cone twice, so both sides of a cut to it meet, too.
TEST(Conformal_cuts, lead_to_a_cone_of_twice_a_full_angle)
{
  const Triangulation t = triangulation_of(samples::bumpy_dome(14, 10, 0.2));
  const IT::Delta_complex& c = t.connectivity();
  const auto inner =
    std::find_if(c.vertices().begin(), c.vertices().end(), [&](Vertex_index v) { return !c.is_border(c.halfedge(v)); });
  const Conformal_map map =
    IT::conformal_parameterization(t, CGAL::parameters::cone_angles(std::vector{std::make_pair(*inner, 4 * CGAL_PI)}));
  EXPECT_EQ(defect(map, t), "");
  EXPECT_TRUE(is_cut(map));
  EXPECT_TRUE(map.overlaps);
}

// Edges of the input and of the ideal triangulation coincide here, but for rounding.
TEST(Conformal_cuts, along_the_input_have_two_sides)
{
  Indexed_triangles torus;
  for (std::uint32_t i = 0; i < 3; ++i)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const double a = 2 * CGAL_PI * i / 3, b = 2 * CGAL_PI * k / 3, r = 2 + 0.7 * std::cos(b);
      torus.points.push_back({r * std::cos(a), r * std::sin(a), 0.7 * std::sin(b)});
      const std::uint32_t v = 3 * i + k, right = (v + 3) % 9, up = 3 * i + (k + 1) % 3, beyond = (up + 3) % 9;
      torus.triangles.push_back({v, right, beyond});
      torus.triangles.push_back({v, beyond, up});
    }
  const Triangulation t = triangulation_of(torus);
  const Conformal_map map = IT::conformal_parameterization(t);
  EXPECT_EQ(defect(map, t), "");
  EXPECT_TRUE(is_cut(map));
  EXPECT_TRUE(map.divided_input.empty());
}

TEST(Conformal_cuts, separate_components_of_very_different_sizes)
{
  Indexed_triangles all = samples::torus(12, 8);
  const Indexed_triangles dome = samples::bumpy_dome(8, 6, 0.2);
  for (const double scale : {1e-9, 1e-20}) {
    const std::uint32_t first = std::uint32_t(all.points.size());
    for (const auto& [x, y, z] : dome.points)
      all.points.push_back({scale * x, scale * y, scale * z});
    for (const auto& [i, j, k] : dome.triangles)
      all.triangles.push_back({first + i, first + j, first + k});
  }
  const Triangulation t = triangulation_of(all);
  const Conformal_map map = IT::conformal_parameterization(t);
  EXPECT_EQ(defect(map, t), "");
  EXPECT_FALSE(map.overlaps);
}

// The largest difference of the sums of angles around vertices off the cones from 2π, and from the angles wanted at
// cones.
long double largest_error(const IT::Discrete_conformal_metric& metric,
                          const std::vector<std::pair<Vertex_index, double>>& cones)
{
  constexpr long double pi = 3.14159265358979323846264338327950288L;
  std::vector<long double> errors(metric.u.size(), -2 * pi);
  for (const auto& [v, angle] : cones)
    errors[v.idx()] = -(long double)(angle);
  const IT::Delta_complex& c = metric.triangulation;
  for (IT::Halfedge_index h : c.halfedges()) {
    const auto length = [&](IT::Halfedge_index side) { return (long double)(metric.lengths[c.edge(side).idx()]); };
    const long double a = length(h), b = length(c.prev(h)), opposite = length(c.next(h));
    errors[metric.vertices[c.source(h).idx()].idx()] +=
      2 * std::atan2(std::sqrt((opposite + a - b) * (opposite + b - a)),
                     std::sqrt((a + b + opposite) * (a + b - opposite)));
  }
  long double result = 0;
  for (long double error : errors)
    result = (std::max)(result, std::abs(error));
  return result;
}

TEST(Conformal_residual, bounds_the_error_of_each_sum_of_angles)
{
  for (std::uint32_t n = 10; n < 60; n += 10) {
    const Triangulation torus = triangulation_of(samples::torus(n, n / 2 + 2));
    const IT::Discrete_conformal_metric flat = IT::discrete_conformal_metric(torus);
    ASSERT_TRUE(flat.cones.empty());
    EXPECT_LE(largest_error(flat, {}), flat.residual) << n;
    // A sum that is wrong by less than 10^-9 is corrected.
    const Triangulation sphere = triangulation_of(samples::bumpy_sphere(n, n / 2 + 2, 0.3));
    const std::vector<std::pair<Vertex_index, double>> cones{
      {Vertex_index(0), CGAL_PI}, {Vertex_index(n), CGAL_PI / 2}, {Vertex_index(n + 7), CGAL_PI / 2 + 1e-11}};
    const IT::Discrete_conformal_metric metric =
      IT::discrete_conformal_metric(sphere, CGAL::parameters::cone_angles(cones));
    EXPECT_LE(largest_error(metric, cones), metric.residual) << n;
    EXPECT_LT(metric.residual, 2e-11);
  }
}

// Three neighbors on a circle with a radius of 10^12 times their distance are collinear, up to rounding.
TEST(Conformal_map, says_that_triangles_are_too_thin)
{
  Indexed_triangles fan;
  fan.points.push_back({0, 0, 0});
  for (std::uint32_t k = 0; k < 6; ++k)
    fan.points.push_back({std::cos(k * 1e-12), std::sin(k * 1e-12), (k % 2) * 1e-13});
  for (std::uint32_t k = 1; k < 6; ++k)
    fan.triangles.push_back({0, k, k + 1});
  try {
    IT::conformal_parameterization(triangulation_of(fan));
    FAIL();
  } catch (const IT::Numerical_error& error) {
    EXPECT_NE(std::string(error.what()).find("too thin"), std::string::npos) << error.what();
  }
}

} // namespace
