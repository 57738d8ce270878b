// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Strips laid out from points in space: fast, with one bound for the error of a strip.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_POINT_FRAMES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_POINT_FRAMES_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include "../../arithmetic/Split_double_double.h"
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Two_doubles.h>
#include "Strip.h"
#include "../../measures/Flat_geometry.h"

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The common part of frames (see `Strip`) that compute with points, and with one error bound for everything instead of
// one for each number.
class Point_frame
{
public:
  using Vector = Split_complex;
  using Run = Strip_run<Vector>;

  // \param points of the input, at most 4 apart, or none at all
  Point_frame(const Delta_complex& input, const Points& points) : input_(input), points_(points) {}

  BOOST_FORCEINLINE void note(const Vector& corner) { distance_ = distance_with(corner); }
  void check_interruption() const {}

protected:
  double distance_with(const Vector& target) const { return (std::max)(distance_, modulus(target)); }

  const Delta_complex& input_;
  const Points& points_;
  double distance_ = 0; // no corner is further from the source
};

// The frame (see `Strip`) in which most positions are found: overlays spend their time here. Corner ratios come
// straight from the points, and there is one error bound for everything instead of one for each number. Ratios are
// independent of each other: they are computed two at a time, and only one for each triangle, because each takes a root
// and a division. The unit is the first crossed edge.
//
// In double-doubles a corner ratio, divided by its absolute value, has an error of at most 2^-97 for any shape of the
// triangle: the errors of scalar and cross product are at most 2^-101 times the product of the lengths. The direction
// of a crossed edge is a product of up to m ratios, m the number of triangles, with an error of at most m 2^-96; so the
// error of a position, a sum of directions of total length X, is at most m 2^-95 X, and that of a cross product of two
// positions, at most Y from the source, m 2^-93 X Y. Positions on the edges are quotients of such cross products.
class Space_frame : public Point_frame
{
  using Pair = Split_double_double<Two_doubles>;
  using Two_vectors = Split_vector<Two_doubles>;

public:
  using Point_frame::Point_frame;

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

  // A bound on the error of an area between the source and two corners, one of which may be the target.
  double error(const Vector& target) const
  {
    return has_good_ratios_ ? 0x1p-93 * double(number_of_triangles_) * extent_ * distance_with(target)
                            : std::numeric_limits<double>::infinity();
  }

private:
  // Two sides of a triangle, and on which side of the first the second is: 1 for left, -1 for right.
  struct Corner
  {
    Halfedge_index base, other;
    double side;
  };

  // In triangle i of the strip, after a crossed edge: the direction of the next crossed edge, or from its left end to
  // the target. In the first one, the direction from there back to the source.
  Corner corner(const Crossed_edges& crossed, std::size_t i) const
  {
    if (i == 0)
      return {crossed[0], input_.next(input_.opposite(crossed[0])), -1};
    const Halfedge_index base = crossed[i - 1];
    if (i == crossed.size())
      return {base, input_.opposite(input_.prev(base)), 1};
    return {base, crossed[i], keeps_left_end(input_, base, crossed[i]) ? 1. : -1.};
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
      // Avoids a division by a zero root; this one is far below the error.
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
    // Far from underflow, as the error bound requires.
    has_good_ratios_ = (std::min)(shortest.first(), shortest.second()) > 1e-100;
  }

  Two_vectors vectors(Halfedge_index g, Halfedge_index h) const
  {
    return two_split_vectors(points_[input_.source(g).idx()], points_[input_.target(g).idx()],
                             points_[input_.source(h).idx()], points_[input_.target(h).idx()]);
  }

  std::vector<Split_complex> ratios_;
  bool has_good_ratios_ = false;
  std::size_t number_of_triangles_ = 0;
  double extent_ = 0; // the sum of the lengths of the vectors that positions are made from
};

// The frame (see `Strip`) for triangles that lie in one plane, side by side. Nothing is rotated: a projection along a
// coordinate is affine, so quotients of areas stay the same, and the projected differences are exact.
class Plane_frame : public Point_frame
{
public:
  using Point_frame::Point_frame;

  Strip_start<Vector> start(const Crossed_edges& crossed)
  {
    const Halfedge_index first = crossed.front();
    source_ = apex(input_, input_.opposite(first));
    choose_projection(input_.source(first), input_.target(first));
    distance_ = 0;
    const Vector right = projected(input_.target(first));
    return {{first, Vector(0, 0), right, 1}, right};
  }

  std::true_type is_flat(Halfedge_index) const { return {}; }
  Vector position(const Run&, Vertex_index v) const { return projected(v); }

  // A bound on the error of an area between the source and two corners, one of which may be the target. A cross product
  // is good to 2^-102 of the sum of the absolute values of two products. (It is far from underflow if it is large
  // enough to be used.)
  double error(const Vector& target) const
  {
    const double distance = distance_with(target);
    return distance > 1e-50 ? 0x1p-100 * distance * distance : std::numeric_limits<double>::infinity();
  }

private:
  // Along the coordinate in which the normal is longest, seen from the side from which the left end is on the left. (A
  // normal that is rounded beyond recognition does no harm: the areas are then too small, or negative.)
  void choose_projection(Vertex_index left, Vertex_index right)
  {
    const auto n =
      cross_product(difference<double>(points_, source_, right), difference<double>(points_, source_, left));
    std::size_t c = 0;
    for (std::size_t i : {1, 2})
      if (std::abs(n[i]) > std::abs(n[c]))
        c = i;
    first_ = (c + 1) % 3;
    second_ = (c + 2) % 3;
    if (n[c] < 0)
      std::swap(first_, second_);
  }

  Split_complex projected(Vertex_index v) const
  {
    const std::array<double, 3>&p = points_[source_.idx()], &q = points_[v.idx()];
    return Split_double_double<Two_doubles>::difference({q[first_], q[second_]}, {p[first_], p[second_]});
  }

  Vertex_index source_;
  std::size_t first_ = 0, second_ = 1; // the coordinates that are kept
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_POINT_FRAMES_H
