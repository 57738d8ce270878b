// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Transfer of vertex data as sparse matrices of Eigen: interpolation, and L2-optimal projection.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRANSFER_MATRICES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRANSFER_MATRICES_H

#include <CGAL/Intrinsic_triangulations/internal/require_Eigen.h>
#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Laplace_Beltrami.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/Point_location.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/positions/overlay_layers.h>
#include <CGAL/Intrinsic_triangulations/transfer.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

using Triplets = std::vector<Eigen::Triplet<double>>;

template <class Layer>
Eigen::SparseMatrix<double> interpolation_matrix(const Layer& layer)
{
  const Overlay& overlay = layer.overlay;
  const Delta_complex& complex = layer.complex;
  Triplets entries;
  entries.reserve(overlay.number_of_vertices() + overlay.number_of_crossings());
  for (Vertex_index v : complex.vertices())
    entries.emplace_back(int(v.idx()), int(v.idx()), 1.);
  for (Overlay::size_type v = complex.number_of_vertices(); v < overlay.number_of_original_vertices(); ++v) {
    const auto& [side, weights] = layer.positions.location(Overlay::Vertex(v));
    Halfedge_index h = side;
    for (double weight : weights) {
      entries.emplace_back(int(v), int(complex.source(h).idx()), weight);
      h = complex.next(h);
    }
  }
  for (Overlay::Vertex x : overlay.crossings()) {
    const Halfedge_index h = complex.halfedge(layer.edge(x));
    const double t = layer.on_edge(x);
    entries.emplace_back(int(x.idx()), int(complex.source(h).idx()), 1 - t);
    entries.emplace_back(int(x.idx()), int(complex.target(h).idx()), t);
  }
  Eigen::SparseMatrix<double> matrix(overlay.number_of_vertices(), complex.number_of_vertices());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

inline std::array<int, 3> corner_vertices(const Delta_complex& complex, Face_index f)
{
  const Halfedge_index h = complex.halfedge(f);
  return {int(complex.source(h).idx()), int(complex.target(h).idx()), int(complex.target(complex.next(h)).idx())};
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsTransfer
/// \brief returns `interpolate_input_values()` as a matrix: a row for each vertex of the overlay, a
/// column for each vertex of the surface.
/// \param subdivision the common subdivision. O(size of the overlay).
inline Eigen::SparseMatrix<double> input_interpolation_matrix(const Common_subdivision& subdivision)
{
  return internal::interpolation_matrix(internal::Input_layer(subdivision));
}

/// \ingroup PkgIntrinsicTriangulationsTransfer
/// \brief returns `interpolate_intrinsic_values()` as a matrix.
/// \param subdivision the common subdivision. O(size of the overlay).
inline Eigen::SparseMatrix<double> intrinsic_interpolation_matrix(const Common_subdivision& subdivision)
{
  return internal::interpolation_matrix(internal::Intrinsic_layer(subdivision));
}

/// \ingroup PkgIntrinsicTriangulationsTransfer
/// \brief the integrals of products of the hat functions of the two triangulations.
struct Transfer_mass_matrices
{
  Eigen::SparseMatrix<double> input;     ///< both on the input: `Galerkin_mass_matrix()`
  Eigen::SparseMatrix<double> intrinsic; ///< both on the intrinsic triangulation
  Eigen::SparseMatrix<double> mixed;     ///< rows: intrinsic, columns: input
};

/// \ingroup PkgIntrinsicTriangulationsTransfer
/// \brief integrates the products of the hat functions of the two triangulations exactly.
///
/// On each face of the overlay all hat functions are linear and their products quadratic. If several
/// corners of a face are at the same vertex, its hat function is the sum of the corners' hat functions. Integrals are
/// in the squared unit of the input, up to rounding. O(size of the overlay).
/// \param subdivision the common subdivision
/// \exception Invalid_surface_error as `area()` of `Intrinsic_triangulation`
inline Transfer_mass_matrices transfer_mass_matrices(const Common_subdivision& subdivision)
{
  const Overlay& overlay = subdivision.overlay();
  const internal::Areas_in_both areas(subdivision);
  internal::Triplets entries;
  entries.reserve(9 * std::size_t(overlay.number_of_faces()));
  internal::for_each_overlay_fan(subdivision, areas, [&](Overlay::Face f, const internal::Overlay_fan& fan) {
    Eigen::Matrix3d integrals = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < fan.size(); ++i) {
      Eigen::Matrix3d in_input, in_intrinsic; // a row for each corner of the triangle
      for (int k = 0; k < 3; ++k) {
        const internal::Corner_in_both& corner = fan.corners[k == 0 ? 0 : i + std::size_t(k)];
        in_input.row(k) = Eigen::Map<const Eigen::RowVector3d>(corner.from.data());
        in_intrinsic.row(k) = Eigen::Map<const Eigen::RowVector3d>(corner.to.data());
      }
      // With linear functions: a twelfth of the area times the sum of the products at the
      // corners and of the product of the sums over the corners.
      integrals +=
        fan.area(i) / 12 *
        (in_intrinsic.transpose() * in_input + in_intrinsic.colwise().sum().transpose() * in_input.colwise().sum());
    }
    const auto rows = internal::corner_vertices(subdivision.intrinsic(), overlay.intrinsic_face(f)),
               columns = internal::corner_vertices(subdivision.input(), overlay.input_face(f));
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c)
        entries.emplace_back(rows[r], columns[c], integrals(r, c));
  });
  Eigen::SparseMatrix<double> mixed(subdivision.intrinsic().number_of_vertices(),
                                    subdivision.input().number_of_vertices());
  mixed.setFromTriplets(entries.begin(), entries.end());
  return {Galerkin_mass_matrix(subdivision.input(), areas.input),
          Galerkin_mass_matrix(subdivision.intrinsic(), areas.intrinsic), std::move(mixed)};
}

/// \ingroup PkgIntrinsicTriangulationsTransfer
///
/// \brief the L2 projection of vertex data from one triangulation to the other.
///
/// Of all piecewise linear functions on the target, the result is nearest to the given one in the
/// L2 norm over the surface. It is the solution u of `M u = N v` with the mass matrix M of the
/// target and the mixed mass matrix N. In contrast, copying the values (both
/// triangulations have the same vertices) interpolates. The projection preserves the integral and
/// constants.
///
/// The matrix is factorized once, for any number of projections.
class L2_projection
{
public:
  /// \brief prepares the projection.
  ///
  /// A vertex whose faces have no area, such as an isolated vertex, keeps its value.
  /// \param target_mass the Galerkin mass matrix of the target
  /// \param mixed_mass the mixed mass matrix, with rows for the vertices of the target
  /// \exception Numerical_error if the masses leave the range of `double`
  L2_projection(Eigen::SparseMatrix<double> target_mass, Eigen::SparseMatrix<double> mixed_mass)
    : target_mass_(std::move(target_mass)), mixed_mass_(std::move(mixed_mass))
  {
    for (Eigen::Index v = 0; v < target_mass_.rows(); ++v)
      if (!(target_mass_.coeff(v, v) > 0))
        target_mass_.coeffRef(v, v) = mixed_mass_.coeffRef(v, v) = 1;
    // Scaled by its diagonal, the matrix has eigenvalues in [1/2, 2] (Wathen 1987): no pivot
    // can fail, unless the entries leave the range of double.
    solver_.compute(target_mass_);
    if (solver_.info() != Eigen::Success || !solver_.vectorD().allFinite())
      throw Numerical_error("the masses leave the range of double; scale the surface");
  }

  /// returns the projection of vertex values; if there are several columns, of each.
  template <class Derived>
  typename Derived::PlainObject operator()(const Eigen::MatrixBase<Derived>& values) const
  {
    CGAL_precondition(values.rows() == mixed_mass_.cols());
    return solver_.solve(mixed_mass_ * values);
  }

  /// returns M.
  const Eigen::SparseMatrix<double>& target_mass() const { return target_mass_; }
  /// returns N.
  const Eigen::SparseMatrix<double>& mixed_mass() const { return mixed_mass_; }

private:
  Eigen::SparseMatrix<double> target_mass_;
  Eigen::SparseMatrix<double> mixed_mass_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
};

/// \ingroup PkgIntrinsicTriangulationsTransfer
/// returns the projection of vertex data of the intrinsic triangulation to the input.
/// \param matrices the integrals, as returned by `transfer_mass_matrices()`
inline L2_projection L2_projection_to_input(const Transfer_mass_matrices& matrices)
{
  return L2_projection(matrices.input, matrices.mixed.transpose());
}

/// \ingroup PkgIntrinsicTriangulationsTransfer
/// returns the projection of vertex data of the input to the intrinsic triangulation.
/// \param matrices as above
inline L2_projection L2_projection_to_intrinsic(const Transfer_mass_matrices& matrices)
{
  return L2_projection(matrices.intrinsic, matrices.mixed);
}

/// \ingroup PkgIntrinsicTriangulationsSimplification
/// \brief returns the matrix that interpolates values at the vertices of a triangulation at points of its input.
///
/// With `Simplified_surface::triangulation` and `Simplified_surface::places`, it carries values from the simplified
/// surface to the vertices of the given one. The triangulation may have been flipped or refined since.
///
/// \param triangulation a triangulation that keeps its input
/// \param points points of `triangulation.input()`; those without a halfedge, the places of isolated vertices, get rows
///   of zeros
/// \return a row for each point, with at most three entries that sum to 1, and a column for each vertex
/// \exception Invalid_point_error as `Point_location`
template <class Traits>
Eigen::SparseMatrix<double> prolongation_matrix(const Intrinsic_triangulation<Traits>& triangulation,
                                                const std::vector<Surface_point>& points)
{
  const Common_subdivision subdivision(triangulation);
  const Point_location location(subdivision);
  const Delta_complex& complex = triangulation.connectivity();
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t row = 0; row < points.size(); ++row) {
    if (!points[row].halfedge.is_valid())
      continue;
    const Surface_point p = location.input_to_intrinsic(points[row]);
    Halfedge_index h = p.halfedge;
    for (double weight : internal::with_sum_one(p.coordinates)) {
      if (weight != 0)
        entries.emplace_back(int(row), int(complex.source(h).idx()), weight);
      h = complex.next(h);
    }
  }
  Eigen::SparseMatrix<double> matrix(Eigen::Index(points.size()), Eigen::Index(complex.number_of_vertices()));
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRANSFER_MATRICES_H
