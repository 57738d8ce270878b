// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Delta_complex as a graph: concepts, and generic algorithms on surfaces with loops.

#include <CGAL/Intrinsic_triangulations/graph_traits_Delta_complex.h>

#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/boost/graph/graph_concepts.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/graph_concepts.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>
#include <type_traits>
#include <unordered_set>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Delta_complex;
using IT::Edge_index;
using IT::Face_index;
using IT::Halfedge_index;
using IT::Oriented_edge;
using IT::Vertex_index;
using Triangles = std::vector<std::array<int, 3>>;
using Side_pairs = std::vector<std::array<int, 2>>;

BOOST_CONCEPT_ASSERT((boost::GraphConcept<Delta_complex>));
BOOST_CONCEPT_ASSERT((boost::IncidenceGraphConcept<Delta_complex>));
BOOST_CONCEPT_ASSERT((boost::BidirectionalGraphConcept<Delta_complex>));
BOOST_CONCEPT_ASSERT((boost::AdjacencyGraphConcept<Delta_complex>));
BOOST_CONCEPT_ASSERT((boost::VertexListGraphConcept<Delta_complex>));
BOOST_CONCEPT_ASSERT((boost::EdgeListGraphConcept<Delta_complex>));
BOOST_CONCEPT_ASSERT((boost::VertexAndEdgeListGraphConcept<Delta_complex>));
BOOST_CONCEPT_ASSERT((CGAL::HalfedgeGraphConcept<Delta_complex>));
BOOST_CONCEPT_ASSERT((CGAL::HalfedgeListGraphConcept<Delta_complex>));
BOOST_CONCEPT_ASSERT((CGAL::FaceGraphConcept<Delta_complex>));
BOOST_CONCEPT_ASSERT((CGAL::FaceListGraphConcept<Delta_complex>));
BOOST_CONCEPT_ASSERT((boost::ReadablePropertyGraphConcept<Delta_complex, Vertex_index, boost::vertex_index_t>));
BOOST_CONCEPT_ASSERT((boost::ReadablePropertyGraphConcept<Delta_complex, Oriented_edge, boost::edge_index_t>));

static_assert(std::is_convertible<Oriented_edge, Edge_index>::value, "");
static_assert(!std::is_convertible<Edge_index, Oriented_edge>::value, "");
static_assert(std::is_same<decltype(*std::declval<Delta_complex>().edges().begin()), Edge_index>::value,
              "the complex itself knows undirected edges only");

namespace {

Delta_complex one_vertex_torus() { return IT::make_Delta_complex_from_gluing(2, Side_pairs{{0, 3}, {1, 4}, {2, 5}}); }

Delta_complex pillow() { return IT::make_Delta_complex_from_gluing(2, Side_pairs{{0, 3}, {1, 5}, {2, 4}}); }

Delta_complex tetrahedron()
{
  return IT::make_Delta_complex_from_triangles(4, Triangles{{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}});
}

// Two edges at vertex 3 are flipped away: it has valence 1, inside a loop.
Delta_complex tetrahedron_with_loop()
{
  Delta_complex c = tetrahedron();
  for (int flips = 0; flips < 2; ++flips)
    c.flip(c.edge(c.halfedge(Vertex_index(3))));
  return c;
}

// Two triangles that share an edge, and a vertex apart.
Delta_complex square_and_isolated_vertex()
{
  return IT::make_Delta_complex_from_triangles(5, Triangles{{0, 1, 2}, {0, 2, 3}});
}

std::vector<Delta_complex> all_surfaces()
{
  return {one_vertex_torus(), pillow(), tetrahedron(), tetrahedron_with_loop(), square_and_isolated_vertex()};
}

// Shortest distances along edges, by plain relaxation over the halfedges.
std::vector<double> distances_by_relaxation(const Delta_complex& c, const std::vector<double>& length,
                                            Vertex_index from)
{
  std::vector<double> distance(c.number_of_vertices(), std::numeric_limits<double>::infinity());
  distance[from.idx()] = 0;
  for (std::size_t round = 0; round < distance.size(); ++round)
    for (Halfedge_index h : c.halfedges()) {
      const double d = distance[c.source(h).idx()] + length[c.edge(h).idx()];
      distance[c.target(h).idx()] = std::min(distance[c.target(h).idx()], d);
    }
  return distance;
}

template <class Traits>
std::vector<double> distances_by_dijkstra(const IT::Intrinsic_triangulation<Traits>& t, Vertex_index from)
{
  const Delta_complex& c = t.connectivity();
  std::vector<double> distance(num_vertices(c));
  boost::dijkstra_shortest_paths(
    c, from,
    boost::weight_map(
      boost::make_function_property_map<Oriented_edge, double>([&](Oriented_edge e) { return t.length(e); }))
      .distance_map(boost::make_iterator_property_map(distance.begin(), get(boost::vertex_index, c)))
      .distance_inf(std::numeric_limits<double>::infinity()));
  return distance;
}

std::size_t number_of_components(const Delta_complex& c)
{
  return CGAL::Polygon_mesh_processing::connected_components(c, get(CGAL::dynamic_face_property_t<std::size_t>(), c));
}

} // namespace

TEST(Graph_traits_Delta_complex, an_oriented_edge_compares_without_its_direction)
{
  const Oriented_edge forth(Halfedge_index(6)), back(Halfedge_index(7)), other(Halfedge_index(8));
  EXPECT_EQ(forth, back);
  EXPECT_NE(forth, other);
  EXPECT_NE(forth.halfedge(), back.halfedge());
  EXPECT_EQ(forth, Edge_index(3));
  EXPECT_EQ(Edge_index(3), back);
  EXPECT_EQ(Oriented_edge(Edge_index(3)).halfedge(), Halfedge_index(6));
  EXPECT_LT(forth, other);
  EXPECT_EQ((std::unordered_set<Oriented_edge>{forth, back, other}).size(), 2u);
  EXPECT_FALSE(Oriented_edge().is_valid());
  EXPECT_EQ(Oriented_edge(), Oriented_edge(Edge_index()));
  EXPECT_FALSE(Edge_index(Oriented_edge()).is_valid());
}

TEST(Graph_traits_Delta_complex, out_edges_begin_and_in_edges_end_at_the_vertex)
{
  for (const Delta_complex& c : all_surfaces()) {
    std::size_t sum = 0;
    for (Vertex_index v : vertices(c)) {
      std::size_t out = 0, in = 0;
      std::multiset<Vertex_index> from_edges, neighbors;
      for (Oriented_edge e : CGAL::make_range(out_edges(v, c))) {
        EXPECT_EQ(source(e, c), v);
        EXPECT_EQ(source(halfedge(e, c), c), v);
        from_edges.insert(target(e, c));
        ++out;
      }
      for (Oriented_edge e : CGAL::make_range(in_edges(v, c))) {
        EXPECT_EQ(target(e, c), v);
        ++in;
      }
      for (Vertex_index u : CGAL::make_range(adjacent_vertices(v, c)))
        neighbors.insert(u);
      EXPECT_EQ(neighbors, from_edges);
      EXPECT_EQ(out, out_degree(v, c));
      EXPECT_EQ(in, in_degree(v, c));
      EXPECT_EQ(out, degree(v, c));
      sum += out;
    }
    EXPECT_EQ(sum, num_halfedges(c));
  }
}

TEST(Graph_traits_Delta_complex, an_isolated_vertex_has_no_edges)
{
  const Delta_complex c = square_and_isolated_vertex();
  const auto out = out_edges(Vertex_index(4), c);
  EXPECT_EQ(out.first, out.second);
  EXPECT_EQ(degree(Vertex_index(4), c), 0u);
  EXPECT_FALSE(halfedge(Vertex_index(0), Vertex_index(4), c).second);
}

TEST(Graph_traits_Delta_complex, some_edge_is_found_by_its_ends_if_there_is_one)
{
  for (const Delta_complex& c : all_surfaces())
    for (Vertex_index u : vertices(c))
      for (Vertex_index v : vertices(c)) {
        bool exists = false;
        for (Halfedge_index h : halfedges(c))
          exists = exists || (source(h, c) == u && target(h, c) == v);
        const auto h = halfedge(u, v, c);
        const auto e = edge(u, v, c);
        EXPECT_EQ(h.second, exists);
        EXPECT_EQ(e.second, exists);
        if (exists) {
          EXPECT_EQ(source(h.first, c), u);
          EXPECT_EQ(target(h.first, c), v);
          EXPECT_EQ(source(e.first, c), u);
          EXPECT_EQ(target(e.first, c), v);
        }
      }
}

TEST(Graph_traits_Delta_complex, index_maps_count_each_range)
{
  for (const Delta_complex& c : all_surfaces()) {
    std::uint32_t n = 0;
    for (auto v : vertices(c))
      EXPECT_EQ(get(get(boost::vertex_index, c), v), n++);
    n = 0;
    for (auto h : halfedges(c))
      EXPECT_EQ(get(CGAL::halfedge_index, c, h), n++);
    n = 0;
    for (auto e : edges(c))
      EXPECT_EQ(get(get(boost::edge_index, c), e), n++);
    EXPECT_EQ(n, std::size_t(std::distance(edges(c).begin(), edges(c).end())));
    n = 0;
    for (auto f : faces(c))
      EXPECT_EQ(get(get(CGAL::face_index, c), f), n++);
  }
}

TEST(Graph_traits_Delta_complex, dynamic_properties_hold_a_value_for_each_element)
{
  const Delta_complex c = tetrahedron_with_loop();
  auto on_vertices = get(CGAL::dynamic_vertex_property_t<int>(), c);
  auto on_halfedges = get(CGAL::dynamic_halfedge_property_t<int>(), c);
  auto on_edges = get(CGAL::dynamic_edge_property_t<bool>(), c);
  auto on_faces = get(CGAL::dynamic_face_property_t<int>(), c);
  for (auto v : vertices(c))
    put(on_vertices, v, int(v.idx()) + 10);
  for (auto h : halfedges(c))
    put(on_halfedges, h, int(h.idx()) + 20);
  for (auto f : faces(c))
    put(on_faces, f, int(f.idx()) + 30);
  put(on_edges, edge(Halfedge_index(5), c), true);
  for (auto v : vertices(c))
    EXPECT_EQ(get(on_vertices, v), int(v.idx()) + 10);
  for (auto h : halfedges(c)) {
    EXPECT_EQ(get(on_halfedges, h), int(h.idx()) + 20);
    EXPECT_EQ(get(on_edges, edge(h, c)), h.idx() / 2 == 2); // both directions, one value
  }
  for (auto f : faces(c))
    EXPECT_EQ(get(on_faces, f), int(f.idx()) + 30);
}

TEST(Graph_traits_Delta_complex, generic_helpers_agree_with_the_complex)
{
  for (const Delta_complex& c : all_surfaces()) {
    EXPECT_TRUE(CGAL::is_triangle_mesh(c));
    bool is_closed = true;
    for (Halfedge_index h : halfedges(c)) {
      EXPECT_EQ(CGAL::is_border(h, c), c.is_border(h));
      is_closed = is_closed && !c.is_border(h);
    }
    EXPECT_EQ(CGAL::is_closed(c), is_closed);
    for (Oriented_edge e : edges(c))
      EXPECT_EQ(CGAL::is_border(e, c), c.is_border(Edge_index(e)));
  }
}

TEST(Graph_traits_Delta_complex, a_complex_copied_as_a_graph_is_the_same_complex)
{
  for (const Delta_complex& c : all_surfaces())
    EXPECT_EQ(IT::make_Delta_complex(c), c);
}

TEST(Graph_traits_Delta_complex, connected_components)
{
  EXPECT_EQ(number_of_components(one_vertex_torus()), 1u);
  EXPECT_EQ(number_of_components(pillow()), 1u);
  EXPECT_EQ(number_of_components(tetrahedron_with_loop()), 1u);
  // A one-vertex torus beside a pillow.
  const Delta_complex two =
    IT::make_Delta_complex_from_gluing(4, Side_pairs{{0, 3}, {1, 4}, {2, 5}, {6, 9}, {7, 11}, {8, 10}});
  EXPECT_EQ(number_of_components(two), 2u);
  std::vector<Face_index> component;
  CGAL::Polygon_mesh_processing::connected_component(Face_index(3), two, std::back_inserter(component));
  EXPECT_EQ((std::set<Face_index>(component.begin(), component.end())),
            (std::set<Face_index>{Face_index(2), Face_index(3)}));
}

TEST(Graph_traits_Delta_complex, shortest_paths_go_along_the_shortest_of_several_edges)
{
  using Traits = IT::Edge_length_traits<double>;
  using Triangulation = IT::Intrinsic_triangulation<Traits>;

  const Triangulation torus = Triangulation::from_lengths(one_vertex_torus(), {1, 1, 1});
  EXPECT_EQ(distances_by_dijkstra(torus, Vertex_index(0)), std::vector<double>{0});

  const Triangulation flat_pillow = Triangulation::from_lengths(pillow(), {3, 4, 5});
  const Delta_complex& p = flat_pillow.connectivity();
  const Vertex_index from = p.source(p.halfedge(Edge_index(2)));
  EXPECT_EQ(distances_by_dijkstra(flat_pillow, from), distances_by_relaxation(p, {3, 4, 5}, from));

  // A tetrahedron with a tall apex at vertex 3; after two flips there the apex is inside a
  // loop and has one neighbor.
  Triangulation tall(tetrahedron(), {{0, 0, 0}, {4, 0, 0}, {1, 3, 0}, {1.5, 1, 9}});
  for (int flips = 0; flips < 2; ++flips) {
    const Delta_complex& c = tall.connectivity();
    ASSERT_EQ(tall.flip(c.edge(c.halfedge(Vertex_index(3)))), Triangulation::Flip_outcome::FLIPPED);
  }
  ASSERT_EQ(degree(Vertex_index(3), tall.connectivity()), 1u);
  std::vector<double> lengths;
  for (Edge_index e : tall.connectivity().edges())
    lengths.push_back(tall.length(e));
  for (Vertex_index v : tall.connectivity().vertices())
    EXPECT_EQ(distances_by_dijkstra(tall, v), distances_by_relaxation(tall.connectivity(), lengths, v));
}
