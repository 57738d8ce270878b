// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/Triangulation_result.h"

#include "system/text.h"

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>

namespace idt {

namespace IT = CGAL::Intrinsic_triangulations;

std::array<double, 3> place(const Surface& surface, const IT::Surface_point& point)
{
  const IT::Halfedge_index h = point.halfedge;
  const std::array<IT::Halfedge_index, 3> sides = {h, surface.connectivity.next(h), surface.connectivity.prev(h)};
  const auto& [a, b, c] = point.coordinates;
  std::array<double, 3> result{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t axis = 0; axis < 3; ++axis)
      result[axis] +=
        point.coordinates[i] / (a + b + c) * surface.points[surface.connectivity.source(sides[i]).idx()][axis];
  return result;
}

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
    if (surface.has_points())
      for (double x : place(surface, point))
        os << ',' << in_full(x);
    else
      os << ",,,";
    os << '\n';
    if (!os)
      return; // the disk is full: the caller finds out
  }
}

} // namespace idt
