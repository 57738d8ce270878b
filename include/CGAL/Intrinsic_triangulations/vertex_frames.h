// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The tangent planes of vertices in space.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_VERTEX_FRAMES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_VERTEX_FRAMES_H

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Exact_geometry.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Planar_vector.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/halfedge_vectors.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsAngles
/// \brief the tangent plane of a vertex in space: three unit vectors at right angles, counterclockwise.
struct Vertex_frame
{
  std::array<double, 3> x;      ///< the first axis
  std::array<double, 3> y;      ///< the second axis, to the left of the first
  std::array<double, 3> normal; ///< the normal, towards the side from which faces are counterclockwise

  /// returns a tangent vector in space.
  std::array<double, 3> in_space(const Planar_vector<double>& v) const
  {
    return {v.x() * x[0] + v.y() * y[0], v.x() * x[1] + v.y() * y[1], v.x() * x[2] + v.y() * y[2]};
  }
};

/// \cond SKIP_IN_MANUAL
namespace internal {

using Space_vector = std::array<double, 3>;

inline Space_vector cross(const Space_vector& a, const Space_vector& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double dot(const Space_vector& a, const Space_vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// Zero remains zero; what is short or long is scaled first.
inline Space_vector normalized(Space_vector a)
{
  const double largest = (std::max)({std::abs(a[0]), std::abs(a[1]), std::abs(a[2])});
  if (!(largest > 0))
    return {0, 0, 0};
  for (double& x : a)
    x /= largest;
  const double length = std::sqrt(dot(a, a));
  for (double& x : a)
    x /= length;
  return a;
}

// From the normal and a vector that is not parallel to it; whatever is zero or parallel is replaced.
inline Vertex_frame frame_of(Space_vector normal, const Space_vector& first)
{
  const auto any_perpendicular = [](const Space_vector& a) {
    const std::size_t smallest =
      std::size_t(std::min_element(a.begin(), a.end(), [](double s, double t) { return std::abs(s) < std::abs(t); }) - a.begin());
    Space_vector axis{0, 0, 0};
    axis[smallest] = 1;
    return normalized(cross(a, axis));
  };
  normal = normalized(normal);
  const Space_vector along = normalized(first);
  if (dot(normal, normal) == 0)
    normal = dot(along, along) == 0 ? Space_vector{0, 0, 1} : any_perpendicular(along);
  Space_vector y = normalized(cross(normal, along));
  if (dot(y, y) == 0)
    y = any_perpendicular(normal);
  return {cross(y, normal), y, normal};
}

} // namespace internal
/// \endcond

/// \ingroup PkgIntrinsicTriangulationsAngles
/// \brief returns the tangent planes of `halfedge_vectors_in_vertex()` in space, for drawing.
///
/// The normal of a vertex is the mean of those of the input faces around it, weighted by their angles, and the first axis of its frame is the first
/// axis of `halfedge_vectors_in_vertex()`, projected to the plane. Frames depend on the input alone. Where the surface is bent, a vector in
/// the plane stands for a direction on the surface; where it is flat, both are the same.
///
/// \param triangulation its traits have to use exact geometry
/// \param points a random access range of the points of the input vertices, each with three coordinates
/// \return a frame for each vertex, inserted ones as well, rounded; any frame for a vertex without faces that have an area
/// O(size).
template <class Traits, class PointRange>
std::vector<Vertex_frame> vertex_frames(const Intrinsic_triangulation<Traits>& triangulation, const PointRange& points)
{
  static_assert(Intrinsic_triangulation<Traits>::uses_exact_geometry,
                "vertex_frames() needs traits with exact geometry, as Filtered_edge_length_traits");
  triangulation.exact_geometry().prepare(triangulation.connectivity());
  const Correspondence& correspondence = triangulation.exact_geometry().correspondence();
  const Delta_complex& input = correspondence.input();
  using internal::Space_vector;
  const auto along = [&](Halfedge_index h) {
    Space_vector result;
    const auto &p = points[input.source(h).idx()], &q = points[input.target(h).idx()];
    for (int i = 0; i < 3; ++i)
      result[i] = CGAL::to_double(q[i]) - CGAL::to_double(p[i]);
    return internal::normalized(result);
  };
  std::vector<Space_vector> normals(input.number_of_vertices(), {0, 0, 0}), face_normals;
  face_normals.reserve(input.number_of_faces());
  for (Face_index f : input.faces()) {
    const Halfedge_index h = input.halfedge(f);
    const std::array<Halfedge_index, 3> sides{h, input.next(h), input.prev(h)};
    const std::array<Space_vector, 3> vectors{along(sides[0]), along(sides[1]), along(sides[2])};
    face_normals.push_back(internal::normalized(internal::cross(vectors[0], vectors[1])));
    for (std::size_t i = 0; i < 3; ++i) {
      const Space_vector turned = internal::cross(vectors[i], vectors[(i + 2) % 3]);
      const double angle = std::atan2(std::sqrt(internal::dot(turned, turned)), -internal::dot(vectors[i], vectors[(i + 2) % 3]));
      for (std::size_t k = 0; k < 3; ++k)
        normals[input.source(sides[i]).idx()][k] += angle * face_normals.back()[k];
    }
  }
  std::vector<Vertex_frame> result;
  result.reserve(triangulation.connectivity().number_of_vertices());
  for (Vertex_index v : triangulation.connectivity().vertices()) {
    if (correspondence.is_inserted(v)) {
      const Surface_point& location = correspondence.location(v);
      Space_vector normal = face_normals[input.face(location.halfedge).idx()];
      if (location.dimension() == 1) {
        const Halfedge_index other = input.opposite(internal::side_of(input, location));
        if (!input.is_border(other))
          for (std::size_t k = 0; k < 3; ++k)
            normal[k] += face_normals[input.face(other).idx()][k];
      }
      result.push_back(internal::frame_of(normal, along(location.halfedge)));
    } else if (input.halfedge(v).is_valid()) {
      result.push_back(internal::frame_of(normals[v.idx()], along(internal::first_axis(input, v))));
    } else {
      result.push_back(internal::frame_of({0, 0, 1}, {1, 0, 0}));
    }
  }
  return result;
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_VERTEX_FRAMES_H
