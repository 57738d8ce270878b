// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Text files for what OFF and PLY cannot hold: gluings with loops, several edges between
// the same vertices and faces that meet themselves.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DELTA_COMPLEX_IO_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DELTA_COMPLEX_IO_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/config.h>

#include <iosfwd>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

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
void write_gluing(std::ostream& os, const Delta_complex& complex,
                  const std::vector<double>& lengths);

/// \ingroup PkgIntrinsicTriangulationsIO
/// \brief reads a complex and the lengths of its edges in the format of `write_gluing()`.
///
/// The output of `write_gluing()` gives an equal complex and the same lengths.
///
/// \exception Invalid_surface_error if anything is wrong with the text. The message and
///   `element()` name the line; only if faces form more than one fan around a vertex, they
///   name that vertex. The triangle inequality is not checked here, but in
///   `Intrinsic_triangulation::from_lengths()`. O(size).
Gluing read_gluing(std::istream& is);

} // namespace Intrinsic_triangulations
} // namespace CGAL

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/internal/connectivity/Delta_complex_io_impl.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DELTA_COMPLEX_IO_H
