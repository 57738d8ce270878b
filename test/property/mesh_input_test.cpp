// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every kind of mesh and kernel leads to the same triangulation, and each named parameter has its effect.

#include "property/flip_test_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/intrinsic_Delaunay_triangulation.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/verify_Delaunay.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/property_map.h>

#include <boost/core/ref.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

namespace {

using namespace test_surfaces;
using Double_traits = IT::Edge_length_traits<double>;

template <class Kernel_, class Mesh_>
struct Input
{
  using Kernel = Kernel_;
  using Mesh = Mesh_;
};
template <class Kernel>
using Surface_mesh_of = Input<Kernel, CGAL::Surface_mesh<typename Kernel::Point_3>>;
template <class Kernel>
using Polyhedron_of = Input<Kernel, CGAL::Polyhedron_3<Kernel>>;

using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Exact_with_sqrt = CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt;
using Cartesian = CGAL::Simple_cartesian<double>;
using Inputs = testing::Types<Surface_mesh_of<Inexact>, Surface_mesh_of<Exact>, Surface_mesh_of<Exact_with_sqrt>,
                              Surface_mesh_of<Cartesian>, Polyhedron_of<Inexact>, Polyhedron_of<Exact>,
                              Polyhedron_of<Exact_with_sqrt>, Polyhedron_of<Cartesian>>;

template <class Input>
typename Input::Mesh mesh_of(const samples::Indexed_triangles& triangles)
{
  std::vector<typename Input::Kernel::Point_3> points;
  for (const std::array<double, 3>& p : triangles.points)
    points.emplace_back(p[0], p[1], p[2]);
  std::vector<std::vector<std::size_t>> polygons;
  for (const auto& t : triangles.triangles)
    polygons.push_back({t[0], t[1], t[2]});
  typename Input::Mesh mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, polygons, mesh);
  return mesh;
}

const samples::Indexed_triangles& sphere()
{
  static const samples::Indexed_triangles triangles = samples::bumpy_sphere(20, 11);
  return triangles;
}

// The reference, which needs no mesh and no kernel.
std::vector<Edge_record> expected_edges(const samples::Indexed_triangles& triangles)
{
  IT::Intrinsic_triangulation<Double_traits> t(
    IT::make_Delta_complex_from_triangles(triangles.points.size(), triangles.triangles), triangles.points);
  IT::flip_to_Delaunay(t);
  return edge_records(t);
}

template <class Input>
class Mesh_input : public testing::Test
{};
TYPED_TEST_SUITE(Mesh_input, Inputs);

struct Counter
{
  bool go_further(const IT::Progress& progress) { return (tests = progress.tests) < limit; }
  void after_flip(IT::Edge_index) { ++flips; }
  std::uint64_t limit = 1000000;
  std::uint64_t flips = 0, tests = 0;
};

// The exact traits, except for coordinates with square roots, whose exact type is too slow here.
template <class TypeParam>
using Test_traits = std::conditional_t<
  std::is_same<typename TypeParam::Kernel::FT, CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt::FT>::value,
  Double_traits, IT::Filtered_edge_length_traits>;

template <class TypeParam>
auto test_traits()
{
  return CGAL::parameters::geom_traits(Test_traits<TypeParam>());
}

} // namespace

TYPED_TEST(Mesh_input, leads_to_the_same_triangulation)
{
  const auto mesh = mesh_of<TypeParam>(sphere());
  const auto [t, report] = IT::intrinsic_Delaunay_triangulation(mesh, CGAL::parameters::geom_traits(Double_traits()));
  EXPECT_EQ(report.status, IT::Flip_status::DELAUNAY);
  EXPECT_GT(report.flips, 100u);
  EXPECT_TRUE(are_same_edges(edge_records(t), expected_edges(sphere()), 1e-12));

  const auto filtered = IT::intrinsic_Delaunay_triangulation(mesh, test_traits<TypeParam>()).triangulation;
  EXPECT_TRUE(are_same_edges(edge_records(filtered), expected_edges(sphere()), 1e-12));

  // Elements keep the numbers that they have in the mesh.
  const auto unflipped = IT::intrinsic_triangulation(mesh, test_traits<TypeParam>());
  const IT::Delta_complex& c = unflipped.connectivity();
  std::vector<typename TypeParam::Kernel::Point_3> points;
  for (auto v : vertices(mesh))
    points.push_back(get(CGAL::vertex_point, mesh, v));
  IT::Edge_index e(0);
  for (auto edge : edges(mesh)) {
    const auto p = get(CGAL::vertex_point, mesh, source(edge, mesh)),
               q = get(CGAL::vertex_point, mesh, target(edge, mesh));
    EXPECT_EQ(points[c.source(c.halfedge(e)).idx()], p);
    EXPECT_EQ(points[c.target(c.halfedge(e)).idx()], q);
    EXPECT_NEAR(unflipped.squared_length(e), CGAL::to_double(CGAL::squared_distance(p, q)), 1e-15);
    e = IT::Edge_index(e.idx() + 1);
  }
  EXPECT_EQ(e.idx(), c.number_of_edges());
}

TYPED_TEST(Mesh_input, helical_tube_has_58_loops)
{
  const auto [t, report] =
    IT::intrinsic_Delaunay_triangulation(mesh_of<TypeParam>(samples::helical_tube()), test_traits<TypeParam>());
  const IT::Delta_complex& c = t.connectivity();
  EXPECT_EQ(report.status, IT::Flip_status::DELAUNAY);
  EXPECT_TRUE(c.is_valid(true));
  ASSERT_EQ(c.number_of_edges(), 174u);
  int loops = 0, self_glued = 0;
  for (IT::Edge_index e : c.edges()) {
    loops += c.is_loop(e);
    self_glued += c.is_self_glued(e);
    EXPECT_TRUE(t.is_locally_Delaunay(e));
    EXPECT_GE(t.cotangent_weight(e), 0);
  }
  EXPECT_EQ(loops, 58);
  EXPECT_EQ(self_glued, 2);
}

TYPED_TEST(Mesh_input, polygons_are_refused)
{
  std::vector<typename TypeParam::Kernel::Point_3> points;
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 40; ++x)
      points.emplace_back(x, y, x * y);
  const auto at = [](std::size_t x, std::size_t y) { return 40 * y + x; };
  std::vector<std::vector<std::size_t>> polygons{{at(0, 0), at(1, 0), at(0, 1)}, {at(1, 0), at(1, 1), at(0, 1)}};
  for (std::size_t y = 0; y < 39; ++y)
    for (std::size_t x = y == 0 ? 1 : 0; x < 39; ++x)
      polygons.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)});
  for (const std::size_t number_of_polygons : {polygons.size(), std::size_t(3)}) {
    polygons.resize(number_of_polygons);
    typename TypeParam::Mesh mesh;
    CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, polygons, mesh);
    try {
      IT::intrinsic_Delaunay_triangulation(mesh, test_traits<TypeParam>());
      FAIL();
    } catch (const IT::Invalid_surface_error& error) {
      EXPECT_EQ(error.defect(), IT::Invalid_surface_error::Defect::NOT_A_TRIANGLE);
      EXPECT_EQ(error.element(), 2u);
      EXPECT_EQ(error.count(), number_of_polygons - 2);
    }
  }
}

TYPED_TEST(Mesh_input, vertex_point_map_is_used)
{
  auto mesh = mesh_of<TypeParam>(sphere());
  using Point = typename TypeParam::Kernel::Point_3;
  using Vertex = typename boost::graph_traits<typename TypeParam::Mesh>::vertex_descriptor;
  // The mesh's own points do not form a surface.
  std::map<Vertex, Point> points;
  for (auto v : vertices(mesh)) {
    points.emplace(v, get(CGAL::vertex_point, mesh, v));
    put(CGAL::vertex_point, mesh, v, Point(0, 0, 0));
  }
  EXPECT_THROW(IT::intrinsic_Delaunay_triangulation(mesh, test_traits<TypeParam>()), IT::Invalid_surface_error);
  const auto t = IT::intrinsic_Delaunay_triangulation(
    mesh, test_traits<TypeParam>().vertex_point_map(
            boost::make_function_property_map<Vertex>([&](Vertex v) { return points.at(v); })));
  EXPECT_TRUE(are_same_edges(edge_records(t.triangulation), expected_edges(sphere()), 1e-12));
}

TYPED_TEST(Mesh_input, visitor_and_budget_arrive)
{
  const auto visitor = [](const auto& v) { return test_traits<TypeParam>().visitor(v); };
  const auto mesh = mesh_of<TypeParam>(sphere());
  Counter by_reference, by_value, by_boost_reference;
  const IT::Flip_report report = IT::intrinsic_Delaunay_triangulation(mesh, visitor(std::ref(by_reference))).report;
  EXPECT_EQ(by_reference.flips, report.flips);
  IT::intrinsic_Delaunay_triangulation(mesh, visitor(boost::ref(by_boost_reference)));
  EXPECT_EQ(by_boost_reference.flips, report.flips);
  IT::intrinsic_Delaunay_triangulation(mesh, visitor(by_value));
  EXPECT_EQ(by_value.flips, 0u); // a copy was told
  by_value.limit = 7;
  EXPECT_THROW(IT::intrinsic_Delaunay_triangulation(mesh, visitor(std::ref(by_value))), IT::Cancelled_error);
  EXPECT_EQ(by_value.tests, 7u);

  const auto stopped =
    IT::intrinsic_Delaunay_triangulation(mesh, test_traits<TypeParam>().maximum_number(std::uint64_t(3)));
  EXPECT_EQ(stopped.report.status, IT::Flip_status::BUDGET_EXHAUSTED);
  EXPECT_EQ(stopped.report.flips, 3u);
}

// Every third edge of the mesh, in the order of its range, is constrained.
template <class Mesh, class ConstraintMap>
void expect_constraints(const Mesh& mesh, const ConstraintMap& is_constrained)
{
  using Traits = IT::Filtered_edge_length_traits;
  const auto unflipped = IT::intrinsic_triangulation(mesh, CGAL::parameters::geom_traits(Traits()));
  auto expected = unflipped;
  const auto by_index =
    boost::make_function_property_map<IT::Edge_index>([](IT::Edge_index e) { return e.idx() % 3 == 0; });
  const IT::Flip_report expected_report =
    IT::flip_to_Delaunay(expected, CGAL::parameters::edge_is_constrained_map(by_index));
  const auto [t, report] = IT::intrinsic_Delaunay_triangulation(
    mesh, CGAL::parameters::edge_is_constrained_map(is_constrained).geom_traits(Traits()));
  EXPECT_EQ(report.status, IT::Flip_status::DELAUNAY);
  EXPECT_EQ(report.flips, expected_report.flips);
  EXPECT_EQ(t.connectivity(), expected.connectivity());
  EXPECT_TRUE(IT::is_Delaunay(t, CGAL::parameters::edge_is_constrained_map(by_index)));
  EXPECT_FALSE(IT::is_Delaunay(t));
  for (IT::Edge_index e : t.connectivity().edges())
    if (e.idx() % 3 == 0) {
      const IT::Halfedge_index h = t.connectivity().halfedge(e);
      EXPECT_EQ(t.connectivity().source(h), unflipped.connectivity().source(h));
      EXPECT_EQ(t.connectivity().target(h), unflipped.connectivity().target(h));
    }
}

TEST(Constrained_edges, of_a_surface_mesh)
{
  using Mesh = CGAL::Surface_mesh<Inexact::Point_3>;
  Mesh mesh = mesh_of<Surface_mesh_of<Inexact>>(sphere());
  const auto constrain = [&] {
    auto map = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_constrained", false).first;
    std::size_t number = 0;
    for (Mesh::Edge_index e : mesh.edges())
      map[e] = number++ % 3 == 0;
    return map;
  };
  expect_constraints(mesh, constrain());
  // With garbage, indices are not positions in the range.
  CGAL::Euler::remove_face(mesh.halfedge(Mesh::Face_index(3)), mesh);
  CGAL::Euler::remove_face(mesh.halfedge(Mesh::Face_index(2)), mesh);
  ASSERT_TRUE(mesh.has_garbage());
  ASSERT_NE(std::size_t(*std::prev(mesh.edges().end())), mesh.number_of_edges() - 1);
  expect_constraints(mesh, constrain());
}

TEST(Constrained_edges, of_a_polyhedron)
{
  using Mesh = CGAL::Polyhedron_3<Inexact>;
  using Edge = boost::graph_traits<Mesh>::edge_descriptor;
  Mesh mesh = mesh_of<Polyhedron_of<Inexact>>(sphere());
  const auto map = get(CGAL::dynamic_edge_property_t<bool>(), mesh);
  std::set<Edge> constrained;
  std::size_t number = 0;
  for (const Edge e : edges(mesh)) {
    put(map, e, number % 3 == 0);
    if (number++ % 3 == 0)
      constrained.insert(e);
  }
  expect_constraints(mesh, map);
  expect_constraints(mesh,
                     boost::make_function_property_map<Edge>([&](const Edge& e) { return constrained.count(e) != 0; }));
}

TEST(Constrained_edges, all_of_them)
{
  using Mesh = CGAL::Surface_mesh<Inexact::Point_3>;
  const Mesh mesh = mesh_of<Surface_mesh_of<Inexact>>(sphere());
  const auto [t, report] = IT::intrinsic_Delaunay_triangulation(
    mesh, CGAL::parameters::edge_is_constrained_map(CGAL::Static_boolean_property_map<Mesh::Edge_index, true>()));
  EXPECT_EQ(report.flips, 0u);
  EXPECT_EQ(report.status, IT::Flip_status::DELAUNAY);
}
