// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of nearness.h.

#include "nearness.h"

#include <CGAL/Intrinsic_triangulations/Point_location.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>

namespace CGAL::Intrinsic_triangulations::internal {

Space_box::Space_box(const Space_triangle& triangle)
{
  for (std::size_t i = 0; i < 3; ++i) {
    low[i] = (std::min)({triangle[0][i], triangle[1][i], triangle[2][i]});
    high[i] = (std::max)({triangle[0][i], triangle[1][i], triangle[2][i]});
  }
}

bool Space_box::is_near(const Space_box& other, double distance) const
{
  for (std::size_t i = 0; i < 3; ++i)
    if (low[i] - distance > other.high[i] || high[i] + distance < other.low[i])
      return false;
  return true;
}

void Space_box::add(const Space_box& other)
{
  for (std::size_t i = 0; i < 3; ++i) {
    low[i] = (std::min)(low[i], other.low[i]);
    high[i] = (std::max)(high[i], other.high[i]);
  }
}

namespace {

class Nearness
{
public:
  using Numbers = std::vector<std::uint32_t>;

  Nearness(const std::vector<Space_triangle>& triangles, const std::vector<Space_triangle>& others, double distance,
           std::vector<std::array<std::uint32_t, 2>>& pairs)
    : triangles_(triangles), others_(others), own_boxes_(triangles.begin(), triangles.end()),
      boxes_(others.begin(), others.end()), distance_(distance), pairs_(pairs)
  {}

  // \param before those of the others that may be near
  bool are_near(Numbers::iterator begin, Numbers::iterator end, const Numbers& before)
  {
    Space_box box = own_boxes_[*begin];
    std::for_each(begin, end, [&](std::uint32_t i) { box.add(own_boxes_[i]); });
    const Numbers candidates = near(box, before);
    if (end - begin == 1)
      return is_near(*begin, triangles_[*begin], candidates, deepest);
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i)
      if (box.high[i] - box.low[i] > box.high[axis] - box.low[axis])
        axis = i;
    const Numbers::iterator middle = begin + (end - begin) / 2;
    std::nth_element(begin, middle, end, [&](std::uint32_t i, std::uint32_t k) {
      return own_boxes_[i].low[axis] + own_boxes_[i].high[axis] < own_boxes_[k].low[axis] + own_boxes_[k].high[axis];
    });
    return are_near(begin, middle, candidates) && are_near(middle, end, candidates);
  }

private:
  static constexpr int deepest = 30;

  Numbers near(const Space_box& box, const Numbers& before) const
  {
    Numbers result;
    std::copy_if(before.begin(), before.end(), std::back_inserter(result),
                 [&](std::uint32_t i) { return box.is_near(boxes_[i], distance_); });
    return result;
  }

  // The distance from a convex set is convex, so it is largest at a corner.
  bool is_near(std::uint32_t number, const Space_triangle& triangle, const Numbers& candidates, int depth)
  {
    if (--rest_ < 0)
      return false;
    std::array<bool, 3> is_corner_near{};
    for (std::uint32_t other : candidates) {
      bool are_all = true;
      for (std::size_t i = 0; i < 3; ++i) {
        const bool is_near = square_of_distance(triangle[i], others_[other]) <= distance_ * distance_;
        is_corner_near[i] = is_corner_near[i] || is_near;
        are_all = are_all && is_near;
      }
      if (are_all) {
        pairs_.push_back({number, other});
        return true;
      }
    }
    if (depth == 0 || !(is_corner_near[0] && is_corner_near[1] && is_corner_near[2]))
      return false;
    std::size_t i = 0; // the longest side is divided
    for (std::size_t k = 1; k < 3; ++k)
      if (square_of_side(triangle, k) > square_of_side(triangle, i))
        i = k;
    Space_triangle first = triangle, second = triangle;
    for (std::size_t axis = 0; axis < 3; ++axis)
      first[i][axis] = second[(i + 1) % 3][axis] = (triangle[i][axis] + triangle[(i + 1) % 3][axis]) / 2;
    return is_near(number, first, near(Space_box(first), candidates), depth - 1) &&
           is_near(number, second, near(Space_box(second), candidates), depth - 1);
  }

  static double square_of_side(const Space_triangle& t, std::size_t k)
  {
    double sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      sum += (t[k][axis] - t[(k + 1) % 3][axis]) * (t[k][axis] - t[(k + 1) % 3][axis]);
    return sum;
  }
  static double square_of_distance(const std::array<double, 3>& p, Space_triangle seen)
  {
    for (auto& q : seen)
      for (std::size_t i = 0; i < 3; ++i)
        q[i] -= p[i];
    return nearest_to_origin(seen).second;
  }

  const std::vector<Space_triangle>&triangles_, &others_;
  std::vector<Space_box> own_boxes_, boxes_;
  const double distance_;
  std::vector<std::array<std::uint32_t, 2>>& pairs_;
  int rest_ = 1 << 16; // of the parts
};

} // namespace

bool are_near(const std::vector<Space_triangle>& triangles, const std::vector<Space_triangle>& others, double distance,
              std::vector<std::array<std::uint32_t, 2>>& pairs)
{
  Nearness::Numbers own(triangles.size()), all(others.size());
  std::iota(own.begin(), own.end(), 0u);
  std::iota(all.begin(), all.end(), 0u);
  return own.empty() || Nearness(triangles, others, distance, pairs).are_near(own.begin(), own.end(), all);
}

} // namespace CGAL::Intrinsic_triangulations::internal
