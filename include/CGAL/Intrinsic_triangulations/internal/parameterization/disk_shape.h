// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// What maps to the plane ask of a surface: its components and boundaries, and sizes without overflow.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_PARAMETERIZATION_DISK_SHAPE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_PARAMETERIZATION_DISK_SHAPE_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/errors.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

[[noreturn]] inline void throw_no_disk(const std::string& what)
{
  throw Invalid_surface_error(Invalid_surface_error::Defect::WRONG_TOPOLOGY, 0, 1,
                              "a map to the plane needs a disk: one component with one boundary "
                              "and no handle; the surface " +
                                what);
}

inline std::size_t number_of_components(const Delta_complex& complex)
{
  std::vector<bool> is_visited(complex.number_of_faces(), false);
  std::vector<Face_index> stack;
  std::size_t components = 0;
  for (Face_index first : complex.faces()) {
    if (is_visited[first.idx()])
      continue;
    ++components;
    is_visited[first.idx()] = true;
    stack.push_back(first);
    while (!stack.empty()) {
      Halfedge_index h = complex.halfedge(stack.back());
      stack.pop_back();
      for (int side = 0; side < 3; ++side, h = complex.next(h)) {
        const Face_index f = complex.face(complex.opposite(h));
        if (f.is_valid() && !is_visited[f.idx()]) {
          is_visited[f.idx()] = true;
          stack.push_back(f);
        }
      }
    }
  }
  return components;
}

inline std::size_t number_of_boundaries(const Delta_complex& complex)
{
  std::vector<bool> is_visited(complex.number_of_halfedges(), false);
  std::size_t boundaries = 0;
  for (Halfedge_index first : complex.halfedges()) {
    if (!complex.is_border(first) || is_visited[first.idx()])
      continue;
    ++boundaries;
    for (Halfedge_index h = first; !is_visited[h.idx()]; h = complex.next(h))
      is_visited[h.idx()] = true;
  }
  return boundaries;
}

inline std::size_t number_of_vertices_with_faces(const Delta_complex& complex)
{
  std::size_t n = 0;
  for (Vertex_index v : complex.vertices())
    n += complex.halfedge(v).is_valid();
  return n;
}

using Planar_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

inline Orientation planar_orientation(const std::array<double, 2>& p, const std::array<double, 2>& q,
                                      const std::array<double, 2>& r)
{
  using Point = Planar_kernel::Point_2;
  return CGAL::orientation(Point(p[0], p[1]), Point(q[0], q[1]), Point(r[0], r[1]));
}

// The lengths over the largest of them: their sum does not overflow.
inline std::vector<double> over_largest(std::vector<double> lengths)
{
  const double largest = lengths.empty() ? 0 : *std::max_element(lengths.begin(), lengths.end());
  if (largest > 0)
    for (double& l : lengths)
      l /= largest;
  return lengths;
}

// The square root of the sum of areas, which may overflow itself.
inline double root_of_sum(const std::vector<double>& areas)
{
  double sum = 0;
  for (double a : over_largest(areas))
    sum += a;
  return std::sqrt(sum) * std::sqrt(*std::max_element(areas.begin(), areas.end()));
}

// The lengths of the edges of a boundary.
inline std::vector<double> boundary_lengths(const Delta_complex& complex, const std::vector<Halfedge_index>& boundary,
                                            const std::vector<double>& edge_lengths)
{
  std::vector<double> lengths;
  for (Halfedge_index h : boundary)
    lengths.push_back(edge_lengths[complex.edge(h).idx()]);
  return lengths;
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_PARAMETERIZATION_DISK_SHAPE_H
