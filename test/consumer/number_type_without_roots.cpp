// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Must not compile: rational numbers have no square roots.

#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Half_angle_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <CGAL/Gmpq.h>

#include <array>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

int main()
{
  const std::vector<std::array<double, 3>> points{{0, 0, 0}, {4, 0, 0}, {2, 1, 0}, {2, 0, 1}};
  const std::vector<std::array<int, 3>> triangles{{0, 1, 2}, {1, 0, 3}};
  IT::Intrinsic_triangulation<IT::TRAITS<CGAL::Gmpq>> triangulation(
    IT::make_Delta_complex_from_triangles(points.size(), triangles), points);
  IT::flip_to_Delaunay(triangulation);
  const auto length = triangulation.length(IT::Edge_index(0));
  return length > length ? 1 : 0;
}
