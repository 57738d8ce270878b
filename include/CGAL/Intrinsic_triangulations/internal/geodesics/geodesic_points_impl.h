// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of trace_geodesic.h.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_GEODESIC_POINTS_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_GEODESIC_POINTS_IMPL_H

#include <CGAL/Intrinsic_triangulations/internal/engine/history/Crossing_sequence.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Input_edge_walk.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/layout/Strip.h>
#include <CGAL/Intrinsic_triangulations/internal/positions/Crossing_locator.h>

#include <cstddef>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// The source of h in the input face into which h leaves it. \pre h runs along no input edge
inline Surface_point source_on_input(const Delta_complex& complex, const Correspondence& correspondence,
                                     Halfedge_index h)
{
  const Delta_complex& input = correspondence.input();
  const Vertex_index v = complex.source(h);
  const Halfedge_index roundabout = correspondence.input_halfedge(h);
  if (!correspondence.is_inserted(v))
    return {input.next(input.opposite(roundabout)), {1, 0, 0}};
  Surface_point p = correspondence.location(v);
  if (roundabout.is_valid()) { // on an input edge
    const Halfedge_index side = input.opposite(roundabout);
    const auto [at_source, at_target] = coordinates_on_edge(input, p, side);
    p = {side, {at_source, at_target, 0}};
  }
  const double sum = p.coordinates[0] + p.coordinates[1] + p.coordinates[2];
  for (double& x : p.coordinates)
    x /= sum;
  return p;
}

// The input edges that h crosses, from the integers alone.
// \pre `engine.prepare()` was called, and h crosses some
inline Crossed_edges find_crossed_edges(const Exact_engine& engine, Halfedge_index h)
{
  const Delta_complex& complex = engine.connectivity();
  const Crossed_halfedges sequence(complex, engine.correspondence(), h, engine.decisions().interruption);
  Crossed_edges crossed(engine.correspondence().input());
  for (std::size_t i = 0; i < sequence.size(); ++i)
    crossed.push_back(sequence[i]);
  return crossed;
}

// An edge along an input edge, or a part of one.
inline void append_along_input_edge(const Delta_complex& complex, const Correspondence& correspondence,
                                    Halfedge_index h, std::vector<Surface_point>& points)
{
  const Delta_complex& input = correspondence.input();
  const Halfedge_index along = correspondence.input_halfedge(h);
  const bool is_turned = input.is_border(along);
  const Halfedge_index side = is_turned ? input.opposite(along) : along;
  const auto append = [&](Vertex_index v, bool is_source) {
    double at_source = is_source == is_turned ? 0 : 1, at_target = 1 - at_source;
    if (correspondence.is_inserted(v)) {
      const auto [a, b] = coordinates_on_edge(input, correspondence.location(v), side);
      at_source = a / (a + b);
      at_target = b / (a + b);
    }
    points.push_back({side, {at_source, at_target, 0}});
  };
  append(complex.source(h), true);
  append(complex.target(h), false);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
void append_input_points(const Exact_engine& engine, Halfedge_index h, std::vector<Surface_point>& points)
{
  const Delta_complex& complex = engine.connectivity();
  const Correspondence& correspondence = engine.correspondence();
  const Delta_complex& input = correspondence.input();
  if (correspondence.coordinates().is_original(complex.edge(h)))
    return append_along_input_edge(complex, correspondence, h, points);
  points.push_back(source_on_input(complex, correspondence, h));
  if (correspondence.coordinates().number_of_crossings(complex.edge(h)) > 0) {
    // Positions are those of the edge, in the direction of its own halfedge, which the overlay has as well.
    const bool is_backward = !is_in_own_direction(h);
    const Crossed_edges crossed = find_crossed_edges(engine, is_backward ? complex.opposite(h) : h);
    const Surface_lease surface = engine.input_surface();
    Crossing_locator locator(complex, correspondence, *surface);
    const std::vector<Position_on_edges>& positions = locator(complex.edge(h), crossed);
    const std::size_t n = crossed.size();
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t j = is_backward ? n - 1 - i : i;
      // The halfedge on the way, which has the face that is entered to its left.
      const Halfedge_index entered = is_backward ? input.opposite(crossed[j]) : crossed[j];
      const double t = positions[j].on_input_edge;
      const double from_source = is_in_own_direction(entered) ? t : 1 - t;
      points.push_back({entered, {1 - from_source, from_source, 0}});
    }
  }
  points.push_back(source_on_input(complex, correspondence, complex.opposite(h)));
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_GEODESIC_POINTS_IMPL_H
