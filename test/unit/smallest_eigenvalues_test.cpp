// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Eigenvalues of surfaces that are not manifolds, and of point clouds, against known ones.

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/eigenvalues.h>
#include <CGAL/Intrinsic_triangulations/point_cloud_Laplacian.h>
#include <CGAL/Intrinsic_triangulations/tufted_Laplacian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Points = std::vector<std::array<double, 3>>;
using Triangles = std::vector<std::array<int, 3>>;

constexpr double pi = 3.14159265358979;

TEST(Smallest_eigenvalues, sphere)
{
  const samples::Indexed_triangles sphere = samples::latitude_longitude_sphere(80, 40);
  for (IT::Mass_type mass_type : {IT::Mass_type::LUMPED, IT::Mass_type::GALERKIN}) {
    const IT::Tufted_Laplacian L =
      IT::tufted_Laplacian(sphere.points, sphere.triangles, CGAL::parameters::mass_type(mass_type));
    const std::vector<double> found = IT::smallest_eigenvalues(L.stiffness, L.mass, 16);
    ASSERT_EQ(found.size(), 16u);
    EXPECT_EQ(found[0], 0);
    for (std::size_t i = 1; i < 16; ++i) {
      const double expected = i < 4 ? 2 : i < 9 ? 6 : 12; // l (l + 1), 2 l + 1 times
      EXPECT_NEAR(found[i], expected, 0.01 * expected) << i;
    }
  }
}

// Two spheres, one smaller: each function belongs to its eigenvalue, and is zero on the other sphere.
TEST(Smallest_eigenvalues, functions)
{
  const samples::Indexed_triangles sphere = samples::latitude_longitude_sphere(24, 12);
  auto points = sphere.points;
  auto triangles = sphere.triangles;
  const std::size_t n = points.size();
  for (std::size_t v = 0; v < n; ++v)
    points.push_back({points[v][0] / 2 + 5, points[v][1] / 2, points[v][2] / 2});
  for (const auto& triangle : sphere.triangles) {
    triangles.push_back(triangle);
    for (auto& v : triangles.back())
      v += static_cast<std::decay_t<decltype(v)>>(n);
  }
  const IT::Tufted_Laplacian L = IT::tufted_Laplacian(points, triangles);
  for (std::size_t k : {std::size_t(6), 2 * n}) { // by iteration, and by dense matrices
    const IT::Eigenfunctions found = IT::smallest_eigenfunctions(L.stiffness, L.mass, k);
    ASSERT_EQ(found.eigenvalues.size(), k);
    EXPECT_EQ(found.eigenvalues, IT::smallest_eigenvalues(L.stiffness, L.mass, k));
    for (Eigen::Index i = 0; i < Eigen::Index(k); ++i) {
      const Eigen::VectorXd u = found.functions.col(i);
      const double lambda = found.eigenvalues[std::size_t(i)];
      EXPECT_LT((L.stiffness * u - lambda * (L.mass * u)).norm(), 1e-6 * (1 + lambda)) << i;
      EXPECT_NEAR(u.dot(L.mass * u), 1, 1e-8);
      EXPECT_EQ((std::min)(u.head(Eigen::Index(n)).norm(), u.tail(Eigen::Index(n)).norm()), 0);
      EXPECT_EQ(u.maxCoeff(), u.cwiseAbs().maxCoeff());
      for (Eigen::Index j = 0; j < i && j < 6; ++j)
        EXPECT_NEAR(u.dot(L.mass * found.functions.col(j)), 0, 1e-7);
    }
  }
}

// Half-disks of radius 1 on one diameter, with rings of triangles.
void make_half_disks(int number, int rings, Points& points, Triangles& triangles)
{
  const int columns = 3 * rings; // in each half-disk
  points = {{0, 0, 0}};
  const auto diameter = [&](int ring, int end) { return 1 + 2 * (ring - 1) + end; };
  for (int ring = 1; ring <= rings; ++ring)
    for (int end : {1, -1})
      points.push_back({double(end) * ring / rings, 0, 0});
  for (int sheet = 0; sheet < number; ++sheet) {
    const int first = int(points.size());
    const double tilt = 2 * pi * sheet / number;
    const auto vertex = [&](int ring, int column) {
      if (ring == 0)
        return 0;
      if (column == 0 || column == columns)
        return diameter(ring, column == 0 ? 0 : 1);
      return first + (ring - 1) * (columns - 1) + column - 1;
    };
    for (int ring = 1; ring <= rings; ++ring)
      for (int column = 1; column < columns; ++column) {
        const double a = pi * column / columns, r = double(ring) / rings;
        points.push_back({r * std::cos(a), r * std::sin(a) * std::cos(tilt), r * std::sin(a) * std::sin(tilt)});
      }
    for (int ring = 0; ring < rings; ++ring)
      for (int column = 0; column < columns; ++column) {
        triangles.push_back({vertex(ring, column), vertex(ring + 1, column), vertex(ring + 1, column + 1)});
        if (ring > 0)
          triangles.push_back({vertex(ring, column), vertex(ring + 1, column + 1), vertex(ring, column + 1)});
      }
  }
}

// Functions that are the same on all sheets are those of a half-disk with a free diameter; those whose sum vanishes
// have the diameter fixed, and there are two for each. Both are Bessel functions of the disk.
TEST(Smallest_eigenvalues, three_half_disks_on_one_edge)
{
  Points points;
  Triangles triangles;
  make_half_disks(3, 40, points, triangles);
  const IT::Tufted_Laplacian L = IT::tufted_Laplacian(points, triangles);
  EXPECT_EQ(L.report.nonmanifold_edges, 80u);
  const std::vector<double> found = IT::smallest_eigenvalues(L.stiffness, L.mass, 11);
  const double one = 3.3900, two = 9.3284, zero = 14.6820, three = 17.6500; // squares of zeros of the derivatives of J
  const std::vector<double> expected = {0, one, one, one, two, two, two, zero, three, three, three};
  ASSERT_EQ(found.size(), expected.size());
  EXPECT_EQ(found[0], 0);
  for (std::size_t i = 1; i < found.size(); ++i)
    EXPECT_NEAR(found[i], expected[i], 0.005 * expected[i]) << i;
}

void make_Moebius_strip(int n, Points& points, Triangles& triangles)
{
  const int columns = 12 * n, rows = 2 * n; // an even number of rows
  points.clear();
  triangles.clear();
  for (int c = 0; c < columns; ++c)
    for (int r = 0; r <= rows; ++r) {
      const double a = 2 * pi * c / columns, s = double(2 * r - rows) / rows * 0.4;
      points.push_back(
        {(1 + s * std::cos(a / 2)) * std::cos(a), (1 + s * std::cos(a / 2)) * std::sin(a), s * std::sin(a / 2)});
    }
  const auto vertex = [&](int c, int r) { return c < columns ? c * (rows + 1) + r : rows - r; };
  for (int c = 0; c < columns; ++c)
    for (int r = 0; r < rows; ++r) {
      triangles.push_back({vertex(c, r), vertex(c + 1, r), vertex(c, r + 1)});
      triangles.push_back({vertex(c + 1, r), vertex(c + 1, r + 1), vertex(c, r + 1)});
    }
}

TEST(Smallest_eigenvalues, Moebius_strips_converge_quadratically)
{
  const auto eigenvalues = [](int n) {
    Points points;
    Triangles triangles;
    make_Moebius_strip(n, points, triangles);
    const IT::Tufted_Laplacian L = IT::tufted_Laplacian(points, triangles);
    EXPECT_FALSE(L.report.is_orientable);
    return IT::smallest_eigenvalues(L.stiffness, L.mass, 6);
  };
  const std::vector<double> coarse = eigenvalues(4), fine = eigenvalues(8), finest = eigenvalues(16);
  EXPECT_EQ(finest[0], 0);
  for (std::size_t i = 1; i < 6; ++i) {
    EXPECT_NEAR(fine[i], finest[i], 0.01 * finest[i]) << i;
    EXPECT_NEAR((coarse[i] - fine[i]) / (fine[i] - finest[i]), 4, 1) << i;
  }
}

TEST(Smallest_eigenvalues, zeros_are_counted_by_components_and_rows_without_mass_are_left_out)
{
  const Points points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}, {9, 9, 9}};
  const IT::Tufted_Laplacian L = IT::tufted_Laplacian(points, Triangles{{0, 1, 2}, {3, 4, 5}});
  const std::vector<double> found = IT::smallest_eigenvalues(L.stiffness, L.mass, 100);
  ASSERT_EQ(found.size(), 6u);
  EXPECT_EQ(found[0], 0);
  EXPECT_EQ(found[1], 0);
  // L = (2, -1, -1; -1, 1, 0; -1, 0, 1)/2 and M = 1/6
  for (std::size_t i : {2, 3})
    EXPECT_NEAR(found[i], 3, 1e-12);
  for (std::size_t i : {4, 5})
    EXPECT_NEAR(found[i], 9, 1e-12);
}

// Copies of a surface beside each other, with these sizes.
template <class Surface>
std::pair<Points, Triangles> copies(const Surface& surface, const std::vector<double>& sizes)
{
  std::pair<Points, Triangles> result;
  for (double size : sizes) {
    const int first = int(result.first.size());
    for (const auto& p : surface.points)
      result.first.push_back({size * p[0], size * p[1], size * p[2]});
    for (const auto& t : surface.triangles)
      result.second.push_back({first + int(t[0]), first + int(t[1]), first + int(t[2])});
  }
  return result;
}

// Those of all components, small ones and large ones, are among the smallest as often as they are there.
TEST(Smallest_eigenvalues, of_many_components)
{
  const samples::Indexed_triangles sphere = samples::latitude_longitude_sphere(20, 10),
                                   small = samples::latitude_longitude_sphere(6, 4);
  std::mt19937 random(5);
  std::uniform_int_distribution<int> exponent(-4, 4); // so that scaling is exact
  for (const auto& [surface, n] : {std::pair(sphere, 12), std::pair(small, 300)}) {
    std::vector<double> sizes;
    for (int i = 0; i < n; ++i)
      sizes.push_back(std::ldexp(1., exponent(random)));
    const auto [points, triangles] = copies(surface, sizes);
    const IT::Tufted_Laplacian one = IT::tufted_Laplacian(surface.points, surface.triangles),
                               all = IT::tufted_Laplacian(points, triangles);
    const std::vector<double> of_one = IT::smallest_eigenvalues(one.stiffness, one.mass, 60);
    EXPECT_EQ(of_one[0], 0);
    std::vector<double> expected;
    for (double size : sizes)
      for (double value : of_one)
        expected.push_back(value / (size * size));
    std::sort(expected.begin(), expected.end());
    for (std::size_t number : {std::size_t(n) / 2, std::size_t(n), std::size_t(n) + 1, std::size_t(n) + 50}) {
      const std::vector<double> found = IT::smallest_eigenvalues(all.stiffness, all.mass, number);
      ASSERT_EQ(found.size(), number);
      for (std::size_t i = 0; i < number; ++i) {
        if (i < std::size_t(n)) {
          EXPECT_EQ(found[i], 0);
        } else {
          EXPECT_NEAR(found[i], expected[i], 1e-8 * expected[i]) << i;
        }
      }
    }
  }
}

// Vertices that all but coincide: the zero is still one.
TEST(Smallest_eigenvalues, beside_huge_weights)
{
  samples::Indexed_triangles sphere = samples::latitude_longitude_sphere(20, 10);
  sphere.points.push_back(sphere.points[30]);
  sphere.points.back()[0] += 4e-13;
  std::size_t corners = 0;
  for (auto& triangle : sphere.triangles)
    for (auto& v : triangle)
      if (v == 30 && ++corners > 3)
        v = static_cast<std::decay_t<decltype(v)>>(sphere.points.size() - 1);
  const IT::Tufted_Laplacian L = IT::tufted_Laplacian(sphere.points, sphere.triangles);
  const std::vector<double> found = IT::smallest_eigenvalues(L.stiffness, L.mass, 3);
  EXPECT_EQ(found[0], 0);
  EXPECT_NEAR(found[1], 2, 0.1);
}

// A matrix whose rows do not sum to zero has no zero; entries and masses out of range are refused.
TEST(Smallest_eigenvalues, of_other_matrices)
{
  const samples::Indexed_triangles sphere = samples::latitude_longitude_sphere(20, 10);
  IT::Tufted_Laplacian L = IT::tufted_Laplacian(sphere.points, sphere.triangles);
  const std::vector<double> found = IT::smallest_eigenvalues(L.stiffness, L.mass, 5),
                            shifted = IT::smallest_eigenvalues(L.stiffness + 0.5 * L.mass, L.mass, 5);
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_NEAR(shifted[i], found[i] + 0.5, 1e-8);
  for (double scale : {1e-150, 1e150})
    EXPECT_NEAR(IT::smallest_eigenvalues(L.stiffness, scale * scale * L.mass, 2)[1] * scale * scale, found[1], 1e-8);
  EXPECT_THROW(IT::smallest_eigenvalues(L.stiffness, 1e-307 * L.mass, 2), IT::Numerical_error);
  EXPECT_THROW(IT::smallest_eigenvalues(L.stiffness, 1e307 * L.mass, 2), IT::Numerical_error);
  EXPECT_THROW(IT::smallest_eigenvalues(L.stiffness, 0 * L.mass, 2).at(0), std::out_of_range);
  for (double wrong : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    L.stiffness.coeffRef(3, 3) = wrong;
    EXPECT_THROW(IT::smallest_eigenvalues(L.stiffness, L.mass, 2), IT::Numerical_error);
  }
}

Points random_sphere(int n)
{
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  Points points;
  for (int i = 0; i < n; ++i) {
    const double x = normal(random), y = normal(random), z = normal(random), r = std::sqrt(x * x + y * y + z * z);
    points.push_back({x / r, y / r, z / r});
  }
  return points;
}

TEST(Point_cloud_Laplacian, random_points_on_a_sphere)
{
  Points points = random_sphere(2000);
  points.push_back(points[7]);
  const IT::Tufted_Laplacian L = IT::point_cloud_Laplacian(points);
  EXPECT_NEAR(L.mass.sum(), 4 * pi, 0.01 * 4 * pi);
  EXPECT_GE(L.minimum_weight, 0);
  EXPECT_EQ(L.report.merged_vertices, 1u);
  EXPECT_EQ(L.representative[2000], 7u);
  EXPECT_EQ(L.mass.coeff(2000, 2000), 0);
  for (int c = 0; c < L.stiffness.outerSize(); ++c)
    for (Eigen::SparseMatrix<double>::InnerIterator i(L.stiffness, c); i; ++i) {
      if (i.row() != i.col()) {
        EXPECT_LE(i.value(), 0);
      }
    }
  const std::vector<double> found = IT::smallest_eigenvalues(L.stiffness, L.mass, 9);
  EXPECT_EQ(found[0], 0);
  for (std::size_t i = 1; i < 9; ++i)
    EXPECT_NEAR(found[i], i < 4 ? 2 : 6, i < 4 ? 0.2 : 0.7) << i;
}

// The star of each point is its star in the triangulation of all points, so each triangle occurs three times.
TEST(Point_cloud_Laplacian, points_in_a_plane_have_three_copies_of_their_triangulation)
{
  Points points;
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 12; ++j)
      points.push_back({i + 0.3 * std::sin(5 * i + 3 * j), j + 0.3 * std::sin(2 * i + 7 * j), 2});
  const IT::Tufted_Laplacian L = IT::point_cloud_Laplacian(points, 143);
  EXPECT_EQ(L.report.number_of_faces % 3, 0u);
  EXPECT_NEAR(L.mass.sum(), 121, 15); // the hull of the points
  const std::vector<double> found = IT::smallest_eigenvalues(L.stiffness, L.mass, 3);
  EXPECT_NEAR(found[1], pi * pi / 121, 0.1 * pi * pi / 121);
}

TEST(Point_cloud_Laplacian, points_that_make_no_surface_are_refused)
{
  EXPECT_THROW(IT::point_cloud_Laplacian(Points{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}),
               IT::Invalid_surface_error);
  EXPECT_THROW(IT::point_cloud_Laplacian(Points{{0, 0, 0}, {1, 0, 0}}), IT::Invalid_surface_error);
  EXPECT_THROW(IT::point_cloud_Laplacian(Points{{0, 0, 0}, {1, 0, 0}, {0, std::nan(""), 0}}),
               IT::Invalid_surface_error);
}

} // namespace
