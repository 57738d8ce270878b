// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Strips laid out by the corner ratios of a metric.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_METRIC_FRAME_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_METRIC_FRAME_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include "Fan_positions.h"
#include "Strip.h"
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>

#include <cstddef>
#include <array>
#include <cstdint>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations::internal {

// At an input halfedge ij with the third corner k to its left, both relative to ij: the
// vector from i to k, and the vector from k to j.
template <class Vector>
struct Corner_ratios
{
  Vector at_source;
  Vector at_target;
};

// The frame (see `Strip`) for any ring with a metric of the input: numbers that are exact or have error bounds. The
// unit is the first side of the first triangle, an input halfedge that leaves the source.
//
// \tparam Metric as of `Unfolding`
template <class Metric>
class Metric_frame
{
public:
  using Vector = typename Metric::Vector;
  using Run = Strip_run<Vector>;

  Metric_frame(const Delta_complex& input, Metric& metric) : input_(input), metric_(metric) {}

  // The unit, if an edge crosses that halfedge first.
  static Halfedge_index reference(const Delta_complex& input, Halfedge_index first_crossed)
  {
    return input.prev(input.opposite(first_crossed));
  }

  template <class Crossed>
  Strip_start<Vector> start(const Crossed& crossed) const
  {
    const Vector zero(metric_.constant(0), metric_.constant(0)), one(metric_.constant(1), metric_.constant(0));
    return {{reference(input_, crossed.front()), zero, one, 1}, one};
  }

  auto is_flat(Halfedge_index h) const { return metric_.is_flat(h); }

  void turn_left(Run& run, std::size_t) const { run.direction = run.direction * ratios(run.base).at_source; }

  // The left end moves along a side of the triangle. Using the right end would save a product, but if long thin
  // triangles have short sides on the left, each would add the error of a long vector.
  void turn_right(Run& run, std::size_t i, const Vector&) const
  {
    const Corner_ratios<Vector>& r = ratios(run.base);
    if (i == 0) { // from the unit at 0
      run.left = r.at_source;
      run.direction = r.at_target;
      return;
    }
    run.left = run.left + run.direction * r.at_source;
    run.direction = run.direction * r.at_target;
  }

  auto keeps_fans() const { return metric_.keeps_fans(); }
  void turn_far_left(Run& run, Halfedge_index h) const
  {
    run.direction = run.direction * metric_.fan_ratio(run.base, h, true);
  }
  void turn_far_right(Run& run, Halfedge_index h) const
  {
    const Vector right = run.left + run.direction;
    run.direction = run.direction * metric_.fan_ratio(input_.opposite(run.base), input_.opposite(h), false);
    run.left = right - run.direction;
  }

  Vector position(const Run& run, Vertex_index v) const
  {
    const Vertex_index source = input_.source(run.base);
    return v == source ? run.left : run.left + run.direction * metric_.ratio_in_plane(run.base, source, v);
  }

  void leave(Run& run, Halfedge_index h) const
  {
    run.left = position(run, input_.source(h));
    run.direction = run.direction * metric_.ratio_in_plane(run.base, input_.source(h), input_.target(h));
  }

  // Three coordinates, divided by their sum.
  std::array<typename Metric::Real, 3> weights(const std::array<double, 3>& b) const
  {
    std::array<typename Metric::Real, 3> result{metric_.constant(b[0]), metric_.constant(b[1]), metric_.constant(b[2])};
    if (b[0] + b[1] + b[2] == 1 && sums_exactly(b))
      return result;
    const typename Metric::Real sum = result[0] + result[1] + result[2];
    for (auto& x : result)
      x = x / sum;
    return result;
  }
  Vector real(const typename Metric::Real& x) const { return Vector(x, metric_.constant(0)); }

  void note(const Vector&) const {}
  void check_interruption() const { metric_.interruption().check(); }

  // The shape of the input face to the left of ij; valid until the metric is asked again.
  const Corner_ratios<Vector>& ratios(Halfedge_index ij) const
  {
    return metric_.remembered(ij, [&]() -> Corner_ratios<Vector> {
      const auto s_ij = metric_.squared_length(input_.edge(ij));
      const auto s_jk = metric_.squared_length(input_.edge(input_.next(ij)));
      const auto s_ki = metric_.squared_length(input_.edge(input_.prev(ij)));
      const auto two_s = s_ij + s_ij;
      const auto height = metric_.four_areas(input_.face(ij)) / two_s;
      return {Vector((s_ij + s_ki - s_jk) / two_s, height), Vector((s_ij + s_jk - s_ki) / two_s, -height)};
    });
  }

  // The ratio from a halfedge to a later one around its source: after `at_most` triangles, or fewer if they leave the
  // plane of the first. Updates `from` and `at_most`.
  Vector fan_ratio(Halfedge_index& from, std::int64_t& at_most) const
  {
    const Halfedge_index base = from;
    std::int64_t length = 0;
    const bool is_fan =
      keeps_fans() && at_most >= std::int64_t(Fan_positions::long_fan) && !is_flat(input_.next_around_source(base));
    do {
      from = input_.next_around_source(from);
      ++length;
    } while (length < at_most && (is_fan ? from != base : bool(metric_.is_flat(from))));
    at_most -= length;
    if constexpr (!std::is_same<decltype(keeps_fans()), std::false_type>::value)
      if (is_fan)
        return metric_.fan_ratio(base, from, true);
    if constexpr (!std::is_same<decltype(is_flat(base)), std::false_type>::value)
      if (length > 1)
        return metric_.ratio_in_plane(base, input_.source(base), input_.target(from));
    return ratios(base).at_source;
  }

private:
  static bool sums_exactly(const std::array<double, 3>& b)
  {
    const double sum = b[0] + b[1], part = sum - b[0];
    return (b[0] - (sum - part)) + (b[1] - part) == 0 && (sum + b[2]) - sum == b[2] && (sum + b[2]) - b[2] == sum;
  }

  const Delta_complex& input_;
  Metric& metric_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_METRIC_FRAME_H
