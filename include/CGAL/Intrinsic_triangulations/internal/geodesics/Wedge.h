// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The angle between two halfedges around a vertex, and flips that make way around the vertex.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_WEDGE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_WEDGE_H

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Angle_sum.h>
#include <CGAL/Intrinsic_triangulations/internal/flips/Undoable_flips.h>

#include <CGAL/enum.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The corners from one halfedge counterclockwise around its source to another.
struct Wedge
{
  Halfedge_index first, last;
};

template <class Traits>
class Wedge_geometry
{
public:
  using Triangulation = Intrinsic_triangulation<Traits>;

  explicit Wedge_geometry(Triangulation& triangulation) : flips_(triangulation) {}

  // The changes made, which can be undone.
  Undoable_flips<Traits>& flips() { return flips_; }

  // An estimate of the angle if it is below π; nothing if the border lies in between.
  std::optional<double> angle_below_pi(const Wedge& wedge)
  {
    corners_.clear();
    for (Halfedge_index h = wedge.first; h != wedge.last; h = complex().next_around_source(h)) {
      if (complex().is_border(h))
        return std::nullopt;
      corners_.push_back({complex().next(h), {}});
    }
    return sum_below_pi();
  }

  // Flips edges inside of the wedge until its outer side is straight or turns toward the vertex everywhere. With an
  // angle below π, that side is then shorter than the two halfedges.
  // \param is_below_pi whether the angle is known to be below π
  // \param may_flip returns whether an edge may be flipped
  // \param goes_on is called before each attempt; if it returns `false`, the work ends
  // \param after_flip is called after each flip
  // \return whether that succeeded: not if an edge inside must not or cannot be flipped, or the work ended
  template <class May_flip, class Go_on, class After_flip>
  bool shorten(const Wedge& wedge, bool is_below_pi, const May_flip& may_flip, const Go_on& goes_on,
               const After_flip& after_flip)
  {
    // If edges are loops at this very vertex, a flip can bring new edges into the wedge.
    const auto is_loop = [this](Halfedge_index h) { return complex().source(h) == complex().target(h); };
    std::size_t rest = 64;
    bool is_doubtful = !is_below_pi || is_loop(wedge.last);
    for (Halfedge_index h = wedge.first; h != wedge.last; h = complex().next_around_source(h)) {
      rest += 4;
      is_doubtful = is_doubtful || is_loop(h);
    }
    for (Halfedge_index h = complex().next_around_source(wedge.first); h != wedge.last;) {
      const Edge_index e = complex().edge(h);
      if (!may_flip(e) || !goes_on())
        return false;
      Halfedge_index before = clockwise(h);
      if (before == wedge.first) // it is tested again unless it is a side
        before = Halfedge_index();
      const bool is_flippable = complex().is_flippable(e);
      if (is_flippable && flips_.flip(e)) {
        after_flip(e);
        if (rest-- == 0)
          return false;
        // The previous edge may have been this one, from its other end.
        h = before.is_valid() && complex().edge(before) != e ? before : complex().next_around_source(wedge.first);
        continue;
      }
      is_doubtful = is_doubtful || !is_flippable;
      h = complex().next_around_source(h);
    }
    // As the angle is below π, a nonconvex hinge is reflex at the far end of its edge; any other edge that is left is
    // an obstacle.
    for (Halfedge_index h = complex().next_around_source(wedge.first); is_doubtful && h != wedge.last;
         h = complex().next_around_source(h))
      if (is_end_below_pi(h))
        return false;
    return true;
  }

private:
  const Delta_complex& complex() const { return flips_.triangulation().connectivity(); }

  Halfedge_index clockwise(Halfedge_index h) const { return complex().next(complex().opposite(h)); }

  // Whether the angles at the target of h on both sides of it sum to less than π. \pre h is not on the border
  bool is_end_below_pi(Halfedge_index h)
  {
    corners_ = {{complex().prev(h), {}}, {complex().next(complex().opposite(h)), {}}};
    return sum_below_pi().has_value();
  }

  // The sum of the corners if it is below π: by stored numbers, by better ones, or exactly.
  std::optional<double> sum_below_pi()
  {
    Bounded_angle sum = estimate();
    // The corners with the largest errors are made accurate first; the others rarely need it.
    for (double largest_error : {0x1p-4, 0x1p-14, 0x1p-24, 0x1p-34, 0x1p-44}) {
      if (sum.is_below_pi() || sum.is_above_pi())
        break;
      bool is_better = false;
      for (const Estimated_corner& corner : corners_)
        if (!(corner.angle.error < largest_error))
          is_better = flips_.recompute(complex().face(corner.opposite)) || is_better;
      if (is_better)
        sum = estimate();
    }
    if (sum.is_below_pi() ||
        (!sum.is_above_pi() && compare_angle_sum_with_pi(engine(flips_.triangulation()), corners_) == SMALLER))
      return sum.value;
    return std::nullopt;
  }

  Bounded_angle estimate()
  {
    const auto squared = [&](Halfedge_index side) { return flips_.squared_length(complex().edge(side)); };
    Bounded_angle sum;
    for (Estimated_corner& corner : corners_) {
      if (sum.is_above_pi()) // the rest cannot change that
        break;
      const Halfedge_index h = corner.opposite;
      corner.angle =
        bounded_angle(twice_scalar_product(squared(complex().next(h)), squared(complex().prev(h)), squared(h)),
                      flips_.four_areas(complex().face(h)));
      sum += corner.angle;
    }
    return sum;
  }

  Undoable_flips<Traits> flips_;
  std::vector<Estimated_corner> corners_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_WEDGE_H
