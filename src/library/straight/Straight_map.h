// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The map from a surface to straight triangles that is linear on each intrinsic face.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_STRAIGHT_STRAIGHT_MAP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_STRAIGHT_STRAIGHT_MAP_H

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>

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

// Each vertex of the triangulation has an image, which is a vertex as well: itself, unless vertices are merged.
class Straight_map
{
public:
  using Point = std::array<double, 3>;

  struct Distance
  {
    double value = 0;
    Point place{}; // on the surface
  };

  // \param points those of the input
  Straight_map(const Common_subdivision& subdivision, const std::vector<Point>& points)
    : subdivision_(subdivision), overlay_(subdivision.overlay()), complex_(subdivision.intrinsic()),
      input_points_(points)
  {
    for (Vertex_index v : complex_.vertices()) { // which the overlay begins with
      points_.push_back(subdivision_.point(Overlay::Vertex(v.idx()), points));
      images_.push_back(v.idx());
      merged_.push_back({v.idx()});
    }
    for (const Point& p : input_points_) // which are the corners of all others
      for (double x : p)
        largest_coordinate_ = (std::max)(largest_coordinate_, std::abs(x));
  }

  const std::vector<Point>& points() const { return points_; }
  std::uint32_t image(Vertex_index v) const { return images_[v.idx()]; }
  std::array<Point, 3> corners(const std::array<std::uint32_t, 3>& t) const
  {
    return {points_[t[0]], points_[t[1]], points_[t[2]]};
  }

  // \return another vertex at the place of v. No vertex of the triangulation has it as its image
  std::uint32_t add_copy(std::uint32_t v)
  {
    points_.push_back(Point(points_[v]));
    merged_.emplace_back();
    return std::uint32_t(points_.size()) - 1;
  }

  struct Undo
  {
    std::uint32_t from, to;
    std::size_t number;
  };
  // All vertices whose image is `from` then have the image `to`.
  Undo merge(std::uint32_t from, std::uint32_t to)
  {
    const Undo result{from, to, merged_[from].size()};
    for (std::uint32_t v : merged_[from])
      images_[v] = to;
    merged_[to].insert(merged_[to].end(), merged_[from].begin(), merged_[from].end());
    merged_[from].clear();
    return result;
  }
  // \pre this was the last merge
  void undo(const Undo& merge)
  {
    std::vector<std::uint32_t>& both = merged_[merge.to];
    merged_[merge.from].assign(both.end() - std::ptrdiff_t(merge.number), both.end());
    both.resize(both.size() - merge.number);
    for (std::uint32_t v : merged_[merge.from])
      images_[v] = merge.from;
  }

  // How far points of the surface are from their images, where the image of a vertex is `v`, without the rounding.
  Distance distance_around(std::uint32_t v) const
  {
    Distance result;
    for (std::uint32_t w : merged_[v]) {
      add(result, points_[w], points_[v]);
      if (complex_.halfedge(Vertex_index(w)).is_valid())
        for (Halfedge_index h : Halfedges_around(complex_, Vertex_index(w)))
          add_crossings(result, complex_.edge(h));
    }
    return result;
  }
  // The same of the points of a face.
  Distance distance_on(Face_index f) const
  {
    Distance result;
    Halfedge_index h = complex_.halfedge(f);
    for (int i = 0; i < 3; ++i, h = complex_.next(h)) {
      add(result, points_[complex_.source(h).idx()], points_[image(complex_.source(h))]);
      add_crossings(result, complex_.edge(h));
    }
    return result;
  }
  Distance largest_distance() const
  {
    Distance result;
    for (Vertex_index v : complex_.vertices())
      add(result, points_[v.idx()], points_[image(v)]);
    for (Edge_index e : complex_.edges())
      add_crossings(result, e);
    return result;
  }

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
  static void add(Distance& distance, const Point& p, const Point& image)
  {
    const double d = std::hypot(p[0] - image[0], p[1] - image[1], p[2] - image[2]);
    if (d > distance.value)
      distance = {d, p};
  }
  void add_crossings(Distance& distance, Edge_index e) const
  {
    const Halfedge_index h = complex_.halfedge(e);
    const Point &p = points_[image(complex_.source(h))], &q = points_[image(complex_.target(h))];
    for (Overlay::Vertex x : overlay_.intrinsic_crossings(e)) {
      const double t = subdivision_.positions().on_intrinsic_edge(x);
      add(distance, subdivision_.point(x, input_points_),
          {(1 - t) * p[0] + t * q[0], (1 - t) * p[1] + t * q[1], (1 - t) * p[2] + t * q[2]});
    }
  }

  const Common_subdivision& subdivision_;
  const Overlay& overlay_;
  const Delta_complex& complex_;
  const std::vector<Point>& input_points_;
  std::vector<Point> points_; // of the vertices, and of copies
  double largest_coordinate_ = 0;
  std::vector<std::uint32_t> images_;
  std::vector<std::vector<std::uint32_t>> merged_; // the vertices of the triangulation with each image
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_STRAIGHT_STRAIGHT_MAP_H
