// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A dome of bad triangles is refined until no angle is below 25 degrees. One more vertex is inserted at a given point.

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/refine_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/verify_Delaunay.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

namespace {

double smallest_angle(const Triangulation& t)
{
  double smallest = 180;
  for (IT::Halfedge_index h : t.connectivity().halfedges())
    if (!t.connectivity().is_border(h))
      smallest = std::min(smallest, IT::angle(t, h) * 180 / CGAL_PI);
  return smallest;
}

double area(const Triangulation& t)
{
  double sum = 0;
  for (IT::Face_index f : t.connectivity().faces())
    sum += t.area(f);
  return sum;
}

} // namespace

int main()
{
  const samples::Indexed_triangles dome = samples::bumpy_dome();
  Triangulation t(IT::make_Delta_complex_from_triangles(dome.points.size(), dome.triangles), dome.points);
  const double area_before = area(t);
  std::cout << "smallest angle " << smallest_angle(t) << " degrees\n";
  IT::flip_to_Delaunay(t);
  std::cout << "after flips    " << smallest_angle(t) << '\n';

  const IT::Refinement_report report = IT::refine_Delaunay(t, CGAL::parameters::minimum_angle(25));
  std::cout << "refined        " << smallest_angle(t) << ", with " << report.insertions << " vertices in faces and "
            << report.segment_splits << " on the border\n";
  const bool is_refined =
    report.status == IT::Refinement_status::REFINED && report.unrefined.empty() && smallest_angle(t) >= 25;

  // In the middle of face 0 of the input. The coordinates need not sum to 1.
  const IT::Delta_complex& input = t.input();
  const IT::Vertex_index v = IT::insert_vertex(t, {input.halfedge(IT::Face_index(0)), {1, 1, 1}});
  std::cout << "vertex " << v.idx() << " sees " << IT::cone_angle(t, v) / CGAL_PI << " pi around it\n";

  // Every decision was exact, and the metric has not changed.
  const bool is_exact = IT::verify_Delaunay(t).is_Delaunay() && std::abs(area(t) / area_before - 1) < 1e-13;
  return is_refined && is_exact ? EXIT_SUCCESS : EXIT_FAILURE;
}
