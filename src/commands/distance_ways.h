// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances on any surface: along straight ways, by heat, and between two sets.

#ifndef IDT_DISTANCE_WAYS_H
#define IDT_DISTANCE_WAYS_H

#include "commands/distance_options.h"
#include "commands/distance_result.h"
#include "system/Interruption.h"
#include "system/Progress.h"

#include <CGAL/Intrinsic_triangulations/Heat_method.h>
#include <CGAL/Intrinsic_triangulations/geodesic_distance_matrix.h>
#include <CGAL/Intrinsic_triangulations/geodesic_distances.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace idt {

namespace IT = CGAL::Intrinsic_triangulations;

// Where distances begin.
struct Ways_from
{
  std::vector<IT::Vertex_index> vertices;
  std::vector<IT::Geodesic_source> places; // instead of the vertices, if there are any
};

inline auto geodesic_options(double tolerance)
{
  return CGAL::parameters::tolerance(tolerance).visitor([] { return !is_interrupted(); });
}

// \tparam Any_surface a triangulation, or a tufted cover
template <class Any_surface>
class Distance_finder
{
public:
  // \param options, surface, from, progress, result must outlive this
  Distance_finder(const Distance_options& options, const Any_surface& surface, const Ways_from& from,
                  Progress& progress, Distance_result& result)
    : options_(options), surface_(surface), from_(from), progress_(progress), result_(result)
  {}

  void find_by_heat()
  {
    progress_.begin("building and factoring the matrix of the heat");
    IT::Heat_method<> heat(surface_, heat_options());
    progress_.begin("solving for distances");
    if (from_.places.empty())
      for (IT::Vertex_index v : from_.vertices)
        heat.add_source(v);
    else
      heat.add_sources(surface_, from_.places);
    result_.mean_edge_length = heat.mean_edge_length();
    result_.distances = heat.distances();
    result_.number_of_bounded_distances = heat.number_of_bounded_distances();
  }

  // If the surface is a cover, it has to be made of sheets.
  void follow_ways()
  {
    progress_.begin("following straight ways");
    IT::Geodesic_distances found = distances(options_.tolerance());
    result_.is_complete = found.is_complete;
    result_.distances = std::move(found.distances);
    result_.nearest_sources = std::move(found.nearest_sources);
  }

  // With the exact distances: the mean and the largest error, as fractions of them.
  void compare()
  {
    progress_.begin("following all straight ways");
    const IT::Geodesic_distances exact = distances(0);
    result_.is_complete = result_.is_complete && exact.is_complete;
    double sum = 0, largest = 0;
    std::size_t n = 0;
    for (std::size_t v = 0; v < exact.distances.size(); ++v)
      if (exact.distances[v] > 0 && std::isfinite(exact.distances[v])) {
        const double error = std::abs(result_.distances[v] - exact.distances[v]) / exact.distances[v];
        sum += error;
        largest = (std::max)(largest, error);
        ++n;
      }
    result_.errors = {n > 0 ? sum / double(n) : 0, largest};
  }

  // Row after row, on all cores.
  std::vector<double> find_matrix(const std::vector<IT::Vertex_index>& targets)
  {
    progress_.begin("following straight ways");
    const auto go_further = [this](double done) { return done > 0 ? progress_(done) : !is_interrupted(); };
    const IT::Geodesic_distance_matrix found = IT::geodesic_distance_matrix<CGAL::Parallel_if_available_tag>(
      surface_, from_.vertices, targets, CGAL::parameters::tolerance(options_.tolerance()).visitor(go_further));
    result_.is_complete = found.is_complete;
    std::vector<double> matrix;
    for (const std::vector<double>& row : found.distances)
      matrix.insert(matrix.end(), row.begin(), row.end());
    return matrix;
  }

private:
  IT::Geodesic_distances distances(double tolerance) const
  {
    return from_.places.empty() ? IT::geodesic_distances(surface_, from_.vertices, geodesic_options(tolerance))
                                : IT::geodesic_distances_from(surface_, from_.places, geodesic_options(tolerance));
  }

  auto heat_options() const
  {
    const std::map<std::string, IT::Heat_boundary> boundaries = {{"", IT::Heat_boundary::NEUMANN},
                                                                 {"neumann", IT::Heat_boundary::NEUMANN},
                                                                 {"dirichlet", IT::Heat_boundary::DIRICHLET},
                                                                 {"average", IT::Heat_boundary::AVERAGED}};
    return CGAL::parameters::heat_boundary(boundaries.at(options_.boundary))
      .time_coefficient(options_.time_coefficient.value_or(1))
      .visitor([] { return !is_interrupted(); });
  }

  const Distance_options& options_;
  const Any_surface& surface_;
  const Ways_from& from_;
  Progress& progress_;
  Distance_result& result_;
};

} // namespace idt

#endif // IDT_DISTANCE_WAYS_H
