// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An intrinsic triangulation is a graph of Boost and CGAL: shortest paths along its edges with the
// property map of lengths, connected components, and the other maps.

#include <CGAL/Intrinsic_triangulations/graph_traits_Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/intrinsic_Delaunay_triangulation.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

// The distance of each vertex from one of them, along edges. The weights are those of get(boost::edge_weight, graph):
// for the graphs of CGAL, the lengths.
template <class Graph>
std::vector<double> distances(const Graph& graph, std::size_t from)
{
  std::vector<double> result(num_vertices(graph));
  boost::dijkstra_shortest_paths(
    graph, vertices(graph).begin()[std::ptrdiff_t(from)],
    boost::distance_map(boost::make_iterator_property_map(result.begin(), get(boost::vertex_index, graph))));
  return result;
}

int main()
{
  // A flat parallelogram, cut into triangles by the long diagonals of its cells.
  constexpr std::uint32_t n = 20;
  Mesh mesh;
  for (std::uint32_t y = 0; y <= n; ++y)
    for (std::uint32_t x = 0; x <= n; ++x)
      mesh.add_vertex(Point(x + 3. * y, y, 0));
  for (std::uint32_t y = 0; y < n; ++y)
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t i = y * (n + 1) + x, above = i + n + 1;
      mesh.add_face(Mesh::Vertex_index(i), Mesh::Vertex_index(i + 1), Mesh::Vertex_index(above + 1));
      mesh.add_face(Mesh::Vertex_index(i), Mesh::Vertex_index(above + 1), Mesh::Vertex_index(above));
    }

  const auto idt = IT::intrinsic_Delaunay_triangulation(mesh).triangulation;
  const Mesh::Vertex_index middle(num_vertices(mesh) / 2);
  const std::vector<double> on_input = distances(mesh, middle), on_intrinsic = distances(idt, middle);

  // In a convex domain of the plane, paths in a Delaunay triangulation are less than 1.998 times as long
  // as straight lines (Xia 2013).
  double input_stretch = 1, intrinsic_stretch = 1;
  for (const Mesh::Vertex_index v : mesh.vertices())
    if (v != middle) {
      const double straight = std::sqrt(CGAL::squared_distance(mesh.point(middle), mesh.point(v)));
      input_stretch = std::max(input_stretch, on_input[v] / straight);
      intrinsic_stretch = std::max(intrinsic_stretch, on_intrinsic[v] / straight);
    }
  std::cout << "paths are at most " << input_stretch << " times as long as straight lines along input edges, "
            << intrinsic_stretch << " times along intrinsic edges\n";

  // The other maps: weights of the Laplace-Beltrami operator, and the number of input edges that an edge crosses.
  const auto weight = get(IT::edge_cotangent_weight, idt);
  const auto crossings = get(IT::edge_normal_coordinate, idt);
  double smallest_weight = 1;
  std::int64_t most_crossings = 0;
  for (const auto e : edges(idt)) {
    if (!CGAL::is_border(e, idt))
      smallest_weight = std::min(smallest_weight, get(weight, e));
    most_crossings = std::max(most_crossings, get(crossings, e));
  }
  std::cout << "smallest weight of an interior edge: " << smallest_weight
            << ", most crossings of an edge: " << most_crossings << '\n';

  auto component = get(CGAL::dynamic_face_property_t<std::size_t>(), idt);
  const std::size_t components = CGAL::Polygon_mesh_processing::connected_components(idt, component);
  std::cout << components << " connected component\n";

  const bool is_fine =
    intrinsic_stretch < 1.998 && input_stretch > 6 && smallest_weight >= 0 && most_crossings > 1 && components == 1;
  return is_fine ? EXIT_SUCCESS : EXIT_FAILURE;
}
