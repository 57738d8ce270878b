// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Exact_side.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_EXACT_SIDE_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_EXACT_SIDE_IMPL_H

#include <CGAL/Intrinsic_triangulations/Unfolding.h>
#include <CGAL/Intrinsic_triangulations/internal/exact/Exact_sign.h>
#include <CGAL/Intrinsic_triangulations/internal/positions/Edge_layout.h>
#include <CGAL/Intrinsic_triangulations/internal/positions/Exact_side.h>
#include <CGAL/Intrinsic_triangulations/internal/positions/overlay_layers.h>
#include <CGAL/Intrinsic_triangulations/rational_metric.h>

#include <array>
#include <cstddef>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// The coordinates relative to another halfedge of the face.
template <class Metric>
std::array<typename Metric::Real, 3> coordinates_from(Metric& metric, const Delta_complex& complex,
                                                      const Surface_point& point,
                                                      Halfedge_index first)
{
  const std::size_t i = side_number(complex, point.halfedge, first);
  const Coordinates& b = point.coordinates;
  return {metric.constant(b[i]), metric.constant(b[(i + 1) % 3]), metric.constant(b[(i + 2) % 3])};
}

inline std::string description_of_distance(Edge_index e)
{
  return "that the distance of a point from an edge that meets edge " + std::to_string(e.idx()) + " is zero";
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
std::optional<Sign> Exact_side::of_intrinsic_chord(Overlay::Halfedge chord, const Surface_point& point) const
{
  const Delta_complex& input = geometry_.correspondence().input();
  const Edge_index e = intrinsic_.edge(overlay_.intrinsic_halfedge(chord));
  const std::size_t position =
    overlay_.segment(chord).idx() - (*overlay_.intrinsic_segments(e).begin()).idx();
  const auto left_of_edge = [&](auto& metric) {
    using Metric = std::decay_t<decltype(metric)>;
    using Vector = typename Metric::Vector;
    const Unfolding<Metric> unfolding(intrinsic_, geometry_.correspondence(), metric);
    const Edge_layout<Metric> layout(overlay_, input, metric, unfolding, e);
    const auto& crossed = layout.crossed_edges();
    const auto zero = metric.constant(0);
    if (position == 0) { // before the first crossing
      const Halfedge_index base = Edge_layout<Metric>::base(input, crossed.front().halfedge);
      const auto b = coordinates_from(metric, input, point, base);
      const Vector p = Vector(b[1], zero) + Vector(b[2], zero) * unfolding.corner_ratios(base).at_source;
      return times_conjugate(p, layout.target()).y();
    }
    const auto& last = crossed[position - 1];
    const auto b = coordinates_from(metric, input, point, last.halfedge);
    const Vector p =
      last.left * Vector(b[0] + b[1] + b[2], zero) +
      last.direction * (Vector(b[1], zero) +
                        Vector(b[2], zero) * unfolding.corner_ratios(last.halfedge).at_source);
    return times_conjugate(p, layout.target()).y();
  };
  const Sign side = exact_sign(*geometry_.input_surface(), left_of_edge, [e] { return description_of_distance(e); });
  if (side == ZERO && squared_four_areas(geometry_.metric(), input, input.face(point.halfedge)) == 0)
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
  const auto right_of_crossed_edge = [&](auto& metric) {
    using Metric = std::decay_t<decltype(metric)>;
    using Vector = typename Metric::Vector;
    const Unfolding<Metric> unfolding(intrinsic_, geometry_.correspondence(), metric);
    const Edge_layout<Metric> layout(overlay_, geometry_.correspondence().input(), metric,
                                     unfolding, e);
    const auto& crossed = layout.crossed_edges()[overlay_.intrinsic_position(x)];
    // The corner at the source of `side`: from there, the third corner relative to `side` is
    // (p + i four_areas) / (2 s_first). The denominator is multiplied out: it is no input quantity.
    const auto corner = unfolding.opposite_corner(intrinsic_.next(side));
    const auto zero = metric.constant(0);
    const auto b = coordinates_from(metric, intrinsic_, point, side);
    const auto two_s = corner.s_first + corner.s_first;
    const Vector scale((b[0] + b[1] + b[2]) * two_s, zero);
    const Vector from_source(b[1] * two_s + b[2] * corner.p, b[2] * corner.four_areas);
    const Vector p = is_left ? layout.target() * from_source
                             : layout.target() * scale - layout.target() * from_source;
    return times_conjugate(crossed.direction, p - crossed.left * scale).y();
  };
  const Sign result =
    exact_sign(*geometry_.input_surface(), right_of_crossed_edge, [e] { return description_of_distance(e); });
  if (result == ZERO && geometry_.sign_of_area(intrinsic_, intrinsic_.face(side)) == ZERO)
    return std::nullopt;
  return is_left ? result : -result;
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_EXACT_SIDE_IMPL_H
