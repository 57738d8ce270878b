// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Geodesic paths between points of the surface, and shortest paths along edges, from which they start.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_GEODESIC_PATH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_GEODESIC_PATH_H

#include <CGAL/Intrinsic_triangulations/Geodesic_path_network.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/insert_vertex.h>
#include <CGAL/Intrinsic_triangulations/internal/numbers/Accurate_shapes.h>
#include <CGAL/Intrinsic_triangulations/intrinsic_Delaunay_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/trace_geodesic.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <queue>
#include <string>
#include <tuple>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsGeodesics
/// \brief finds a shortest path from `source` to `target` along the edges of a triangulation, by the algorithm A*: as
/// Dijkstra's, but vertices that are farther from the target in space come later.
///
/// \param triangulation the triangulation
/// \param source, target vertices
/// \return its halfedges, in order; none if both vertices are the same. Lengths are rounded, so any of several paths of
///   nearly the same length may be returned
/// \exception Invalid_argument_error if there is no such vertex, or no path
///
/// O(n log n) for the n edges that are nearer to the source than the target is. If the input has points, edges from
/// which the straight line to the target is too long are skipped.
template <class Traits>
std::vector<Halfedge_index> shortest_edge_path(const Intrinsic_triangulation<Traits>& triangulation,
                                               Vertex_index source, Vertex_index target)
{
  const Delta_complex& complex = triangulation.connectivity();
  for (Vertex_index v : {source, target})
    internal::require_vertex(v, complex.number_of_vertices());
  const internal::Accurate_shapes<Traits> shapes(triangulation);
  // If the input has points, the straight-line distance to the target prunes the search.
  std::function<double(Vertex_index)> distance_in_space = [](Vertex_index) { return 0.; };
  if (triangulation.keeps_input() && !internal::engine(triangulation).metric().points().empty()) {
    const internal::Correspondence& correspondence = internal::engine(triangulation).correspondence();
    const internal::Points& points = internal::engine(triangulation).metric().points();
    const auto position = [&correspondence, &points](Vertex_index v) {
      if (!correspondence.is_inserted(v))
        return points[v.idx()];
      const auto& [h, coordinates] = correspondence.location(v);
      return point_in_space(correspondence.input(), points, {h, internal::with_sum_one(coordinates)});
    };
    distance_in_space = [position, end = position(target),
                         unit = triangulation.unit_exponent() - shapes.exponent()](Vertex_index v) {
      const auto [x, y, z] = position(v);
      return std::ldexp(std::hypot(x - end[0], y - end[1], z - end[2]), unit);
    };
  }
  // A lower bound on the total length, the length so far, and the vertex.
  using Entry = std::tuple<double, double, Vertex_index::size_type>;
  std::vector<double> distance(complex.number_of_vertices(), std::numeric_limits<double>::infinity());
  std::vector<Halfedge_index> arrival(complex.number_of_vertices());
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  distance[source.idx()] = 0;
  queue.push({0, 0, source.idx()});
  while (!queue.empty()) {
    const auto [estimate, d, number] = queue.top();
    queue.pop();
    if (number == target.idx())
      break;
    if (d > distance[number])
      continue;
    for (Halfedge_index h : internal::Halfedges_around(complex, Vertex_index(number))) {
      const Halfedge_index out = complex.opposite(h);
      const auto next = complex.target(out).idx();
      // Some lengths take long.
      const double through = d < distance[next] ? d + shapes.length(complex.edge(h)) : d;
      if (through < distance[next]) {
        distance[next] = through;
        arrival[next] = out;
        queue.push({through + distance_in_space(complex.target(out)), through, next});
      }
    }
  }
  std::vector<Halfedge_index> path;
  for (Vertex_index v = target; v != source; v = complex.source(path.back())) {
    if (!arrival[v.idx()].is_valid())
      throw Invalid_argument_error("no path along edges leads from vertex " + std::to_string(source.idx()) +
                                   " to vertex " + std::to_string(target.idx()) + ": choose two of the same component");
    path.push_back(arrival[v.idx()]);
  }
  std::reverse(path.begin(), path.end());
  return path;
}

/// \ingroup PkgIntrinsicTriangulationsGeodesics
/// \brief a path on the input.
struct Geodesic_path
{
  std::vector<Surface_point> points;            ///< what `geodesic_points()` returns, on the input
  std::vector<std::array<double, 3>> positions; ///< the same points in space, within a few units in the last place
  double initial_length = 0;                    ///< the length of the shortest path along edges
  double length = 0;                            ///< its length, as by `Geodesic_path_network`
  bool is_geodesic = false;                     ///< whether it is locally shortest, by an exact decision
  Geodesic_report report;                       ///< the report of the shortening
};

namespace internal {

template <class TriangleMesh>
Vertex_index index_of_vertex(const TriangleMesh& mesh, typename boost::graph_traits<TriangleMesh>::vertex_descriptor v)
{
  const auto all = vertices(mesh);
  const auto before = std::distance(all.begin(), std::find(all.begin(), all.end(), v));
  return Vertex_index(Vertex_index::size_type(before)); // shortest_edge_path() refuses one too many
}

// A point on an edge relative to the same halfedge, whichever face it was given in.
inline Surface_point seen_from_one_side(const Delta_complex& input, const Surface_point& point)
{
  if (point.dimension() != 1)
    return point;
  Halfedge_index along = input.halfedge(input.edge(side_of(input, point)));
  if (input.is_border(along))
    along = input.opposite(along);
  const auto [a, b] = coordinates_on_edge(input, point, along);
  return {along, {a, b, 0}};
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsGeodesics
/// \brief returns the vertex at a point of the input, and inserts one if there is none.
///
/// It flips no edge. So several points can be inserted one after the other, also on the same edge, before other flips.
///
/// \param triangulation a triangulation that has all edges of its input, divided by inserted vertices
/// \param point a point of the input, as `locate()` finds it
/// \exception Invalid_point_error if the point does not lie on the surface. \exception Undecided_error as
///   `insert_vertex()`
template <class Traits>
Vertex_index vertex_at_point(Intrinsic_triangulation<Traits>& triangulation, const Surface_point& point)
{
  const internal::Correspondence& correspondence = internal::engine(triangulation).correspondence();
  const Delta_complex& input = correspondence.input();
  const Halfedge_index h = point.halfedge;
  if (h.is_valid() && h.idx() < input.number_of_halfedges() && !input.is_border(h)) {
    const auto& [a, b, c] = point.coordinates;
    if (a > 0 && b == 0 && c == 0)
      return input.source(h);
    if (a == 0 && b > 0 && c == 0)
      return input.target(h);
    if (a == 0 && b == 0 && c > 0)
      return input.target(input.next(h));
  }
  internal::check_new_vertex(input, point);
  const Surface_point p = internal::seen_from_one_side(input, point);
  for (auto v = input.number_of_vertices(); v < triangulation.connectivity().number_of_vertices(); ++v) {
    const Surface_point q = internal::seen_from_one_side(input, correspondence.location(Vertex_index(v)));
    if (input.face(p.halfedge) == input.face(q.halfedge) && internal::are_same_points(input, p, q))
      return Vertex_index(v);
  }
  return insert_vertex(triangulation, p,
                       parameters::edge_is_constrained_map(Static_boolean_property_map<Edge_index, true>()));
}

namespace internal {

// In a triangulation of the mesh that has both vertices.
template <class TriangleMesh, class Traits, class NamedParameters>
Geodesic_path shortened_edge_path(const TriangleMesh& mesh, Intrinsic_triangulation<Traits>& triangulation,
                                  Vertex_index source, Vertex_index target, const NamedParameters& np)
{
  const auto start = shortest_edge_path(triangulation, source, target);
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
    result.positions.push_back(point_in_space(triangulation.input(), points, q));
  return result;
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsGeodesics
/// \brief finds a locally shortest path between two vertices of a mesh.
///
/// It begins with the shortest path along edges. The result is a geodesic, and no longer than that path; it need not be
/// the shortest of all.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param mesh the mesh. The i-th edge of its range is edge i of the result
/// \param source, target the ends of the path
/// \param np named parameters: `vertex_point_map` as for `intrinsic_triangulation()`, `visitor` and `maximum_number` as
///   for the function `shorten` of `Geodesic_path_network`
///
/// \exception Invalid_surface_error as `intrinsic_triangulation()`
/// \exception Invalid_argument_error if no path along edges joins the two vertices
/// \exception Undecided_error, Cancelled_error as the function `shorten` of `Geodesic_path_network`
template <class TriangleMesh, class NamedParameters = parameters::Default_named_parameters>
Geodesic_path geodesic_path(const TriangleMesh& mesh,
                            typename boost::graph_traits<TriangleMesh>::vertex_descriptor source,
                            typename boost::graph_traits<TriangleMesh>::vertex_descriptor target,
                            const NamedParameters& np = parameters::default_values())
{
  auto triangulation = intrinsic_triangulation(mesh, np);
  return internal::shortened_edge_path(mesh, triangulation, internal::index_of_vertex(mesh, source),
                                       internal::index_of_vertex(mesh, target), np);
}

/// \ingroup PkgIntrinsicTriangulationsGeodesics
/// \brief finds a locally shortest path between two points of a mesh, which may be vertices or lie on edges or inside
/// faces.
///
/// Points that are not vertices are inserted as vertices, without rounding; then this is `geodesic_path()` between
/// vertices.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param mesh the mesh. Its i-th edge and its i-th vertex have the number i in `source` and `target`
/// \param source, target the ends of the path, in faces of `make_Delta_complex(mesh)`
/// \param np as for vertices
///
/// \return the path; it has no points if both ends are the same
/// \exception Invalid_surface_error as `intrinsic_triangulation()`
/// \exception Invalid_point_error if a point does not lie on the mesh
/// \exception Invalid_argument_error if no path along edges joins the two
/// \exception Undecided_error, Cancelled_error as the function `shorten` of `Geodesic_path_network`
template <class TriangleMesh, class NamedParameters = parameters::Default_named_parameters>
Geodesic_path geodesic_path(const TriangleMesh& mesh, const Surface_point& source, const Surface_point& target,
                            const NamedParameters& np = parameters::default_values())
{
  auto triangulation = intrinsic_triangulation(mesh, np);
  const Vertex_index s = vertex_at_point(triangulation, source);
  const Vertex_index t = vertex_at_point(triangulation, target);
  return internal::shortened_edge_path(mesh, triangulation, s, t, np);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_GEODESIC_PATH_H
