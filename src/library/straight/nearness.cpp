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
#include <iterator>
#include <numeric>
#include <utility>

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

Box_tree::Box_tree(std::vector<Space_box> boxes) : boxes_(std::move(boxes)), order_(boxes_.size())
{
  std::iota(order_.begin(), order_.end(), 0u);
  if (!order_.empty())
    build(0, order_.begin(), order_.end());
}

void Box_tree::build(std::size_t node, Numbers::iterator begin, Numbers::iterator end)
{
  nodes_.resize((std::max)(nodes_.size(), node + 1));
  Space_box box = boxes_[*begin];
  std::for_each(begin, end, [&](std::uint32_t i) { box.add(boxes_[i]); });
  nodes_[node] = box;
  if (end - begin == 1)
    return;
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (box.high[i] - box.low[i] > box.high[axis] - box.low[axis])
      axis = i;
  const Numbers::iterator middle = begin + (end - begin) / 2;
  std::nth_element(begin, middle, end, [&](std::uint32_t i, std::uint32_t k) {
    return boxes_[i].low[axis] + boxes_[i].high[axis] < boxes_[k].low[axis] + boxes_[k].high[axis];
  });
  build(2 * node + 1, begin, middle);
  build(2 * node + 2, middle, end);
}

std::vector<std::uint32_t> Box_tree::near(const Space_box& box, double distance) const
{
  Numbers result;
  if (!order_.empty())
    collect(0, 0, order_.size(), box, distance, result);
  std::sort(result.begin(), result.end());
  return result;
}

void Box_tree::collect(std::size_t node, std::size_t begin, std::size_t end, const Space_box& box, double distance,
                       Numbers& result) const
{
  if (!box.is_near(nodes_[node], distance))
    return;
  if (end - begin == 1) {
    result.push_back(order_[begin]);
    return;
  }
  const std::size_t middle = begin + (end - begin) / 2;
  collect(2 * node + 1, begin, middle, box, distance, result);
  collect(2 * node + 2, middle, end, box, distance, result);
}

namespace {

using Numbers = std::vector<std::uint32_t>;

class Nearness
{
public:
  Nearness(const std::vector<Space_triangle>& triangles, const std::vector<Space_triangle>& others, double distance,
           std::vector<std::array<std::uint32_t, 2>>& pairs)
    : triangles_(triangles), others_(others), tree_({others.begin(), others.end()}), distance_(distance), pairs_(pairs),
      rest_((std::max)(std::size_t(1) << 16, 256 * (triangles.size() + others.size())))
  {}

  bool operator()()
  {
    for (std::uint32_t i = 0; i < triangles_.size(); ++i)
      if (!are_parts_near(i, triangles_[i], tree_.near(Space_box(triangles_[i]), distance_), deepest))
        return false;
    return true;
  }

private:
  static constexpr int deepest = 30;

  bool is_near(const std::array<double, 3>& p, std::uint32_t other) const
  {
    const Space_box& box = tree_.box(other);
    for (std::size_t i = 0; i < 3; ++i)
      if (p[i] < box.low[i] - distance_ || p[i] > box.high[i] + distance_)
        return false;
    Space_triangle seen = others_[other];
    for (auto& q : seen)
      for (std::size_t i = 0; i < 3; ++i)
        q[i] -= p[i];
    return nearest_to_origin(seen).second <= distance_ * distance_;
  }

  // The distance from a convex set is convex, so it is largest at a corner.
  bool are_parts_near(std::uint32_t number, const Space_triangle& triangle, const Numbers& candidates, int depth)
  {
    if (rest_-- == 0)
      return false;
    std::array<bool, 3> is_corner_near{};
    for (std::uint32_t other : candidates) {
      bool are_all = true;
      for (std::size_t i = 0; i < 3; ++i)
        if (are_all || !is_corner_near[i]) {
          const bool is_one = is_near(triangle[i], other);
          is_corner_near[i] = is_corner_near[i] || is_one;
          are_all = are_all && is_one;
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
    return are_parts_near(number, first, near(Space_box(first), candidates), depth - 1) &&
           are_parts_near(number, second, near(Space_box(second), candidates), depth - 1);
  }

  Numbers near(const Space_box& box, const Numbers& before) const
  {
    Numbers result;
    std::copy_if(before.begin(), before.end(), std::back_inserter(result),
                 [&](std::uint32_t i) { return box.is_near(tree_.box(i), distance_); });
    return result;
  }

  static double square_of_side(const Space_triangle& t, std::size_t k)
  {
    double sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      sum += (t[k][axis] - t[(k + 1) % 3][axis]) * (t[k][axis] - t[(k + 1) % 3][axis]);
    return sum;
  }

  const std::vector<Space_triangle>&triangles_, &others_;
  const Box_tree tree_; // of the others
  const double distance_;
  std::vector<std::array<std::uint32_t, 2>>& pairs_;
  std::size_t rest_; // of the parts
};

} // namespace

bool are_near(const std::vector<Space_triangle>& triangles, const std::vector<Space_triangle>& others, double distance,
              std::vector<std::array<std::uint32_t, 2>>& pairs)
{
  return Nearness(triangles, others, distance, pairs)();
}

} // namespace CGAL::Intrinsic_triangulations::internal
