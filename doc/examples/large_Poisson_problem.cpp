// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A Poisson problem on a surface that is too large for a factorization, by one process or by several:
//
//   mpiexec -n 8 large_Poisson_problem 10000000
//
// The surface is a torus. The first process makes the matrix; all solve.

#include "Multigrid_solver.h"

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Laplace_Beltrami.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

// \param number_of_faces approximately
Triangulation torus(int number_of_faces)
{
  const double turn = 2 * std::acos(-1.);
  const int n = int(std::sqrt(number_of_faces / 6)) + 3, m = 3 * n;
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  const auto vertex = [&](int i, int j) { return std::uint32_t((i % m) * n + j % n); };
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      const double u = turn * i / m, v = turn * j / n, r = 3 + std::cos(v);
      points.push_back({r * std::cos(u), r * std::sin(u), std::sin(v)});
      triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  return Triangulation(IT::make_Delta_complex_from_triangles(points.size(), triangles), points);
}

int main(int argc, char** argv)
{
  MPI_Init(&argc, &argv);
  HYPRE_Init();
  int rank = 0, number_of_processes = 1, status = EXIT_SUCCESS;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &number_of_processes);
  try {
    Eigen::SparseMatrix<double> matrix;
    Eigen::VectorXd right;
    if (rank == 0) {
      Triangulation triangulation = torus(argc > 1 ? std::atoi(argv[1]) : 20000);
      IT::flip_to_Delaunay(triangulation); // no weight is negative then
      const Eigen::SparseMatrix<double> stiffness = IT::stiffness_matrix(triangulation),
                                        mass = IT::lumped_mass_matrix(triangulation);
      matrix = stiffness + mass; // -Δu + u = f
      right = mass * Eigen::VectorXd::LinSpaced(mass.rows(), -1, 1);
      std::cout << triangulation.connectivity().number_of_faces() << " faces, " << matrix.rows() << " unknowns\n";
    }
    const Multigrid_solver solver(matrix, MPI_COMM_WORLD);
    Multigrid_solver::Report report;
    const Eigen::VectorXd u = solver.solve(right, report);
    if (rank == 0) {
      std::cout << "solved by " << number_of_processes << " processes in " << report.iterations
                << " iterations, relative residual " << report.relative_residual << "\nu is between " << u.minCoeff()
                << " and " << u.maxCoeff() << "\n";
      if (!((matrix * u - right).norm() < 1e-8 * right.norm()))
        status = EXIT_FAILURE;
    }
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    MPI_Abort(MPI_COMM_WORLD, EXIT_FAILURE);
  }
  HYPRE_Finalize();
  MPI_Finalize();
  return status;
}
