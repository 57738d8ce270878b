// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The Laplace-Beltrami operator of a triangulation, its mass matrix, and the Laplacian of tangent vectors.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_LAPLACE_BELTRAMI_H
#define CGAL_INTRINSIC_TRIANGULATIONS_LAPLACE_BELTRAMI_H

#include <CGAL/Intrinsic_triangulations/internal/require_Eigen.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/matrices/assemble_symmetric_matrix.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/intrinsic_Delaunay_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/tangent_vectors.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <Eigen/SparseCore>

#include <complex>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \addtogroup PkgIntrinsicTriangulationsOperators
/// @{

/// \brief the factor of the cotangents in a stiffness matrix.
enum class Stiffness_factor {
  HALF, ///< `w_ij = (cot k + cot l) / 2`: as for linear finite elements, matching a mass matrix
  ONE   ///< `w_ij = cot k + cot l`: as in section 3.1 of the paper
};

namespace internal {

template <class ConcurrencyTag, class Edge_weight>
Eigen::SparseMatrix<double> assemble_stiffness_matrix(const Delta_complex& complex, const Edge_weight& weight,
                                                      Stiffness_factor factor)
{
  const double scale = factor == Stiffness_factor::HALF ? -0.5 : -1;
  return assemble_symmetric_matrix<ConcurrencyTag>(
    complex, [&](Edge_index e) { return scale * weight(e); }, [](int, double sum_of_others) { return -sum_of_others; });
}

} // namespace internal

/// \brief returns the stiffness matrix for given cotangent weights.
///
/// Let `w_ij` be the total weight of all edges that join i and j. The entries are
/// `L_ij = −w_ij` off the diagonal, and `L_ii` is the sum of all `w_ij`. So the matrix is
/// symmetric and positive semidefinite, the rows sum to zero, and `uᵀ L u` is the integral
/// of `|∇u|²` with `Stiffness_factor::HALF`. Loops contribute nothing. The boundary conditions are
/// natural (Neumann): a border edge has one cotangent, and no row is left out. For
/// Dirichlet conditions, take the rows and columns of the interior vertices.
///
/// Each diagonal entry is stored, even if it is zero. The indices of a column are in increasing order.
///
/// \param complex the triangles
/// \param weights `cot k + cot l` for each edge, as returned by `cotangent_weights()`
/// \param factor the factor
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` (with TBB) or `Parallel_if_available_tag`: the matrix is the
///   same, bit for bit
/// \pre there is a weight for each edge. O(size).
template <class ConcurrencyTag = Sequential_tag>
Eigen::SparseMatrix<double> stiffness_matrix(const Delta_complex& complex, const std::vector<double>& weights,
                                             Stiffness_factor factor = Stiffness_factor::HALF)
{
  CGAL_precondition(weights.size() == complex.number_of_edges());
  return internal::assemble_stiffness_matrix<ConcurrencyTag>(
    complex, [&](Edge_index e) { return weights[e.idx()]; }, factor);
}

/// \brief returns the stiffness matrix of a triangulation.
///
/// As above, with the weights of `cotangent_weights()`. For an intrinsic Delaunay
/// triangulation it represents the intrinsic Laplace-Beltrami operator: no off-diagonal entry is positive, except those
/// of border edges. For a triangulation that was not flipped, it is the usual, extrinsic matrix. One pass over the
/// edges computes all weights.
/// \tparam ConcurrencyTag as above
/// \param triangulation the triangulation
/// \param factor the factor
/// \exception Invalid_surface_error as `cotangent_weights()`
/// Source: Fisher, Springborn, Schroeder, Bobenko (2006), section 3.1.
template <class ConcurrencyTag = Sequential_tag, class Traits>
Eigen::SparseMatrix<double> stiffness_matrix(const Intrinsic_triangulation<Traits>& triangulation,
                                             Stiffness_factor factor = Stiffness_factor::HALF)
{
  const Delta_complex& complex = triangulation.connectivity();
  if constexpr (std::is_convertible<ConcurrencyTag, Parallel_tag>::value)
    return stiffness_matrix<ConcurrencyTag>(complex, cotangent_weights<ConcurrencyTag>(triangulation), factor);
  else
    return internal::assemble_stiffness_matrix<ConcurrencyTag>(
      complex, internal::Cotangent_weight<Traits>(triangulation), factor);
}

/// \brief returns the lumped mass matrix: the diagonal entry of a vertex is a third of the area of
/// its faces.
///
/// If several corners of a face are at the same vertex, the face counts once for each.
/// \param complex the triangles
/// \param areas the area of each face. O(size).
/// \pre there is an area for each face
inline Eigen::SparseMatrix<double> lumped_mass_matrix(const Delta_complex& complex, const std::vector<double>& areas)
{
  CGAL_precondition(areas.size() == complex.number_of_faces());
  return internal::assemble_lumped_mass_matrix(complex, internal::Row_of_vertex(complex), areas);
}

/// \brief as above, with the areas of `face_areas()`.
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` (with TBB) or `Parallel_if_available_tag`, for the areas
/// \param triangulation the triangulation
template <class ConcurrencyTag = Sequential_tag, class Traits>
Eigen::SparseMatrix<double> lumped_mass_matrix(const Intrinsic_triangulation<Traits>& triangulation)
{
  return lumped_mass_matrix(triangulation.connectivity(), face_areas<ConcurrencyTag>(triangulation));
}

/// \brief returns the Galerkin mass matrix of linear finite elements: a face adds a sixth of
/// its area for each corner and a twelfth for each pair of corners.
///
/// Corners at the same vertex are treated as different corners with the same value, so
/// `uᵀ M u` is always the integral of `u²`.
/// \param complex the triangles
/// \param areas the area of each face. O(size).
/// \pre there is an area for each face
/// \tparam ConcurrencyTag as for `stiffness_matrix()`
template <class ConcurrencyTag = Sequential_tag>
Eigen::SparseMatrix<double> Galerkin_mass_matrix(const Delta_complex& complex, const std::vector<double>& areas)
{
  CGAL_precondition(areas.size() == complex.number_of_faces());
  std::vector<double> diagonal = internal::corner_sums(complex, internal::Row_of_vertex(complex), areas, 1. / 6);
  for (Edge_index e : complex.edges())
    if (complex.is_loop(e)) // two corners of each face beside it are the same vertex
      diagonal[complex.target(complex.halfedge(e)).idx()] += internal::area_beside(complex, areas, e) / 6;
  return internal::assemble_symmetric_matrix<ConcurrencyTag>(
    complex, [&](Edge_index e) { return internal::area_beside(complex, areas, e) / 12; },
    [&](int v, double) { return diagonal[std::size_t(v)]; });
}

/// \brief as above, with the areas of `face_areas()`.
/// \tparam ConcurrencyTag as above
/// \param triangulation the triangulation
template <class ConcurrencyTag = Sequential_tag, class Traits>
Eigen::SparseMatrix<double> Galerkin_mass_matrix(const Intrinsic_triangulation<Traits>& triangulation)
{
  return Galerkin_mass_matrix<ConcurrencyTag>(triangulation.connectivity(), face_areas<ConcurrencyTag>(triangulation));
}

/// \brief stiffness matrix `L` and lumped mass matrix `M`: `L u = λ M u` is the eigenvalue problem of `−Δ`.
struct Laplace_Beltrami_operator
{
  Eigen::SparseMatrix<double> stiffness; ///< with `Stiffness_factor::HALF`
  Eigen::SparseMatrix<double> mass;      ///< lumped
};

/// \brief returns the intrinsic Laplace-Beltrami operator of a triangle mesh, a replacement for
/// its cotangent matrix.
///
///     auto [L, M] = intrinsic_Delaunay_Laplacian(mesh);
///
/// The i-th row belongs to the i-th vertex of the mesh. Conventions are as for `stiffness_matrix()`, parameters and
/// exceptions as for `intrinsic_Delaunay_triangulation()`. Entries are rounded.
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` (with TBB) or `Parallel_if_available_tag`
/// \param mesh, np as for `intrinsic_Delaunay_triangulation()`
template <class ConcurrencyTag = Sequential_tag, class TriangleMesh,
          class NamedParameters = parameters::Default_named_parameters>
Laplace_Beltrami_operator intrinsic_Delaunay_Laplacian(const TriangleMesh& mesh,
                                                       const NamedParameters& np = parameters::default_values())
{
  const auto triangulation = intrinsic_Delaunay_triangulation<ConcurrencyTag>(mesh, np).triangulation;
  return {stiffness_matrix<ConcurrencyTag>(triangulation), lumped_mass_matrix<ConcurrencyTag>(triangulation)};
}

/// \brief returns the extrinsic operator, from the unchanged triangles of the mesh; otherwise
/// as `intrinsic_Delaunay_Laplacian()`.
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` (with TBB) or `Parallel_if_available_tag`
/// \param mesh, np as for `intrinsic_Delaunay_Laplacian()`
template <class ConcurrencyTag = Sequential_tag, class TriangleMesh,
          class NamedParameters = parameters::Default_named_parameters>
Laplace_Beltrami_operator extrinsic_Laplacian(const TriangleMesh& mesh,
                                              const NamedParameters& np = parameters::default_values())
{
  const auto triangulation = intrinsic_triangulation<ConcurrencyTag>(mesh, np);
  return {stiffness_matrix<ConcurrencyTag>(triangulation), lumped_mass_matrix<ConcurrencyTag>(triangulation)};
}

namespace internal {

// The factor that turns a vector at the target of h into the parallel one at its source.
inline std::complex<double> transport_to_source(const Delta_complex& complex,
                                                const std::vector<std::complex<double>>& vectors, Halfedge_index h)
{
  const auto direction = [&](Halfedge_index side) {
    const std::complex<double>& v = vectors[side.idx()];
    return std::arg(v);
  };
  // The same halfedge seen from both ends: backwards at the target.
  return -std::polar(1., direction(h) - direction(complex.opposite(h)));
}

// \param vectors the result of `halfedge_vectors_in_vertex()`
// \param weight returns the weight of an edge
template <class Weight>
Eigen::SparseMatrix<std::complex<double>>
assemble_connection_Laplacian(const Delta_complex& complex, const std::vector<std::complex<double>>& vectors,
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

/// \brief returns the connection Laplacian: the operator on tangent vectors whose kernel consists of the parallel
/// fields.
///
/// A vector at a vertex is a complex number in the tangent plane of `halfedge_vectors_in_vertex()`. The matrix L is
/// Hermitian, and u* L u is the sum over the edges ij of w |u_i - r u_j|², with half the sum w of the cotangents, where
/// r turns vectors at j into the parallel ones at i. So it is positive semidefinite if no weight is negative: on a
/// Delaunay triangulation, except for edges of the border whose opposite angle is obtuse. Where the surface is flat,
/// and for real numbers instead of vectors, it is `stiffness_matrix()`.
///
/// \param triangulation all of its faces have positive area
/// \return a matrix with a row for each vertex, without unit; weights and turns are rounded like those of
///   `cotangent_weights()` and `halfedge_vectors_in_vertex()`
/// \exception Invalid_surface_error if a face has zero area. \exception Undecided_error as `angle()`. O(size).
///
/// Source: N. Sharp, Y. Soliman, K. Crane, "The vector heat method", 2019, section 3.
template <class Traits>
Eigen::SparseMatrix<std::complex<double>> connection_Laplacian(const Intrinsic_triangulation<Traits>& triangulation)
{
  const internal::Cotangent_weight<Traits> cotangents(triangulation);
  return internal::assemble_connection_Laplacian(triangulation.connectivity(),
                                                 halfedge_vectors_in_vertex(triangulation),
                                                 [&](Edge_index e) { return cotangents(e) / 2; });
}

/// @}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_LAPLACE_BELTRAMI_H
