// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Editing with the bi-Laplacian: some vertices are fixed or moved, and the displacement u of the others minimizes the
// integral of (Δu)², that is uᵀ L M⁻¹ L u (M. Botsch, L. Kobbelt, "An intuitive framework for real-time freeform
// modeling", 2004). Here a sheet is given such a rim, two rings wide, that the exact answer is known: the paraboloid x²
// + y², for which Δ²u = 0. The rows of the sheet are shifted against each other, so that its triangles are long and
// obtuse, while its points are spread well: the intrinsic operator depends on the points alone.

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Laplace_Beltrami.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Matrix = Eigen::SparseMatrix<double>;

namespace {

Mesh mesh_of(const samples::Indexed_triangles& sample)
{
  Mesh mesh;
  for (const auto& p : sample.points)
    mesh.add_vertex(Point(p[0], p[1], p[2]));
  for (const auto& t : sample.triangles)
    mesh.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2]));
  return mesh;
}

// Solves for the free entries of u; the others are kept.
void minimize_bi_Laplacian(const IT::Laplace_Beltrami_operator& Laplacian, const std::vector<bool>& is_free,
                           Eigen::VectorXd& u)
{
  const Eigen::VectorXd inverse_mass = Eigen::VectorXd(Laplacian.mass.diagonal()).cwiseInverse();
  const Matrix energy = Laplacian.stiffness * inverse_mass.asDiagonal() * Laplacian.stiffness;
  std::vector<Eigen::Triplet<double>> entries;
  int columns = 0;
  for (std::size_t v = 0; v < is_free.size(); ++v)
    if (is_free[v])
      entries.emplace_back(int(v), columns++, 1);
  Matrix select(u.size(), columns);
  select.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Matrix> solver(select.transpose() * energy * select);
  const Eigen::VectorXd change = solver.solve(-(select.transpose() * (energy * u)));
  u += select * change;
}

// The largest error of the sheet that is bent by its rim.
double error(const Mesh& mesh, const IT::Laplace_Beltrami_operator& Laplacian, std::size_t columns, std::size_t rows)
{
  Eigen::VectorXd exact(Eigen::Index(mesh.number_of_vertices()));
  std::vector<bool> is_free(mesh.number_of_vertices(), false);
  for (Mesh::Vertex_index v : mesh.vertices()) {
    const Point& p = mesh.point(v);
    exact[v.idx()] = p.x() * p.x() + p.y() * p.y();
    const std::size_t column = v.idx() % (columns + 1), row = v.idx() / (columns + 1);
    is_free[v.idx()] = std::min(column, columns - column) >= 2 && std::min(row, rows - row) >= 2;
  }
  Eigen::VectorXd u = exact;
  for (std::size_t v = 0; v < is_free.size(); ++v)
    if (is_free[v])
      u[Eigen::Index(v)] = 0;
  minimize_bi_Laplacian(Laplacian, is_free, u);
  return (u - exact).cwiseAbs().maxCoeff() / exact.cwiseAbs().maxCoeff();
}

} // namespace

int main()
{
  const std::size_t columns = 30, rows = 20;
  samples::Indexed_triangles sheet = samples::sheared_grid(columns, rows, 0);
  for (std::array<double, 3>& p : sheet.points) {
    p[0] += 2.5 * std::sin(p[1] * p[1]) + 0.3 * std::sin(37 * p[0] + 11 * p[1]);
    p[1] += 0.3 * std::sin(23 * p[0] + 5 * p[1]);
  }
  const Mesh mesh = mesh_of(sheet);
  const double extrinsic = error(mesh, IT::extrinsic_Laplacian(mesh), columns, rows),
               intrinsic = error(mesh, IT::intrinsic_Delaunay_Laplacian(mesh), columns, rows);
  std::cout << "largest error of the bent sheet: extrinsic " << extrinsic << ", intrinsic " << intrinsic << '\n';
  return intrinsic < 0.02 && intrinsic < extrinsic / 5 ? EXIT_SUCCESS : EXIT_FAILURE;
}
