// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Strips laid out from points in space: fast, with one bound for the error of a strip.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_SPACE_FRAME_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_SPACE_FRAME_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Split_double_double.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Two_doubles.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/layout/Strip.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/Flat_geometry.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The frame (see `Strip`) in which most positions are found: overlays spend their time here. Corner ratios come
// straight from the points, and there is one bound for the error of all that is computed instead of one for each
// number. A ratio does not depend on those before: they are computed two at a time, and only one for each triangle,
// as each takes a root and a division. The unit is the first crossed edge.
//
// In double-doubles a corner ratio, divided by its absolute value, is good to 2^-97 whatever the
// shape of the triangle: scalar and cross product are good to 2^-101 of the product of the
// lengths. The direction of a crossed edge is a product of up to m ratios, m the number of
// triangles, and good to m 2^-96; so a position, a sum of directions of total length X, is good
// to m 2^-95 X, and a cross product of two positions, at most Y from the source, to m 2^-93 X Y.
// Positions on the edges are quotients of such cross products.
class Space_frame
{
  using Pair = Split_double_double<Two_doubles>;
  using Two_vectors = Split_vector<Two_doubles>;

public:
  using Vector = Split_complex;
  using Run = Strip_run<Vector>;

  // \param points of the input, none further from another than 4, or none at all
  Space_frame(const Delta_complex& input, const Points& points) : input_(&input), points_(&points) {}

  Strip_start<Vector> start(const Crossed_edges& crossed)
  {
    compute_ratios(crossed);
    number_of_triangles_ = crossed.size() + 1;
    // The first triangle is done: the run already begins with the unit.
    const Vector left = -ratios_[0], one(1, 0);
    distance_ = 0;
    extent_ = 1 + modulus(left);
    return {{crossed.front(), left, one, 1}, left + one};
  }

  std::false_type is_flat(Halfedge_index) const { return {}; }

  BOOST_FORCEINLINE void turn_left(Run& run, std::size_t i)
  {
    run.direction = i == 1 ? ratios_[1] : run.direction * ratios_[i];
    extent_ += modulus(run.direction);
  }

  BOOST_FORCEINLINE void turn_right(Run& run, std::size_t i, const Vector& right)
  {
    if (i == 0)
      return;
    turn_left(run, i);
    run.left = right - run.direction;
  }

  BOOST_FORCEINLINE void note(const Vector& corner) { distance_ = (std::max)(distance_, modulus(corner)); }
  void check_interruption() const {}

  // A bound on the error of an area between the source and two corners, one of which may be the target.
  double error(const Vector& target) const
  {
    return has_good_ratios_ ? 0x1p-93 * double(number_of_triangles_) * extent_ * (std::max)(distance_, modulus(target))
                            : std::numeric_limits<double>::infinity();
  }

private:
  // Two sides of a triangle, and on which side of the first the second is: 1 for left, -1 for right.
  struct Corner
  {
    Halfedge_index base, other;
    double side;
  };

  // In triangle i of the strip, between an edge that is crossed and what comes next: the direction
  // of the edge that is crossed then, or from its left end to the target. In the first one, the
  // direction from there back to the source.
  Corner corner(const Crossed_edges& crossed, std::size_t i) const
  {
    if (i == 0)
      return {crossed[0], input_->next(input_->opposite(crossed[0])), -1};
    const Halfedge_index base = crossed[i - 1];
    if (i == crossed.size())
      return {base, input_->opposite(input_->prev(base)), 1};
    return {base, crossed[i], crossed.turns_left(i) ? 1. : -1.};
  }

  // One for each triangle.
  void compute_ratios(const Crossed_edges& crossed)
  {
    const std::size_t n = crossed.size();
    if (ratios_.size() < n + 2)
      ratios_.resize(n + 2);
    Two_doubles shortest(1.);
    for (std::size_t i = 0; i <= n; i += 2) {
      const Corner a = corner(crossed, i), b = corner(crossed, (std::min)(i + 1, n));
      const Two_vectors v = vectors(a.base, b.base), w = vectors(a.other, b.other);
      shortest = min_of(shortest, min_of(rough_square(v), rough_square(w)));

      Pair square = split_squared_area(v, w);
      // A root of zero would be divided by; this one is far below the error.
      square.hi = max_of(square.hi, Two_doubles(1e-300));
      const Pair s = split_scalar_product(v, v);
      const Two_doubles reciprocal = Two_doubles(1.) / s.hi;
      const Pair x = quotient(split_scalar_product(v, w), s, reciprocal),
                 height = quotient(square_root(square), s, reciprocal);
      const Two_doubles side(a.side, b.side);
      const auto ratios = Split_complex::two_points(x, Pair(side * height.hi, side * height.lo));
      ratios_[i] = ratios[0];
      ratios_[i + 1] = ratios[1];
    }
    // Far from underflow; it has to be far for the error bound to hold.
    has_good_ratios_ = (std::min)(shortest.first(), shortest.second()) > 1e-100;
  }

  Two_vectors vectors(Halfedge_index g, Halfedge_index h) const
  {
    return two_split_vectors((*points_)[input_->source(g).idx()], (*points_)[input_->target(g).idx()],
                             (*points_)[input_->source(h).idx()], (*points_)[input_->target(h).idx()]);
  }

  const Delta_complex* input_;
  const Points* points_;
  std::vector<Split_complex> ratios_;
  bool has_good_ratios_ = false;
  std::size_t number_of_triangles_ = 0;
  double distance_ = 0; // no corner is further from the source
  double extent_ = 0;   // the sum of the lengths of what positions are made from
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_SPACE_FRAME_H
