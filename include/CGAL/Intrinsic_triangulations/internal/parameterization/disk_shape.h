// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// What maps to the plane need to know about a surface: components, boundaries, and sizes computed without overflow.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_PARAMETERIZATION_DISK_SHAPE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_PARAMETERIZATION_DISK_SHAPE_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/matrices/Sparse_Cholesky.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/planar_orientation.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Disjoint_sets.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

[[noreturn]] inline void throw_no_disk(const std::string& what)
{
  throw Invalid_surface_error(Invalid_surface_error::Defect::WRONG_TOPOLOGY, 0, 1,
                              "a map to the plane needs a disk: one component with one boundary "
                              "and no handle; the surface " +
                                what);
}

inline std::size_t number_of_components(const Delta_complex& complex)
{
  Disjoint_sets sets(complex.number_of_faces());
  for (Edge_index e : complex.edges())
    if (!complex.is_border(e)) {
      const Halfedge_index h = complex.halfedge(e);
      sets.unite(complex.face(h).idx(), complex.face(complex.opposite(h)).idx());
    }
  std::vector<std::size_t> component_of;
  return sets.number(component_of);
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

// The lengths divided by the largest, so that their sum does not overflow.
inline std::vector<double> over_largest(std::vector<double> lengths)
{
  const double largest = lengths.empty() ? 0 : *std::max_element(lengths.begin(), lengths.end());
  if (largest > 0)
    for (double& l : lengths)
      l /= largest;
  return lengths;
}

// The square root of the sum of areas; the sum itself may overflow.
inline double root_of_sum(const std::vector<double>& areas)
{
  double sum = 0;
  for (double a : over_largest(areas))
    sum += a;
  return std::sqrt(sum) * std::sqrt(*std::max_element(areas.begin(), areas.end()));
}

// Scales a map so that its image has the area of the surface.
// \exception Numerical_error with this message if the image has no area
inline void scale_to_area(const Delta_complex& complex, const std::vector<Halfedge_index>& boundary,
                          const std::vector<double>& areas, std::vector<std::array<double, 2>>& uv, const char* message)
{
  double image_area = 0;
  for (Halfedge_index h : boundary) {
    const auto &p = uv[complex.source(h).idx()], &q = uv[complex.target(h).idx()];
    image_area += (p[0] * q[1] - q[0] * p[1]) / 2;
  }
  if (!(image_area > 0))
    throw Numerical_error(message);
  const double scale = root_of_sum(areas) / std::sqrt(image_area);
  for (std::array<double, 2>& p : uv)
    p = {scale * p[0], scale * p[1]};
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

// Numbers the wanted entries from 0 on; the others get -1.
template <class Is_wanted>
std::vector<int> numbering(std::size_t size, int& number, const Is_wanted& is_wanted)
{
  std::vector<int> result(size, -1);
  number = 0;
  for (std::size_t i = 0; i < size; ++i)
    if (is_wanted(i))
      result[i] = number++;
  return result;
}

// Solves matrix * x = 0 for the rows that are not fixed, where x has given values in the others.
inline void solve_with_fixed_values(const Eigen::SparseMatrix<double>& matrix, const std::vector<bool>& is_fixed,
                                    Eigen::MatrixXd& x, const char* what)
{
  int number_of_free = 0, number_of_fixed = 0;
  const std::vector<int> free_row =
                           numbering(is_fixed.size(), number_of_free, [&](std::size_t i) { return !is_fixed[i]; }),
                         fixed_row = numbering(is_fixed.size(), number_of_fixed,
                                               [&](std::size_t i) { return bool(is_fixed[i]); });
  Eigen::MatrixXd fixed(number_of_fixed, x.cols());
  for (std::size_t i = 0; i < is_fixed.size(); ++i)
    if (is_fixed[i])
      fixed.row(fixed_row[i]) = x.row(Eigen::Index(i));
  const Sparse_Cholesky<> cholesky(submatrix(matrix, free_row, free_row, number_of_free, number_of_free), what);
  const Eigen::MatrixXd right = -(submatrix(matrix, free_row, fixed_row, number_of_free, number_of_fixed) * fixed);
  const Eigen::MatrixXd solution = cholesky.solve(right);
  for (std::size_t i = 0; i < is_fixed.size(); ++i)
    if (!is_fixed[i])
      x.row(Eigen::Index(i)) = solution.row(free_row[i]);
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_PARAMETERIZATION_DISK_SHAPE_H
