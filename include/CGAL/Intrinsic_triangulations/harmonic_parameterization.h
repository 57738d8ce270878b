// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Discrete harmonic maps of disks to the plane, with the boundary fixed or free.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_HARMONIC_PARAMETERIZATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_HARMONIC_PARAMETERIZATION_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Laplace_Beltrami.h>
#include <CGAL/Intrinsic_triangulations/disk_boundary.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/matrices/Sparse_Cholesky.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \cond SKIP_IN_MANUAL
namespace internal {

// The lengths of the edges of a boundary.
inline std::vector<double> boundary_lengths(const Delta_complex& complex,
                                            const std::vector<Halfedge_index>& boundary,
                                            const std::vector<double>& edge_lengths)
{
  std::vector<double> lengths;
  for (Halfedge_index h : boundary)
    lengths.push_back(edge_lengths[complex.edge(h).idx()]);
  return lengths;
}

// Numbers the entries that are wanted from 0 on, and the others -1.
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
inline void solve_with_fixed_values(const Eigen::SparseMatrix<double>& matrix,
                                    const std::vector<bool>& is_fixed, Eigen::MatrixXd& x,
                                    const char* what)
{
  int number_of_free = 0, number_of_fixed = 0;
  const std::vector<int> free_row = numbering(is_fixed.size(), number_of_free,
                                              [&](std::size_t i) { return !is_fixed[i]; }),
                         fixed_row = numbering(is_fixed.size(), number_of_fixed,
                                               [&](std::size_t i) { return bool(is_fixed[i]); });
  Eigen::MatrixXd fixed(number_of_fixed, x.cols());
  for (std::size_t i = 0; i < is_fixed.size(); ++i)
    if (is_fixed[i])
      fixed.row(fixed_row[i]) = x.row(Eigen::Index(i));
  const Sparse_Cholesky<> cholesky(
    submatrix(matrix, free_row, free_row, number_of_free, number_of_free), what);
  const Eigen::MatrixXd right =
    -(submatrix(matrix, free_row, fixed_row, number_of_free, number_of_fixed) * fixed);
  const Eigen::MatrixXd solution = cholesky.solve(right);
  for (std::size_t i = 0; i < is_fixed.size(); ++i)
    if (!is_fixed[i])
      x.row(Eigen::Index(i)) = solution.row(free_row[i]);
}

} // namespace internal
/// \endcond

/// \ingroup PkgIntrinsicTriangulationsParameterization
/// \brief returns the discrete harmonic map of a disk whose boundary is fixed.
///
/// Each interior vertex is the average of its neighbours, weighted with the cotangent weights.
/// If these are positive and the boundary is a convex polygon, the map is
/// one-to-one, by the theorem of Tutte and Floater. Negative weights can fold it. Edges with
/// weight zero (ties) do not count. If the other neighbours of a vertex lie on
/// a line, or if loops or double edges separate the disk, triangles
/// collapse, and rounding may turn such a triangle over. `check_parameterization()` reports this.
///
/// \param complex the triangles of a disk
/// \param weights `cot k + cot l` for each edge, as returned by `cotangent_weights()`
/// \param boundary_positions for each halfedge returned by `disk_boundary(complex)`, the position
///   of its source
///
/// \return the position of each vertex; (0, 0) for a vertex without a face
///
/// \exception Invalid_surface_error if the surface is not a disk
/// \exception Numerical_error if the linear system cannot be solved
/// \pre there is a position for each vertex of the boundary
///
/// One sparse Cholesky factorization.
/// Source: Fisher, Springborn, Schroeder, Bobenko (2006), section 3.2.
inline Planar_points harmonic_parameterization(const Delta_complex& complex,
                                               const std::vector<double>& weights,
                                               const Planar_points& boundary_positions)
{
  const std::vector<Halfedge_index> boundary = disk_boundary(complex);
  CGAL_precondition(boundary_positions.size() == boundary.size());
  Eigen::MatrixXd x = Eigen::MatrixXd::Zero(Eigen::Index(complex.number_of_vertices()), 2);
  std::vector<bool> is_fixed(complex.number_of_vertices(), false);
  for (Vertex_index v : complex.vertices())
    is_fixed[v.idx()] = !complex.halfedge(v).is_valid();
  for (std::size_t i = 0; i < boundary.size(); ++i) {
    const std::size_t v = complex.source(boundary[i]).idx();
    is_fixed[v] = true;
    x.row(Eigen::Index(v)) << boundary_positions[i][0], boundary_positions[i][1];
  }
  internal::solve_with_fixed_values(stiffness_matrix(complex, weights), is_fixed, x,
                                    "the Laplace-Beltrami operator");
  Planar_points uv;
  uv.reserve(complex.number_of_vertices());
  for (Eigen::Index v = 0; v < x.rows(); ++v)
    uv.push_back({x(v, 0), x(v, 1)});
  return uv;
}

/// \ingroup PkgIntrinsicTriangulationsParameterization
/// \brief returns the discrete harmonic map of a disk to the unit disk, with the boundary placed
/// on the unit circle by arc length.
///
/// The map of an intrinsic Delaunay triangulation is piecewise linear on the intrinsic
/// triangles. A triangulation that was not flipped gives the usual, extrinsic map.
/// Otherwise as above; exceptions also as for `cotangent_weights()`.
template <class Traits>
Planar_points harmonic_parameterization(const Intrinsic_triangulation<Traits>& triangulation)
{
  const Delta_complex& complex = triangulation.connectivity();
  return harmonic_parameterization(
    complex, cotangent_weights(triangulation),
    positions_on_circle(
      internal::boundary_lengths(complex, disk_boundary(complex), edge_lengths(triangulation))));
}

/// \ingroup PkgIntrinsicTriangulationsParameterization
/// \brief returns the discrete harmonic map of a disk to a convex polygon, with the boundary placed
/// by `positions_on_polygon()`.
///
/// A triangle with all three corners on one side of the polygon collapses, up to rounding:
/// on a side that is not parallel to an axis, the check may find it turned over.
/// Otherwise as above; exceptions also as for `positions_on_polygon()`.
template <class Traits>
Planar_points harmonic_parameterization(const Intrinsic_triangulation<Traits>& triangulation,
                                        const Planar_points& polygon)
{
  const Delta_complex& complex = triangulation.connectivity();
  return harmonic_parameterization(
    complex, cotangent_weights(triangulation),
    positions_on_polygon(
      internal::boundary_lengths(complex, disk_boundary(complex), edge_lengths(triangulation)),
      polygon));
}

/// \ingroup PkgIntrinsicTriangulationsParameterization
/// \brief returns the discrete harmonic map of a disk with natural boundary conditions: the
/// boundary is free, and the map is as conformal as possible.
///
/// It minimizes the Dirichlet energy minus the area of the image, a quadratic energy that is zero for
/// conformal maps and positive otherwise. Two boundary vertices, half the boundary apart,
/// are fixed for this. Then the map is scaled so that the image has the area of the
/// surface. Triangles may be turned over. If triangles are so thin that weights
/// differ by a factor of 1e10 or more, rounding spoils the result.
///
/// \param complex the triangles of a disk
/// \param weights `cot k + cot l` for each edge
/// \param lengths the length of each edge
/// \param areas the area of each face
/// Return value and exceptions as for `harmonic_parameterization()`.
///
/// Sources: M. Desbrun, M. Meyer, P. Alliez, "Intrinsic parameterizations of surface meshes",
/// 2002; B. Lévy, S. Petitjean, N. Ray, J. Maillot, "Least squares conformal maps", 2002.
inline Planar_points natural_parameterization(const Delta_complex& complex,
                                              const std::vector<double>& weights,
                                              const std::vector<double>& lengths,
                                              const std::vector<double>& areas)
{
  const std::vector<Halfedge_index> boundary = disk_boundary(complex);
  const std::size_t n = complex.number_of_vertices();

  // u comes first, then v. The area of the image is the sum of (u_i v_j - u_j v_i) / 2 over
  // the halfedges ij of the boundary.
  const Eigen::SparseMatrix<double> stiffness = stiffness_matrix(complex, weights);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(2 * std::size_t(stiffness.nonZeros()) + 4 * boundary.size());
  for (int c = 0; c < stiffness.outerSize(); ++c)
    for (Eigen::SparseMatrix<double>::InnerIterator i(stiffness, c); i; ++i)
      for (int shift : {0, int(n)})
        entries.emplace_back(int(i.row()) + shift, c + shift, i.value());
  for (Halfedge_index h : boundary) {
    const int i = int(complex.source(h).idx()), j = int(complex.target(h).idx());
    entries.emplace_back(i, j + int(n), -0.5);
    entries.emplace_back(j + int(n), i, -0.5);
    entries.emplace_back(j, i + int(n), 0.5);
    entries.emplace_back(i + int(n), j, 0.5);
  }
  Eigen::SparseMatrix<double> energy(Eigen::Index(2 * n), Eigen::Index(2 * n));
  energy.setFromTriplets(entries.begin(), entries.end());

  const std::vector<double> sides =
    internal::over_largest(internal::boundary_lengths(complex, boundary, lengths));
  double total = 0, sum = 0;
  for (double l : sides)
    total += l;
  std::size_t middle = 0;
  while (sum < total / 2)
    sum += sides[middle++];
  const std::size_t first = complex.source(boundary.front()).idx(),
                    second = complex.target(boundary[middle - 1]).idx();
  std::vector<bool> is_fixed(2 * n, false);
  for (Vertex_index v : complex.vertices())
    is_fixed[v.idx()] = is_fixed[v.idx() + n] = !complex.halfedge(v).is_valid();
  Eigen::MatrixXd x = Eigen::MatrixXd::Zero(Eigen::Index(2 * n), 1);
  for (std::size_t v : {first, second})
    is_fixed[v] = is_fixed[v + n] = true;
  x(Eigen::Index(second), 0) = 1;
  internal::solve_with_fixed_values(energy, is_fixed, x, "the conformal energy");

  double image_area = 0;
  Planar_points uv;
  uv.reserve(n);
  for (std::size_t v = 0; v < n; ++v)
    uv.push_back({x(Eigen::Index(v), 0), x(Eigen::Index(v + n), 0)});
  for (Halfedge_index h : boundary) {
    const auto &p = uv[complex.source(h).idx()], &q = uv[complex.target(h).idx()];
    image_area += (p[0] * q[1] - q[0] * p[1]) / 2;
  }
  if (!(image_area > 0))
    throw Numerical_error("the map with natural boundary conditions collapses the surface");
  const double scale = internal::root_of_sum(areas) / std::sqrt(image_area);
  for (std::array<double, 2>& p : uv)
    p = {scale * p[0], scale * p[1]};
  return uv;
}

/// \ingroup PkgIntrinsicTriangulationsParameterization
/// as above, for a triangulation.
template <class Traits>
Planar_points natural_parameterization(const Intrinsic_triangulation<Traits>& triangulation)
{
  return natural_parameterization(triangulation.connectivity(), cotangent_weights(triangulation),
                                  edge_lengths(triangulation), face_areas(triangulation));
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_HARMONIC_PARAMETERIZATION_H
