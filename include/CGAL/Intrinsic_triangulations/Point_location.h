// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Maps points of one surface to the other, and finds the point of a surface that is nearest to a point in space.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_POINT_LOCATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_POINT_LOCATION_H

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Index.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/triangle_formulas_3.h>
#include <CGAL/Intrinsic_triangulations/internal/positions/affine_image.h>
#include <CGAL/Intrinsic_triangulations/internal/positions/overlay_layers.h>
#include <CGAL/Intrinsic_triangulations/internal/positions/overlay_search.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsTransfer
///
/// \brief maps points of the input to the intrinsic triangulation, and back.
///
/// Whether a point is a vertex, lies on an edge, or inside a face is decided exactly. The
/// coordinates of the query are taken as rational numbers and divided by their sum. The side of an edge on which the
/// point lies is the sign of an exact real number, found in stages like a Delaunay test. So a result has a zero
/// coordinate exactly if the point lies on an edge, and two exactly if it is a vertex. In and beside faces of zero
/// area, several points of the faces are one point of the surface; there, the result may also be a point inside a face
/// beside that edge. Nonzero coordinates of results are rounded: the result lies within a few units in the last place
/// of the longest edge of either face from the exact point.
///
/// A query searches the edges that cross a face by bisection. It costs O(log n) for n such edges, unless the point is
/// so close to one of them that `double` cannot tell the side. Then the strip of input triangles that the edge crosses
/// is laid out. In an input face with inserted vertices it walks from piece to piece, in O(number of pieces) at most.
///
/// No array is built except for a bit for each input face if vertices were inserted, because the overlay stores the
/// edges that cross a face in order.
class Point_location
{
public:
  /// \brief constructs the map. O(1).
  ///
  /// \param subdivision the common subdivision, which must outlive the map and stay where it is
  explicit Point_location(const Common_subdivision& subdivision)
    : input_(subdivision), intrinsic_(subdivision), correspondence_(input_.engine.correspondence())
  {
    if (correspondence_.number_of_inserted_vertices() != 0)
      note_inserted_vertices();
  }
  /// \cond SKIP_IN_MANUAL
  explicit Point_location(const Common_subdivision&&) = delete; // does not outlive the map
  /// \endcond

  /// \brief returns the position of a point of the input in the intrinsic triangulation.
  ///
  /// \param point a point of the input: its coordinates and a halfedge of `Common_subdivision::input()`,
  ///   which is the halfedge with the same number in the original input
  /// \return a vertex as a `halfedge` with this source and coordinates (1, 0, 0); a point on an edge with
  ///   the third coordinate zero; a point in a face with three positive coordinates
  /// \exception Invalid_point_error if the halfedge is a border halfedge or out of range, or the
  ///   coordinates are not finite, negative, or all zero
  /// \exception Undecided_error as `sign_of_cotangent_weight()`
  Surface_point input_to_intrinsic(const Surface_point& point) const
  {
    const Surface_point p = checked(input_.complex, point);
    if (!has_inserted_.empty() && p.dimension() > 0 && has_inserted_[input_.complex.face(p.halfedge).idx()])
      return beside_inserted_vertices(p);
    return map(input_, intrinsic_, p);
  }

  /// \brief returns the position of a point of the intrinsic triangulation in the input; as
  /// `input_to_intrinsic()`, but in the other direction.
  Surface_point intrinsic_to_input(const Surface_point& point) const
  {
    return map(intrinsic_, input_, checked(intrinsic_.complex, point));
  }

private:
  using Coordinates = internal::Coordinates;

  template <class From, class To>
  static Surface_point map(const From& from, const To& to, const Surface_point& point)
  {
    if (point.dimension() == 0)
      return at_vertex(from, to, point);
    if (point.dimension() == 1) {
      const Overlay::Halfedge part = from.part(internal::side_of(from.complex, point), 0);
      if (from.overlay.label(from.overlay.segment(part)) == Segment_label::BOTH)
        return on_common_edge(from, to, part, point);
    }
    const auto found = internal::Chord_search<From>(from, point)();
    return found.is_on_chord ? on_chord(from, to, found.part, point)
                             : in_face(from, to, from.overlay.face(found.part), point);
  }

  // The input faces with inserted vertices inside or on their sides.
  void note_inserted_vertices()
  {
    const Delta_complex& input = input_.complex;
    has_inserted_.resize(input.number_of_faces(), false);
    for (auto v = input.number_of_vertices(); v < intrinsic_.complex.number_of_vertices(); ++v) {
      const Surface_point& location = correspondence_.location(Vertex_index(v));
      const Halfedge_index side = location.dimension() == 1 ? internal::side_of(input, location) : location.halfedge;
      has_inserted_[input.face(side).idx()] = true;
      if (location.dimension() == 1 && !input.is_border(input.opposite(side)))
        has_inserted_[input.face(input.opposite(side)).idx()] = true;
    }
  }

  // As input_to_intrinsic(), in a face with inserted vertices.
  Surface_point beside_inserted_vertices(const Surface_point& point) const
  {
    if (point.dimension() == 1) {
      const Place_on_input_edge place = place_on_input_edge(point);
      if (place.vertex.is_valid())
        return at(place.vertex);
      if (input_.overlay.label(input_.overlay.segment(place.part)) == Segment_label::BOTH)
        return on_common_edge(input_, intrinsic_, place.part, point);
    }
    const auto found = internal::Piece_walk(input_)(point);
    const auto& before = found.before_chords;
    for (std::size_t i = 0; before.size() > 1 && i < before.size(); ++i) {
      const Overlay::Halfedge chord = input_.overlay.next(before[i]);
      if (chord == before[(i + 1) % before.size()])
        return at(input_.overlay.target(chord));
    }
    return before.empty() ? in_face(input_, intrinsic_, found.face, point)
                          : on_chord(input_, intrinsic_, before.front(), point);
  }

  struct Place_on_input_edge
  {
    Overlay::Vertex vertex; // an inserted vertex, or:
    Overlay::Halfedge part; // the first part of the input edge after the last vertex before the point
  };
  Place_on_input_edge place_on_input_edge(const Surface_point& point) const
  {
    const Overlay& overlay = input_.overlay;
    const Delta_complex& input = input_.complex;
    const Edge_index e = input.edge(internal::side_of(input, point));
    const Halfedge_index along = input.halfedge(e);
    const auto [a, b] = internal::coordinates_on_edge(input, point, along);
    Overlay::Halfedge part = overlay.input_part(e, 0);
    for (Overlay::size_type i = 0; i + 1 < overlay.number_of_input_segments(e); ++i) {
      const Overlay::Vertex v = overlay.input_crossing(e, i);
      if (overlay.is_crossing(v))
        continue;
      const auto [c, d] =
        internal::coordinates_on_edge(input, correspondence_.location(overlay.original_vertex(v)), along);
      const Sign order = internal::compare_products(b, c, d, a); // b / (a + b) and d / (c + d)
      if (order == ZERO)
        return {v, {}};
      if (order == NEGATIVE)
        break;
      part = overlay.input_part(e, i + 1);
    }
    return {{}, part};
  }

  Surface_point at(Overlay::Vertex inserted) const
  {
    const Delta_complex& complex = intrinsic_.complex;
    return {complex.opposite(complex.halfedge(intrinsic_.overlay.original_vertex(inserted))), {1, 0, 0}};
  }

  // The point with coordinates whose sum does not overflow.
  static Surface_point checked(const Delta_complex& complex, const Surface_point& point)
  {
    if (point.halfedge.idx() >= complex.number_of_halfedges() || complex.is_border(point.halfedge))
      throw Invalid_point_error("a point has to be given in a face: halfedge " + std::to_string(point.halfedge.idx()) +
                                " has none");
    double largest = 0;
    for (double x : point.coordinates) {
      if (!(x >= 0 && x <= (std::numeric_limits<double>::max)()))
        throw Invalid_point_error("a barycentric coordinate of a point in the face of halfedge " +
                                  std::to_string(point.halfedge.idx()) + " is negative or not finite");
      largest = (std::max)(largest, x);
    }
    if (largest == 0)
      throw Invalid_point_error("the barycentric coordinates of a point in the face of halfedge " +
                                std::to_string(point.halfedge.idx()) + " are all zero");
    Surface_point result = point;
    if (largest > 0x1p200 || largest < 0x1p-200)
      for (double& x : result.coordinates)
        x = std::ldexp(x, -std::ilogb(largest));
    return result;
  }

  template <class From, class To>
  static Surface_point at_vertex(const From& from, const To& to, const Surface_point& point)
  {
    const Coordinates& b = point.coordinates;
    const Delta_complex& c = from.complex;
    const Vertex_index v = b[0] > 0   ? c.source(point.halfedge)
                           : b[1] > 0 ? c.target(point.halfedge)
                                      : c.target(c.next(point.halfedge));
    if (v.idx() >= to.complex.number_of_vertices())
      return to.positions.location(Overlay::Vertex(v.idx()));
    // A vertex on the border names a border halfedge that points to it.
    return {to.complex.opposite(to.complex.halfedge(v)), {1, 0, 0}};
  }

  // The part of the side on which the point lies.
  template <class From, class To>
  static Surface_point on_common_edge(const From& from, const To& to, Overlay::Halfedge part,
                                      const Surface_point& point)
  {
    const auto [source, target] = internal::coordinates_on_edge(from.complex, point, from.halfedge(part));
    double before = target / (source + target), behind = source / (source + target);
    const auto [from_begin, from_end] = from.ends(part);
    const auto [to_begin, to_end] = to.ends(part);
    if (from_begin > 0 || from_end < 1) {
      before = (std::min)(1., (std::max)(0., (before - from_begin) / (from_end - from_begin)));
      behind = 1 - before;
    }
    if (to_begin > 0 || to_end < 1) {
      before = to_begin + before * (to_end - to_begin);
      behind = 1 - before;
    }
    return on_edge(to.complex, to.halfedge(part), behind, before);
  }

  // The chord begins where `part` ends.
  template <class From, class To>
  static Surface_point on_chord(const From& from, const To& to, Overlay::Halfedge part, const Surface_point& point)
  {
    const Overlay::Halfedge chord = from.overlay.next(part);
    const Halfedge_index h = to.halfedge(chord);
    const double t = internal::fraction_between(internal::corner_coordinates(from, part, point.halfedge),
                                                internal::corner_coordinates(from, chord, point.halfedge),
                                                internal::with_sum_one(point.coordinates));
    const auto [begin, end] = to.ends(chord);
    const Coordinates result = internal::between({1 - begin, begin, 0}, {1 - end, end, 0}, t);
    return on_edge(to.complex, h, result[0], result[1]);
  }

  template <class From, class To>
  static Surface_point in_face(const From& from, const To& to, Overlay::Face f, const Surface_point& point)
  {
    const Halfedge_index h = to.complex.halfedge(to.face(f));
    Coordinates result = internal::affine_image(internal::corners_in_both(from, point.halfedge, to, h, f),
                                                internal::with_sum_one(point.coordinates));
    for (double& x : result)
      x = positive(x);
    return {h, result};
  }

  static Surface_point on_edge(const Delta_complex& complex, Halfedge_index h, double source, double target)
  {
    if (complex.is_border(h))
      return {complex.opposite(h), {positive(target), positive(source), 0}};
    return {h, {positive(source), positive(target), 0}};
  }

  // A coordinate that is known to be positive, even if rounding has lost it.
  static double positive(double x) { return x > 0 ? x : 0x1p-60; }

  internal::Input_layer input_;
  internal::Intrinsic_layer intrinsic_;
  const internal::Correspondence& correspondence_;
  std::vector<bool> has_inserted_; // for each input face, if there are inserted vertices
};

namespace internal {

// The point of a triangle that is nearest to the origin, and its squared distance.
inline std::pair<Coordinates, double> nearest_to_origin(const std::array<std::array<double, 3>, 3>& corners)
{
  const auto &p = corners[0], &q = corners[1], &r = corners[2];
  const auto squared_distance = [&](const Coordinates& b) {
    std::array<double, 3> x;
    for (std::size_t k = 0; k < 3; ++k)
      x[k] = b[0] * p[k] + b[1] * q[k] + b[2] * r[k];
    return scalar_product(x, x);
  };
  const auto normal =
    cross_product<double>({q[0] - p[0], q[1] - p[1], q[2] - p[2]}, {r[0] - p[0], r[1] - p[1], r[2] - p[2]});
  Coordinates inside;
  for (std::size_t i = 0; i < 3; ++i)
    inside[i] = scalar_product(normal, cross_product(corners[(i + 1) % 3], corners[(i + 2) % 3]));
  if (inside[0] > 0 && inside[1] > 0 && inside[2] > 0) {
    inside = with_sum_one(inside);
    return {inside, squared_distance(inside)};
  }
  std::pair<Coordinates, double> result{{}, std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const double t = fraction_between(corners[i], corners[j], {0, 0, 0});
    Coordinates on_side{0, 0, 0};
    on_side[i] = 1 - t;
    on_side[j] = t;
    const double squared = squared_distance(on_side);
    if (squared < result.second)
      result = {on_side, squared};
  }
  return result;
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsGeodesics
/// \brief returns the point of a surface that is nearest to a given point in space, for instance a picked one.
///
/// All faces are examined, which takes about as long for a few points as building a search tree. Of several nearest
/// points, the one in the face with the smallest number is returned.
///
/// \param complex the triangles; each has three different vertices in space
/// \param points a random access range of the points of the vertices, each with three coordinates
/// \param p the point
/// \return a point in a face, with rounded coordinates that sum to 1. None is positive and below 2⁻⁴⁰: a point that is
///   so near to an edge or a vertex lies on it
/// \exception Invalid_point_error if a coordinate of `p` is not finite, or there are no faces. O(size).
template <class PointRange>
Surface_point locate(const Delta_complex& complex, const PointRange& points, const std::array<double, 3>& p)
{
  double largest = (std::max)({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
  if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
    throw Invalid_point_error("a coordinate of the point to be located is not finite");
  if (complex.number_of_faces() == 0)
    throw Invalid_point_error("a point cannot be located on a surface without faces");
  for (Vertex_index v : complex.vertices())
    for (int k = 0; k < 3; ++k)
      largest = (std::max)(largest, std::abs(CGAL::to_double(points[v.idx()][k])));
  const int exponent = largest > 0 ? -std::ilogb(largest) - 1 : 0; // so that no product overflows
  const auto relative = [&](Vertex_index v) {
    std::array<double, 3> result;
    for (int k = 0; k < 3; ++k)
      result[k] = std::ldexp(CGAL::to_double(points[v.idx()][k]), exponent) - std::ldexp(p[k], exponent);
    return result;
  };
  Surface_point nearest{complex.halfedge(Face_index(0)), {1, 0, 0}};
  double squared_distance = std::numeric_limits<double>::infinity();
  for (Face_index f : complex.faces()) {
    const Halfedge_index h = complex.halfedge(f);
    const auto [coordinates, squared] = internal::nearest_to_origin(
      {relative(complex.source(h)), relative(complex.target(h)), relative(complex.target(complex.next(h)))});
    if (squared < squared_distance) {
      squared_distance = squared;
      nearest = {h, coordinates};
    }
  }
  nearest.coordinates = internal::on_near_edges(nearest.coordinates);
  return nearest;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_POINT_LOCATION_H
