// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Exact_side.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_EXACT_SIDE_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_EXACT_SIDE_IMPL_H

#include <CGAL/Intrinsic_triangulations/internal/engine/layout/Unfolding.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/decide/Exact_sign.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/layout/Metric_frame.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/layout/Strip.h>
#include <CGAL/Intrinsic_triangulations/internal/positions/Crossing_locator.h>
#include <CGAL/Intrinsic_triangulations/internal/positions/overlay_layers.h>
#include <CGAL/Intrinsic_triangulations/Input_metric.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations::internal {

// The coordinates relative to another halfedge of the face.
template <class Metric>
std::array<typename Metric::Real, 3> coordinates_from(Metric& metric, const Delta_complex& complex,
                                                      const Surface_point& point, Halfedge_index first)
{
  const std::size_t i = side_number(complex, point.halfedge, first);
  const Coordinates& b = point.coordinates;
  return {metric.constant(b[i]), metric.constant(b[(i + 1) % 3]), metric.constant(b[(i + 2) % 3])};
}

inline std::string description_of_distance(Edge_index e)
{
  return "that the distance of a point from an edge that meets edge " + std::to_string(e.idx()) + " is zero";
}

inline Crossed_edges crossed_edges(const Overlay& overlay, const Delta_complex& input, Edge_index e)
{
  Crossed_edges result(input);
  find_crossed_edges(overlay, input, overlay.intrinsic_crossings(e), result);
  return result;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
std::optional<Sign> Exact_side::of_intrinsic_chord(Overlay::Halfedge chord, const Surface_point& point) const
{
  const Halfedge_index h = intrinsic_.halfedge(intrinsic_.edge(overlay_.intrinsic_halfedge(chord)));
  const std::int64_t position =
    std::int64_t(overlay_.segment(chord).idx()) - (*overlay_.intrinsic_segments(intrinsic_.edge(h)).begin()).idx();
  const Sign side = engine_.side_of(h, position, point);
  const Delta_complex& input = engine_.correspondence().input();
  if (side == ZERO && squared_four_areas(engine_.metric(), input, input.face(point.halfedge)) == 0)
    return std::nullopt;
  return (chord.idx() & 1) ? -side : side;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
std::optional<Sign> Exact_side::of_input_chord(Overlay::Halfedge chord, Halfedge_index side,
                                               const Surface_point& point) const
{
  const Overlay::Vertex x = overlay_.source(chord);
  const Edge_index e = intrinsic_.edge(side);
  const bool is_left = side == intrinsic_.halfedge(e);
  const Delta_complex& input = engine_.correspondence().input();
  const Crossed_edges crossed = crossed_edges(overlay_, input, e);
  const auto right_of_crossed_edge = [&](auto& metric) {
    using Metric = std::decay_t<decltype(metric)>;
    using Frame = Metric_frame<Metric>;
    using Vector = typename Frame::Vector;
    const Unfolding<Metric> unfolding(intrinsic_, engine_.correspondence(), metric);
    Strip<Frame> strip(input, Frame(input, metric));
    unfolding.lay_out(strip, intrinsic_.halfedge(e), crossed);
    const auto triangle = strip.triangle_behind(overlay_.intrinsic_position(x));
    // The corner at the source of `side`: from there, the third corner relative to `side` is
    // (p + i four_areas) / (2 s_first). The denominator is multiplied out: it is no input quantity.
    const auto corner = unfolding.opposite_corner(intrinsic_.next(side));
    const auto zero = metric.constant(0);
    const auto b = coordinates_from(metric, intrinsic_, point, side);
    const auto two_s = corner.s_first + corner.s_first;
    const Vector scale((b[0] + b[1] + b[2]) * two_s, zero);
    const Vector from_source(b[1] * two_s + b[2] * corner.p, b[2] * corner.four_areas);
    const Vector p = is_left ? strip.target() * from_source : strip.target() * scale - strip.target() * from_source;
    return area_between(p - triangle.left * scale, triangle.right - triangle.left);
  };
  const Sign result =
    exact_sign(*engine_.input_surface(), right_of_crossed_edge, [e] { return description_of_distance(e); });
  if (result == ZERO && engine_.sign_of_area(intrinsic_.face(side)) == ZERO)
    return std::nullopt;
  return is_left ? result : -result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_EXACT_SIDE_IMPL_H
