// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/Triangulation_result.h"

#include "system/text.h"

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/trace_geodesic.h>

#include <cstddef>

namespace idt {

namespace IT = CGAL::Intrinsic_triangulations;

void write_points(std::ostream& os, const Triangulation_result& result)
{
  const Surface& surface = result.surface;
  os << "vertex,input_face,b0,b1,b2,x,y,z\n";
  if (!result.outcome.refinement)
    return;
  std::size_t vertex = surface.connectivity.number_of_vertices();
  for (const IT::Surface_point& point : result.outcome.refinement->points) {
    const IT::Face_index f = surface.connectivity.face(point.halfedge);
    os << vertex++ << ',' << f.idx();
    for (double x : IT::coordinates_from(surface.connectivity, point, surface.connectivity.halfedge(f)))
      os << ',' << in_full(x);
    if (surface.has_points()) {
      IT::Surface_point normalized = point;
      for (double& x : normalized.coordinates)
        x /= point.coordinates[0] + point.coordinates[1] + point.coordinates[2];
      for (double x : IT::point_in_space(surface.connectivity, surface.points, normalized))
        os << ',' << in_full(x);
    } else {
      os << ",,,";
    }
    os << '\n';
    if (!os)
      return; // the disk is full; the caller will notice
  }
}

} // namespace idt
