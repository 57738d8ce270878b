// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The boundary of a topological disk, and where a parameterization can place it.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DISK_BOUNDARY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DISK_BOUNDARY_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/errors.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/assertions.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsParameterization
/// \brief points of the plane: the UV coordinates of all vertices in their order, or those of
/// the corners of a polygon.
using Planar_points = std::vector<std::array<double, 2>>;

/// \cond SKIP_IN_MANUAL
namespace internal {

[[noreturn]] inline void throw_no_disk(const std::string& what)
{
  throw Invalid_surface_error(Invalid_surface_error::Defect::WRONG_TOPOLOGY, 0, 1,
                              "a map to the plane needs a disk: one component with one boundary "
                              "and no handle; the surface " +
                                what);
}

inline std::size_t number_of_components(const Delta_complex& complex)
{
  std::vector<bool> is_visited(complex.number_of_faces(), false);
  std::vector<Face_index> stack;
  std::size_t components = 0;
  for (Face_index first : complex.faces()) {
    if (is_visited[first.idx()])
      continue;
    ++components;
    is_visited[first.idx()] = true;
    stack.push_back(first);
    while (!stack.empty()) {
      Halfedge_index h = complex.halfedge(stack.back());
      stack.pop_back();
      for (int side = 0; side < 3; ++side, h = complex.next(h)) {
        const Face_index f = complex.face(complex.opposite(h));
        if (f.is_valid() && !is_visited[f.idx()]) {
          is_visited[f.idx()] = true;
          stack.push_back(f);
        }
      }
    }
  }
  return components;
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

using Planar_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

inline Orientation planar_orientation(const std::array<double, 2>& p,
                                      const std::array<double, 2>& q,
                                      const std::array<double, 2>& r)
{
  using Point = Planar_kernel::Point_2;
  return CGAL::orientation(Point(p[0], p[1]), Point(q[0], q[1]), Point(r[0], r[1]));
}

// The lengths over the largest of them: their sum does not overflow.
inline std::vector<double> over_largest(std::vector<double> lengths)
{
  const double largest = lengths.empty() ? 0 : *std::max_element(lengths.begin(), lengths.end());
  if (largest > 0)
    for (double& l : lengths)
      l /= largest;
  return lengths;
}

// The square root of the sum of areas, which may overflow itself.
inline double root_of_sum(const std::vector<double>& areas)
{
  double sum = 0;
  for (double a : over_largest(areas))
    sum += a;
  return std::sqrt(sum) * std::sqrt(*std::max_element(areas.begin(), areas.end()));
}

} // namespace internal
/// \endcond

/// \ingroup PkgIntrinsicTriangulationsParameterization
/// \brief returns the boundary of a disk: its halfedges that have a face, counterclockwise.
///
/// Border edges are never flipped, so an intrinsic triangulation and its input have the
/// same boundary. The first halfedge is `opposite(h)` of the first border halfedge h. Isolated
/// vertices are ignored.
/// \exception Invalid_surface_error if the surface is not a disk; the message says what it is
///   and what is needed. O(size).
inline std::vector<Halfedge_index> disk_boundary(const Delta_complex& complex)
{
  const std::size_t components = internal::number_of_components(complex),
                    boundaries = internal::number_of_boundaries(complex);
  if (components != 1)
    internal::throw_no_disk("has " + std::to_string(components) +
                            " components: take one at a time");
  if (boundaries == 0)
    internal::throw_no_disk("is closed: cut it open along edges, or remove a face");
  if (boundaries > 1)
    internal::throw_no_disk("has " + std::to_string(boundaries) +
                            " boundaries: fill all but one, or cut from one to the other");
  const long long euler = (long long)(internal::number_of_vertices_with_faces(complex)) -
                          (long long)(complex.number_of_edges()) +
                          (long long)(complex.number_of_faces());
  if (euler != 1)
    internal::throw_no_disk("has " + std::to_string((1 - euler) / 2) +
                            " handles: cut each of them open along edges");

  const auto halfedges = complex.halfedges();
  const Halfedge_index first = *std::find_if(
    halfedges.begin(), halfedges.end(), [&](Halfedge_index h) { return complex.is_border(h); });
  std::vector<Halfedge_index> boundary;
  Halfedge_index h = first;
  do {
    boundary.push_back(complex.opposite(h));
    h = complex.prev(h); // the border runs clockwise
  } while (h != first);
  return boundary;
}

/// \ingroup PkgIntrinsicTriangulationsParameterization
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

/// \ingroup PkgIntrinsicTriangulationsParameterization
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
/// \exception Error if the polygon is not strictly convex and counterclockwise, has a coordinate
///   that is not finite or beyond 1e300, or has more corners than the boundary has vertices. O(size).
inline Planar_points positions_on_polygon(const std::vector<double>& boundary_lengths,
                                          const Planar_points& corners)
{
  const std::vector<double> lengths = internal::over_largest(boundary_lengths);
  const std::size_t n = lengths.size(), m = corners.size();
  for (std::size_t i = 0; i < m; ++i)
    for (double x : corners[i])
      if (!(std::abs(x) <= 1e300))
        throw Error("corner " + std::to_string(i) +
                    " of the polygon: a coordinate is not finite, or beyond 1e300");
  for (std::size_t i = 0; i < m; ++i) {
    const bool turns_left = m >= 3 && internal::planar_orientation(
                                        corners[i], corners[(i + 1) % m], corners[(i + 2) % m]) ==
                                        LEFT_TURN;
    const bool is_around = i == 0 || i + 1 == m ||
                           internal::planar_orientation(corners[0], corners[i], corners[i + 1]) ==
                             LEFT_TURN;
    if (!turns_left || !is_around)
      throw Error("corner " + std::to_string(i) +
                  " of the polygon: it is not strictly convex and counterclockwise there");
  }
  if (m < 3 || m > n)
    throw Error("a polygon with " + std::to_string(m) + " corners for a boundary with " +
                std::to_string(n) + " vertices: there must be 3 at least, and no more than vertices");

  // Arc lengths from the first vertex and corner on; the last is the whole.
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
    std::size_t v = std::size_t(
      std::lower_bound(along_boundary.begin(), along_boundary.end() - 1, wanted) -
      along_boundary.begin());
    if (v > 0 && wanted - along_boundary[v - 1] < along_boundary[v] - wanted)
      --v;
    vertex_at.push_back((std::min)((std::max)(v, vertex_at.back() + 1), n - (m - i)));
  }
  vertex_at.push_back(n);

  Planar_points positions;
  positions.reserve(n);
  for (std::size_t i = 0; i < m; ++i) {
    const auto &p = corners[i], &q = corners[(i + 1) % m];
    // Summed up for each side alone, so that short edges count after long ones.
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

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DISK_BOUNDARY_H
