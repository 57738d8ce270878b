// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Vertices with a small sum of angles, where refinement has to keep its distance.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_SMALL_CONES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_SMALL_CONES_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/point_on_input.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// See doc/termination.md. Lengths are in the unit of the input.
class Small_cones
{
public:
  Small_cones(const Exact_engine& engine, Input_shapes& shapes)
    : input_(engine.correspondence().input()), unit_exponent_(engine.metric().unit_exponent()), shapes_(shapes)
  {}

  void add(Vertex_index v, double angle) { cones_.emplace(v, Cone{angle, 0}); }
  bool contains(Vertex_index v) const { return cones_.count(v) != 0; }
  std::vector<Vertex_index> vertices() const
  {
    std::vector<Vertex_index> result;
    for (const auto& cone : cones_)
      result.push_back(cone.first);
    std::sort(result.begin(), result.end());
    return result;
  }

  // A circle around v of this radius lies in the input faces there: the smallest height from v.
  double radius_of_input_faces(Vertex_index v) const
  {
    double radius = (std::numeric_limits<double>::infinity)();
    for (Halfedge_index h : Halfedges_around(input_, v)) {
      const double height = shapes_.four_areas(input_.face(h)) / (2 * shapes_.length(input_.edge(input_.prev(h))));
      radius = (std::min)(radius, std::ldexp(height, unit_exponent_));
    }
    return radius;
  }

  // Keeps the circumcircle of the triangle free that a vertex at this distance makes with v.
  void protect(Vertex_index v, double distance)
  {
    Cone& cone = cones_.at(v);
    constexpr double for_rounding = 1 + 1e-9;
    cone.radius = distance / std::cos(cone.angle / 2) * for_rounding;
  }

  bool is_too_close(const Surface_point& point) const
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

private:
  struct Cone
  {
    double angle;
    double radius; // of the circle that is kept free
  };

  const Delta_complex& input_;
  const int unit_exponent_;
  Input_shapes& shapes_;
  std::unordered_map<Vertex_index, Cone> cones_;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_SMALL_CONES_H
