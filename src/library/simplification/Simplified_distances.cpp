// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Distances on a surface with intervals, by way of a simplified surface.

#include "Simplifier.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Point_location.h>
#include <CGAL/Intrinsic_triangulations/Simplified_distances.h>
#include <CGAL/Intrinsic_triangulations/internal/distances/Window_propagation.h>

#include <cmath>
#include <cstdint>

namespace CGAL::Intrinsic_triangulations {

namespace {

// Each vertex has a row of its own.
struct Own_rows
{
  const Delta_complex& complex;
  std::size_t number_of_rows() const { return complex.number_of_vertices(); }
  std::size_t operator()(Vertex_index v) const { return v.idx(); }
  bool is_cut() const { return false; }
  template <class Visit>
  void for_each_flat_edge(const Visit&) const
  {}
};

// From the triangles that define the surface to those on which ways are followed.
std::vector<Surface_point> places_on_triangulation(const Simplified_surface& surface)
{
  const Common_subdivision subdivision(surface.triangulation);
  const Point_location location(subdivision);
  std::vector<Surface_point> result;
  for (const Surface_point& place : surface.places)
    result.push_back(place.halfedge.is_valid() ? location.input_to_intrinsic(place) : Surface_point());
  return result;
}

} // namespace

Simplified_distances::Simplified_distances(const Simplified_surface& surface)
  : faces_(surface.triangulation, Own_rows{surface.triangulation.connectivity()}),
    points_(faces_, surface.triangulation.connectivity(), places_on_triangulation(surface))
{
  const Delta_complex& coarse = surface.map.coarse();
  const std::vector<std::size_t> component = internal::numbers_of_components(coarse);
  for (const Surface_point& place : surface.places)
    changes_.push_back(place.halfedge.is_valid()
                         ? surface.changes_of_components[component[coarse.face(place.halfedge).idx()]].second
                         : Metric_change());
}

Distance_intervals Simplified_distances::find(const std::vector<Vertex_index>& sources,
                                              const internal::Interruption& interruption) const
{
  std::vector<std::uint32_t> numbers;
  for (Vertex_index v : sources) {
    internal::require_vertex(v, number_of_vertices());
    numbers.push_back(v.idx());
  }
  Distance_intervals result;
  result.distances = internal::propagate_windows(faces_, points_, numbers, interruption);
  for (Vertex_index v : sources)
    result.distances[v.idx()] = 0;
  for (std::size_t v = 0; v < result.distances.size(); ++v) {
    double& d = result.distances[v];
    d = std::ldexp(d, faces_.exponent());
    result.lower.push_back(d / changes_[v].stretch);
    result.upper.push_back(d / changes_[v].shrink);
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations
