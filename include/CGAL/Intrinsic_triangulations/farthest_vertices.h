// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Vertices that are as far as possible from each other.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FARTHEST_VERTICES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FARTHEST_VERTICES_H

#include <CGAL/Intrinsic_triangulations/geodesic_distances.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief a vertex, as chosen by `farthest_vertices()`.
struct Farthest_vertex
{
  Vertex_index vertex; ///< of the input
  double distance;     ///< from the sources and the vertices chosen before; infinite if no path leads there
};

namespace internal {

template <class Search>
std::vector<Farthest_vertex> farthest_vertices(const Search& search, std::size_t number_of_vertices,
                                               const std::vector<Geodesic_source>& sources, std::size_t number)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> distances = search.distances_up_to(search.at_points(sources), infinity);
  std::vector<Farthest_vertex> result;
  while (result.size() < number) {
    Farthest_vertex next{{}, 0};
    for (std::size_t i = 0; i < number_of_vertices; ++i) {
      const Vertex_index v{Vertex_index::size_type(i)};
      const std::uint32_t row = search.row_of_input(v);
      if (distances[row] > next.distance && search.faces().first_corner(row) < search.faces().first_corner(row + 1))
        next = {v, distances[row]};
    }
    if (next.distance == 0)
      break;
    result.push_back(next);
    const std::vector<double> nearer = search.distances_up_to(search.at_vertices({next.vertex}), next.distance);
    for (std::size_t row = 0; row < distances.size(); ++row)
      distances[row] = (std::min)(distances[row], nearer[row]);
  }
  return result;
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief returns vertices, each of which is as far as possible from the sources and the ones before.
///
/// Of several that are equally far, the first one is taken; of those that no path reaches, too. The ways from each are
/// followed no farther than its distance, so that later ones take less time.
///
/// \param triangulation a triangulation that keeps its input
/// \param sources points of `triangulation.input()`; none to begin with the first vertex
/// \param number how many vertices are wanted; there are fewer if all others have the distance 0
/// \param np the named parameters of `geodesic_distances()`
/// \exception Invalid_argument_error, Invalid_point_error, Cancelled_error, Undecided_error as
///   `geodesic_distances_from()`
template <class Traits, class NamedParameters = parameters::Default_named_parameters>
std::vector<Farthest_vertex> farthest_vertices(const Intrinsic_triangulation<Traits>& triangulation,
                                               const std::vector<Geodesic_source>& sources, std::size_t number,
                                               const NamedParameters& np = parameters::default_values())
{
  const internal::Distance_search<Traits, internal::Row_of_vertex> search(
    triangulation, internal::Row_of_vertex(triangulation.connectivity()), np);
  return internal::farthest_vertices(search, triangulation.input().number_of_vertices(), sources, number);
}

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief as above, for any triangles.
/// \param cover a cover that was made Delaunay
/// \param sources points of `cover.triangulation.input()`, as given by `sources_on_cover()`
/// \param number, np as above
template <class NamedParameters = parameters::Default_named_parameters>
std::vector<Farthest_vertex> farthest_vertices(const Tufted_cover& cover, const std::vector<Geodesic_source>& sources,
                                               std::size_t number,
                                               const NamedParameters& np = parameters::default_values())
{
  using Traits = typename decltype(cover.triangulation)::Traits;
  const internal::Distance_search<Traits, internal::Row_of_cover_vertex> search(
    cover.triangulation, internal::Row_of_cover_vertex(cover), np);
  return internal::farthest_vertices(search, cover.representative.size(), sources, number);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FARTHEST_VERTICES_H
