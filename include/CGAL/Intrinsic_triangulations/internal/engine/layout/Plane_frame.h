// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Strips in a flat part of the input, projected.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_PLANE_FRAME_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_PLANE_FRAME_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Split_double_double.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Two_doubles.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/layout/Strip.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/Flat_geometry.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

// The frame (see `Strip`) for triangles that lie in one plane, side by side. Nothing is turned: a projection along
// a coordinate is affine, so that quotients of areas are the same, and the differences that are projected are exact.
class Plane_frame
{
public:
  using Vector = Split_complex;
  using Run = Strip_run<Vector>;

  // \param points of the input, none further from another than 4, or none at all
  Plane_frame(const Delta_complex& input, const Points& points) : input_(&input), points_(&points) {}

  Strip_start<Vector> start(const Crossed_edges& crossed)
  {
    const Halfedge_index first = crossed.front();
    source_ = apex(*input_, input_->opposite(first));
    choose_projection(input_->source(first), input_->target(first));
    distance_ = 0;
    const Vector right = projected(input_->target(first));
    return {{first, Vector(0, 0), right, 1}, right};
  }

  std::true_type is_flat(Halfedge_index) const { return {}; }
  Vector position(const Run&, Vertex_index v) const { return projected(v); }

  void note(const Vector& corner) { distance_ = (std::max)(distance_, modulus(corner)); }
  void check_interruption() const {}

  // A bound on the error of an area between the source and two corners, one of which may be the target. A cross
  // product is good to 2^-102 of the sum of the absolute values of two products. (It is far from underflow where it is
  // large enough to be used.)
  double error(const Vector& target) const
  {
    const double distance = (std::max)(distance_, modulus(target));
    return distance > 1e-50 ? 0x1p-100 * distance * distance : std::numeric_limits<double>::infinity();
  }

private:
  // Along the coordinate in which the normal is longest, seen from the side from which the left
  // end is on the left. (With a normal that is rounded beyond recognition nothing is wrong:
  // the areas are too small then, or negative.)
  void choose_projection(Vertex_index left, Vertex_index right)
  {
    const auto n =
      cross_product(difference<double>(*points_, source_, right), difference<double>(*points_, source_, left));
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
    const std::array<double, 3>&p = (*points_)[source_.idx()], &q = (*points_)[v.idx()];
    return Split_double_double<Two_doubles>::difference({q[first_], q[second_]}, {p[first_], p[second_]});
  }

  const Delta_complex* input_;
  const Points* points_;
  Vertex_index source_;
  std::size_t first_ = 0, second_ = 1; // the coordinates that are kept
  double distance_ = 0;                // no corner is further from the source
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_PLANE_FRAME_H
