// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of nearness.h.

#include "nearness.h"

#include <CGAL/Intrinsic_triangulations/Point_location.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <tuple>
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

Box_tree::Box_tree(std::vector<Space_box> boxes) : boxes_(std::move(boxes))
{
  std::vector<Numbered_box> numbered;
  for (std::uint32_t i = 0; i < boxes_.size(); ++i)
    numbered.emplace_back(enlarged(boxes_[i], 0), i);
  tree_ = {numbered.begin(), numbered.end()}; // packed
}

Box_tree::Box Box_tree::enlarged(const Space_box& box, double distance)
{
  const auto& [low, high] = std::tie(box.low, box.high);
  return {{low[0] - distance, low[1] - distance, low[2] - distance},
          {high[0] + distance, high[1] + distance, high[2] + distance}};
}

std::vector<std::uint32_t> Box_tree::near(const Space_box& box, double distance) const
{
  std::vector<std::uint32_t> result;
  tree_.query(boost::geometry::index::intersects(enlarged(box, distance)),
              boost::make_function_output_iterator([&](const Numbered_box& found) { result.push_back(found.second); }));
  std::sort(result.begin(), result.end());
  return result;
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
