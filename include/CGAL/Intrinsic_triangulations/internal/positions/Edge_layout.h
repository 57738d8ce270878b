// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// An intrinsic edge and the input edges that it crosses, laid out in the plane.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_EDGE_LAYOUT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_EDGE_LAYOUT_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/Unfolding.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// The source of the intrinsic edge lies at 0. The unit is the input halfedge that bounds the
// first input triangle on the right.
template <class Metric>
class Edge_layout
{
public:
  using Real = typename Metric::Real;
  using Vector = typename Metric::Vector;

  // An input edge that is crossed, from its end on the left to its end on the right.
  struct Crossed_edge
  {
    Halfedge_index halfedge;
    Vector left;
    Vector direction;
  };

  // \pre e crosses input edges
  Edge_layout(const Overlay& overlay, const Delta_complex& input, Metric& metric,
              const Unfolding<Metric>& unfolding, Edge_index e)
    : target_(metric.constant(0), metric.constant(0))
  {
    const auto crossings = overlay.intrinsic_crossings(e);
    CGAL_precondition(!crossings.empty());
    crossed_edges_.reserve(crossings.size());
    for (Overlay::Vertex x : crossings) {
      const Halfedge_index crossed = input.opposite(overlay.crossing_input_halfedge(x));
      if (crossed_edges_.empty()) {
        const auto ratios = unfolding.corner_ratios(base(input, crossed));
        // From the left corner to the right one: against the second side of the triangle.
        crossed_edges_.push_back({crossed, ratios.at_source, ratios.at_target});
        continue;
      }
      // Directions are products alone, and positions sums of such products: so errors add up
      // instead of doubling.
      const Crossed_edge& last = crossed_edges_.back();
      const auto ratios = unfolding.corner_ratios(last.halfedge);
      if (crossed == input.opposite(input.prev(last.halfedge)))
        crossed_edges_.push_back({crossed, last.left, last.direction * ratios.at_source});
      else
        crossed_edges_.push_back({crossed, last.left + last.direction * ratios.at_source,
                                  last.direction * ratios.at_target});
    }
    const Crossed_edge& last = crossed_edges_.back();
    target_ = last.left + last.direction * unfolding.corner_ratios(last.halfedge).at_source;
  }

  // The input halfedge out of the source, to the right of the edge, which is the unit.
  static Halfedge_index base(const Delta_complex& input, Halfedge_index first_crossed)
  {
    return input.prev(input.opposite(first_crossed));
  }

  const std::vector<Crossed_edge>& crossed_edges() const { return crossed_edges_; }
  const Vector& target() const { return target_; }

private:
  std::vector<Crossed_edge> crossed_edges_;
  Vector target_;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_EDGE_LAYOUT_H
