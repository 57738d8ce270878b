// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Where the shortest path from a curve to a vertex begins.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_NEAREST_SOURCE_POINT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_NEAREST_SOURCE_POINT_H

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Geodesic_source.h>
#include <CGAL/Intrinsic_triangulations/Index.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Point_location.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/geodesic_distances.h>
#include <CGAL/Intrinsic_triangulations/internal/distances/Curve_sources.h>
#include <CGAL/Intrinsic_triangulations/internal/distances/Laid_out_faces.h>
#include <CGAL/Intrinsic_triangulations/internal/distances/Window_propagation.h>
#include <CGAL/Intrinsic_triangulations/internal/matrices/Row_of_vertex.h>
#include <CGAL/Intrinsic_triangulations/internal/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>
#include <CGAL/Intrinsic_triangulations/observer.h>

#include <cmath>
#include <cstdint>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// A point of the faces.
Surface_point beginning_of_way(const Laid_out_faces& faces, const Window_distances& windows, std::uint32_t row);

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief the result of `nearest_source_point()`.
struct Nearest_source_point
{
  Surface_point point;     ///< of the input, rounded
  double distance = 0;     ///< from there, up to rounding, in the unit of the input
  bool is_complete = true; ///< whether it is known to be the nearest one
};

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief returns the point of some curves that is nearest to a vertex: `shortest_path()` to there, after
/// `vertex_at_point()`, leads to the curves at a right angle or to one of their corners.
///
/// \param triangulation a triangulation that keeps its input, preferably Delaunay
/// \param v a vertex, which may be an inserted one
/// \param curves parts of the input; the offset has no effect
/// \param np the named parameters of `geodesic_distances()`, except for the tolerance
/// \exception Invalid_argument_error if there is no such vertex, or no path from there to the curves
///
/// O(size) beside the ways, because the point is looked up in the overlay with the input.
/// \exception Invalid_point_error, Cancelled_error, Undecided_error as `geodesic_distances_from()`
template <class Traits, class NamedParameters = parameters::Default_named_parameters>
Nearest_source_point nearest_source_point(const Intrinsic_triangulation<Traits>& triangulation, Vertex_index v,
                                          Geodesic_source curves,
                                          const NamedParameters& np = parameters::default_values())
{
  const Delta_complex& complex = triangulation.connectivity();
  const internal::Row_of_vertex row(complex);
  internal::require_vertex(v, row.number_of_rows());
  const internal::Laid_out_faces faces(triangulation, row);
  curves.offset = 0;
  const internal::Window_distances windows = internal::propagate_windows(
    faces, 0, internal::sources_in_faces(internal::engine(triangulation), complex, faces, {curves}),
    internal::number_of_ways(np, complex), internal::Interruption(internal::go_further_function_of(np)), {v.idx()});
  if (!std::isfinite(windows.distances[v.idx()]))
    throw Invalid_argument_error("no path leads from vertex " + std::to_string(v.idx()) + " to the curve");
  const Surface_point point = internal::beginning_of_way(faces, windows, v.idx());
  const Common_subdivision subdivision(triangulation);
  return {Point_location(subdivision).intrinsic_to_input(point),
          std::ldexp(windows.distances[v.idx()], faces.exponent()), windows.is_complete};
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_NEAREST_SOURCE_POINT_H
