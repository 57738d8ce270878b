// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A visitor that shows progress and stops the flips when time is up. The triangulation reached by then is valid, and
// another run continues from there.

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/observer.h>

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

// A model of IntrinsicTriangulationVisitor.
class Clock_watch
{
  using Clock = std::chrono::steady_clock;

public:
  explicit Clock_watch(std::chrono::seconds limit) : end_(Clock::now() + limit) {}

  bool go_further(const IT::Progress& progress)
  {
    flips_ = progress.flips;
    if (progress.tests % 1000 != 0) // a look at the clock takes longer than a test
      return true;
    if (progress.flips >= next_report_) {
      std::cout << progress.tests << " tests, " << progress.flips << " flips\n";
      next_report_ = progress.flips + 20000;
    }
    return Clock::now() < end_;
  }
  std::uint64_t flips() const { return flips_; }

private:
  Clock::time_point end_;
  std::uint64_t flips_ = 0, next_report_ = 20000;
};

int main()
{
  const samples::Indexed_triangles sample = samples::pillow(400); // its flips are quadratic in number
  Triangulation triangulation(IT::make_Delta_complex_from_triangles(sample.points.size(), sample.triangles),
                              sample.points);

  // A visitor is copied unless it is passed by std::ref().
  bool is_cancelled = false;
  Clock_watch none(std::chrono::seconds(0));
  try {
    IT::flip_to_Delaunay(triangulation, CGAL::parameters::visitor(std::ref(none)));
  } catch (const IT::Cancelled_error&) { // the triangulation is valid, and the next call goes on
    is_cancelled = true;
  }
  Clock_watch hour{std::chrono::hours(1)};
  const IT::Flip_report all = IT::flip_to_Delaunay(triangulation, CGAL::parameters::visitor(std::ref(hour)));
  std::cout << "without time " << none.flips() << " flips, with enough of it " << all.flips << '\n';
  const bool is_fine = is_cancelled && all.status == IT::Flip_status::DELAUNAY && all.flips > 40000;
  return is_fine ? EXIT_SUCCESS : EXIT_FAILURE;
}
