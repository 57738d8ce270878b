// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A conformal map of a surface to the plane, and what is proven about it.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CONFORMAL_MAP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CONFORMAL_MAP_H

#include <CGAL/Intrinsic_triangulations/Conformal_metric.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsParameterization
/// \brief a conformal map of a surface, cut open between its cones, to the plane.
///
/// It is linear on the triangles of a mesh that divides both the input triangles and those of the ideal Delaunay
/// triangulation. On the input, its triangles are flat. Counts and signs refer to exactly the doubles in `uv`.
struct Conformal_map
{
  /// a point of the plane
  using Point = std::array<double, 2>;

  /// the metric that was laid out
  Discrete_conformal_metric metric;
  /// where the vertices of the mesh lie on the input of the given triangulation; first the vertices of the surface
  std::vector<Surface_point> places;
  /// the weights of homogeneous coordinates of the images of these vertices: where triangles have a face of the
  /// Delaunay triangulation in common, and one of the ideal one, interpolating (w x, w y, w) linearly, and dividing by
  /// the last, makes them one projective map, which is smoother than the linear ones
  std::vector<double> weights;
  std::vector<std::array<std::uint32_t, 3>> triangles; ///< the vertices of the triangles, counterclockwise
  std::vector<std::array<Point, 3>> uv;                ///< the images of their corners
  std::vector<Face_index> input_faces;                 ///< for each triangle, the input face that contains it
  /// for each triangle, the factors by which the map stretches it most and least: their ratio is the distortion, which
  /// is 1 where shapes are kept, and their product is the scale of areas
  std::vector<std::array<double, 2>> stretch;
  /// for each triangle, whether its side i, from corner i to the next, is a part of a cut: it has two images
  std::vector<std::array<bool, 3>> is_cut;
  /// the triangles of the mesh that are not counterclockwise in the plane: exactly
  std::vector<std::size_t> turned;
  /// whether all triangles of the ideal Delaunay triangulation keep their orientation, exactly, and go around each
  /// vertex once that is not on a cut: then the map on these triangles is locally injective
  bool is_certified = false;
  /// the largest difference of the lengths of the two images of an edge of a cut, and of the length in `metric`
  double seam = 0;
  /// whether two sides of the image's border have a common point that is no common end, exactly
  bool overlaps = false;
  /// for each halfedge of the input, the image of its source in its face; (0, 0) if it has none. A triangle that a cut
  /// crosses has the image that its largest part, extended linearly, gives it
  std::vector<Point> input_uv;
  std::vector<Face_index> turned_input;  ///< the input triangles that turn over if the map is linear on them: exactly
  std::vector<Face_index> divided_input; ///< the input triangles that a cut crosses

  /// \brief returns the image of a point of the input. O(number of triangles in its face).
  /// \exception Invalid_point_error if the halfedge is a border halfedge or out of range, or the coordinates are not
  ///   finite, negative, or all zero
  Point to_plane(const Surface_point& point) const;
  /// \brief returns a point of the input with a given image: if none has it, one whose image is near. O(number of
  /// triangles).
  /// \exception Invalid_point_error if a coordinate is not finite, or the map has no triangle
  Surface_point to_surface(const Point& point) const;

  /// \cond SKIP_IN_MANUAL
  Delta_complex input;
  std::vector<std::size_t> first_of_face; // of the triangles, which are in the order of the input faces
  std::array<double, 3> coordinates_in_face(const Surface_point& p, Face_index f) const;
  // In the affine coordinates in which the corners of the face are (0, 0), (1, 0) and (0, 1).
  Point in_face(const Surface_point& p, Face_index f) const;
  std::array<Point, 3> in_face(std::size_t triangle) const;
  // The image of such a point by the linear map of a triangle.
  Point extended(std::size_t triangle, const Point& p) const;
  /// \endcond
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CONFORMAL_MAP_H
