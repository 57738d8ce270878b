// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The common subdivision of a surface and a triangulation with inserted vertices: places, areas, transfer, point
// location.

#include "insert_random_vertices.h"
#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Laplace_Beltrami.h>
#include <CGAL/Intrinsic_triangulations/Point_location.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/surface_mesh_adaptors.h>
#include <CGAL/Intrinsic_triangulations/refine_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/transfer.h>
#include <CGAL/Intrinsic_triangulations/transfer_matrices.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;
using Point = std::array<double, 3>;

Triangulation with_inserted_vertices(const samples::Indexed_triangles& surface, std::size_t number,
                                     unsigned largest_coordinate)
{
  Triangulation triangulation(IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles),
                              surface.points);
  IT::flip_to_Delaunay(triangulation);
  std::mt19937 random(7);
  EXPECT_GT(IT::insert_random_vertices(triangulation, number, largest_coordinate, random), number / 5);
  return triangulation;
}

std::vector<samples::Indexed_triangles> flat_surfaces()
{
  return {samples::sheared_grid(), samples::random_diagonal_grid(), samples::strip(200, 30)};
}

std::vector<samples::Indexed_triangles> curved_surfaces()
{
  return {samples::torus(20, 12),     samples::bad_torus(20, 20), samples::bumpy_dome(),
          samples::disk_with_spike(), samples::Schwarz_lantern(), samples::cap(),
          samples::prism(),           samples::pillow(60),        samples::helical_tube()};
}

double distance(const Point& p, const Point& q) { return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]); }

Point point_of(const IT::Delta_complex& complex, const std::vector<Point>& points, const IT::Surface_point& point)
{
  Point result{};
  IT::Halfedge_index h = point.halfedge;
  for (double x : point.coordinates) {
    for (std::size_t i = 0; i < 3; ++i)
      result[i] += x * points[complex.source(h).idx()][i];
    h = complex.next(h);
  }
  return result;
}

IT::Surface_point random_point(const IT::Delta_complex& complex, std::mt19937& random)
{
  IT::Surface_point point;
  do
    point.halfedge = IT::Halfedge_index(std::uint32_t(random() % complex.number_of_halfedges()));
  while (complex.is_border(point.halfedge));
  double sum = 0;
  for (double& x : point.coordinates)
    sum += x = 1 + random() % (random() % 2 == 0 ? 5 : 1000000);
  if (random() % 4 == 0) {
    double& x = point.coordinates[random() % 3];
    sum -= x;
    x = 0;
  }
  for (double& x : point.coordinates)
    x /= sum;
  return point;
}

// In a plane, both triangulations interpolate coordinates to the same points.
TEST(Inserted_vertices, lie_where_both_triangulations_say)
{
  for (const samples::Indexed_triangles& surface : flat_surfaces()) {
    const Triangulation triangulation = with_inserted_vertices(surface, 500, 6);
    const IT::Common_subdivision subdivision(triangulation);
    const IT::Overlay& overlay = subdivision.overlay();
    std::vector<Point> points;
    for (std::uint32_t v = 0; v < overlay.number_of_original_vertices(); ++v)
      points.push_back(subdivision.point(IT::Overlay::Vertex(v), surface.points));
    std::vector<std::array<std::vector<double>, 2>> interpolated(3); // of each coordinate
    for (std::size_t i = 0; i < 3; ++i) {
      std::vector<double> in_input, in_intrinsic;
      for (const Point& p : surface.points)
        in_input.push_back(p[i]);
      for (const Point& p : points)
        in_intrinsic.push_back(p[i]);
      interpolated[i] = {IT::interpolate_input_values(subdivision, in_input),
                         IT::interpolate_intrinsic_values(subdivision, in_intrinsic)};
      const Eigen::Map<const Eigen::VectorXd> values(in_input.data(), Eigen::Index(in_input.size()));
      const Eigen::VectorXd by_matrix = IT::input_interpolation_matrix(subdivision) * values;
      for (std::size_t v = 0; v < overlay.number_of_vertices(); ++v)
        ASSERT_NEAR(by_matrix[Eigen::Index(v)], interpolated[i][0][v], 1e-12);
    }
    for (IT::Overlay::Vertex v : overlay.vertices()) {
      const Point p = subdivision.point(v, surface.points);
      for (std::size_t i = 0; i < 3; ++i)
        for (const std::vector<double>& values : interpolated[i])
          ASSERT_NEAR(values[v.idx()], p[i], 1e-10);
    }
    for (IT::Edge_index e : subdivision.intrinsic().edges()) {
      const IT::Halfedge_index h = subdivision.intrinsic().halfedge(e);
      ASSERT_NEAR(triangulation.length(e) / distance(points[subdivision.intrinsic().source(h).idx()],
                                                     points[subdivision.intrinsic().target(h).idx()]),
                  1, 1e-11);
    }
  }
}

void expect_same_areas(const Triangulation& triangulation, const IT::Common_subdivision& subdivision)
{
  const IT::internal::Areas_in_both areas(subdivision);
  std::vector<double> input(areas.input.size(), 0), intrinsic(areas.intrinsic.size(), 0);
  const std::vector<double> pieces = IT::face_areas(subdivision);
  for (IT::Overlay::Face f : subdivision.overlay().faces()) {
    input[subdivision.overlay().input_face(f).idx()] += pieces[f.idx()];
    intrinsic[subdivision.overlay().intrinsic_face(f).idx()] += pieces[f.idx()];
  }
  for (std::size_t f = 0; f < input.size(); ++f)
    ASSERT_NEAR(input[f], areas.input[f], 1e-12 * *std::max_element(areas.input.begin(), areas.input.end())) << f;
  for (std::size_t f = 0; f < intrinsic.size(); ++f) {
    ASSERT_NEAR(intrinsic[f], areas.intrinsic[f], 1e-12 * *std::max_element(areas.input.begin(), areas.input.end()))
      << f;
    ASSERT_DOUBLE_EQ(areas.intrinsic[f], triangulation.area(IT::Face_index(std::uint32_t(f))));
  }
}

TEST(Inserted_vertices, divide_areas)
{
  for (const samples::Indexed_triangles& surface : curved_surfaces())
    for (unsigned largest_coordinate : {3u, 1000u}) {
      const Triangulation triangulation = with_inserted_vertices(surface, 200, largest_coordinate);
      expect_same_areas(triangulation, IT::Common_subdivision(triangulation));
    }
}

// Points go there and back, and their neighbours' distances hold.
TEST(Inserted_vertices, leave_points_where_they_are)
{
  std::mt19937 random(5);
  for (const std::vector<samples::Indexed_triangles>& surfaces : {flat_surfaces(), curved_surfaces()})
    for (const samples::Indexed_triangles& surface : surfaces) {
      const Triangulation triangulation = with_inserted_vertices(surface, 300, 4);
      const IT::Common_subdivision subdivision(triangulation);
      const IT::Point_location location(subdivision);
      double size = 0;
      for (const Point& p : surface.points)
        size = std::max(size, distance(p, surface.points[0]));
      for (int i = 0; i < 2000; ++i) {
        const IT::Surface_point p = random_point(subdivision.input(), random);
        const IT::Surface_point q = location.intrinsic_to_input(location.input_to_intrinsic(p));
        ASSERT_LE(
          distance(point_of(subdivision.input(), surface.points, p), point_of(subdivision.input(), surface.points, q)),
          1e-12 * size);
      }
      std::vector<Point> points;
      for (std::uint32_t v = 0; v < subdivision.overlay().number_of_original_vertices(); ++v)
        points.push_back(subdivision.point(IT::Overlay::Vertex(v), surface.points));
      for (int i = 0; i < 2000; ++i) {
        const IT::Surface_point p = random_point(subdivision.intrinsic(), random);
        const IT::Surface_point q = location.intrinsic_to_input(p);
        const IT::Surface_point r = location.input_to_intrinsic(q);
        ASSERT_LE(distance(point_of(subdivision.input(), surface.points, q),
                           point_of(subdivision.input(), surface.points, location.intrinsic_to_input(r))),
                  1e-12 * size);
      }
    }
}

TEST(Inserted_vertices, are_found)
{
  for (const std::vector<samples::Indexed_triangles>& surfaces : {flat_surfaces(), curved_surfaces()})
    for (const samples::Indexed_triangles& surface : surfaces) {
      const Triangulation triangulation = with_inserted_vertices(surface, 200, 4);
      const IT::Common_subdivision subdivision(triangulation);
      const IT::Point_location location(subdivision);
      const IT::Delta_complex& complex = subdivision.intrinsic();
      const IT::internal::Correspondence& correspondence = IT::internal::engine(subdivision).correspondence();
      for (IT::Vertex_index v : complex.vertices())
        if (correspondence.is_inserted(v)) {
          const IT::Surface_point there = location.input_to_intrinsic(correspondence.location(v));
          ASSERT_EQ(there.dimension(), 0);
          ASSERT_EQ(complex.source(there.halfedge), v);
          const IT::Surface_point back = location.intrinsic_to_input(there);
          ASSERT_LE(distance(point_of(subdivision.input(), surface.points, back),
                             subdivision.point(IT::Overlay::Vertex(v.idx()), surface.points)),
                    1e-14);
        }
      // Points on edges that leave inserted vertices lie there in the input, too, and are known to.
      for (IT::Edge_index e : complex.edges()) {
        const IT::Halfedge_index h =
          complex.is_border(complex.halfedge(e)) ? complex.opposite(complex.halfedge(e)) : complex.halfedge(e);
        if (!correspondence.is_inserted(complex.source(h)) || correspondence.coordinates().number_of_crossings(e) != 0)
          continue;
        const IT::Surface_point middle = location.intrinsic_to_input({h, {0.5, 0.5, 0}});
        ASSERT_EQ(middle.dimension(), correspondence.coordinates().is_original(e) ? 1 : 2);
      }
    }
}

TEST(Inserted_vertices, are_refined_to)
{
  for (const samples::Indexed_triangles& surface :
       {samples::bad_torus(30, 30), samples::bumpy_dome(), samples::sheared_grid(), samples::prism(), samples::cap()}) {
    Triangulation triangulation(IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles),
                                surface.points);
    EXPECT_GT(IT::refine_Delaunay(triangulation).insertions, 0u);
    const IT::Common_subdivision subdivision(triangulation);
    expect_same_areas(triangulation, subdivision);
    const IT::Transfer_mass_matrices masses = IT::transfer_mass_matrices(subdivision);
    double area = 0;
    for (IT::Face_index f : triangulation.connectivity().faces())
      area += triangulation.area(f);
    EXPECT_NEAR(masses.mixed.sum() / area, 1, 1e-12);
    const auto projection = IT::L2_projection_to_intrinsic(masses);
    const Eigen::VectorXd ones = projection(Eigen::VectorXd::Ones(subdivision.input().number_of_vertices()).eval());
    EXPECT_NEAR(ones.minCoeff(), 1, 1e-10);
    EXPECT_NEAR(ones.maxCoeff(), 1, 1e-10);

    using Kernel_point = CGAL::Simple_cartesian<double>::Point_3;
    std::vector<Kernel_point> points;
    for (const Point& p : surface.points)
      points.emplace_back(p[0], p[1], p[2]);
    auto mesh = IT::overlay_to_surface_mesh(subdivision, points);
    EXPECT_TRUE(mesh.is_valid());
    EXPECT_EQ(mesh.number_of_vertices(), subdivision.overlay().number_of_vertices());
    IT::triangulate_overlay_faces(mesh);
    EXPECT_TRUE(CGAL::is_triangle_mesh(mesh));
  }
}

} // namespace
