// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definition of crossing_triangles().

#include "crossing_triangles.h"
#include "nearness.h"

#include <CGAL/Intrinsic_triangulations/internal/connectivity/Delta_complex_builder.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Intersections_3/Segment_3_Triangle_3.h>
#include <CGAL/Intersections_3/Triangle_3_Triangle_3.h>

#include <algorithm>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

using Crossing_kernel = Exact_predicates_inexact_constructions_kernel;

class Crossing_test
{
public:
  explicit Crossing_test(const std::vector<std::array<double, 3>>& points)
  {
    points_.reserve(points.size());
    for (const auto& [x, y, z] : points)
      points_.emplace_back(x, y, z);
  }

  bool has_area(const Index_triangle& t) const { return !collinear(points_[t[0]], points_[t[1]], points_[t[2]]); }

  bool operator()(Index_triangle s, Index_triangle t) const
  {
    // Common corners come first.
    const auto is_common = [](const Index_triangle& other) {
      return [&other](std::uint32_t v) { return std::count(other.begin(), other.end(), v) != 0; };
    };
    const Index_triangle all = s;
    const auto end = std::stable_partition(s.begin(), s.end(), is_common(t));
    std::stable_partition(t.begin(), t.end(), is_common(all));
    switch (end - s.begin()) {
    case 0:
      return do_intersect(triangle(s), triangle(t));
    case 1:
      return do_intersect(Crossing_kernel::Segment_3(points_[s[1]], points_[s[2]]), triangle(t)) ||
             do_intersect(Crossing_kernel::Segment_3(points_[t[1]], points_[t[2]]), triangle(s));
    case 2: {
      const Crossing_kernel::Point_3 &p = points_[s[0]], &q = points_[s[1]], &a = points_[s[2]], &b = points_[t[2]];
      return coplanar(p, q, a, b) && coplanar_orientation(p, q, a, b) == POSITIVE;
    }
    default:
      return false;
    }
  }

private:
  Crossing_kernel::Triangle_3 triangle(const Index_triangle& t) const
  {
    return {points_[t[0]], points_[t[1]], points_[t[2]]};
  }

  std::vector<Crossing_kernel::Point_3> points_;
};

} // namespace

std::vector<std::array<std::uint32_t, 2>> crossing_triangles(const std::vector<std::array<double, 3>>& points,
                                                             const std::vector<Index_triangle>& triangles,
                                                             const std::function<void()>& go_on)
{
  const Crossing_test cross(points);
  std::vector<std::uint32_t> with_area;
  std::vector<Space_box> boxes;
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    if (cross.has_area(triangles[t])) {
      const auto& [u, v, w] = triangles[t];
      with_area.push_back(t);
      boxes.emplace_back(Space_triangle{points[u], points[v], points[w]});
    }
  std::vector<std::array<std::uint32_t, 2>> result;
  const std::vector<std::vector<std::uint32_t>> near = near_boxes(boxes, boxes, 0);
  for (std::uint32_t i = 0; i < near.size(); ++i) {
    go_on();
    for (std::uint32_t k : near[i])
      if (k > i && cross(triangles[with_area[i]], triangles[with_area[k]]))
        result.push_back({with_area[i], with_area[k]});
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal
