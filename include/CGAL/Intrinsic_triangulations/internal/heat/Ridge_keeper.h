// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Raises distances that are too small for those of the neighbors.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_RIDGE_KEEPER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_RIDGE_KEEPER_H

#include <CGAL/Intrinsic_triangulations/internal/heat/Heat_surface.h>
#include <CGAL/Intrinsic_triangulations/internal/heat/Pinned_system.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The distance of a vertex is the smallest sum of the distance of a point on the boundary of its star and the way from
// there. Where fronts from several sides meet, the function that fits the directions best rounds off the ridge and lies
// below that sum: there it is raised. Larger values stay. Only old distances of the neighbors are used, so that nothing
// accumulates; a second pass handles the neighbors of raised vertices.
//
// Between two vertices the distance is linear, unless one is a source, from which ways are straight.
class Ridge_keeper
{
public:
  Ridge_keeper(const Heat_surface& surface, const Pins& sources, const std::vector<bool>& is_reachable)
    : surface_(surface), is_fixed_(surface.size())
  {
    for (std::size_t row = 0; row < surface.size(); ++row)
      is_fixed_[row] = !is_reachable[row];
    for (const auto& source : sources)
      is_fixed_[source.first] = true;
  }

  void raise(Eigen::VectorXd& distances) const
  {
    raise<true>(distances);
    raise<false>(distances);
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  // \tparam only_nearer whether ways lead only over nearer vertices
  template <bool only_nearer>
  void raise(Eigen::VectorXd& distances) const
  {
    const std::vector<char> is_settled = settled_rows(distances);
    std::vector<double> ways(surface_.size(), infinity);
    for (const Heat_face& face : surface_.faces)
      for (int i = 0; i < 3; ++i)
        if (!is_settled[face.row[i]])
          ways[face.row[i]] = (std::min)(ways[face.row[i]], shortest_way<only_nearer>(face, i, distances));
    for (std::size_t row = 0; row < ways.size(); ++row)
      if (ways[row] < infinity)
        distances[Eigen::Index(row)] = (std::max)(distances[Eigen::Index(row)], ways[row]);
  }

  // Most rows are not on a ridge: in a face around them the distance falls off into the face about as steeply as it
  // can; not between two sources.
  std::vector<char> settled_rows(const Eigen::VectorXd& distances) const
  {
    std::vector<char> result = is_fixed_;
    for (const Heat_face& face : surface_.faces) {
      const auto& row = face.row;
      const auto [x, y] = face.slope({distances[row[0]], distances[row[1]], distances[row[2]]});
      const double area = face.base * face.height, to_second = x * face.height - y * face.x, to_third = y * face.base;
      const bool is_steep = (x * x + y * y >= 0.9 * area * area) &
                            (is_fixed_[row[0]] + is_fixed_[row[1]] + is_fixed_[row[2]] < 2),
                 from_first = to_second + to_third >= 0, from_second = to_second <= 0, from_third = to_third <= 0;
      result[row[0]] |= is_steep & from_second & from_third;
      result[row[1]] |= is_steep & from_first & from_third;
      result[row[2]] |= is_steep & from_first & from_second;
    }
    return result;
  }

  // The way to a corner across the opposite side of the face; infinite if there is none.
  template <bool only_nearer>
  double shortest_way(const Heat_face& face, int corner, const Eigen::VectorXd& distances) const
  {
    const std::array<double, 3> x{0, face.base, face.x}, y{0, 0, face.height};
    const int i = corner, j = (i + 1) % 3, k = (i + 2) % 3;
    const std::uint32_t v = face.row[i], a = face.row[j], b = face.row[k];
    const double at_v = distances[v], at_a = distances[a], at_b = distances[b];
    if (is_fixed_[a] && is_fixed_[b] && (at_a > 0 || at_b > 0))
      return 0; // ways across a side of a face with a source inside it are unknown: nothing is raised
    const double ax = x[j] - x[i], ay = y[j] - y[i], bx = x[k] - x[i], by = y[k] - y[i];
    const bool over_a = !only_nearer || at_a < at_v || (at_a == at_v && a < v),
               over_b = !only_nearer || at_b < at_v || (at_b == at_v && b < v);
    double result = over_a ? at_a + std::sqrt(ax * ax + ay * ay) : infinity;
    if (over_b)
      result = (std::min)(result, at_b + std::sqrt(bx * bx + by * by));
    if (!over_a || !over_b || at_a == 0 || at_b == 0)
      return result;
    // Across the point where the cosine of the angle between way and side is the slope of the distance along the side.
    const double ex = bx - ax, ey = by - ay, square = ex * ex + ey * ey, area = face.base * face.height,
                 more = at_b - at_a, root = std::sqrt((std::max)(0., square - more * more)),
                 from_a = -(ax * ex + ay * ey), from_b = bx * ex + by * ey;
    if (from_a * root > more * area && from_b * root > -more * area)
      result = (std::min)(result, at_a + (from_a * more + area * root) / square);
    return result;
  }

  const Heat_surface& surface_;
  std::vector<char> is_fixed_; // sources and unreachable rows
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_RIDGE_KEEPER_H
