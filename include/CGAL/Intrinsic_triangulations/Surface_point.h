// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A point of a triangulated surface, a direction there, interpolation of vertex data, and whether two points are the
// same.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SURFACE_POINT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SURFACE_POINT_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Index.h>

#include <CGAL/enum.h>
#include <CGAL/number_type_basic.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsTransfer
///
/// \brief a point of a triangulated surface: three barycentric coordinates in a face.
///
/// The coordinates belong, in this order, to the source of `halfedge`, to its target and to the
/// third corner of the face to its left. A halfedge tells the corners apart even if they
/// are the same vertex, and it does not depend on the choice of `halfedge(f)`. Coordinates are
/// not negative. They need not sum to 1, but those that the package returns do, up to rounding.
///
/// A point with one zero coordinate lies on an edge, a point with two zeros at a vertex.
struct Surface_point
{
  Halfedge_index halfedge;           ///< a halfedge of the face; not a border halfedge
  std::array<double, 3> coordinates; ///< of source, target and third corner

  /// returns 0 for a point at a vertex, 1 for a point on an edge, 2 for one inside of a face.
  int dimension() const
  {
    int positive = 0;
    for (double x : coordinates)
      positive += x > 0 ? 1 : 0;
    return positive - 1;
  }
};

/// \ingroup PkgIntrinsicTriangulationsGeodesics
/// \brief a point of the input, and a direction in its face.
struct Surface_direction
{
  Surface_point point; ///< where a line begins
  /// by how much the barycentric coordinates of the target and of the third corner grow in this direction, in any unit;
  /// the coordinate of the source falls by their sum
  std::array<double, 2> displacement;
};

/// \ingroup PkgIntrinsicTriangulationsGeodesics
/// \brief returns the coordinates of `point` relative to another halfedge of its face.
/// \pre `first` is a side of the face of `point.halfedge`
std::array<double, 3> coordinates_from(const Delta_complex& complex, const Surface_point& point, Halfedge_index first);

namespace internal {

// A piece of a triangle (i, j, k) of the current triangulation, between the input edges that cross it.
//
// It is named by a part of a side: the part after `gap` crossings of `side`, counted from its source. A piece that
// touches several sides has several names.
struct Triangle_piece
{
  Halfedge_index side; // a halfedge of the triangle
  std::int64_t gap;    // from 0 to the number of crossings of its edge
};

// Barycentric coordinates, divided by their sum.
std::array<double, 3> with_sum_one(const std::array<double, 3>& coordinates);

// The same, without positive ones below 2⁻⁴⁰: a point lies on an edge that rounding may have moved it off. Slivers
// between them would have sides whose lengths are rounded to nothing.
std::array<double, 3> on_near_edges(std::array<double, 3> coordinates);

// The side on which a point on an edge lies.
Halfedge_index side_of(const Delta_complex& complex, const Surface_point& point);

// The coordinates of a point on an edge relative to the ends of a halfedge of that edge.
std::pair<double, double> coordinates_on_edge(const Delta_complex& complex, const Surface_point& point,
                                              Halfedge_index along);

// The coordinates of a point relative to h and the two other sides of its face; whether it lies there.
bool find_coordinates(const Delta_complex& complex, Halfedge_index h, const Surface_point& p,
                      std::array<double, 3>& result);

// The sign of a b − c d for finite nonnegative numbers; nothing over- or underflows.
Sign compare_products(double a, double b, double c, double d);

// Whether two points of the same face are the same.
bool are_same_points(const Delta_complex& complex, const Surface_point& p, const Surface_point& q);

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsTransfer
/// \brief returns the value at a point of the piecewise linear function with given values at the
/// vertices.
///
/// \param complex the triangulation that contains the point
/// \param values a random access range with a value for each vertex; values can be added and
///   multiplied by a `double` from the left
/// \param point the point; its coordinates sum to 1
template <class VertexValues>
auto interpolate(const Delta_complex& complex, const VertexValues& values, const Surface_point& point)
{
  const Halfedge_index h = point.halfedge;
  const auto& [a, b, c] = point.coordinates;
  using Value = std::decay_t<decltype(values[0])>;
  return Value(a * values[complex.source(h).idx()] + b * values[complex.target(h).idx()] +
               c * values[complex.target(complex.next(h)).idx()]);
}

/// \ingroup PkgIntrinsicTriangulationsGeodesics
/// \brief returns the point in space of a point of the input.
///
/// \param input the input, as returned by `Intrinsic_triangulation::input()`
/// \param points a random access range of the points of the vertices, each with three coordinates
/// \param p a point whose coordinates sum to 1
/// \return its coordinates, each within a few units in the last place of the largest at the corners of the face
template <class PointRange>
std::array<double, 3> point_in_space(const Delta_complex& input, const PointRange& points, const Surface_point& p)
{
  const Halfedge_index h = p.halfedge;
  const Vertex_index corners[] = {input.source(h), input.target(h), input.target(input.next(h))};
  std::array<double, 3> result{0, 0, 0};
  for (int c = 0; c < 3; ++c)
    if (p.coordinates[c] != 0)
      for (int i = 0; i < 3; ++i)
        result[i] += p.coordinates[c] * CGAL::to_double(points[corners[c].idx()][i]);
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SURFACE_POINT_H
