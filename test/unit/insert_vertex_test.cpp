// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// New vertices: in faces and on edges, of flat and curved surfaces, among many others.

#include "insert_random_vertices.h"
#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/insert_vertex.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <CGAL/property_map.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

class Inserted_vertices
{
public:
  explicit Inserted_vertices(samples::Indexed_triangles surface)
    : surface_(std::move(surface)),
      input_(IT::make_Delta_complex_from_triangles(surface_.points.size(), surface_.triangles)),
      triangulation(input_, surface_.points)
  {
    area_ = area();
    IT::flip_to_Delaunay(triangulation);
  }

  double area() const
  {
    double sum = 0;
    for (IT::Face_index f : triangulation.connectivity().faces())
      sum += triangulation.area(f);
    return sum;
  }

  void expect_consistent(bool has_faces_without_area = false) const
  {
    const IT::Delta_complex& complex = triangulation.connectivity();
    ASSERT_TRUE(complex.is_valid());
    const IT::internal::Exact_engine& geometry = IT::internal::engine(triangulation);
    for (IT::Edge_index e : complex.edges()) {
      if (complex.is_flippable(e)) {
        ASSERT_NE(geometry.test(e, IT::internal::Exact_engine::Means::UNFOLDING)->sign, CGAL::NEGATIVE) << e;
      }
    }
    for (IT::Face_index f : complex.faces())
      ASSERT_GE(geometry.sign_of_area(f), has_faces_without_area ? CGAL::ZERO : CGAL::POSITIVE) << f;
    EXPECT_NEAR(area() / area_, 1, 1e-13);
  }

  // The position of a vertex in space.
  std::array<double, 3> position(IT::Vertex_index v) const
  {
    const IT::internal::Correspondence& correspondence = IT::internal::engine(triangulation).correspondence();
    if (!correspondence.is_inserted(v))
      return surface_.points[v.idx()];
    const IT::Surface_point& p = correspondence.location(v);
    const std::array<IT::Vertex_index, 3> corners{input_.source(p.halfedge), input_.target(p.halfedge),
                                                  input_.target(input_.next(p.halfedge))};
    const double sum = p.coordinates[0] + p.coordinates[1] + p.coordinates[2];
    std::array<double, 3> result{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        result[j] += p.coordinates[i] / sum * surface_.points[corners[i].idx()][j];
    return result;
  }

private:
  samples::Indexed_triangles surface_;
  IT::Delta_complex input_;
  double area_ = 0;

public:
  Triangulation triangulation;
};

TEST(Surface_point, has_coordinates_from_each_side_of_its_face)
{
  const samples::Indexed_triangles surface = samples::torus(6, 5);
  const IT::Delta_complex complex = IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles);
  const IT::Halfedge_index h = complex.halfedge(IT::Face_index(7));
  const IT::Surface_point point{h, {0.5, 0.25, 0.125}};
  using Coordinates = std::array<double, 3>;
  EXPECT_EQ(IT::coordinates_from(complex, point, h), (Coordinates{0.5, 0.25, 0.125}));
  EXPECT_EQ(IT::coordinates_from(complex, point, complex.next(h)), (Coordinates{0.25, 0.125, 0.5}));
  EXPECT_EQ(IT::coordinates_from(complex, point, complex.prev(h)), (Coordinates{0.125, 0.5, 0.25}));
}

TEST(Insert_vertex, lengths_in_a_plane_are_distances)
{
  std::mt19937 random(1);
  for (const samples::Indexed_triangles& surface :
       {samples::sheared_grid(), samples::random_diagonal_grid(), samples::strip(200, 30)}) {
    Inserted_vertices test(surface);
    EXPECT_GT(IT::insert_random_vertices(test.triangulation, 700, 6, random), 300u);
    test.expect_consistent();
    const IT::Delta_complex& complex = test.triangulation.connectivity();
    for (IT::Edge_index e : complex.edges()) {
      const auto p = test.position(complex.source(complex.halfedge(e))),
                 q = test.position(complex.target(complex.halfedge(e)));
      const double distance = std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
      EXPECT_NEAR(test.triangulation.length(e) / distance, 1, 1e-11);
    }
  }
}

TEST(Insert_vertex, of_curved_surfaces)
{
  std::mt19937 random(2);
  for (const samples::Indexed_triangles& surface :
       {samples::torus(), samples::bad_torus(30, 30), samples::bumpy_dome(), samples::disk_with_spike(),
        samples::Schwarz_lantern(), samples::cap(), samples::cap(0), samples::prism(), samples::pillow(60),
        samples::sliver_sheet(), samples::helical_tube()})
    for (unsigned largest_coordinate : {3u, 1000u}) {
      Inserted_vertices test(surface);
      EXPECT_GT(IT::insert_random_vertices(test.triangulation, 200, largest_coordinate, random), 50u);
      test.expect_consistent();
    }
}

// The angles around a vertex on the surface sum to 2 pi, or to pi on the border.
TEST(Insert_vertex, does_not_change_the_metric)
{
  std::mt19937 random(3);
  Inserted_vertices test(samples::bumpy_dome());
  IT::insert_random_vertices(test.triangulation, 300, 20, random);
  const IT::Delta_complex& complex = test.triangulation.connectivity();
  const IT::internal::Correspondence& correspondence = IT::internal::engine(test.triangulation).correspondence();
  for (IT::Vertex_index v : complex.vertices()) {
    if (!correspondence.is_inserted(v))
      continue;
    EXPECT_NEAR(IT::angle_defect(test.triangulation, v), 0, 1e-9) << v;
  }
}

// Vertices 2 and 4 lie on the edge from 0 to 1, in faces 3 and 4, which have no area and stay where that edge is on the
// border.
samples::Indexed_triangles triangle_over_flat_faces(bool is_closed_below)
{
  samples::Indexed_triangles result;
  result.points = {{{0, 0, 0}}, {{4, 0, 0}}, {{1, 0, 0}}, {{2, 3, 0}}, {{2, 0, 0}}, {{2, -3, 0}}};
  result.triangles = {{0, 2, 3}, {2, 4, 3}, {4, 1, 3}, {0, 4, 2}, {0, 1, 4}};
  if (is_closed_below)
    result.triangles.push_back({0, 5, 1});
  else
    result.points.pop_back();
  return result;
}

TEST(Insert_vertex, faces_without_area)
{
  std::mt19937 random(4);
  for (bool is_closed_below : {false, true})
    for (unsigned largest_coordinate : {1u, 3u, 1000u})
      for (int i = 0; i < 10; ++i) {
        Inserted_vertices test(triangle_over_flat_faces(is_closed_below));
        EXPECT_GE(IT::insert_random_vertices(test.triangulation, 30, largest_coordinate, random), 3u);
        test.expect_consistent(!is_closed_below);
      }
  Inserted_vertices test(triangle_over_flat_faces(false));
  const IT::Delta_complex input = test.triangulation.input();
  const auto insert = [&](std::uint32_t face, const std::array<double, 3>& coordinates) {
    IT::insert_vertex(test.triangulation, {input.halfedge(IT::Face_index(face)), coordinates});
  };
  for (std::uint32_t face : {3u, 4u})
    try {
      insert(face, {1, 1, 1});
      ADD_FAILURE() << "a vertex in a face without area";
    } catch (const IT::Invalid_point_error& error) {
      EXPECT_NE(std::string(error.what()).find("face " + std::to_string(face) + " of the input, which has zero area"),
                std::string::npos)
        << error.what();
    }
  const auto side_between = [&](std::uint32_t v, std::uint32_t w) {
    for (IT::Halfedge_index h : input.halfedges())
      if (!input.is_border(h) && input.source(h).idx() == v && input.target(h).idx() == w)
        return IT::Surface_point{h, {1, 2, 0}};
    return IT::Surface_point{};
  };
  EXPECT_THROW(IT::insert_vertex(test.triangulation, side_between(0, 1)), IT::Invalid_point_error); // on the border
  for (const auto& [v, w] : {std::pair(0u, 2u), std::pair(4u, 2u), std::pair(4u, 1u)})
    EXPECT_THROW(IT::insert_vertex(test.triangulation, side_between(v, w)), IT::Invalid_point_error);
  test.expect_consistent(true);
}

// Walks to a point can run in circles there.
TEST(Insert_vertex, where_the_triangulation_is_far_from_Delaunay)
{
  const std::vector<std::array<double, 3>> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.3, -0.4, 0.9}};
  const std::vector<std::array<std::uint32_t, 3>> triangles{{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
  const auto keeps_all =
    CGAL::parameters::edge_is_constrained_map(CGAL::Static_boolean_property_map<IT::Edge_index, true>());
  for (unsigned seed = 0; seed < 130; ++seed) {
    Triangulation t(IT::make_Delta_complex_from_triangles(4, triangles), points);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> weight(0.01, 1);
    const IT::Halfedge_index h = t.input().halfedge(IT::Face_index(0));
    for (int i = 0; i < 60; ++i) {
      const auto begin = std::chrono::steady_clock::now();
      t.set_interruption([&] { return std::chrono::steady_clock::now() - begin < std::chrono::seconds(10); });
      ASSERT_NO_THROW(IT::insert_vertex(t, {h, {weight(random), weight(random), weight(random)}}, keeps_all)) << seed;
      for (int k = 0; k < 20; ++k) {
        const IT::Edge_index e(random() % t.connectivity().number_of_edges());
        if (!t.is_input_edge(e) && t.connectivity().is_flippable(e))
          t.flip(e);
      }
    }
    const IT::internal::Exact_engine& engine = IT::internal::engine(t);
    for (IT::Face_index f : t.connectivity().faces())
      ASSERT_EQ(engine.sign_of_area(f), CGAL::POSITIVE) << seed;
  }
}

TEST(Insert_vertex, refuses_what_is_no_new_point)
{
  Inserted_vertices test(samples::torus(8, 6));
  const IT::Halfedge_index h(0);
  const auto refuses = [&](const std::array<double, 3>& coordinates) {
    EXPECT_THROW(IT::insert_vertex(test.triangulation, {h, coordinates}), IT::Invalid_point_error);
  };
  refuses({0, 0, 0});
  refuses({1, 0, 0});
  refuses({-1, 1, 1});
  refuses({1, 1, std::nan("")});
  const std::size_t n = test.triangulation.connectivity().number_of_vertices();
  EXPECT_EQ(IT::insert_vertex(test.triangulation, {h, {1, 1, 2}}).idx(), n);
  refuses({2, 2, 4});
  EXPECT_EQ(test.triangulation.connectivity().number_of_vertices(), n + 1);
}

} // namespace
