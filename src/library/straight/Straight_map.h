// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The map from a surface to straight triangles that is linear on each intrinsic face.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_STRAIGHT_STRAIGHT_MAP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_STRAIGHT_STRAIGHT_MAP_H

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/triangle_formulas_3.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The smallest angle of a triangle in degrees, and its corner. The angle is 0 between points that coincide.
inline std::pair<double, std::size_t> smallest_angle(const std::array<std::array<double, 3>, 3>& corners)
{
  std::pair<double, std::size_t> result{180, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto &p = corners[i], &q = corners[(i + 1) % 3], &r = corners[(i + 2) % 3];
    double size = (std::numeric_limits<double>::min)(); // so that products neither overflow nor vanish
    for (std::size_t axis = 0; axis < 3; ++axis)
      size = (std::max)({size, std::abs(q[axis] - p[axis]), std::abs(r[axis] - p[axis])});
    std::array<double, 3> a{}, b{}, across{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      a[axis] = (q[axis] - p[axis]) / size;
      b[axis] = (r[axis] - p[axis]) / size;
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
      across[axis] = a[(axis + 1) % 3] * b[(axis + 2) % 3] - a[(axis + 2) % 3] * b[(axis + 1) % 3];
    const double angle =
      std::atan2(std::hypot(across[0], across[1], across[2]), a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
    result = (std::min)(result, {angle * (180 / CGAL_PI), i});
  }
  return result;
}

// The angle in degrees between the half-planes from the line pq to r and to s: 0 where they lie on each other.
inline double dihedral_angle(const std::array<double, 3>& p, const std::array<double, 3>& q,
                             const std::array<double, 3>& r, const std::array<double, 3>& s)
{
  const auto point = [](const std::array<double, 3>& x) { return Simple_cartesian<double>::Point_3(x[0], x[1], x[2]); };
  return std::abs(approximate_dihedral_angle(point(p), point(q), point(r), point(s)));
}

inline std::array<double, 3> difference(const std::array<double, 3>& p, const std::array<double, 3>& q)
{
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}

// As long as twice the area.
inline std::array<double, 3> normal_of(const std::array<std::array<double, 3>, 3>& corners)
{
  return cross_product(difference(corners[1], corners[0]), difference(corners[2], corners[0]));
}

// Without squares of areas, which overflow early.
inline double area_of(const std::array<std::array<double, 3>, 3>& corners)
{
  const std::array<double, 3> normal = normal_of(corners);
  return std::hypot(normal[0], normal[1], normal[2]) / 2;
}

// Zero if there is no area.
inline std::array<double, 3> unit_normal_of(const std::array<std::array<double, 3>, 3>& corners)
{
  std::array<double, 3> result = normal_of(corners);
  if (const double length = std::hypot(result[0], result[1], result[2]); length > 0)
    for (double& x : result)
      x /= length;
  return result;
}

// Knows where the surface lies below each face, and where its vertices and added ones are.
class Straight_map
{
public:
  using Point = std::array<double, 3>;
  using Corners = std::array<Point, 3>;

  struct Distance
  {
    double value = 0;
    Point place{}; // on the surface
  };

  // \param points those of the input
  Straight_map(const Common_subdivision& subdivision, const std::vector<Point>& points)
    : subdivision_(subdivision), overlay_(subdivision.overlay()), complex_(subdivision.intrinsic())
  {
    for (Overlay::Vertex x : overlay_.vertices())
      positions_.push_back(subdivision_.point(x, points));
    points_.assign(positions_.begin(), positions_.begin() + std::ptrdiff_t(complex_.number_of_vertices()));
    for (const Point& p : points) // which are the corners of all others
      for (double x : p)
        largest_coordinate_ = (std::max)(largest_coordinate_, std::abs(x));
  }

  const std::vector<Point>& points() const { return points_; }
  Corners corners(const std::array<std::uint32_t, 3>& t) const { return {points_[t[0]], points_[t[1]], points_[t[2]]}; }
  std::uint32_t add_vertex(const Point& p)
  {
    points_.push_back(Point(p)); // which may be one of them
    return std::uint32_t(points_.size()) - 1;
  }
  void move_vertex(std::uint32_t v, const Point& p) { points_[v] = p; }

  // How far points of a face are from their images, if its vertices have not moved, without rounding.
  Distance distance_on(Face_index f) const
  {
    Distance result;
    const Halfedge_index first = complex_.halfedge(f);
    for (Halfedge_index h : {first, complex_.next(first), complex_.prev(first)}) {
      const Halfedge_index along = complex_.halfedge(complex_.edge(h));
      const Point &p = positions_[complex_.source(along).idx()], &q = positions_[complex_.target(along).idx()];
      for (Overlay::Vertex x : overlay_.intrinsic_crossings(complex_.edge(h))) {
        const double t = subdivision_.positions().on_intrinsic_edge(x);
        const Point& at = positions_[x.idx()];
        const double d = std::hypot(at[0] - ((1 - t) * p[0] + t * q[0]), at[1] - ((1 - t) * p[1] + t * q[1]),
                                    at[2] - ((1 - t) * p[2] + t * q[2]));
        if (d > result.value)
          result = {d, at};
      }
    }
    return result;
  }

  // The point of an edge that divides it in this ratio.
  Point point_on(Edge_index e, double part) const
  {
    Point before = positions_[complex_.source(complex_.halfedge(e)).idx()];
    double begin = 0;
    const auto between = [&](const Point& after, double end) {
      const double t = end > begin ? (part - begin) / (end - begin) : 0;
      Point result;
      for (std::size_t i = 0; i < 3; ++i)
        result[i] = (1 - t) * before[i] + t * after[i];
      return result;
    };
    for (Overlay::Vertex x : overlay_.intrinsic_crossings(e)) {
      const double end = subdivision_.positions().on_intrinsic_edge(x);
      if (end >= part)
        return between(positions_[x.idx()], end);
      before = positions_[x.idx()];
      begin = end;
    }
    return between(positions_[complex_.target(complex_.halfedge(e)).idx()], 1);
  }

  // The surface in a face, as triangles in space.
  std::vector<Corners> surface_in(Face_index f)
  {
    if (overlay_faces_.empty()) {
      overlay_faces_.resize(complex_.number_of_faces());
      for (Overlay::Face g : overlay_.faces())
        overlay_faces_[overlay_.intrinsic_face(g).idx()].push_back(g);
    }
    std::vector<Corners> result;
    for (Overlay::Face g : overlay_faces_[f.idx()]) {
      const Overlay::Halfedge first = overlay_.halfedge(g);
      Point before = position(overlay_.target(overlay_.next(first)));
      for (Overlay::Halfedge h = overlay_.next(overlay_.next(first)); h != first; h = overlay_.next(h)) {
        const Point& at = position(overlay_.target(h));
        result.push_back({position(overlay_.target(first)), before, at});
        before = at;
      }
    }
    return result;
  }

  const Point& position(Overlay::Vertex x) const { return positions_[x.idx()]; }

  double largest_coordinate() const { return largest_coordinate_; }

  // A bound for the distance that includes all rounding.
  //
  // In units of u = 2^-53 and of the largest coordinate: both positions of a crossing have relative errors of 2u, so
  // (1 - t) p + t q has an error of 8u at most in each coordinate, and an inserted vertex as well. Their difference has
  // one of 18u, and its norm one of 32u = 2^-48. The factor covers the rounding of the norm.
  double bound(double distance) const
  {
    if (overlay_.number_of_vertices() == overlay_.number_of_input_vertices() && distance == 0)
      return 0;
    return distance * (1 + 0x1p-50) + 0x1p-48 * largest_coordinate_;
  }

private:
  const Common_subdivision& subdivision_;
  const Overlay& overlay_;
  const Delta_complex& complex_;
  std::vector<Point> positions_; // of the vertices of the overlay; those of the triangulation come first
  std::vector<Point> points_;    // of the vertices of the triangles
  std::vector<std::vector<Overlay::Face>> overlay_faces_; // in each face
  double largest_coordinate_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_STRAIGHT_STRAIGHT_MAP_H
