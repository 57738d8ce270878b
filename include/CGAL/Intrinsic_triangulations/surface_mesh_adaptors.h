// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// From and to CGAL::Surface_mesh: triangulations, and overlays of triangulation and input.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SURFACE_MESH_ADAPTORS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SURFACE_MESH_ADAPTORS_H

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/straight_mesh.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/internal/overlay/Carried_properties.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/convex_polygon_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/positions/overlay_layers.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/range/has_range_iterator.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Gives a mesh that has only vertices the edges and faces of a complex or an overlay, with their links.
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
  const auto point_map = parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                                      get_const_property_map(vertex_point, mesh));
  using Point = typename boost::property_traits<std::decay_t<decltype(point_map)>>::value_type;
  std::vector<Point> points;
  points.reserve(num_vertices(mesh));
  for (typename boost::graph_traits<TriangleMesh>::vertex_descriptor v : vertices(mesh))
    points.push_back(get(point_map, v));
  return points;
}

} // namespace internal

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
template <class PointRange, class = std::enable_if_t<boost::has_range_const_iterator<PointRange>::value>>
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
template <class Traits, class PointRange, class = std::enable_if_t<boost::has_range_const_iterator<PointRange>::value>>
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

/// \ingroup PkgIntrinsicTriangulationsAdaptors
/// \brief copies straight triangles into a `Surface_mesh`.
///
/// Vertex and face i are point and triangle i. The property maps `"f:input_face"` and `"f:region"` have the value type
/// `std::uint32_t`, and so has `"e:line"`: the number of the line of a marked edge, and `number_of_lines` for all
/// others.
///
/// \tparam Point the type of the points
/// \param straight the triangles
/// \exception Invalid_surface_error if they are no manifold. O(size).
template <class Point>
CGAL::Surface_mesh<Point> to_surface_mesh(const Straight_mesh& straight)
{
  using Mesh = CGAL::Surface_mesh<Point>;
  std::vector<Point> points;
  for (const auto& [x, y, z] : straight.points)
    points.emplace_back(x, y, z);
  Mesh mesh = to_surface_mesh(make_Delta_complex_from_triangles(points.size(), straight.triangles), points);
  using Edge = typename Mesh::Edge_index;
  using Face = typename Mesh::Face_index;
  using Vertex = typename Mesh::Vertex_index;
  auto input_face = mesh.template add_property_map<Face, std::uint32_t>("f:input_face").first;
  auto region = mesh.template add_property_map<Face, std::uint32_t>("f:region").first;
  auto line = mesh.template add_property_map<Edge, std::uint32_t>("e:line", straight.number_of_lines).first;
  for (std::uint32_t f = 0; f < straight.triangles.size(); ++f) {
    input_face[Face(f)] = straight.input_faces[f].idx();
    region[Face(f)] = straight.regions[f];
  }
  for (std::size_t i = 0; i < straight.marked_edges.size(); ++i) {
    const auto [a, b] = straight.marked_edges[i];
    line[mesh.edge(mesh.halfedge(Vertex(a), Vertex(b)))] = straight.lines[i];
  }
  return mesh;
}

/// \ingroup PkgIntrinsicTriangulationsAdaptors
/// \brief the label of an edge that is in neither triangulation: a diagonal of a face of the
/// overlay, inserted by `triangulate_overlay_faces()`.
constexpr std::uint8_t diagonal_label = 3;

/// \ingroup PkgIntrinsicTriangulationsAdaptors
/// \brief copies an overlay into a `Surface_mesh` whose faces are convex polygons in space.
///
/// Vertex, halfedge, segment and face i of the overlay become vertex, halfedge, edge and face i
/// of the mesh. Vertices of the surface keep their points; crossings lie on the input edges.
/// The mesh has loops or multiple edges only where the input has them. Its property maps:
///
/// | name | value type | |
/// | --- | --- | --- |
/// | `"v:kind"` | `std::uint8_t` | 0 for a vertex of the input, 1 for a crossing, 2 for an inserted vertex |
/// | `"e:label"` | `std::uint8_t` | a `Segment_label`: 0 for o, 1 for c, 2 for oc |
/// | `"f:input_face"` | `std::uint32_t` | the input face that contains the face |
/// | `"f:intrinsic_face"` | `std::uint32_t` | the intrinsic face that contains it |
/// | `"h:input_point"` | `Surface_point` | the corner of the face of h at its target, in the input face |
/// | `"h:intrinsic_point"` | `Surface_point` | the same corner in the intrinsic face |
///
/// A corner lies on the edge of the halfedge of its `Surface_point`, so its third
/// barycentric coordinate is 0. Border halfedges have no corner: their points have the null
/// halfedge. `CGAL::IO::write_PLY()` writes the property maps of numbers with the mesh.
/// `add_property_map<Face_index, std::uint32_t>("f:input_face").first` returns the map that is there already,
/// with CGAL 5 and 6 alike.
///
/// \param subdivision the common subdivision
/// \param points a point for each vertex of the surface, in their order
/// \exception Invalid_surface_error if there are fewer or more points than vertices. O(size).
template <class PointRange, class = std::enable_if_t<boost::has_range_const_iterator<PointRange>::value>>
auto overlay_to_surface_mesh(const Common_subdivision& subdivision, const PointRange& points)
{
  const Overlay& overlay = subdivision.overlay();
  using Point = std::decay_t<decltype(*std::begin(points))>;
  using Mesh = CGAL::Surface_mesh<Point>;
  using Vertex = typename Mesh::Vertex_index;
  using Edge = typename Mesh::Edge_index;
  using Face = typename Mesh::Face_index;
  const std::vector<Point> original_points(std::begin(points), std::end(points));
  internal::check_number_of_points(original_points.size(), overlay.number_of_input_vertices());

  Mesh mesh;
  mesh.reserve(overlay.number_of_vertices(), overlay.number_of_segments(), overlay.number_of_faces());
  for (const Point& p : original_points)
    mesh.add_vertex(p);
  for (Overlay::Vertex x : overlay.vertices()) {
    if (x.idx() < overlay.number_of_input_vertices())
      continue;
    const auto [a, b, c] = subdivision.point(x, original_points);
    mesh.add_vertex(Point{a, b, c});
  }
  internal::copy_links(overlay, mesh);

  auto kind = mesh.template add_property_map<Vertex, std::uint8_t>("v:kind", 0).first;
  for (Overlay::Vertex x : overlay.crossings())
    kind[Vertex(x.idx())] = 1;
  for (std::uint32_t i = overlay.number_of_input_vertices(); i < overlay.number_of_original_vertices(); ++i)
    kind[Vertex(i)] = 2;
  auto label = mesh.template add_property_map<Edge, std::uint8_t>("e:label").first;
  for (Overlay::Segment s : overlay.segments())
    label[Edge(s.idx())] = std::uint8_t(overlay.label(s));
  auto input_face = mesh.template add_property_map<Face, std::uint32_t>("f:input_face").first;
  auto intrinsic_face = mesh.template add_property_map<Face, std::uint32_t>("f:intrinsic_face").first;
  for (Overlay::Face f : overlay.faces()) {
    input_face[Face(f.idx())] = overlay.input_face(f).idx();
    intrinsic_face[Face(f.idx())] = overlay.intrinsic_face(f).idx();
  }

  using Halfedge = typename Mesh::Halfedge_index;
  const Surface_point none{Halfedge_index(), {0, 0, 0}};
  auto input_point = mesh.template add_property_map<Halfedge, Surface_point>("h:input_point", none).first;
  auto intrinsic_point = mesh.template add_property_map<Halfedge, Surface_point>("h:intrinsic_point", none).first;
  const internal::Input_layer input_layer(subdivision);
  const internal::Intrinsic_layer intrinsic_layer(subdivision);
  for (Overlay::Halfedge h : overlay.halfedges())
    if (!overlay.is_border(h)) {
      input_point[Halfedge(h.idx())] = internal::corner(input_layer, h);
      intrinsic_point[Halfedge(h.idx())] = internal::corner(intrinsic_layer, h);
    }
  return mesh;
}

/// \ingroup PkgIntrinsicTriangulationsAdaptors
/// \brief as above, with the points of a mesh.
///
/// \tparam TriangleMesh a model of `VertexListGraph`
/// \tparam NamedParameters a sequence of named parameters
/// \param subdivision the common subdivision
/// \param mesh the input, or another mesh with as many vertices
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
template <class TriangleMesh, class NamedParameters = parameters::Default_named_parameters,
          class = std::enable_if_t<!boost::has_range_const_iterator<TriangleMesh>::value>>
auto overlay_to_surface_mesh(const Common_subdivision& subdivision, const TriangleMesh& mesh,
                             const NamedParameters& np = parameters::default_values())
{
  return overlay_to_surface_mesh(subdivision, internal::points_of(mesh, np));
}

/// \ingroup PkgIntrinsicTriangulationsAdaptors
/// \brief splits the faces of an overlay mesh into triangles.
///
/// The triangulation of a face is the one whose smallest triangle in space is largest. So a triangle of zero area
/// arises only if it is unavoidable. New edges have the label `diagonal_label`. New faces and corners have all
/// properties of those that were split, including your own, such as texture coordinates in a map `"h:uv"`; all other
/// properties of new edges have their default values. O(size).
///
/// \tparam Value the value types of your property maps of halfedges and faces, unless they are numbers,
///   `bool`, `std::string`, points and vectors of CGAL, `CGAL::IO::Color`, indices of CGAL, `Surface_point`, or
///   `std::array`s of two to four floats, doubles or 32-bit integers, all of which are known
/// \param mesh what `overlay_to_surface_mesh()` returns
///
/// \exception std::invalid_argument if there is a property map of halfedges or faces with another value type; the
///   message names it, and the mesh is unchanged
template <class... Value, class Point>
void triangulate_overlay_faces(CGAL::Surface_mesh<Point>& mesh)
{
  using Mesh = CGAL::Surface_mesh<Point>;
  using Halfedge = typename Mesh::Halfedge_index;
  using Edge = typename Mesh::Edge_index;
  using Face = typename Mesh::Face_index;
  auto label = internal::find_property_map<Edge, std::uint8_t>(mesh, "e:label");
  CGAL_precondition_msg(label, "not an overlay mesh");
  const internal::Carried_properties<Mesh, Halfedge, Value...> corner_properties(mesh, "halfedges");
  const internal::Carried_properties<Mesh, Face, Value...> face_properties(mesh, "faces");

  std::vector<Halfedge> sides; // of a face
  std::vector<std::array<double, 3>> corners;
  const std::size_t number_of_faces = mesh.number_of_faces();
  for (std::size_t i = 0; i < number_of_faces; ++i) {
    sides.clear();
    corners.clear();
    const Face f(static_cast<typename Mesh::size_type>(i));
    for (Halfedge h : halfedges_around_face(mesh.halfedge(f), mesh)) {
      const Point& p = mesh.point(mesh.target(h));
      sides.push_back(h);
      corners.push_back({CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2])});
    }
    internal::for_each_diagonal(corners, [&](std::size_t a, std::size_t b) {
      // Cuts off the corners from a to b. Uses only links, because edges may be loops.
      const Halfedge at_a = mesh.prev(sides[a + 1]), at_b = sides[b];
      CGAL::Euler::split_face(at_a, at_b, mesh);
      const Halfedge to_a = mesh.prev(sides[a + 1]), to_b = mesh.opposite(to_a);
      label[mesh.edge(to_a)] = diagonal_label;
      corner_properties.copy(at_a, to_a);
      corner_properties.copy(at_b, to_b);
      for (Halfedge h : {to_a, to_b})
        face_properties.copy(f, mesh.face(h));
    });
  }
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SURFACE_MESH_ADAPTORS_H
