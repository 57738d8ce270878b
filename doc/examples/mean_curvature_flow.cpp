// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Denoising by implicit mean-curvature flow: one step of length h solves (M + h L) x = M x_0 for
// the coordinates x (M. Desbrun, M. Meyer, P. Schröder, A. H. Barr, "Implicit fairing of irregular
// meshes using diffusion and curvature flow", 1999). With the intrinsic operator each new
// position is an average of old ones: none leaves their bounding box, and a spike leaves no
// dent around it.

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Laplace_Beltrami.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cstdlib>
#include <iostream>

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

Eigen::MatrixXd positions(const Mesh& mesh)
{
  Eigen::MatrixXd x(Eigen::Index(mesh.number_of_vertices()), 3);
  for (Mesh::Vertex_index v : mesh.vertices())
    x.row(v.idx()) << mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z();
  return x;
}

Eigen::MatrixXd flow(const IT::Laplace_Beltrami_operator& Laplacian, const Eigen::MatrixXd& x, double h)
{
  const Eigen::SimplicialLDLT<Matrix> solver(Laplacian.mass + h * Laplacian.stiffness);
  return solver.solve(Laplacian.mass * x);
}

// How far below zero the flow takes a function that is 1 at one vertex and 0 at all others, for the worst vertex.
double worst_dent(const IT::Laplace_Beltrami_operator& Laplacian, double h)
{
  const Eigen::Index n = Laplacian.mass.rows();
  return std::min(0., flow(Laplacian, Eigen::MatrixXd::Identity(n, n), h).minCoeff());
}

} // namespace

int main()
{
  const Mesh mesh = mesh_of(samples::bumpy_sphere(40, 21)); // needles and obtuse triangles
  const IT::Laplace_Beltrami_operator extrinsic = IT::extrinsic_Laplacian(mesh),
                                      intrinsic = IT::intrinsic_Delaunay_Laplacian(mesh);
  const double h = 1e-3;
  const Eigen::MatrixXd before = positions(mesh), after = flow(intrinsic, before, h);
  const double dent_extrinsic = worst_dent(extrinsic, h), dent_intrinsic = worst_dent(intrinsic, h);
  std::cout << "spike of height 1, deepest dent after one step: extrinsic " << dent_extrinsic << ", intrinsic "
            << dent_intrinsic << '\n';

  // The flow makes the area smaller, and does not move the center of mass.
  const double dirichlet_before = (before.transpose() * intrinsic.stiffness * before).trace(),
               dirichlet_after = (after.transpose() * intrinsic.stiffness * after).trace();
  const double drift = (Eigen::VectorXd(intrinsic.mass.diagonal()).transpose() * (after - before)).norm();
  std::cout << "Dirichlet energy " << dirichlet_before << " -> " << dirichlet_after << ", drift " << drift << '\n';
  const bool stays_in_box = ((after.colwise().maxCoeff() - before.colwise().maxCoeff()).maxCoeff() <= 1e-12) &&
                            ((before.colwise().minCoeff() - after.colwise().minCoeff()).maxCoeff() <= 1e-12);
  const bool is_fine = dent_extrinsic < -1e-4 && dent_intrinsic > -1e-12 && stays_in_box &&
                       dirichlet_after < dirichlet_before && drift < 1e-9;
  return is_fine ? EXIT_SUCCESS : EXIT_FAILURE;
}
