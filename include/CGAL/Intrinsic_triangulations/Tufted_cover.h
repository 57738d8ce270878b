// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A closed oriented surface over any triangles.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TUFTED_COVER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TUFTED_COVER_H

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/Delta_complex_builder.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/triangle_formulas_3.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Standard_arithmetic.h>
#include <CGAL/Intrinsic_triangulations/internal/system/shown_text.h>
#include <CGAL/Intrinsic_triangulations/mollify.h>
#include <CGAL/Intrinsic_triangulations/internal/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/observer.h>

#include <CGAL/number_utils.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsCover
/// \brief the surface that `make_tufted_cover()` builds over the triangles.
enum class Surface_cover {
  /// The tufted cover, which takes any triangles and has no border.
  TUFTED,
  /// The triangles themselves, turned over where neighbors disagree: no edge may have more than two faces, and
  /// the surface must be orientable. Border edges stay border edges.
  NONE,
  /// As `NONE`, for any triangles: they are cut apart at edges with more than two faces, and where neighbors cannot be
  /// made to agree. `geodesic_distances()` continues from each of the resulting border edges to all others.
  SHEETS
};

/// \ingroup PkgIntrinsicTriangulationsCover
/// \brief how edges between two vertices at the same place are handled.
enum class Coincident_vertices {
  ERROR, ///< an exception names them
  MERGE, ///< they become one vertex, and their faces lose a corner
  DROP   ///< the faces at such an edge are left out
};

/// \ingroup PkgIntrinsicTriangulationsCover
/// \brief the defects of the triangles, and how they were handled.
struct Tufted_cover_report
{
  std::size_t number_of_vertices = 0;   ///< the vertices given
  std::size_t number_of_faces = 0;      ///< the faces given
  std::size_t nonmanifold_edges = 0;    ///< edges with more than two faces
  std::size_t nonmanifold_vertices = 0; ///< vertices whose faces form more than one fan
  std::size_t border_edges = 0;         ///< edges with one face
  bool is_orientable = true; ///< whether all faces can be turned so that they agree across each edge with two faces
  std::size_t repeated_corner_faces = 0; ///< faces dropped because they name a vertex twice
  std::size_t collapsed_faces = 0;       ///< faces dropped because some of their corners were merged
  std::size_t zero_length_faces = 0;     ///< faces dropped by `Coincident_vertices::DROP`
  std::size_t faces_without_area = 0;    ///< faces of zero area that share no edge with one that has an area
  std::size_t merged_vertices = 0;       ///< vertices merged into another one
  std::size_t unreferenced_vertices = 0; ///< vertices of no remaining face: their rows are zero
  Mollification_report mollification;    ///< the changes by mollification, if requested

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
/// A connected part of the input that is closed, orientable and has two faces at each edge is its own cover. A tufted
/// cover has two copies of each face of all other parts, one of them turned over; such a part counts half. The other
/// covers have one copy of each face. The first vertices of the cover are the input vertices, with the same numbers.
/// More follow where the faces at an input vertex form several fans in the cover. Vertices without faces are isolated.
struct Tufted_cover
{
  /// the cover with its exact metric, before any flip
  Intrinsic_triangulation<Filtered_edge_length_traits> triangulation;
  /// for each vertex of the cover, the input vertex below it
  std::vector<std::uint32_t> vertex_of;
  /// for each face of the cover, the input face below it, of which it may be a part; flips make it meaningless
  std::vector<std::uint32_t> face_of;
  /// for each face of the cover, whether it is the copy that is turned over
  std::vector<bool> is_back;
  /// for each face of the cover, whether it counts half, like all faces that flips can join with it
  std::vector<bool> is_half;
  /// for each input vertex, the vertex that represents it: another one if it was merged
  std::vector<std::uint32_t> representative;
  /// the defects and how they were handled
  Tufted_cover_report report;
  /// whether border edges of the cover between the same vertices of the input are one edge that was cut
  bool is_cut = false;
  /// an edge at which all faces have zero area
  struct Flat_edge
  {
    std::uint32_t source; ///< a vertex of the input that represents itself
    std::uint32_t target; ///< another one
    double length;        ///< its length
    std::uint32_t face;   ///< a face of the input in which it lies
  };
  /// the edges that are not in the cover because all their faces have zero area, such as those of flat spikes
  std::vector<Flat_edge> flat_edges;
};

namespace internal {

struct Cover_options
{
  Surface_cover cover;
  Coincident_vertices coincident_vertices;
  bool is_welded;
  double mollification;
  std::function<bool()> go_further;
};

template <class NamedParameters>
Cover_options cover_options_of(const NamedParameters& np)
{
  return {value_of<Parameter::SURFACE_COVER>(np, Surface_cover::TUFTED),
          value_of<Parameter::COINCIDENT_VERTICES>(np, Coincident_vertices::MERGE),
          value_of<Parameter::IS_WELDED>(np, false), value_of<Parameter::MOLLIFICATION>(np, 0.),
          go_further_function_of(np)};
}

template <class PointRange>
Points copy_points(const PointRange& points)
{
  Points result;
  result.reserve(std::size_t(std::distance(std::begin(points), std::end(points))));
  for (const auto& p : points)
    result.push_back({to_double(p[0]), to_double(p[1]), to_double(p[2])});
  if (result.size() >= (std::numeric_limits<std::uint32_t>::max)())
    throw Invalid_surface_error(Invalid_surface_error::Defect::OUT_OF_RANGE, 0, 1,
                                "there are too many vertices for 32-bit indices");
  return result;
}

template <class TriangleRange>
std::vector<Index_triangle> copy_triangles(const TriangleRange& triangles, std::size_t number_of_vertices)
{
  std::vector<Index_triangle> result;
  result.reserve(std::size_t(std::distance(std::begin(triangles), std::end(triangles))));
  for (const auto& t : triangles) {
    for (int i = 0; i < 3; ++i)
      if (std::size_t(t[i]) >= number_of_vertices)
        throw Invalid_surface_error(Invalid_surface_error::Defect::BAD_INDEX, result.size(), 1,
                                    "face " + std::to_string(result.size()) + " names vertex " +
                                      index_text(std::size_t(t[i])) + ", but there are only " +
                                      std::to_string(number_of_vertices) + " vertices");
    result.push_back({std::uint32_t(t[0]), std::uint32_t(t[1]), std::uint32_t(t[2])});
  }
  if (result.empty())
    throw Invalid_surface_error(Invalid_surface_error::Defect::EMPTY, 0, 1, "there is no face");
  return result;
}

// As make_tufted_cover().
// \pre the vertices of all triangles exist
Tufted_cover build_cover(const Points& points, const std::vector<Index_triangle>& triangles,
                         const Cover_options& options);

// As make_tufted_cover() for a complex.
Tufted_cover build_cover_of_complex(const Delta_complex& complex, const std::vector<double>& lengths,
                                    const Cover_options& options);

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsCover
/// \brief builds an oriented surface without border over any triangles, for operators that need one.
///
/// Each face gets two copies, the second turned over. At each edge the copies are glued in the order of the faces
/// around it: the copy with the face on its left to the copy of the next face, counterclockwise, with the face on its
/// right. A single face at an edge is glued to its own copy. So the cover is closed and oriented whatever the triangles
/// are. Their edges may have any number of faces, their orientations need not agree, they may form a Möbius strip, and
/// faces may be given several times. A part that is closed, orientable and has two faces at each edge is not doubled.
///
/// The order is decided exactly from the points, and depends neither on how these are rotated nor on how vertices and
/// faces are numbered, except where isosceles triangles over the same edge lie in one half-plane, or third vertices
/// are at the same place.
///
/// Faces that name a vertex twice are dropped. Faces of zero area are segments: the faces at their longest side are cut
/// at their third corner, which changes no distance, and edges that have no other faces remain as `flat_edges`. If they
/// join vertices at the same place, these are one point of the cover. The parameter `coincident_vertices` determines
/// how such vertices and edges of length zero are handled.
///
/// \tparam PointRange a range of points whose coordinates are `p[0]`, `p[1]` and `p[2]`; they are rounded to `double`
/// \tparam TriangleRange a range of random access ranges of three vertex indices each
///
/// \param points the vertices; vertices without faces may have any position
/// \param triangles the faces
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{surface_cover}
///     \cgalParamDescription{the surface to build}
///     \cgalParamType{`Surface_cover`}
///     \cgalParamDefault{`Surface_cover::TUFTED`}
///   \cgalParamNEnd
///   \cgalParamNBegin{coincident_vertices}
///     \cgalParamDescription{how edges of length zero are handled}
///     \cgalParamType{`Coincident_vertices`}
///     \cgalParamDefault{`Coincident_vertices::MERGE`}
///   \cgalParamNEnd
///   \cgalParamNBegin{is_welded}
///     \cgalParamDescription{whether all vertices at the same place become one, whether an edge joins them or not: for
///       triangles that do not share their corners}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{mollification}
///     \cgalParamDescription{if positive, lengths are rounded and edges lengthened as by `mollify_lengths()` with this
///       margin; the metric changes, and the report says how much}
///     \cgalParamType{`double`}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
///   \cgalParamVisitor{is called from time to time, and can cancel}
/// \cgalNamedParamsEnd
///
/// \return the cover, not flipped: see `flip_to_Delaunay()`, and `tufted_Laplacian()` for its operator
///
/// \exception Invalid_surface_error if there is no face, an index is invalid, the point of a face is not finite or its
///   squared lengths leave the range of `double`; if an edge has length zero and `Coincident_vertices::ERROR` is
///   chosen; or if `Surface_cover::NONE` is chosen and the faces are not an orientable surface
/// \exception Cancelled_error if the visitor asks for it
///
/// Complexity: O(n), and O(k log k) for an edge with k faces.
///
/// Source: N. Sharp, K. Crane, "A Laplacian for nonmanifold triangle meshes", 2020, section 4.
template <class PointRange, class TriangleRange, class NamedParameters = parameters::Default_named_parameters>
Tufted_cover make_tufted_cover(const PointRange& points, const TriangleRange& triangles,
                               const NamedParameters& np = parameters::default_values())
{
  const internal::Standard_arithmetic arithmetic;
  const internal::Points copied = internal::copy_points(points);
  return internal::build_cover(copied, internal::copy_triangles(triangles, copied.size()),
                               internal::cover_options_of(np));
}

/// \ingroup PkgIntrinsicTriangulationsCover
/// \brief as `make_tufted_cover()` of points, for a surface given by lengths: doubled if it has a border.
/// \param complex the triangles
/// \param lengths the length of each edge
/// \param np as above; only `surface_cover` and `mollification` apply to a complex
/// \exception Invalid_surface_error if a length is not positive and finite, or three violate the triangle inequality.
///   O(n).
template <class NamedParameters = parameters::Default_named_parameters>
Tufted_cover make_tufted_cover(const Delta_complex& complex, const std::vector<double>& lengths,
                               const NamedParameters& np = parameters::default_values())
{
  const internal::Standard_arithmetic arithmetic;
  return internal::build_cover_of_complex(complex, lengths, internal::cover_options_of(np));
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TUFTED_COVER_H
