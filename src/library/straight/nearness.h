// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Whether triangles in space lie near others.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_STRAIGHT_NEARNESS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_STRAIGHT_NEARNESS_H

#include <array>
#include <cstddef>
#include <cstdint>
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
  using Numbers = std::vector<std::uint32_t>;

  void build(std::size_t node, Numbers::iterator begin, Numbers::iterator end);
  void collect(std::size_t node, std::size_t begin, std::size_t end, const Space_box& box, double distance,
               Numbers& result) const;

  std::vector<Space_box> boxes_;
  Numbers order_;                // halves of it are the children of a node, down to single boxes
  std::vector<Space_box> nodes_; // the children of the k-th one are 2k + 1 and 2k + 2
};

// Whether each point of the triangles is within a distance of one of the others. For this, triangles are divided, down
// to points; the answer is also "no" where too many parts would be needed. Everything is rounded: callers give a little
// less than the distance that they prove.
// \param pairs receives pairs of a triangle and another one, by their numbers, that suffice to show it
bool are_near(const std::vector<Space_triangle>& triangles, const std::vector<Space_triangle>& others, double distance,
              std::vector<std::array<std::uint32_t, 2>>& pairs);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_STRAIGHT_NEARNESS_H
