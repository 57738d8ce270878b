// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A lower bound in float for the cotangent of a corner, by which most edges are known to be
// Delaunay without a look at their hinges.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COTANGENT_BOUND_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COTANGENT_BOUND_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/Large_vector.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// Bounds every number that differs from p / a by at most 2^-23 (1 + |p / a|), so also what
// other roundings make of p / a. With c = p / a as it is computed here, the bound is
// c - 2^-22 (1 + |c|), and of the difference of 2^-23 (1 + |c|) the rounding to float takes at
// most 2^-24 |c|, the operations in double a few 2^-53 (1 + |c|). An area of zero gives a NaN,
// whose sums are not greater than zero.
inline float cotangent_bound(double p, double a)
{
  const double c = p * (1 / a); // where three corners of a face are bounded, one division
  return float(c - 0x1p-22 * (1 + std::abs(c)));
}

// Whether traits bound cotangents.
template <class Traits, class = void>
struct Has_cotangent_bound : std::false_type {};
template <class Traits>
struct Has_cotangent_bound<Traits, std::void_t<typename Traits::Compute_cotangent_bound>>
  : std::true_type {};

// The bounds of all corners, each at the halfedge opposite to it. Border halfedges have minus
// infinity, so that nothing is said of their edges.
class Cotangent_bounds
{
public:
  Cotangent_bounds() = default;
  explicit Cotangent_bounds(const Delta_complex& complex)
    : bounds_(complex.number_of_halfedges(), default_init)
  {
    if (3 * std::size_t(complex.number_of_faces()) != complex.number_of_halfedges())
      std::fill(bounds_.begin(), bounds_.end(), -std::numeric_limits<float>::infinity());
  }

  float& operator[](Halfedge_index h) { return bounds_[h.idx()]; }

  // The sign of a sum of two floats is right, whatever its rounding.
  bool imply_Delaunay(Edge_index e) const
  {
    return bounds_[2 * std::size_t(e.idx())] + bounds_[2 * std::size_t(e.idx()) + 1] > 0;
  }

private:
  Large_vector<float> bounds_;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COTANGENT_BOUND_H
