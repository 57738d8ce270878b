// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Geodesic distance by heat (K. Crane, C. Weischedel, M. Wardetzky, "Geodesics in heat", 2013) on
// the intrinsic Delaunay triangulation, and brought back to the input. The distance φ is the function
// whose gradient is nearest to X = -∇u/|∇u|, where u is heat that has spread for a short time. The
// surface is a flat torus of needles, given by lengths alone, on which the distance is known.

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Laplace_Beltrami.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/transfer.h>

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
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;
using Matrix = Eigen::SparseMatrix<double>;

constexpr std::size_t n = 40;

Eigen::VectorXd distance_from_vertex_0(const Triangulation& t)
{
  const IT::Delta_complex& complex = t.connectivity();
  const Matrix stiffness = IT::stiffness_matrix(t), mass = IT::lumped_mass_matrix(t);
  const Eigen::VectorXd source = Eigen::VectorXd::Unit(n * n, 0), // time 1, the squared spacing
    u = Eigen::SimplicialLDLT<Matrix>(mass + stiffness).solve(source);
  Eigen::VectorXd divergence = Eigen::VectorXd::Zero(u.size());
  for (IT::Face_index f : complex.faces()) {
    // The face in the plane, from its lengths: no points are needed.
    const IT::Halfedge_index h = complex.halfedge(f), next = complex.next(h);
    const double base = t.length(complex.edge(h)), area = t.area(f), height = 2 * area / base;
    const Eigen::Vector2d corner[] = {{0, 0}, {base, 0}, {t.cotangent(next) * height, height}};
    const Eigen::Index vertex[] = {complex.source(h).idx(), complex.target(h).idx(),
                                   complex.target(next).idx()};
    Eigen::Vector2d hat_gradient[3], gradient = Eigen::Vector2d::Zero();
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector2d opposite = corner[(i + 2) % 3] - corner[(i + 1) % 3];
      hat_gradient[i] = Eigen::Vector2d(-opposite[1], opposite[0]) / (2 * area);
      gradient += u[vertex[i]] * hat_gradient[i];
    }
    for (int i = 0; i < 3; ++i) // the integral of X · ∇(hat function)
      divergence[vertex[i]] -= area * hat_gradient[i].dot(gradient.normalized());
  }
  const Eigen::VectorXd phi =
    Eigen::SimplicialLDLT<Matrix>(stiffness + 1e-12 * mass).solve(divergence);
  return phi.array() - phi[0];
}

// Vertex v lies at the point (v % n + 5 (v / n), v / n), modulo n in both coordinates.
Triangulation sheared_torus()
{
  std::vector<std::array<std::size_t, 3>> triangles;
  for (std::size_t v = 0; v < n * n; ++v) {
    const std::size_t right = v / n * n + (v + 1) % n, size = n * n;
    triangles.push_back({v, right, (right + n) % size});
    triangles.push_back({v, (right + n) % size, (v + n) % size});
  }
  IT::Delta_complex complex = IT::make_Delta_complex_from_triangles(n * n, triangles);
  std::vector<double> lengths;
  for (IT::Edge_index e : complex.edges()) {
    const std::size_t a = complex.source(complex.halfedge(e)).idx(),
                      b = complex.target(complex.halfedge(e)).idx();
    lengths.push_back(a / n == b / n ? 1 : std::hypot(a % n == b % n ? 5 : 6, 1));
  }
  return Triangulation::from_lengths(complex, lengths);
}

int main()
{
  Triangulation t = sheared_torus();
  IT::flip_to_Delaunay(t);
  const Eigen::VectorXd distance = distance_from_vertex_0(t);
  double error = 0;
  for (std::size_t v = 0; v < n * n; ++v) {
    const std::size_t x = (v % n + 5 * (v / n)) % n, y = v / n;
    const double exact = std::hypot((std::min)(x, n - x), (std::min)(y, n - y));
    error = (std::max)(error, std::abs(distance[Eigen::Index(v)] - exact));
  }
  std::cout << "error up to " << error << ", of distances up to " << std::hypot(n / 2, n / 2) << '\n';
  // Back on the input triangles, cut by the intrinsic edges, it is the same function.
  const auto values = IT::interpolate_intrinsic_values(IT::Common_subdivision(t), distance);
  std::cout << values.size() << " values on the overlay of " << n * n << " vertices\n";
  return error < 1 && values.size() > n * n ? EXIT_SUCCESS : EXIT_FAILURE;
}
