// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Halfedges as vectors in the tangent planes of vertices and faces.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_HALFEDGE_VECTORS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_HALFEDGE_VECTORS_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Planar_vector.h>
#include <CGAL/Intrinsic_triangulations/angles.h>

#include <CGAL/number_type_config.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \cond SKIP_IN_MANUAL
namespace internal {

template <class Triangulation>
Planar_vector<double> halfedge_vector(const Triangulation& triangulation, Halfedge_index h, double direction)
{
  const double length = CGAL::to_double(triangulation.length(triangulation.connectivity().edge(h)));
  return {length * std::cos(direction), length * std::sin(direction)};
}

} // namespace internal
/// \endcond

/// \ingroup PkgIntrinsicTriangulationsAngles
/// \brief returns each halfedge as a vector in the tangent plane of its source.
///
/// In polar coordinates, the radius is the length of the edge. The angle is that from a first halfedge, counterclockwise,
/// scaled so that the angles around the vertex sum to 2π, or to π on the border. The first halfedge is
/// `opposite(halfedge(v))`; on the border, this is the halfedge from which the faces at v follow counterclockwise. If
/// the cone angle of the vertex is zero, all angles are.
///
/// \return a vector for each halfedge, in their order, with an error of at most 2^-45 + 2^-49 n of its length for n faces
///   at the vertex; with traits without exact geometry, an error as that of their lengths and cotangents
/// \exception Undecided_error as `angle()`. O(size).
///
/// Source: F. Knöppel, K. Crane, U. Pinkall, P. Schröder, "Globally optimal direction fields" (2013).
template <class Traits>
std::vector<Planar_vector<double>> halfedge_vectors_in_vertex(const Intrinsic_triangulation<Traits>& triangulation)
{
  const Delta_complex& complex = triangulation.connectivity();
  std::vector<Planar_vector<double>> result(complex.number_of_halfedges(), {0, 0});
  std::vector<std::pair<Halfedge_index, double>> directions;
  for (Vertex_index v : complex.vertices()) {
    directions.clear();
    double sum = 0, whole = 2 * CGAL_PI;
    internal::for_each_halfedge_from(complex, v, [&](Halfedge_index h) {
      directions.emplace_back(h, sum);
      if (complex.is_border(h))
        whole = CGAL_PI;
      else
        sum += angle(triangulation, complex.next(h));
    });
    const double scale = sum > 0 ? whole / sum : 0;
    for (const auto& [h, direction] : directions)
      result[h.idx()] = internal::halfedge_vector(triangulation, h, scale * direction);
  }
  return result;
}

/// \ingroup PkgIntrinsicTriangulationsAngles
/// \brief returns each halfedge as a vector in the plane of its face.
///
/// The face lies to the left of its halfedges, and `halfedge(f)` has the direction (1, 0). The vectors of a face
/// sum to zero, and in a face of zero area all lie on the first axis, up to rounding.
///
/// \return a vector for each halfedge, in their order, with an error of at most 2^-46 of its length, or with traits without
///   exact geometry, an error as that of their lengths and cotangents; (0, 0) for a border halfedge
/// \exception Undecided_error as `angle()`. O(size).
template <class Traits>
std::vector<Planar_vector<double>> halfedge_vectors_in_face(const Intrinsic_triangulation<Traits>& triangulation)
{
  const Delta_complex& complex = triangulation.connectivity();
  std::vector<Planar_vector<double>> result(complex.number_of_halfedges(), {0, 0});
  for (Face_index f : complex.faces()) {
    const Halfedge_index first = complex.halfedge(f), next = complex.next(first), prev = complex.prev(first);
    const double at_source = angle(triangulation, next), at_target = angle(triangulation, prev);
    result[first.idx()] = internal::halfedge_vector(triangulation, first, 0);
    result[next.idx()] = internal::halfedge_vector(triangulation, next, CGAL_PI - at_target);
    result[prev.idx()] = internal::halfedge_vector(triangulation, prev, CGAL_PI + at_source);
  }
  return result;
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_HALFEDGE_VECTORS_H
