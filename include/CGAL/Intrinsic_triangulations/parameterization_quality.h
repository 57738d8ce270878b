// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// What a map of a triangulation to the plane is worth: triangles that are flipped or
// collapsed, and how far the others are from similar.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_PARAMETERIZATION_QUALITY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_PARAMETERIZATION_QUALITY_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/disk_boundary.h>
#include <CGAL/Intrinsic_triangulations/errors.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsParameterization
/// \brief the result of `check_parameterization()`.
struct Parameterization_check
{
  std::vector<Face_index> flipped;   ///< faces whose image is clockwise
  std::vector<Face_index> collapsed; ///< faces whose image has collinear corners

  /// returns whether each face keeps its orientation.
  bool is_locally_injective() const { return flipped.empty() && collapsed.empty(); }
};

/// \ingroup PkgIntrinsicTriangulationsParameterization
/// \brief decides for each face, exactly, whether its image is counterclockwise.
///
/// A face whose corners are not three different vertices counts as collapsed.
/// \param complex the triangles
/// \param uv the position of each vertex. \pre there is one for each. O(size).
/// \exception Numerical_error if a coordinate is not finite
inline Parameterization_check check_parameterization(const Delta_complex& complex,
                                                     const Planar_points& uv)
{
  CGAL_precondition(uv.size() == complex.number_of_vertices());
  for (std::size_t v = 0; v < uv.size(); ++v)
    if (!std::isfinite(uv[v][0]) || !std::isfinite(uv[v][1]))
      throw Numerical_error("the position of vertex " + std::to_string(v) + " is not finite");
  Parameterization_check check;
  for (Face_index f : complex.faces()) {
    const Halfedge_index h = complex.halfedge(f);
    const Orientation orientation = internal::planar_orientation(
      uv[complex.source(h).idx()], uv[complex.target(h).idx()],
      uv[complex.target(complex.next(h)).idx()]);
    if (orientation == RIGHT_TURN)
      check.flipped.push_back(f);
    else if (orientation == COLLINEAR)
      check.collapsed.push_back(f);
  }
  return check;
}

/// \ingroup PkgIntrinsicTriangulationsParameterization
/// \brief returns for each face the ratio of the larger to the smaller singular value of the
/// linear map that takes it to its image: 1 if the map is a similarity, infinite if it collapses the face.
///
/// Orientation is ignored. In the overlay of input and intrinsic triangulation, each
/// cell has the ratio of the triangle whose map is used.
///
/// \param complex the triangles
/// \param lengths the length of each edge
/// \param areas the area of each face
/// \param uv the position of each vertex. O(size).
inline std::vector<double> quasi_conformal_distortion(const Delta_complex& complex,
                                                      const std::vector<double>& lengths,
                                                      const std::vector<double>& areas,
                                                      const Planar_points& uv)
{
  CGAL_precondition(lengths.size() == complex.number_of_edges());
  CGAL_precondition(areas.size() == complex.number_of_faces());
  CGAL_precondition(uv.size() == complex.number_of_vertices());
  std::vector<double> result;
  result.reserve(complex.number_of_faces());
  for (Face_index f : complex.faces()) {
    const Halfedge_index ij = complex.halfedge(f), jk = complex.next(ij), ki = complex.next(jk);
    const double l_ij = lengths[complex.edge(ij).idx()], l_jk = lengths[complex.edge(jk).idx()],
                 l_ki = lengths[complex.edge(ki).idx()];
    const auto &i = uv[complex.source(ij).idx()], &j = uv[complex.source(jk).idx()],
               &k = uv[complex.source(ki).idx()];
    if (internal::planar_orientation(i, j, k) == COLLINEAR) {
      result.push_back(std::numeric_limits<double>::infinity());
      continue;
    }
    // The ratio does not depend on the size of the image, whose squares may leave the range.
    double size = 0;
    for (int c : {0, 1})
      size = (std::max)({size, std::abs(j[c] / 2 - i[c] / 2), std::abs(k[c] / 2 - i[c] / 2)});
    const auto between = [size](double from, double to) { return (to / 2 - from / 2) / size; };
    // With i at the origin and j at (1, 0), k is (x, y).
    const double x = ((l_ki / l_ij - l_jk / l_ij) * (l_ki / l_ij + l_jk / l_ij) + 1) / 2,
                 y = 2 * (areas[f.idx()] / l_ij / l_ij);
    const double a = between(i[0], j[0]), c = between(i[1], j[1]),
                 b = (between(i[0], k[0]) - a * x) / y, d = (between(i[1], k[1]) - c * x) / y;
    // Half the sum and half the difference of the singular values.
    const double half_sum = std::hypot(a + d, c - b) / 2, half_difference = std::hypot(a - d, b + c) / 2;
    const double larger = (std::max)(half_sum, half_difference) +
                          (std::min)(half_sum, half_difference);
    const double determinant = std::abs(a * d - b * c);
    const double ratio = larger / determinant * larger;
    result.push_back(ratio >= 1        ? ratio // false for NaN as well
                     : determinant > 0 ? 1.
                                       : std::numeric_limits<double>::infinity());
  }
  return result;
}

/// \ingroup PkgIntrinsicTriangulationsParameterization
/// \brief mean, 99th percentile and maximum of the distortion of a map.
struct Distortion_summary
{
  double mean = 1;          ///< weighted by the areas on the surface
  double percentile_99 = 1; ///< the smallest value that is not exceeded on 99 % of the area
  double maximum = 1;       ///< over all faces
};

/// \ingroup PkgIntrinsicTriangulationsParameterization
/// \brief summarizes the distortion of the faces. Faces of zero area are ignored. O(n log n).
inline Distortion_summary summarize_distortion(const std::vector<double>& distortion,
                                               const std::vector<double>& areas)
{
  CGAL_precondition(distortion.size() == areas.size());
  std::vector<std::size_t> order;
  const std::vector<double> shares = internal::over_largest(areas);
  double total = 0;
  for (std::size_t f = 0; f < areas.size(); ++f)
    if (areas[f] > 0) {
      order.push_back(f);
      total += shares[f];
    }
  std::sort(order.begin(), order.end(), [&](std::size_t f, std::size_t g) {
    return distortion[f] < distortion[g];
  });
  Distortion_summary summary;
  if (order.empty())
    return summary;
  summary.mean = 0;
  double sum = 0;
  bool is_found = false;
  for (std::size_t f : order) {
    summary.mean += distortion[f] * (shares[f] / total);
    sum += shares[f];
    if (!is_found && sum >= 0.99 * total) {
      summary.percentile_99 = distortion[f];
      is_found = true;
    }
  }
  summary.maximum = distortion[order.back()];
  return summary;
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_PARAMETERIZATION_QUALITY_H
