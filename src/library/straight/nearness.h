// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Whether triangles in space lie near others.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_STRAIGHT_NEARNESS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_STRAIGHT_NEARNESS_H

#include <boost/geometry/algorithms/intersects.hpp> // the tree needs it with Boost 1.83
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

using Space_triangle = std::array<std::array<double, 3>, 3>;

struct Space_box
{
  Space_box() = default;
  explicit Space_box(const Space_triangle& triangle);
  bool is_near(const Space_box& other, double distance) const;
  void add(const Space_box& other);

  std::array<double, 3> low{}, high{};
};

// Finds boxes near others.
class Box_tree
{
public:
  explicit Box_tree(std::vector<Space_box> boxes);
  // Their numbers in order. Complexity: O(log n) and for each of the result, usually.
  std::vector<std::uint32_t> near(const Space_box& box, double distance) const;
  const Space_box& box(std::uint32_t number) const { return boxes_[number]; }

private:
  using Box = boost::geometry::model::box<boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>>;
  using Numbered_box = std::pair<Box, std::uint32_t>;

  static Box enlarged(const Space_box& box, double distance);

  std::vector<Space_box> boxes_;
  boost::geometry::index::rtree<Numbered_box, boost::geometry::index::quadratic<16>> tree_;
};

// Whether each point of the triangles is within a distance of one of the others. For this, triangles are divided, down
// to points; the answer is also "no" where too many parts would be needed. Everything is rounded: callers give a little
// less than the distance that they prove.
// \param pairs receives pairs of a triangle and another one, by their numbers, that suffice to show it
bool are_near(const std::vector<Space_triangle>& triangles, const std::vector<Space_triangle>& others, double distance,
              std::vector<std::array<std::uint32_t, 2>>& pairs);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_STRAIGHT_NEARNESS_H
