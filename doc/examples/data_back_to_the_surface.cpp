// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Heat spreads on the intrinsic Delaunay triangulation of a bad mesh, and the result is transferred: to the overlay, to
// single points of the mesh, and to its vertices.

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Laplace_Beltrami.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/Point_location.h>
#include <CGAL/Intrinsic_triangulations/intrinsic_Delaunay_triangulation.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/transfer.h>
#include <CGAL/Intrinsic_triangulations/transfer_matrices.h>

#include <Eigen/SparseCholesky>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

int main()
{
  const samples::Indexed_triangles mesh = samples::bumpy_sphere(40, 21);
  Triangulation idt(IT::make_Delta_complex_from_triangles(mesh.points.size(), mesh.triangles), mesh.points);
  IT::flip_to_Delaunay(idt);

  const IT::Common_subdivision subdivision(idt);
  const IT::Overlay& overlay = subdivision.overlay();
  const IT::Transfer_mass_matrices mass = IT::transfer_mass_matrices(subdivision);

  // One implicit step of (M + t L) u = M u_0, with the heat in vertex 0.
  const Eigen::SparseMatrix<double> stiffness = IT::stiffness_matrix(idt);
  Eigen::VectorXd start = Eigen::VectorXd::Zero(stiffness.rows());
  start[0] = 1;
  const Eigen::SparseMatrix<double> matrix = mass.intrinsic + 0.1 * stiffness;
  const Eigen::VectorXd heat = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(mass.intrinsic * start);

  // On the overlay the solution is linear on each face: nothing is lost.
  const IT::Delta_complex& complex = idt.connectivity();
  const std::vector<double> on_overlay = IT::interpolate_intrinsic_values(subdivision, heat);
  std::cout << on_overlay.size() << " values represent the solution, " << overlay.number_of_crossings()
            << " of them at crossings\n";

  // At a point of the mesh, here the middle of the input edge with the first crossing.
  const IT::Overlay::Vertex x = *overlay.crossings().begin();
  const IT::Halfedge_index h(2 * overlay.input_edge(x).idx());
  const IT::Point_location location(subdivision);
  const double t = subdivision.positions().on_input_edge(x);
  const IT::Surface_point at_crossing = location.input_to_intrinsic({h, {1 - t, t, 0}}),
                          middle = location.input_to_intrinsic({h, {1, 1, 0}});
  std::cout << "in the middle of input edge " << h.idx() / 2 << ": " << IT::interpolate(complex, heat, middle) << '\n';

  // For the vertices of the mesh, the least-squares nearest function on its triangles.
  const Eigen::VectorXd on_mesh = IT::L2_projection_to_input(mass)(heat);
  const double before = (mass.intrinsic * heat).sum(), after = (mass.input * on_mesh).sum();
  std::cout << "heat " << before << " on the intrinsic triangulation, " << after << " on the mesh\n";

  const bool is_fine =
    std::abs(after - before) < 1e-12 * before &&
    std::abs(IT::interpolate(complex, heat, at_crossing) - on_overlay[x.idx()]) < 1e-12 * heat.maxCoeff();
  return is_fine ? EXIT_SUCCESS : EXIT_FAILURE;
}
