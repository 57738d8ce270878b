// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The intrinsic Laplace-Beltrami operator beside the extrinsic one: a function that is harmonic
// inside takes its extrema on the boundary. That is so for a surface, for the intrinsic operator,
// and not for the extrinsic one, which has negative weights.

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Laplace_Beltrami.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <Eigen/SparseCholesky>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;
using Matrix = Eigen::SparseMatrix<double>;

namespace {

// The function with the given values on the boundary and L u = 0 inside.
Eigen::VectorXd harmonic_function(const Triangulation& t, const Eigen::VectorXd& boundary_values)
{
  const IT::Delta_complex& complex = t.connectivity();
  std::vector<Eigen::Triplet<double>> entries;
  int columns = 0;
  for (IT::Vertex_index v : complex.vertices())
    if (!complex.is_border(complex.halfedge(v)))
      entries.emplace_back(int(v.idx()), columns++, 1);
  Matrix select(boundary_values.size(), columns);
  select.setFromTriplets(entries.begin(), entries.end());

  const Matrix stiffness = IT::stiffness_matrix(t);
  const Eigen::SimplicialLDLT<Matrix> solver(select.transpose() * stiffness * select);
  return boundary_values - select * solver.solve(select.transpose() * (stiffness * boundary_values));
}

// Prints, and returns, the smallest and the largest value.
std::array<double, 2> range_of_values(const char* name, const Triangulation& t, const Eigen::VectorXd& boundary_values)
{
  const std::vector<double> weights = IT::cotangent_weights(t);
  std::size_t negative = 0;
  for (IT::Edge_index e : t.connectivity().edges())
    negative += !t.connectivity().is_border(e) && weights[e.idx()] < 0;
  const Eigen::VectorXd u = harmonic_function(t, boundary_values);
  std::cout << name << ": " << negative << " negative weights, values from " << u.minCoeff() << " to " << u.maxCoeff()
            << '\n';
  return {u.minCoeff(), u.maxCoeff()};
}

} // namespace

int main()
{
  const std::size_t columns = 20, rows = 20;
  const samples::Indexed_triangles sheet = samples::sheared_grid(columns, rows, 2);
  Triangulation t(IT::make_Delta_complex_from_triangles(sheet.points.size(), sheet.triangles), sheet.points);

  // 1 in the middle of the lowest row, 0 on the rest of the boundary.
  Eigen::VectorXd values = Eigen::VectorXd::Zero(Eigen::Index(sheet.points.size()));
  values[columns / 2] = 1;
  const auto extrinsic = range_of_values("extrinsic", t, values);
  IT::flip_to_Delaunay(t);
  const auto intrinsic = range_of_values("intrinsic", t, values);
  const bool is_fine = extrinsic[0] < -1e-3 && intrinsic[0] > -1e-12 && intrinsic[1] < 1 + 1e-12;
  return is_fine ? EXIT_SUCCESS : EXIT_FAILURE;
}
