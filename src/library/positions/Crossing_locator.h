// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Computes the positions of an intrinsic edge's crossings on it and on the input edges.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_CROSSING_LOCATOR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_CROSSING_LOCATOR_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include "../engine/layout/Unfolding.h"
#include <CGAL/Intrinsic_triangulations/errors.h>
#include "../arithmetic/Split_double_double.h"
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Two_doubles.h>
#include "../engine/layout/Metric_frame.h"
#include "../engine/layout/Strip.h"
#include "../engine/layout/metric_images.h"
#include "../engine/layout/Point_frames.h"

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// A number x in [0, 1] with known bounds lower <= x <= upper, as a double.
struct Located
{
  double value;
  bool is_good; // whether the value is within 2^-53 of x, relative to x
};

inline Located located(const Bounded_double_double& x) { return {x.hi(), x.error() <= 0x1p-53 * std::abs(x.hi())}; }
inline Located located(const Mpfr_interval& x)
{
  const double low = mpfr_get_d(x.lower(), MPFR_RNDN), high = mpfr_get_d(x.upper(), MPFR_RNDN);
  // Halfway between two doubles, no number of digits tells which one is next.
  return {low, low == high || x.upper_double() - x.lower_double() <= 0x1p-52 * std::abs(low)};
}

// The input edges that an intrinsic edge crosses, from its crossings.
inline void find_crossed_edges(const Overlay& overlay, const Delta_complex& input,
                               const Overlay::Range<Overlay::Vertex>& crossings, Crossed_edges& result)
{
  result.clear();
  for (Overlay::Vertex x : crossings)
    result.push_back(input.opposite(overlay.crossing_input_halfedge(x)));
}

// Whether a halfedge is the first one of its edge.
inline bool is_in_own_direction(Halfedge_index h) { return (h.idx() & 1) == 0; }

// Both in [0, 1]; a rounded quotient can be outside.
struct Position_on_edges
{
  double on_intrinsic_edge;
  double on_input_edge; // in its own direction

  Position_on_edges(double intrinsic, double input) : Position_on_edges(Two_doubles(intrinsic, input)) {}
  explicit Position_on_edges(Two_doubles both)
  {
    both = min_of(max_of(both, Two_doubles(0.)), Two_doubles(1.));
    on_intrinsic_edge = both.first();
    on_input_edge = both.second();
  }
};

// Uses one a priori error bound; returns false if it is too weak.
//
// In double-doubles from the start: rounding the quotient takes half of the promised error, and in doubles each area
// would add as much, because it is a sum of rounded products. No bound would be small enough even for a single
// crossing.
// \return whether all crossings were located
template <class Frame>
bool locate_crossings(Strip<Frame>& strip, const Crossed_edges& crossed, std::vector<Position_on_edges>& positions)
{
  strip.lay_out(crossed);
  // Quotients of areas with relative errors of 2^-55 have errors of 2^-54 before they are rounded.
  const double enough = 0x1p55 * strip.frame().error(strip.target());
  positions.clear();
  return strip.for_each_crossing([&](const auto& areas, const auto&, const auto&) {
    if (!(areas.left.hi >= enough && areas.right.hi >= enough && areas.along.hi >= enough))
      return false;
    const auto whole = areas.left + areas.right;
    const bool starts_left = is_in_own_direction(crossed[positions.size()]);
    const auto& from_start = starts_left ? areas.left : areas.right;
    // Both quotients at once.
    using Pair = Split_double_double<Two_doubles>;
    const Pair parts(Two_doubles(areas.along.hi, from_start.hi), Two_doubles(areas.along.lo, from_start.lo));
    const Pair whole_twice(whole.hi, whole.lo);
    positions.push_back(Position_on_edges(quotient(parts, whole_twice, 1 / whole.hi).hi));
    return true;
  });
}

class Crossing_locator
{
public:
  // \param surface the input, which caches its answers
  Crossing_locator(const Delta_complex& intrinsic, const Correspondence& correspondence, Input_surface& surface)
    : intrinsic_(intrinsic), correspondence_(correspondence), input_(correspondence.input()), surface_(surface),
      in_space_(input_, Space_frame(input_, surface.metric().points())),
      in_plane_(input_, Plane_frame(input_, surface.metric().points()))
  {}

  // The positions where e crosses these edges, in order; valid until the next call.
  // \pre e crosses input edges
  const std::vector<Position_on_edges>& operator()(Edge_index e, const Crossed_edges& crossed)
  {
    bool is_good = !surface_.metric().points().empty() && !has_inserted_end(e) &&
                   (is_flat(crossed) ? locate_crossings(in_plane_, crossed, positions_)
                                     : locate_crossings(in_space_, crossed, positions_));
    if (!is_good)
      locate_in_stages(e, crossed);
    return positions_;
  }

private:
  bool has_inserted_end(Edge_index e) const
  {
    if (correspondence_.number_of_inserted_vertices() == 0)
      return false;
    const Halfedge_index h = intrinsic_.halfedge(e);
    return correspondence_.is_inserted(intrinsic_.source(h)) || correspondence_.is_inserted(intrinsic_.target(h));
  }

  bool is_flat(const Crossed_edges& crossed)
  {
    return std::all_of(crossed.begin(), crossed.end(), [this](Halfedge_index h) { return surface_.is_flat(h); });
  }

  // By numbers with error bounds, with more and more digits.
  void locate_in_stages(Edge_index e, const Crossed_edges& crossed)
  {
    Double_double_metric metric(surface_);
    if (locate(e, crossed, 0, metric))
      return;
    const std::size_t without_area = number_without_area(crossed);
    bool is_good = without_area > 0 && locate(e, crossed, without_area, metric);
    for (std::size_t i = 0; i < precisions.size() && !is_good; ++i) {
      if (!precise_metrics_[i])
        precise_metrics_[i].emplace(surface_, Mpfr_image{precisions[i]});
      is_good = locate(e, crossed, without_area, *precise_metrics_[i]);
    }
  }

  // With how many triangles of zero area the strip begins. The edges behind them are crossed at its source, which no
  // number of digits proves.
  std::size_t number_without_area(const Crossed_edges& crossed) const
  {
    const auto has_area = [&](Halfedge_index h) { return surface_.metric().has_area(input_, input_.face(h)); };
    if (has_area(input_.opposite(crossed.front())))
      return 0;
    return 1 + std::size_t(std::find_if(crossed.begin(), crossed.end(), has_area) - crossed.begin());
  }

  template <class Metric>
  bool locate(Edge_index e, const Crossed_edges& crossed, std::size_t without_area, Metric& metric)
  {
    using Frame = Metric_frame<Metric>;
    Strip<Frame> strip(input_, Frame(input_, metric));
    Unfolding<Metric>(intrinsic_, correspondence_, metric).lay_out(strip, intrinsic_.halfedge(e), crossed);
    const bool is_line = without_area > crossed.size();
    bool is_good = true;
    positions_.clear();
    strip.for_each_crossing([&](const auto& areas, const auto& left, const auto& right) {
      const bool starts_left = is_in_own_direction(crossed[positions_.size()]);
      check_sides(e, areas.left.sign(), areas.right.sign());
      const auto whole = areas.left + areas.right;
      if (is_line || !is_certain(whole.sign())) {
        // In a strip of zero area an edge can be crossed along its whole length.
        const auto along = [&](const auto& end) {
          return located(times_conjugate(end, strip.target()).x() / squared_norm(strip.target()));
        };
        const Located at_left = along(left), at_right = along(right);
        is_good = is_good && is_line && at_left.is_good && at_right.is_good;
        positions_.push_back(collinear_position(at_left.value, at_right.value, starts_left));
        return true;
      }
      // Each part as a quotient, so that small parts are precise.
      const Located on_intrinsic_edge =
                      positions_.size() < without_area ? Located{0, true} : located(areas.along / whole),
                    on_input_edge = located((starts_left ? areas.left : areas.right) / whole);
      is_good = is_good && on_intrinsic_edge.is_good && on_input_edge.is_good;
      positions_.push_back({on_intrinsic_edge.value, on_input_edge.value});
      return true;
    });
    return is_good;
  }

  void check_sides(Edge_index e, const Uncertain<Sign>& left, const Uncertain<Sign>& right) const
  {
    if (certainly(left == NEGATIVE) || certainly(right == NEGATIVE))
      throw Undecided_error("edge " + std::to_string(e.idx()) +
                            " is no straight line over the input triangles: a rounded decision "
                            "has flipped a hinge that is not convex");
  }

  // The middle of the common part of both edges.
  // \param a, b where the left and the right end lie along the intrinsic edge
  static Position_on_edges collinear_position(double a, double b, bool starts_left)
  {
    const double low = (std::max)(0., (std::min)(a, b)), high = (std::min)(1., (std::max)(a, b));
    const double middle = low + (high - low) / 2;
    const double from_left = a == b ? 0.5 : (middle - a) / (b - a);
    return {middle, starts_left ? from_left : 1 - from_left};
  }

  const Delta_complex& intrinsic_;
  const Correspondence& correspondence_;
  const Delta_complex& input_;
  Input_surface& surface_;
  Strip<Space_frame> in_space_;
  Strip<Plane_frame> in_plane_;
  std::vector<Position_on_edges> positions_;
  // They remember the triangles that neighboring edges cross, too.
  static constexpr std::array<long, 3> precisions = {128, 512, 2048};
  std::array<std::optional<Mpfr_metric>, 3> precise_metrics_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_CROSSING_LOCATOR_H
