// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Where an intrinsic edge in a flat part of the input crosses input edges.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_PLANE_STRIP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_PLANE_STRIP_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Split_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Split_double_double.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Two_doubles.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/Flat_geometry.h>
#include <CGAL/Intrinsic_triangulations/internal/positions/Strip_layout.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// As Point_strip, for a strip of triangles that lie in one plane, side by side. It need not be
// laid out: a projection along a coordinate is affine, so that quotients of areas are the same.
// The differences that are projected are exact.
class Plane_strip
{
public:
  // \param points of the input, none further from another than 4, or none at all
  Plane_strip(const Delta_complex& input, const Points& points) : input_(input), points_(points) {}

  // \param crossed the input edges that an edge crosses, in order, as halfedges from the left end
  //   to the right end
  // \param visit as `Strip_layout::finish()`, and so is the result
  template <class Visit>
  bool operator()(const std::vector<Halfedge_index>& crossed, const Visit& visit)
  {
    const Halfedge_index first = crossed.front();
    source_ = apex(input_.opposite(first));
    choose_projection(input_.source(first), input_.target(first));
    layout_.start(projected(input_.source(first)), projected(input_.target(first)));
    for (std::size_t i = 1; i < crossed.size(); ++i)
      layout_.add(projected(apex(crossed[i - 1])),
                  crossed[i] == input_.opposite(input_.prev(crossed[i - 1])));
    const Split_complex target = projected(apex(crossed.back()));
    const double distance = (std::max)(layout_.distance(), modulus(target));
    // A cross product is good to 2^-102 of the sum of the absolute values of two products. (It
    // is far from underflow where it is large enough to be used.)
    return distance > 1e-50 && layout_.finish(target, 0x1p-100 * distance * distance, visit);
  }

private:
  // The corner opposite to h.
  Vertex_index apex(Halfedge_index h) const { return input_.target(input_.next(h)); }

  // Along the coordinate in which the normal is longest, seen from the side from which the left
  // end is on the left. (With a normal that is rounded beyond recognition nothing is wrong:
  // the areas are too small then, or negative.)
  void choose_projection(Vertex_index left, Vertex_index right)
  {
    const auto n = cross_product(difference<double>(points_, source_, right),
                                 difference<double>(points_, source_, left));
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

  const Delta_complex& input_;
  const Points& points_;
  Vertex_index source_;
  std::size_t first_ = 0, second_ = 1; // the coordinates that are kept
  Strip_layout layout_;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_PLANE_STRIP_H
