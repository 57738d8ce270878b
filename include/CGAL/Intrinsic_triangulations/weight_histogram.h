// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// How the coefficients of a Laplace-Beltrami operator are distributed.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_WEIGHT_HISTOGRAM_H
#define CGAL_INTRINSIC_TRIANGULATIONS_WEIGHT_HISTOGRAM_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsOperators
/// \brief the numbers of cotangent weights in intervals of equal width.
struct Weight_histogram
{
  double low = 0;                  ///< where the first interval begins
  double high = 0;                 ///< where the last interval ends
  std::vector<std::size_t> counts; ///< half-open intervals, from `low` to `high`
  std::size_t below = 0;           ///< weights less than `low`
  std::size_t above = 0;           ///< weights of at least `high`, infinite ones included
};

/// \ingroup PkgIntrinsicTriangulationsOperators
/// \brief counts the weights of interior edges. Those of border edges are single cotangents
/// and say nothing about the Delaunay property.
///
/// \param complex the triangles
/// \param weights `cot k + cot l` for each edge, as returned by `cotangent_weights()`; none is NaN
/// \param low, high the range of the intervals
/// \param number_of_intervals their number
/// \pre `low < high`, `number_of_intervals > 0`, and there is a weight for each edge. O(size).
/// Source: Fisher, Springborn, Schroeder, Bobenko (2006), figure 6.
inline Weight_histogram weight_histogram(const Delta_complex& complex,
                                         const std::vector<double>& weights, double low,
                                         double high, std::size_t number_of_intervals)
{
  CGAL_precondition(low < high && number_of_intervals > 0);
  CGAL_precondition(weights.size() == complex.number_of_edges());
  Weight_histogram histogram{low, high, std::vector<std::size_t>(number_of_intervals, 0)};
  for (Edge_index e : complex.edges()) {
    const double w = weights[e.idx()];
    if (complex.is_border(e))
      continue;
    if (w < low)
      ++histogram.below;
    else if (w >= high)
      ++histogram.above;
    else
      ++histogram.counts[(std::min)(
        std::size_t((w - low) / (high - low) * double(number_of_intervals)),
        number_of_intervals - 1)];
  }
  return histogram;
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_WEIGHT_HISTOGRAM_H
