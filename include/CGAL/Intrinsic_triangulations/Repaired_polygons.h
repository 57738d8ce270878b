// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// What a repair of polygons leaves: triangles, where they come from, and what was done.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_REPAIRED_POLYGONS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_REPAIRED_POLYGONS_H

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsValidation
/// \brief what `repair_polygons()` does.
enum class Repair_kind {
  MERGED_VERTEX,     ///< a vertex was merged with another at the same place
  COLLAPSED_FACE,    ///< a face was removed, as fewer than three of its corners differ
  DUPLICATE_FACE,    ///< a face was removed, as another has the same corners
  DUPLICATE_PART,    ///< of a face that was cut, some or all parts were removed, as other faces have the same corners
  TRIANGULATED_FACE, ///< a face was cut into triangles
  REVERSED_FACE,     ///< a face was turned over
  SPLIT_VERTEX,      ///< a vertex got copies, one for each fan of faces beyond the first
  DROPPED_VERTEX     ///< a vertex was removed, as no triangle of the result has it
};

/// \ingroup PkgIntrinsicTriangulationsValidation
/// \brief one kind of thing that `repair_polygons()` did, with the first elements of the input to
/// which it was done.
struct Repair
{
  /// what was done.
  Repair_kind kind;
  /// the smallest indices of faces or vertices of the input, at most ten, increasing.
  std::vector<std::size_t> elements;
  /// to how many elements it was done.
  std::size_t count;
  /// names the first element, e.g. "vertex 17 was merged with vertex 3 at the same place".
  std::string description;
};

/// \ingroup PkgIntrinsicTriangulationsValidation
/// \brief triangles, and where they come from.
struct Repaired_polygons
{
  /// the vertices.
  std::vector<std::array<double, 3>> points;
  /// the faces, as indices into `points`.
  std::vector<std::array<std::size_t, 3>> triangles;
  /// for each vertex the vertex of the input that it is, the first of those merged into it.
  std::vector<std::size_t> input_vertices;
  /// for each face the face of the input that it is, or that it is a part of.
  std::vector<std::size_t> input_faces;
  /// one entry for each kind of thing that was done, in the order of `Repair_kind`.
  std::vector<Repair> repairs;
};

/// \cond SKIP_IN_MANUAL
namespace internal {
inline bool is_about_faces(Repair_kind kind)
{
  return kind != Repair_kind::MERGED_VERTEX && kind != Repair_kind::SPLIT_VERTEX &&
         kind != Repair_kind::DROPPED_VERTEX;
}
} // namespace internal
/// \endcond

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_REPAIRED_POLYGONS_H
