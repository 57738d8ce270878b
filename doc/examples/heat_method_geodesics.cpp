// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Geodesic distance by heat on the intrinsic Delaunay triangulation, transferred back to the input. The surface is a
// flat torus of needles, given by lengths alone, on which the distance is known.

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Heat_method.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/transfer.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

constexpr std::size_t n = 40;

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
    const std::size_t a = complex.source(complex.halfedge(e)).idx(), b = complex.target(complex.halfedge(e)).idx();
    lengths.push_back(a / n == b / n ? 1 : std::hypot(a % n == b % n ? 5 : 6, 1));
  }
  return Triangulation::from_lengths(complex, lengths);
}

int main()
{
  Triangulation t = sheared_torus();
  IT::flip_to_Delaunay(t);
  IT::Heat_method<> heat(t);
  heat.add_source(IT::Vertex_index(0));
  const std::vector<double>& distances = heat.distances();
  double error = 0;
  for (std::size_t v = 0; v < n * n; ++v) {
    const std::size_t x = (v % n + 5 * (v / n)) % n, y = v / n;
    const double exact = std::hypot((std::min)(x, n - x), (std::min)(y, n - y));
    error = (std::max)(error, std::abs(distances[v] - exact));
  }
  std::cout << "error up to " << error << ", of distances up to " << std::hypot(n / 2, n / 2) << '\n';
  // Back on the input triangles, cut by the intrinsic edges, it is the same function.
  const Eigen::VectorXd distance = Eigen::VectorXd::Map(distances.data(), Eigen::Index(distances.size()));
  const auto values = IT::interpolate_intrinsic_values(IT::Common_subdivision(t), distance);
  std::cout << values.size() << " values on the overlay of " << n * n << " vertices\n";
  return error < 1 && values.size() > n * n ? EXIT_SUCCESS : EXIT_FAILURE;
}
