// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The operator of any triangles against results computed by hand or in another way.

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Laplace_Beltrami.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/tufted_Laplacian.h>
#include <CGAL/Intrinsic_triangulations/verify_Delaunay.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Dense>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Matrix = Eigen::SparseMatrix<double>;
using Dense = Eigen::MatrixXd;
using Point = std::array<double, 3>;
using Points = std::vector<Point>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

Eigen::Vector3d vector(const Point& p, const Point& q) { return {q[0] - p[0], q[1] - p[1], q[2] - p[2]}; }

// The cotangent matrix of the triangles as they are, one by one.
Dense cotangent_matrix(const Points& points, const Triangles& triangles)
{
  Dense result = Dense::Zero(Eigen::Index(points.size()), Eigen::Index(points.size()));
  for (const auto& t : triangles)
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3];
      const Eigen::Vector3d u = vector(points[c], points[a]), v = vector(points[c], points[b]);
      const double w = u.dot(v) / u.cross(v).norm() / 2;
      result(a, b) -= w;
      result(b, a) -= w;
      result(a, a) += w;
      result(b, b) += w;
    }
  return result;
}

double total_area(const Points& points, const Triangles& triangles)
{
  double sum = 0;
  for (const auto& [a, b, c] : triangles)
    sum += vector(points[a], points[b]).cross(vector(points[a], points[c])).norm() / 2;
  return sum;
}

void expect_near(const Dense& a, const Dense& b, double bound)
{
  ASSERT_EQ(a.rows(), b.rows());
  EXPECT_LE((a - b).cwiseAbs().maxCoeff(), bound * (1 + b.cwiseAbs().maxCoeff()));
}

// The promises for all triangles.
void check_operator(const IT::Tufted_Laplacian& result)
{
  const Matrix& L = result.stiffness;
  EXPECT_EQ(Dense(L), Dense(L.transpose()));
  const Eigen::VectorXd sums = L * Eigen::VectorXd::Ones(L.rows());
  for (int c = 0; c < L.outerSize(); ++c) {
    EXPECT_LE(std::abs(sums[c]), 1e-12 * L.coeff(c, c));
    for (Matrix::InnerIterator i(L, c); i; ++i) {
      if (i.row() != i.col()) {
        EXPECT_LE(i.value(), 0);
      }
    }
    EXPECT_GE(result.mass.coeff(c, c), 0);
  }
  EXPECT_GE(result.minimum_weight, 0);
}

// A soup with edges of many faces, faces in one plane and turned any way.
void make_soup(std::mt19937& random, Points& points, Triangles& triangles, int size, int number_of_points,
               int number_of_faces)
{
  std::uniform_int_distribution<int> coordinate(-size, size);
  points.clear();
  triangles.clear();
  while (int(points.size()) < number_of_points) {
    const Point p = {double(coordinate(random)), double(coordinate(random)), double(coordinate(random))};
    if (std::find(points.begin(), points.end(), p) == points.end())
      points.push_back(p);
  }
  std::uniform_int_distribution<std::uint32_t> vertex(0, std::uint32_t(points.size() - 1));
  for (int f = 0; f < number_of_faces; ++f)
    triangles.push_back({vertex(random), vertex(random), vertex(random)});
}

bool has_area(const Points& points, const std::array<std::uint32_t, 3>& t)
{
  return vector(points[t[0]], points[t[1]]).cross(vector(points[t[0]], points[t[2]])).norm() > 0; // of integers
}

TEST(Tufted_Laplacian, an_acute_triangle_has_its_cotangents)
{
  const Points points = {{0, 0, 0}, {4, 0, 0}, {1, 3, 0}};
  const Triangles triangles = {{0, 1, 2}};
  const IT::Tufted_Laplacian result = IT::tufted_Laplacian(points, triangles);
  check_operator(result);
  expect_near(Dense(result.stiffness), cotangent_matrix(points, triangles), 1e-15);
  expect_near(Dense(result.mass), 2 * Dense::Identity(3, 3), 1e-15);
}

// The two copies make two isosceles triangles with the apex angles 2α and 2β, whose bases are glued to each other.
TEST(Tufted_Laplacian, an_obtuse_triangle_is_flipped_across_its_border)
{
  const Points points = {{0, 0, 0}, {10, 0, 0}, {2, 1, 0}};
  const IT::Tufted_Laplacian result = IT::tufted_Laplacian(points, Triangles{{0, 1, 2}});
  check_operator(result);
  const double tan_alpha = 1. / 2, tan_beta = 1. / 8;
  Dense expected(3, 3);
  expected << tan_alpha, 0, -tan_alpha, 0, tan_beta, -tan_beta, -tan_alpha, -tan_beta, tan_alpha + tan_beta;
  expect_near(Dense(result.stiffness), expected / 2, 1e-15);
  // Areas 2 · 2/2 and 8 · 1/2 · 2 of both copies: halved, a third at each corner, twice at the third vertex.
  EXPECT_NEAR(result.mass.coeff(0, 0), 2. / 2 / 3, 1e-15);
  EXPECT_NEAR(result.mass.coeff(1, 1), 8. / 2 / 3, 1e-15);
  EXPECT_NEAR(result.mass.coeff(2, 2), 10. / 3, 1e-15);
  EXPECT_EQ(result.flips.flips, 1u);
}

TEST(Tufted_Laplacian, closed_oriented_surfaces_have_the_same_bits_as_the_intrinsic_operator)
{
  for (const samples::Indexed_triangles& surface :
       {samples::bumpy_sphere(30, 15), samples::torus(20, 10), samples::bad_torus(12, 12)}) {
    typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
    Mesh mesh;
    for (const auto& [x, y, z] : surface.points)
      mesh.add_vertex({x, y, z});
    for (const auto& [a, b, c] : surface.triangles)
      mesh.add_face(Mesh::Vertex_index(a), Mesh::Vertex_index(b), Mesh::Vertex_index(c));
    const auto expected = IT::intrinsic_Delaunay_Laplacian(mesh);
    const IT::Tufted_Laplacian found = IT::tufted_Laplacian(surface.points, surface.triangles);
    check_operator(found);
    EXPECT_EQ(Dense(found.stiffness), Dense(expected.stiffness));
    EXPECT_EQ(Dense(found.mass), Dense(expected.mass));
    EXPECT_EQ(found.stiffness.nonZeros(), expected.stiffness.nonZeros());
    const auto options = CGAL::parameters::mass_type(IT::Mass_type::GALERKIN);
    expect_near(Dense(IT::tufted_Laplacian(surface.points, surface.triangles, options).mass),
                Dense(IT::Galerkin_mass_matrix(IT::intrinsic_Delaunay_triangulation(mesh).triangulation)), 1e-15);
  }
}

// All faces once more, in the other orientation: the sheets outside are two copies of the surface, and between the two
// sheets of each face there is a double of this face alone.
TEST(Tufted_Laplacian, all_faces_twice)
{
  const samples::Indexed_triangles surface = samples::bumpy_sphere(10, 6);
  Triangles twice = surface.triangles;
  Dense expected = Dense(IT::tufted_Laplacian(surface.points, surface.triangles).stiffness);
  for (const auto& [a, b, c] : surface.triangles) {
    twice.push_back({a, c, b});
    expected += Dense(IT::tufted_Laplacian(surface.points, Triangles{{a, b, c}}).stiffness);
  }
  const IT::Tufted_Laplacian result = IT::tufted_Laplacian(surface.points, twice);
  check_operator(result);
  EXPECT_EQ(result.report.border_edges, 0u);
  expect_near(Dense(result.stiffness), expected, 1e-12);
}

// Flips never increase the Dirichlet energy of given values at the vertices, and never change the area.
TEST(Tufted_Laplacian, random_soups)
{
  std::mt19937 random(7);
  Points points;
  Triangles triangles;
  std::normal_distribution<double> normal;
  std::size_t nonmanifold = 0, merged = 0;
  for (int round = 0; round < 300; ++round) {
    make_soup(random, points, triangles, 2 + round % 5, 8 + round % 13, 5 + round % 40);
    if (round % 4 == 3)
      points[1] = points[2] = points[0];
    const IT::Tufted_Laplacian result = IT::tufted_Laplacian(points, triangles);
    check_operator(result);
    nonmanifold += result.report.nonmanifold_edges;
    merged += result.report.merged_vertices;
    EXPECT_NEAR(result.mass.sum(), total_area(points, triangles), 1e-10 * (1 + total_area(points, triangles)));
    if (result.report.merged_vertices > 0 ||
        !std::all_of(triangles.begin(), triangles.end(), [&](const auto& t) { return has_area(points, t); }))
      continue;
    const Dense extrinsic = cotangent_matrix(points, triangles);
    for (int i = 0; i < 10; ++i) {
      const Eigen::VectorXd u =
        Eigen::VectorXd::NullaryExpr(Eigen::Index(points.size()), [&](Eigen::Index) { return normal(random); });
      EXPECT_LE(u.dot(result.stiffness * u), u.dot(extrinsic * u) * (1 + 1e-12));
    }
  }
  EXPECT_GT(nonmanifold, 1000u);
  EXPECT_GT(merged, 30u);
}

// By the formulas, from lengths in double, one entry after the other.
TEST(Tufted_Laplacian, matrices_are_sums_over_the_flipped_cover)
{
  std::mt19937 random(11);
  Points points;
  Triangles triangles;
  for (int round = 0; round < 40; ++round) {
    make_soup(random, points, triangles, 6, 12, 25);
    triangles.erase(
      std::remove_if(triangles.begin(), triangles.end(), [&](const auto& t) { return !has_area(points, t); }),
      triangles.end());
    IT::Tufted_cover cover = IT::make_tufted_cover(points, triangles);
    IT::flip_to_Delaunay(cover.triangulation);
    EXPECT_TRUE(IT::verify_Delaunay(cover.triangulation).is_Delaunay());
    const IT::Delta_complex& complex = cover.triangulation.connectivity();
    const Eigen::Index n = Eigen::Index(points.size());
    Dense stiffness = Dense::Zero(n, n), lumped = stiffness, Galerkin = stiffness;
    for (IT::Face_index f : complex.faces()) {
      IT::Halfedge_index h = complex.halfedge(f);
      const double share = cover.is_half[f.idx()] ? 0.5 : 1, area = share * cover.triangulation.area(f);
      for (int i = 0; i < 3; ++i, h = complex.next(h)) {
        const std::uint32_t v = cover.vertex_of[complex.source(h).idx()], w = cover.vertex_of[complex.target(h).idx()];
        const double half = share * cover.triangulation.cotangent(h) / 2;
        stiffness(v, v) += half;
        stiffness(w, w) += half;
        stiffness(v, w) -= half;
        stiffness(w, v) -= half;
        lumped(v, v) += area / 3;
        Galerkin(v, v) += area / 6;
        Galerkin(v, w) += area / 12;
        Galerkin(w, v) += area / 12;
      }
    }
    expect_near(Dense(IT::stiffness_matrix(cover)), stiffness, 1e-12);
    expect_near(Dense(IT::lumped_mass_matrix(cover)), lumped, 1e-12);
    expect_near(Dense(IT::Galerkin_mass_matrix(cover)), Galerkin, 1e-12);
  }
}

// Neither numbers nor orientations nor a rotation that rounds nothing change the operator.
TEST(Tufted_Laplacian, the_order_of_everything_is_of_no_importance)
{
  std::mt19937 random(13);
  Points points;
  Triangles triangles;
  std::uniform_int_distribution<std::uint32_t> vertex(2, 13);
  for (int round = 0; round < 60; ++round) {
    make_soup(random, points, triangles, 50, 14, 10);
    for (int i = 0; i < 8; ++i) // many at one edge, some twice
      triangles.push_back({0, 1, vertex(random)});
    const Dense expected = Dense(IT::tufted_Laplacian(points, triangles).stiffness);

    std::vector<std::uint32_t> number(points.size());
    std::iota(number.begin(), number.end(), 0u);
    std::shuffle(number.begin(), number.end(), random);
    Points moved(points.size());
    for (std::size_t v = 0; v < points.size(); ++v) // by a rotation times 3
      moved[number[v]] = {2 * points[v][0] - points[v][1] + 2 * points[v][2],
                          2 * points[v][0] + 2 * points[v][1] - points[v][2],
                          -points[v][0] + 2 * points[v][1] + 2 * points[v][2]};
    Triangles shuffled;
    for (auto t : triangles) {
      for (std::uint32_t& v : t)
        v = number[v];
      std::shuffle(t.begin(), t.end(), random);
      shuffled.push_back(t);
    }
    std::shuffle(shuffled.begin(), shuffled.end(), random);
    const Dense found = Dense(IT::tufted_Laplacian(moved, shuffled).stiffness);
    Dense back(expected.rows(), expected.cols());
    for (std::size_t v = 0; v < points.size(); ++v)
      for (std::size_t w = 0; w < points.size(); ++w)
        back(Eigen::Index(v), Eigen::Index(w)) = found(number[v], number[w]);
    expect_near(back, expected, 1e-11);
  }
}

TEST(Tufted_Laplacian, a_fixed_border_gives_the_operator_of_the_mesh)
{
  const samples::Indexed_triangles surface = samples::bumpy_dome(12, 8);
  const auto options = CGAL::parameters::surface_cover(IT::Surface_cover::NONE);
  IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits> triangulation(
    IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles), surface.points);
  IT::flip_to_Delaunay(triangulation);
  const IT::Tufted_Laplacian fixed = IT::tufted_Laplacian(surface.points, surface.triangles, options);
  expect_near(Dense(fixed.stiffness), Dense(IT::stiffness_matrix(triangulation)), 1e-14);
  expect_near(Dense(fixed.mass), Dense(IT::lumped_mass_matrix(triangulation)), 1e-14);
}

// The same surface by points and by lengths; and a closed gluing, which is taken as it is.
TEST(Tufted_Laplacian, surfaces_given_by_lengths)
{
  const samples::Indexed_triangles surface = samples::bumpy_dome(9, 7);
  const IT::Delta_complex complex = IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles);
  std::vector<double> lengths;
  for (IT::Edge_index e : complex.edges()) {
    const IT::Halfedge_index h = complex.halfedge(e);
    lengths.push_back(vector(surface.points[complex.source(h).idx()], surface.points[complex.target(h).idx()]).norm());
  }
  const IT::Tufted_Laplacian by_points = IT::tufted_Laplacian(surface.points, surface.triangles);
  const IT::Tufted_Laplacian by_lengths = IT::tufted_Laplacian(complex, lengths);
  check_operator(by_lengths);
  EXPECT_GT(by_points.report.border_edges, 0u);
  EXPECT_EQ(by_lengths.report.border_edges, by_points.report.border_edges);
  expect_near(Dense(by_lengths.stiffness), Dense(by_points.stiffness), 1e-10);
  expect_near(Dense(by_lengths.mass), Dense(by_points.mass), 1e-10);

  const IT::Delta_complex torus =
    IT::make_Delta_complex_from_gluing(2, std::vector<std::array<int, 2>>{{0, 3}, {1, 4}, {2, 5}});
  const IT::Tufted_Laplacian one = IT::tufted_Laplacian(torus, {3, 4, 5});
  EXPECT_EQ(Dense(one.stiffness), Dense::Zero(1, 1));
  EXPECT_NEAR(one.mass.coeff(0, 0), 12, 1e-14);
}

// Two triangles without area on the edge between two large ones: their third vertices are one point of the surface.
TEST(Tufted_Laplacian, vertices_that_triangles_without_area_join_are_merged)
{
  const Points points = {{0, 0, 0}, {4, 0, 0}, {2, 3, 0}, {2, 0, 0}, {2, 0, 0}, {2, -3, 1}};
  const Triangles triangles = {{0, 3, 2}, {3, 1, 2}, {0, 1, 3}, {1, 0, 4}, {0, 5, 4}, {4, 5, 1}};
  const IT::Tufted_Laplacian result = IT::tufted_Laplacian(points, triangles);
  check_operator(result);
  EXPECT_EQ(result.report.merged_vertices, 1u);
  EXPECT_EQ(result.representative[4], 3u);
  EXPECT_EQ(result.stiffness.coeff(4, 4), 0);
  // As without the two, and the vertices merged.
  const IT::Tufted_Laplacian expected =
    IT::tufted_Laplacian(points, Triangles{{0, 3, 2}, {3, 1, 2}, {0, 5, 3}, {3, 5, 1}});
  expect_near(Dense(result.stiffness), Dense(expected.stiffness), 1e-12);
  const auto options = CGAL::parameters::coincident_vertices(IT::Coincident_vertices::ERROR);
  try {
    IT::tufted_Laplacian(points, triangles, options);
    FAIL();
  } catch (const IT::Invalid_surface_error& error) {
    EXPECT_STREQ(error.what(), "vertices 3 and 4 are at the same place, and faces without area join them; merge them "
                               "(Coincident_vertices::MERGE, --coincident-vertices merge)");
  }
}

TEST(Tufted_Laplacian, mollification_is_reported)
{
  const Points points = {{0, 0, 0}, {1, 0, 0}, {0.5, 1e-9, 0}};
  const Triangles triangles = {{0, 1, 2}};
  EXPECT_EQ(IT::tufted_Laplacian(points, triangles).report.mollification.number_of_changed_edges, 0u);
  const IT::Tufted_Laplacian result = IT::tufted_Laplacian(points, triangles, CGAL::parameters::mollification(1e-3));
  check_operator(result);
  EXPECT_EQ(result.report.mollification.number_of_changed_edges, 3u);
  EXPECT_GT(result.report.mollification.largest_relative_change, 1e-4);
}

struct Impatient_visitor
{
  bool go_further(const IT::Progress& progress) { return progress.tests == 0; }
};

TEST(Tufted_Laplacian, flips_can_be_cancelled)
{
  const samples::Indexed_triangles surface = samples::bumpy_dome(9, 7);
  EXPECT_THROW(IT::tufted_Laplacian(surface.points, surface.triangles, CGAL::parameters::visitor(Impatient_visitor())),
               IT::Cancelled_error);
}

TEST(Tufted_Laplacian, a_function_ends_it)
{
  const samples::Indexed_triangles surface = samples::bumpy_dome(9, 7);
  bool goes_on = false;
  const auto options = CGAL::parameters::visitor([&goes_on] { return goes_on; });
  EXPECT_THROW(IT::make_tufted_cover(surface.points, surface.triangles, options), IT::Cancelled_error);
  EXPECT_THROW(IT::tufted_Laplacian(surface.points, surface.triangles, options), IT::Cancelled_error);
  goes_on = true;
  EXPECT_EQ(IT::tufted_Laplacian(surface.points, surface.triangles, options).mass.rows(), int(surface.points.size()));
}

TEST(Tufted_Laplacian, a_function_ends_weights_that_are_computed_exactly)
{
  // The weight of the diagonal of a square is zero, which no error bound tells.
  std::vector<std::array<double, 3>> points = {{0, 0, 0}, {0, 1, 0}};
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::uint32_t i = 0; i < 100; ++i) {
    points.push_back({i + 1., 0, 0});
    points.push_back({i + 1., 1, 0});
    triangles.push_back({2 * i, 2 * i + 2, 2 * i + 3});
    triangles.push_back({2 * i, 2 * i + 3, 2 * i + 1});
  }
  IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits> t(
    IT::make_Delta_complex_from_triangles(points.size(), triangles), points);
  t.set_interruption([] { return false; });
  EXPECT_THROW(IT::stiffness_matrix(t), IT::Cancelled_error);
}

} // namespace
