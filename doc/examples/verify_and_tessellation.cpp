// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A result of any number type is checked exactly from the input alone; and the common part of all Delaunay
// triangulations of a surface, its Delaunay tessellation.

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Delaunay_tessellation.h>
#include <CGAL/Intrinsic_triangulations/verify_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;

template <class Traits>
IT::Intrinsic_triangulation<Traits> triangulate(const samples::Indexed_triangles& surface)
{
  IT::Intrinsic_triangulation<Traits> triangulation(
    IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles), surface.points);
  if (!triangulation.keeps_input()) // the exact traits keep it by default
    triangulation.keep_input(
      IT::Input_metric::from_points(IT::Input_metric::Point_vector(surface.points.begin(), surface.points.end())));
  IT::flip_to_Delaunay(triangulation);
  return triangulation;
}

int main()
{
  const samples::Indexed_triangles prism = samples::prism(24, 1); // many corners on a circle, rotated
  const auto rounded = triangulate<IT::Edge_length_traits<double>>(prism);
  const auto exact = triangulate<IT::Filtered_edge_length_traits>(prism);
  const IT::Delaunay_verification wrong = IT::verify_Delaunay(rounded), right = IT::verify_Delaunay(exact);
  std::cout << "double: " << wrong.not_Delaunay.size() << " of " << wrong.tests
            << " edges are not Delaunay\nexact:  " << right.not_Delaunay.size() << '\n';

  // Squares that are split at random: other diagonals, the same cells.
  const auto first = triangulate<IT::Filtered_edge_length_traits>(samples::random_diagonal_grid(12, 12, 1)),
             second = triangulate<IT::Filtered_edge_length_traits>(samples::random_diagonal_grid(12, 12, 2));
  const std::size_t cells = IT::Delaunay_tessellation(first).number_of_cells();
  std::cout << first.connectivity().number_of_faces() << " triangles form " << cells << " cells\n";

  const bool is_fine = !wrong.is_Delaunay() && right.is_Delaunay() && cells == 144 &&
                       IT::Delaunay_tessellation(second).number_of_cells() == cells;
  return is_fine ? EXIT_SUCCESS : EXIT_FAILURE;
}
