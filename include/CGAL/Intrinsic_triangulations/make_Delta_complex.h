// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Builds the connectivity from a face graph, from index triples or from a gluing.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_MAKE_DELTA_COMPLEX_H
#define CGAL_INTRINSIC_TRIANGULATIONS_MAKE_DELTA_COMPLEX_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/Delta_complex_builder.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/check_triangles.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/copy_face_graph.h>

#include <cstddef>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsConnectivity
/// \brief copies the connectivity of a triangle mesh.
///
/// The i-th vertex, edge and face of the result are the i-th of `vertices(graph)`,
/// `edges(graph)` and `faces(graph)`; halfedge `2e` is `halfedge(e, graph)`. For a
/// `CGAL::Surface_mesh` without garbage the positions are those of its own descriptors.
/// O(size).
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` (with TBB) or `Parallel_if_available_tag`
/// \tparam FaceGraph a model of `FaceListGraph` and `HalfedgeListGraph`
/// \exception Invalid_surface_error if a face is not a triangle or there are too many edges
template <class ConcurrencyTag = Sequential_tag, class FaceGraph>
Delta_complex make_Delta_complex(const FaceGraph& graph)
{
  Delta_complex complex = internal::copy_face_graph<ConcurrencyTag>(graph);
  internal::check_triangles(complex);
  return complex;
}

/// \ingroup PkgIntrinsicTriangulationsConnectivity
/// \brief builds the connectivity of a simplicial surface from the corners of its triangles.
///
/// Edges are numbered by their first appearance around the faces in order; corner i of
/// face f starts side i, from corner i to corner i + 1, and `halfedge(f)` is side 0.
/// Vertices that belong to no face become isolated vertices. O(size), no hashing.
///
/// \tparam TriangleRange a range of random access ranges of three vertex indices each
/// \exception Invalid_surface_error if an index is out of range or repeated, an edge has
///   more than two faces, two faces traverse an edge in the same direction, or the faces
///   around a vertex form more than one fan
template <class TriangleRange>
Delta_complex make_Delta_complex_from_triangles(std::size_t number_of_vertices,
                                                const TriangleRange& triangles)
{
  return internal::Delta_complex_builder::from_triangles(number_of_vertices, triangles);
}

/// \ingroup PkgIntrinsicTriangulationsConnectivity
/// \brief builds the connectivity of a surface from triangles and glued sides.
///
/// Side `3 f + i` runs from corner i of face f to corner i + 1. Two glued sides run in
/// opposite directions along their common edge; a side that is not glued lies on
/// the boundary. Any gluing is allowed, even of a face to itself. Edges are numbered
/// in the order of their first sides, vertices in the order of their first corners. O(size).
///
/// \tparam SidePairRange a range of pairs (random access ranges of two) of side numbers
/// \exception Invalid_surface_error if a side is out of range, glued twice or to itself
template <class SidePairRange>
Delta_complex make_Delta_complex_from_gluing(std::size_t number_of_faces,
                                             const SidePairRange& glued_sides)
{
  return internal::Delta_complex_builder::from_gluing(number_of_faces, glued_sides);
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_MAKE_DELTA_COMPLEX_H
