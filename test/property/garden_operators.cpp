// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The garden, by the algorithms that need linear algebra.

#include "property/garden.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Laplace_Beltrami.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/eigenvalues.h>
#include <CGAL/Intrinsic_triangulations/conformal_parameterization.h>
#include <CGAL/Intrinsic_triangulations/harmonic_parameterization.h>
#include <CGAL/Intrinsic_triangulations/transfer_matrices.h>
#include <CGAL/Intrinsic_triangulations/tufted_Laplacian.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cmath>
#include <variant>

namespace garden {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

// Rows sum to zero, and no weight of an edge between two faces is negative.
void stiffness(const Surface& surface)
{
  const Triangulation t = Delaunay_triangulation(surface);
  const IT::Delta_complex& complex = t.connectivity();
  const std::vector<double> weights = IT::cotangent_weights(t);
  for (IT::Edge_index e : complex.edges()) {
    EXPECT_TRUE(std::isfinite(weights[e.idx()]));
    if (complex.is_flippable(e)) {
      EXPECT_GE(weights[e.idx()], 0);
    }
  }
  const Matrix matrix = IT::stiffness_matrix(t);
  for (int v = 0; v < matrix.outerSize(); ++v) {
    double row_sum = 0, magnitude = 0;
    for (Matrix::InnerIterator i(matrix, v); i; ++i) {
      row_sum += i.value();
      magnitude += std::abs(i.value());
    }
    expect_near(row_sum, 0, 1e-12 * magnitude, "row sum");
  }
  const IT::Weight_histogram histogram = IT::weight_histogram(complex, weights, -10, 10, 20);
  EXPECT_EQ(histogram.counts.size(), 20u);
}

// Both sum to the area.
void mass(const Surface& surface)
{
  const Triangulation t = Delaunay_triangulation(surface);
  const double area = sum(IT::face_areas(t));
  expect_near(IT::lumped_mass_matrix(t).sum(), area, 1e-9 * area, "lumped mass");
  expect_near(IT::Galerkin_mass_matrix(t).sum(), area, 1e-9 * area, "Galerkin mass");
}

void condition_number(const Surface& surface)
{
  const Triangulation t = Delaunay_triangulation(surface);
  const IT::Extreme_eigenvalues values = IT::extreme_eigenvalues(t.connectivity(), IT::stiffness_matrix(t));
  EXPECT_GT(values.smallest, 0);
  EXPECT_GE(values.condition_number(), 1);
  EXPECT_TRUE(std::isfinite(values.condition_number()));
}

// Constants stay constant.
void project(const Surface& surface)
{
  const Triangulation t = Delaunay_triangulation(surface);
  const IT::Transfer_mass_matrices matrices = IT::transfer_mass_matrices(IT::Common_subdivision(t));
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(matrices.input.rows());
  for (const Eigen::VectorXd& x : {Eigen::VectorXd(IT::L2_projection_to_input(matrices)(ones)),
                                   Eigen::VectorXd(IT::L2_projection_to_intrinsic(matrices)(ones))})
    expect_near((x - ones).cwiseAbs().maxCoeff(), 0, 1e-6, "projected constant");
}

// As for a stiffness matrix, but for any triangles and without exceptions for the border.
void tufted(const Surface& surface)
{
  const auto* const s = std::get_if<samples::Indexed_triangles>(&surface);
  const auto from_gluing = [&] {
    const IT::Delta_complex complex = connectivity(surface);
    return IT::tufted_Laplacian(complex, edge_lengths(std::get<samples::Glued_triangles>(surface), complex));
  };
  const IT::Tufted_Laplacian result = s ? IT::tufted_Laplacian(s->points, s->triangles) : from_gluing();
  EXPECT_GE(result.minimum_weight, 0);
  for (int v = 0; v < result.stiffness.outerSize(); ++v) {
    double row_sum = 0;
    for (Matrix::InnerIterator i(result.stiffness, v); i; ++i) {
      row_sum += i.value();
      EXPECT_TRUE(i.row() == v ? i.value() >= 0 : i.value() <= 0) << i.value();
    }
    expect_near(row_sum, 0, 1e-12 * result.stiffness.coeff(v, v), "row sum");
    EXPECT_GE(result.mass.coeff(v, v), 0);
  }
}

void expect_map(const Triangulation& t, const IT::Planar_points& uv)
{
  EXPECT_EQ(uv.size(), t.connectivity().number_of_vertices());
  IT::check_parameterization(t.connectivity(), uv); // throws for NaN
  const std::vector<double> areas = IT::face_areas(t);
  const std::vector<double> distortion =
    IT::quasi_conformal_distortion(t.connectivity(), IT::edge_lengths(t), areas, uv);
  for (double x : distortion)
    EXPECT_GE(x, 1);
  EXPECT_GE(IT::summarize_distortion(distortion, areas).mean, 1);
}

void map_to_circle(const Surface& surface)
{
  const Triangulation t = Delaunay_triangulation(surface);
  expect_map(t, IT::harmonic_parameterization(t));
}

void map_to_triangle(const Surface& surface)
{
  const Triangulation t = Delaunay_triangulation(surface);
  expect_map(t, IT::harmonic_parameterization(t, IT::Planar_points{{0, 0}, {1, 0}, {0, 1}}));
}

void map_naturally(const Surface& surface)
{
  const Triangulation t = Delaunay_triangulation(surface);
  expect_map(t, IT::natural_parameterization(t));
}

void map_conformally(const Surface& surface)
{
  const IT::Conformal_map map = IT::conformal_parameterization(Delaunay_triangulation(surface));
  EXPECT_TRUE(map.is_certified);
  EXPECT_LE(map.metric.residual, 1e-7); // 1e-8 on slivers, whose angles depend on the last bits of lengths
}

} // namespace

std::vector<Algorithm> cover_algorithms() { return {{"tufted", tufted}}; }

std::vector<Algorithm> operator_algorithms()
{
  return {{"stiffness", stiffness},        {"mass", mass},
          {"condition", condition_number}, {"project", project},
          {"circle", map_to_circle},       {"triangle", map_to_triangle},
          {"natural", map_naturally},      {"conformal", map_conformally}};
}

} // namespace garden
