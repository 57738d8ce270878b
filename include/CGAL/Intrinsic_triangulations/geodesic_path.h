// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A locally shortest path between two vertices of a mesh, in one call.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_GEODESIC_PATH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_GEODESIC_PATH_H

#include <CGAL/Intrinsic_triangulations/Geodesic_path_network.h>
#include <CGAL/Intrinsic_triangulations/geodesic_points.h>
#include <CGAL/Intrinsic_triangulations/intrinsic_Delaunay_triangulation.h>
#include <CGAL/Intrinsic_triangulations/shortest_edge_path.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsGeodesics
/// \brief a path on the input.
struct Geodesic_path
{
  std::vector<Surface_point> points;            ///< what `geodesic_points()` returns, on the input
  std::vector<std::array<double, 3>> positions; ///< the same points in space, within a few units in the last place
  double initial_length = 0;                    ///< of the shortest path along edges
  double length = 0;                            ///< as of `Geodesic_path_network`
  bool is_geodesic = false;                     ///< whether it is locally shortest, by an exact decision
  Geodesic_report report;                       ///< what it took
};

/// \cond SKIP_IN_MANUAL
namespace internal {

template <class TriangleMesh>
Vertex_index index_of_vertex(const TriangleMesh& mesh, typename boost::graph_traits<TriangleMesh>::vertex_descriptor v)
{
  Vertex_index::size_type index = 0;
  for (auto w : vertices(mesh)) {
    if (w == v)
      break;
    ++index;
  }
  return Vertex_index(index); // one too many is refused by shortest_edge_path()
}

} // namespace internal
/// \endcond

/// \ingroup PkgIntrinsicTriangulationsGeodesics
/// \brief finds a locally shortest path between two vertices of a mesh.
///
/// It begins with the shortest path along edges. The result is a geodesic, and no longer than that path; it need not be the shortest of all.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param mesh the mesh. The i-th edge of its range is edge i in what is returned
/// \param source, target the ends of the path
/// \param np named parameters: `vertex_point_map` as of `intrinsic_triangulation()`, `visitor` and `maximum_number` as of
///   the function `shorten` of `Geodesic_path_network`
///
/// \exception Invalid_surface_error as `intrinsic_triangulation()`
/// \exception Invalid_point_error if no path along edges joins the two vertices
/// \exception Undecided_error, Cancelled_error as the function `shorten` of `Geodesic_path_network`
template <class TriangleMesh, class NamedParameters = parameters::Default_named_parameters>
Geodesic_path geodesic_path(const TriangleMesh& mesh, typename boost::graph_traits<TriangleMesh>::vertex_descriptor source,
                            typename boost::graph_traits<TriangleMesh>::vertex_descriptor target,
                            const NamedParameters& np = parameters::default_values())
{
  auto triangulation = intrinsic_triangulation(mesh, np);
  using Traits = typename decltype(triangulation)::Traits;
  const auto start = shortest_edge_path(triangulation, internal::index_of_vertex(mesh, source),
                                        internal::index_of_vertex(mesh, target));
  Geodesic_path_network<Traits> network(triangulation);
  const std::size_t p = network.add_path(start);
  Geodesic_path result;
  result.initial_length = network.length(p);
  result.report = network.shorten(np);
  result.length = network.length(p);
  result.is_geodesic = network.is_geodesic(p);
  result.points = geodesic_points(triangulation, network.halfedges(p));
  const auto point_map = parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                                      get_const_property_map(vertex_point, mesh));
  std::vector<std::array<double, 3>> points;
  points.reserve(num_vertices(mesh));
  for (auto v : vertices(mesh)) {
    const auto& p_v = get(point_map, v);
    points.push_back({CGAL::to_double(p_v.x()), CGAL::to_double(p_v.y()), CGAL::to_double(p_v.z())});
  }
  for (const Surface_point& q : result.points)
    result.positions.push_back(point_in_space(triangulation.exact_geometry().correspondence().input(), points, q));
  return result;
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_GEODESIC_PATH_H
