// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The connectivity of triangles, meshes and texts.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_MAKE_DELTA_COMPLEX_H
#define CGAL_INTRINSIC_TRIANGULATIONS_MAKE_DELTA_COMPLEX_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/Delta_complex_builder.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/copy_face_graph.h>

#include <cstddef>
#include <iosfwd>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsConnectivity
/// \brief copies the connectivity of a triangle mesh.
///
/// The i-th vertex, edge and face of the result are the i-th of `vertices(graph)`,
/// `edges(graph)` and `faces(graph)`; halfedge `2e` is `halfedge(e, graph)`. For a
/// `CGAL::Surface_mesh` without garbage these are the numbers of its own descriptors.
/// O(size).
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` (with TBB) or `Parallel_if_available_tag`
/// \tparam FaceGraph a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param graph the mesh
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
/// \param number_of_vertices the number of vertices
/// \param triangles the corners of the triangles
/// \exception Invalid_surface_error if an index is out of range or repeated, an edge has
///   more than two faces, two faces traverse an edge in the same direction, or the faces
///   around a vertex form more than one fan
template <class TriangleRange>
Delta_complex make_Delta_complex_from_triangles(std::size_t number_of_vertices, const TriangleRange& triangles)
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
/// \param number_of_faces the number of triangles
/// \param glued_sides the pairs of glued sides
/// \exception Invalid_surface_error if a side is out of range, glued twice or to itself
template <class SidePairRange>
Delta_complex make_Delta_complex_from_gluing(std::size_t number_of_faces, const SidePairRange& glued_sides)
{
  return internal::Delta_complex_builder::from_gluing(number_of_faces, glued_sides);
}

/// \ingroup PkgIntrinsicTriangulationsIO
/// \brief the contents of a gluing file.
struct Gluing
{
  Delta_complex complex;       ///< the triangles
  std::vector<double> lengths; ///< the length of each edge, in the order of the edges
};

/// \ingroup PkgIntrinsicTriangulationsIO
/// \brief writes a complex and the lengths of its edges in the gluing format.
///
/// The format is text; files have the extension `.gluing`. A `#` starts a comment, and
/// empty lines are ignored.
///
/// \verbatim
/// INTRINSIC_GLUING 1
/// V E F                    the numbers of vertices, edges and faces
/// a b c                    for each face, the vertices of its corners
/// side opposite length     for each edge, the sides of its halfedges 2e and 2e + 1, and its length
/// \endverbatim
///
/// Side `3f + i` runs from corner i of face f to corner i + 1; side `3f` is
/// `halfedge(f)`. A border halfedge has side -1. Lengths are written with 17 significant digits, so
/// they are read back as the same numbers. Reading also restores all descriptors, the direction of
/// each edge and the first halfedge of each face; `halfedge(v)` of an interior vertex may differ.
///
/// \param os the stream; the caller has to check its state afterwards
/// \param complex any complex
/// \param lengths the length of each edge
/// \exception Invalid_surface_error if a length is not positive and finite, or there are
///   more than a million isolated vertices, which `read_gluing()` would take for damage.
///   Then nothing is written. O(size).
/// \pre `lengths.size() == complex.number_of_edges()`
void write_gluing(std::ostream& os, const Delta_complex& complex, const std::vector<double>& lengths);

/// \ingroup PkgIntrinsicTriangulationsIO
/// \brief reads a complex and the lengths of its edges in the format of `write_gluing()`.
///
/// The output of `write_gluing()` gives an equal complex and the same lengths.
///
/// \param is the stream
/// \exception Invalid_surface_error if the text is invalid. The message and
///   `element()` name the line; only if faces form more than one fan around a vertex, they
///   name that vertex. The triangle inequality is not checked here, but in
///   `Intrinsic_triangulation::from_lengths()`. O(size).
Gluing read_gluing(std::istream& is);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_MAKE_DELTA_COMPLEX_H
