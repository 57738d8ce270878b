// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of nearness.h.

#include "nearness.h"
#include "Straight_map.h"

#include <CGAL/Intrinsic_triangulations/Point_location.h>
#include <CGAL/Intrinsic_triangulations/internal/positions/affine_image.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
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

using Point = std::array<double, 3>;
using Part = std::vector<Point>; // a convex polygon in a triangle
using Numbers = std::vector<std::uint32_t>;

Space_box box_of(const Part& part)
{
  Space_box result(Space_triangle{part[0], part[1], part[2]});
  for (const Point& p : part)
    result.add(Space_box(Space_triangle{p, p, p}));
  return result;
}

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
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
      const Numbers candidates = tree_.near(Space_box(triangles_[i]), distance_);
      if (!is_part_near(i, {triangles_[i].begin(), triangles_[i].end()}, candidates, candidates, deepest))
        return false;
    }
    return true;
  }

private:
  static constexpr int deepest = 30;

  double squared_distance(const Point& p, std::uint32_t other) const
  {
    const Space_box& box = tree_.box(other);
    for (std::size_t i = 0; i < 3; ++i)
      if (p[i] < box.low[i] - distance_ || p[i] > box.high[i] + distance_)
        return std::numeric_limits<double>::infinity();
    Space_triangle seen = others_[other];
    for (auto& q : seen)
      for (std::size_t i = 0; i < 3; ++i)
        q[i] -= p[i];
    return nearest_to_origin(seen).second;
  }
  bool is_near(const Point& p, std::uint32_t other) const
  {
    return squared_distance(p, other) <= distance_ * distance_;
  }

  // A part that no single triangle is near to is divided along the sides of the one nearest to its middle, or at the
  // middle of its longest side if that divides nothing.
  // \param divisors the candidates that may still divide it
  bool is_part_near(std::uint32_t number, const Part& part, const Numbers& candidates, const Numbers& divisors,
                    int depth)
  {
    if (rest_-- == 0)
      return false;
    // The distance from a convex set is convex, so it is largest at a corner.
    std::vector<bool> is_corner_near(part.size());
    for (std::uint32_t other : candidates) {
      bool are_all = true;
      for (std::size_t i = 0; i < part.size(); ++i)
        if (are_all || !is_corner_near[i]) {
          const bool is_one = is_near(part[i], other);
          is_corner_near[i] = is_corner_near[i] || is_one;
          are_all = are_all && is_one;
        }
      if (are_all) {
        pairs_.push_back({number, other});
        return true;
      }
    }
    if (depth == 0 || std::count(is_corner_near.begin(), is_corner_near.end(), false) > 0)
      return false;
    Point middle{};
    for (const Point& p : part)
      for (std::size_t axis = 0; axis < 3; ++axis)
        middle[axis] += p[axis] / double(part.size());
    std::pair<double, std::uint32_t> nearest{distance_ * distance_, none};
    for (std::uint32_t other : divisors)
      nearest = (std::min)(nearest, {squared_distance(middle, other), other});
    const auto is_rest_near = [&](const Part& rest, const Numbers& left, int deeper) {
      return is_part_near(number, rest, near(rest, candidates), near(rest, left), deeper);
    };
    if (nearest.second == none)
      return bisect(part, [&](const Part& rest) { return is_rest_near(rest, divisors, depth - 1); });
    Numbers left = divisors;
    left.erase(std::find(left.begin(), left.end(), nearest.second));
    Part inside = part;
    const Space_triangle& divisor = others_[nearest.second];
    const Point normal = unit_normal_of(divisor);
    for (std::size_t i = 0; i < 3 && !inside.empty(); ++i) {
      const Point outward = cross_product(difference(divisor[(i + 1) % 3], divisor[i]), normal);
      Part outside = cut_off(inside, divisor[i], outward);
      if (!outside.empty() && !is_rest_near(outside, left, depth))
        return false;
    }
    return inside.empty() || is_rest_near(inside, left, depth);
  }

  // Cuts off what lies beyond a plane.
  static Part cut_off(Part& part, const Point& on_plane, const Point& outward)
  {
    std::vector<double> heights;
    for (const Point& p : part)
      heights.push_back(scalar_product(difference(p, on_plane), outward));
    if (std::all_of(heights.begin(), heights.end(), [](double x) { return x <= 0; }))
      return {};
    if (std::all_of(heights.begin(), heights.end(), [](double x) { return x >= 0; }))
      return std::exchange(part, {});
    Part inside, outside;
    for (std::size_t i = 0; i < part.size(); ++i) {
      const std::size_t next = (i + 1) % part.size();
      const double here = heights[i], there = heights[next];
      if (here <= 0)
        inside.push_back(part[i]);
      if (here >= 0)
        outside.push_back(part[i]);
      if ((here < 0 && there > 0) || (here > 0 && there < 0)) {
        inside.push_back(internal::between(part[i], part[next], here / (here - there)));
        outside.push_back(inside.back());
      }
    }
    part = inside;
    return outside;
  }

  template <class Is_near>
  static bool bisect(const Part& part, const Is_near& is_near)
  {
    const std::size_t n = part.size();
    std::size_t longest = 0;
    for (std::size_t i = 1; i < n; ++i)
      if (squared_distance_3(part[i], part[(i + 1) % n]) > squared_distance_3(part[longest], part[(longest + 1) % n]))
        longest = i;
    const auto corner = [&](std::size_t i) { return part[(longest + i) % n]; };
    const std::size_t opposite = (n + 1) / 2;
    const Point middle = internal::between(corner(0), corner(1), 0.5);
    Part first{middle}, second{middle};
    for (std::size_t i = 1; i <= opposite; ++i)
      first.push_back(corner(i));
    for (std::size_t i = opposite; i <= n; ++i)
      second.push_back(corner(i));
    return is_near(first) && is_near(second);
  }

  Numbers near(const Part& part, const Numbers& before) const
  {
    Numbers result;
    std::copy_if(before.begin(), before.end(), std::back_inserter(result),
                 [&, box = box_of(part)](std::uint32_t i) { return box.is_near(tree_.box(i), distance_); });
    return result;
  }

  static constexpr auto none = (std::numeric_limits<std::uint32_t>::max)();
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
