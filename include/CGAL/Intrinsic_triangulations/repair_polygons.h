// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Turns polygons that do not form a surface into one, as far as the connectivity is at fault. Says
// what was done, to which elements, and where each element of the result comes from.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_REPAIR_POLYGONS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_REPAIR_POLYGONS_H

#include <CGAL/Intrinsic_triangulations/internal/validation/Polygon_repairer.h>
#include <CGAL/Intrinsic_triangulations/observer.h>
#include <CGAL/Intrinsic_triangulations/validate_triangles.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsValidation
/// \brief returns whether `repair_polygons()` can repair a kind of finding.
///
/// It repairs the connectivity. Invalid indices and coordinates are damage to
/// the data, which cannot be repaired. Complexity: constant.
inline bool is_repairable(Finding_kind kind)
{
  switch (kind) {
  case Finding_kind::EMPTY:
  case Finding_kind::TOO_MANY_ELEMENTS:
  case Finding_kind::BAD_INDEX:
  case Finding_kind::NOT_FINITE:
  case Finding_kind::COORDINATE_RANGE:
  case Finding_kind::LENGTH_RANGE:
    return false;
  default:
    return true;
  }
}

/// \ingroup PkgIntrinsicTriangulationsValidation
/// \brief turns polygons into an oriented 2-manifold of triangles.
///
/// The steps, in this order:
/// - Vertices at the same position are merged where an edge joins them and along the border, which
///   closes seams. Elsewhere they stay apart, as do surfaces that merely touch.
/// - A face that visits a vertex twice is cut into loops. A face with fewer than three different corners
///   is removed.
/// - Of several faces with the same corners, one is kept.
/// - Polygons are triangulated.
/// - Faces are oriented consistently; the first of all that edges join keeps its orientation. A one-sided surface is cut.
/// - At an edge with more than two faces, those that bound the same piece of a solid stay together: they are found by
///   their exact order around the edge and by their orientation. What is closed and oriented, or the border of a solid whose
///   faces are turned in any way, stays closed. Where faces do not pair up, as three sheets at an edge, the surface is cut.
/// - Vertices are copied for each fan of faces.
/// - Vertices that belong to no triangle are removed.
///
/// No vertex is moved. Faces and vertices keep their order; copies of vertices come last.
/// Zero-area faces stay. If an edge had several faces and is border afterwards, there is an entry of `repairs` for
/// it (`Repair_kind::OPENED_EDGE`): without that entry, the repair has made no border. In most cases the result has no fatal
/// finding, but check it with `examine_polygons()`: lengths can be zero or out of range.
///
/// \tparam PointRange a model of `RandomAccessRange`, of points whose coordinates are `p[0]`, `p[1]` and `p[2]`
/// \tparam PolygonRange a model of `ForwardRange`, of ranges of integers of any length
///
/// \param points the vertices; their coordinates are converted to `double`
/// \param polygons the faces, as indices into `points`
/// \param progress is called from time to time, at least before each polygon is triangulated
///
/// \exception Invalid_surface_error if there is no face, an index is invalid, or a coordinate is not finite
/// \exception Cancelled_error if `progress` returns `false`
///
/// Complexity: O(n log n), plus that of faces with k > 3 corners: nearly planar ones
/// take O(k log k), others O(k<sup>3</sup>) up to 200 corners; with more corners they become fans.
///
/// It uses these functions of `CGAL::Polygon_mesh_processing`: `merge_duplicate_points_in_polygon_soup()`,
/// `merge_duplicate_polygons_in_polygon_soup()` and `triangulate_hole_polyline()`.
template <class PointRange, class PolygonRange>
Repaired_polygons repair_polygons(const PointRange& points, const PolygonRange& polygons,
                                  const Progress_function& progress = {})
{
  const Surface_report report = examine_polygons(points, polygons);
  for (Finding_kind kind : {Finding_kind::EMPTY, Finding_kind::TOO_MANY_ELEMENTS,
                            Finding_kind::BAD_INDEX, Finding_kind::NOT_FINITE})
    if (report.find(kind) != nullptr)
      throw_if_fatal(report);

  std::vector<std::array<double, 3>> coordinates;
  coordinates.reserve(report.number_of_vertices);
  for (const auto& p : points)
    coordinates.push_back({to_double(p[0]), to_double(p[1]), to_double(p[2])});
  std::vector<std::vector<std::size_t>> faces;
  faces.reserve(report.number_of_faces);
  for (const auto& polygon : polygons) {
    faces.emplace_back();
    for (const auto index : polygon)
      faces.back().push_back(static_cast<std::size_t>(index));
  }
  return internal::Polygon_repairer(std::move(coordinates), std::move(faces)).run(progress);
}

/// \ingroup PkgIntrinsicTriangulationsValidation
/// \brief returns a sentence that says what was done, to which element, and how often.
/// \param repair an entry of `Repaired_polygons::repairs`
/// \return for example "face 4 (6 corners) was cut into triangles, and 2 more faces like it".
/// Complexity: constant.
inline std::string message(const Repair& repair)
{
  std::string text = repair.description;
  if (repair.count > 1)
    text += ", and " + std::to_string(repair.count - 1) + " more " +
            internal::counted_elements(repair.kind)[repair.count == 2 ? 0 : 1] + " like it";
  return text;
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_REPAIR_POLYGONS_H
