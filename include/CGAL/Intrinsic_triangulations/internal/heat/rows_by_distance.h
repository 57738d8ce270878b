// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Rows in the order of their distances.

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

// The nearest first; of equal ones, the smallest row. Distances are spread evenly enough over as many intervals as there
// are rows that hardly anything is left to sort. \pre none is negative or NaN
template <class Distances>
std::vector<std::uint32_t> rows_by_distance(const Distances& distances)
{
  const std::size_t n = std::size_t(distances.size());
  double largest = 0;
  for (const double d : distances)
    if (d < std::numeric_limits<double>::infinity())
      largest = (std::max)(largest, d);
  const auto interval = [&](double d) { return d < largest ? std::size_t(d / largest * double(n - 1)) : n - 1; };
  std::vector<std::uint32_t> result(n), first(n + 1, 0);
  for (const double d : distances)
    ++first[interval(d)];
  std::partial_sum(first.begin(), first.end(), first.begin());
  for (std::size_t row = n; row-- > 0;)
    result[--first[interval(distances[row])]] = std::uint32_t(row);
  const auto is_before = [&](std::uint32_t v, std::uint32_t w) {
    return distances[v] < distances[w] || (distances[v] == distances[w] && v < w);
  };
  for (std::size_t i = 0; i < n; ++i)
    if (first[i + 1] - first[i] > 1)
      std::sort(result.begin() + first[i], result.begin() + first[i + 1], is_before);
  return result;
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_ROWS_BY_DISTANCE_H
