// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The metric of the input in rational numbers.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INPUT_METRIC_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INPUT_METRIC_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Rational.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/metric/Input_metric.h>

#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsMetric
/// \brief an exact rational number of Boost.Multiprecision, without expression templates.
using Rational = internal::Rational;

/// \ingroup PkgIntrinsicTriangulationsMetric
/// \brief constructs a metric from the exact squared length of each edge, for instance between points with rational
/// coordinates. O(size).
/// \param squared_lengths the squared length of each edge, in their order
/// \exception Invalid_surface_error if a length leaves the range of `double`
Input_metric metric_from_squared_lengths(std::vector<Rational> squared_lengths);

/// \ingroup PkgIntrinsicTriangulationsMetric
/// \brief returns the squared length of an input edge exactly, in the unit of the metric. O(1).
/// \param metric, input the metric and the connectivity of the input
/// \param e an edge of the input
Rational squared_length(const Input_metric& metric, const Delta_complex& input, Edge_index e);

/// \ingroup PkgIntrinsicTriangulationsMetric
/// \brief returns the square of four times the area of an input face exactly, in the unit of the metric. O(1).
/// \param metric, input the metric and the connectivity of the input
/// \param f a face of the input
Rational squared_four_areas(const Input_metric& metric, const Delta_complex& input, Face_index f);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INPUT_METRIC_H
