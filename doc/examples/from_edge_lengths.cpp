// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A surface without positions in space: a flat torus of one vertex, three edges and two triangles that are glued to
// each other, given by the lengths of the edges alone.

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

int main()
{
  // Side 3 f + i runs from corner i of face f to corner i + 1: each side of face 0 is glued
  // to the same side of face 1.
  const std::vector<std::array<std::size_t, 2>> glued_sides = {{0, 3}, {1, 4}, {2, 5}};
  IT::Delta_complex torus = IT::make_Delta_complex_from_gluing(2, glued_sides);
  std::cout << torus.number_of_vertices() << " vertex, " << torus.number_of_edges() << " edges, "
            << torus.number_of_faces() << " faces\n";

  // One length for each edge: two triangles with sides 3, 4 and 6.
  Triangulation triangulation = Triangulation::from_lengths(std::move(torus), {3, 4, 6});
  const IT::Flip_report report = IT::flip_to_Delaunay(triangulation);

  // In a parallelogram, 6² + d² = 2 (3² + 4²), so that the other diagonal has length √14.
  std::cout.precision(17);
  for (IT::Edge_index e : triangulation.connectivity().edges())
    std::cout << "edge " << e.idx() << (triangulation.connectivity().is_loop(e) ? ", a loop" : "") << ": length "
              << triangulation.length(e) << '\n';
  const double d = triangulation.length(IT::Edge_index(2));
  const bool is_fine = report.status == IT::Flip_status::DELAUNAY && report.flips == 1 && d == 3.7416573867739413;
  return is_fine ? EXIT_SUCCESS : EXIT_FAILURE;
}
