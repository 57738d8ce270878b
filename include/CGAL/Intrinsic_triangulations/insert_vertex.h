// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// New vertices at points of the input, and their removal.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INSERT_VERTEX_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INSERT_VERTEX_H

#include <CGAL/Intrinsic_triangulations/internal/engine/history/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Input_edge_walk.h>
#include <CGAL/Intrinsic_triangulations/internal/flips/Whole_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/Piece_search.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/Vertex_remover.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/settle_around.h>
#include <CGAL/Intrinsic_triangulations/internal/numbers/Cotangent_weight.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Standard_arithmetic.h>
#include <CGAL/Intrinsic_triangulations/internal/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/observer.h>

#include <CGAL/enum.h>
#include <CGAL/property_map.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// The halfedge of an edge in a face without area, if there is one.
template <class Traits>
std::optional<Halfedge_index> side_without_area(const Intrinsic_triangulation<Traits>& triangulation, Edge_index e)
{
  const Delta_complex& complex = triangulation.connectivity();
  for (Halfedge_index h : {complex.halfedge(e), complex.opposite(complex.halfedge(e))})
    if (!complex.is_border(h) && !has_positive_area(triangulation, complex.face(h)))
      return h;
  return std::nullopt;
}

inline void check_new_vertex(const Delta_complex& input, const Surface_point& point)
{
  const auto fail = [](const std::string& what) { throw Invalid_point_error("a new vertex " + what); };
  if (!point.halfedge.is_valid() || point.halfedge.idx() >= input.number_of_halfedges() ||
      input.is_border(point.halfedge))
    fail("needs a halfedge of an input face");
  double sum = 0;
  for (double x : point.coordinates) {
    if (!(x >= 0))
      fail("needs barycentric coordinates that are not negative");
    sum += x;
  }
  if (!std::isfinite(sum) || sum == 0)
    fail("needs barycentric coordinates with a finite sum that is not zero");
  if (point.dimension() == 0)
    fail("lies at a vertex of the input: use that");
}

// The halfedge of the current triangulation along the part of an input edge that contains a given point, if there is
// one. Inserted vertices divide the edge into parts.
inline std::optional<Halfedge_index> halfedge_along(const internal::Exact_engine& engine, const Surface_point& point)
{
  const Delta_complex& complex = engine.connectivity();
  const internal::Correspondence& correspondence = engine.correspondence();
  const Delta_complex& input = correspondence.input();
  const Halfedge_index along = side_of(input, point);
  const auto [a, b] = coordinates_on_edge(input, point, along);
  for (Vertex_index v = input.source(along);;) {
    const Input_edge_start start = start_of_input_edge(complex, correspondence, v, along);
    const bool coincides = start.position < 0;
    if (coincides)
      v = complex.target(start.side);
    else {
      const Edge_index e = complex.edge(start.side);
      Input_edge_walk walk(complex, correspondence, complex.opposite(start.side),
                           correspondence.coordinates().number_of_crossings(e) - 1 - start.position);
      for (std::size_t step = 1; !walk.step(); ++step)
        if (step % 1024 == 0)
          engine.decisions().interruption.check();
      v = walk.end_vertex();
    }
    Sign order = NEGATIVE; // of the point and v, from the source on
    if (correspondence.is_inserted(v)) {
      const auto [c, d] = coordinates_on_edge(input, correspondence.location(v), along);
      order = compare_products(b, c, d, a); // b / (a + b) and d / (c + d)
    }
    if (order == ZERO)
      throw Invalid_point_error("a new vertex lies at vertex " + std::to_string(v.idx()) + ": use that");
    if (order == NEGATIVE)
      return coincides ? std::make_optional(start.side) : std::nullopt;
  }
}

// The vertex already inserted at the point, if it is a corner of the face of h.
inline std::optional<Vertex_index> vertex_at(const Delta_complex& complex,
                                             const internal::Correspondence& correspondence, Halfedge_index h,
                                             const Surface_point& point)
{
  const Delta_complex& input = correspondence.input();
  for (Halfedge_index side : {h, complex.next(h), complex.prev(h)}) {
    const Vertex_index v = complex.target(side);
    if (!correspondence.is_inserted(v))
      continue;
    const Surface_point& location = correspondence.location(v);
    if (location.dimension() == 2 && input.face(location.halfedge) == input.face(point.halfedge) &&
        are_same_points(input, location, point))
      return v;
  }
  return std::nullopt;
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsInsertion
/// \brief inserts a vertex at a point of the input, and flips edges until the triangulation is Delaunay again.
///
/// The metric does not change: the barycentric coordinates of the point, divided by their sum, are taken as exact.
/// Lengths and decisions follow exactly from them and from the input. The triangle that contains the point is found
/// exactly, too. No descriptor changes; the new vertex, its edges and faces have the next ones.
///
/// Input faces of zero area have no interior: their points coincide with points of their sides. No vertex is inserted
/// there, nor on sides of such faces that cannot be flipped away, at the border or at a constrained edge.
///
/// \param triangulation a Delaunay triangulation, or a constrained one
/// \param point a point strictly inside a face of `triangulation.input()`, or on an input edge that coincides with an
///   edge of the triangulation (a border edge, or one that was never flipped) and has faces of positive area
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamConstraints{which edges must not be flipped, including new edges}
///   \cgalParamVisitor{is called during long decisions, and can cancel}
/// \cgalNamedParamsEnd
///
/// \return the new vertex
/// \exception Invalid_point_error if the point is not such a point, or coincides with a vertex of the triangulation.
///   The message names the face of the input or the vertex
/// \exception Integer_overflow_error if an edge crosses more than 2^60 input edges
/// \exception Undecided_error as `sign_of_cotangent_weight()`
/// \exception Cancelled_error if the visitor asks for it, or as `sign_of_cotangent_weight()`
/// \pre `triangulation.keeps_input()`, with traits that use exact geometry
///
/// After any exception the triangulation is valid. If the number of vertices has grown, the vertex was inserted as the
/// last one, and edges near it may not be Delaunay; otherwise nothing is changed.
///
/// Complexity: proportional to the number of edges around a corner of the input face, to the number of edges that
/// cross this face between that corner and the point, and to the number of flips.
template <class Traits, class NamedParameters = parameters::Default_named_parameters>
Vertex_index insert_vertex(Intrinsic_triangulation<Traits>& triangulation, const Surface_point& point,
                           const NamedParameters& np = parameters::default_values())
{
  const auto is_constrained = internal::edge_constraints_of(np);
  const internal::Interruption_scope scope(triangulation, internal::go_further_function_of(np));
  const internal::Standard_arithmetic arithmetic;
  const Delta_complex& complex = triangulation.connectivity();
  const internal::Exact_engine& engine = internal::engine(triangulation);
  const internal::Correspondence& correspondence = engine.correspondence();
  internal::check_new_vertex(correspondence.input(), point);
  const auto throw_no_area = [](const char* where, Face_index f) {
    throw Invalid_point_error(std::string("a new vertex lies ") + where + " face " + std::to_string(f.idx()) +
                              " of the input, which has zero area: move it into another one");
  };
  Vertex_index v;
  if (point.dimension() == 1) {
    const std::optional<Halfedge_index> h = internal::halfedge_along(engine, point);
    if (!h)
      throw Invalid_point_error("a new vertex lies on an input edge that is no longer an edge of the triangulation: "
                                "move it into a face, or constrain that edge before flips");
    if (complex.is_self_glued(complex.edge(*h)))
      throw Invalid_point_error("a new vertex lies on an edge with the same face on both sides: move it into the face");
    if (const auto side = internal::side_without_area(triangulation, complex.edge(*h)))
      throw_no_area("on a side of", correspondence.input().face(correspondence.input_halfedge(*side)));
    v = internal::Whole_triangulation<Traits>(triangulation).split_edge(*h, point);
  } else {
    if (const Face_index f = correspondence.input().face(point.halfedge);
        !engine.metric().has_area(correspondence.input(), f))
      throw_no_area("in", f);
    const internal::Triangle_piece start = internal::piece_at_source(complex, correspondence, point.halfedge);
    const internal::Triangle_piece piece = internal::piece_of_point(engine, start, point);
    if (const auto there = internal::vertex_at(complex, correspondence, piece.side, point))
      throw Invalid_point_error("a new vertex lies at vertex " + std::to_string(there->idx()) + ": use that");
    v = internal::Whole_triangulation<Traits>(triangulation).split_face(piece, point);
  }
  std::vector<Edge_index> stack;
  internal::settle_around(triangulation, v, is_constrained, stack, [](Edge_index) {});
  return v;
}

/// \ingroup PkgIntrinsicTriangulationsInsertion
/// \brief removes a vertex that was inserted, and flips edges until the triangulation is Delaunay again.
///
/// The metric does not change, and all decisions are exact. A vertex on the border, or where a constrained edge was
/// split, is removed with the two halves of that edge becoming one.
///
/// Descriptors have no holes: the last vertex, edges and faces take the places of those that are removed. Vertices of
/// the input keep their descriptors. `remove_entries()` updates an array with one entry for each element.
///
/// \param triangulation a Delaunay triangulation, or a constrained one
/// \param v a vertex of it that was inserted
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamConstraints{which edges must not be flipped, by their descriptors before the removal}
///   \cgalParamVisitor{is called during long decisions, and can cancel}
/// \cgalNamedParamsEnd
///
/// \return the removed elements, which determine the moved descriptors
/// \exception Invalid_removal_error if `v` was not inserted, if constrained edges end in it other than the two halves
///   of an input edge, or if flips cannot reduce its edges to three, which can happen if edges lead from `v` around a
///   handle back to `v`. The triangulation then has the same vertices, and is Delaunay
/// \exception Integer_overflow_error if an edge crosses more than 2^60 input edges
/// \exception Undecided_error as `sign_of_cotangent_weight()`
/// \exception Cancelled_error if the visitor asks for it, or as `sign_of_cotangent_weight()`
/// \pre `triangulation.keeps_input()`, with traits that use exact geometry
///
/// After any exception but the first, the triangulation is valid, but may not be Delaunay near `v`, nor near the edges
/// opposite to it. If the number of vertices has decreased, `v` was removed, and descriptors have moved as described.
///
/// Complexity: O(d² + e + f) at most, for the degree d of `v`, the degree e of the vertex that moves, and f flips
/// afterwards.
template <class Traits, class NamedParameters = parameters::Default_named_parameters>
Removed_elements remove_vertex(Intrinsic_triangulation<Traits>& triangulation, Vertex_index v,
                               const NamedParameters& np = parameters::default_values())
{
  const auto is_constrained = internal::edge_constraints_of(np);
  const internal::Interruption_scope scope(triangulation, internal::go_further_function_of(np));
  if (v.idx() >= triangulation.connectivity().number_of_vertices() || !triangulation.is_inserted(v))
    throw Invalid_removal_error("vertex " + std::to_string(v.idx()) +
                                " was not inserted: only inserted vertices can be removed");
  return internal::Vertex_remover<Traits, std::decay_t<decltype(is_constrained)>>(triangulation, v, is_constrained)
    .remove();
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INSERT_VERTEX_H
