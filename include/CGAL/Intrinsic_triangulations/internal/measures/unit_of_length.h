// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The power of two by which points or lengths are scaled, so that computations stay within the range of the number
// type.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_UNIT_OF_LENGTH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_UNIT_OF_LENGTH_H

#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Two_doubles.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/number_kinds.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/metric_defects.h>
#include <CGAL/Intrinsic_triangulations/internal/system/for_each_block.h>

#include <CGAL/Uncertain.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Products of two squared lengths occur, and differences of such products matter down to their rounding: lengths
// between 2^-(a tenth of the largest exponent) and 2^(the same) stay far from over- and underflow. If the largest
// length is outside of that range, it is scaled to its upper end, so that small lengths keep all their bits if they
// can.
template <class FT>
int unit_exponent(double largest)
{
  if constexpr (has_small_exponent_range<FT>) {
    const int limit = std::numeric_limits<typename Machine_type<FT>::type>::max_exponent / 10;
    const int exponent = largest > 0 ? std::ilogb(largest) + 1 : 0;
    return exponent > limit || exponent < -limit ? exponent - limit : 0;
  } else if constexpr (has_exact_roots<FT>) {
    constexpr int limit = 16;
    const int exponent = largest > 0 ? std::ilogb(largest) + 1 : 0;
    return exponent > limit || exponent < -limit ? exponent : 0;
  } else {
    return 0;
  }
}

template <class FT>
FT times_power_of_two(const FT& x, int exponent)
{
  if constexpr (Is_interval<FT>::value)
    return FT(std::ldexp(x.inf(), exponent), std::ldexp(x.sup(), exponent));
  else if constexpr (has_small_exponent_range<FT>) {
    using std::ldexp; // Boost's function is found by its argument
    return ldexp(x, exponent);
  } else if constexpr (has_exact_roots<FT>) {
    FT result = x;
    for (int rest = exponent; rest != 0;) {
      const int step = (std::max)(-1000, (std::min)(1000, rest));
      result = result * FT(std::ldexp(1., step));
      rest -= step;
    }
    return result;
  } else
    return x;
}

template <class FT>
double magnitude(const FT& x)
{
  if constexpr (is_machine_number<FT>)
    return std::abs(double(x));
  else {
    const std::pair<double, double> range = CGAL::to_interval(x);
    return (std::max)(std::abs(range.first), std::abs(range.second));
  }
}

// Multiplies by a power of two, and returns whether that was exact.
template <class FT>
bool scale(FT& x, int exponent)
{
  if constexpr (has_exact_roots<FT>) {
    // A `double` stays one if it can: exact numbers built in other ways are slower.
    const double rounded = CGAL::to_double(x), scaled = std::ldexp(rounded, exponent);
    if (std::ldexp(scaled, -exponent) == rounded && FT(rounded) == x)
      x = FT(scaled);
    else
      x = times_power_of_two(x, exponent);
    return true;
  }
  const FT scaled = times_power_of_two(x, exponent);
  const FT back = times_power_of_two(scaled, -exponent);
  bool is_exact;
  if constexpr (Is_interval<FT>::value)
    is_exact = back.is_same(x);
  else
    is_exact = back == x;
  x = scaled;
  return is_exact;
}

// Zero for finite numbers and NaN otherwise, without a branch. An exact number may be finite and still beyond double,
// where scaling cannot help either.
inline double zero_if_finite(double x) { return x - x; }

template <class PointVector>
Defect_tally non_finite_points(const PointVector& points)
{
  Defect_tally offenders;
  for (std::size_t v = 0; v < points.size(); ++v)
    if (!(zero_if_finite(CGAL::to_double(points[v][0])) + zero_if_finite(CGAL::to_double(points[v][1])) +
            zero_if_finite(CGAL::to_double(points[v][2])) ==
          0))
      offenders.add(v);
  return offenders;
}

// The smallest box around points.
struct Box
{
  void add(int i, double x)
  {
    low[i] = x < low[i] ? x : low[i];
    high[i] = x > high[i] ? x : high[i];
  }
  void add(const Box& other)
  {
    for (int i = 0; i < 3; ++i) {
      low[i] = (std::min)(low[i], other.low[i]);
      high[i] = (std::max)(high[i], other.high[i]);
    }
    zero += other.zero;
  }
  // Half of the largest extent, because the extent itself may overflow. Zero only if there is no extent: half of the
  // smallest number is not representable.
  double half_extent() const
  {
    double largest = 0;
    for (int i = 0; i < 3; ++i)
      if (high[i] > low[i])
        largest = (std::max)({largest, high[i] / 2 - low[i] / 2, 0x1p-1074});
    return largest;
  }
  // Whether a coordinate is constant, so that no length depends on it.
  bool is_flat(int i) const { return low[i] == high[i]; }

  static constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 3> low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};
  double zero = 0; // NaN if a coordinate is not finite
};

// Scales the coordinates of a vertex of a surface in the box, and returns whether that was exact. A constant coordinate
// that is large or tiny would leave the range of the number type, and is not needed.
template <class FT>
bool scale_point(std::array<FT, 3>& point, const Box& box, int exponent)
{
  bool is_exact = true;
  for (int i = 0; i < 3; ++i)
    // For a number type wider than double, the box has rounded coordinates.
    if (is_machine_number<FT> && sizeof(FT) <= sizeof(double) && box.is_flat(i))
      point[i] = FT(0);
    else
      is_exact &= scale(point[i], -exponent);
  return is_exact;
}

// The box of the used vertices, which must all be finite.
template <class ConcurrencyTag, class PointVector, class IsUsed>
Box bounding_box(const PointVector& points, const IsUsed& is_used)
{
  std::vector<Box> boxes(points.size() / elements_of_block + 1);
  for_each_block<ConcurrencyTag>(points.size(), elements_of_block, [&](std::size_t first, std::size_t last) {
    Two_doubles low(Box::infinity), high(-Box::infinity), low_z = low, high_z = high, zero(0.);
    for (std::size_t v = first; v < last; ++v) {
      const auto& p = points[v];
      const Two_doubles xy(CGAL::to_double(p[0]), CGAL::to_double(p[1])), z(CGAL::to_double(p[2]));
      zero = zero + (xy - xy) + (z - z);
      if (!is_used(v))
        continue;
      low = min_of(xy, low);
      high = max_of(xy, high);
      low_z = min_of(z, low_z);
      high_z = max_of(z, high_z);
    }
    boxes[first / elements_of_block] = {{low.first(), low.second(), low_z.first()},
                                        {high.first(), high.second(), high_z.first()},
                                        zero.first() + zero.second()};
  });
  Box result;
  for (const Box& box : boxes)
    result.add(box);
  return result;
}

// Chooses the unit by the used vertices. The others become zero if the unit differs from the input's, because they may
// not be representable in it.
template <class ConcurrencyTag = Sequential_tag, class PointVector, class IsUsed>
int normalize_points(PointVector& points, const IsUsed& is_used)
{
  using FT = typename PointVector::value_type::value_type;
  const Box box = bounding_box<ConcurrencyTag>(points, is_used);
  if (!(box.zero == 0))
    non_finite_points(points).refuse(Defect::NOT_FINITE, "vertex ", " has a coordinate that is not a finite number");
  const int exponent = unit_exponent<FT>(box.half_extent());
  if (exponent == 0)
    return 0;
  Defect_tally offenders;
  for (std::size_t v = 0; v < points.size(); ++v)
    if (!is_used(v))
      points[v] = {FT(0), FT(0), FT(0)};
    else if (!scale_point(points[v], box, exponent))
      offenders.add(v);
  offenders.refuse_underflow("a coordinate of vertex ", "; round it to zero, or remove the outliers");
  return exponent;
}

template <class PointVector>
int normalize_points(PointVector& points)
{
  return normalize_points(points, [](std::size_t) { return true; });
}

template <class FT>
int normalize_lengths(std::vector<FT>& lengths)
{
  double largest = 0;
  Defect_tally offenders;
  for (std::size_t e = 0; e < lengths.size(); ++e) {
    const double l = magnitude(lengths[e]);
    if (!(l < std::numeric_limits<double>::infinity()) || !certainly(lengths[e] > FT(0)))
      offenders.add(e);
    largest = l > largest ? l : largest;
  }
  offenders.refuse(Defect::NOT_FINITE, "the length of edge ", " is not a positive finite number");
  const int exponent = unit_exponent<FT>(largest);
  if (exponent == 0)
    return 0;
  for (std::size_t e = 0; e < lengths.size(); ++e)
    if (!scale(lengths[e], -exponent))
      offenders.add(e);
  offenders.refuse_underflow("the length of edge ");
  return exponent;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_UNIT_OF_LENGTH_H
