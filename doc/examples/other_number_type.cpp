// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The number type is a parameter of the traits: the same surface with exact decisions, in
// machine numbers, in intervals, and with 128 bits.

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Mpfr_float.h>
#include <CGAL/Intrinsic_triangulations/intrinsic_Delaunay_triangulation.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <CGAL/Interval_nt.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

template <class Traits>
IT::Flip_report run(const char* name, const samples::Indexed_triangles& surface)
{
  std::vector<typename Traits::Point_data> points;
  for (const auto& p : surface.points)
    points.push_back({typename Traits::FT(p[0]), typename Traits::FT(p[1]), typename Traits::FT(p[2])});
  IT::Intrinsic_triangulation<Traits> triangulation(
    IT::make_Delta_complex_from_triangles(points.size(), surface.triangles), points);
  IT::Flip_report report = IT::flip_to_Delaunay(triangulation);
  std::cout << name << ": " << report.flips << " flips, "
            << (report.status == IT::Flip_status::DELAUNAY ? "Delaunay" : "no result") << ", "
            << report.undecided.size() << " edges undecided\n";
  return report;
}

int main()
{
  // Corners on circles: after the rotation, rounding decides what is a tie.
  const samples::Indexed_triangles prism = samples::prism(24, 1);

  const IT::Flip_report exact = run<IT::Filtered_edge_length_traits>("filtered", prism);
  run<IT::Edge_length_traits<double>>("double", prism);
  // An interval decides rightly or not at all. Undecided edges are listed, not guessed.
  const IT::Flip_report intervals = run<IT::Edge_length_traits<CGAL::Interval_nt<>>>("interval", prism);
  const IT::Mpfr_precision precision(128); // of the numbers made while it lives
  const IT::Flip_report mpfr = run<IT::Edge_length_traits<IT::Mpfr_float>>("MPFR", prism);

  const bool is_fine = exact.status == IT::Flip_status::DELAUNAY &&
                       (intervals.status == IT::Flip_status::DELAUNAY) == intervals.undecided.empty() &&
                       mpfr.flips == exact.flips;
  return is_fine ? EXIT_SUCCESS : EXIT_FAILURE;
}
