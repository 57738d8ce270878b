// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Shortest ways followed back to the curve where they begin.

#include <CGAL/Intrinsic_triangulations/nearest_source_point.h>

#include "plane_vectors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

using plane::Vector;

// A straight way back from a row. The row lies at the origin, and the way on the axis.
class Way
{
public:
  Way(const Laid_out_faces& faces, const Window_distances& windows, std::uint32_t row)
    : faces_(faces), windows_(windows), length_(windows.distances[row]), side_(windows.arrivals[row].side)
  {
    const Laid_out_faces::Side& s = faces.side(side_);
    const double angle = -windows.arrivals[row].angle;
    corners_ = {Vector{0, 0}, plane::turned({s.length, 0}, angle), plane::turned({s.apex_x, s.apex_y}, angle)};
  }

  // \return the row where it comes from, or none if it ends at `end`
  std::uint32_t follow(Surface_point& end)
  {
    if (comes_from(1))
      return faces_.side(Laid_out_faces::next(side_)).row;
    std::size_t right = 1, left = 2;
    std::uint32_t crossed = Laid_out_faces::next(side_);
    for (std::size_t i = 0; i < faces_.sides().size(); ++i) {
      if (comes_from(2))
        return faces_.side(Laid_out_faces::prev(side_)).row;
      const Vector p = corners_[right], q = corners_[left];
      const double crossing = p[0] + (q[0] - p[0]) * (p[1] / (p[1] - q[1]));
      const std::uint32_t opposite = faces_.side(crossed).opposite;
      if (crossing >= length_ || opposite == Laid_out_faces::none) {
        end = at((std::min)(crossing, length_));
        return Laid_out_faces::none;
      }
      side_ = opposite;
      const Laid_out_faces::Side& s = faces_.side(side_);
      const Vector along{(p[0] - q[0]) / s.length, (p[1] - q[1]) / s.length};
      corners_ = {
        q, p,
        Vector{q[0] + s.apex_x * along[0] - s.apex_y * along[1], q[1] + s.apex_x * along[1] + s.apex_y * along[0]}};
      const bool is_left = corners_[2][1] > 0;
      right = is_left ? 1 : 2;
      left = is_left ? 2 : 0;
      crossed = is_left ? Laid_out_faces::next(side_) : Laid_out_faces::prev(side_);
    }
    end = at(0);
    return Laid_out_faces::none;
  }

private:
  bool comes_from(std::size_t corner) const
  {
    const auto [x, y] = corners_[corner];
    const std::uint32_t side = corner == 1 ? Laid_out_faces::next(side_) : Laid_out_faces::prev(side_);
    const double gone = std::hypot(x, y);
    return x > 0 && std::abs(y) <= 1e-5 * gone &&
           std::abs(windows_.distances[faces_.side(side).row] + gone - length_) <= 1e-9 * length_;
  }

  // The point of the axis, in the current face.
  Surface_point at(double x) const
  {
    Surface_point result{faces_.halfedge(side_), {}};
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector p = plane::difference(corners_[(i + 1) % 3], {x, 0}),
                   q = plane::difference(corners_[(i + 2) % 3], {x, 0});
      sum += result.coordinates[i] = (std::max)(0., plane::cross(p, q));
    }
    for (double& c : result.coordinates)
      c /= sum;
    return result;
  }

  const Laid_out_faces& faces_;
  const Window_distances& windows_;
  double length_;
  std::uint32_t side_;            // of the current face
  std::array<Vector, 3> corners_; // from where it begins
};

} // namespace

Surface_point beginning_of_way(const Laid_out_faces& faces, const Window_distances& windows, std::uint32_t row)
{
  Surface_point result;
  while (row != Laid_out_faces::none) {
    result = {faces.halfedge(faces.corner(faces.first_corner(row))), {1, 0, 0}};
    row = windows.arrivals[row].side == Laid_out_faces::none ? Laid_out_faces::none
                                                             : Way(faces, windows, row).follow(result);
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal
