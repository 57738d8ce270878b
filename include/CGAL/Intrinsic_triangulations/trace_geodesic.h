// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Straight lines over the surface, and the points that an edge or a path passes.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRACE_GEODESIC_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRACE_GEODESIC_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/named_parameters.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \addtogroup PkgIntrinsicTriangulationsGeodesics
/// @{

/// \brief where a traced line ends.
enum class Trace_status {
  AT_LENGTH,       ///< inside a face, or on an edge, after the requested length
  AT_BORDER,       ///< on a border edge
  AT_VERTEX,       ///< exactly at a vertex, where the continuation is not determined
  BUDGET_EXHAUSTED ///< after the maximum number of faces, where it enters the next one
};

/// \brief a straight line on the input, or on the current triangulation.
struct Traced_geodesic
{
  Trace_status status = Trace_status::AT_LENGTH; ///< where it ends
  Vertex_index vertex;                           ///< the vertex where it ends, or the null descriptor
  double length = 0;                             ///< its length, in the unit of the input
  /// its start, its entry into each face, and its end: each point but the last lies in the face that the line enters
  /// there
  std::vector<Surface_point> points;
};

namespace internal {
Traced_geodesic trace(const internal::Exact_engine& engine, const Surface_direction& start, double length,
                      std::size_t maximum_number);
Traced_geodesic trace_in_triangulation(const internal::Exact_engine& engine, const Surface_direction& start,
                                       double length, std::size_t maximum_number);
Surface_direction direction_at_vertex(const internal::Exact_engine& engine, Halfedge_index h, double angle);
} // namespace internal

/// \brief follows a straight line over the input faces.
///
/// Which edge the line crosses next, and whether it meets a vertex, is decided exactly for the given point and
/// direction. Only positions and lengths are rounded.
///
/// \param triangulation a triangulation that keeps its input; flips do not affect the line
/// \param start a point of the input and a direction. On an edge or at a vertex, the direction must not leave the face
/// \param length the length of the line, in the unit of the input
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{maximum_number}
///     \cgalParamDescription{the number of faces after which the line ends, at least one. Each takes memory, and near
///       the tip of a needle a short line can cross any number of them}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{no limit}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the line
/// \exception Invalid_argument_error if `length` is not finite or is negative
/// \exception Invalid_point_error if `start` is not finite, the point does not lie on the surface, or the direction
///   is zero or leaves the face at once
/// \exception Undecided_error, Cancelled_error as `sign_of_cotangent_weight()`
///
/// O(number of points) arithmetic operations, after the preparation of the exact geometry; tests too close for
/// double-doubles lay out the whole line once more.
template <class Traits, class NamedParameters = parameters::Default_named_parameters>
Traced_geodesic trace_geodesic(const Intrinsic_triangulation<Traits>& triangulation, const Surface_direction& start,
                               double length, const NamedParameters& np = parameters::default_values())
{
  return internal::trace(internal::engine(triangulation), start, length, std::size_t(internal::maximum_number_of(np)));
}

/// \brief follows the same line over the faces of the current triangulation.
///
/// The start is a point of the input, as for `trace_geodesic()`; the points and the vertex of the result belong to the
/// triangulation. An inserted vertex does not end the line, because the surface is flat there: the line continues in
/// another face at that vertex, with a point at the corner. On an edge of the triangulation, the line runs along one of
/// the two faces beside it.
///
/// Each decision is exact, as for `trace_geodesic()`, and needs the layout of the edges of a face: its cost is
/// proportional to the crossings of these edges.
///
/// \param triangulation the triangulation
/// \param start a point of the input and a direction, as for `trace_geodesic()`
/// \param length the length of the line, in the unit of the input
/// \param np as for `trace_geodesic()`; `maximum_number` counts faces of the triangulation
/// \return the line
/// \exception Invalid_point_error, Undecided_error, Cancelled_error as `trace_geodesic()`
template <class Traits, class NamedParameters = parameters::Default_named_parameters>
Traced_geodesic trace_geodesic_in_triangulation(const Intrinsic_triangulation<Traits>& triangulation,
                                                const Surface_direction& start, double length,
                                                const NamedParameters& np = parameters::default_values())
{
  return internal::trace_in_triangulation(internal::engine(triangulation), start, length,
                                          std::size_t(internal::maximum_number_of(np)));
}

/// \brief returns a direction at the source of an input halfedge.
///
/// \param triangulation a triangulation that keeps its input
/// \param h an input halfedge, whose direction is the angle 0
/// \param angle the angle in radians, counterclockwise from `h`, on the surface: the whole circle is the sum of the
///   angles of the faces at the vertex. Rounded by a few units in the last place
/// \exception Invalid_point_error if the angle is not finite, there is no such halfedge, or the angle leads beyond the
///   border
template <class Traits>
Surface_direction direction_at_vertex(const Intrinsic_triangulation<Traits>& triangulation, Halfedge_index h,
                                      double angle)
{
  return internal::direction_at_vertex(internal::engine(triangulation), h, angle);
}

namespace internal {

// Appends the source of h, its crossings with input edges in order, and its target.
// \pre `engine.prepare()` was called
void append_input_points(const internal::Exact_engine& engine, Halfedge_index h, std::vector<Surface_point>& points);

} // namespace internal

/// \brief returns the points of the input through which intrinsic halfedges run, one after the other.
///
/// These are their vertices, including inserted ones, and all crossings with input edges. Each point but the last is
/// given in the input face that the line enters there, so that it and the next point lie in that face. Crossings have a
/// relative error of at most 2^-52 along their edge.
///
/// \param triangulation a triangulation that keeps its input
/// \param halfedges a range of halfedges, each of which begins where the previous one ends
/// \exception Undecided_error if an edge crosses too many input edges to be laid out
///
/// O(number of points) arithmetic operations, after the preparation of the exact geometry.
template <class Traits, class HalfedgeRange>
std::vector<Surface_point> geodesic_points(const Intrinsic_triangulation<Traits>& triangulation,
                                           const HalfedgeRange& halfedges)
{
  std::vector<Surface_point> result;
  for (Halfedge_index h : halfedges) {
    if (!result.empty()) // the same vertex follows, in the face that is entered there
      result.pop_back();
    internal::append_input_points(internal::engine(triangulation), h, result);
  }
  return result;
}

/// \brief returns the segments of an overlay along intrinsic halfedges, in order.
///
/// Segment i is edge i of the mesh that `overlay_to_surface_mesh()` returns: so a path can be marked there, and a seam
/// cut along it.
/// \param overlay the overlay of the triangulation
/// \param complex the triangulation
/// \param halfedges a range of its halfedges
template <class HalfedgeRange>
std::vector<Overlay::Segment> geodesic_segments(const Overlay& overlay, const Delta_complex& complex,
                                                const HalfedgeRange& halfedges)
{
  std::vector<Overlay::Segment> result;
  for (Halfedge_index h : halfedges) {
    const auto first = std::ptrdiff_t(result.size());
    for (Overlay::Segment s : overlay.intrinsic_segments(complex.edge(h)))
      result.push_back(s);
    if (h != complex.halfedge(complex.edge(h)))
      std::reverse(result.begin() + first, result.end());
  }
  return result;
}

/// @}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRACE_GEODESIC_H
