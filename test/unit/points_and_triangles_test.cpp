// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Arrays of points and triangles of any types give the same results as a mesh, and files become such arrays.

#include "Surface_file_test.h"
#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/intrinsic_Delaunay_triangulation.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/polygon_soup.h>
#include <CGAL/Intrinsic_triangulations/verify_Delaunay.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <list>
#include <string>
#include <vector>

namespace {

typedef Surface_file_test Points_and_triangles;
typedef CGAL::Simple_cartesian<double>::Point_3 Point;
typedef CGAL::Exact_predicates_exact_constructions_kernel Exact_kernel;
typedef std::vector<std::array<double, 3>> Points;
typedef std::vector<std::array<std::uint32_t, 3>> Triangles;

template <class Triangulation>
std::vector<std::array<double, 3>> edges(const Triangulation& triangulation)
{
  std::vector<std::array<double, 3>> result;
  const IT::Delta_complex& complex = triangulation.connectivity();
  for (IT::Edge_index e : complex.edges()) {
    const IT::Halfedge_index h = complex.halfedge(e);
    result.push_back({double(complex.source(h).idx()), double(complex.target(h).idx()), triangulation.length(e)});
  }
  return result;
}

TEST_F(Points_and_triangles, whose_lengths_round_are_not_verified_without_the_input)
{
  const samples::Indexed_triangles sample = samples::prism(6, 1);
  const auto rounded = CGAL::parameters::geom_traits(IT::Edge_length_traits<double>());
  auto t = IT::intrinsic_triangulation(sample.points, sample.triangles, rounded);
  EXPECT_THROW(IT::verify_Delaunay(t), IT::Invalid_argument_error);
  t.keep_input(IT::Input_metric::from_points({sample.points.begin(), sample.points.end()}));
  EXPECT_NO_THROW(IT::verify_Delaunay(t));
}

TEST_F(Points_and_triangles, give_what_a_mesh_gives)
{
  const samples::Indexed_triangles sample = samples::bumpy_dome();
  CGAL::Surface_mesh<Point> mesh;
  std::list<Point> points; // no random access
  std::vector<std::vector<int>> triangles;
  for (const auto& p : sample.points) {
    mesh.add_vertex(Point(p[0], p[1], p[2]));
    points.emplace_back(p[0], p[1], p[2]);
  }
  typedef CGAL::Surface_mesh<Point>::Vertex_index Vertex;
  for (const auto& t : sample.triangles) {
    mesh.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2]));
    triangles.push_back({int(t[0]), int(t[1]), int(t[2])});
  }
  const auto from_mesh = IT::intrinsic_Delaunay_triangulation(mesh);
  const auto from_arrays = IT::intrinsic_Delaunay_triangulation(sample.points, sample.triangles);
  const auto from_others = IT::intrinsic_Delaunay_triangulation<CGAL::Parallel_if_available_tag>(points, triangles);
  EXPECT_GT(from_arrays.report.flips, 0u);
  EXPECT_EQ(from_arrays.report.flips, from_mesh.report.flips);
  EXPECT_EQ(edges(from_arrays.triangulation), edges(from_mesh.triangulation));
  EXPECT_EQ(edges(from_others.triangulation), edges(from_mesh.triangulation));
  EXPECT_TRUE(IT::verify_Delaunay(from_arrays.triangulation).is_Delaunay());
  EXPECT_EQ(edges(IT::intrinsic_triangulation(sample.points, sample.triangles)),
            edges(IT::intrinsic_triangulation(mesh)));
}

// A corner of a square was moved towards the diagonal by 10^-30, of which nothing is left in a double.
TEST_F(Points_and_triangles, may_be_rational)
{
  const Exact_kernel::FT small = Exact_kernel::FT(1) / Exact_kernel::FT(1e30);
  const std::vector<Exact_kernel::Point_3> points = {{1, 1, 0}, {2 - small, 1 + small, 0}, {2, 2, 0}, {1, 2, 0}};
  const Triangles triangles = {{{0, 1, 2}}, {{0, 2, 3}}};
  EXPECT_EQ(IT::intrinsic_Delaunay_triangulation(points, triangles).report.flips, 1u);
  Points rounded;
  for (const auto& p : points)
    rounded.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
  EXPECT_EQ(IT::intrinsic_Delaunay_triangulation(rounded, triangles).report.flips, 0u);
}

TEST_F(Points_and_triangles, named_parameters)
{
  const Points points = {{{0, 0, 0}}, {{4, 0, 0}}, {{2, 1, 0}}, {{2, 0, 1}}};
  const Triangles triangles = {{{0, 1, 2}}, {{1, 0, 3}}};
  const IT::Delta_complex complex = IT::make_Delta_complex_from_triangles(points.size(), triangles);
  std::vector<bool> flags(complex.number_of_edges(), false);
  flags[0] = true; // the first side of the first face
  const IT::internal::Edge_flags constraints{flags};
  const auto free = IT::intrinsic_Delaunay_triangulation(points, triangles);
  EXPECT_EQ(free.report.flips, 1u);
  EXPECT_DOUBLE_EQ(free.triangulation.length(IT::Edge_index(0)), 2);
  const auto constrained =
    IT::intrinsic_Delaunay_triangulation(points, triangles, CGAL::parameters::edge_is_constrained_map(constraints));
  EXPECT_EQ(constrained.report.flips, 0u);
  const auto rounded = IT::intrinsic_Delaunay_triangulation(
    points, triangles, CGAL::parameters::geom_traits(IT::Edge_length_traits<float>()));
  EXPECT_EQ(rounded.report.flips, 1u);
}

TEST_F(Points_and_triangles, errors_name_the_element)
{
  const Points points = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}};
  const double nan = std::nan("");
  struct Bad
  {
    Points points;
    Triangles triangles;
    Defect defect;
    const char* message;
  };
  const Bad table[] = {{points, {{{0, 1, 2}}, {{0, 2, 7}}}, Defect::BAD_INDEX, "face 1 names vertex 7"},
                       {points, {{{0, 1, 2}}, {{0, 2, 2}}}, Defect::REPEATED_CORNER, "face 1 has vertex 2"},
                       {points, {{{0, 1, 2}}, {{0, 1, 3}}}, Defect::INCONSISTENT_ORIENTATION, "edge 0-1 of face 1"},
                       {{points[0], points[1], {{0, nan, 0}}}, {{{0, 1, 2}}}, Defect::NOT_FINITE, "vertex 2"},
                       {{points[0], points[1], points[1]}, {{{0, 1, 2}}}, Defect::ZERO_LENGTH_EDGE, "1"}};
  for (const Bad& bad : table)
    try {
      IT::intrinsic_Delaunay_triangulation(bad.points, bad.triangles);
      ADD_FAILURE() << bad.message;
    } catch (const IT::Invalid_surface_error& error) {
      EXPECT_EQ(static_cast<int>(error.defect()), static_cast<int>(bad.defect)) << error.what();
      EXPECT_TRUE(contains(error.what(), bad.message)) << error.what();
    }
}

TEST_F(Points_and_triangles, come_from_files)
{
  const std::string off = write("a.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n");
  Points points;
  Triangles triangles;
  IT::read_triangles(off, points, triangles);
  ASSERT_EQ(points.size(), 4u);
  EXPECT_EQ(triangles, (Triangles{{{0, 1, 2}}, {{0, 2, 3}}}));
  std::list<Point> others(7);
  std::vector<std::vector<int>> other_triangles;
  IT::read_triangles(off, others, other_triangles);
  EXPECT_EQ(others.size(), 4u);
  EXPECT_EQ(others.back(), Point(0, 1, 0));
  EXPECT_EQ(other_triangles, (std::vector<std::vector<int>>{{0, 1, 2}, {0, 2, 3}}));

  const std::string quadrangle = write("b.off", "OFF\n4 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n4 0 1 2 3\n2 0 1\n");
  try {
    IT::read_triangles(quadrangle, points, triangles);
    ADD_FAILURE();
  } catch (const IT::Invalid_surface_error& error) {
    EXPECT_EQ(error.what(), quadrangle + ": face 1 is not a triangle (2 such faces); triangulate the faces first");
    EXPECT_EQ(error.element(), 1u);
    EXPECT_EQ(error.count(), 2u);
  }
  EXPECT_EQ(triangles.size(), 2u);
  const IT::Polygon_soup soup = IT::read_polygon_soup(quadrangle);
  EXPECT_EQ(soup.first_corner, (std::vector<std::size_t>{0, 3, 7, 9}));
  EXPECT_EQ(soup.polygons()[1].size(), 4u);
  EXPECT_EQ(soup.polygon(2).begin()[1], 1u);
  EXPECT_THROW(IT::read_polygon_soup(path("none.off")), IT::Invalid_surface_error);
  EXPECT_THROW(IT::read_polygon_soup(write("a.gluing", "INTRINSIC_GLUING 1\n")), IT::Invalid_surface_error);
}

} // namespace
