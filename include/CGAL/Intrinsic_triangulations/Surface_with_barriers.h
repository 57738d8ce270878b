// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Distances and paths that do not cross given curves.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SURFACE_WITH_BARRIERS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SURFACE_WITH_BARRIERS_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Geodesic_source.h>
#include <CGAL/Intrinsic_triangulations/Index.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/cut_along_path.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/geodesic_distances.h>
#include <CGAL/Intrinsic_triangulations/internal/named_parameters.h>

#include <array>
#include <cstddef>
#include <map>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief a surface that is cut open along barriers: curves that no path crosses.
///
/// Paths may run along a barrier, and turn around its ends, unless these lie on the border or on other barriers. A
/// triangulation of `connectivity()` and `points()` gives distances by heat, paths and whatever else is asked of the cut
/// surface; the functions of this class lead from the input to it and back.
class Surface_with_barriers
{
public:
  /// \param input the surface; no two of its edges have the same two ends
  /// \param points of its vertices
  /// \param barriers curves, two consecutive points in the face of the first, as of `geodesic_points()`. They meet only
  ///   at points that both have; points within 2⁻⁴⁰ of an edge lie on it, as for `cut_along_path()`
  /// \exception Invalid_surface_error, Invalid_point_error as `cut_along_path()`
  Surface_with_barriers(const Delta_complex& input, const std::vector<std::array<double, 3>>& points,
                        const std::vector<std::vector<Surface_point>>& barriers);

  const Delta_complex& connectivity() const { return connectivity_; }              ///< of the cut surface
  const std::vector<std::array<double, 3>>& points() const { return cut_.points; } ///< of its vertices
  /// returns the vertices at a vertex of the input: one for each side of the barriers there.
  std::vector<Vertex_index> copies(Vertex_index v) const;
  /// returns sources of the input on the cut surface. Those within 10⁻¹² (as a fraction of a face) of a barrier lie on
  /// both sides. \exception Invalid_point_error as `geodesic_distances_from()`
  std::vector<Geodesic_source> sources(const std::vector<Geodesic_source>& of_input) const;
  /// returns distances of the vertices of the input: at a barrier, those of the nearer side.
  Geodesic_distances of_nearer_sides(Geodesic_distances of_cut_surface) const;
  /// returns points of the cut surface as points of the input.
  std::vector<Surface_point> on_input(const std::vector<Surface_point>& path) const;

private:
  using Coordinates = std::array<double, 3>;
  using Parts = std::vector<std::vector<Surface_point>>;

  void add_point(const Surface_point& p, Parts& parts) const;
  void add_segment(const Surface_point& p, const Surface_point& q, Parts& parts) const;
  void add_segment_in_face(Halfedge_index h, const Coordinates& from, const Coordinates& to, Parts& parts) const;
  Surface_point checked(const Surface_point& p) const;
  std::array<Coordinates, 3> corners(std::size_t triangle, Halfedge_index h) const;

  Delta_complex input_, connectivity_;
  Cut_surface cut_;
  std::vector<std::size_t> first_; // the first triangle of a face of the input
  std::multimap<Vertex_index, Vertex_index> copies_;
};

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief as `geodesic_distances_from()` of a triangulation, by paths that cross no barrier.
/// \param surface the surface
/// \param sources points of its input
/// \param np as above
template <class NamedParameters = parameters::Default_named_parameters>
Geodesic_distances geodesic_distances_from(const Surface_with_barriers& surface,
                                           const std::vector<Geodesic_source>& sources,
                                           const NamedParameters& np = parameters::default_values())
{
  Intrinsic_triangulation<Filtered_edge_length_traits> triangulation(surface.connectivity(), surface.points());
  flip_to_Delaunay(triangulation, np);
  return surface.of_nearer_sides(geodesic_distances_from(triangulation, surface.sources(sources), np));
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SURFACE_WITH_BARRIERS_H
