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
#include <CGAL/Intrinsic_triangulations/internal/heat/rows_by_distance.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>

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

// The distance of a vertex is the smallest sum of the distance of a point on the boundary of its star and the way from
// there. Where fronts from several sides meet, the function that fits the directions best rounds off the ridge and lies
// below that: there it is raised. What is larger stays as it is. The distances of the others are those from before, so
// that nothing adds up on the way; a second pass gets to the vertices next to those that were raised.
//
// Between two vertices the distance is linear if their ways come from the same source, or from two that are joined by
// an edge. If not, a ridge runs between them, and there are only ways over the vertices themselves.
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

  // \param interruption is asked now and then
  void raise(Eigen::VectorXd& distances, const Pins& sources, const Interruption& interruption) const
  {
    std::vector<std::uint32_t> origins(surface_.size(), none);
    for (const auto& source : sources)
      origins[source.first] = source.first;
    const bool has_points =
      std::any_of(sources.begin(), sources.end(), [](const auto& source) { return source.second > 0; });
    const Front front{distances, origins, joined_sources(origins), has_points};
    // The nearest first, so that the source of those is known.
    Eigen::VectorXd raised = distances;
    std::size_t steps = 0;
    const auto ask = [&] {
      if (++steps % 1024 == 0)
        interruption.check();
    };
    for (const std::uint32_t v : rows_by_distance(distances)) {
      ask();
      if (origins[v] != v)
        origins[v] = raise(v, front, raised);
    }
    distances = raised;
    for (std::uint32_t v = 0; v < std::uint32_t(surface_.size()); ++v) {
      ask();
      if (origins[v] != v)
        raise(v, front, raised);
    }
    distances = raised;
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
    const double jx = x[j] - x[i], jy = y[j] - y[i], kx = x[k] - x[i], ky = y[k] - y[i],
                 side = std::hypot(kx - jx, ky - jy), ex = (kx - jx) / side, ey = (ky - jy) / side;
    return {face.row[j], face.row[k],          std::hypot(jx, jy),         std::hypot(kx, ky),
            side,        -(jx * ex + jy * ey), std::abs(jx * ey - jy * ex)};
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
    const std::vector<std::uint32_t>&
      origins; // the source that the way to each vertex comes from; none if it comes later
    std::set<std::pair<std::uint32_t, std::uint32_t>> joined;
    bool has_points; // whether there are sources inside of faces

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

  // Returns the source of the shortest way to v.
  std::uint32_t raise(std::uint32_t v, const Front& front, Eigen::VectorXd& raised) const
  {
    const Way way = shortest_way(v, front);
    if (way.origin != none)
      raised[v] = (std::max)(front.distances[v], way.length);
    return way.origin;
  }

  // First over the vertices around v, then over the points between them: most sides of the star are too far away for
  // these.
  Way shortest_way(std::uint32_t v, const Front& front) const
  {
    Way result;
    const Corner *const first = corners_.data() + first_[v], *const end = corners_.data() + first_[v + 1];
    for (const Corner* corner = first; corner != end; ++corner) {
      keep_shorter(result, front, corner->a, front.distances[corner->a] + corner->to_a);
      keep_shorter(result, front, corner->b, front.distances[corner->b] + corner->to_b);
    }
    for (const Corner* corner = first; corner != end; ++corner) {
      if (front.has_points && is_behind_point(*corner, front))
        return {0, corner->a};
      if ((std::min)(front.distances[corner->a], front.distances[corner->b]) + corner->height < result.length)
        keep_shorter(result, front, *corner);
    }
    return result;
  }

  // Behind a side of the face of a source inside it, ways cross the side somewhere: nothing is raised there.
  static bool is_behind_point(const Corner& corner, const Front& front)
  {
    const std::uint32_t a = corner.a, b = corner.b;
    return front.origins[a] == a && front.origins[b] == b && (front.distances[a] > 0 || front.distances[b] > 0);
  }

  static void keep_shorter(Way& way, const Front& front, std::uint32_t over, double length)
  {
    if (length < way.length && front.origins[over] != none)
      way = {length, front.origins[over]};
  }

  // Over all points of the side opposite to a corner; between two sources there is none.
  static void keep_shorter(Way& way, const Front& front, const Corner& corner)
  {
    const std::uint32_t a = corner.a, b = corner.b;
    if (!front.is_linear(a, b))
      return;
    // The point at which the way and the side form the angle whose cosine is the slope of the distance along the side.
    const double at_a = front.distances[a], at_b = front.distances[b], slope = (at_b - at_a) / corner.side;
    if (!(std::abs(slope) < 1))
      return;
    const double sine = std::sqrt((1 - slope) * (1 + slope)), s = corner.foot - slope * corner.height / sine;
    if (s > 0 && s < corner.side)
      keep_shorter(way, front, 2 * s < corner.side ? a : b, at_a + corner.foot * slope + corner.height * sine);
  }

  const Heat_surface& surface_;
  std::vector<std::uint32_t> first_; // the corners at a row are those from this number on
  std::vector<Corner> corners_;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_RIDGE_KEEPER_H
