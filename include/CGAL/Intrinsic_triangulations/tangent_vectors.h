// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Halfedges as vectors in tangent planes, and tangent vectors as vectors in space.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TANGENT_VECTORS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TANGENT_VECTORS_H

#include <CGAL/Intrinsic_triangulations/internal/engine/history/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Engine_numbers.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/triangle_formulas_3.h>

#include <CGAL/number_type_config.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

template <class Triangulation>
std::complex<double> halfedge_vector(const Triangulation& triangulation, Halfedge_index h, double direction)
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

// The direction of a halfedge at its source, which is not on the border: the angle from the first axis, before scaling.
inline double direction_on_input(const internal::Exact_engine& engine, Halfedge_index h)
{
  const Delta_complex& complex = engine.connectivity();
  const internal::Correspondence& correspondence = engine.correspondence();
  const Delta_complex& input = correspondence.input();
  const Vertex_index v = complex.source(h);
  const internal::Engine_numbers numbers(engine);
  const auto begin = numbers.edge_beginning(h);
  double sum = std::arg(begin.vector);
  if (!correspondence.is_inserted(v)) {
    for (Halfedge_index side = first_axis(input, v); side != begin.reference; side = input.next_around_source(side))
      sum += numbers.input_angle(side);
    return sum;
  }
  // From a side of the face to the next one, the direction turns left by π minus the angle between them.
  const auto turn = [&](Halfedge_index& side) {
    side = input.next(side);
    return CGAL_PI - numbers.input_angle(side);
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
std::pair<Halfedge_index, double> halfedge_with_direction(const Intrinsic_triangulation<Traits>& triangulation,
                                                          Vertex_index v)
{
  const Delta_complex& complex = triangulation.connectivity();
  if constexpr (Intrinsic_triangulation<Traits>::uses_exact_geometry) {
    const internal::Exact_engine& engine = internal::engine(triangulation);
    const internal::Correspondence& correspondence = engine.correspondence();
    const Halfedge_index first = complex.opposite(complex.halfedge(v));
    if (complex.is_border(complex.halfedge(v)) && !correspondence.is_inserted(v))
      return {first, 0};
    Halfedge_index best = first; // the one with the fewest crossings; -1 means that it lies on an input edge
    const auto crossings = [&](Halfedge_index h) { return correspondence.coordinates().crossings(complex.edge(h)); };
    for_each_halfedge_from(complex, v, [&](Halfedge_index h) { best = crossings(h) < crossings(best) ? h : best; });
    return {best, direction_on_input(engine, best)};
  } else {
    return {first_axis(complex, v), 0};
  }
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsAngles
/// \brief returns each halfedge as a vector in the tangent plane of its source.
///
/// In polar coordinates, the radius is the length of the edge. The angle is measured counterclockwise from the first
/// axis, and scaled so that the angles around the vertex sum to 2π. On the border it is not scaled, because the faces
/// there can be laid out in a plane. If the cone angle of the vertex is zero, all angles are zero.
///
/// With traits that use exact geometry, the first axis belongs to the input, so that a vector remains valid after flips
/// and insertions. It is the input halfedge with the smallest number that leaves the vertex; on the border, the
/// halfedge from which the faces follow counterclockwise; at an inserted vertex, the halfedge of its location. With
/// other traits, the same rule selects a halfedge of the current triangulation.
///
/// \param triangulation the triangulation
/// \return a vector for each halfedge, in their order, with an error of at most 2^-45 + 2^-49 n of its length for n
///   faces at the vertex, in the input or now; with traits without exact geometry, with the error of their lengths and
///   cotangents
/// \exception Undecided_error as `angle()`. O(size + crossings of one edge at each vertex).
///
/// Source: F. Knöppel, K. Crane, U. Pinkall, P. Schröder, "Globally optimal direction fields" (2013).
template <class Traits>
std::vector<std::complex<double>> halfedge_vectors_in_vertex(const Intrinsic_triangulation<Traits>& triangulation)
{
  const Delta_complex& complex = triangulation.connectivity();
  std::vector<std::complex<double>> result(complex.number_of_halfedges(), {0, 0});
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
/// \param triangulation the triangulation
/// \return a vector for each halfedge, in their order, with an error of at most 2^-46 of its length, or with the error
///   of their lengths and cotangents for traits without exact geometry; (0, 0) for a border halfedge
/// \exception Undecided_error as `angle()`. O(size).
template <class Traits>
std::vector<std::complex<double>> halfedge_vectors_in_face(const Intrinsic_triangulation<Traits>& triangulation)
{
  const Delta_complex& complex = triangulation.connectivity();
  std::vector<std::complex<double>> result(complex.number_of_halfedges(), {0, 0});
  for (Face_index f : complex.faces()) {
    const Halfedge_index first = complex.halfedge(f), next = complex.next(first), prev = complex.prev(first);
    const double at_source = angle(triangulation, next), at_target = angle(triangulation, prev);
    result[first.idx()] = internal::halfedge_vector(triangulation, first, 0);
    result[next.idx()] = internal::halfedge_vector(triangulation, next, CGAL_PI - at_target);
    result[prev.idx()] = internal::halfedge_vector(triangulation, prev, CGAL_PI + at_source);
  }
  return result;
}

/// \ingroup PkgIntrinsicTriangulationsAngles
/// \brief the tangent plane of a vertex in space: three unit vectors at right angles, counterclockwise.
struct Vertex_frame
{
  std::array<double, 3> x;      ///< the first axis
  std::array<double, 3> y;      ///< the second axis, to the left of the first
  std::array<double, 3> normal; ///< the normal, toward the side from which faces are counterclockwise

  /// returns a tangent vector in space.
  std::array<double, 3> in_space(const std::complex<double>& v) const
  {
    return {v.real() * x[0] + v.imag() * y[0], v.real() * x[1] + v.imag() * y[1], v.real() * x[2] + v.imag() * y[2]};
  }
};

namespace internal {

using Space_vector = Vector_3<double>;

// Zero remains zero; short and long vectors are scaled first.
inline Space_vector normalized(Space_vector a)
{
  const double largest = (std::max)({std::abs(a[0]), std::abs(a[1]), std::abs(a[2])});
  if (!(largest > 0))
    return {0, 0, 0};
  for (double& x : a)
    x /= largest;
  const double length = std::sqrt(scalar_product(a, a));
  for (double& x : a)
    x /= length;
  return a;
}

// From the normal and a vector that is not parallel to it; zero or parallel vectors are replaced.
inline Vertex_frame frame_of(Space_vector normal, const Space_vector& first)
{
  const auto any_perpendicular = [](const Space_vector& a) {
    const std::size_t smallest = std::size_t(
      std::min_element(a.begin(), a.end(), [](double s, double t) { return std::abs(s) < std::abs(t); }) - a.begin());
    Space_vector axis{0, 0, 0};
    axis[smallest] = 1;
    return normalized(cross_product(a, axis));
  };
  normal = normalized(normal);
  const Space_vector along = normalized(first);
  if (scalar_product(normal, normal) == 0)
    normal = scalar_product(along, along) == 0 ? Space_vector{0, 0, 1} : any_perpendicular(along);
  Space_vector y = normalized(cross_product(normal, along));
  if (scalar_product(y, y) == 0)
    y = any_perpendicular(normal);
  return {cross_product(y, normal), y, normal};
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsAngles
/// \brief returns the tangent planes of `halfedge_vectors_in_vertex()` in space, for drawing.
///
/// The normal of a vertex is the mean normal of the input faces around it, weighted by their angles. The first axis of
/// its frame is the first axis of `halfedge_vectors_in_vertex()`, projected to the plane. Frames depend on the input
/// alone. Where the surface is bent, a vector in the plane represents a direction on the surface; where it is flat,
/// both are the same.
///
/// \param triangulation its traits have to use exact geometry
/// \param points a random access range of the points of the input vertices, each with three coordinates
/// \return a rounded frame for each vertex, including inserted ones; an arbitrary frame for a vertex without faces of
/// positive area. O(size).
template <class Traits, class PointRange>
std::vector<Vertex_frame> vertex_frames(const Intrinsic_triangulation<Traits>& triangulation, const PointRange& points)
{
  static_assert(Intrinsic_triangulation<Traits>::uses_exact_geometry,
                "vertex_frames() needs traits with exact engine, as Filtered_edge_length_traits");
  const internal::Correspondence& correspondence = internal::engine(triangulation).correspondence();
  const Delta_complex& input = correspondence.input();
  using internal::Space_vector;
  const auto along = [&](Halfedge_index h) {
    Space_vector result;
    const auto &p = points[input.source(h).idx()], &q = points[input.target(h).idx()];
    for (int i = 0; i < 3; ++i)
      result[i] = CGAL::to_double(q[i]) - CGAL::to_double(p[i]);
    return internal::normalized(result);
  };
  std::vector<Space_vector> normals(input.number_of_vertices(), {0, 0, 0}), face_normals;
  face_normals.reserve(input.number_of_faces());
  for (Face_index f : input.faces()) {
    const Halfedge_index h = input.halfedge(f);
    const std::array<Halfedge_index, 3> sides{h, input.next(h), input.prev(h)};
    const std::array<Space_vector, 3> vectors{along(sides[0]), along(sides[1]), along(sides[2])};
    face_normals.push_back(internal::normalized(internal::cross_product(vectors[0], vectors[1])));
    for (std::size_t i = 0; i < 3; ++i) {
      const Space_vector turned = internal::cross_product(vectors[i], vectors[(i + 2) % 3]);
      const double angle = std::atan2(std::sqrt(internal::scalar_product(turned, turned)),
                                      -internal::scalar_product(vectors[i], vectors[(i + 2) % 3]));
      for (std::size_t k = 0; k < 3; ++k)
        normals[input.source(sides[i]).idx()][k] += angle * face_normals.back()[k];
    }
  }
  std::vector<Vertex_frame> result;
  result.reserve(triangulation.connectivity().number_of_vertices());
  for (Vertex_index v : triangulation.connectivity().vertices()) {
    if (correspondence.is_inserted(v)) {
      const Surface_point& location = correspondence.location(v);
      Space_vector normal = face_normals[input.face(location.halfedge).idx()];
      if (location.dimension() == 1) {
        const Halfedge_index other = input.opposite(internal::side_of(input, location));
        if (!input.is_border(other))
          for (std::size_t k = 0; k < 3; ++k)
            normal[k] += face_normals[input.face(other).idx()][k];
      }
      result.push_back(internal::frame_of(normal, along(location.halfedge)));
    } else if (input.halfedge(v).is_valid()) {
      result.push_back(internal::frame_of(normals[v.idx()], along(internal::first_axis(input, v))));
    } else {
      result.push_back(internal::frame_of({0, 0, 1}, {1, 0, 0}));
    }
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TANGENT_VECTORS_H
