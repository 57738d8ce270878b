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

using Numbers = std::vector<std::uint32_t>;

Numbers near(const Space_box& box, const std::vector<Space_box>& boxes, const Numbers& before, double distance)
{
  Numbers result;
  std::copy_if(before.begin(), before.end(), std::back_inserter(result),
               [&](std::uint32_t i) { return box.is_near(boxes[i], distance); });
  return result;
}

// Calls a function for each box with the others within a distance, until it returns false.
// \param before the others that may be near
template <class Visit>
bool visit_near(Numbers::iterator begin, Numbers::iterator end, const std::vector<Space_box>& boxes,
                const std::vector<Space_box>& others, const Numbers& before, double distance, const Visit& visit)
{
  Space_box box = boxes[*begin];
  std::for_each(begin, end, [&](std::uint32_t i) { box.add(boxes[i]); });
  const Numbers candidates = near(box, others, before, distance);
  if (end - begin == 1)
    return visit(*begin, candidates);
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (box.high[i] - box.low[i] > box.high[axis] - box.low[axis])
      axis = i;
  const Numbers::iterator middle = begin + (end - begin) / 2;
  std::nth_element(begin, middle, end, [&](std::uint32_t i, std::uint32_t k) {
    return boxes[i].low[axis] + boxes[i].high[axis] < boxes[k].low[axis] + boxes[k].high[axis];
  });
  return visit_near(begin, middle, boxes, others, candidates, distance, visit) &&
         visit_near(middle, end, boxes, others, candidates, distance, visit);
}

template <class Visit>
bool visit_near(const std::vector<Space_box>& boxes, const std::vector<Space_box>& others, double distance,
                const Visit& visit)
{
  Numbers own(boxes.size()), all(others.size());
  std::iota(own.begin(), own.end(), 0u);
  std::iota(all.begin(), all.end(), 0u);
  return own.empty() || visit_near(own.begin(), own.end(), boxes, others, all, distance, visit);
}

class Nearness
{
public:
  Nearness(const std::vector<Space_triangle>& triangles, const std::vector<Space_triangle>& others, double distance,
           std::vector<std::array<std::uint32_t, 2>>& pairs)
    : triangles_(triangles), others_(others), boxes_(others.begin(), others.end()), distance_(distance), pairs_(pairs)
  {}

  bool operator()()
  {
    return visit_near(
      {triangles_.begin(), triangles_.end()}, boxes_, distance_,
      [this](std::uint32_t i, const Numbers& candidates) { return is_near(i, triangles_[i], candidates, deepest); });
  }

private:
  static constexpr int deepest = 30;

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
    return is_near(number, first, near(Space_box(first), boxes_, candidates, distance_), depth - 1) &&
           is_near(number, second, near(Space_box(second), boxes_, candidates, distance_), depth - 1);
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
  const std::vector<Space_box> boxes_; // of the others
  const double distance_;
  std::vector<std::array<std::uint32_t, 2>>& pairs_;
  int rest_ = 1 << 16; // of the parts
};

} // namespace

std::vector<std::vector<std::uint32_t>> near_boxes(const std::vector<Space_box>& boxes,
                                                   const std::vector<Space_box>& others, double distance)
{
  std::vector<std::vector<std::uint32_t>> result(boxes.size());
  visit_near(boxes, others, distance, [&](std::uint32_t i, const Numbers& candidates) {
    result[i] = candidates;
    return true;
  });
  return result;
}

bool are_near(const std::vector<Space_triangle>& triangles, const std::vector<Space_triangle>& others, double distance,
              std::vector<std::array<std::uint32_t, 2>>& pairs)
{
  return Nearness(triangles, others, distance, pairs)();
}

} // namespace CGAL::Intrinsic_triangulations::internal
