// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A surface prepared for finding distances from several sets of sources.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_DISTANCE_SEARCH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_DISTANCE_SEARCH_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Geodesic_source.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/Index.h>
#include <CGAL/Intrinsic_triangulations/internal/distances/Curve_sources.h>
#include <CGAL/Intrinsic_triangulations/internal/distances/Distance_bounds.h>
#include <CGAL/Intrinsic_triangulations/internal/distances/Laid_out_faces.h>
#include <CGAL/Intrinsic_triangulations/internal/distances/Places.h>
#include <CGAL/Intrinsic_triangulations/internal/distances/Window_propagation.h>
#include <CGAL/Intrinsic_triangulations/internal/distances/Window_sources.h>
#include <CGAL/Intrinsic_triangulations/internal/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>
#include <CGAL/Intrinsic_triangulations/observer.h>

#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The maximum number of bundles of straight ways.
template <class NamedParameters>
std::uint64_t number_of_ways(const NamedParameters& np, const Delta_complex& complex)
{
  return parameters::choose_parameter(parameters::get_parameter(np, internal_np::maximum_number),
                                      1000000 + 500 * std::uint64_t(complex.number_of_faces()));
}

// Distances by windows, between their bounds and in the unit of the input; only those of the goals if there are any.
Window_distances bounded_distances(const Laid_out_faces& faces, const Distance_bounds& bounds, double tolerance,
                                   const Window_sources& sources, std::uint64_t most, const Interruption& interruption,
                                   const std::vector<std::uint32_t>& goals);

// Rows near the sources with their distances, and how much farther a point of a source may be from a row.
struct Distances_near_sources
{
  std::map<std::uint32_t, double> of_rows;
  double farther = 0;
};

// The distances of the corners of the faces that contain sources, in the unit of the input.
Distances_near_sources distances_near_sources(const Laid_out_faces& faces, const Distance_bounds& bounds,
                                              const Window_sources& sources, std::uint64_t most,
                                              const Interruption& interruption);

// \tparam Row gives the row of a vertex, as Row_of_vertex
template <class Traits, class Row>
class Distance_search
{
public:
  // \param triangulation, row must outlive this
  // \exception Invalid_argument_error if the tolerance is out of range
  template <class NamedParameters>
  Distance_search(const Intrinsic_triangulation<Traits>& triangulation, Row row, const NamedParameters& np)
    : row_(std::move(row)), tolerance_(checked_tolerance(value_of<Parameter::TOLERANCE>(np, 0.001))),
      most_(number_of_ways(np, triangulation.connectivity())), interruption_(go_further_function_of(np)),
      by_place_(with_ties_by_place(triangulation, row_, interruption_)),
      triangulation_(by_place_ ? *by_place_ : triangulation), faces_(triangulation_, row_),
      bounds_(triangulation_, row_)
  {}
  Distance_search(const Distance_search&) = delete; // refers to itself
  Distance_search& operator=(const Distance_search&) = delete;

  std::uint32_t row_of_input(Vertex_index v) const { return row_.of_input(v); }

  // \param sources vertices: for a cover, vertices of its input, as in the result
  // \exception Invalid_argument_error if there is no such vertex
  Window_sources at_vertices(const std::vector<Vertex_index>& sources) const
  {
    Window_sources result;
    for (std::uint32_t row : rows(sources))
      result.rows.push_back({row, 0, 0, {}});
    return result;
  }
  std::vector<std::uint32_t> rows(const std::vector<Vertex_index>& vertices) const
  {
    std::vector<std::uint32_t> result;
    for (Vertex_index v : vertices) {
      require_vertex(v, row_.number_of_rows());
      result.push_back(row_.of_input(v));
    }
    return result;
  }

  Window_sources at_points(const std::vector<Geodesic_source>& sources) const
  {
    return sources_in_faces(engine(triangulation_), triangulation_.connectivity(), faces_, sources);
  }

  Window_distances find(const Window_sources& sources, const std::vector<std::uint32_t>& goals = {}) const
  {
    return bounded_distances(faces_, bounds_, tolerance_, sources, most_, interruption_, goals);
  }

  Distances_near_sources near(const Window_sources& sources) const
  {
    return distances_near_sources(faces_, bounds_, sources, most_, interruption_);
  }

  // The waves up to a distance, in the unit of the input.
  Waves waves(const Window_sources& sources, double farthest) const
  {
    return find_waves(faces_, tolerance_, sources, most_, interruption_, std::ldexp(farthest, -faces_.exponent()));
  }

  // The distances of all rows, in the unit of the input; those beyond `farthest` may be too large.
  std::vector<double> distances_up_to(const Window_sources& sources, double farthest) const
  {
    std::vector<double> result =
      propagate_windows(faces_, tolerance_, sources, most_, interruption_, {}, std::ldexp(farthest, -faces_.exponent()))
        .distances;
    for (double& d : result)
      d = std::ldexp(d, faces_.exponent());
    return result;
  }

  double tolerance() const { return tolerance_; }
  const Interruption& interruption() const { return interruption_; }
  const Intrinsic_triangulation<Traits>& triangulation() const { return triangulation_; }
  const Laid_out_faces& faces() const { return faces_; }

private:
  static double checked_tolerance(double tolerance)
  {
    if (!(tolerance >= 0 && tolerance < 1))
      throw Invalid_argument_error("the tolerance of distances has to be at least 0 and less than 1");
    return tolerance;
  }

  Row row_;
  double tolerance_;
  std::uint64_t most_;
  Interruption interruption_;
  std::optional<Intrinsic_triangulation<Traits>> by_place_;
  const Intrinsic_triangulation<Traits>& triangulation_;
  Laid_out_faces faces_;
  Distance_bounds bounds_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_DISTANCE_SEARCH_H
