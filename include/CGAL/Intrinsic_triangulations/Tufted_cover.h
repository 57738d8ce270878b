// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A closed oriented surface over any triangles, how it is made, and what was found on the way.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TUFTED_COVER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TUFTED_COVER_H

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/mollify.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsCover
/// \brief what is built over the triangles.
enum class Surface_cover {
  /// The tufted cover, which takes any triangles and has no border.
  TUFTED,
  /// The triangles themselves, turned over where neighbours disagree: no edge may have more than two faces, and
  /// the surface must be orientable. Border edges stay border edges.
  NONE
};

/// \ingroup PkgIntrinsicTriangulationsCover
/// \brief what is done where an edge joins two vertices at the same place.
enum class Coincident_vertices {
  ERROR, ///< an exception names them
  MERGE, ///< they become one vertex, and their faces lose a corner
  DROP   ///< the faces at such an edge are left out
};

/// \ingroup PkgIntrinsicTriangulationsCover
/// \brief how a cover is made.
struct Tufted_cover_options
{
  /// what is built
  Surface_cover cover = Surface_cover::TUFTED;
  /// what is done with edges of length zero
  Coincident_vertices coincident_vertices = Coincident_vertices::MERGE;
  /// whether all vertices at the same place become one, whether an edge joins them or not: for triangles that do not
  /// share their corners
  bool is_welded = false;
  /// if positive, lengths are rounded and edges lengthened as by `mollify_lengths()` with this margin; the metric
  /// changes, and the report says how much
  double mollification = 0;
  /// is asked now and then while the cover is built, and while its operator is assembled; if it returns `false`, `Cancelled_error` is thrown
  std::function<bool()> go_further = {};
};

/// \ingroup PkgIntrinsicTriangulationsCover
/// \brief what was found in the triangles, and what was done with them.
struct Tufted_cover_report
{
  std::size_t number_of_vertices = 0;    ///< the vertices given
  std::size_t number_of_faces = 0;       ///< the faces given
  std::size_t nonmanifold_edges = 0;     ///< edges with more than two faces
  std::size_t nonmanifold_vertices = 0;  ///< vertices whose faces form more than one fan
  std::size_t border_edges = 0;          ///< edges with one face
  bool is_orientable = true;             ///< whether all faces can be turned so that they agree across each edge with two faces
  std::size_t repeated_corner_faces = 0; ///< faces dropped because they name a vertex twice
  std::size_t collapsed_faces = 0;       ///< faces dropped because corners of theirs were merged
  std::size_t zero_length_faces = 0;     ///< faces dropped by `Coincident_vertices::DROP`
  std::size_t faces_without_area = 0;    ///< faces dropped because all that they are connected with has no area
  std::size_t merged_vertices = 0;       ///< vertices that another one stands for
  std::size_t unreferenced_vertices = 0; ///< vertices that no face has that was not dropped: their rows are zero
  Mollification_report mollification;    ///< what mollification changed: nothing unless it was asked for

  /// returns the number of all faces that were dropped.
  std::size_t dropped_faces() const
  {
    return repeated_corner_faces + collapsed_faces + zero_length_faces + faces_without_area;
  }
};

/// \ingroup PkgIntrinsicTriangulationsCover
///
/// \brief an oriented surface over any triangles, as `make_tufted_cover()` builds it.
///
/// A connected part of the input that is closed, orientable and has two faces at each edge is its own cover. All others
/// are covered by two copies of each face, one of them turned over; such a part counts half. The first vertices of the
/// cover are those of the input, with the same numbers. Further ones follow where the faces
/// at an input vertex form several fans in the cover. Vertices without faces are isolated.
struct Tufted_cover
{
  /// the cover with its exact metric, before any flip
  Intrinsic_triangulation<Filtered_edge_length_traits> triangulation;
  /// for each vertex of the cover, the input vertex below it
  std::vector<std::uint32_t> vertex_of;
  /// for each face of the cover, the input face below it; flips make it meaningless
  std::vector<std::uint32_t> face_of;
  /// for each face of the cover, whether it is the copy that is turned over
  std::vector<bool> is_back;
  /// for each face of the cover, whether it counts half, as each other face that flips can join it with
  std::vector<bool> is_half;
  /// for each input vertex, the vertex that stands for it: another one if it was merged
  std::vector<std::uint32_t> representative;
  /// what was found and done
  Tufted_cover_report report;
};

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TUFTED_COVER_H
