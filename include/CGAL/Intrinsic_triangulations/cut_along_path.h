// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A surface cut open along a path.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CUT_ALONG_PATH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CUT_ALONG_PATH_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsGeodesics
/// \brief the result of `cut_along_path()`.
struct Cut_surface
{
  /// the points of the vertices; input vertices come first
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::uint32_t, 3>> triangles; ///< the corners of the triangles
  std::vector<std::uint32_t> input_faces;              ///< for each triangle, the input face that it is part of
  /// for `points[n + i]`, if the input has n vertices, where it lies on the input, also if it is a copy of an input
  /// vertex: `interpolate()` gives the values of vertex data there
  std::vector<Surface_point> locations;
};

namespace internal {

// The paths may meet at points that both have.
Cut_surface cut_along_paths(const Delta_complex& complex, const std::vector<std::array<double, 3>>& points,
                            const std::vector<std::vector<Surface_point>>& paths);

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsGeodesics
/// \brief cuts a surface open along a path.
///
/// Faces that the path crosses are divided, and each vertex on the path gets a copy for each side of it. The ends of an
/// open path are not divided, unless they lie on the border: so a path between two inner points leaves a slit. If it
/// has no vertex in between, it gets one. The vertices of the input keep their numbers, and orientations remain.
///
/// \param complex the input; no two of its edges have the same two ends
/// \param points a random access range of the points of its vertices, each with three coordinates
/// \param path points of the input, two consecutive ones in the face of the first, as `Geodesic_path::points` and
///   `geodesic_points()`. Its segments do not cross. A closed path ends where it begins. A point whose barycentric
///   coordinate is below 2⁻⁴⁰ of their sum lies on that edge
/// \return the triangles; the input triangles if the path has fewer than two points
/// \exception Invalid_surface_error if two edges have the same two ends
/// \exception Invalid_point_error if a point does not lie on the surface, or two consecutive ones do not lie in the
///   face of the first, or segments cross
///
/// O(size), and in a face with k points mostly O(k log k).
template <class PointRange>
Cut_surface cut_along_path(const Delta_complex& complex, const PointRange& points,
                           const std::vector<Surface_point>& path)
{
  std::vector<std::array<double, 3>> places;
  for (Vertex_index v : complex.vertices()) {
    const auto& p = points[v.idx()];
    places.push_back({CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2])});
  }
  return internal::cut_along_paths(complex, places, {path});
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CUT_ALONG_PATH_H
