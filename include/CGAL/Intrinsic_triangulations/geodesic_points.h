// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The points of the input that an intrinsic edge passes.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_GEODESIC_POINTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_GEODESIC_POINTS_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/config.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \cond SKIP_IN_MANUAL
namespace internal {

// Appends the source of h, its crossings with input edges in order, and its target.
// \pre `geometry.prepare()` was called
void append_input_points(const internal::Exact_engine& engine, Halfedge_index h,
                         std::vector<Surface_point>& points);

} // namespace internal
/// \endcond

/// \ingroup PkgIntrinsicTriangulationsGeodesics
/// \brief returns the points of the input through which intrinsic halfedges run, one after the other.
///
/// These are their vertices, inserted ones as well, and all crossings with input edges. Each point but the last is given in the input face that
/// the line enters there, so that two consecutive points lie in that face. Crossings have a relative error of at most 2^-52
/// along their edge.
///
/// \param triangulation a triangulation that keeps its input
/// \param halfedges a range of halfedges, each of which begins where the one before ends
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

/// \ingroup PkgIntrinsicTriangulationsGeodesics
/// \brief returns the segments of an overlay along intrinsic halfedges, in order.
///
/// Segment i is edge i of the mesh that `overlay_to_surface_mesh()` returns: so a path can be marked there, and a seam cut along it.
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

/// \ingroup PkgIntrinsicTriangulationsGeodesics
/// \brief returns the point in space of a point of the input.
///
/// \param input the input, as returned by `Correspondence::input()`
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

} // namespace Intrinsic_triangulations
} // namespace CGAL

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/internal/geodesics/geodesic_points_impl.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_GEODESIC_POINTS_H
