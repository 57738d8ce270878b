// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// What is found when a list of polygons is examined, and how it is said: kinds of findings,
// the report, its messages and the exception.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SURFACE_REPORT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SURFACE_REPORT_H

#include <CGAL/Intrinsic_triangulations/internal/config.h>
#include <CGAL/Intrinsic_triangulations/errors.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsValidation
/// \brief a kind of finding of `examine_polygons()`: the fatal kinds first, in the order
/// in which they should be fixed, then those that a surface may have.
enum class Finding_kind {
  EMPTY,                    ///< there is no face
  TOO_MANY_ELEMENTS,        ///< too many vertices or corners for 32-bit indices
  BAD_INDEX,                ///< a face refers to a vertex that does not exist
  NOT_FINITE,               ///< a coordinate is NaN or infinite
  NOT_A_TRIANGLE,           ///< a face has fewer or more than three corners
  REPEATED_CORNER,          ///< a face has the same vertex twice
  DUPLICATE_FACE,           ///< a face has the three corners of an earlier one
  NON_MANIFOLD_EDGE,        ///< an edge has more than two faces
  INCONSISTENT_ORIENTATION, ///< the two faces of an edge traverse it in the same direction
  NON_MANIFOLD_VERTEX,      ///< the faces around a vertex form more than one fan
  ZERO_LENGTH_EDGE,         ///< the ends of an edge coincide
  COORDINATE_RANGE,         ///< a coordinate is lost when the surface is scaled into the range of `double`
  LENGTH_RANGE,             ///< no power of two scales all squared lengths, and their products, into the range of `double`
  ZERO_AREA_FACE,           ///< not fatal: the three distinct corners of a face are collinear
  UNREFERENCED_VERTEX,      ///< not fatal: a vertex belongs to no face
  SEVERAL_COMPONENTS        ///< not fatal: the surface is in several pieces
};

/// \ingroup PkgIntrinsicTriangulationsValidation
/// \brief a finding of `examine_polygons()`, with the first elements that it concerns.
struct Finding
{
  /// the kind of finding.
  Finding_kind kind;
  /// the corresponding defect of an exception; meaningless unless `is_fatal`.
  Invalid_surface_error::Defect defect;
  /// the smallest indices, at most ten, increasing where they are vertices or
  /// faces; for a finding about edges, the first face of each of `edges`.
  std::vector<std::size_t> elements;
  /// the end vertices of the first edges, smaller first; empty for other findings.
  std::vector<std::array<std::size_t, 2>> edges;
  /// the number of elements concerned (for `SEVERAL_COMPONENTS`: of components).
  std::size_t count;
  /// whether the package cannot work on the surface.
  bool is_fatal;
  /// a description of the first element with its vertices, e.g. "edge 3-17 has 4 faces (faces 5, 8, 9, 11)".
  std::string description;
};

/// \ingroup PkgIntrinsicTriangulationsValidation
/// \brief everything that `examine_polygons()` found, and the numbers of elements.
struct Surface_report
{
  /// one entry per kind that occurs, in the order of `Finding_kind`.
  std::vector<Finding> findings;
  std::size_t number_of_vertices = 0;     ///< points, referenced or not
  std::size_t number_of_faces = 0;        ///< polygons, valid or not
  std::size_t number_of_edges = 0;        ///< edges of the faces with valid indices
  std::size_t number_of_border_edges = 0; ///< those with one face
  std::size_t number_of_components = 0;   ///< pieces that share no vertex
  /// whether the faces can be oriented consistently (known only if no edge has three faces).
  bool is_orientable = true;
  /// the smallest `e` such that no coordinate differs by 2<sup>e</sup> or more along any edge.
  int exponent_of_longest_edge = 0;
  /// the same for the shortest edge of nonzero length.
  int exponent_of_shortest_edge = 0;

  /// returns the entry of a kind, or `nullptr` if there is none. Complexity: constant.
  const Finding* find(Finding_kind kind) const
  {
    for (const Finding& finding : findings)
      if (finding.kind == kind)
        return &finding;
    return nullptr;
  }

  /// returns the first fatal entry, or `nullptr` if the surface can be used. Complexity: constant.
  const Finding* first_fatal() const
  {
    for (const Finding& finding : findings)
      if (finding.is_fatal)
        return &finding;
    return nullptr;
  }
};

/// \cond SKIP_IN_MANUAL
namespace internal {

// How a kind is called, mended and thrown.
struct Finding_properties
{
  Invalid_surface_error::Defect defect;
  bool is_fatal;
  const char* singular; // the element that `count` counts
  const char* plural;
  const char* summary; // completes "3 ..."
  const char* advice;
};

const Finding_properties& finding_properties(const Finding_kind kind);
} // namespace internal
/// \endcond

/// \ingroup PkgIntrinsicTriangulationsValidation
/// \brief returns a sentence that says what was found, where, how often, and what to do about it.
/// \param finding an entry of a report
/// \param advice what to do about it, instead of the default advice for programmers; empty for no advice
/// \return for example "edge 3-17 has 4 faces (faces 5, 8, 9, 11), and 2 more edges like it; remove ...".
/// Complexity: constant.
std::string message(const Finding& finding, const std::optional<std::string>& advice = std::nullopt);

/// \ingroup PkgIntrinsicTriangulationsValidation
/// \brief returns a text that says what is wrong with a surface.
/// \param report what `examine_polygons()` returned
/// \param name the name of the surface, e.g. of its file; it precedes the text unless it is empty
/// \param advice what to do about the first fatal entry, instead of the default advice for programmers
/// \return if the report has fatal entries, the first one in full and the counts of the
/// others; otherwise all entries, one after the other; the
/// empty string if there is no entry. Complexity: constant.
std::string message(const Surface_report& report, const std::string& name = std::string(),
                    const std::optional<std::string>& advice = std::nullopt);

/// \ingroup PkgIntrinsicTriangulationsValidation
/// \brief does nothing if a surface can be used; otherwise throws an exception that says why not.
/// \param report what `examine_polygons()` returned
/// \param name the name of the surface, e.g. of its file; it precedes the message unless it is empty
/// \exception Invalid_surface_error with the defect, first element and count of the first
/// fatal entry (for an edge, the element is its first face), and the text of `message()`.
/// Complexity: constant.
void throw_if_fatal(const Surface_report& report, const std::string& name = std::string());

} // namespace Intrinsic_triangulations
} // namespace CGAL

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/internal/reports/Surface_report_impl.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SURFACE_REPORT_H
