// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Building, checking and flipping connectivity.

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Delta_complex;
using IT::Edge_index;
using IT::Face_index;
using IT::Halfedge_index;
using IT::Vertex_index;
using Defect = IT::Invalid_surface_error::Defect;
using Triangles = std::vector<std::array<int, 3>>;
using Side_pairs = std::vector<std::array<int, 2>>;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

namespace {

// The arrays of a complex, to be damaged.
struct Arrays
{
  explicit Arrays(const Delta_complex& c)
  {
    for (Halfedge_index h : c.halfedges())
      halfedges.push_back({c.next(h).idx(), c.prev(h).idx(), c.target(h).idx(), c.face(h).idx()});
    for (Vertex_index v : c.vertices())
      vertices.push_back(c.halfedge(v));
    for (Face_index f : c.faces())
      faces.push_back(c.halfedge(f));
  }
  Delta_complex complex() const { return Delta_complex(halfedges, vertices, faces); }

  Delta_complex::Halfedge_vector halfedges;
  Delta_complex::Descriptor_vector vertices, faces;
};

Delta_complex tetrahedron()
{
  return IT::make_Delta_complex_from_triangles(4, Triangles{{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}});
}

int degree(const Delta_complex& c, Vertex_index v)
{
  int n = 0;
  for (Halfedge_index h : c.halfedges())
    n += c.target(h) == v;
  return n;
}

int euler_characteristic(const Delta_complex& c)
{
  return int(c.number_of_vertices()) - int(c.number_of_edges()) + int(c.number_of_faces());
}

int number_of_border_halfedges(const Delta_complex& c)
{
  int n = 0;
  for (Halfedge_index h : c.halfedges())
    n += c.is_border(h);
  return n;
}

std::vector<std::array<std::uint32_t, 4>> link_table(const Delta_complex& c)
{
  std::vector<std::array<std::uint32_t, 4>> table;
  for (Halfedge_index h : c.halfedges())
    table.push_back({c.next(h).idx(), c.prev(h).idx(), c.target(h).idx(), c.face(h).idx()});
  for (Face_index f : c.faces())
    table.push_back({c.halfedge(f).idx(), 0, 0, 0});
  return table;
}

void expect_defect(const std::function<void()>& build, Defect defect, std::size_t element, const std::string& word)
{
  try {
    build();
    FAIL() << "was accepted";
  } catch (const IT::Invalid_surface_error& e) {
    EXPECT_EQ(e.defect(), defect) << e.what();
    EXPECT_EQ(e.element(), element) << e.what();
    EXPECT_NE(std::string(e.what()).find(word), std::string::npos) << e.what();
  }
}

// All ways to glue some of the given sides in pairs.
std::vector<Side_pairs> all_gluings(std::vector<int> sides)
{
  if (sides.empty())
    return {{}};
  const int first = sides.front();
  sides.erase(sides.begin());
  std::vector<Side_pairs> result = all_gluings(sides); // the first side stays on the boundary
  for (int partner : sides) {
    std::vector<int> rest = sides;
    rest.erase(std::find(rest.begin(), rest.end(), partner));
    for (Side_pairs pairs : all_gluings(rest)) {
      pairs.push_back({first, partner});
      result.push_back(pairs);
    }
  }
  return result;
}

// Two triangles that share side 0 = side 3, the other four sides glued in every way.
std::vector<Delta_complex> all_hinges()
{
  std::vector<Delta_complex> result;
  for (Side_pairs pairs : all_gluings({1, 2, 4, 5})) {
    pairs.insert(pairs.begin(), {0, 3});
    result.push_back(IT::make_Delta_complex_from_gluing(2, pairs));
  }
  return result;
}

// The faces by the vertices of their corners, smallest first.
std::multiset<std::array<std::uint32_t, 3>> corner_sets(const Delta_complex& c)
{
  std::multiset<std::array<std::uint32_t, 3>> result;
  for (Face_index f : c.faces()) {
    const Halfedge_index h = c.halfedge(f);
    std::array<std::uint32_t, 3> corners{c.source(h).idx(), c.target(h).idx(), c.target(c.next(h)).idx()};
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    result.insert(corners);
  }
  return result;
}

// The corners of a mesh by the positions of its vertices in their range.
template <class FaceGraph>
Triangles triangles_of(const FaceGraph& graph)
{
  std::map<typename boost::graph_traits<FaceGraph>::vertex_descriptor, int> position;
  for (auto v : vertices(graph))
    position.insert({v, int(position.size())});
  Triangles result;
  for (auto f : faces(graph)) {
    const auto h = halfedge(f, graph);
    result.push_back({position[source(h, graph)], position[target(h, graph)], position[target(next(h, graph), graph)]});
  }
  return result;
}

template <class FaceGraph>
void expect_same_as_from_triangles(const FaceGraph& graph)
{
  const Delta_complex c = IT::make_Delta_complex(graph);
  const Triangles triangles = triangles_of(graph);
  // num_vertices() of a mesh with garbage counts the garbage.
  const std::size_t n = std::size_t(std::distance(vertices(graph).begin(), vertices(graph).end()));
  const Delta_complex d = IT::make_Delta_complex_from_triangles(n, triangles);
  EXPECT_TRUE(c.is_valid(true));
  EXPECT_TRUE(d.is_valid(true));
  EXPECT_EQ(c.number_of_vertices(), d.number_of_vertices());
  EXPECT_EQ(c.number_of_edges(), d.number_of_edges());
  EXPECT_EQ(corner_sets(c), corner_sets(d));
  EXPECT_EQ(number_of_border_halfedges(c), number_of_border_halfedges(d));
  // Faces keep their order, edges and halfedges that of the graph's range.
  for (Face_index f : c.faces()) {
    EXPECT_EQ(c.source(c.halfedge(f)).idx(), std::uint32_t(triangles[f.idx()][0]));
    EXPECT_EQ(c.target(c.halfedge(f)).idx(), std::uint32_t(triangles[f.idx()][1]));
  }
  std::map<typename boost::graph_traits<FaceGraph>::vertex_descriptor, std::uint32_t> position;
  for (auto v : vertices(graph))
    position.insert({v, std::uint32_t(position.size())});
  std::uint32_t i = 0;
  for (auto e : edges(graph)) {
    EXPECT_EQ(c.source(Halfedge_index(2 * i)).idx(), position[source(halfedge(e, graph), graph)]);
    EXPECT_EQ(c.target(Halfedge_index(2 * i)).idx(), position[target(halfedge(e, graph), graph)]);
    ++i;
  }
}

} // namespace

TEST(Make_Delta_complex_from_triangles, numbers_edges_by_their_first_appearance)
{
  const Delta_complex c = IT::make_Delta_complex_from_triangles(5, Triangles{{0, 1, 2}, {0, 2, 3}});
  ASSERT_TRUE(c.is_valid(true));
  EXPECT_EQ(c.number_of_vertices(), 5u);
  EXPECT_EQ(c.number_of_edges(), 5u);
  EXPECT_EQ(c.halfedge(Face_index(0)), Halfedge_index(0));
  EXPECT_EQ(c.halfedge(Face_index(1)), Halfedge_index(5)); // edge 2 is 2-0 in face 0
  EXPECT_EQ(c.source(Halfedge_index(4)), Vertex_index(2));
  EXPECT_TRUE(c.is_border(Edge_index(0)));
  EXPECT_FALSE(c.is_border(Edge_index(2)));
  EXPECT_TRUE(c.is_border(c.halfedge(Vertex_index(0))));
  EXPECT_FALSE(c.halfedge(Vertex_index(4)).is_valid());
  Halfedge_index h = c.opposite(Halfedge_index(0));
  for (int i = 0; i < 4; ++i) { // once around the border
    EXPECT_TRUE(c.is_border(h));
    EXPECT_EQ(c.prev(c.next(h)), h);
    h = c.next(h);
  }
  EXPECT_EQ(h, c.opposite(Halfedge_index(0)));
}

TEST(Make_Delta_complex_from_triangles, refuses_what_is_no_oriented_surface)
{
  const auto build = [](int n, Triangles t) {
    return [=] { IT::make_Delta_complex_from_triangles(std::size_t(n), t); };
  };
  expect_defect(build(3, {{0, 1, 2}, {0, 2, 3}}), Defect::BAD_INDEX, 1, "vertex 3");
  expect_defect(build(3, {{0, 1, -1}}), Defect::BAD_INDEX, 0, "vertex -1");
  expect_defect(build(3, {{0, 1, 0}}), Defect::REPEATED_CORNER, 0, "vertex 0");
  expect_defect(build(3, {{0, 1, 1}}), Defect::REPEATED_CORNER, 0, "vertex 1");
  expect_defect(build(3, {{1, 1, 9}}), Defect::REPEATED_CORNER, 0, "vertex 1");
  expect_defect(build(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}), Defect::NON_MANIFOLD_EDGE, 2, "edge 0-1");
  expect_defect(build(4, {{0, 1, 2}, {0, 1, 3}}), Defect::INCONSISTENT_ORIENTATION, 1, "edge 0-1");
  // Turning faces does not help if there are three.
  expect_defect(build(5, {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}}), Defect::NON_MANIFOLD_EDGE, 2, "edge 1-0");
  expect_defect(build(5, {{0, 1, 2}, {2, 3, 4}}), Defect::NON_MANIFOLD_VERTEX, 2, "vertex 2");
  // two tetrahedra that share vertex 0
  expect_defect(build(7, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}, {0, 4, 5}, {0, 6, 4}, {4, 6, 5}, {5, 6, 0}}),
                Defect::NON_MANIFOLD_VERTEX, 0, "vertex 0");
}

TEST(Make_Delta_complex_from_gluing, refuses_sides_that_cannot_be_glued)
{
  const auto build = [](int n, Side_pairs p) { return [=] { IT::make_Delta_complex_from_gluing(std::size_t(n), p); }; };
  expect_defect(build(1, {{0, 3}}), Defect::INVALID_GLUING, 0, "does not exist");
  expect_defect(build(1, {{-1, 1}}), Defect::INVALID_GLUING, 0, "does not exist");
  expect_defect(build(2, {{0, 3}, {4, 4}}), Defect::INVALID_GLUING, 1, "to itself");
  expect_defect(build(2, {{0, 3}, {1, 3}}), Defect::INVALID_GLUING, 1, "already");
  expect_defect(build(2, {{0, 3}, {0, 4}}), Defect::INVALID_GLUING, 1, "already");
}

TEST(Make_Delta_complex_from_gluing, finds_the_vertices)
{
  const auto vertices = [](int n, Side_pairs p) {
    const Delta_complex c = IT::make_Delta_complex_from_gluing(std::size_t(n), p);
    EXPECT_TRUE(c.is_valid(true));
    return c.number_of_vertices();
  };
  EXPECT_EQ(vertices(1, {}), 3u);
  EXPECT_EQ(vertices(1, {{0, 1}}), 2u);                 // a cone
  EXPECT_EQ(vertices(2, {{0, 3}, {1, 4}, {2, 5}}), 1u); // a torus
  EXPECT_EQ(vertices(2, {{0, 3}, {1, 5}, {2, 4}}), 3u); // a pillow
  EXPECT_EQ(vertices(2, {{0, 1}, {2, 5}, {3, 4}}), 3u); // two cones
}

TEST(Make_Delta_complex, agrees_with_the_corners_of_a_surface_mesh)
{
  Mesh sphere;
  CGAL::make_icosahedron(sphere, Point(0, 0, 0), 1.);
  expect_same_as_from_triangles(sphere);
  Mesh grid;
  CGAL::make_grid(
    3, 4, grid, [](int i, int j) { return Point(i, j, 0); }, true);
  expect_same_as_from_triangles(grid);
  const Delta_complex c = IT::make_Delta_complex(grid);
  for (auto h : grid.halfedges())
    EXPECT_EQ(c.next(Halfedge_index(h.idx())).idx(), grid.next(h).idx());
}

TEST(Make_Delta_complex, agrees_with_the_corners_of_a_surface_mesh_with_garbage)
{
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Point(0, 0, 0), 1.);
  CGAL::Euler::remove_center_vertex(mesh.halfedge(Mesh::Vertex_index(0)), mesh);
  for (auto f : mesh.faces()) // fill the hole that the vertex left
    if (mesh.degree(f) > 3) {
      CGAL::Euler::split_face(mesh.halfedge(f), mesh.next(mesh.next(mesh.halfedge(f))), mesh);
      break;
    }
  for (auto f : mesh.faces()) // and open what remains of it
    if (mesh.degree(f) > 3) {
      CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
      break;
    }
  ASSERT_TRUE(mesh.has_garbage());
  ASSERT_TRUE(mesh.is_removed(Mesh::Vertex_index(0)));
  expect_same_as_from_triangles(mesh);
}

TEST(Make_Delta_complex, agrees_with_the_corners_of_a_polyhedron)
{
  using Polyhedron = CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>;
  Polyhedron polyhedron;
  CGAL::make_icosahedron(polyhedron, Point(0, 0, 0), 1.);
  expect_same_as_from_triangles(polyhedron);
  polyhedron.erase_facet(polyhedron.facets_begin()->halfedge());
  expect_same_as_from_triangles(polyhedron);
}

TEST(Make_Delta_complex, refuses_a_face_that_is_not_a_triangle)
{
  Mesh mesh;
  CGAL::make_hexahedron(Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0), Point(0, 1, 1), Point(0, 0, 1),
                        Point(1, 0, 1), Point(1, 1, 1), mesh);
  expect_defect([&] { IT::make_Delta_complex(mesh); }, Defect::NOT_A_TRIANGLE, 0, "6 such faces");
}

// An edge without faces: the copy must keep everything that refers to it.
TEST(Make_Delta_complex, copies_an_edge_without_faces)
{
  Mesh mesh;
  CGAL::make_triangle(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), mesh);
  const auto v = mesh.add_vertex(Point(5, 0, 0)), w = mesh.add_vertex(Point(6, 0, 0));
  const auto h = mesh.add_edge(v, w), g = mesh.opposite(h);
  mesh.set_next(h, g);
  mesh.set_next(g, h);
  mesh.set_halfedge(v, g);
  mesh.set_halfedge(w, h);
  const Delta_complex c = IT::make_Delta_complex(mesh);
  ASSERT_EQ(c.number_of_halfedges(), 8u);
  const Halfedge_index copy(h.idx());
  EXPECT_TRUE(c.is_border(copy) && c.is_border(c.opposite(copy)));
  EXPECT_EQ(c.next(copy), c.opposite(copy));
  EXPECT_EQ(c.prev(copy), c.opposite(copy));
  EXPECT_EQ(c.target(copy).idx(), w.idx());
  EXPECT_EQ(c.source(copy).idx(), v.idx());
}

TEST(Delta_complex, any_single_wrong_entry_is_found)
{
  const Delta_complex with_border = IT::make_Delta_complex_from_triangles(5, Triangles{{0, 1, 2}, {0, 2, 3}});
  const Delta_complex torus = IT::make_Delta_complex_from_gluing(2, Side_pairs{{0, 3}, {1, 4}, {2, 5}});
  for (const Delta_complex& c : {with_border, torus, tetrahedron()}) {
    const Arrays arrays(c);
    ASSERT_TRUE(arrays.complex().is_valid(true));
    const std::uint32_t out_of_range[] = {1000, Halfedge_index::null_index()};
    const auto values = [&](std::uint32_t n) {
      std::vector<std::uint32_t> result(out_of_range, out_of_range + 2);
      for (std::uint32_t i = 0; i < n; ++i)
        result.push_back(i);
      return result;
    };
    for (std::size_t h = 0; h < arrays.halfedges.size(); ++h) {
      for (std::uint32_t value : values(c.number_of_halfedges())) {
        Arrays a = arrays;
        a.halfedges[h].next = value;
        EXPECT_EQ(a.complex().is_valid(), a.halfedges[h].next == arrays.halfedges[h].next);
        a = arrays;
        a.halfedges[h].prev = value;
        EXPECT_EQ(a.complex().is_valid(), a.halfedges[h].prev == arrays.halfedges[h].prev);
      }
      for (std::uint32_t value : values(c.number_of_vertices())) {
        Arrays a = arrays;
        a.halfedges[h].target = value;
        EXPECT_EQ(a.complex().is_valid(), a.halfedges[h].target == arrays.halfedges[h].target);
      }
      for (std::uint32_t value : values(c.number_of_faces())) {
        Arrays a = arrays;
        a.halfedges[h].face = value;
        EXPECT_EQ(a.complex().is_valid(), a.halfedges[h].face == arrays.halfedges[h].face);
      }
    }
    for (std::size_t f = 0; f < arrays.faces.size(); ++f)
      for (std::uint32_t value : values(c.number_of_halfedges())) {
        Arrays a = arrays;
        a.faces[f] = Halfedge_index(value);
        const bool is_in_face =
          value < c.number_of_halfedges() && c.face(Halfedge_index(value)) == Face_index(std::uint32_t(f));
        EXPECT_EQ(a.complex().is_valid(), is_in_face);
      }
    for (std::size_t v = 0; v < arrays.vertices.size(); ++v)
      for (std::uint32_t value : values(c.number_of_halfedges())) {
        Arrays a = arrays;
        a.vertices[v] = Halfedge_index(value);
        const bool points_to_it =
          value < c.number_of_halfedges() && c.target(Halfedge_index(value)) == Vertex_index(std::uint32_t(v));
        const bool is_isolated = !arrays.vertices[v].is_valid();
        const bool is_good =
          is_isolated ? value == Halfedge_index::null_index()
                      : points_to_it && (!c.is_border(arrays.vertices[v]) || c.is_border(Halfedge_index(value)));
        EXPECT_EQ(a.complex().is_valid(), is_good) << "v" << v << " h" << value;
      }
  }
}

TEST(Delta_complex, missing_and_additional_entries_are_found)
{
  const Arrays arrays(tetrahedron());
  Arrays a = arrays;
  a.halfedges.pop_back();
  EXPECT_FALSE(a.complex().is_valid());
  a = arrays;
  a.faces.pop_back();
  EXPECT_FALSE(a.complex().is_valid());
  a = arrays;
  a.faces.push_back(a.faces.back());
  EXPECT_FALSE(a.complex().is_valid());
  a = arrays;
  a.vertices.pop_back();
  EXPECT_FALSE(a.complex().is_valid());
  a = arrays;
  a.vertices.push_back(Halfedge_index()); // an isolated vertex
  EXPECT_TRUE(a.complex().is_valid());
  // a vertex cut into two, but both fans keep its number
  Arrays two = Arrays(IT::make_Delta_complex_from_triangles(6, Triangles{{0, 1, 2}, {3, 4, 5}}));
  EXPECT_TRUE(two.complex().is_valid());
  for (Delta_complex::Halfedge& h : two.halfedges)
    if (h.target == 3)
      h.target = 2;
  two.vertices[3] = Halfedge_index();
  EXPECT_FALSE(two.complex().is_valid());
}

TEST(Delta_complex, equality_ignores_only_the_halfedges_of_inner_vertices)
{
  const Arrays arrays(tetrahedron());
  Arrays a = arrays;
  a.vertices[0] = arrays.complex().next_around_target(a.vertices[0]);
  ASSERT_TRUE(a.complex().is_valid(true));
  EXPECT_EQ(a.complex(), arrays.complex());
  a = arrays;
  a.faces[1] = arrays.complex().next(a.faces[1]);
  EXPECT_NE(a.complex(), arrays.complex());
  a = arrays;
  a.vertices.push_back(Halfedge_index());
  EXPECT_NE(a.complex(), arrays.complex());
  Delta_complex flipped = tetrahedron();
  flipped.flip(Edge_index(0));
  EXPECT_NE(flipped, arrays.complex());
}

TEST(Delta_complex_flip, does_as_documented_on_every_gluing_of_two_triangles)
{
  const std::vector<Delta_complex> hinges = all_hinges();
  ASSERT_EQ(hinges.size(), 10u);
  for (const Delta_complex& original : hinges) {
    ASSERT_TRUE(original.is_valid(true));
    for (Edge_index e : original.edges()) {
      if (!original.is_flippable(e)) {
        EXPECT_TRUE(original.is_border(e) || original.is_self_glued(e));
        continue;
      }
      const Halfedge_index h = original.halfedge(e), g = original.opposite(h);
      const Halfedge_index jk = original.next(h), ki = original.prev(h);
      const Halfedge_index il = original.next(g), lj = original.prev(g);
      const Vertex_index k = original.target(jk), l = original.target(il);
      Delta_complex c = original;
      c.flip(e);
      EXPECT_TRUE(c.is_valid(true));
      EXPECT_EQ(euler_characteristic(c), euler_characteristic(original));
      EXPECT_EQ(number_of_border_halfedges(c), number_of_border_halfedges(original));
      EXPECT_EQ(c.source(h), l);
      EXPECT_EQ(c.target(h), k);
      EXPECT_EQ(c.halfedge(original.face(h)), h);
      EXPECT_EQ(c.halfedge(original.face(g)), g);
      EXPECT_EQ(c.next(h), ki);
      EXPECT_EQ(c.next(ki), il);
      EXPECT_EQ(c.next(g), lj);
      EXPECT_EQ(c.next(lj), jk);
      EXPECT_EQ(c.face(ki), original.face(h));
      EXPECT_EQ(c.face(il), original.face(h));
      EXPECT_EQ(c.face(lj), original.face(g));
      EXPECT_EQ(c.face(jk), original.face(g));
      for (Halfedge_index other : c.halfedges()) {
        if (c.edge(other) == e)
          continue;
        EXPECT_EQ(c.target(other), original.target(other));
        if (original.is_border(other)) {
          EXPECT_EQ(c.next(other), original.next(other));
        }
      }
    }
  }
}

TEST(Delta_complex_flip, four_times_is_the_identity_and_twice_turns_the_edge_around)
{
  for (const Delta_complex& hinge : all_hinges())
    for (Edge_index e : hinge.edges()) {
      if (!hinge.is_flippable(e))
        continue;
      Delta_complex original = hinge; // faces that begin with the edge, as a flip leaves them
      for (int i = 0; i < 4; ++i)
        original.flip(e);
      Delta_complex c = original;
      c.flip(e);
      c.flip(e);
      const Halfedge_index h = c.halfedge(e);
      EXPECT_EQ(c.source(h), original.target(h));
      EXPECT_EQ(c.target(h), original.source(h));
      EXPECT_EQ(c.next(h), original.next(original.opposite(h)));
      c.flip(e);
      c.flip(e);
      EXPECT_EQ(link_table(c), link_table(original));
      EXPECT_EQ(c, original);
      // Except for the first halfedges of the two faces, from any start.
      for (Halfedge_index g : hinge.halfedges()) {
        EXPECT_EQ(c.next(g), hinge.next(g));
        EXPECT_EQ(c.target(g), hinge.target(g));
        EXPECT_EQ(c.face(g), hinge.face(g));
      }
    }
}

TEST(Delta_complex_flip, keeps_many_random_flips_valid)
{
  std::mt19937 random(3);
  Mesh grid;
  CGAL::make_grid(
    4, 4, grid, [](int i, int j) { return Point(i, j, 0); }, true);
  for (Delta_complex c : {tetrahedron(), IT::make_Delta_complex(grid)}) {
    const int chi = euler_characteristic(c);
    std::uniform_int_distribution<std::uint32_t> any_edge(0, c.number_of_edges() - 1);
    int loops = 0;
    for (int i = 0; i < 2000; ++i) {
      const Edge_index e(any_edge(random));
      if (!c.is_flippable(e))
        continue;
      c.flip(e);
      loops += c.is_loop(e);
      ASSERT_TRUE(c.is_valid(true));
      ASSERT_EQ(euler_characteristic(c), chi);
    }
    EXPECT_GT(loops, 0);
  }
}

// Figure 3 of the paper: a vertex of valence three gets valence one, inside a loop.
TEST(Delta_complex_flip, two_flips_put_a_vertex_of_valence_three_inside_a_loop)
{
  const Vertex_index apex(3);
  Delta_complex c = tetrahedron();
  EXPECT_EQ(degree(c, apex), 3);

  c.flip(c.edge(c.halfedge(apex)));
  ASSERT_TRUE(c.is_valid(true));
  EXPECT_EQ(degree(c, apex), 2);
  for (Edge_index e : c.edges())
    EXPECT_FALSE(c.is_loop(e));

  const Edge_index last = c.edge(c.halfedge(apex));
  c.flip(last);
  ASSERT_TRUE(c.is_valid(true));
  EXPECT_EQ(degree(c, apex), 1);
  EXPECT_TRUE(c.is_loop(last));
  const Halfedge_index stem = c.halfedge(apex);
  EXPECT_TRUE(c.is_self_glued(c.edge(stem)));
  EXPECT_FALSE(c.is_flippable(c.edge(stem)));
  EXPECT_EQ(c.next(stem), c.opposite(stem));
  EXPECT_EQ(c.source(stem), c.target(c.halfedge(last)));
  EXPECT_EQ(c.number_of_vertices() + c.number_of_faces(), c.number_of_edges() + 2);
}
