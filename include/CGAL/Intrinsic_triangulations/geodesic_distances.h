// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Lengths of shortest paths on a surface.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_GEODESIC_DISTANCES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_GEODESIC_DISTANCES_H

#include <CGAL/Intrinsic_triangulations/internal/require_Eigen.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/Index.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Tufted_cover.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/heat/Distance_bounds.h>
#include <CGAL/Intrinsic_triangulations/internal/heat/Heat_surface.h>
#include <CGAL/Intrinsic_triangulations/internal/heat/Laid_out_faces.h>
#include <CGAL/Intrinsic_triangulations/internal/heat/Window_propagation.h>
#include <CGAL/Intrinsic_triangulations/internal/matrices/assemble_symmetric_matrix.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>
#include <CGAL/Intrinsic_triangulations/internal/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/observer.h>
#include <CGAL/Intrinsic_triangulations/tufted_Laplacian.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief the result of `geodesic_distances()`.
struct Geodesic_distances
{
  std::vector<double> distances; ///< of all vertices, in the unit of the input; infinite where no source is connected
  std::uint64_t number_of_ways = 0; ///< how often a bundle of straight lines was followed to the next face
  bool is_complete = true;          ///< whether all were followed; if not, distances may be as large as along edges
};

/// \cond SKIP_IN_MANUAL
namespace internal {

// How many bundles of straight ways may be followed.
template <class NamedParameters>
std::uint64_t number_of_ways(const NamedParameters& np, const Delta_complex& complex)
{
  return parameters::choose_parameter(parameters::get_parameter(np, internal_np::maximum_number),
                                      1000000 + 500 * std::uint64_t(complex.number_of_faces()));
}

template <class Traits, class Row, class NamedParameters>
Geodesic_distances distances_by_windows(const Intrinsic_triangulation<Traits>& triangulation, const Row& row,
                                        const std::vector<std::uint32_t>& sources, const NamedParameters& np)
{
  const double tolerance = value_of<Parameter::TOLERANCE>(np, 0.001);
  if (!(tolerance >= 0 && tolerance < 1))
    throw Invalid_argument_error("the tolerance of distances has to be at least 0 and less than 1");
  const Interruption interruption(go_further_function_of(np));
  const Laid_out_faces faces(triangulation, row);
  Window_propagation windows(faces, tolerance);
  Geodesic_distances result;
  result.is_complete = windows.run(sources, number_of_ways(np, triangulation.connectivity()), interruption);
  result.number_of_ways = windows.number_of_steps();
  std::vector<double> distances = windows.distances();
  std::map<std::uint32_t, double> pins;
  for (std::uint32_t source : sources)
    pins[source] = 0;
  Distance_bounds(triangulation, row).apply(distances, pins);
  for (double d : distances)
    result.distances.push_back(std::ldexp(d, faces.exponent()));
  return result;
}

} // namespace internal
/// \endcond

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief returns the length of the shortest path on the surface from the nearest source to each vertex.
///
/// Straight lines that cross the same edges are followed together, from face to face, the nearest first. Paths bend at
/// vertices whose angles sum to more than 2π, and at the border. With a positive tolerance, bundles that meet at an
/// edge are merged if that changes no length by more than the tolerance. On a Delaunay triangulation there are then
/// about four to ten bundles for each face, and fewer the finer the faces are. Their number may grow quadratically with
/// the number of faces if the tolerance is zero, or if many thin faces meet.
///
/// Distances are zero only at the sources. They never exceed the shortest path along edges of the triangulation or of
/// its input and, for a surface in space, are never shorter than the straight line. They do not depend on other
/// components of the surface.
///
/// \param triangulation a triangulation, preferably Delaunay, so that paths cross few faces
/// \param sources vertices
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{tolerance}
///     \cgalParamDescription{how much the length of a path may be changed at each edge that it crosses, as a fraction
///       of the length of the edge. With 0, distances are exact up to rounding; a positive tolerance saves much time on
///       large surfaces}
///     \cgalParamType{`double`, at least 0 and less than 1}
///     \cgalParamDefault{0.001}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_number}
///     \cgalParamDescription{the maximum number of steps of bundles from one face to the next}
///     \cgalParamType{`std::uint64_t`}
///     \cgalParamDefault{a million, and 500 for each face}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{is called from time to time, and can cancel}
///     \cgalParamType{a model of `IntrinsicTriangulationVisitor`}
///     \cgalParamDefault{`Default_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \exception Invalid_argument_error if there is no such vertex, or the tolerance is out of range
/// \exception Cancelled_error if the visitor asks for it
///
/// Source: J. Chen, Y. Han, "Shortest paths on a polyhedron", 1996; V. Surazhsky et al., "Fast exact and approximate
/// geodesics on meshes", 2005; S. Xin, G. Wang, "Improving Chen and Han's algorithm on the discrete geodesic problem",
/// 2009.
template <class Traits, class NamedParameters = parameters::Default_named_parameters>
Geodesic_distances geodesic_distances(const Intrinsic_triangulation<Traits>& triangulation,
                                      const std::vector<Vertex_index>& sources,
                                      const NamedParameters& np = parameters::default_values())
{
  const internal::Row_of_vertex row(triangulation.connectivity());
  std::vector<std::uint32_t> rows;
  for (Vertex_index v : sources) {
    internal::require_vertex(v, row.number_of_rows());
    rows.push_back(std::uint32_t(v.idx()));
  }
  return internal::distances_by_windows(triangulation, row, rows, np);
}

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief as `geodesic_distances()` of a triangulation, for any triangles. The vertices are those of the input; merged
/// vertices have the same distance.
/// \param cover a cover
/// \param sources vertices of the input
/// \param np as above
/// \pre the cover was made Delaunay by `flip_to_Delaunay(cover.triangulation)`, or the faces are the given ones
template <class NamedParameters = parameters::Default_named_parameters>
Geodesic_distances geodesic_distances(const Tufted_cover& cover, const std::vector<Vertex_index>& sources,
                                      const NamedParameters& np = parameters::default_values())
{
  const internal::Row_of_cover_vertex row(cover);
  std::vector<std::uint32_t> rows;
  for (Vertex_index v : sources) {
    internal::require_vertex(v, row.number_of_rows());
    rows.push_back(cover.representative[v.idx()]);
  }
  Geodesic_distances result = internal::distances_by_windows(cover.triangulation, row, rows, np);
  for (std::size_t v = 0; v < cover.representative.size(); ++v)
    if (cover.representative[v] != v)
      result.distances[v] = result.distances[cover.representative[v]];
  return result;
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_GEODESIC_DISTANCES_H
