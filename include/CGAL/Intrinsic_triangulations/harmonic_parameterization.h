// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Maps of a disk to the plane: harmonic with a fixed boundary, or natural, and measures of quality.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_HARMONIC_PARAMETERIZATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_HARMONIC_PARAMETERIZATION_H

#include <CGAL/Intrinsic_triangulations/internal/require_Eigen.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Laplace_Beltrami.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/parameterization/disk_shape.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \addtogroup PkgIntrinsicTriangulationsParameterization
/// @{

/// \brief points of the plane: the UV coordinates of all vertices, in their order, or of the corners of a polygon.
using Planar_points = std::vector<std::array<double, 2>>;

/// \brief returns the boundary of a disk: its halfedges that have a face, counterclockwise.
///
/// Border edges are never flipped, so an intrinsic triangulation and its input have the
/// same boundary. The first halfedge is `opposite(h)` of the first border halfedge h. Isolated
/// vertices are ignored.
/// \param complex the triangles
/// \exception Invalid_surface_error if the surface is not a disk; the message says why not and suggests a remedy.
///   O(size).
inline std::vector<Halfedge_index> disk_boundary(const Delta_complex& complex)
{
  const std::size_t components = internal::number_of_components(complex),
                    boundaries = internal::number_of_boundaries(complex);
  if (components != 1)
    internal::throw_no_disk("has " + std::to_string(components) + " components: take one at a time");
  if (boundaries == 0)
    internal::throw_no_disk("is closed: cut it open along edges, or remove a face");
  if (boundaries > 1)
    internal::throw_no_disk("has " + std::to_string(boundaries) +
                            " boundaries: fill all but one, or cut from one to the other");
  const long long euler = (long long)(internal::number_of_vertices_with_faces(complex)) -
                          (long long)(complex.number_of_edges()) + (long long)(complex.number_of_faces());
  if (euler != 1)
    internal::throw_no_disk("has " + std::to_string((1 - euler) / 2) + " handles: cut each of them open along edges");

  const auto halfedges = complex.halfedges();
  const Halfedge_index first =
    *std::find_if(halfedges.begin(), halfedges.end(), [&](Halfedge_index h) { return complex.is_border(h); });
  std::vector<Halfedge_index> boundary;
  Halfedge_index h = first;
  do {
    boundary.push_back(complex.opposite(h));
    h = complex.prev(h); // the border runs clockwise
  } while (h != first);
  return boundary;
}

/// \brief places the vertices of a boundary on the unit circle, by arc length.
///
/// \param boundary_lengths the lengths of the boundary's edges in order. \pre they are positive
/// \return the position where each edge begins; the first is (1, 0). O(size).
inline Planar_points positions_on_circle(const std::vector<double>& boundary_lengths)
{
  const std::vector<double> lengths = internal::over_largest(boundary_lengths);
  double total = 0;
  for (double l : lengths)
    total += l;
  Planar_points positions;
  positions.reserve(lengths.size());
  double sum = 0;
  for (double l : lengths) {
    const double angle = boost::math::constants::two_pi<double>() * (sum / total);
    positions.push_back({std::cos(angle), std::sin(angle)});
    sum += l;
  }
  return positions;
}

/// \brief places the vertices of a boundary on a convex polygon.
///
/// The first vertex goes to the first corner. Each other corner gets the vertex that is
/// nearest if boundary and polygon are traversed at the same rate of arc length, except for vertices
/// that an earlier corner has or a later one needs. On each side, the vertices in between
/// are placed by arc length.
///
/// \param boundary_lengths the lengths of the boundary's edges in order. \pre they are positive
/// \param corners the corners of the polygon, counterclockwise and strictly convex
/// \return the position where each edge begins
/// \exception Invalid_argument_error if the polygon is not strictly convex and counterclockwise, has a coordinate
///   that is not finite or beyond 1e300, or has more corners than the boundary has vertices. O(size).
inline Planar_points positions_on_polygon(const std::vector<double>& boundary_lengths, const Planar_points& corners)
{
  const std::vector<double> lengths = internal::over_largest(boundary_lengths);
  const std::size_t n = lengths.size(), m = corners.size();
  for (std::size_t i = 0; i < m; ++i)
    for (double x : corners[i])
      if (!(std::abs(x) <= 1e300))
        throw Invalid_argument_error("corner " + std::to_string(i) +
                                     " of the polygon: a coordinate is not finite, or beyond 1e300");
  for (std::size_t i = 0; i < m; ++i) {
    const bool turns_left =
      m >= 3 && internal::planar_orientation(corners[i], corners[(i + 1) % m], corners[(i + 2) % m]) == LEFT_TURN;
    const bool is_around =
      i == 0 || i + 1 == m || internal::planar_orientation(corners[0], corners[i], corners[i + 1]) == LEFT_TURN;
    if (!turns_left || !is_around)
      throw Invalid_argument_error("corner " + std::to_string(i) +
                                   " of the polygon: it is not strictly convex and counterclockwise there");
  }
  if (m < 3 || m > n)
    throw Invalid_argument_error("a polygon with " + std::to_string(m) + " corners for a boundary with " +
                                 std::to_string(n) + " vertices: there must be 3 at least, and no more than vertices");

  // Arc lengths from the first vertex and corner on; the last one is the total.
  std::vector<double> along_boundary{0}, along_polygon{0};
  for (double l : lengths)
    along_boundary.push_back(along_boundary.back() + l);
  for (std::size_t i = 0; i < m; ++i) {
    const auto &p = corners[i], &q = corners[(i + 1) % m];
    along_polygon.push_back(along_polygon.back() + std::hypot(q[0] - p[0], q[1] - p[1]));
  }
  std::vector<std::size_t> vertex_at{0};
  for (std::size_t i = 1; i < m; ++i) {
    const double wanted = along_polygon[i] / along_polygon.back() * along_boundary.back();
    std::size_t v =
      std::size_t(std::lower_bound(along_boundary.begin(), along_boundary.end() - 1, wanted) - along_boundary.begin());
    if (v > 0 && wanted - along_boundary[v - 1] < along_boundary[v] - wanted)
      --v;
    vertex_at.push_back((std::min)((std::max)(v, vertex_at.back() + 1), n - (m - i)));
  }
  vertex_at.push_back(n);

  Planar_points positions;
  positions.reserve(n);
  for (std::size_t i = 0; i < m; ++i) {
    const auto &p = corners[i], &q = corners[(i + 1) % m];
    // Summed up for each side separately, so that short edges after long ones count.
    double side = 0, along_side = 0;
    for (std::size_t v = vertex_at[i]; v < vertex_at[i + 1]; ++v)
      side += lengths[v];
    for (std::size_t v = vertex_at[i]; v < vertex_at[i + 1]; ++v) {
      const double t = along_side / side;
      positions.push_back({p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])});
      along_side += lengths[v];
    }
  }
  return positions;
}

/// \brief returns the discrete harmonic map of a disk whose boundary is fixed.
///
/// Each interior vertex is the average of its neighbors, weighted with the cotangent weights.
/// If these are positive and the boundary is a convex polygon, the map is
/// one-to-one, by the theorem of Tutte and Floater. Negative weights can fold it. Edges with
/// weight zero (ties) do not count. If the other neighbors of a vertex lie on
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
inline Planar_points harmonic_parameterization(const Delta_complex& complex, const std::vector<double>& weights,
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
  internal::solve_with_fixed_values(stiffness_matrix(complex, weights), is_fixed, x, "the Laplace-Beltrami operator");
  Planar_points uv;
  uv.reserve(complex.number_of_vertices());
  for (Eigen::Index v = 0; v < x.rows(); ++v)
    uv.push_back({x(v, 0), x(v, 1)});
  return uv;
}

/// \brief returns the discrete harmonic map of a disk to the unit disk, with the boundary placed
/// on the unit circle by arc length.
///
/// The map of an intrinsic Delaunay triangulation is piecewise linear on the intrinsic
/// triangles. A triangulation that was not flipped gives the usual, extrinsic map.
/// Otherwise as above; exceptions also as for `cotangent_weights()`.
/// \param triangulation the triangulation
template <class Traits>
Planar_points harmonic_parameterization(const Intrinsic_triangulation<Traits>& triangulation)
{
  const Delta_complex& complex = triangulation.connectivity();
  return harmonic_parameterization(
    complex, cotangent_weights(triangulation),
    positions_on_circle(internal::boundary_lengths(complex, disk_boundary(complex), edge_lengths(triangulation))));
}

/// \brief returns the discrete harmonic map of a disk to a convex polygon, with the boundary placed
/// by `positions_on_polygon()`.
///
/// A triangle with all three corners on one side of the polygon collapses, up to rounding:
/// on a side that is not parallel to an axis, the check may find it turned over.
/// Otherwise as above; exceptions also as for `positions_on_polygon()`.
/// \param triangulation the triangulation
/// \param polygon the corners of the polygon, as for `positions_on_polygon()`
template <class Traits>
Planar_points harmonic_parameterization(const Intrinsic_triangulation<Traits>& triangulation,
                                        const Planar_points& polygon)
{
  const Delta_complex& complex = triangulation.connectivity();
  return harmonic_parameterization(
    complex, cotangent_weights(triangulation),
    positions_on_polygon(internal::boundary_lengths(complex, disk_boundary(complex), edge_lengths(triangulation)),
                         polygon));
}

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
inline Planar_points natural_parameterization(const Delta_complex& complex, const std::vector<double>& weights,
                                              const std::vector<double>& lengths, const std::vector<double>& areas)
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

  const std::vector<double> sides = internal::over_largest(internal::boundary_lengths(complex, boundary, lengths));
  double total = 0, sum = 0;
  for (double l : sides)
    total += l;
  std::size_t middle = 0;
  while (sum < total / 2)
    sum += sides[middle++];
  const std::size_t first = complex.source(boundary.front()).idx(), second = complex.target(boundary[middle - 1]).idx();
  std::vector<bool> is_fixed(2 * n, false);
  for (Vertex_index v : complex.vertices())
    is_fixed[v.idx()] = is_fixed[v.idx() + n] = !complex.halfedge(v).is_valid();
  Eigen::MatrixXd x = Eigen::MatrixXd::Zero(Eigen::Index(2 * n), 1);
  for (std::size_t v : {first, second})
    is_fixed[v] = is_fixed[v + n] = true;
  x(Eigen::Index(second), 0) = 1;
  internal::solve_with_fixed_values(energy, is_fixed, x, "the conformal energy");

  Planar_points uv;
  uv.reserve(n);
  for (std::size_t v = 0; v < n; ++v)
    uv.push_back({x(Eigen::Index(v), 0), x(Eigen::Index(v + n), 0)});
  internal::scale_to_area(complex, boundary, areas, uv,
                          "the map with natural boundary conditions collapses the surface");
  return uv;
}

/// as above, for a triangulation.
/// \param triangulation the triangulation
template <class Traits>
Planar_points natural_parameterization(const Intrinsic_triangulation<Traits>& triangulation)
{
  return natural_parameterization(triangulation.connectivity(), cotangent_weights(triangulation),
                                  edge_lengths(triangulation), face_areas(triangulation));
}

/// \brief the result of `check_parameterization()`.
struct Parameterization_check
{
  std::vector<Face_index> flipped;   ///< faces whose image is clockwise
  std::vector<Face_index> collapsed; ///< faces whose image has collinear corners

  /// returns whether each face keeps its orientation.
  bool is_locally_injective() const { return flipped.empty() && collapsed.empty(); }
};

/// \brief decides for each face, exactly, whether its image is counterclockwise.
///
/// A face whose corners are not three different vertices counts as collapsed.
/// \param complex the triangles
/// \param uv the position of each vertex. \pre there is one for each. O(size).
/// \exception Numerical_error if a coordinate is not finite
inline Parameterization_check check_parameterization(const Delta_complex& complex, const Planar_points& uv)
{
  CGAL_precondition(uv.size() == complex.number_of_vertices());
  for (std::size_t v = 0; v < uv.size(); ++v)
    if (!std::isfinite(uv[v][0]) || !std::isfinite(uv[v][1]))
      throw Numerical_error("the position of vertex " + std::to_string(v) + " is not finite");
  Parameterization_check check;
  for (Face_index f : complex.faces()) {
    const Halfedge_index h = complex.halfedge(f);
    const Orientation orientation = internal::planar_orientation(
      uv[complex.source(h).idx()], uv[complex.target(h).idx()], uv[complex.target(complex.next(h)).idx()]);
    if (orientation == RIGHT_TURN)
      check.flipped.push_back(f);
    else if (orientation == COLLINEAR)
      check.collapsed.push_back(f);
  }
  return check;
}

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
inline std::vector<double> quasi_conformal_distortion(const Delta_complex& complex, const std::vector<double>& lengths,
                                                      const std::vector<double>& areas, const Planar_points& uv)
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
    const auto &i = uv[complex.source(ij).idx()], &j = uv[complex.source(jk).idx()], &k = uv[complex.source(ki).idx()];
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
    const double a = between(i[0], j[0]), c = between(i[1], j[1]), b = (between(i[0], k[0]) - a * x) / y,
                 d = (between(i[1], k[1]) - c * x) / y;
    // Half the sum and half the difference of the singular values.
    const double half_sum = std::hypot(a + d, c - b) / 2, half_difference = std::hypot(a - d, b + c) / 2;
    const double larger = (std::max)(half_sum, half_difference) + (std::min)(half_sum, half_difference);
    const double determinant = std::abs(a * d - b * c);
    const double ratio = larger / determinant * larger;
    result.push_back(ratio >= 1        ? ratio // false for NaN as well
                     : determinant > 0 ? 1.
                                       : std::numeric_limits<double>::infinity());
  }
  return result;
}

/// \brief mean, 99th percentile and maximum of the distortion of a map.
struct Distortion_summary
{
  double mean = 1;          ///< weighted by the areas on the surface
  double percentile_99 = 1; ///< the smallest value that is not exceeded on 99 % of the area
  double maximum = 1;       ///< over all faces
};

/// \brief summarizes the distortion of the faces. Faces of zero area are ignored. O(n).
/// \param distortion, areas the distortion and the area of each face
/// \pre both have the same size
inline Distortion_summary summarize_distortion(const std::vector<double>& distortion, const std::vector<double>& areas)
{
  CGAL_precondition(distortion.size() == areas.size());
  const std::vector<double> shares = internal::over_largest(areas);
  std::vector<std::pair<double, double>> faces; // distortion and share
  for (std::size_t f = 0; f < areas.size(); ++f)
    if (areas[f] > 0)
      faces.emplace_back(distortion[f], shares[f]);
  Distortion_summary summary;
  if (faces.empty())
    return summary;
  using Iterator = std::vector<std::pair<double, double>>::const_iterator;
  const auto sum = [](Iterator begin, Iterator end) {
    return std::accumulate(begin, end, 0., [](double s, const auto& face) { return s + face.second; });
  };
  const double total = sum(faces.begin(), faces.end());
  summary.mean = std::accumulate(faces.begin(), faces.end(), 0.,
                                 [&](double s, const auto& face) { return s + face.first * (face.second / total); });
  summary.maximum = std::max_element(faces.begin(), faces.end())->first;
  double before = 0;
  auto begin = faces.begin(), end = faces.end();
  while (end - begin > 1) {
    const auto middle = begin + (end - begin) / 2;
    std::nth_element(begin, middle, end);
    const double half = sum(begin, middle);
    if (before + half >= 0.99 * total) {
      end = middle;
    } else {
      before += half;
      begin = middle;
    }
  }
  summary.percentile_99 = begin->first;
  return summary;
}

/// @}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_HARMONIC_PARAMETERIZATION_H
