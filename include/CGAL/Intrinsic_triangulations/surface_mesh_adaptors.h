// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Intrinsic triangulations as CGAL::Surface_mesh, which is under the GPL; so is this header.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SURFACE_MESH_ADAPTORS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SURFACE_MESH_ADAPTORS_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/named_parameters.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/range/has_range_iterator.hpp>

#include <cstddef>
#include <iterator>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \cond SKIP_IN_MANUAL
namespace internal {

// Gives a mesh that has vertices alone the edges and faces of a complex or an overlay, by
// their links.
template <class Graph, class Mesh>
void copy_links(const Graph& graph, Mesh& mesh)
{
  using Vertex = typename Mesh::Vertex_index;
  using Halfedge = typename Mesh::Halfedge_index;
  using Face = typename Mesh::Face_index;
  const auto to_mesh = [](auto h) { return Halfedge(h.idx()); };
  for (std::size_t e = 0; e < graph.number_of_halfedges() / 2; ++e)
    mesh.add_edge();
  for (std::size_t f = 0; f < graph.number_of_faces(); ++f)
    mesh.add_face();
  for (auto h : graph.halfedges()) {
    mesh.set_next(to_mesh(h), to_mesh(graph.next(h)));
    mesh.set_target(to_mesh(h), Vertex(graph.target(h).idx()));
    if (!graph.is_border(h))
      mesh.set_face(to_mesh(h), Face(graph.face(h).idx()));
  }
  for (auto f : graph.faces())
    mesh.set_halfedge(Face(f.idx()), to_mesh(graph.halfedge(f)));
  for (auto v : graph.vertices())
    if (graph.halfedge(v).is_valid())
      mesh.set_halfedge(Vertex(v.idx()), to_mesh(graph.halfedge(v)));
}

inline void check_number_of_points(std::size_t number_of_points, std::size_t number_of_vertices)
{
  if (number_of_points != number_of_vertices)
    throw Invalid_surface_error(Invalid_surface_error::Defect::BAD_INDEX, number_of_points, 1,
                                "there are " + std::to_string(number_of_points) + " points for " +
                                  std::to_string(number_of_vertices) + " vertices");
}

// The points of the vertices of a mesh, in their order.
template <class TriangleMesh, class NamedParameters>
auto points_of(const TriangleMesh& mesh, const NamedParameters& np)
{
  const auto point_map =
    parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                 get_const_property_map(vertex_point, mesh));
  using Point = typename boost::property_traits<std::decay_t<decltype(point_map)>>::value_type;
  std::vector<Point> points;
  points.reserve(num_vertices(mesh));
  for (typename boost::graph_traits<TriangleMesh>::vertex_descriptor v : vertices(mesh))
    points.push_back(get(point_map, v));
  return points;
}

} // namespace internal
/// \endcond

/// \ingroup PkgIntrinsicTriangulationsAdaptors
/// \brief copies a complex into a `Surface_mesh`, with the same numbering of all elements.
///
/// Vertex, halfedge, edge and face i of the complex become number i of the mesh. The mesh is
/// built from halfedges, not from corners: `Surface_mesh::add_face(u, v, w)` would refuse
/// a loop, and would find an arbitrary edge between two vertices if there are several. So every
/// complex can be copied, and `mesh.is_valid()` holds. This is a design choice: an intrinsic
/// Delaunay triangulation of an ordinary mesh often has a few loops or parallel edges,
/// and a result without them, or no result, would be useless. Navigation, property maps,
/// connected components, circulators and shortest paths work with them.
///
/// \warning A function that looks edges up by their end vertices (`halfedge(u, v, mesh)`,
/// the writers of OFF and PLY, remeshing, Euler operations) is wrong on a mesh that is
/// not simplicial, and `is_valid_polygon_mesh()` rejects loops. Check
/// `is_simplicial(complex)` first.
///
/// \param complex the connectivity
/// \param points a point for each vertex, in the order of the vertices
/// \exception Invalid_surface_error if there are fewer or more points than vertices. O(size).
template <class PointRange,
          class = std::enable_if_t<boost::has_range_const_iterator<PointRange>::value>>
auto to_surface_mesh(const Delta_complex& complex, const PointRange& points)
{
  using Point = std::decay_t<decltype(*std::begin(points))>;
  CGAL::Surface_mesh<Point> mesh;
  mesh.reserve(complex.number_of_vertices(), complex.number_of_edges(), complex.number_of_faces());
  for (const Point& p : points)
    mesh.add_vertex(p);
  internal::check_number_of_points(mesh.number_of_vertices(), complex.number_of_vertices());
  internal::copy_links(complex, mesh);
  return mesh;
}

/// \ingroup PkgIntrinsicTriangulationsAdaptors
/// \brief copies an intrinsic triangulation into a `Surface_mesh` with its metric.
///
/// It works like the function for the connectivity alone. In addition the mesh has the property maps
/// `"e:squared_length"`, `"e:length"` and `"f:area"` with value type `Traits::FT`. These
/// are intrinsic: a flipped edge is longer than the straight segment in space
/// between its end points. The given points serve only for display and data.
///
/// \param triangulation the triangulation
/// \param points a point for each vertex, in the order of the vertices
/// \exception Invalid_surface_error if there are fewer or more points than vertices. O(size).
template <class Traits, class PointRange,
          class = std::enable_if_t<boost::has_range_const_iterator<PointRange>::value>>
auto to_surface_mesh(const Intrinsic_triangulation<Traits>& triangulation, const PointRange& points)
{
  using FT = typename Traits::FT;
  auto mesh = to_surface_mesh(triangulation.connectivity(), points);
  using Mesh = decltype(mesh);
  using Edge = typename Mesh::Edge_index;
  using Face = typename Mesh::Face_index;
  auto squared_length = mesh.template add_property_map<Edge, FT>("e:squared_length").first;
  auto length = mesh.template add_property_map<Edge, FT>("e:length").first;
  auto area = mesh.template add_property_map<Face, FT>("f:area").first;
  for (Edge_index e : triangulation.connectivity().edges()) {
    squared_length[Edge(e.idx())] = triangulation.squared_length(e);
    length[Edge(e.idx())] = triangulation.length(e);
  }
  for (Face_index f : triangulation.connectivity().faces())
    area[Face(f.idx())] = triangulation.area(f);
  return mesh;
}

/// \ingroup PkgIntrinsicTriangulationsAdaptors
/// \brief copies an intrinsic triangulation into a `Surface_mesh` with its metric and the
/// points of the mesh that it came from.
///
/// \tparam TriangleMesh a model of `VertexListGraph`; not a range itself
/// \param triangulation the triangulation
/// \param mesh the input, whose i-th vertex is vertex i of the triangulation
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the points of the vertices of `mesh`}
///     \cgalParamType{a model of `ReadablePropertyMap`}
///     \cgalParamDefault{`get_const_property_map(CGAL::vertex_point, mesh)`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \exception Invalid_surface_error if the numbers of vertices differ. O(size).
template <class Traits, class TriangleMesh, class NamedParameters = parameters::Default_named_parameters,
          class = std::enable_if_t<!boost::has_range_const_iterator<TriangleMesh>::value>>
auto to_surface_mesh(const Intrinsic_triangulation<Traits>& triangulation, const TriangleMesh& mesh,
                     const NamedParameters& np = parameters::default_values())
{
  return to_surface_mesh(triangulation, internal::points_of(mesh, np));
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SURFACE_MESH_ADAPTORS_H
