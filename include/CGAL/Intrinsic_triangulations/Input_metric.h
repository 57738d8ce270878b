// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The metric of the input surface, exactly as it was given.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INPUT_METRIC_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INPUT_METRIC_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Large_vector.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/With_error.h>

#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \cond SKIP_IN_MANUAL
namespace internal {
struct Rational_lengths;
}
/// \endcond

/// \ingroup PkgIntrinsicTriangulationsMetric
///
/// \brief the squared lengths of the input edges, as exact functions of the given
/// points with `double` coordinates, lengths, or rational squared lengths.
///
/// Coordinates and lengths are multiplied by a power of two, which is exact, if they are
/// so large or so small that products of squared lengths would over- or underflow. `squared_lengths.h` has the
/// functions that return rational numbers.
class Input_metric
{
public:
  /// the points of the vertices, three doubles each
  using Point_vector = Large_vector<std::array<double, 3>>;

  /// constructs the metric of an empty surface.
  Input_metric() = default;

  /// constructs the metric of a surface in space, from the points of its vertices.
  /// \exception Invalid_surface_error if a coordinate is not finite
  static Input_metric from_points(Point_vector points);
  /// \brief as above, but ignores the positions of isolated vertices of `input`: in the unit that
  /// `Intrinsic_triangulation` chooses.
  /// \exception Invalid_surface_error if a coordinate is not finite
  static Input_metric from_points(const Delta_complex& input, Point_vector points);
  /// constructs the metric from the length of each edge.
  /// \exception Invalid_surface_error if a length is not positive and finite
  static Input_metric from_lengths(std::vector<double> lengths);

  /// checks exactly that lengths are positive and satisfy the triangle inequality.
  /// \exception Invalid_surface_error if not
  void check(const Delta_complex& input) const;

  /// returns k such that one unit of this metric is `2^k` units of the input.
  int unit_exponent() const { return exponent_; }
  /// returns the points; empty unless the metric was constructed from points.
  const Point_vector& points() const { return points_; }

  /// returns the lengths; empty unless the metric was constructed from lengths.
  const std::vector<double>& lengths() const { return lengths_; }

  /// \cond SKIP_IN_MANUAL
  static Input_metric from_normalized_points(Point_vector points, int exponent)
  {
    Input_metric m;
    m.exponent_ = exponent;
    m.points_ = std::move(points);
    return m;
  }
  static Input_metric from_normalized_lengths(std::vector<double> lengths, int exponent)
  {
    Input_metric m;
    m.exponent_ = exponent;
    m.lengths_ = std::move(lengths);
    return m;
  }
  static Input_metric from_normalized_squared_lengths(std::shared_ptr<const internal::Rational_lengths> lengths,
                                                      int exponent)
  {
    Input_metric m;
    m.exponent_ = exponent;
    m.rational_lengths_ = std::move(lengths);
    return m;
  }

  // Null unless it was constructed from squared lengths.
  const internal::Rational_lengths* rational_lengths() const { return rational_lengths_.get(); }

  // A pseudorandom number that depends on the given data, for use as a seed.
  std::uint64_t hash() const;

  // A bound on the number of bits that numerators and denominators of squared lengths, and of the squares of four
  // times the areas, have.
  double largest_size() const;

  using Double_double = internal::Bounded_double_double;
  Double_double squared_length_double_double(const Delta_complex& input, Edge_index e) const;
  Double_double four_areas_double_double(const Delta_complex& input, Face_index f) const;
  // Whether a face has positive area, exactly.
  bool has_area(const Delta_complex& input, Face_index f) const;
  /// \endcond

private:
  int exponent_ = 0;
  Point_vector points_;
  std::vector<double> lengths_;
  std::shared_ptr<const internal::Rational_lengths> rational_lengths_;
};

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INPUT_METRIC_H
