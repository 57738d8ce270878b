// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The Laplacian of tangent vectors.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CONNECTION_LAPLACIAN_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CONNECTION_LAPLACIAN_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Planar_vector.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/halfedge_vectors.h>

#include <Eigen/SparseCore>

#include <complex>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \cond SKIP_IN_MANUAL
namespace internal {

// What turns a vector at the target of h into the parallel one at its source.
inline std::complex<double> transport_to_source(const Delta_complex& complex, const std::vector<Planar_vector<double>>& vectors,
                                                Halfedge_index h)
{
  const auto direction = [&](Halfedge_index side) {
    const Planar_vector<double>& v = vectors[side.idx()];
    return std::arg(std::complex<double>(v.x(), v.y()));
  };
  // The same halfedge as both ends see it: backwards at the target.
  return -std::polar(1., direction(h) - direction(complex.opposite(h)));
}

// \param vectors those of `halfedge_vectors_in_vertex()`
// \param weight gives that of an edge
template <class Weight>
Eigen::SparseMatrix<std::complex<double>> assemble_connection_Laplacian(const Delta_complex& complex,
                                                                        const std::vector<Planar_vector<double>>& vectors,
                                                                        const Weight& weight)
{
  using Scalar = std::complex<double>;
  std::vector<Eigen::Triplet<Scalar>> entries;
  entries.reserve(4 * std::size_t(complex.number_of_edges()));
  for (Edge_index e : complex.edges()) {
    const double w = weight(e);
    if (w == 0)
      continue;
    const Halfedge_index h = complex.halfedge(e);
    const int i = int(complex.source(h).idx()), j = int(complex.target(h).idx());
    const Scalar r = transport_to_source(complex, vectors, h);
    entries.emplace_back(i, i, w);
    entries.emplace_back(j, j, w);
    entries.emplace_back(i, j, -w * r);
    entries.emplace_back(j, i, -w * std::conj(r));
  }
  const auto n = Eigen::Index(complex.number_of_vertices());
  Eigen::SparseMatrix<Scalar> result(n, n);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

} // namespace internal
/// \endcond

/// \ingroup PkgIntrinsicTriangulationsOperators
/// \brief returns the connection Laplacian: the operator on tangent vectors whose kernel are the parallel fields.
///
/// A vector at a vertex is a complex number in the tangent plane of `halfedge_vectors_in_vertex()`. The matrix L is Hermitian, and
/// u* L u is the sum over the edges ij of w |u_i - r u_j|², with half the sum w of the cotangents, where r turns vectors at j into the parallel
/// ones at i. So it is positive semidefinite if no weight is negative: on a Delaunay triangulation, except for edges of the border whose
/// opposite angle is obtuse. Where the surface is flat, and for real numbers instead of vectors, it is `stiffness_matrix()`.
///
/// \param triangulation all of its faces have positive area
/// \return a matrix with a row for each vertex; the weights and the turns are rounded as those of `cotangent_weights()` and
///   `halfedge_vectors_in_vertex()`. The weight has no unit
/// \exception Invalid_surface_error if a face has no area. \exception Undecided_error as `angle()`. O(size).
///
/// Source: N. Sharp, Y. Soliman, K. Crane, "The vector heat method", 2019, section 3.
template <class Traits>
Eigen::SparseMatrix<std::complex<double>> connection_Laplacian(const Intrinsic_triangulation<Traits>& triangulation)
{
  const internal::Cotangent_weight<Traits> cotangents(triangulation);
  return internal::assemble_connection_Laplacian(triangulation.connectivity(), halfedge_vectors_in_vertex(triangulation),
                                                 [&](Edge_index e) { return cotangents(e) / 2; });
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CONNECTION_LAPLACIAN_H
