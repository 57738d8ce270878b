// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A visitor that shows progress and stops the flips when time is up. What was reached until then
// is a valid triangulation of the surface, and another run continues from there.

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

// A model of IntrinsicFlipVisitor.
class Progress
{
  using Clock = std::chrono::steady_clock;

public:
  explicit Progress(std::chrono::seconds limit) : end_(Clock::now() + limit) {}

  bool go_further(std::uint64_t tests, std::uint64_t flips)
  {
    if (tests % 1000 != 0) // a look at the clock takes longer than a test
      return true;
    if (flips >= next_report_) {
      std::cout << tests << " tests, " << flips << " flips\n";
      next_report_ = flips + 20000;
    }
    return Clock::now() < end_;
  }
  void after_flip(IT::Edge_index) {}

private:
  Clock::time_point end_;
  std::uint64_t next_report_ = 20000;
};

int main()
{
  const samples::Indexed_triangles sample = samples::pillow(400); // its flips are quadratic in number
  Triangulation triangulation(
    IT::make_Delta_complex_from_triangles(sample.points.size(), sample.triangles), sample.points);

  // A visitor is copied unless it is passed by std::ref().
  const auto run = [&](std::chrono::seconds limit) {
    Progress progress(limit);
    return IT::flip_to_Delaunay(triangulation, CGAL::parameters::visitor(std::ref(progress)));
  };
  const IT::Flip_report none = run(std::chrono::seconds(0)), all = run(std::chrono::hours(1));
  std::cout << "without time " << none.flips << " flips, with enough of it " << all.flips << '\n';
  const bool is_fine = none.status == IT::Flip_status::CANCELLED &&
                       all.status == IT::Flip_status::DELAUNAY && all.flips > 40000;
  return is_fine ? EXIT_SUCCESS : EXIT_FAILURE;
}
