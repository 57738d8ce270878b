// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A surface that is cut open along a path.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CUT_ALONG_PATH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CUT_ALONG_PATH_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Index.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Large_vector.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/geodesic_points.h>
#include <CGAL/Intrinsic_triangulations/internal/gluing/Cut_faces.h>
#include <CGAL/Intrinsic_triangulations/internal/gluing/separate_fans.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsGeodesics
/// \brief what `cut_along_path()` makes of a surface.
struct Cut_surface
{
  /// of the vertices: first those of the input, then the others
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::uint32_t, 3>> triangles; ///< their corners
  std::vector<std::uint32_t> input_faces;              ///< for each triangle, the face of the input that it is a part of
  /// for each vertex behind those of the input, where it lies on the input: for data at the vertices, `interpolate()` gives its value
  std::vector<Surface_point> locations;
};

/// \ingroup PkgIntrinsicTriangulationsGeodesics
/// \brief cuts a surface open along a path.
///
/// Faces that the path crosses are divided, and each vertex on the path gets a copy for each side of it. The ends of an open path are not
/// divided, unless they lie on the border: so a path between two inner points leaves a slit. If it has no vertex in between, it gets one. The
/// vertices of the input keep their numbers, and orientations remain.
///
/// \param complex the input; no two of its edges have the same two ends
/// \param points a random access range of the points of its vertices, each with three coordinates
/// \param path points of the input, two consecutive ones in the face of the first, as `Geodesic_path::points` and `geodesic_points()`. Its
///   segments do not cross. A closed one ends where it begins
/// \return the triangles; those of the input, if there are less than two points
/// \exception Invalid_surface_error if two edges have the same two ends
/// \exception Invalid_point_error if a point is none of the surface, or two consecutive ones do not lie in the face of the first, or segments
///   cross
///
/// O(size), and for each face the number of segments there times that of its pieces.
template <class PointRange>
Cut_surface cut_along_path(const Delta_complex& complex, const PointRange& points, const std::vector<Surface_point>& path)
{
  const internal::Cut_faces faces(complex, path);
  const std::vector<std::array<std::uint32_t, 3>>& triangles = faces.triangles();
  constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();
  const auto key = [](std::uint32_t from, std::uint32_t to) { return (std::uint64_t(from) << 32) | to; };
  std::unordered_map<std::uint64_t, std::uint32_t> sides;
  Large_vector<std::uint32_t> corners;
  for (const auto& triangle : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = triangle[i], to = triangle[(i + 1) % 3];
      if (!sides.insert({key(from, to), std::uint32_t(corners.size())}).second)
        throw Invalid_surface_error(Invalid_surface_error::Defect::WRONG_TOPOLOGY, from, 1,
                                    "two edges join vertex " + std::to_string(from) + " and vertex " + std::to_string(to) +
                                      ": the corners of triangles do not tell them apart");
      corners.push_back(triangle[i]);
    }
  for (const auto& [from, to] : faces.seam())
    if (sides.count(key(from, to)) + sides.count(key(to, from)) == 0)
      throw Invalid_point_error("a surface cannot be cut along a path that crosses itself");
  for (const auto& [from, to] : faces.seam()) {
    sides.erase(key(from, to));
    sides.erase(key(to, from));
  }
  Large_vector<std::uint32_t> glued_to(corners.size(), none);
  for (const auto& side : sides) {
    const auto other = sides.find((side.first << 32) | (side.first >> 32));
    if (other != sides.end())
      glued_to[side.second] = other->second;
  }
  const auto [vertex_of, fans] = internal::separate_fans(faces.number_of_vertices(), corners, glued_to);

  Cut_surface result;
  const std::size_t n = complex.number_of_vertices();
  for (Vertex_index v : complex.vertices()) {
    const auto& p = points[v.idx()];
    result.points.push_back({CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2])});
  }
  for (std::size_t i = n; i < vertex_of.size(); ++i) {
    result.locations.push_back(faces.location(vertex_of[i]));
    result.points.push_back(vertex_of[i] < n ? result.points[vertex_of[i]] : point_in_space(complex, points, result.locations.back()));
  }
  for (std::size_t f = 0; f < triangles.size(); ++f)
    result.triangles.push_back({fans[3 * f], fans[3 * f + 1], fans[3 * f + 2]});
  result.input_faces = faces.input_faces();
  return result;
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CUT_ALONG_PATH_H
