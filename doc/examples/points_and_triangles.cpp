// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From arrays of points and triangles, those of a file or your own, to the cotangent weights of the intrinsic Delaunay
// triangulation as three more arrays, without a mesh class.
//
//   points_and_triangles [MESH]

#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/intrinsic_Delaunay_triangulation.h>
#include <CGAL/Intrinsic_triangulations/polygon_soup.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

int main(int argc, char** argv)
{
  // Two triangles that meet at a fold, each with an obtuse corner opposite the common edge.
  std::vector<std::array<double, 3>> points = {{{0, 0, 0}}, {{4, 0, 0}}, {{2, 1, 0}}, {{2, 0, 1}}};
  std::vector<std::array<std::uint32_t, 3>> triangles = {{{0, 1, 2}}, {{1, 0, 3}}};
  try {
    if (argc > 1)
      IT::read_triangles(argv[1], points, triangles);

    const auto [idt, report] = IT::intrinsic_Delaunay_triangulation(points, triangles);
    std::vector<std::uint32_t> sources, targets;
    const std::vector<double> weights = IT::element_numbers(idt).cotangent_weights;
    const IT::Delta_complex& complex = idt.connectivity();
    for (IT::Edge_index e : complex.edges()) {
      sources.push_back(complex.source(complex.halfedge(e)).idx());
      targets.push_back(complex.target(complex.halfedge(e)).idx());
    }
    std::cout << points.size() << " vertices, " << weights.size() << " edges, " << report.flips
              << " flips; edge 0 joins " << sources[0] << " and " << targets[0] << ", its weight is " << weights[0]
              << '\n';
  } catch (const IT::Invalid_surface_error& error) {
    std::cerr << error.what() << '\n'; // the file, the element at fault, and what to do
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
