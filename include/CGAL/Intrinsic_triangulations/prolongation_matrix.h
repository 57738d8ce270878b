// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// From values at the vertices of a simplified surface to values at points of it.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_PROLONGATION_MATRIX_H
#define CGAL_INTRINSIC_TRIANGULATIONS_PROLONGATION_MATRIX_H

#include <CGAL/Intrinsic_triangulations/internal/require_Eigen.h>

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Point_location.h>

#include <Eigen/SparseCore>

#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

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

#endif // CGAL_INTRINSIC_TRIANGULATIONS_PROLONGATION_MATRIX_H
