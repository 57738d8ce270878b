// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A flat torus that is sheared so far that Delaunay flips, one by one, would take years.

#include <CGAL/Intrinsic_triangulations/untwist.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

int main()
{
  // The lattice of (1, 0) and (n, 1): two triangles with the sides (1, 0), (n, 1) and (n + 1, 1). Their squared lengths
  // have 25 digits, which doubles would round to those of no triangle.
  const IT::Integer n("1000000000000");
  const std::vector<std::array<std::size_t, 2>> glued_sides = {{0, 3}, {1, 4}, {2, 5}};
  IT::Exact_gluing torus;
  torus.complex = IT::make_Delta_complex_from_gluing(2, glued_sides);
  torus.squared_lengths = {1, n * n + 1, (n + 1) * (n + 1) + 1};

  const auto [idt, report, untwisting] =
    IT::intrinsic_Delaunay_triangulation(torus, CGAL::parameters::fast_forward(true));

  // It is the square torus: each of the two sides of the square, and one of its diagonals.
  std::cout << untwisting.number_of_flips << " flips in " << untwisting.twists.size() << " twist, " << report.flips
            << " after it\n";
  double sum = 0;
  for (IT::Edge_index e : idt.connectivity().edges()) {
    std::cout << "length " << idt.length(e) << ", crosses " << untwisting.crossings.number_of_crossings(e)
              << " edges of the input\n";
    sum += idt.length(e) * idt.length(e);
  }
  const bool is_fine =
    report.status == IT::Flip_status::DELAUNAY && untwisting.number_of_flips >= n - 1 && sum > 3.999 && sum < 4.001;
  return is_fine ? EXIT_SUCCESS : EXIT_FAILURE;
}
