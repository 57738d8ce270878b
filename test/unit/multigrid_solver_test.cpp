// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The example of a solver by multigrid, against a factorization.

#include "../../doc/examples/Multigrid_solver.h"
#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Laplace_Beltrami.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <Eigen/SparseCholesky>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Matrix = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;

struct Operators
{
  Matrix stiffness, mass;
};

Operators operators(const samples::Indexed_triangles& surface)
{
  IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits> t(
    IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles), surface.points);
  IT::flip_to_Delaunay(t);
  return {IT::stiffness_matrix(t), IT::lumped_mass_matrix(t)};
}

Operators sphere() { return operators(samples::latitude_longitude_sphere(64, 32)); }

Matrix heat_matrix(const Operators& of, double time) { return of.mass + time * of.stiffness; }

// Any right side.
Vector waves(Eigen::Index n)
{
  Vector b(n);
  for (Eigen::Index i = 0; i < n; ++i)
    b[i] = std::sin(double(i)) + 0.1 * std::cos(0.01 * double(i));
  return b;
}

double relative_difference(const Vector& x, const Vector& y)
{
  return (x - y).cwiseAbs().maxCoeff() / y.cwiseAbs().maxCoeff();
}

TEST(Multigrid_solver, agrees_with_a_factorization)
{
  for (const auto& surface : {samples::latitude_longitude_sphere(64, 32), samples::latitude_longitude_sphere(300, 5)}) {
    const Operators of = operators(surface);
    for (double time : {1e-3, 1., 1e3}) {
      const Matrix a = heat_matrix(of, time);
      const Vector b = of.mass * waves(a.rows());
      Multigrid_solver::Report report;
      const Vector x = Multigrid_solver(a).solve(b, report), y = Eigen::SimplicialLDLT<Matrix>(a).solve(b);
      EXPECT_LT(relative_difference(x, y), 1e-8) << time;
      EXPECT_NEAR(report.relative_residual, (a * x - b).norm() / b.norm(), 1e-14 + 0.5 * report.relative_residual);
      EXPECT_LT(report.relative_residual, 1e-12 + 4 * (a * y - b).norm() / b.norm());
      EXPECT_GT(report.iterations, 0);
      EXPECT_LT(report.iterations, 40);
    }
  }
}

// Zero at one vertex, whose row and column are left out.
TEST(Multigrid_solver, Poisson_problem_on_a_closed_surface)
{
  const Operators of = sphere();
  const Eigen::Index n = of.mass.rows() - 1;
  const Matrix a = of.stiffness.topLeftCorner(n, n);
  const Vector b = of.mass.topLeftCorner(n, n) * waves(n);
  EXPECT_LT(relative_difference(Multigrid_solver(a).solve(b), Eigen::SimplicialLDLT<Matrix>(a).solve(b)), 1e-8);
}

TEST(Multigrid_solver, solves_again)
{
  const Matrix a = heat_matrix(sphere(), 1);
  const Multigrid_solver solver(a);
  const Vector b = waves(a.rows()), expected = solver.solve(b);
  for (double factor : {1., 2., 3.})
    EXPECT_LT(relative_difference(solver.solve(factor * b), factor * expected), 1e-12);
}

TEST(Multigrid_solver, takes_any_unit)
{
  const Matrix a = heat_matrix(sphere(), 1);
  const Vector b = waves(a.rows()), x = Multigrid_solver(a).solve(b);
  for (double unit : {1e-200, 1e200}) {
    EXPECT_LT(relative_difference(Multigrid_solver(a * unit).solve(b * unit), x), 1e-10);
    EXPECT_LT(relative_difference(Multigrid_solver(a).solve(b * unit) / unit, x), 1e-10);
  }
  EXPECT_THROW(Multigrid_solver(a * 1e-200).solve(b * 1e200), IT::Numerical_error);
}

TEST(Multigrid_solver, zero_and_nothing)
{
  const Matrix a = heat_matrix(sphere(), 1);
  EXPECT_EQ(Multigrid_solver(a).solve(Vector::Zero(a.rows())), Vector::Zero(a.rows()).eval());
  EXPECT_EQ(Multigrid_solver(Matrix(0, 0)).solve(Vector(0)).size(), 0);
  Matrix one(1, 1);
  one.coeffRef(0, 0) = 4;
  EXPECT_DOUBLE_EQ(Multigrid_solver(one).solve(Vector::Constant(1, 2.))[0], 0.5);
}

TEST(Multigrid_solver, refuses_what_cannot_be_solved)
{
  const Matrix a = heat_matrix(sphere(), 1);
  const Multigrid_solver solver(a);
  Vector b = waves(a.rows());
  EXPECT_THROW(solver.solve(b.head(b.size() - 1)), IT::Invalid_argument_error);
  b[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(solver.solve(b), IT::Invalid_argument_error);
  EXPECT_THROW(Multigrid_solver(Matrix(3, 4)), IT::Invalid_argument_error);
  EXPECT_THROW(Multigrid_solver(Matrix(3, 3)), IT::Invalid_argument_error); // no diagonal
  Matrix broken = a;
  broken.coeffRef(5, 5) = std::numeric_limits<double>::infinity();
  EXPECT_THROW(Multigrid_solver{broken}, IT::Invalid_argument_error);
  // Neither positive definite nor solvable: the right side has a part in the kernel.
  const Operators of = sphere();
  EXPECT_THROW(Multigrid_solver(of.stiffness).solve(of.mass * Vector::Ones(a.rows())), IT::Numerical_error);
}

} // namespace

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  MPI_Init(&argc, &argv);
  HYPRE_Init();
  const int status = RUN_ALL_TESTS();
  HYPRE_Finalize();
  MPI_Finalize();
  return status;
}
