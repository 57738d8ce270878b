// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Lengths of shortest paths between two sets of vertices.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_GEODESIC_DISTANCE_MATRIX_H
#define CGAL_INTRINSIC_TRIANGULATIONS_GEODESIC_DISTANCE_MATRIX_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Index.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/geodesic_distances.h>
#include <CGAL/Intrinsic_triangulations/internal/distances/Distance_search.h>
#include <CGAL/Intrinsic_triangulations/internal/matrices/Row_of_vertex.h>
#include <CGAL/Intrinsic_triangulations/internal/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/internal/system/for_each_block.h>
#include <CGAL/Intrinsic_triangulations/observer.h>
#include <CGAL/Intrinsic_triangulations/Tufted_cover.h>
#include <CGAL/Intrinsic_triangulations/internal/cover/Row_of_cover_vertex.h>

#include <CGAL/tags.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief the result of `geodesic_distance_matrix()`.
struct Geodesic_distance_matrix
{
  /// a row for each source with a column for each target; infinite where no path leads
  std::vector<std::vector<double>> distances;
  std::uint64_t number_of_ways = 0; ///< as in `Geodesic_distances`, for all sources
  bool is_complete = true;          ///< likewise
};

namespace internal {

// \param row finds the distances of the targets from one source
// \param progress is asked after each row
template <class ConcurrencyTag, class Row>
Geodesic_distance_matrix distance_matrix(const std::vector<Vertex_index>& sources, const Row& row,
                                         const Progress_function& progress)
{
  Geodesic_distance_matrix result;
  result.distances.resize(sources.size());
  std::atomic<std::uint64_t> number_of_ways{0};
  std::atomic<std::size_t> number_of_rows{0};
  std::atomic<bool> is_complete{true};
  for_each_block<ConcurrencyTag>(sources.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      Geodesic_distances found = row(sources[i]);
      result.distances[i] = std::move(found.distances);
      number_of_ways += found.number_of_ways;
      if (!found.is_complete)
        is_complete = false;
      report_progress(progress, double(++number_of_rows) / double(sources.size()), "the matrix of distances");
    }
  });
  result.number_of_ways = number_of_ways;
  result.is_complete = is_complete;
  return result;
}

template <class Search>
Geodesic_distances distances_of_targets(const Search& search, Vertex_index source,
                                        const std::vector<std::uint32_t>& targets)
{
  const Window_distances found = search.find(search.at_vertices({source}), targets);
  Geodesic_distances result{{}, found.number_of_steps, found.is_complete, {}};
  for (std::uint32_t row : targets)
    result.distances.push_back(found.distances[row]);
  return result;
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief returns the length of the shortest path from each source to each target.
///
/// The numbers are those of `geodesic_distances()` from each source. Straight ways are followed
/// only as far as the farthest target; paths along edges, which bound the distances, over the whole surface.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` (with TBB) or `Parallel_if_available_tag`: the sources are
///   distributed among the threads; the result is the same
/// \param triangulation a triangulation, preferably Delaunay
/// \param sources, targets vertices
/// \param np the named parameters of `geodesic_distances()`; `maximum_number` counts for each source. The visitor
///   gets the part of the sources that are done, or 0 in between; with `Parallel_tag`, several threads may call it at
///   once
/// \exception Invalid_argument_error if there is no such vertex, or the tolerance is out of range
/// \exception Cancelled_error if the visitor asks for it
template <class ConcurrencyTag = Sequential_tag, class Traits,
          class NamedParameters = parameters::Default_named_parameters>
Geodesic_distance_matrix geodesic_distance_matrix(const Intrinsic_triangulation<Traits>& triangulation,
                                                  const std::vector<Vertex_index>& sources,
                                                  const std::vector<Vertex_index>& targets,
                                                  const NamedParameters& np = parameters::default_values())
{
  const internal::Distance_search<Traits, internal::Row_of_vertex> search(
    triangulation, internal::Row_of_vertex(triangulation.connectivity()), np);
  const std::vector<std::uint32_t> rows = search.rows(targets);
  return internal::distance_matrix<ConcurrencyTag>(
    sources, [&](Vertex_index source) { return internal::distances_of_targets(search, source, rows); },
    internal::progress_function_of(np));
}

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief as above, for any triangles, as `geodesic_distances()` of a cover.
/// \param cover a cover that was made Delaunay
/// \param sources, targets vertices of the input
/// \param np as above
template <class ConcurrencyTag = Sequential_tag, class NamedParameters = parameters::Default_named_parameters>
Geodesic_distance_matrix geodesic_distance_matrix(const Tufted_cover& cover, const std::vector<Vertex_index>& sources,
                                                  const std::vector<Vertex_index>& targets,
                                                  const NamedParameters& np = parameters::default_values())
{
  using Traits = typename decltype(cover.triangulation)::Traits;
  const internal::Distance_search<Traits, internal::Row_of_cover_vertex> search(
    cover.triangulation, internal::Row_of_cover_vertex(cover), np);
  const std::vector<std::uint32_t> rows = search.rows(targets);
  return internal::distance_matrix<ConcurrencyTag>(
    sources, [&](Vertex_index source) { return internal::distances_of_targets(search, source, rows); },
    internal::progress_function_of(np));
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_GEODESIC_DISTANCE_MATRIX_H
