// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Builds a closed oriented surface over any triangles.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_MAKE_TUFTED_COVER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_MAKE_TUFTED_COVER_H

#include <CGAL/Intrinsic_triangulations/Tufted_cover.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/cover/Cover_builder.h>
#include <CGAL/Intrinsic_triangulations/internal/cover/Cover_of_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Standard_arithmetic.h>
#include <CGAL/Intrinsic_triangulations/internal/system/shown_text.h>

#include <CGAL/number_utils.h>

#include <cstddef>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \cond SKIP_IN_MANUAL
namespace internal {

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

} // namespace internal
/// \endcond

/// \ingroup PkgIntrinsicTriangulationsCover
/// \brief builds an oriented surface without border over any triangles, for operators that want one.
///
/// Two copies are made of each face, the second turned over. At each edge the copies are glued in the order in which the
/// faces lie around it: the copy that has a face on its left with that of the next face, counterclockwise,
/// that has it on its right. A single face at an edge is glued to its own copy. So the cover is closed and oriented
/// whatever the triangles are. Their edges may have any number of faces, their orientations need not agree, they may form a
/// Möbius strip, and faces may be given several times. What is closed, orientable and has two faces
/// at each edge is not doubled.
///
/// The order is decided exactly from the points, and depends neither on how these are rotated nor on how vertices and faces
/// are numbered, except where isosceles triangles over the same edge lie in one half-plane, third vertices are at the
/// same place, or more than two faces meet at the edge of one without area and several of them reach farthest.
///
/// Faces that name a vertex twice are dropped. So are parts of the cover without area. Other faces without area are flipped
/// away, which cuts the faces beside them and changes no distance. Where they join vertices at the same place, these are one
/// point of the cover. `Tufted_cover_options` says what happens then, and to edges of length zero.
///
/// \tparam PointRange a range of points whose coordinates are `p[0]`, `p[1]` and `p[2]`; they are rounded to `double`
/// \tparam TriangleRange a range of random access ranges of three vertex indices each
///
/// \param points the vertices; those without faces may be anywhere
/// \param triangles the faces
/// \param options what is built, and what is done with degenerate input
///
/// \return the cover, not flipped: see `flip_to_Delaunay()`, and `tufted_Laplacian()` for its operator
///
/// \exception Invalid_surface_error if there is no face, an index is invalid, the point of a face is not finite or its
///   squared lengths leave the range of `double`; if an edge has length zero and `Coincident_vertices::ERROR` is
///   chosen; or if `Surface_cover::NONE` is chosen and the faces are not an orientable surface
/// \exception Cancelled_error if `options.go_further` says so
///
/// Complexity: O(n), and O(k log k) for an edge with k faces.
///
/// Source: N. Sharp, K. Crane, "A Laplacian for nonmanifold triangle meshes", 2020, section 4.
template <class PointRange, class TriangleRange>
Tufted_cover make_tufted_cover(const PointRange& points, const TriangleRange& triangles,
                               const Tufted_cover_options& options = Tufted_cover_options())
{
  const internal::Standard_arithmetic arithmetic;
  const internal::Points copied = internal::copy_points(points);
  return internal::build_cover(copied, internal::copy_triangles(triangles, copied.size()), options);
}

/// \ingroup PkgIntrinsicTriangulationsCover
/// \brief as above, for a surface that is given by lengths: doubled if it has a border.
/// \param complex the triangles
/// \param lengths the length of each edge
/// \param options `cover` and `mollification` count, as a complex leaves nothing else open
/// \exception Invalid_surface_error if a length is not positive and finite, or three violate the triangle inequality. O(n).
inline Tufted_cover make_tufted_cover(const Delta_complex& complex, const std::vector<double>& lengths,
                                      const Tufted_cover_options& options = Tufted_cover_options())
{
  const internal::Standard_arithmetic arithmetic;
  return internal::build_cover_of_complex(complex, lengths, options);
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_MAKE_TUFTED_COVER_H
