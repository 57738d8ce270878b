// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Distances on a surface with intervals that are proven to contain them, by way of a simplified surface.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SIMPLIFIED_DISTANCES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SIMPLIFIED_DISTANCES_H

#include <CGAL/Intrinsic_triangulations/internal/distances/Laid_out_faces.h>
#include <CGAL/Intrinsic_triangulations/internal/distances/Laid_out_points.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>
#include <CGAL/Intrinsic_triangulations/internal/system/for_each_block.h>
#include <CGAL/Intrinsic_triangulations/observer.h>
#include <CGAL/Intrinsic_triangulations/simplify_surface.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <mutex>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsSimplification
/// \brief distances of all vertices of a surface, each between two bounds.
struct Distance_intervals
{
  std::vector<double> distances; ///< on the simplified surface; infinite where no source is connected
  std::vector<double> lower;     ///< on the surface itself, distances are not shorter
  std::vector<double> upper;     ///< and not longer
};

/// \ingroup PkgIntrinsicTriangulationsSimplification
/// \brief finds distances between the vertices of a surface by way of a simplified one.
///
/// Straight ways are followed on the simplified surface, exactly up to rounding, between the places of the vertices. So
/// the intervals contain the distances on the surface itself, up to rounding, and they are as narrow as the
/// simplification allows. Any number of threads may ask one object.
class Simplified_distances
{
public:
  /// \brief O(size of both surfaces).
  /// \param surface the result of `simplify_surface()`, which is not needed later
  explicit Simplified_distances(const Simplified_surface& surface);

  /// returns the number of vertices of the surface that was simplified.
  std::size_t number_of_vertices() const { return changes_.size(); }

  /// \brief returns the distance of each vertex from the nearest source.
  /// \param sources vertices of the surface that was simplified
  /// \param np an optional sequence of named parameters
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamVisitor{is called from time to time, and can cancel}
  /// \cgalNamedParamsEnd
  ///
  /// \exception Invalid_argument_error if there is no such vertex
  /// \exception Cancelled_error if the visitor asks for it
  template <class NamedParameters = parameters::Default_named_parameters>
  Distance_intervals from(const std::vector<Vertex_index>& sources,
                          const NamedParameters& np = parameters::default_values()) const
  {
    return find(sources, internal::Interruption(internal::go_further_function_of(np)));
  }

  /// \brief finds the distances between all vertices: calls `visit(source, intervals)` for each vertex.
  ///
  /// The results are not kept: for 32,000 vertices, they are a billion numbers.
  /// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` (with TBB) or `Parallel_if_available_tag`: then several
  ///   threads call `visit` at once
  /// \param visit a function of a `Vertex_index` and of the `Distance_intervals` from it
  /// \param np an optional sequence of named parameters
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamVisitor{is called after each source with the fraction that is done, by one thread at a time, and can
  ///     cancel}
  /// \cgalNamedParamsEnd
  ///
  /// \exception Cancelled_error if the visitor asks for it
  template <class ConcurrencyTag = Sequential_tag, class Visit,
            class NamedParameters = parameters::Default_named_parameters>
  void from_each(const Visit& visit, const NamedParameters& np = parameters::default_values()) const
  {
    const Progress_function progress = internal::progress_function_of(np);
    std::mutex mutex;
    std::size_t done = 0;
    internal::for_each_block<ConcurrencyTag>(number_of_vertices(), 8, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const Vertex_index v(static_cast<Vertex_index::size_type>(i));
        visit(v, find({v}, internal::Interruption()));
        const std::lock_guard<std::mutex> lock(mutex);
        internal::report_progress(progress, double(++done) / double(number_of_vertices()), "finding all distances");
      }
    });
  }

private:
  Distance_intervals find(const std::vector<Vertex_index>& sources, const internal::Interruption& interruption) const;

  internal::Laid_out_faces faces_;
  internal::Laid_out_points points_;
  std::vector<Metric_change> changes_; // of the component of each vertex
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SIMPLIFIED_DISTANCES_H
