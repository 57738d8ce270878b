// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Extreme eigenvalues against dense ones, and the histogram of weights.

#include "property/flip_test_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Laplace_Beltrami.h>
#include <CGAL/Intrinsic_triangulations/eigenvalues.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace {

using namespace test_surfaces;
using Traits = IT::Edge_length_traits<double>;

// Of the inner vertices, by definition, without the zeros, which are recognized by their size.
IT::Extreme_eigenvalues dense_eigenvalues(const IT::Delta_complex& c, const Eigen::MatrixXd& stiffness)
{
  std::vector<Eigen::Index> inner;
  for (IT::Vertex_index v : c.vertices())
    if (c.halfedge(v).is_valid() && !c.is_border(c.halfedge(v)))
      inner.push_back(v.idx());
  Eigen::MatrixXd m(inner.size(), inner.size());
  for (std::size_t i = 0; i < inner.size(); ++i)
    for (std::size_t j = 0; j < inner.size(); ++j)
      m(Eigen::Index(i), Eigen::Index(j)) = stiffness(inner[i], inner[j]);
  const Eigen::VectorXd all = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(m).eigenvalues();
  const double largest = all[all.size() - 1];
  Eigen::Index first = 0;
  while (all[first] < 1e-12 * largest)
    ++first;
  return {all[first], largest};
}

void expect_dense(const Surface& surface)
{
  SCOPED_TRACE(surface.name);
  const auto t = triangulation<Traits>(surface);
  const Eigen::SparseMatrix<double> stiffness = IT::stiffness_matrix(t);
  const IT::Extreme_eigenvalues found = IT::extreme_eigenvalues(t.connectivity(), stiffness),
                                expected = dense_eigenvalues(t.connectivity(), Eigen::MatrixXd(stiffness));
  EXPECT_NEAR(found.smallest, expected.smallest, 1e-7 * expected.smallest);
  EXPECT_NEAR(found.largest, expected.largest, 1e-8 * expected.largest);
  EXPECT_DOUBLE_EQ(found.condition_number(), found.largest / found.smallest);
}

} // namespace

TEST(Condition_number, dense_eigenvalues_of_closed_and_open_surfaces)
{
  expect_dense(from_triangles("sphere", samples::bumpy_sphere(14, 9)));
  expect_dense(from_triangles("torus", samples::bad_torus(12, 9)));
  expect_dense(from_triangles("annulus", samples::Schwarz_lantern(9, 12)));
  expect_dense(from_triangles("disk", samples::disk_with_spike(12, 9)));
  expect_dense(from_triangles("small sphere", samples::bumpy_sphere(4, 4)));
  expect_dense(from_triangles("small disk", samples::disk_with_spike(4, 3)));
  samples::Indexed_triangles thin = samples::random_diagonal_grid(9, 9, 1);
  for (auto& p : thin.points) // so that all eigenvalues are about 1e17
    p[1] *= 1e-17;
  expect_dense(from_triangles("thin sheet", thin));
}

TEST(Condition_number, each_closed_component_has_a_zero_that_does_not_count)
{
  for (std::size_t columns : {4, 12}) { // dense, and by iteration
    samples::Indexed_triangles both = samples::bumpy_sphere(columns, columns);
    for (const samples::Indexed_triangles& more :
         {samples::disk_with_spike(columns, 4), samples::bad_torus(columns, 4)}) {
      const auto n = std::uint32_t(both.points.size());
      both.points.insert(both.points.end(), more.points.begin(), more.points.end());
      for (const std::array<std::uint32_t, 3>& t : more.triangles)
        both.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
    }
    both.points.push_back({9, 9, 9}); // and a vertex without a face has none
    expect_dense(from_triangles("", both));
  }
}

TEST(Condition_number, of_nothing_is_an_error)
{
  const auto t = triangulation<Traits>(from_triangles("", samples::sheared_grid(1, 1, 0)));
  EXPECT_THROW(IT::extreme_eigenvalues(t.connectivity(), IT::stiffness_matrix(t)), IT::Invalid_surface_error);
  const auto one = triangulation<Traits>(from_gluing("", samples::one_vertex_torus()));
  EXPECT_THROW(IT::extreme_eigenvalues(one.connectivity(), IT::stiffness_matrix(one)), IT::Invalid_surface_error);
}

TEST(Weight_histogram, counts_inner_edges_once)
{
  // A tetrahedron without a face: three border edges.
  const IT::Delta_complex c =
    IT::make_Delta_complex_from_triangles(4, std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 3, 1}, {1, 3, 2}});
  std::vector<double> weights(c.number_of_edges(), 1e9);
  std::vector<double> values{-2.5, 1, std::numeric_limits<double>::infinity()};
  for (IT::Edge_index e : c.edges())
    if (!c.is_border(e)) {
      weights[e.idx()] = values.back();
      values.pop_back();
    }
  const IT::Weight_histogram h = IT::weight_histogram(c, weights, -2, 2, 4);
  EXPECT_EQ(h.counts, (std::vector<std::size_t>{0, 0, 0, 1}));
  EXPECT_EQ(h.below, 1u);
  EXPECT_EQ(h.above, 1u);
}
