// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Maps of disks to the plane: harmonic ones, and their checks.

#include "property/flip_test_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/harmonic_parameterization.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <string>
#include <vector>

namespace {

using namespace test_surfaces;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;
using IT::Planar_points;

Triangulation triangulation_of(const samples::Indexed_triangles& triangles, bool is_Delaunay)
{
  Triangulation t(IT::make_Delta_complex_from_triangles(triangles.points.size(), triangles.triangles),
                  triangles.points);
  if (is_Delaunay)
    IT::flip_to_Delaunay(t);
  return t;
}

// A flat sheet of badly shaped triangles.
samples::Indexed_triangles flat_sheet()
{
  samples::Indexed_triangles sheet = samples::sheared_grid(9, 7, 1.7);
  std::mt19937 random(3);
  for (std::array<double, 3>& p : sheet.points)
    for (int i = 0; i < 2; ++i)
      p[std::size_t(i)] += 0.2 * (double(random()) / 0x1p31 - 1);
  return sheet;
}

Planar_points plane_points(const samples::Indexed_triangles& triangles)
{
  Planar_points points;
  for (const std::array<double, 3>& p : triangles.points)
    points.push_back({p[0], p[1]});
  return points;
}

Planar_points boundary_values(const Triangulation& t, const Planar_points& positions)
{
  Planar_points values;
  for (IT::Halfedge_index h : IT::disk_boundary(t.connectivity()))
    values.push_back(positions[t.connectivity().source(h).idx()]);
  return values;
}

double largest_distance(const Planar_points& p, const Planar_points& q)
{
  double result = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    result = std::max(result, std::hypot(p[i][0] - q[i][0], p[i][1] - q[i][1]));
  return result;
}

// Moves, turns and scales `p` so that its points 0 and `last` lie on those of `q`.
Planar_points aligned(const Planar_points& p, const Planar_points& q)
{
  using Complex = std::complex<double>;
  const auto at = [](const Planar_points& points, std::size_t i) { return Complex(points[i][0], points[i][1]); };
  const std::size_t last = p.size() - 1;
  const Complex factor = (at(q, last) - at(q, 0)) / (at(p, last) - at(p, 0));
  Planar_points result;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Complex z = at(q, 0) + factor * (at(p, i) - at(p, 0));
    result.push_back({z.real(), z.imag()});
  }
  return result;
}

IT::Distortion_summary distortion(const Triangulation& t, const Planar_points& uv)
{
  const std::vector<double> areas = IT::face_areas(t);
  return IT::summarize_distortion(IT::quasi_conformal_distortion(t.connectivity(), IT::edge_lengths(t), areas, uv),
                                  areas);
}

template <class Function>
void expect_topology_error(const Function& function, const std::string& part)
{
  try {
    function();
    FAIL() << "no exception; expected: " << part;
  } catch (const IT::Invalid_surface_error& error) {
    EXPECT_EQ(error.defect(), IT::Invalid_surface_error::Defect::WRONG_TOPOLOGY);
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

const Planar_points square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

} // namespace

TEST(Disk_boundary, runs_counterclockwise_around_a_sheet)
{
  const samples::Indexed_triangles sheet = samples::sheared_grid(5, 4, 0);
  const Triangulation t = triangulation_of(sheet, false);
  const Planar_points around = boundary_values(t, plane_points(sheet));
  EXPECT_EQ(around.size(), 18u);
  double area = 0;
  for (std::size_t i = 0; i < around.size(); ++i) {
    const auto &p = around[i], &q = around[(i + 1) % around.size()];
    area += (p[0] * q[1] - q[0] * p[1]) / 2;
  }
  EXPECT_EQ(area, 20);
}

TEST(Disk_boundary, says_what_the_surface_is_instead)
{
  const auto boundary = [](const samples::Indexed_triangles& s) {
    return [s] { IT::disk_boundary(triangulation_of(s, false).connectivity()); };
  };
  expect_topology_error(boundary(samples::bumpy_sphere(5, 4)), "is closed");
  expect_topology_error(boundary(samples::Schwarz_lantern(5, 4)), "2 boundaries");
  samples::Indexed_triangles torus = samples::torus(6, 5);
  torus.triangles.pop_back();
  expect_topology_error(boundary(torus), "1 handle");
  samples::Indexed_triangles two = samples::sheared_grid(1, 1, 0);
  const auto n = std::uint32_t(two.points.size());
  two.points.insert(two.points.end(), {{9, 0, 0}, {10, 0, 0}, {9, 1, 0}});
  two.triangles.push_back({n, n + 1, n + 2});
  expect_topology_error(boundary(two), "2 components");
}

TEST(Boundary_positions, on_the_circle_by_arc_length)
{
  const Planar_points p = IT::positions_on_circle({1, 2, 1});
  EXPECT_LE(largest_distance(p, {{1, 0}, {0, 1}, {0, -1}}), 1e-15);
}

TEST(Boundary_positions, on_a_polygon_with_a_vertex_at_each_corner)
{
  const Planar_points p = IT::positions_on_polygon({1, 1, 2, 2, 1, 1}, square);
  ASSERT_EQ(p.size(), 6u);
  EXPECT_LE(largest_distance(p, {{0, 0}, {0.5, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0.5}}), 1e-15);
  // As many vertices as corners, and very uneven.
  EXPECT_EQ(IT::positions_on_polygon({100, 1, 1, 1}, square), square);
  EXPECT_EQ(IT::positions_on_polygon({1, 1, 1, 100}, square), square);
}

TEST(Boundary_positions, only_on_convex_polygons)
{
  const std::vector<double> lengths(7, 1.);
  const Planar_points clockwise{{0, 0}, {0, 1}, {1, 1}, {1, 0}}, straight{{0, 0}, {1, 0}, {2, 0}, {1, 1}},
    concave{{0, 0}, {2, 0}, {1, 0.5}, {0, 2}}, two{{0, 0}, {1, 0}};
  Planar_points star;
  for (int i = 0; i < 5; ++i)
    star.push_back({std::cos(2.4 * M_PI / 3 * i), std::sin(2.4 * M_PI / 3 * i)});
  for (const Planar_points& polygon : {clockwise, straight, concave, two, star})
    EXPECT_THROW(IT::positions_on_polygon(lengths, polygon), IT::Invalid_argument_error);
  EXPECT_THROW(IT::positions_on_polygon({1, 1, 1}, square), IT::Invalid_argument_error);
  for (double x : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e308})
    EXPECT_THROW(IT::positions_on_polygon(lengths, {{0, 0}, {1, 0}, {x, 1}}), IT::Invalid_argument_error);
}

// Lengths whose sum overflows, and lengths that vanish beside those before.
TEST(Boundary_positions, whatever_the_lengths)
{
  const Planar_points triangle{{0, 0}, {1, 0}, {0, 1}};
  for (const std::vector<double>& lengths : {std::vector<double>{1, 1, 1e-20}, {1, 1e-17, 1}, {1e308, 1e308, 1e308}}) {
    EXPECT_EQ(IT::positions_on_polygon(lengths, triangle), triangle);
    for (const auto& p : IT::positions_on_circle(lengths))
      EXPECT_NEAR(std::hypot(p[0], p[1]), 1, 1e-15);
  }
}

// Linear functions are harmonic on any flat triangulation.
TEST(Harmonic_parameterization, a_flat_sheet_with_its_own_boundary_stays_as_it_is)
{
  const samples::Indexed_triangles sheet = flat_sheet();
  const Planar_points points = plane_points(sheet);
  for (bool is_Delaunay : {false, true}) {
    const Triangulation t = triangulation_of(sheet, is_Delaunay);
    const Planar_points uv =
      IT::harmonic_parameterization(t.connectivity(), IT::cotangent_weights(t), boundary_values(t, points));
    EXPECT_LE(largest_distance(uv, points), 1e-10);
  }
}

TEST(Harmonic_parameterization, each_inner_vertex_is_the_weighted_mean_of_its_neighbours)
{
  const Triangulation t = triangulation_of(samples::disk_with_spike(12, 8), true);
  const Planar_points uv = IT::harmonic_parameterization(t);
  const IT::Delta_complex& c = t.connectivity();
  std::vector<std::complex<double>> sums(c.number_of_vertices());
  for (IT::Edge_index e : c.edges()) {
    const IT::Halfedge_index h = c.halfedge(e);
    const std::size_t v = c.source(h).idx(), w = c.target(h).idx();
    const std::complex<double> flow =
      t.cotangent_weight(e) * std::complex<double>(uv[v][0] - uv[w][0], uv[v][1] - uv[w][1]);
    sums[v] += flow;
    sums[w] -= flow;
  }
  for (IT::Vertex_index v : c.vertices()) {
    if (c.is_border(c.halfedge(v))) {
      EXPECT_NEAR(std::hypot(uv[v.idx()][0], uv[v.idx()][1]), 1, 1e-15);
    } else {
      EXPECT_LE(std::abs(sums[v.idx()]), 1e-9) << v;
    }
  }
}

// The surface is twisted, so that the extrinsic operator has large negative weights.
TEST(Harmonic_parameterization, folds_with_the_extrinsic_operator_and_not_with_the_intrinsic)
{
  samples::Indexed_triangles sheet = samples::sheared_grid(16, 12, 0);
  std::mt19937 random(1);
  for (std::array<double, 3>& p : sheet.points) {
    p[0] += 3 * std::sin(p[1] * p[1]) + 0.3 * (double(random()) / 0x1p31 - 1);
    p[2] = 2 * (double(random()) / 0x1p31 - 1);
  }
  const Triangulation extrinsic = triangulation_of(sheet, false), intrinsic = triangulation_of(sheet, true);
  EXPECT_GT(
    IT::check_parameterization(extrinsic.connectivity(), IT::harmonic_parameterization(extrinsic)).flipped.size(), 0u);
  EXPECT_TRUE(IT::check_parameterization(intrinsic.connectivity(), IT::harmonic_parameterization(intrinsic))
                .is_locally_injective());
  EXPECT_TRUE(IT::check_parameterization(intrinsic.connectivity(), IT::harmonic_parameterization(intrinsic, square))
                .flipped.empty());
}

TEST(Natural_parameterization, a_flat_sheet_comes_out_similar)
{
  const samples::Indexed_triangles sheet = flat_sheet();
  const Planar_points points = plane_points(sheet);
  for (bool is_Delaunay : {false, true}) {
    const Triangulation t = triangulation_of(sheet, is_Delaunay);
    const Planar_points uv = IT::natural_parameterization(t);
    EXPECT_LE(largest_distance(aligned(uv, points), points), 1e-9);
    EXPECT_NEAR(std::hypot(uv.front()[0] - uv.back()[0], uv.front()[1] - uv.back()[1]),
                std::hypot(points.front()[0] - points.back()[0], points.front()[1] - points.back()[1]), 1e-9);
    EXPECT_NEAR(distortion(t, uv).maximum, 1, 1e-6);
    EXPECT_TRUE(IT::check_parameterization(t.connectivity(), uv).is_locally_injective());
  }
}

// Each area is in the range of double, their sum is not.
TEST(Natural_parameterization, of_a_sheet_as_large_as_can_be)
{
  samples::Indexed_triangles sheet = flat_sheet();
  const Planar_points unit = IT::natural_parameterization(triangulation_of(sheet, true));
  for (auto& p : sheet.points)
    for (double& x : p)
      x = std::ldexp(x, 511);
  const Triangulation t = triangulation_of(sheet, true);
  Planar_points uv = IT::natural_parameterization(t);
  EXPECT_NEAR(distortion(t, uv).mean, 1, 1e-6);
  for (auto& p : uv)
    p = {std::ldexp(p[0], -511), std::ldexp(p[1], -511)};
  EXPECT_LE(largest_distance(uv, unit), 1e-9);
}

// The derivative of Dirichlet energy minus area of the image vanishes except at the two fixed vertices.
TEST(Natural_parameterization, is_stationary)
{
  for (bool is_Delaunay : {false, true}) {
    const Triangulation t = triangulation_of(samples::disk_with_spike(16, 10, 1, 0.4), is_Delaunay);
    const IT::Delta_complex& c = t.connectivity();
    const Planar_points uv = IT::natural_parameterization(t);
    const auto at = [&](IT::Vertex_index v) { return std::complex<double>(uv[v.idx()][0], uv[v.idx()][1]); };
    std::vector<std::complex<double>> derivative(c.number_of_vertices());
    for (IT::Edge_index e : c.edges()) {
      const IT::Vertex_index v = c.source(c.halfedge(e)), w = c.target(c.halfedge(e));
      derivative[v.idx()] += t.cotangent_weight(e) / 2 * (at(v) - at(w));
      derivative[w.idx()] += t.cotangent_weight(e) / 2 * (at(w) - at(v));
    }
    for (IT::Halfedge_index h : IT::disk_boundary(c)) {
      const IT::Vertex_index v = c.source(h), w = c.target(h);
      derivative[v.idx()] += std::complex<double>(0, 0.5) * at(w); // minus the derivative of (v × w) / 2
      derivative[w.idx()] -= std::complex<double>(0, 0.5) * at(v);
    }
    int held = 0;
    for (const std::complex<double>& d : derivative)
      held += std::abs(d) > 1e-9;
    EXPECT_LE(held, 2);
  }
}

TEST(Parameterization_quality, orientation_is_decided_exactly)
{
  const auto check = [](const Planar_points& uv) {
    return IT::check_parameterization(
      IT::make_Delta_complex_from_triangles(3, std::vector<std::array<int, 3>>{{0, 1, 2}}), uv);
  };
  const double tiny = 0x1p-1074;
  EXPECT_TRUE(check({{0, 0}, {1, 0}, {0.5, tiny}}).is_locally_injective());
  EXPECT_EQ(check({{0, 0}, {1, 0}, {0.5, -tiny}}).flipped.size(), 1u);
  EXPECT_EQ(check({{0, 0}, {1, 0}, {0.5, 0}}).collapsed.size(), 1u);
  // On a line in the reals, where a rounded determinant is not zero.
  EXPECT_EQ(check({{0.5, 0.5}, {12, 12}, {24, 24}}).collapsed.size(), 1u);
  EXPECT_EQ(check({{0.5, 0.5}, {12, 12}, {24, std::nextafter(24., 25.)}}).collapsed.size(), 0u);
  for (double x : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    EXPECT_THROW(check({{0, 0}, {1, 0}, {0.5, x}}), IT::Numerical_error);
}

TEST(Parameterization_quality, distortion_of_known_maps)
{
  const samples::Indexed_triangles sheet = flat_sheet();
  const Triangulation t = triangulation_of(sheet, false);
  const auto mapped = [&](double a, double b, double c, double d) {
    Planar_points uv;
    for (const std::array<double, 2>& p : plane_points(sheet))
      uv.push_back({a * p[0] + b * p[1], c * p[0] + d * p[1]});
    return distortion(t, uv);
  };
  for (double scale : {1e-300, 1e-161, 1e-8, 1., 1e8, 1e160, 1e305}) {
    EXPECT_NEAR(mapped(3 * scale, 4 * scale, -4 * scale, 3 * scale).maximum, 1, 1e-9);
    EXPECT_NEAR(mapped(3 * scale, 0, 0, scale).mean, 3, 1e-9);
    EXPECT_NEAR(mapped(scale, 0, 0, -2 * scale).percentile_99, 2, 1e-9); // a reflection
    // A shear by 1: the squares of the singular values are (3 + √5)/2 and its inverse.
    EXPECT_NEAR(mapped(scale, scale, 0, scale).maximum, (3 + std::sqrt(5)) / 2, 1e-9);
  }
  EXPECT_EQ(mapped(1, 0, 0, 0).maximum, std::numeric_limits<double>::infinity());
}

TEST(Parameterization_quality, mean_and_percentile_are_weighted_with_area)
{
  const IT::Distortion_summary s =
    IT::summarize_distortion({5, 1, 2, std::numeric_limits<double>::infinity()}, {0.5, 98, 1.5, 0});
  EXPECT_DOUBLE_EQ(s.mean, (2.5 + 98 + 3) / 100);
  EXPECT_EQ(s.percentile_99, 2);
  EXPECT_EQ(s.maximum, 5);
}
