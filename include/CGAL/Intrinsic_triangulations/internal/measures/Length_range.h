// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The extreme lengths of a surface, and whether the square of the smallest vanishes beside its size.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_LENGTH_RANGE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_LENGTH_RANGE_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Intrinsic_triangulations::internal {

// For each added edge, only the largest difference of a coordinate is used: it is within a factor of sqrt(3) of the
// length.
class Length_range
{
public:
  // Returns whether the points differ; edges of zero length are ignored.
  bool add(const std::array<double, 3>& p, const std::array<double, 3>& q, const std::size_t edge)
  {
    if (p == q)
      return false;
    const double length = (std::max)({std::abs(p[0] - q[0]), std::abs(p[1] - q[1]), std::abs(p[2] - q[2])});
    if (!(longest_ >= length)) {
      longest_ = length;
      longest_edge_ = edge;
    }
    if (!(shortest_ <= length)) {
      shortest_ = length;
      shortest_edge_ = edge;
    }
    return true;
  }

  bool is_empty() const { return !(longest_ > 0); }
  double longest() const { return longest_; }
  double shortest() const { return shortest_; }
  std::size_t longest_edge() const { return longest_edge_; }
  std::size_t shortest_edge() const { return shortest_edge_; }

  // The smallest e such that the length is below 2^e.
  int exponent_of_longest() const { return exponent(longest_); }
  int exponent_of_shortest() const { return exponent(shortest_); }

  // Whether the shortest squared length is zero once lengths are divided by 2^e, as the constructors of triangulations
  // do. The largest component of a difference suffices: if its square vanishes, so do the others.
  bool vanishes_in_unit(int e) const
  {
    const double length = std::ldexp(shortest_, -e);
    return length * length == 0;
  }

private:
  // A difference that overflows is less than 2 * 2^1024.
  static int exponent(const double length) { return std::isinf(length) ? 1025 : std::ilogb(length) + 1; }

  double longest_ = -1;
  double shortest_ = std::numeric_limits<double>::quiet_NaN();
  std::size_t longest_edge_ = 0;
  std::size_t shortest_edge_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_LENGTH_RANGE_H
