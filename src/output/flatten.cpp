// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/flatten.h"

#include <CGAL/Intrinsic_triangulations/Overlay.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace idt {

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

// In degrees.
double smallest_angle(const Flattened_surface& surface)
{
  double result = 180;
  for (const std::array<std::uint32_t, 3>& triangle : surface.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto &p = surface.points[triangle[i]], &q = surface.points[triangle[(i + 1) % 3]],
                 &r = surface.points[triangle[(i + 2) % 3]];
      std::array<double, 3> a{}, b{}, cross{};
      double size = 0; // so that no product overflows or vanishes
      for (std::size_t axis = 0; axis < 3; ++axis)
        size = (std::max)({size, std::abs(q[axis] - p[axis]), std::abs(r[axis] - p[axis])});
      for (std::size_t axis = 0; axis < 3; ++axis) {
        a[axis] = (q[axis] - p[axis]) / size;
        b[axis] = (r[axis] - p[axis]) / size;
      }
      for (std::size_t axis = 0; axis < 3; ++axis)
        cross[axis] = a[(axis + 1) % 3] * b[(axis + 2) % 3] - a[(axis + 2) % 3] * b[(axis + 1) % 3];
      const double angle =
        std::atan2(std::hypot(cross[0], cross[1], cross[2]), a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
      result = (std::min)(result, angle * (180 / CGAL_PI));
    }
  return result;
}

// The number of pairs of vertices that more than two triangles share as ends of a side.
std::size_t count_non_manifold_edges(const std::vector<std::array<std::uint32_t, 3>>& triangles)
{
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sides;
  for (const std::array<std::uint32_t, 3>& triangle : triangles)
    for (std::size_t i = 0; i < 3; ++i)
      sides.push_back(std::minmax({triangle[i], triangle[(i + 1) % 3]}));
  std::sort(sides.begin(), sides.end());
  std::size_t result = 0;
  for (auto first = sides.begin(); first != sides.end();) {
    const auto last = std::find_if(first, sides.end(), [&](const auto& side) { return side != *first; });
    result += last - first > 2;
    first = last;
  }
  return result;
}

} // namespace

Flattened_surface flatten(const IT::Common_subdivision& subdivision, const std::vector<std::array<double, 3>>& points)
{
  const IT::Overlay& overlay = subdivision.overlay();
  const IT::Delta_complex& complex = subdivision.intrinsic();
  Flattened_surface result;
  // The overlay begins with the vertices of the triangulation.
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
  result.minimum_angle = smallest_angle(result);
  result.number_of_non_manifold_edges = count_non_manifold_edges(result.triangles);
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
