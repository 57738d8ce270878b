// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Copies into Surface_mesh: the same numbers, the same metric, loops included.

#include <CGAL/Intrinsic_triangulations/surface_mesh_adaptors.h>

#include <CGAL/Intrinsic_triangulations/internal/overlay/Carried_properties.h>
#include <CGAL/Intrinsic_triangulations/intrinsic_Delaunay_triangulation.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Delta_complex;
using IT::Edge_index;
using IT::Face_index;
using IT::Halfedge_index;
using IT::Vertex_index;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Triangles = std::vector<std::array<int, 3>>;
using Side_pairs = std::vector<std::array<int, 2>>;

namespace {

Delta_complex tetrahedron()
{
  return IT::make_Delta_complex_from_triangles(4, Triangles{{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}});
}

template <class SurfaceMesh>
void expect_same_links(const SurfaceMesh& mesh, const Delta_complex& c)
{
  ASSERT_EQ(mesh.number_of_vertices(), c.number_of_vertices());
  ASSERT_EQ(mesh.number_of_edges(), c.number_of_edges());
  ASSERT_EQ(mesh.number_of_faces(), c.number_of_faces());
  EXPECT_FALSE(mesh.has_garbage());
  EXPECT_TRUE(mesh.is_valid(true));
  for (Halfedge_index h : c.halfedges()) {
    const typename SurfaceMesh::Halfedge_index g(h.idx());
    EXPECT_EQ(mesh.next(g).idx(), c.next(h).idx());
    EXPECT_EQ(mesh.prev(g).idx(), c.prev(h).idx());
    EXPECT_EQ(mesh.opposite(g).idx(), c.opposite(h).idx());
    EXPECT_EQ(mesh.target(g).idx(), c.target(h).idx());
    EXPECT_EQ(mesh.is_border(g), c.is_border(h));
    if (!c.is_border(h)) {
      EXPECT_EQ(mesh.face(g).idx(), c.face(h).idx());
    }
  }
  for (Edge_index e : c.edges())
    EXPECT_EQ(mesh.halfedge(typename SurfaceMesh::Edge_index(e.idx())).idx(), c.halfedge(e).idx());
  for (Face_index f : c.faces())
    EXPECT_EQ(mesh.halfedge(typename SurfaceMesh::Face_index(f.idx())).idx(), c.halfedge(f).idx());
  for (Vertex_index v : c.vertices()) {
    const typename SurfaceMesh::Vertex_index u(v.idx());
    EXPECT_EQ(mesh.is_isolated(u), !c.halfedge(v).is_valid());
    if (c.halfedge(v).is_valid()) {
      EXPECT_EQ(mesh.halfedge(u).idx(), c.halfedge(v).idx());
    }
  }
  EXPECT_EQ(IT::make_Delta_complex(mesh), c);
}

template <class SurfaceMesh, class Triangulation>
void expect_same_metric(const SurfaceMesh& mesh, const Triangulation& t)
{
  using FT = typename Triangulation::FT;
  using Edge = typename SurfaceMesh::Edge_index;
  using Face = typename SurfaceMesh::Face_index;
  const auto squared = IT::internal::find_property_map<Edge, FT>(mesh, "e:squared_length");
  const auto length = IT::internal::find_property_map<Edge, FT>(mesh, "e:length");
  const auto area = IT::internal::find_property_map<Face, FT>(mesh, "f:area");
  ASSERT_TRUE(squared && length && area);
  for (Edge_index e : t.connectivity().edges()) {
    EXPECT_EQ(squared[Edge(e.idx())], t.squared_length(e));
    EXPECT_EQ(length[Edge(e.idx())], t.length(e));
  }
  for (Face_index f : t.connectivity().faces())
    EXPECT_EQ(area[Face(f.idx())], t.area(f));
}

} // namespace

TEST(Is_simplicial, asks_for_elements_that_are_known_by_their_vertices)
{
  EXPECT_TRUE(IT::is_simplicial(Delta_complex()));
  EXPECT_TRUE(IT::is_simplicial(tetrahedron()));
  EXPECT_TRUE(IT::is_simplicial(IT::make_Delta_complex_from_triangles(5, Triangles{{0, 1, 2}, {0, 2, 3}})));
  // two faces with the same corners
  const Delta_complex pillow = IT::make_Delta_complex_from_gluing(2, Side_pairs{{0, 3}, {1, 5}, {2, 4}});
  EXPECT_FALSE(IT::is_simplicial(pillow));
  EXPECT_FALSE(IT::is_simplicial(IT::make_Delta_complex_from_gluing(1, Side_pairs{{0, 1}})));
  EXPECT_FALSE(IT::is_simplicial(IT::make_Delta_complex_from_gluing(2, Side_pairs{{0, 3}, {1, 4}, {2, 5}})));
  Delta_complex c = tetrahedron();
  c.flip(Edge_index(0));
  EXPECT_FALSE(IT::is_simplicial(c));
  for (int i = 0; i < 3; ++i)
    c.flip(Edge_index(0));
  EXPECT_TRUE(IT::is_simplicial(c));
}

TEST(To_surface_mesh, copies_any_complex_with_its_numbers)
{
  std::vector<Delta_complex> complexes{tetrahedron(),
                                       IT::make_Delta_complex_from_gluing(2, Side_pairs{{0, 3}, {1, 4}, {2, 5}}),
                                       IT::make_Delta_complex_from_gluing(2, Side_pairs{{0, 3}, {1, 5}, {2, 4}}),
                                       IT::make_Delta_complex_from_gluing(1, Side_pairs{{0, 1}}),
                                       IT::make_Delta_complex_from_triangles(6, Triangles{{0, 1, 2}, {0, 2, 4}}),
                                       Delta_complex()};
  Delta_complex c = tetrahedron(); // until vertex 3 is inside a loop
  for (int flips = 0; flips < 2; ++flips)
    c.flip(c.edge(c.halfedge(Vertex_index(3))));
  complexes.push_back(c);
  for (const Delta_complex& complex : complexes)
    expect_same_links(IT::to_surface_mesh(complex, std::vector<Point>(complex.number_of_vertices())), complex);
}

TEST(To_surface_mesh, refuses_a_wrong_number_of_points)
{
  EXPECT_THROW(IT::to_surface_mesh(tetrahedron(), std::vector<Point>(3)), IT::Invalid_surface_error);
  EXPECT_THROW(IT::to_surface_mesh(tetrahedron(), std::vector<Point>(5)), IT::Invalid_surface_error);
}

TEST(To_surface_mesh, carries_the_metric_and_the_points_of_the_input)
{
  Mesh sphere;
  CGAL::make_icosahedron(sphere, Point(0, 0, 0), 2.);
  for (auto v : sphere.vertices()) { // squeezed, so that edges flip
    const Point p = sphere.point(v);
    sphere.point(v) = Point(p.x(), 0.2 * p.y(), p.z());
  }
  const auto [idt, report] = IT::intrinsic_Delaunay_triangulation(sphere);
  ASSERT_GT(report.flips, 0u);
  const auto from_mesh = IT::to_surface_mesh(idt, sphere);
  expect_same_links(from_mesh, idt.connectivity());
  expect_same_metric(from_mesh, idt);
  std::vector<Point> points;
  for (auto v : sphere.vertices()) {
    EXPECT_EQ(from_mesh.point(v), sphere.point(v));
    points.push_back(sphere.point(v));
  }
  const auto from_points = IT::to_surface_mesh(idt, points);
  expect_same_links(from_points, idt.connectivity());
  expect_same_metric(from_points, idt);
  // A geodesic edge is at least as long as the chord between its ends.
  const auto length = IT::internal::find_property_map<Mesh::Edge_index, double>(from_mesh, "e:length");
  for (auto e : from_mesh.edges())
    EXPECT_GE(length[e] * (1 + 1e-12), std::sqrt(CGAL::squared_distance(from_mesh.point(from_mesh.vertex(e, 0)),
                                                                        from_mesh.point(from_mesh.vertex(e, 1)))));
}

TEST(To_surface_mesh, takes_other_meshes_other_kernels_and_point_maps)
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  CGAL::Polyhedron_3<Exact> polyhedron;
  polyhedron.make_tetrahedron(Exact::Point_3(0, 0, 0), Exact::Point_3(1, 0, 0), Exact::Point_3(0, 1, 0),
                              Exact::Point_3(0, 0, 1));
  const auto t = IT::intrinsic_triangulation(polyhedron);
  const auto exact_mesh = IT::to_surface_mesh(t, polyhedron);
  expect_same_links(exact_mesh, t.connectivity());
  expect_same_metric(exact_mesh, t);
  std::size_t i = 0;
  for (auto v : vertices(polyhedron))
    EXPECT_EQ(exact_mesh.point(CGAL::SM_Vertex_index(std::uint32_t(i++))), v->point());

  Mesh mesh;
  CGAL::make_tetrahedron(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1), mesh);
  auto moved = mesh.add_property_map<Mesh::Vertex_index, Point>("v:moved", Point(5, 5, 5)).first;
  const auto copy =
    IT::to_surface_mesh(IT::intrinsic_triangulation(mesh), mesh, CGAL::parameters::vertex_point_map(moved));
  EXPECT_EQ(copy.point(Mesh::Vertex_index(2)), Point(5, 5, 5));
}
