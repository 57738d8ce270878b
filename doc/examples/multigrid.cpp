// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A Poisson problem on a surface, by conjugate gradients with a multigrid preconditioner: the levels are simplified
// surfaces, and the prolongations between them carry values. Beside it, a factorization and the preconditioners of Eigen.
//
//   multigrid [MESH]

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Laplace_Beltrami.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/polygon_soup.h>
#include <CGAL/Intrinsic_triangulations/transfer_matrices.h>
#include <CGAL/Intrinsic_triangulations/simplify_surface.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>

#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <type_traits>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;
using Matrix = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;

namespace {

// From each level to the next finer one.
std::vector<Matrix> prolongations(Triangulation triangulation)
{
  constexpr std::size_t coarse_enough = 500;
  std::vector<Matrix> result;
  for (std::size_t n = triangulation.connectivity().number_of_vertices(); n > coarse_enough;) {
    IT::Simplified_surface coarse = IT::simplify_surface(triangulation, CGAL::parameters::number_of_vertices(n / 4));
    if (coarse.kept.size() > n / 2)
      break;
    n = coarse.kept.size();
    result.push_back(IT::prolongation_matrix(coarse.triangulation, coarse.places));
    triangulation = std::move(coarse.triangulation);
  }
  return result;
}

// One V-cycle, with a sweep of Gauss and Seidel before and after each correction by the coarser level, in opposite
// directions: so the preconditioner is symmetric.
class Multigrid_preconditioner
{
public:
  void set_prolongations(std::vector<Matrix> prolongations) { prolongations_ = std::move(prolongations); }

  Multigrid_preconditioner& analyzePattern(const Matrix&) { return *this; }
  Multigrid_preconditioner& factorize(const Matrix& matrix) { return compute(matrix); }
  Multigrid_preconditioner& compute(const Matrix& matrix)
  {
    matrices_ = {matrix};
    for (const Matrix& p : prolongations_)
      matrices_.push_back(p.transpose() * matrices_.back() * p);
    coarsest_.compute(matrices_.back());
    return *this;
  }
  Vector solve(const Vector& right) const { return cycle(0, right); }
  Eigen::ComputationInfo info() { return coarsest_.info(); }

private:
  Vector cycle(std::size_t level, const Vector& right) const
  {
    if (level == prolongations_.size())
      return coarsest_.solve(right);
    const Matrix& matrix = matrices_[level];
    Vector x = matrix.triangularView<Eigen::Lower>().solve(right);
    x += prolongations_[level] * cycle(level + 1, prolongations_[level].transpose() * (right - matrix * x));
    return x + matrix.triangularView<Eigen::Upper>().solve(right - matrix * x);
  }

  std::vector<Matrix> prolongations_, matrices_;
  Eigen::SimplicialLDLT<Matrix> coarsest_;
};

class Stopwatch
{
public:
  double restart()
  {
    const auto now = std::chrono::steady_clock::now();
    return std::chrono::duration<double>(now - std::exchange(begin_, now)).count();
  }

private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

// Prints what a solver does, and returns whether it solves the system.
template <class Solver>
bool solve(const char* name, Solver& solver, const Matrix& matrix, const Vector& right)
{
  Stopwatch stopwatch;
  solver.compute(matrix);
  const double preparation = stopwatch.restart();
  const Vector x = solver.solve(right);
  std::cout << name << ": " << preparation << " s, then " << stopwatch.restart() << " s a solution";
  if constexpr (!std::is_base_of<Eigen::SimplicialLDLT<Matrix>, Solver>::value)
    std::cout << ", " << solver.iterations() << " iterations";
  std::cout << '\n';
  return (matrix * x - right).norm() < 1e-7 * right.norm();
}

template <class Preconditioner>
struct Gradients : Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper, Preconditioner>
{
  Gradients() { this->setTolerance(1e-8); }
};

} // namespace

int main(int argc, char** argv)
{
  samples::Indexed_triangles surface;
  if (argc > 1)
    IT::read_triangles(argv[1], surface.points, surface.triangles);
  else
    surface = samples::bumpy_sphere(120, 80, 0.1);
  Triangulation t(IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles), surface.points);
  IT::flip_to_Delaunay(t);
  const Matrix mass = IT::lumped_mass_matrix(t);
  const double area = mass.diagonal().sum();
  const Matrix matrix = IT::stiffness_matrix(t) + mass / area; // -Δu + u / area = f
  const Vector right = mass * Vector::LinSpaced(mass.rows(), -1, 1);
  std::cout << matrix.rows() << " unknowns\n";

  Eigen::SimplicialLDLT<Matrix> factorization;
  Gradients<Eigen::DiagonalPreconditioner<double>> diagonal;
  Gradients<Eigen::IncompleteCholesky<double>> incomplete;
  Gradients<Multigrid_preconditioner> multigrid;
  bool is_solved = solve("factorization", factorization, matrix, right);
  is_solved = solve("diagonal", diagonal, matrix, right) && is_solved;
  is_solved = solve("incomplete factorization", incomplete, matrix, right) && is_solved;
  Stopwatch stopwatch;
  multigrid.preconditioner().set_prolongations(prolongations(t));
  std::cout << "simplification: " << stopwatch.restart() << " s\n";
  is_solved = solve("multigrid", multigrid, matrix, right) && is_solved;
  return is_solved && 4 * multigrid.iterations() < diagonal.iterations() ? EXIT_SUCCESS : EXIT_FAILURE;
}
