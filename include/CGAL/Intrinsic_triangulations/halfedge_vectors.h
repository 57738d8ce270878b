// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Halfedges as vectors in the tangent planes of vertices and faces.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_HALFEDGE_VECTORS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_HALFEDGE_VECTORS_H

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Exact_geometry.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Planar_vector.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>

#include <CGAL/number_type_config.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <complex>
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

// The halfedge that is the first axis of the tangent plane of an input vertex that has a face.
inline Halfedge_index first_axis(const Delta_complex& input, Vertex_index v)
{
  const Halfedge_index first = input.opposite(input.halfedge(v));
  Halfedge_index result = first;
  if (input.is_border(input.halfedge(v)))
    return first;
  for (Halfedge_index h = input.next_around_source(first); h != first; h = input.next_around_source(h))
    result = (std::min)(result, h);
  return result;
}

// The direction of a halfedge at its source, which is no vertex of the border: the angle from the first axis, before it is scaled.
inline double direction_on_input(const Delta_complex& complex, const Exact_geometry& geometry, Halfedge_index h)
{
  const Correspondence& correspondence = geometry.correspondence();
  const Delta_complex& input = correspondence.input();
  const Vertex_index v = complex.source(h);
  const auto begin = geometry.edge_beginning(complex, h);
  double sum = std::arg(begin.vector);
  if (!correspondence.is_inserted(v)) {
    for (Halfedge_index side = first_axis(input, v); side != begin.reference; side = input.next_around_source(side))
      sum += geometry.input_angle(side);
    return sum;
  }
  // From a side of the face to the next one, one turns left by π minus the angle between them.
  const auto turn = [&](Halfedge_index& side) {
    side = input.next(side);
    return CGAL_PI - geometry.input_angle(side);
  };
  const Surface_point& location = correspondence.location(v);
  Halfedge_index side = location.halfedge;
  if (input.face(side) != input.face(begin.reference)) {
    for (const Halfedge_index along = side_of(input, location); side != along;)
      sum += turn(side);
    side = input.opposite(side);
    sum += CGAL_PI;
  }
  while (side != begin.reference)
    sum += turn(side);
  return sum;
}

// As above, for one of the halfedges that leave v.
template <class Traits>
std::pair<Halfedge_index, double> halfedge_with_direction(const Intrinsic_triangulation<Traits>& triangulation, Vertex_index v)
{
  const Delta_complex& complex = triangulation.connectivity();
  const Halfedge_index first = complex.opposite(complex.halfedge(v));
  if constexpr (Intrinsic_triangulation<Traits>::uses_exact_geometry) {
    const Exact_geometry& geometry = triangulation.exact_geometry();
    const Correspondence& correspondence = geometry.correspondence();
    if (complex.is_border(complex.halfedge(v)) && !correspondence.is_inserted(v))
      return {first, 0};
    Halfedge_index best = first; // that with the fewest crossings: -1 means that it lies on an edge of the input
    const auto crossings = [&](Halfedge_index h) { return correspondence.coordinates().crossings(complex.edge(h)); };
    for_each_halfedge_from(complex, v, [&](Halfedge_index h) { best = crossings(h) < crossings(best) ? h : best; });
    return {best, direction_on_input(complex, geometry, best)};
  } else {
    const Halfedge_index axis = first_axis(complex, v);
    return {axis, 0};
  }
}

} // namespace internal
/// \endcond

/// \ingroup PkgIntrinsicTriangulationsAngles
/// \brief returns each halfedge as a vector in the tangent plane of its source.
///
/// In polar coordinates, the radius is the length of the edge. The angle is that from the first axis, counterclockwise,
/// scaled so that the angles around the vertex sum to 2π. On the border it is not scaled: the faces there can be laid out in a plane as they
/// are. If the cone angle of the vertex is zero, all angles are.
///
/// With traits that use exact geometry, the first axis belongs to the input, so that a vector remains the same whatever is flipped or
/// inserted elsewhere. It is the first halfedge of the input that leaves the vertex, by its number, or on the border that from which the
/// faces follow counterclockwise; at an inserted vertex, the halfedge of its location. With other traits, it is such a halfedge of the
/// current triangulation.
///
/// \return a vector for each halfedge, in their order, with an error of at most 2^-45 + 2^-49 n of its length for n faces
///   at the vertex, in the input or now; with traits without exact geometry, an error as that of their lengths and cotangents
/// \exception Undecided_error as `angle()`. O(size), and the crossings of one edge at each vertex.
///
/// Source: F. Knöppel, K. Crane, U. Pinkall, P. Schröder, "Globally optimal direction fields" (2013).
template <class Traits>
std::vector<Planar_vector<double>> halfedge_vectors_in_vertex(const Intrinsic_triangulation<Traits>& triangulation)
{
  const Delta_complex& complex = triangulation.connectivity();
  std::vector<Planar_vector<double>> result(complex.number_of_halfedges(), {0, 0});
  std::vector<std::pair<Halfedge_index, double>> directions;
  for (Vertex_index v : complex.vertices()) {
    if (!complex.halfedge(v).is_valid())
      continue;
    directions.clear();
    const std::pair<Halfedge_index, double> known = internal::halfedge_with_direction(triangulation, v);
    double sum = 0, at_known = 0;
    bool is_on_border = false;
    internal::for_each_halfedge_from(complex, v, [&](Halfedge_index h) {
      directions.emplace_back(h, sum);
      if (h == known.first)
        at_known = sum;
      if (complex.is_border(h))
        is_on_border = true;
      else
        sum += angle(triangulation, complex.next(h));
    });
    const double scale = is_on_border || sum == 0 ? 1 : 2 * CGAL_PI / sum;
    for (const auto& [h, direction] : directions)
      result[h.idx()] = internal::halfedge_vector(triangulation, h, scale * (direction - at_known + known.second));
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
