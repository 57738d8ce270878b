// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Turns polygons that do not form a surface into one, if only the connectivity is at fault. Reports each repair with
// its elements, and where each element of the result comes from.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_REPAIR_POLYGONS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_REPAIR_POLYGONS_H

#include <CGAL/Intrinsic_triangulations/internal/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/observer.h>
#include <CGAL/Intrinsic_triangulations/validate_triangles.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsValidation
/// \brief a kind of repair by `repair_polygons()`.
enum class Repair_kind {
  MERGED_VERTEX,     ///< a vertex was merged with another at the same position
  COLLAPSED_FACE,    ///< a face that encloses nothing was removed
  DUPLICATE_FACE,    ///< a face with the same corners as another was removed
  DUPLICATE_PART,    ///< some or all parts of a face that was cut were removed: other faces have the same corners
  TRIANGULATED_FACE, ///< a face was cut into triangles
  FANNED_FACE,       ///< its triangles are a fan, which may overlap: the face is large and far from any plane
  FLAT_SPIKE,        ///< a vertex around which all faces had zero area and an angle of zero was removed
  STITCHED_EDGE,     ///< an edge was split at vertices that lie within it
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
  /// the smallest indices of faces or vertices of the input, at most ten, in increasing order; for an edge, its face.
  std::vector<std::size_t> elements;
  /// the number of elements affected.
  std::size_t count;
  /// a description of the first element, e.g. "vertex 17 was merged with vertex 3 at the same place".
  std::string description;
};

/// \ingroup PkgIntrinsicTriangulationsValidation
/// \brief triangles and their origins in the input.
struct Repaired_polygons
{
  /// the vertices.
  std::vector<std::array<double, 3>> points;
  /// the faces, as indices into `points`.
  std::vector<std::array<std::size_t, 3>> triangles;
  /// the input vertex of each vertex: the first of those merged into it.
  std::vector<std::size_t> input_vertices;
  /// the input face that each face is, or is part of.
  std::vector<std::size_t> input_faces;
  /// one entry for each kind of repair that was made, in the order of `Repair_kind`.
  std::vector<Repair> repairs;
};

namespace internal {

// As examine_polygons(), but only of the numbers of elements, of indices and coordinates.
Surface_report examine_data(Polygon_copies polygons);

Repaired_polygons repair(std::vector<std::array<double, 3>> points, std::vector<std::vector<std::size_t>> polygons,
                         const Progress_function& progress, const std::optional<double>& stitching_tolerance);

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsValidation
/// \brief returns the name of a kind of repair in files, for example "reversed faces". Complexity: constant.
/// \param kind the kind
const char* name(Repair_kind kind);

/// \ingroup PkgIntrinsicTriangulationsValidation
/// \brief returns whether `repair_polygons()` can repair a defect.
///
/// It repairs the connectivity. Invalid indices and coordinates are damage to
/// the data, which cannot be repaired. Of faces of zero area, it removes those of flat spikes. Complexity: constant.
/// \param defect the defect
bool is_repairable(Invalid_surface_error::Defect defect);

/// \ingroup PkgIntrinsicTriangulationsValidation
/// \brief turns polygons into an oriented 2-manifold of triangles.
///
/// The steps, in this order:
/// - Vertices at the same position are merged where an edge joins them and along the border, which
///   closes seams. Elsewhere they stay apart, as do surfaces that merely touch.
/// - A face that encloses nothing, such as one with fewer than three different corners, is removed.
/// - Polygons are cut into triangles as by `triangulate_polygon()`.
/// - Vertices around which all faces have zero area and an angle of zero are removed: no area is lost. Vertices at the
///   same place on the common longest side of two faces of zero area become one.
/// - If a stitching tolerance is given, edges are split where others end within them (see `Gap_kind::T_JUNCTION`),
///   exactly or not farther away, and border vertices and the ends of edges that are not farther from each other are
///   merged: T-junctions and narrow gaps are closed.
/// - Of several triangles with the same corners, one is kept; or two, if they are the wall between two rooms or the
///   sides of a fin, as an even number of other faces at their edges tells. A fin of one triangle goes with both sides.
/// - Faces are oriented consistently; the first of all that edges join keeps its orientation. A one-sided surface is
///   cut.
/// - At an edge with more than two faces, those that bound the same piece of a solid stay together: they are found by
///   their exact order around the edge and by their orientation. Closed oriented parts, and boundaries of solids with
///   faces of any orientation, stay closed. Where faces do not pair up, such as three sheets at an edge, the surface is
///   cut. Pieces of zero area that this cuts off are removed.
/// - Vertices are copied for each fan of faces.
/// - Vertices that belong to no triangle are removed.
///
/// No vertex is moved. Faces and vertices keep their order; copies of vertices come last.
/// Other zero-area faces stay. If an edge had several faces and is border afterwards, there is an entry of `repairs`
/// for it (`Repair_kind::OPENED_EDGE`): without that entry, the repair has made no border. In most cases the result has
/// no fatal finding, but check it with `examine_polygons()`: lengths can be zero or out of range.
///
/// \tparam PointRange a model of `RandomAccessRange`, of points whose coordinates are `p[0]`, `p[1]` and `p[2]`
/// \tparam PolygonRange a model of `ForwardRange`, of ranges of integers of any length
///
/// \param points the vertices; their coordinates are converted to `double`
/// \param polygons the faces, as indices into `points`
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{stitching_tolerance}
///     \cgalParamDescription{a length in the unit of the input, within which the border is stitched}
///     \cgalParamType{`double`, at least 0, or `std::optional<double>`}
///     \cgalParamDefault{nothing is stitched}
///   \cgalParamNEnd
///   \cgalParamVisitor{is called from time to time, at least before each polygon is triangulated, and can cancel}
/// \cgalNamedParamsEnd
///
/// \exception Invalid_surface_error if there is no face, an index is invalid, a coordinate is not finite, or a face
///   crosses itself
/// \exception Invalid_argument_error if the tolerance is negative or not finite
/// \exception Cancelled_error if the visitor asks for it
///
/// Complexity: O(n log n), plus that of `triangulate_polygon()` for faces with more than three corners.
template <class PointRange, class PolygonRange, class NamedParameters = parameters::Default_named_parameters>
Repaired_polygons repair_polygons(const PointRange& points, const PolygonRange& polygons,
                                  const NamedParameters& np = parameters::default_values())
{
  const auto stitching_tolerance =
    internal::value_of<internal::Parameter::STITCHING_TOLERANCE>(np, std::optional<double>());
  if (stitching_tolerance && !(*stitching_tolerance >= 0 && std::isfinite(*stitching_tolerance)))
    throw Invalid_argument_error("a stitching tolerance is at least 0 and finite");
  const Surface_report report = internal::examine_data(internal::copy_polygons(points, polygons));
  if (const Finding* const first = report.first_fatal();
      first != nullptr && (first->defect <= Invalid_surface_error::Defect::NOT_FINITE || first->elements.empty()))
    throw_if_fatal(report);

  const Progress_function progress = internal::progress_function_of(np);
  internal::report_progress(progress, 0, "the repair");
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
  return internal::repair(std::move(coordinates), std::move(faces), progress, stitching_tolerance);
}

/// \ingroup PkgIntrinsicTriangulationsValidation
/// \brief returns a sentence that says what was done, to which element, and how often.
/// \param repair an entry of `Repaired_polygons::repairs`
/// \return for example "face 4 (6 corners) was cut into triangles, and 2 more faces like it".
/// Complexity: constant.
std::string message(const Repair& repair);

/// \ingroup PkgIntrinsicTriangulationsValidation
/// \brief the triangles of a polygon.
struct Polygon_triangles
{
  std::vector<std::array<std::size_t, 3>> triangles; ///< their vertices, in the direction of the polygon
  std::string warning;                               ///< a warning about the triangles; empty if they are correct
};

/// \ingroup PkgIntrinsicTriangulationsValidation
/// \brief cuts one polygon in space into triangles, which have its sides as their border.
///
/// The polygon is projected onto the plane of its area, or of three distant corners if its area is small. If its sides
/// do not cross there, it is cut into the triangles that it encloses (a constrained Delaunay triangulation with exact
/// decisions). Sides may touch and run along each other: parts that slits connect with the outside, and run in the
/// other direction, are holes. A corner that rounding has moved beyond a side touches it, if by at most the distance of
/// the polygon from the plane or 10<sup>-6</sup> of its size, whichever is larger, but less than 1/256 of its size. A
/// polygon whose sides cross in both planes, and miss each other in space by more than a hundredth of its size, becomes
/// a surface of small dihedral angles and area if it has up to 200 corners, and otherwise a fan, the only cause of a
/// warning.
///
/// \param points positions of vertices
/// \param polygon the vertices at the corners. Repetitions of the previous vertex are ignored; no triangle names a
///   vertex twice
/// \param face the number of the polygon in messages
///
/// \exception Invalid_surface_error with `WRONG_TOPOLOGY` if the polygon crosses itself, or winds twice around a part
///   of itself; the message names the sides
///
/// Complexity: O(k log k) for k corners in practice, O(k<sup>3</sup>) for up to 200 corners far from a plane. It uses
/// `CGAL::Constrained_Delaunay_triangulation_2` and `CGAL::Polygon_mesh_processing::triangulate_hole_polyline()`.
Polygon_triangles triangulate_polygon(const std::vector<std::array<double, 3>>& points,
                                      const std::vector<std::size_t>& polygon, std::size_t face);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_REPAIR_POLYGONS_H
