// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Triangles without those that no cover can have.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COVER_CLEANED_TRIANGLES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COVER_CLEANED_TRIANGLES_H

#include <CGAL/Intrinsic_triangulations/Tufted_cover.h>
#include <CGAL/Intrinsic_triangulations/config.h>
#include <CGAL/Intrinsic_triangulations/internal/gluing/Sides_by_edge.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/Points.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

using Vertex_number_pair = std::pair<std::uint32_t, std::uint32_t>;

// Triangles whose corners are at three different places, by the vertices that stand for those given.
struct Cleaned_triangles
{
  std::vector<Index_triangle> triangles;
  std::vector<std::uint32_t> input_face;     // of each triangle
  std::vector<std::uint32_t> representative; // of each vertex
  Tufted_cover_report report;                // numbers of vertices, faces, and what was dropped and merged
};

// \param merged pairs of vertices that become one, besides those that the options merge
// \exception Invalid_surface_error if the point of a vertex with a face is not finite, or by Coincident_vertices::ERROR
// \pre the vertices exist
Cleaned_triangles clean_triangles(const Points& points, std::vector<Index_triangle> triangles,
                                  const Tufted_cover_options& options, const std::vector<Vertex_number_pair>& merged);

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/internal/cover/Cleaned_triangles_impl.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COVER_CLEANED_TRIANGLES_H
