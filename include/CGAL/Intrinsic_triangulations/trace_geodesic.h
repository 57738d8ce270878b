// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A straight line on a surface from a point in a direction: the exponential map.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRACE_GEODESIC_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRACE_GEODESIC_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/config.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsGeodesics
/// \brief where a traced line ends.
enum class Trace_status {
  AT_LENGTH,       ///< inside of a face, or on an edge, after the length that was asked for
  AT_BORDER,       ///< on a border edge
  AT_VERTEX,       ///< exactly in a vertex, where it is not determined how to go on
  BUDGET_EXHAUSTED ///< after the largest number of faces, where it enters the next one
};

/// \ingroup PkgIntrinsicTriangulationsGeodesics
/// \brief a straight line on the input, or on the current triangulation.
struct Traced_geodesic
{
  Trace_status status = Trace_status::AT_LENGTH; ///< where it ends
  Vertex_index vertex;                           ///< the vertex where it ends, or the null descriptor
  double length = 0;                             ///< its length, in the unit of the input
  /// where it begins, where it enters each face, and where it ends: each point but the last in the face that the line enters there
  std::vector<Surface_point> points;
};

/// \cond SKIP_IN_MANUAL
namespace internal {
Traced_geodesic trace(const Exact_engine& engine, const Surface_direction& start, double length, std::size_t maximum_number);
Traced_geodesic trace_in_triangulation(const Exact_engine& engine, const Surface_direction& start, double length,
                                       std::size_t maximum_number);
Surface_direction direction_at_vertex(const Exact_engine& engine, Halfedge_index h, double angle);
} // namespace internal
/// \endcond

/// \ingroup PkgIntrinsicTriangulationsGeodesics
/// \brief follows a straight line over the input faces.
///
/// Which edge the line crosses next, and whether it meets a vertex, is decided exactly for the point and the direction as they are
/// given. Only positions and lengths are rounded.
///
/// \param triangulation a triangulation that keeps its input; flips change nothing
/// \param start a point of the input and a direction. On an edge or at a vertex, the direction must not leave the face
/// \param length how far to go, in the unit of the input
/// \param maximum_number after how many faces the line ends at the latest, at least one. Each takes memory: near the tip of a needle, a short
///   line can cross any number of them
/// \return the line
/// \exception Invalid_point_error if `start` or `length` is not finite, the point does not lie on the surface, or the direction
///   is zero or leaves the face at once
/// \exception Undecided_error, Cancelled_error as `sign_of_cotangents()` of `Exact_geometry`
///
/// O(number of points) arithmetic operations, after the preparation of the exact geometry; tests too close for double-doubles lay
/// out the whole line once more.
template <class Traits>
Traced_geodesic trace_geodesic(const Intrinsic_triangulation<Traits>& triangulation, const Surface_direction& start,
                               double length, std::size_t maximum_number = (std::numeric_limits<std::size_t>::max)())
{
  return internal::trace(internal::engine(triangulation), start, length, maximum_number);
}

/// \ingroup PkgIntrinsicTriangulationsGeodesics
/// \brief follows the same line over the faces of the current triangulation.
///
/// The start is a point of the input, as for `trace_geodesic()`; the points of the result, and its vertex, are those of the triangulation. An
/// inserted vertex does not end the line, since the surface is flat there: the line goes on in another face at that vertex, with a point at the corner.
/// On an edge of the triangulation, the line runs along one of the two faces beside it.
///
/// Each decision is exact, as for `trace_geodesic()`, and needs the layout of the edges of a face: its cost is that of the crossings of these edges.
///
/// \param triangulation the triangulation
/// \param start a point of the input and a direction, as for `trace_geodesic()`
/// \param length how far to go, in the unit of the input
/// \param maximum_number as for `trace_geodesic()`, of faces of the triangulation
/// \return the line
/// \exception Invalid_point_error, Undecided_error, Cancelled_error as `trace_geodesic()`
template <class Traits>
Traced_geodesic trace_geodesic_in_triangulation(const Intrinsic_triangulation<Traits>& triangulation, const Surface_direction& start,
                                                double length,
                                                std::size_t maximum_number = (std::numeric_limits<std::size_t>::max)())
{
  return internal::trace_in_triangulation(internal::engine(triangulation), start, length, maximum_number);
}

/// \ingroup PkgIntrinsicTriangulationsGeodesics
/// \brief returns a direction at the source of an input halfedge.
///
/// \param triangulation a triangulation that keeps its input
/// \param h an input halfedge, whose direction is the angle 0
/// \param angle the angle in radians, counterclockwise from `h`, on the surface: the whole circle is the sum of the angles
///   of the faces at the vertex. Rounded by a few units in the last place
/// \exception Invalid_point_error if the angle is not finite, there is no such halfedge, or the angle leads beyond the border
template <class Traits>
Surface_direction direction_at_vertex(const Intrinsic_triangulation<Traits>& triangulation, Halfedge_index h, double angle)
{
  return internal::direction_at_vertex(internal::engine(triangulation), h, angle);
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/internal/geodesics/trace_geodesic_impl.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRACE_GEODESIC_H
