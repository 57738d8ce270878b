// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of overlay_layers.h.

#include <CGAL/Intrinsic_triangulations/internal/positions/overlay_layers.h>
#include "../engine/layout/Unfolding.h"
#include "../engine/decide/Ladder.h"
#include "../engine/layout/Metric_frame.h"
#include "../engine/layout/Strip.h"
#include "Crossing_locator.h"
#include <CGAL/Intrinsic_triangulations/squared_lengths.h>

#include <cstdint>
#include <string>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations::internal {

Halfedge_index only_side_from(const Delta_complex& complex, Face_index f, Vertex_index v)
{
  Halfedge_index result;
  const Halfedge_index first = complex.halfedge(f);
  for (Halfedge_index h : {first, complex.next(first), complex.prev(first)})
    if (complex.source(h) == v) {
      if (result.is_valid())
        return Halfedge_index();
      result = h;
    }
  return result;
}

std::optional<Sign> Input_layer::side_of_chord(Overlay::Halfedge before, const Surface_point& point) const
{
  const Overlay::Halfedge chord = overlay.next(before);
  const Delta_complex& intrinsic = engine.connectivity();
  const Halfedge_index h = intrinsic.halfedge(intrinsic.edge(overlay.intrinsic_halfedge(chord)));
  const std::int64_t position =
    std::int64_t(overlay.segment(chord).idx()) - (*overlay.intrinsic_segments(intrinsic.edge(h)).begin()).idx();
  const Sign side = engine.side_of(h, position, point);
  if (side == ZERO && squared_four_areas(engine.metric(), complex, complex.face(point.halfedge)) == 0)
    return std::nullopt;
  return (chord.idx() & 1) ? -side : side;
}

std::optional<Sign> Intrinsic_layer::side_of_chord(Overlay::Halfedge before, const Surface_point& point) const
{
  const Halfedge_index side = overlay.intrinsic_halfedge(before);
  const Edge_index e = complex.edge(side);
  const bool is_left = side == complex.halfedge(e);
  const Delta_complex& input = engine.correspondence().input();
  Crossed_edges crossed;
  find_crossed_edges(overlay, input, overlay.intrinsic_crossings(e), crossed);
  const auto right_of_crossed_edge = [&](auto& metric) {
    using Metric = std::decay_t<decltype(metric)>;
    using Frame = Metric_frame<Metric>;
    using Vector = typename Frame::Vector;
    const Unfolding<Metric> unfolding(complex, engine.correspondence(), metric);
    Strip<Frame> strip(input, Frame(input, metric));
    unfolding.lay_out(strip, complex.halfedge(e), crossed);
    const auto triangle = strip.triangle_behind(overlay.intrinsic_position(overlay.target(before)));
    // The corner at the source of `side`: from there, the third corner relative to `side` is (p + i four_areas) / (2
    // s_first). The denominator is not an input quantity, so it is multiplied out.
    const auto corner = unfolding.opposite_corner(complex.next(side));
    const auto zero = metric.constant(0);
    const Coordinates c = coordinates_from(complex, point, side);
    const auto at_source = metric.constant(c[0]), at_target = metric.constant(c[1]), at_third = metric.constant(c[2]);
    const auto two_s = corner.s_first + corner.s_first;
    const Vector scale((at_source + at_target + at_third) * two_s, zero);
    const Vector from_source(at_target * two_s + at_third * corner.p, at_third * corner.four_areas);
    const Vector p = is_left ? strip.target() * from_source : strip.target() * scale - strip.target() * from_source;
    return area_between(p - triangle.left * scale, triangle.right - triangle.left);
  };
  const Sign result = exact_sign(*engine.input_surface(), right_of_crossed_edge, [e] {
    return "that the distance of a point from an edge that meets edge " + std::to_string(e.idx()) + " is zero";
  });
  if (result == ZERO && engine.sign_of_area(complex.face(side)) == ZERO)
    return std::nullopt;
  return is_left ? result : -result;
}

} // namespace CGAL::Intrinsic_triangulations::internal
