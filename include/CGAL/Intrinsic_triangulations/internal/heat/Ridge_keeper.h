// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Raises distances that are less than what the vertices around allow.

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
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// The distance of a vertex is the smallest sum of the distance of a point on the boundary of its star and the way from there.
// Where fronts from several sides meet, the function that fits the directions best rounds off the ridge and lies below
// that: there it is raised. What is larger stays as it is. The distances of the others are those from before, so that nothing
// adds up on the way; a second pass gets to the vertices next to those that were raised.
//
// Between two vertices the distance is linear if their ways come from the same source, or from two that are joined by an edge. If not,
// a ridge runs between them, and there are only ways over the vertices themselves.
class Ridge_keeper
{
public:
  explicit Ridge_keeper(const Heat_surface& surface) : surface_(surface), first_(surface.size() + 1, 0)
  {
    for (const Heat_face& face : surface.faces)
      for (std::uint32_t row : face.row)
        ++first_[row + 1];
    for (std::size_t v = 0; v < surface.size(); ++v)
      first_[v + 1] += first_[v];
    corners_.resize(3 * surface.faces.size());
    std::vector<std::uint32_t> position(first_.begin(), first_.end() - 1);
    for (const Heat_face& face : surface.faces)
      for (int i = 0; i < 3; ++i)
        corners_[position[face.row[i]]++] = corner(face, i);
  }

  void raise(Eigen::VectorXd& distances, const Pins& sources) const
  {
    std::vector<std::uint32_t> order(surface_.size()), origins(surface_.size(), none);
    for (std::size_t v = 0; v < order.size(); ++v)
      order[v] = std::uint32_t(v);
    std::sort(order.begin(), order.end(), [&](std::uint32_t v, std::uint32_t w) {
      return distances[v] < distances[w] || (distances[v] == distances[w] && v < w);
    });
    for (const auto& source : sources)
      origins[source.first] = source.first;
    const Front front{distances, origins, joined_sources(origins)};
    raise_once(distances, order, front, origins);
    raise_once(distances, order, front, origins);
  }

private:
  static constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();

  // The side opposite to a corner as it is seen from there: from a to b.
  struct Corner
  {
    std::uint32_t a, b;
    double to_a, to_b, side;
    double foot, height; // of the altitude: how far its foot is from a towards b
  };

  static Corner corner(const Heat_face& face, int i)
  {
    const std::array<double, 3> x{0, face.base, face.x}, y{0, 0, face.height};
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double jx = x[j] - x[i], jy = y[j] - y[i], kx = x[k] - x[i], ky = y[k] - y[i], side = std::hypot(kx - jx, ky - jy),
                 ex = (kx - jx) / side, ey = (ky - jy) / side;
    return {face.row[j], face.row[k], std::hypot(jx, jy), std::hypot(kx, ky), side, -(jx * ex + jy * ey), std::abs(jx * ey - jy * ex)};
  }

  struct Way
  {
    double length = std::numeric_limits<double>::infinity();
    std::uint32_t origin = none;
  };

  // What is known while the pass goes on.
  struct Front
  {
    const Eigen::VectorXd& distances;
    const std::vector<std::uint32_t>& origins; // the source that the way to each vertex comes from; none if it comes later
    std::set<std::pair<std::uint32_t, std::uint32_t>> joined;

    bool is_linear(std::uint32_t v, std::uint32_t w) const
    {
      const std::uint32_t a = origins[v], b = origins[w];
      if (a == none || b == none || (a == v && b == w))
        return false;
      return a == b || joined.count({(std::min)(a, b), (std::max)(a, b)}) > 0;
    }
  };

  std::set<std::pair<std::uint32_t, std::uint32_t>> joined_sources(const std::vector<std::uint32_t>& origins) const
  {
    std::set<std::pair<std::uint32_t, std::uint32_t>> result;
    for (const Heat_face& face : surface_.faces)
      for (int i = 0; i < 3; ++i) {
        const std::uint32_t v = face.row[i], w = face.row[(i + 1) % 3];
        if (origins[v] != none && origins[w] != none)
          result.insert({(std::min)(v, w), (std::max)(v, w)});
      }
    return result;
  }

  // \param order the nearest first, so that the source of those is known
  void raise_once(Eigen::VectorXd& distances, const std::vector<std::uint32_t>& order, const Front& front,
                  std::vector<std::uint32_t>& origins) const
  {
    Eigen::VectorXd raised = distances;
    for (std::uint32_t v : order) {
      if (origins[v] == v)
        continue;
      const Way way = shortest_way(v, front);
      if (way.origin == none)
        continue;
      raised[v] = (std::max)(distances[v], way.length);
      origins[v] = way.origin;
    }
    distances = raised;
  }

  Way shortest_way(std::uint32_t v, const Front& front) const
  {
    Way result;
    for (std::uint32_t i = first_[v]; i < first_[v + 1]; ++i)
      keep_shorter(corners_[i], front, result);
    return result;
  }

  // Over all points of the side opposite to a corner; between two sources there is none.
  static void keep_shorter(const Corner& corner, const Front& front, Way& way)
  {
    const std::uint32_t a = corner.a, b = corner.b;
    const auto keep = [&](std::uint32_t over, double length) {
      if (front.origins[over] != none && length < way.length)
        way = {length, front.origins[over]};
    };
    const double at_a = front.distances[a], at_b = front.distances[b];
    // Behind a side of the face of a source inside it, ways cross the side somewhere: nothing is raised there.
    if (front.origins[a] == a && front.origins[b] == b && (at_a > 0 || at_b > 0)) {
      way = {0, a};
      return;
    }
    keep(a, at_a + corner.to_a);
    keep(b, at_b + corner.to_b);
    if (!front.is_linear(a, b))
      return;
    // The point at which the way and the side form the angle whose cosine is the slope of the distance along the side.
    const double slope = (at_b - at_a) / corner.side;
    if (!(std::abs(slope) < 1))
      return;
    const double sine = std::sqrt((1 - slope) * (1 + slope)), s = corner.foot - slope * corner.height / sine;
    if (s > 0 && s < corner.side)
      keep(2 * s < corner.side ? a : b, at_a + corner.foot * slope + corner.height * sine);
  }

  const Heat_surface& surface_;
  std::vector<std::uint32_t> first_; // the corners at a row are those from this number on
  std::vector<Corner> corners_;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_RIDGE_KEEPER_H
