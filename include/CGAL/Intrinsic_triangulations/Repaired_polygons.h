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
/// \brief a kind of repair by `repair_polygons()`.
enum class Repair_kind {
  MERGED_VERTEX,     ///< a vertex was merged with another at the same position
  COLLAPSED_FACE,    ///< a face with fewer than three different corners was removed
  DUPLICATE_FACE,    ///< a face with the same corners as another was removed
  DUPLICATE_PART,    ///< some or all parts of a face that was cut were removed, as other faces have the same corners
  TRIANGULATED_FACE, ///< a face was cut into triangles
  REVERSED_FACE,     ///< a face was turned over
  SPLIT_VERTEX,      ///< a vertex was copied for each fan of faces after the first
  OPENED_EDGE,       ///< an edge that had several faces, or lay inside one, became a border edge
  DROPPED_VERTEX     ///< a vertex that belongs to no triangle of the result was removed
};

/// \ingroup PkgIntrinsicTriangulationsValidation
/// \brief one kind of repair that `repair_polygons()` made, with the first elements of the input
/// that it affected.
struct Repair
{
  /// the kind of repair.
  Repair_kind kind;
  /// the smallest indices of faces or vertices of the input, at most ten, increasing; of an edge, its face.
  std::vector<std::size_t> elements;
  /// the number of elements affected.
  std::size_t count;
  /// a description of the first element, e.g. "vertex 17 was merged with vertex 3 at the same place".
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
  /// for each vertex, the vertex of the input that it is: the first of those merged into it.
  std::vector<std::size_t> input_vertices;
  /// for each face, the face of the input that it is, or is a part of.
  std::vector<std::size_t> input_faces;
  /// one entry for each kind of repair that was made, in the order of `Repair_kind`.
  std::vector<Repair> repairs;
};

/// \ingroup PkgIntrinsicTriangulationsValidation
/// \brief returns what a kind of repair is called in files, for example "reversed faces". Complexity: constant.
inline const char* name(Repair_kind kind)
{
  switch (kind) {
  case Repair_kind::MERGED_VERTEX:
    return "merged vertices";
  case Repair_kind::COLLAPSED_FACE:
    return "collapsed faces";
  case Repair_kind::DUPLICATE_FACE:
    return "duplicate faces";
  case Repair_kind::DUPLICATE_PART:
    return "duplicate parts of faces";
  case Repair_kind::TRIANGULATED_FACE:
    return "triangulated faces";
  case Repair_kind::REVERSED_FACE:
    return "reversed faces";
  case Repair_kind::SPLIT_VERTEX:
    return "split vertices";
  case Repair_kind::OPENED_EDGE:
    return "opened edges";
  case Repair_kind::DROPPED_VERTEX:
    return "dropped vertices";
  }
  return "";
}

/// \cond SKIP_IN_MANUAL
namespace internal {
// What a kind of repair counts, one and several.
inline std::array<const char*, 2> counted_elements(Repair_kind kind)
{
  switch (kind) {
  case Repair_kind::MERGED_VERTEX:
  case Repair_kind::SPLIT_VERTEX:
  case Repair_kind::DROPPED_VERTEX:
    return {"vertex", "vertices"};
  case Repair_kind::OPENED_EDGE:
    return {"edge", "edges"};
  default:
    return {"face", "faces"};
  }
}
} // namespace internal
/// \endcond

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_REPAIRED_POLYGONS_H
