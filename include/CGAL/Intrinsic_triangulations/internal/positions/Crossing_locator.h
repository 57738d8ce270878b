// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Computes where the crossings of an intrinsic edge lie on it and on the input edges.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_CROSSING_LOCATOR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_CROSSING_LOCATOR_H

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/Unfolding.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/exact/metric_images.h>
#include <CGAL/Intrinsic_triangulations/internal/positions/Edge_layout.h>
#include <CGAL/Intrinsic_triangulations/internal/positions/Plane_strip.h>
#include <CGAL/Intrinsic_triangulations/internal/positions/Point_strip.h>
#include <CGAL/Intrinsic_triangulations/internal/positions/Strip_layout.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// A number in [0, 1] for which lower <= x <= upper is known, as a double.
struct Located
{
  double value;
  bool is_good; // whether the value is within 2^-53 of x, relative to x
};

inline Located located(const Bounded_double_double& x)
{
  return {x.hi(), x.error() <= 0x1p-53 * std::abs(x.hi())};
}
inline Located located(const Mpfr_interval& x)
{
  const double low = x.lower_double(), high = x.upper_double();
  // An interval around a double is two units in its last place wide, however high the precision.
  return {low + (high - low) / 2, high - low <= 0x1p-51 * std::abs(low)};
}

class Crossing_locator
{
public:
  // \param surface the input, which remembers what it is asked
  Crossing_locator(const Delta_complex& intrinsic, const Correspondence& correspondence,
                   Input_surface& surface, const Overlay& overlay)
    : intrinsic_(intrinsic), correspondence_(correspondence), surface_(surface), overlay_(overlay),
      point_strip_(correspondence.input(), surface.metric().points()),
      plane_strip_(correspondence.input(), surface.metric().points())
  {}

  // Calls `visit(x, on_intrinsic_edge, on_input_edge)` for each crossing of e in order.
  template <class Visit>
  void operator()(Edge_index e, const Visit& visit)
  {
    bool is_good = !surface_.metric().points().empty() && locate_by_points(e);
    if (!is_good) {
      Double_double_metric metric(surface_);
      is_good = locate(e, metric);
    }
    for (long precision : {128l, 512l, 2048l})
      if (!is_good) {
        Mpfr_metric precise_metric(surface_, {precision});
        is_good = locate(e, precise_metric);
      }
    for (std::size_t i = 0; i < positions_.size(); ++i) {
      const Overlay::Vertex x = *(overlay_.intrinsic_crossings(e).begin() + std::ptrdiff_t(i));
      visit(x, in_unit_interval(positions_[i].on_intrinsic_edge),
            in_unit_interval(positions_[i].on_input_edge));
    }
  }

private:
  struct Position
  {
    double on_intrinsic_edge;
    double on_input_edge;
  };

  bool locate_by_points(Edge_index e)
  {
    const Delta_complex& input = correspondence_.input();
    crossed_.clear();
    for (Overlay::Vertex x : overlay_.intrinsic_crossings(e))
      crossed_.push_back(input.opposite(overlay_.crossing_input_halfedge(x)));
    const bool is_in_plane =
      std::all_of(crossed_.begin(), crossed_.end(),
                  [&](Halfedge_index h) { return surface_.is_flat(h); });
    return is_in_plane ? locate_in(plane_strip_) : locate_in(point_strip_);
  }

  template <class Strip>
  bool locate_in(Strip& strip)
  {
    positions_.clear();
    auto crossed = crossed_.begin();
    return strip(crossed_, [&](const Strip_layout::Crossing& crossing) {
      const bool starts_left = (crossed++->idx() & 1) == 0;
      positions_.push_back({crossing.on_line(), starts_left ? crossing.from_left() : crossing.from_right()});
    });
  }

  static double in_unit_interval(double x) { return (std::min)(1., (std::max)(0., x)); }

  // With the target of e on the positive real axis, the ends of a crossed edge lie above it and
  // below it; the heights divide the edge.
  template <class Metric>
  bool locate(Edge_index e, Metric& metric)
  {
    using Real = typename Metric::Real;
    const Unfolding<Metric> unfolding(intrinsic_, correspondence_, metric);
    const Edge_layout<Metric> layout(overlay_, correspondence_.input(), metric, unfolding, e);
    const Real length = squared_norm(layout.target());
    bool is_good = true;
    positions_.clear();
    for (const auto& crossed : layout.crossed_edges()) {
      const auto left = times_conjugate(crossed.left, layout.target());
      const auto direction = times_conjugate(crossed.direction, layout.target());
      const Real below = -(left.y() + direction.y());
      check_sides(e, left.y().sign(), below.sign());
      const Real drop = -direction.y();
      const bool starts_left = (crossed.halfedge.idx() & 1) == 0;
      if (!is_certain(drop.sign()) || get_certain(drop.sign()) == ZERO) {
        is_good = false;
        positions_.push_back(collinear_position(left, direction, length, starts_left));
        continue;
      }
      const Real from_left = left.y() / drop;
      const Located on_intrinsic_edge = located((left.x() + from_left * direction.x()) / length);
      // Both parts as quotients, so that small ones are precise.
      const Located on_input_edge = starts_left ? located(from_left) : located(below / drop);
      is_good = is_good && on_intrinsic_edge.is_good && on_input_edge.is_good;
      positions_.push_back({on_intrinsic_edge.value, on_input_edge.value});
    }
    return is_good;
  }

  void check_sides(Edge_index e, const Uncertain<Sign>& left, const Uncertain<Sign>& right) const
  {
    if (certainly(left == NEGATIVE) || certainly(right == NEGATIVE))
      throw Undecided_error("edge " + std::to_string(e.idx()) +
                            " is no straight line over the input triangles: a rounded decision "
                            "has flipped a hinge that is not convex");
  }

  // In a strip of zero area an edge can be crossed all along: the middle of what both share.
  template <class Vector, class Real>
  static Position collinear_position(const Vector& left, const Vector& direction,
                                     const Real& length, bool starts_left)
  {
    const double a = located(left.x() / length).value,
                 b = located((left.x() + direction.x()) / length).value;
    const double low = (std::max)(0., (std::min)(a, b)), high = (std::min)(1., (std::max)(a, b));
    const double middle = in_unit_interval(low + (high - low) / 2);
    const double from_left = a == b ? 0.5 : in_unit_interval((middle - a) / (b - a));
    return {middle, starts_left ? from_left : 1 - from_left};
  }

  const Delta_complex& intrinsic_;
  const Correspondence& correspondence_;
  Input_surface& surface_;
  const Overlay& overlay_;
  Point_strip point_strip_;
  Plane_strip plane_strip_;
  std::vector<Halfedge_index> crossed_; // from the left to the right
  std::vector<Position> positions_;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_CROSSING_LOCATOR_H
