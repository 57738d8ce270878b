// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Lengths of shortest paths over the surface, from vertices, points, curves and regions.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_GEODESIC_DISTANCES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_GEODESIC_DISTANCES_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Geodesic_source.h>
#include <CGAL/Intrinsic_triangulations/Index.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/distances/Distance_search.h>
#include <CGAL/Intrinsic_triangulations/internal/matrices/Row_of_vertex.h>
#include <CGAL/Intrinsic_triangulations/internal/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/observer.h>
#include <CGAL/Intrinsic_triangulations/Tufted_cover.h>
#include <CGAL/Intrinsic_triangulations/internal/cover/Row_of_cover_vertex.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief the result of `geodesic_distances()`.
struct Geodesic_distances
{
  std::vector<double> distances; ///< of all vertices, in the unit of the input; infinite where no source is connected
  std::uint64_t number_of_ways = 0; ///< how often a bundle of straight lines was followed to the next face
  bool is_complete = true;          ///< whether all were followed; if not, distances may be as large as along edges
  static constexpr std::uint32_t no_source = std::uint32_t(-1); ///< in `nearest_sources`
  /// set by `geodesic_distances_from()` only: for each vertex, the number of the nearest `Geodesic_source`, or
  /// `no_source` if no straight way leads there
  std::vector<std::uint32_t> nearest_sources;
};

namespace internal {

// The distances of all vertices of the input, by rows.
template <class Search>
Geodesic_distances by_vertices(const Search& search, Window_distances found)
{
  Geodesic_distances result{{}, found.number_of_steps, found.is_complete, {}};
  result.distances.reserve(found.distances.size());
  for (std::size_t v = 0; v < found.distances.size(); ++v) {
    const std::uint32_t row = search.row_of_input(Vertex_index(Vertex_index::size_type(v)));
    result.distances.push_back(found.distances[row]);
    result.nearest_sources.push_back(found.origins[row]);
  }
  return result;
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief returns the length of the shortest path on the surface from the nearest source to each vertex.
///
/// Straight lines that cross the same edges are followed together, from face to face, the nearest first. Paths bend at
/// vertices whose angles sum to more than 2π, and at the border. With a positive tolerance, bundles that meet at an
/// edge are merged if that changes no length by more than the tolerance. On a Delaunay triangulation there are then
/// about four to ten bundles for each face, and fewer the finer the faces are. Their number may grow quadratically with
/// the number of faces if the tolerance is zero, or if many thin faces meet.
///
/// Distances are zero only at the sources. They never exceed the shortest path along edges of the triangulation or of
/// its input and, for a surface in space, are never shorter than the straight line. They do not depend on other
/// components of the surface, nor on the numbers of vertices and faces if the vertices of the input are points at
/// different places: edges by which Delaunay triangulations of one surface differ are replaced in a copy, unless they are
/// in the input.
///
/// \param triangulation a triangulation, preferably Delaunay, so that paths cross few faces
/// \param sources vertices
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{tolerance}
///     \cgalParamDescription{how much the length of a path may be changed at each edge that it crosses, as a fraction
///       of the length of the edge. With 0, distances are exact up to rounding; a positive tolerance saves much time on
///       large surfaces}
///     \cgalParamType{`double`, at least 0 and less than 1}
///     \cgalParamDefault{0.001}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_number}
///     \cgalParamDescription{the maximum number of steps of bundles from one face to the next}
///     \cgalParamType{`std::uint64_t`}
///     \cgalParamDefault{a million, and 500 for each face}
///   \cgalParamNEnd
///   \cgalParamVisitor{is called from time to time, and can cancel}
/// \cgalNamedParamsEnd
///
/// \exception Invalid_argument_error if there is no such vertex, or the tolerance is out of range
/// \exception Cancelled_error if the visitor asks for it
///
/// Source: J. Chen, Y. Han, "Shortest paths on a polyhedron", 1996; V. Surazhsky et al., "Fast exact and approximate
/// geodesics on meshes", 2005; S. Xin, G. Wang, "Improving Chen and Han's algorithm on the discrete geodesic problem",
/// 2009.
template <class Traits, class NamedParameters = parameters::Default_named_parameters>
Geodesic_distances geodesic_distances(const Intrinsic_triangulation<Traits>& triangulation,
                                      const std::vector<Vertex_index>& sources,
                                      const NamedParameters& np = parameters::default_values())
{
  const internal::Distance_search<Traits, internal::Row_of_vertex> search(
    triangulation, internal::Row_of_vertex(triangulation.connectivity()), np);
  return internal::by_vertices(search, search.find(search.at_vertices(sources)));
}

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief as `geodesic_distances()` of a triangulation, for any triangles. The vertices are those of the input; merged
/// vertices have the same distance. Ways lead along edges of faces of zero area, too.
///
/// If the cover is made of sheets (`Surface_cover::SHEETS`), paths go from each face at an edge into all others. On a
/// tufted cover, they go into the next faces around an edge only; distances across edges with more than two faces are
/// then too long.
/// \param cover a cover
/// \param sources vertices of the input
/// \param np as above
/// \pre the cover was made Delaunay by `flip_to_Delaunay(cover.triangulation)`, or the faces are the given ones
template <class NamedParameters = parameters::Default_named_parameters>
Geodesic_distances geodesic_distances(const Tufted_cover& cover, const std::vector<Vertex_index>& sources,
                                      const NamedParameters& np = parameters::default_values())
{
  using Traits = typename decltype(cover.triangulation)::Traits;
  const internal::Distance_search<Traits, internal::Row_of_cover_vertex> search(
    cover.triangulation, internal::Row_of_cover_vertex(cover), np);
  return internal::by_vertices(search, search.find(search.at_vertices(sources)));
}

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief returns the length of the shortest path from the nearest of several points, curves and regions to each vertex.
///
/// Ways leave a curve at right angles as parallel fronts, which are followed as straight lines from a point are. So
/// with a tolerance of 0, distances from curves are exact up to rounding, too. Vertices on a curve have the distance
/// zero. No distance is longer than along edges from the corners of the faces with sources; with a positive tolerance,
/// distances from curves may be shorter than the straight line by as much as the tolerance allows.
///
/// \param triangulation a triangulation that keeps its input
/// \param sources points of `triangulation.input()`
/// \param np as above
/// \exception Invalid_point_error if a point does not lie on the surface, or two consecutive points of a curve do not
///   lie in the face of the first
/// \exception Invalid_argument_error if an offset is negative or not finite, or the tolerance is out of range
/// \exception Cancelled_error, Undecided_error as `trace_geodesic()`
template <class Traits, class NamedParameters = parameters::Default_named_parameters>
Geodesic_distances geodesic_distances_from(const Intrinsic_triangulation<Traits>& triangulation,
                                           const std::vector<Geodesic_source>& sources,
                                           const NamedParameters& np = parameters::default_values())
{
  const internal::Distance_search<Traits, internal::Row_of_vertex> search(
    triangulation, internal::Row_of_vertex(triangulation.connectivity()), np);
  return internal::by_vertices(search, search.find(search.at_points(sources)));
}

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief as above, for any triangles.
/// \param cover a cover that was made Delaunay
/// \param sources points of `cover.triangulation.input()`, as given by `sources_on_cover()`
/// \param np as above
template <class NamedParameters = parameters::Default_named_parameters>
Geodesic_distances geodesic_distances_from(const Tufted_cover& cover, const std::vector<Geodesic_source>& sources,
                                           const NamedParameters& np = parameters::default_values())
{
  using Traits = typename decltype(cover.triangulation)::Traits;
  const internal::Distance_search<Traits, internal::Row_of_cover_vertex> search(
    cover.triangulation, internal::Row_of_cover_vertex(cover), np);
  return internal::by_vertices(search, search.find(search.at_points(sources)));
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_GEODESIC_DISTANCES_H
