// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Rows about in the order of their distances.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_ROWS_BY_DISTANCE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_ROWS_BY_DISTANCE_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// The nearest first, by an eighth as many intervals of the same length as there are rows; of the same interval, the
// smallest row. \pre none is negative or NaN
template <class Distances>
std::vector<std::uint32_t> rows_by_distance(const Distances& distances)
{
  const std::size_t n = std::size_t(distances.size()), number_of_intervals = n / 8 + 1;
  double largest = 0;
  for (const double d : distances)
    if (d < std::numeric_limits<double>::infinity())
      largest = (std::max)(largest, d);
  std::vector<std::uint32_t> interval, first(number_of_intervals, 0), result(n);
  interval.reserve(n);
  for (const double d : distances) {
    interval.push_back(std::uint32_t((d < largest ? d / largest : 1) * double(number_of_intervals - 1)));
    ++first[interval.back()];
  }
  std::exclusive_scan(first.begin(), first.end(), first.begin(), std::uint32_t(0));
  for (std::size_t row = 0; row < n; ++row)
    result[first[interval[row]]++] = std::uint32_t(row);
  return result;
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_ROWS_BY_DISTANCE_H
