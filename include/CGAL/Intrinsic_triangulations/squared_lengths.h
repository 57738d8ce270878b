// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Exact squared lengths: rational numbers, the metric that they define, and gluing files that have them.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SQUARED_LENGTHS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SQUARED_LENGTHS_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Rational.h>
#include <CGAL/Intrinsic_triangulations/Input_metric.h>

#include <iosfwd>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsMetric
/// \brief an exact rational number of Boost.Multiprecision, without expression templates.
using Rational = internal::Rational;

/// \ingroup PkgIntrinsicTriangulationsMetric
/// \brief an integer of any size, exact: Boost.Multiprecision's, without expression templates.
using Integer = internal::Integer;

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

/// \ingroup PkgIntrinsicTriangulationsMetric
/// \brief returns the exact squares of lengths that are doubles. O(size).
/// \param lengths the length of each edge
/// \exception Invalid_surface_error if a length is not positive and finite
std::vector<Rational> squared_lengths(const std::vector<double>& lengths);

/// \ingroup PkgIntrinsicTriangulationsIO
/// \brief the contents of a gluing file of either version: one of the two vectors is empty.
struct Exact_gluing
{
  Delta_complex complex;                 ///< the triangles
  std::vector<double> lengths;           ///< the length of each edge, in version 1 of the format
  std::vector<Rational> squared_lengths; ///< its square, in version 2
};

/// \ingroup PkgIntrinsicTriangulationsIO
/// \brief writes a complex and the exact squared lengths of its edges, in version 2 of the gluing format.
///
/// It differs from version 1, which `write_gluing()` describes, in two things: the first line is `INTRINSIC_GLUING 2`,
/// and the last field in the line of an edge is the *square* of its length, as an integer or a fraction of two without
/// a sign, such as `5` or `25/4`.
///
/// \param os the stream; the caller has to check its state afterwards
/// \param complex any complex
/// \param squared_lengths the squared length of each edge
/// \exception Invalid_surface_error if a squared length is not positive, or there are
///   more than a million isolated vertices. Then nothing is written. O(size).
/// \pre `squared_lengths.size() == complex.number_of_edges()`
void write_exact_gluing(std::ostream& os, const Delta_complex& complex, const std::vector<Rational>& squared_lengths);

/// \ingroup PkgIntrinsicTriangulationsIO
/// \brief reads a gluing of either version.
///
/// \exception Invalid_surface_error as `read_gluing()`; also if a squared length has more than a million digits.
///   O(size)
Exact_gluing read_exact_gluing(std::istream& is);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SQUARED_LENGTHS_H
