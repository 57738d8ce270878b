// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// From where distances are measured: points, curves and regions.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_GEODESIC_SOURCE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_GEODESIC_SOURCE_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Index.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/Tufted_cover.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief a set of points of the input from which `geodesic_distances_from()` measures.
struct Geodesic_source
{
  /// Each part is a point or a curve of straight segments. Two consecutive points of a curve lie in the face of the
  /// first, as in the results of `geodesic_points()`. Curves may cross each other and themselves. A closed curve ends
  /// where it begins. A point whose barycentric coordinate is below 2⁻⁴⁰ of their sum lies on that edge.
  std::vector<std::vector<Surface_point>> parts;
  double offset = 0; ///< the distance at these points, not negative, in the unit of the input
};

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief returns a vertex as a source. \exception Invalid_argument_error if there is no such vertex, or it has no face
Geodesic_source source_at_vertex(const Delta_complex& input, Vertex_index v);
/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief returns an edge as a source. \exception Invalid_argument_error if there is no such edge
Geodesic_source source_at_edge(const Delta_complex& input, Edge_index e);
/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief returns the points of some faces as a source: their vertices, and the edges between them and other faces.
/// Inside of the faces, distances are zero at the vertices only.
/// \exception Invalid_argument_error if there is no such face
Geodesic_source source_of_region(const Delta_complex& input, const std::vector<Face_index>& faces);

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief a point of a triangle.
struct Point_in_triangle
{
  std::size_t triangle;              ///< its number
  std::array<double, 3> coordinates; ///< barycentric coordinates, of its corners in the order in which they are given
};

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief returns points and curves, given in the triangles below a cover, as sources on it: on its input,
/// `cover.triangulation.input()`. A curve gets several parts where it goes over an edge of several triangles, and points
/// where it crosses a cut beside a triangle of zero area.
/// \param cover a cover
/// \param triangles the triangles from which it was made
/// \param curves each a point or a curve: points of the triangles, each one in the triangle of the one before
/// \exception Invalid_point_error if there is no such triangle, or it has zero area, and no triangle with an area has the
///   edge where the point lies; if coordinates are negative or not finite; or if a point does not lie in the triangle of
///   the one before
/// O(number of triangles and points), and as much for each point of a triangle of zero area.
std::vector<Geodesic_source> sources_on_cover(const Tufted_cover& cover,
                                              const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                              const std::vector<std::vector<Point_in_triangle>>& curves);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_GEODESIC_SOURCE_H
