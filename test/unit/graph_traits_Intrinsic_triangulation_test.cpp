// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Intrinsic_triangulation as a graph: concepts, property maps, and generic algorithms on it.

#include <CGAL/Intrinsic_triangulations/graph_traits_Intrinsic_triangulation.h>

#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/intrinsic_Delaunay_triangulation.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/boost/graph/graph_concepts.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/graph_concepts.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Delta_complex;
using IT::Edge_index;
using IT::Face_index;
using IT::Halfedge_index;
using IT::Oriented_edge;
using IT::Vertex_index;
using Traits = IT::Filtered_edge_length_traits;
using Triangulation = IT::Intrinsic_triangulation<Traits>;

template <class Graph>
struct Check_concepts
{
  BOOST_CONCEPT_ASSERT((boost::GraphConcept<Graph>));
  BOOST_CONCEPT_ASSERT((boost::IncidenceGraphConcept<Graph>));
  BOOST_CONCEPT_ASSERT((boost::BidirectionalGraphConcept<Graph>));
  BOOST_CONCEPT_ASSERT((boost::AdjacencyGraphConcept<Graph>));
  BOOST_CONCEPT_ASSERT((boost::VertexListGraphConcept<Graph>));
  BOOST_CONCEPT_ASSERT((boost::EdgeListGraphConcept<Graph>));
  BOOST_CONCEPT_ASSERT((boost::VertexAndEdgeListGraphConcept<Graph>));
  BOOST_CONCEPT_ASSERT((CGAL::HalfedgeGraphConcept<Graph>));
  BOOST_CONCEPT_ASSERT((CGAL::HalfedgeListGraphConcept<Graph>));
  BOOST_CONCEPT_ASSERT((CGAL::FaceGraphConcept<Graph>));
  BOOST_CONCEPT_ASSERT((CGAL::FaceListGraphConcept<Graph>));
  BOOST_CONCEPT_ASSERT((boost::ReadablePropertyGraphConcept<Graph, Vertex_index, boost::vertex_index_t>));
  BOOST_CONCEPT_ASSERT((boost::ReadablePropertyGraphConcept<Graph, Halfedge_index, boost::halfedge_index_t>));
  BOOST_CONCEPT_ASSERT((boost::ReadablePropertyGraphConcept<Graph, Face_index, boost::face_index_t>));
  BOOST_CONCEPT_ASSERT((boost::ReadablePropertyGraphConcept<Graph, Oriented_edge, boost::edge_index_t>));
  BOOST_CONCEPT_ASSERT((boost::ReadablePropertyGraphConcept<Graph, Oriented_edge, boost::edge_weight_t>));
  BOOST_CONCEPT_ASSERT((boost::ReadablePropertyGraphConcept<Graph, Oriented_edge, IT::Edge_cotangent_weight_tag>));
  BOOST_CONCEPT_ASSERT((boost::ReadablePropertyGraphConcept<Graph, Edge_index, IT::Edge_normal_coordinate_tag>));
  static_assert(CGAL::graph_has_property<Graph, boost::face_index_t>::value, "");
  static_assert(CGAL::graph_has_property<Graph, boost::edge_weight_t>::value, "");
  static_assert(!CGAL::graph_has_property<Graph, boost::vertex_point_t>::value, "edges are no straight lines in space");
};
template struct Check_concepts<Triangulation>;
template struct Check_concepts<IT::Intrinsic_triangulation<IT::Edge_length_traits<float>>>;

namespace {

// Two sheets of 2 x n squares, cut by long diagonals and sheared, so that many edges are flipped.
Triangulation two_sheared_sheets()
{
  constexpr int n = 8;
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<int, 3>> triangles;
  for (int sheet = 0; sheet < 2; ++sheet)
    for (int y = 0; y <= n; ++y)
      for (int x = 0; x < 3; ++x)
        points.push_back({x + 1.75 * y, double(y), (x == 1 ? 0.5 : 0.) + 10 * sheet});
  for (int sheet = 0; sheet < 2; ++sheet)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < 2; ++x) {
        const int i = sheet * 3 * (n + 1) + 3 * y + x;
        triangles.push_back({i, i + 1, i + 4});
        triangles.push_back({i, i + 4, i + 3});
      }
  return Triangulation(IT::make_Delta_complex_from_triangles(std::uint32_t(points.size()), triangles), points);
}

Triangulation flat_pillow()
{
  using Side_pairs = std::vector<std::array<int, 2>>;
  return Triangulation::from_lengths(IT::make_Delta_complex_from_gluing(2, Side_pairs{{0, 3}, {1, 5}, {2, 4}}),
                                     {3, 4, 5});
}

// By plain relaxation over the halfedges.
std::vector<double> distances_by_relaxation(const Triangulation& t, Vertex_index from)
{
  const Delta_complex& c = t.connectivity();
  std::vector<double> distance(c.number_of_vertices(), std::numeric_limits<double>::infinity());
  distance[from.idx()] = 0;
  for (std::size_t round = 0; round < distance.size(); ++round)
    for (Halfedge_index h : c.halfedges())
      distance[c.target(h).idx()] =
        std::min(distance[c.target(h).idx()], distance[c.source(h).idx()] + t.length(c.edge(h)));
  return distance;
}

template <class Graph>
std::vector<double> distances_by_dijkstra(const Graph& g, Vertex_index from)
{
  std::vector<double> distance(num_vertices(g));
  boost::dijkstra_shortest_paths( // weights are those of get(boost::edge_weight, g)
    g, from,
    boost::distance_map(boost::make_iterator_property_map(distance.begin(), get(boost::vertex_index, g)))
      .distance_inf(std::numeric_limits<double>::infinity()));
  return distance;
}

} // namespace

TEST(Graph_traits_Intrinsic_triangulation, functions_are_those_of_the_connectivity)
{
  Triangulation t = two_sheared_sheets();
  ASSERT_GT(IT::flip_to_Delaunay(t).flips, 0u);
  const Delta_complex& c = t.connectivity();
  EXPECT_EQ(num_vertices(t), num_vertices(c));
  EXPECT_EQ(num_halfedges(t), num_halfedges(c));
  EXPECT_EQ(num_edges(t), num_edges(c));
  EXPECT_EQ(num_faces(t), num_faces(c));
  EXPECT_TRUE(std::equal(edges(t).begin(), edges(t).end(), edges(c).begin(), edges(c).end()));
  for (Halfedge_index h : halfedges(t)) {
    EXPECT_EQ(next(h, t), c.next(h));
    EXPECT_EQ(prev(h, t), c.prev(h));
    EXPECT_EQ(opposite(h, t), c.opposite(h));
    EXPECT_EQ(source(h, t), c.source(h));
    EXPECT_EQ(target(h, t), c.target(h));
    EXPECT_EQ(face(h, t), c.face(h));
    EXPECT_EQ(edge(h, t), c.edge(h));
    EXPECT_EQ(halfedge(edge(h, t), t), h);
    EXPECT_EQ(source(halfedge(source(h, t), target(h, t), t).first, t), c.source(h));
    EXPECT_EQ(target(edge(source(h, t), target(h, t), t).first, t), c.target(h));
  }
  for (Face_index f : faces(t)) {
    EXPECT_EQ(halfedge(f, t), c.halfedge(f));
    EXPECT_EQ(degree(f, t), 3u);
    for (Halfedge_index h : CGAL::halfedges_around_face(halfedge(f, t), t))
      EXPECT_EQ(face(h, t), f);
  }
  for (Vertex_index v : vertices(t)) {
    EXPECT_EQ(halfedge(v, t), c.halfedge(v));
    EXPECT_EQ(degree(v, t), degree(v, c));
    EXPECT_EQ(out_degree(v, t), std::size_t(std::distance(out_edges(v, t).first, out_edges(v, t).second)));
    EXPECT_EQ(in_degree(v, t), std::size_t(std::distance(in_edges(v, t).first, in_edges(v, t).second)));
    for (Vertex_index u : CGAL::make_range(adjacent_vertices(v, t)))
      EXPECT_TRUE(edge(u, v, t).second);
  }
}

TEST(Graph_traits_Intrinsic_triangulation, maps_follow_the_flips)
{
  Triangulation t = two_sheared_sheets();
  const auto length = get(boost::edge_weight, t);
  const auto weight = get(IT::edge_cotangent_weight, t);
  const auto crossings = get(IT::edge_normal_coordinate, t);
  static_assert(std::is_same<decltype(crossings)::value_type, std::int64_t>::value, "");
  for (Edge_index e : t.connectivity().edges())
    EXPECT_EQ(get(crossings, e), -1);
  ASSERT_GT(IT::flip_to_Delaunay(t).flips, 0u);
  std::int64_t most = 0;
  for (Oriented_edge e : edges(t)) {
    EXPECT_EQ(get(length, e), t.length(e));
    EXPECT_EQ(weight[e], t.cotangent_weight(e));
    EXPECT_EQ(get(boost::edge_weight, t, e), t.length(e));
    EXPECT_EQ(get(crossings, e), IT::internal::engine(t).correspondence().coordinates().crossings(e));
    most = std::max(most, get(crossings, e));
  }
  EXPECT_GT(most, 0);
}

TEST(Graph_traits_Intrinsic_triangulation, index_maps_count_each_range)
{
  const Triangulation t = flat_pillow();
  std::uint32_t n = 0;
  for (Vertex_index v : vertices(t))
    EXPECT_EQ(get(get(boost::vertex_index, t), v), n++);
  n = 0;
  for (Halfedge_index h : halfedges(t))
    EXPECT_EQ(get(CGAL::halfedge_index, t, h), n++);
  n = 0;
  for (Oriented_edge e : edges(t))
    EXPECT_EQ(get(boost::edge_index, t, e), n++);
  n = 0;
  for (Face_index f : faces(t))
    EXPECT_EQ(get(get(CGAL::face_index, t), f), n++);
}

TEST(Graph_traits_Intrinsic_triangulation, shortest_paths_have_the_lengths_as_weights)
{
  Triangulation sheets = two_sheared_sheets();
  IT::flip_to_Delaunay(sheets);
  for (const Triangulation& t : {sheets, flat_pillow()})
    for (Vertex_index v : vertices(t))
      EXPECT_EQ(distances_by_dijkstra(t, v), distances_by_relaxation(t, v));
}

TEST(Graph_traits_Intrinsic_triangulation, algorithms_of_CGAL)
{
  const Triangulation t = two_sheared_sheets();
  EXPECT_EQ(distances_by_dijkstra(t, Vertex_index(0)), distances_by_relaxation(t, Vertex_index(0)));
  EXPECT_TRUE(CGAL::is_triangle_mesh(t));
  EXPECT_FALSE(CGAL::is_closed(t));
  auto component = get(CGAL::dynamic_face_property_t<std::size_t>(), t);
  EXPECT_EQ(CGAL::Polygon_mesh_processing::connected_components(t, component), 2u);
  EXPECT_NE(get(component, Face_index(0)), get(component, Face_index(num_faces(t) - 1)));
}

TEST(Graph_traits_Intrinsic_triangulation, connected_components_beyond_constrained_edges)
{
  Triangulation t = two_sheared_sheets();
  IT::flip_to_Delaunay(t);
  std::vector<std::size_t> component(num_faces(t));
  const auto map = boost::make_iterator_property_map(component.begin(), get(boost::face_index, t));
  EXPECT_EQ(CGAL::Polygon_mesh_processing::connected_components(t, map), 2u);
  // Each face for itself.
  auto is_constrained = get(CGAL::dynamic_edge_property_t<bool>(), t);
  for (Oriented_edge e : edges(t))
    put(is_constrained, e, true);
  EXPECT_EQ(CGAL::Polygon_mesh_processing::connected_components(
              t, map, CGAL::parameters::edge_is_constrained_map(is_constrained)),
            num_faces(t));
}
