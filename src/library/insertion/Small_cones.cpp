// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Keeping new vertices away from vertices with a small sum of angles.

#include <CGAL/Intrinsic_triangulations/internal/insertion/Small_cones.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

std::vector<Vertex_index> Small_cones::vertices() const
{
  std::vector<Vertex_index> result;
  for (const auto& cone : cones_)
    result.push_back(cone.first);
  std::sort(result.begin(), result.end());
  return result;
}

double Small_cones::radius_of_input_faces(Vertex_index v) const
{
  double radius = (std::numeric_limits<double>::infinity)();
  for (Halfedge_index h : Halfedges_around(input_, v)) {
    const double height = shapes_.four_areas(input_.face(h)) / (2 * shapes_.length(input_.edge(input_.prev(h))));
    radius = (std::min)(radius, std::ldexp(height, unit_exponent_));
  }
  return radius;
}

void Small_cones::protect(Vertex_index v, double distance)
{
  Cone& cone = cones_.at(v);
  constexpr double for_rounding = 1 + 1e-9;
  cone.radius = distance / std::cos(cone.angle / 2) * for_rounding;
}

bool Small_cones::is_too_close(const Surface_point& point) const
{
  if (cones_.empty())
    return false;
  std::array<double, 3> w = point.coordinates;
  Halfedge_index h = point.halfedge;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto cone = cones_.find(input_.source(h));
    if (cone != cones_.end()) {
      const double distance = std::abs(w[1] + w[2] * shapes_.apex(h)) * shapes_.length(input_.edge(h));
      if (std::ldexp(distance, unit_exponent_) < cone->second.radius)
        return true;
    }
    h = input_.next(h);
    std::rotate(w.begin(), w.begin() + 1, w.end());
  }
  return false;
}

} // namespace CGAL::Intrinsic_triangulations::internal
