// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/flatten.h"

#include <CGAL/Intrinsic_triangulations/Overlay.h>

#include <algorithm>
#include <cmath>

namespace idt {

namespace IT = CGAL::Intrinsic_triangulations;

Flattened_surface flatten(const IT::Common_subdivision& subdivision, const std::vector<std::array<double, 3>>& points)
{
  const IT::Overlay& overlay = subdivision.overlay();
  const IT::Delta_complex& complex = subdivision.intrinsic();
  Flattened_surface result;
  // The first vertices of the overlay are those of the triangulation.
  for (IT::Vertex_index v : complex.vertices())
    result.points.push_back(subdivision.point(IT::Overlay::Vertex(v.idx()), points));
  for (IT::Face_index f : complex.faces()) {
    const IT::Halfedge_index h = complex.halfedge(f);
    const std::uint32_t a = complex.source(h).idx(), b = complex.target(h).idx(),
                        c = complex.target(complex.next(h)).idx();
    if (a == b || b == c || c == a)
      ++result.number_of_other_faces;
    else
      result.triangles.push_back({a, b, c});
  }
  for (IT::Overlay::Vertex v : overlay.crossings()) {
    const IT::Halfedge_index h = complex.halfedge(overlay.intrinsic_edge(v));
    const auto &p = result.points[complex.source(h).idx()], &q = result.points[complex.target(h).idx()];
    const std::array<double, 3> on_surface = subdivision.point(v, points);
    const double t = subdivision.positions().on_intrinsic_edge(v);
    std::array<double, 3> away{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      away[axis] = on_surface[axis] - ((1 - t) * p[axis] + t * q[axis]);
    result.deviation = (std::max)(result.deviation, std::hypot(away[0], away[1], away[2]));
  }
  return result;
}

} // namespace idt
