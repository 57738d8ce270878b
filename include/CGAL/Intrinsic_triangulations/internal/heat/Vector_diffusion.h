// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// How tangent vectors spread in a short time.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_VECTOR_DIFFUSION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_VECTOR_DIFFUSION_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Laplace_Beltrami.h>
#include <CGAL/Intrinsic_triangulations/internal/heat/Heat_surface.h>
#include <CGAL/Intrinsic_triangulations/internal/heat/Layered_heat.h>
#include <CGAL/Intrinsic_triangulations/internal/heat/Pinned_system.h>
#include <CGAL/Intrinsic_triangulations/internal/matrices/Sparse_Cholesky.h>
#include <CGAL/Intrinsic_triangulations/tangent_vectors.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <complex>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// An edge between two rows, over which heat flows.
struct Heat_edge
{
  std::uint32_t i, j;
  double weight;
  std::complex<double> ij, ji; // as vectors at i and at j, in the unit of the heat surface
};

// Vectors after a squared unit of time: (M + L) u = 0 except at their sources, for the connection Laplacian L.
class Vector_diffusion
{
  using Scalar = std::complex<double>;
  using Matrix = Eigen::SparseMatrix<Scalar>;
  using Vector = Eigen::VectorXcd;

public:
  // \param surface that of the triangulation
  // \param interruption is asked before the factorization and each solution; has to live as long
  template <class Traits>
  Vector_diffusion(const Intrinsic_triangulation<Traits>& triangulation, const Heat_surface& surface,
                   const Interruption& interruption)
    : Vector_diffusion(triangulation.connectivity(), halfedge_vectors_in_vertex(triangulation), surface, interruption)
  {}

  // Vectors that are sent on where the heat of the same sources is, which they never exceed.
  std::vector<Vector> spread_likewise(const Vector& vectors, const Layered_heat& heat) const
  {
    return internal::spread_likewise(
      vectors, heat, matrix_, [this](const Vector& b) { return solver_.solve(after(interruption_, b)); },
      [](Vector&, std::size_t) {});
  }

  const std::vector<Heat_edge>& edges() const { return edges_; }

private:
  Vector_diffusion(const Delta_complex& complex, const std::vector<Planar_vector<double>>& vectors,
                   const Heat_surface& surface, const Interruption& interruption)
    : interruption_(interruption), matrix_(heat_matrix(complex, vectors, surface)),
      solver_(after(interruption_, matrix_), "the matrix of tangent vectors")
  {
    for (Edge_index e : complex.edges()) {
      if (surface.weights[e.idx()] == 0)
        continue;
      const Halfedge_index h = complex.halfedge(e), g = complex.opposite(h);
      const auto in_units = [&](Halfedge_index side) {
        const Planar_vector<double>& v = vectors[side.idx()];
        const std::size_t row = complex.source(side).idx();
        return Scalar(surface.from_input_unit(v.x(), row), surface.from_input_unit(v.y(), row));
      };
      edges_.push_back({std::uint32_t(complex.source(h).idx()), std::uint32_t(complex.source(g).idx()),
                        surface.weights[e.idx()], in_units(h), in_units(g)});
    }
  }

  static Matrix heat_matrix(const Delta_complex& complex, const std::vector<Planar_vector<double>>& vectors,
                            const Heat_surface& surface)
  {
    Matrix result = assemble_connection_Laplacian(
      complex, vectors, [&](Edge_index e) { return (std::max)(surface.weights[e.idx()], 0.); });
    for (Eigen::Index v = 0; v < result.rows(); ++v) // a vertex without faces keeps its vector
      result.coeffRef(v, v) += surface.mass[v] > 0 ? surface.mass[v] : 1;
    return result;
  }

  const Interruption& interruption_;
  Matrix matrix_;
  Sparse_Cholesky<Scalar> solver_;
  std::vector<Heat_edge> edges_;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_VECTOR_DIFFUSION_H
