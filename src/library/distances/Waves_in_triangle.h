// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The waves that may be the lowest somewhere in a triangle.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_WAVES_IN_TRIANGLE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_WAVES_IN_TRIANGLE_H

#include "wave_functions.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// A wave at the corners of a triangle. It is convex: nowhere above the linear function with these values, and below it
// by three times as much as in the middle at most, because the middle divides the way from any point through it to the
// boundary at two thirds or earlier.
struct Wave_in_triangle
{
  const Wave* wave;
  std::array<double, 3> values;
  double dip;

  double lowest() const { return *std::min_element(values.begin(), values.end()) - dip; }
  double highest() const { return *std::max_element(values.begin(), values.end()); }
  // Whether it is nowhere lower than another one by more than a tolerance.
  bool is_above(const Wave_in_triangle& other, double tolerance) const
  {
    for (std::size_t i = 0; i < 3; ++i)
      if (values[i] - other.values[i] < dip - tolerance)
        return false;
    return true;
  }
};

class Waves_in_triangle
{
  static constexpr double infinity = std::numeric_limits<double>::infinity();

public:
  using Sources = std::array<std::uint32_t, 3>; // perhaps with repetitions
  static constexpr std::uint32_t any_source = (std::numeric_limits<std::uint32_t>::max)();

  // \param a, b, c the corners
  // \param margin by how much higher waves are kept
  Waves_in_triangle(const std::vector<const Wave*>& waves, const plane::Vector& a, const plane::Vector& b,
                    const plane::Vector& c, double margin)
  {
    const plane::Vector middle{(a[0] + b[0] + c[0]) / 3, (a[1] + b[1] + c[1]) / 3};
    double highest = infinity;
    for (const Wave* wave : waves) {
      Wave_in_triangle w{wave, {distance(*wave, a), distance(*wave, b), distance(*wave, c)}, 0};
      w.dip = (std::max)(0., w.values[0] + w.values[1] + w.values[2] - 3 * distance(*wave, middle));
      highest = (std::min)(highest, w.highest());
      waves_.push_back(w);
    }
    waves_.erase(std::remove_if(waves_.begin(), waves_.end(),
                                [&](const Wave_in_triangle& w) { return w.lowest() > highest + margin; }),
                 waves_.end());
  }

  auto begin() const { return waves_.begin(); }
  auto end() const { return waves_.end(); }

  // Bounds on the lowest wave.
  std::pair<double, double> range() const
  {
    std::pair<double, double> result{infinity, infinity};
    for (const Wave_in_triangle& w : waves_)
      result = {(std::min)(result.first, w.lowest()), (std::min)(result.second, w.highest())};
    return result;
  }

  bool has_source_beside(const Sources& sources) const
  {
    return std::any_of(waves_.begin(), waves_.end(),
                       [&](const Wave_in_triangle& w) { return !contains(sources, w.wave->source); });
  }
  bool is_other_nearer(const plane::Vector& p, const Sources& sources) const
  {
    double own = infinity, other = infinity;
    for (const Wave_in_triangle& w : waves_) {
      double& least = contains(sources, w.wave->source) ? own : other;
      least = (std::min)(least, distance(*w.wave, p));
    }
    return other < own * (1 - 1e-12);
  }

  // The distance of a point from a source, or from any.
  double nearest(const plane::Vector& p, std::uint32_t source) const
  {
    double result = infinity;
    for (const Wave_in_triangle& w : waves_)
      if (source == any_source || w.wave->source == source)
        result = (std::min)(result, distance(*w.wave, p));
    return result;
  }

  // Whether the distance from a source, or from all, is nowhere above a linear function, that of the lowest wave, and
  // below it by a tolerance at most. So it differs no more along a chord with equal distances at both ends.
  bool is_nearly_linear(std::uint32_t source, double tolerance) const
  {
    const Wave_in_triangle* lowest = nullptr;
    const auto sum = [](const Wave_in_triangle& w) { return w.values[0] + w.values[1] + w.values[2]; };
    const auto is_other = [&](const Wave_in_triangle& w) { return source != any_source && w.wave->source != source; };
    for (const Wave_in_triangle& w : waves_)
      if (!is_other(w) && (lowest == nullptr || sum(w) < sum(*lowest)))
        lowest = &w;
    return lowest != nullptr && lowest->dip <= tolerance &&
           std::all_of(waves_.begin(), waves_.end(),
                       [&](const Wave_in_triangle& w) { return is_other(w) || w.is_above(*lowest, tolerance); });
  }

private:
  static bool contains(const Sources& sources, std::uint32_t source)
  {
    return std::find(sources.begin(), sources.end(), source) != sources.end();
  }

  std::vector<Wave_in_triangle> waves_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_WAVES_IN_TRIANGLE_H
