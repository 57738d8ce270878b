// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The Laplace-Beltrami operator of any triangles.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TUFTED_LAPLACIAN_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TUFTED_LAPLACIAN_H

#include <CGAL/Intrinsic_triangulations/internal/require_Eigen.h>
#include <CGAL/Intrinsic_triangulations/Tufted_cover.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/internal/flips/default_traits.h>
#include <CGAL/Intrinsic_triangulations/internal/cover/Row_of_cover_vertex.h>
#include <CGAL/Intrinsic_triangulations/internal/matrices/assemble_symmetric_matrix.h>
#include <CGAL/Intrinsic_triangulations/internal/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/observer.h>
#include <CGAL/Intrinsic_triangulations/reports.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsCover
/// \brief the kind of a mass matrix.
enum class Mass_type {
  LUMPED,  ///< diagonal: a third of the area around each vertex
  GALERKIN ///< the matrix of linear finite elements
};

/// \ingroup PkgIntrinsicTriangulationsCover
/// \brief stiffness matrix `L` and mass matrix `M` of any triangles: `L u = λ M u` is the eigenvalue problem of `−Δ`.
struct Tufted_Laplacian
{
  Eigen::SparseMatrix<double> stiffness; ///< positive semidefinite, as with `Stiffness_factor::HALF`
  Eigen::SparseMatrix<double> mass;      ///< lumped or Galerkin
  /// for each input vertex, the vertex that represents it: the row of a merged vertex is zero, and it has the value of
  /// its representative
  std::vector<std::uint32_t> representative;
  Tufted_cover_report report; ///< the defects of the triangles, and how they were handled
  Flip_report flips;          ///< how the cover became Delaunay
  double minimum_weight = 0;  ///< the smallest of the numbers `(cot k + cot l)/2` of edges of the cover
};

/// \cond SKIP_IN_MANUAL
namespace internal {

// The areas of the faces, with their weights.
inline std::vector<double> shares_of_area(const Tufted_cover& cover)
{
  const Row_of_cover_vertex row(cover);
  std::vector<double> areas = face_areas(cover.triangulation);
  for (Face_index f : cover.triangulation.connectivity().faces())
    areas[f.idx()] *= row.share(f);
  return areas;
}

// The stiffness matrix, and the smallest (cot k + cot l)/2 of an edge between different vertices of the input, or 0.
inline std::pair<Eigen::SparseMatrix<double>, double> stiffness_and_minimum_weight(const Tufted_cover& cover)
{
  const Cotangent_weight<Filtered_edge_length_traits> weight(cover.triangulation);
  const Row_of_cover_vertex row(cover);
  double minimum = std::numeric_limits<double>::infinity();
  Eigen::SparseMatrix<double> result = assemble_symmetric_matrix(
    cover.triangulation.connectivity(), row,
    [&](Edge_index e) {
      const double w = weight(e);
      minimum = (std::min)(minimum, w);
      return -0.5 * row.share(e) * w;
    },
    [](int, double sum_of_others) { return 0 - sum_of_others; });
  return {std::move(result), minimum < std::numeric_limits<double>::infinity() ? minimum / 2 : 0};
}

} // namespace internal
/// \endcond

/// \ingroup PkgIntrinsicTriangulationsCover
/// \brief returns the stiffness matrix of a cover for the vertices of the input.
///
/// This is `stiffness_matrix()` of the cover, summed over all cover edges above the same two input vertices, and halved
/// where there are two copies of each face. If the cover was made Delaunay and has no border, no entry off the diagonal
/// is positive. O(size).
/// \param cover the cover, flipped or not
/// \exception Invalid_surface_error as `cotangent_weights()`
inline Eigen::SparseMatrix<double> stiffness_matrix(const Tufted_cover& cover)
{
  return internal::stiffness_and_minimum_weight(cover).first;
}

/// \ingroup PkgIntrinsicTriangulationsCover
/// \brief returns the lumped mass matrix of a cover for the vertices of the input: a third of the area of the faces at
/// each vertex. O(size).
/// \param cover the cover
/// \exception Invalid_surface_error as `face_areas()`
inline Eigen::SparseMatrix<double> lumped_mass_matrix(const Tufted_cover& cover)
{
  return internal::assemble_lumped_mass_matrix(cover.triangulation.connectivity(), internal::Row_of_cover_vertex(cover),
                                               internal::shares_of_area(cover));
}

/// \ingroup PkgIntrinsicTriangulationsCover
/// \brief returns the Galerkin mass matrix of a cover for the vertices of the input. O(size).
/// \param cover the cover
/// \exception Invalid_surface_error as `face_areas()`
inline Eigen::SparseMatrix<double> Galerkin_mass_matrix(const Tufted_cover& cover)
{
  const Delta_complex& complex = cover.triangulation.connectivity();
  const internal::Row_of_cover_vertex row(cover);
  const std::vector<double> areas = internal::shares_of_area(cover);
  std::vector<double> diagonal(row.number_of_rows(), 0);
  for (Halfedge_index h : complex.halfedges()) {
    if (complex.is_border(h))
      continue;
    const std::uint32_t v = row(complex.target(h));
    const double mass = areas[complex.face(h).idx()] / 6;
    diagonal[v] += mass;
    if (v == row(complex.source(h))) // two corners of the face at the same vertex
      diagonal[v] += mass;
  }
  return internal::assemble_symmetric_matrix(
    complex, row, [&](Edge_index e) { return internal::area_beside(complex, areas, e) / 12; },
    [&](int v, double) { return diagonal[std::size_t(v)]; });
}

/// \cond SKIP_IN_MANUAL
namespace internal {

template <class NamedParameters>
Tufted_Laplacian operator_of_cover(Tufted_cover cover, const NamedParameters& np)
{
  Tufted_Laplacian result;
  result.flips = flip_to_Delaunay(cover.triangulation, np);
  cover.triangulation.set_interruption(go_further_function_of(np));
  std::tie(result.stiffness, result.minimum_weight) = stiffness_and_minimum_weight(cover);
  result.mass = value_of<Parameter::MASS_TYPE>(np, Mass_type::LUMPED) == Mass_type::LUMPED
                  ? lumped_mass_matrix(cover)
                  : Galerkin_mass_matrix(cover);
  result.representative = std::move(cover.representative);
  result.report = cover.report;
  return result;
}

} // namespace internal
/// \endcond

/// \ingroup PkgIntrinsicTriangulationsCover
/// \brief returns the Laplace-Beltrami operator of any triangles, by their tufted cover made intrinsic Delaunay.
///
///     auto result = tufted_Laplacian(points, triangles);
///     // result.stiffness, result.mass
///
/// Rows belong to the input vertices. `L` is symmetric and positive semidefinite; its rows sum to zero; no entry off
/// the diagonal is positive. Neither depends on a tolerance, and no length is changed unless you ask for mollification.
/// Scale and sign are as for `intrinsic_Delaunay_Laplacian()`; on a closed oriented surface both operators are the
/// same. On a surface with border they differ, because edges at the border are flipped here as well. Entries are
/// rounded.
///
/// A vertex has a row of zeros in both matrices if it has no faces, if all of them were dropped or collapsed, or if it
/// was merged with another vertex, its `representative`.
///
/// \param points, triangles as for `make_tufted_cover()`
/// \param np an optional sequence of named parameters: those of `make_tufted_cover()` and `flip_to_Delaunay()`, and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{mass_type}
///     \cgalParamDescription{which mass matrix is returned}
///     \cgalParamType{`Mass_type`}
///     \cgalParamDefault{`Mass_type::LUMPED`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \exception Invalid_surface_error as `make_tufted_cover()`; also if flips cannot remove a face of zero area, which
///   can happen only at a border
/// \exception Cancelled_error if the visitor asks for it
///
/// Complexity: as `make_tufted_cover()`, plus the flips.
///
/// Source: N. Sharp, K. Crane, "A Laplacian for nonmanifold triangle meshes", 2020.
template <class PointRange, class TriangleRange, class NamedParameters = parameters::Default_named_parameters>
Tufted_Laplacian tufted_Laplacian(const PointRange& points, const TriangleRange& triangles,
                                  const NamedParameters& np = parameters::default_values())
{
  return internal::operator_of_cover(make_tufted_cover(points, triangles, np), np);
}

/// \ingroup PkgIntrinsicTriangulationsCover
/// \brief as `tufted_Laplacian()` of points, for a surface given by lengths.
/// \param complex the triangles
/// \param lengths the length of each edge
/// \param np as above
template <class NamedParameters = parameters::Default_named_parameters>
Tufted_Laplacian tufted_Laplacian(const Delta_complex& complex, const std::vector<double>& lengths,
                                  const NamedParameters& np = parameters::default_values())
{
  return internal::operator_of_cover(make_tufted_cover(complex, lengths, np), np);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TUFTED_LAPLACIAN_H
