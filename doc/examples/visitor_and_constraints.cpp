// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Edges that must not flip, a visitor that follows the flips and can stop them, and a run that is continued.

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/observer.h>

#include <boost/property_map/function_property_map.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

// A model of IntrinsicTriangulationVisitor.
struct Counter
{
  std::uint64_t limit;
  std::uint64_t flips = 0;
  bool has_flipped_constrained = false;

  bool go_further(const IT::Progress&) { return flips < limit; }
  void after_flip(IT::Edge_index e)
  {
    ++flips;
    has_flipped_constrained = has_flipped_constrained || e.idx() % 10 == 0;
  }
};

int main()
{
  const samples::Indexed_triangles sample = samples::sheared_grid();
  Triangulation triangulation(IT::make_Delta_complex_from_triangles(sample.points.size(), sample.triangles),
                              sample.points);

  // Every tenth edge stays. Any readable property map on Edge_index will do.
  const auto is_constrained =
    boost::make_function_property_map<IT::Edge_index>([](IT::Edge_index e) { return e.idx() % 10 == 0; });

  Counter visitor{100}; // by reference, or the algorithm would count in a copy
  const auto np = CGAL::parameters::edge_is_constrained_map(is_constrained).visitor(std::ref(visitor));
  bool is_cancelled = false;
  try {
    IT::flip_to_Delaunay(triangulation, np);
  } catch (const IT::Cancelled_error&) {
    is_cancelled = true;
  }
  std::cout << "stopped after " << visitor.flips << " flips\n";
  const bool is_stopped = is_cancelled && visitor.flips == 100;

  visitor.limit = UINT64_MAX; // a triangulation is valid whenever a run ends
  const IT::Flip_report second = IT::flip_to_Delaunay(triangulation, np);
  std::cout << "ended after " << second.flips << " more\n";

  std::size_t not_Delaunay = 0;
  for (IT::Edge_index e : triangulation.connectivity().edges())
    if (!triangulation.is_locally_Delaunay(e)) {
      ++not_Delaunay;
      if (!get(is_constrained, e))
        return EXIT_FAILURE;
    }
  std::cout << not_Delaunay << " edges are not Delaunay, all of them constrained\n";

  const bool is_fine = is_stopped && second.status == IT::Flip_status::DELAUNAY && !visitor.has_flipped_constrained;
  return is_fine ? EXIT_SUCCESS : EXIT_FAILURE;
}
