// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Straight triangles: their distance from the surface, by sampling; regions, lines and defects.

#include <CGAL/Intrinsic_triangulations/straight_mesh.h>
#include <CGAL/Intrinsic_triangulations/surface_mesh_adaptors.h>

#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/refine_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/surface_features.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_type_config.h>

#include <gtest/gtest.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Points = std::vector<std::array<double, 3>>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

struct Model
{
  Points points;
  Triangles triangles;

  IT::Delta_complex complex() const { return IT::make_Delta_complex_from_triangles(points.size(), triangles); }
  Triangulation triangulation() const { return Triangulation(complex(), points); }
};

Model box(double y, double z)
{
  return {{{0, 0, 0}, {1, 0, 0}, {0, y, 0}, {1, y, 0}, {0, 0, z}, {1, 0, z}, {0, y, z}, {1, y, z}},
          {{0, 2, 3},
           {0, 3, 1},
           {4, 5, 7},
           {4, 7, 6},
           {0, 1, 5},
           {0, 5, 4},
           {2, 6, 7},
           {2, 7, 3},
           {0, 4, 6},
           {0, 6, 2},
           {1, 3, 7},
           {1, 7, 5}}};
}

// A graph over a grid of n by n squares.
template <class Height>
Model graph(std::uint32_t n, const Height& height)
{
  Model result;
  for (std::uint32_t i = 0; i <= n; ++i)
    for (std::uint32_t j = 0; j <= n; ++j)
      result.points.push_back({double(i) / n, double(j) / n, height(double(i) / n, double(j) / n)});
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < n; ++j) {
      const std::uint32_t a = i * (n + 1) + j, b = a + n + 1;
      result.triangles.push_back({a, b, b + 1});
      result.triangles.push_back({a, b + 1, a + 1});
    }
  return result;
}

IT::Refinement_report refine(Triangulation& t, const std::vector<bool>& is_kept, double longest)
{
  const auto map = boost::make_function_property_map<IT::Edge_index, bool>(
    [&](IT::Edge_index e) { return e.idx() < is_kept.size() && is_kept[e.idx()]; });
  return IT::refine_Delaunay(
    t, CGAL::parameters::minimum_angle(25).maximum_edge_length(longest).edge_is_constrained_map(map));
}

// By the closest point of each triangle, from the definition of that point.
double distance(const std::array<double, 3>& from, const Points& points, const Triangles& triangles)
{
  const Kernel::Point_3 p(from[0], from[1], from[2]);
  double result = std::numeric_limits<double>::infinity();
  for (const auto& t : triangles) {
    std::array<Kernel::Point_3, 3> c;
    for (std::size_t i = 0; i < 3; ++i)
      c[i] = {points[t[i]][0], points[t[i]][1], points[t[i]][2]};
    for (std::size_t i = 0; i < 3; ++i)
      result = (std::min)(result, std::sqrt(CGAL::squared_distance(p, Kernel::Segment_3(c[i], c[(i + 1) % 3]))));
    const Kernel::Plane_3 plane(c[0], c[1], c[2]);
    const Kernel::Point_3 foot = plane.projection(p);
    const Kernel::Vector_3 normal = plane.orthogonal_vector();
    bool is_inside = true;
    for (std::size_t i = 0; i < 3; ++i)
      is_inside = is_inside && CGAL::cross_product(c[(i + 1) % 3] - c[i], foot - c[i]) * normal >= 0;
    if (is_inside)
      result = (std::min)(result, std::sqrt(CGAL::squared_distance(p, foot)));
  }
  return result;
}

double farthest_sample(const Points& points, const Triangles& triangles, const Points& others,
                       const Triangles& other_triangles)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  double result = 0;
  for (const auto& t : triangles)
    for (int sample = 0; sample < 4; ++sample) {
      double u = uniform(random), v = uniform(random);
      if (u + v > 1)
        u = 1 - u, v = 1 - v;
      std::array<double, 3> p{};
      for (std::size_t i = 0; i < 3; ++i)
        p[i] = (1 - u - v) * points[t[0]][i] + u * points[t[1]][i] + v * points[t[2]][i];
      result = (std::max)(result, distance(p, others, other_triangles));
    }
  return result;
}

} // namespace

TEST(Straight_mesh, of_an_unchanged_triangulation_is_the_input)
{
  const Model model = box(1, 1);
  const Triangulation t = model.triangulation();
  const IT::Straight_mesh mesh = IT::straight_mesh(IT::Common_subdivision(t), model.points);
  EXPECT_EQ(mesh.points, model.points);
  EXPECT_EQ(mesh.triangles.size(), 12u);
  EXPECT_EQ(mesh.deviation, 0);
  EXPECT_NEAR(mesh.minimum_angle, 45, 1e-12);
  EXPECT_TRUE(mesh.is_surface());
  EXPECT_EQ(message(mesh), "");
  EXPECT_EQ(mesh.number_of_regions, 1u);
  EXPECT_TRUE(mesh.marked_edges.empty());
  for (std::uint32_t f = 0; f < 12; ++f)
    EXPECT_EQ(mesh.input_faces[f], mesh.faces[f]);
}

// The long ridge of a roof is flipped away: its middle is at a distance of 1 from the other diagonal.
TEST(Straight_mesh, tells_how_far_it_is_away)
{
  const Model roof{{{0, -1, 0}, {2, 0, 1}, {0, 1, 0}, {-2, 0, 1}}, {{0, 1, 3}, {3, 1, 2}}};
  Triangulation t = roof.triangulation();
  IT::flip_to_Delaunay(t);
  const IT::Straight_mesh mesh = IT::straight_mesh(IT::Common_subdivision(t), roof.points);
  EXPECT_GE(mesh.deviation, 1);
  EXPECT_LT(mesh.deviation, 1 + 1e-13);
  EXPECT_NEAR(mesh.deviation_place[2], 1, 1e-15);
  EXPECT_EQ(mesh.number_of_regions, 1u);
  EXPECT_EQ(mesh.number_of_lines, 1u);
  EXPECT_EQ(mesh.marked_edges.size(), 4u);
}

TEST(Straight_mesh, is_as_near_as_it_says_in_both_directions)
{
  const Model model = graph(12, [](double x, double y) { return 0.3 * std::sin(9 * x) * std::cos(7 * y); });
  Triangulation t = model.triangulation();
  refine(t, {}, 0.3);
  const IT::Straight_mesh mesh = IT::straight_mesh(IT::Common_subdivision(t), model.points);
  ASSERT_TRUE(mesh.is_surface()) << message(mesh);
  const double there = farthest_sample(model.points, model.triangles, mesh.points, mesh.triangles),
               back = farthest_sample(mesh.points, mesh.triangles, model.points, model.triangles);
  EXPECT_LE(there, mesh.deviation);
  EXPECT_LE(back, mesh.deviation);
  EXPECT_GT((std::max)(there, back), mesh.deviation / 4);
}

TEST(Straight_mesh, has_the_regions_between_marked_edges_and_the_lines_around_them)
{
  const Model cube = box(1, 1);
  Triangulation t = cube.triangulation();
  const std::vector<bool> sharp = IT::sharp_edges(t.input(), cube.points, 30);
  refine(t, sharp, 0.3);
  const IT::Straight_mesh mesh = IT::straight_mesh(IT::Common_subdivision(t), cube.points, sharp);
  EXPECT_TRUE(mesh.is_surface());
  EXPECT_LT(mesh.deviation, 1e-13);
  EXPECT_EQ(mesh.number_of_regions, 6u);
  EXPECT_EQ(mesh.number_of_lines, 12u);
  std::vector<double> area(6), length(12);
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    std::array<Kernel::Point_3, 3> c;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& [x, y, z] = mesh.points[mesh.triangles[f][i]];
      c[i] = {x, y, z};
    }
    area[mesh.regions[f]] += std::sqrt(CGAL::squared_area(c[0], c[1], c[2]));
    EXPECT_EQ(mesh.input_faces[f].idx() / 2,
              mesh.input_faces[std::size_t(std::find(mesh.regions.begin(), mesh.regions.end(), mesh.regions[f]) -
                                           mesh.regions.begin())]
                  .idx() /
                2);
  }
  for (double a : area)
    EXPECT_NEAR(a, 1, 1e-12);
  for (std::size_t i = 0; i < mesh.marked_edges.size(); ++i) {
    const auto [a, b] = mesh.marked_edges[i];
    const auto &p = mesh.points[a], &q = mesh.points[b];
    length[mesh.lines[i]] += std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  }
  for (double l : length)
    EXPECT_NEAR(l, 1, 1e-12);
  // The same in a Surface_mesh.
  auto copy = IT::to_surface_mesh<Kernel::Point_3>(mesh);
  EXPECT_TRUE(copy.is_valid());
  EXPECT_EQ(copy.number_of_faces(), mesh.triangles.size());
  std::size_t on_lines = 0;
  const auto line = copy.add_property_map<CGAL::SM_Edge_index, std::uint32_t>("e:line").first;
  for (auto e : copy.edges())
    on_lines += line[e] < mesh.number_of_lines;
  EXPECT_EQ(on_lines, mesh.marked_edges.size());
}

// Two holes in a plate have lines of their own, although the same region lies beside them.
TEST(Straight_mesh, separates_the_lines_of_holes)
{
  Model plate = graph(7, [](double, double) { return 0.; });
  plate.triangles.erase(plate.triangles.begin() + 66, plate.triangles.begin() + 68);
  plate.triangles.erase(plate.triangles.begin() + 18, plate.triangles.begin() + 20);
  const Triangulation t = plate.triangulation();
  const IT::Straight_mesh mesh = IT::straight_mesh(IT::Common_subdivision(t), plate.points);
  EXPECT_EQ(mesh.number_of_lines, 3u);
  EXPECT_EQ(mesh.marked_edges.size(), 28u + 4 + 4);
}

// Edges run around a thin box.
TEST(Straight_mesh, names_what_makes_it_no_surface)
{
  const Model thin = box(0.1, 0.1);
  Triangulation t = thin.triangulation();
  refine(t, {}, 10);
  const IT::Straight_mesh mesh = IT::straight_mesh(IT::Common_subdivision(t), thin.points);
  EXPECT_FALSE(mesh.is_surface());
  EXPECT_FALSE(mesh.loops.empty());
  EXPECT_GT(mesh.triangles.size(), t.connectivity().number_of_faces()); // of the loops become triangles
  EXPECT_LE(farthest_sample(thin.points, thin.triangles, mesh.points, mesh.triangles), mesh.deviation);
  EXPECT_LE(farthest_sample(mesh.points, mesh.triangles, thin.points, thin.triangles), mesh.deviation);
  for (IT::Edge_index e : mesh.loops) {
    const IT::Halfedge_index h = t.connectivity().halfedge(e);
    EXPECT_EQ(t.connectivity().source(h), t.connectivity().target(h));
  }
  EXPECT_NE(message(mesh).find(" (at "), std::string::npos) << message(mesh);
}

TEST(Straight_mesh, tells_sharp_corners_from_other_thin_triangles)
{
  const Model fan{{{0, 0, 0}, {1, 0, 0}, {1, 0.05, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  Triangulation t = fan.triangulation();
  const IT::Straight_mesh mesh = IT::straight_mesh(IT::Common_subdivision(t), fan.points);
  EXPECT_EQ(mesh.thin_triangles, std::vector<std::uint32_t>{0});
  EXPECT_EQ(mesh.number_of_sharp_corners, 0u);
  std::vector<bool> is_marked(5, true);
  EXPECT_EQ(IT::straight_mesh(IT::Common_subdivision(t), fan.points, is_marked).number_of_sharp_corners, 1u);
  EXPECT_TRUE(IT::straight_mesh(IT::Common_subdivision(t), fan.points, {}, 1).thin_triangles.empty());
}

TEST(Straight_mesh, names_thin_triangles_before_sharp_corners)
{
  const Model fan{{{0, 0, 0}, {1, 0, 0}, {1, 0.05, 0}, {0, 1, 0}, {-0.05, 1, 0}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}};
  const Triangulation t = fan.triangulation();
  std::vector<bool> is_marked;
  for (IT::Edge_index e : t.connectivity().edges()) { // that from the first to the third vertex
    const IT::Halfedge_index h = t.connectivity().halfedge(e);
    is_marked.push_back(t.connectivity().source(h).idx() + t.connectivity().target(h).idx() == 2);
  }
  const IT::Straight_mesh mesh = IT::straight_mesh(IT::Common_subdivision(t), fan.points, is_marked);
  EXPECT_EQ(mesh.number_of_sharp_corners, 1u);
  EXPECT_EQ(mesh.thin_triangles, (std::vector<std::uint32_t>{2, 0}));
}

// Both directions, by sampling.
void expect_within(const Model& model, double deviation, std::size_t most_triangles)
{
  Triangulation t = model.triangulation();
  const IT::Refinement_report report =
    IT::refine_Delaunay(t, CGAL::parameters::minimum_angle(25).maximum_deviation(deviation));
  EXPECT_EQ(report.status, IT::Refinement_status::REFINED);
  EXPECT_EQ(report.insertions + report.segment_splits, t.connectivity().number_of_vertices() - model.points.size());
  const IT::Straight_mesh mesh = IT::straight_mesh(IT::Common_subdivision(t), model.points, {}, 10, deviation);
  EXPECT_TRUE(mesh.is_surface()) << message(mesh);
  EXPECT_TRUE(mesh.has_good_angles()) << mesh.minimum_angle;
  EXPECT_EQ(mesh.sufficient_deviation, 0);
  EXPECT_LE(mesh.deviation, deviation);
  EXPECT_LT(mesh.triangles.size(), most_triangles);
  if (mesh.triangles.size() * model.triangles.size() < 2000000) {
    EXPECT_LE(farthest_sample(model.points, model.triangles, mesh.points, mesh.triangles), mesh.deviation + 1e-15);
    EXPECT_LE(farthest_sample(mesh.points, mesh.triangles, model.points, model.triangles), mesh.deviation + 1e-15);
  }
}

TEST(Straight_mesh, comes_as_near_as_one_likes)
{
  const Model model = graph(12, [](double x, double y) { return 0.3 * std::sin(9 * x) * std::cos(7 * y); });
  expect_within(model, 0.02, 3000);
  expect_within(model, 0.005, 12000);
}

// Where a fold is kept, few triangles follow it at any distance.
TEST(Straight_mesh, follows_folds)
{
  const Model fold = graph(4, [](double x, double) { return std::abs(x - 0.5); });
  expect_within(fold, 0.001, 100);
  expect_within(box(1, 0.01), 0.001, 4000);
}

// Loops run around a spike: their faces become a rod, at any thickness.
TEST(Straight_mesh, keeps_spikes)
{
  for (double width : {0.1, 0.01, 1e-5}) {
    const Model spike{{{0, 0, 0}, {width, 0, 0}, {0, 0, width}, {0, 1, 0}},
                      {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
    expect_within(spike, 0.05, 2000);
  }
}

// After flips, the face around the tip is on both sides of an edge to keep.
TEST(Straight_mesh, keeps_folds_of_flipped_spikes)
{
  const Model spike{
    {{-1.9, -0.01, -0.06},
     {0.2, 0.01, 0.3},
     {-1.1, -0.02, 0.29},
     {0.6, 0.04, -0.07},
     {-1.6, 0.01, 0.02},
     {-1.2, -0.04, -0.01},
     {0.04, -0.03, 0.08}},
    {{5, 0, 3}, {2, 0, 5}, {4, 3, 0}, {4, 1, 3}, {4, 0, 2}, {4, 2, 1}, {6, 5, 3}, {6, 3, 1}, {6, 2, 5}, {6, 1, 2}}};
  Triangulation t = spike.triangulation();
  IT::flip_to_Delaunay(t);
  bool has_self_glued_edge = false;
  for (IT::Edge_index e : t.connectivity().edges())
    has_self_glued_edge = has_self_glued_edge || t.connectivity().is_self_glued(e);
  EXPECT_TRUE(has_self_glued_edge);
  IT::refine_Delaunay(t, CGAL::parameters::minimum_angle(25).maximum_deviation(0.05));
  EXPECT_LE(IT::straight_mesh(IT::Common_subdivision(t), spike.points, {}, 10, 0.05).deviation, 0.05);
}

// Refinement has left faces that bend too far.
TEST(Straight_mesh, says_how_far_it_is_where_it_is_too_far)
{
  const Model model = graph(12, [](double x, double y) { return 0.3 * std::sin(9 * x) * std::cos(7 * y); });
  Triangulation t = model.triangulation();
  IT::flip_to_Delaunay(t);
  const IT::Common_subdivision subdivision(t);
  const double deviation = IT::straight_mesh(subdivision, model.points).deviation;
  ASSERT_GT(deviation, 0.01);
  const IT::Straight_mesh mesh = IT::straight_mesh(subdivision, model.points, {}, 10, deviation / 100);
  EXPECT_GE(mesh.deviation, 0.9 * deviation);
  EXPECT_LE(farthest_sample(model.points, model.triangles, mesh.points, mesh.triangles), mesh.deviation);
}

// The folds of a cone of many facets form small corners at its tip.
TEST(Straight_mesh, has_good_angles_where_folds_meet)
{
  constexpr std::uint32_t n = 64;
  Model cone;
  for (std::uint32_t i = 0; i < n; ++i)
    cone.points.push_back({std::cos(i * 2 * CGAL_PI / n), std::sin(i * 2 * CGAL_PI / n), 0});
  cone.points.push_back({0, 0, 1});
  cone.points.push_back({0, 0, 0});
  for (std::uint32_t i = 0; i < n; ++i) {
    cone.triangles.push_back({i, (i + 1) % n, n});
    cone.triangles.push_back({(i + 1) % n, i, n + 1});
  }
  expect_within(cone, 0.001, 20000);
}

// A vertex just beside another one, as CAD programs leave them.
TEST(Straight_mesh, merges_what_is_thinner_than_the_deviation)
{
  Model plate = graph(4, [](double x, double y) { return 0.01 * x * y; });
  const auto extra = std::uint32_t(plate.points.size());
  const Triangles::iterator cut = plate.triangles.begin() + 12;
  const auto [a, b, c] = *cut;
  const auto &p = plate.points[a], &q = plate.points[b], &r = plate.points[c];
  plate.points.push_back({p[0] + 1e-5 * (q[0] - p[0]) + 1e-6 * (r[0] - p[0]),
                          p[1] + 1e-5 * (q[1] - p[1]) + 1e-6 * (r[1] - p[1]), p[2] + 1e-5});
  *cut = {a, b, extra};
  plate.triangles.push_back({b, c, extra});
  plate.triangles.push_back({c, a, extra});
  Triangulation t = plate.triangulation();
  IT::refine_Delaunay(t, CGAL::parameters::minimum_angle(25).minimum_size(1e-3));
  const IT::Common_subdivision subdivision(t);
  const IT::Straight_mesh before = IT::straight_mesh(subdivision, plate.points);
  EXPECT_GT(before.thin_triangles.size(), 0u);
  const double deviation = (std::max)(before.deviation, 1e-4) + 1e-4;
  const IT::Straight_mesh after = IT::straight_mesh(subdivision, plate.points, {}, 10, deviation);
  EXPECT_TRUE(after.is_surface());
  EXPECT_TRUE(after.thin_triangles.empty());
  EXPECT_LE(after.deviation, deviation);
  EXPECT_EQ(after.surface.number_of_border_edges, before.surface.number_of_border_edges);
  ASSERT_EQ(after.merged_vertices.size(), 1u);
  EXPECT_EQ(after.points.size(), before.points.size() - 1);
  EXPECT_EQ(after.points_of_vertices[a], after.points_of_vertices[extra]);
  EXPECT_LE(farthest_sample(plate.points, plate.triangles, after.points, after.triangles), after.deviation);
  EXPECT_LE(farthest_sample(after.points, after.triangles, plate.points, plate.triangles), after.deviation);
}

// A corner of a triangle just beside its longest side, inside or on the border.
TEST(Straight_mesh, bends_long_sides_to_corners_near_them)
{
  const Model caps{{{0, 0, 0}, {1, 0, 0}, {0.5, 1e-5, 0}, {0.5, -1, 0}, {0.5, 1, 0}},
                   {{0, 1, 2}, {1, 0, 3}, {1, 4, 2}, {4, 0, 2}}};
  const Model border{caps.points, {{0, 1, 2}, {1, 4, 2}, {4, 0, 2}}};
  for (const Model& model : {caps, border}) {
    const Triangulation t = model.triangulation();
    const IT::Common_subdivision subdivision(t);
    std::vector<bool> is_marked; // the longest side
    for (IT::Edge_index e : t.input().edges())
      is_marked.push_back(t.length(e) == 1);
    std::vector<bool> is_fixed(5);
    is_fixed[2] = true;
    const IT::Straight_mesh mesh = IT::straight_mesh(subdivision, model.points, is_marked, 10, 1e-4, is_fixed);
    EXPECT_TRUE(mesh.is_surface()) << message(mesh);
    EXPECT_GT(mesh.minimum_angle, 20);
    EXPECT_EQ(mesh.triangles.size(), model.triangles.size() == 4 ? 4u : 2u);
    EXPECT_GE(mesh.deviation, 1e-5 * (1 - 1e-9));
    EXPECT_LE(mesh.deviation, 1e-4);
    EXPECT_LE(farthest_sample(model.points, model.triangles, mesh.points, mesh.triangles), mesh.deviation);
    const auto has = [&](std::uint32_t v, std::uint32_t w) {
      return std::count(mesh.marked_edges.begin(), mesh.marked_edges.end(), std::array<std::uint32_t, 2>{v, w}) == 1;
    };
    EXPECT_TRUE(has(0, 2) && has(1, 2) && !has(0, 1));
    is_fixed[0] = is_fixed[1] = true;
    EXPECT_EQ(IT::straight_mesh(subdivision, model.points, {}, 10, 1e-4, is_fixed).thin_triangles.size(), 1u);
  }
}

// Two triangles on another surface are no such piece.
TEST(Straight_mesh, leaves_patches_along_others)
{
  Model cube = box(1, 1);
  const double z = 1 + 1e-6;
  cube.points.insert(cube.points.end(), {{0.3, 0.3, z}, {0.5, 0.3, z}, {0.5, 0.5, z}, {0.3, 0.5, z}});
  cube.triangles.insert(cube.triangles.end(), {{8, 9, 10}, {8, 10, 11}});
  const IT::Straight_mesh mesh =
    IT::straight_mesh(IT::Common_subdivision(cube.triangulation()), cube.points, {}, 10, 0.02);
  EXPECT_EQ(mesh.triangles.size(), 14u);
  EXPECT_EQ(mesh.sufficient_deviation, 0);
}

// A kite of two sides that coincide after a flip, and a needle: above a cube, or on it.
TEST(Straight_mesh, leaves_out_pieces_along_others)
{
  for (double height : {1e-6, 0.5}) {
    Model cube = box(1, 1);
    const double z = 1 + height;
    cube.points.insert(cube.points.end(), {{0.3, 0.5, z}, {0.5, 0.4, z}, {0.7, 0.5, z}, {0.5, 0.6, z}});
    cube.triangles.insert(cube.triangles.end(), {{8, 9, 11}, {9, 10, 11}, {8, 10, 9}, {8, 11, 10}});
    cube.points.insert(cube.points.end(), {{0.2, 0.1, z}, {0.8, 0.1, z}, {0.2, 0.1 + 1e-6, z}, {0.2, 0.1, z + 1e-6}});
    cube.triangles.insert(cube.triangles.end(), {{12, 14, 13}, {12, 13, 15}, {13, 14, 15}, {14, 12, 15}});
    Triangulation t = cube.triangulation();
    IT::flip_to_Delaunay(t);
    const IT::Common_subdivision subdivision(t);
    const IT::Straight_mesh before = IT::straight_mesh(subdivision, cube.points);
    EXPECT_EQ(before.multiple_edges.size(), 1u);
    EXPECT_FALSE(before.is_surface());
    const IT::Straight_mesh mesh = IT::straight_mesh(subdivision, cube.points, {}, 10, 0.02);
    if (height < 0.1) {
      EXPECT_TRUE(mesh.is_surface()) << message(mesh);
      EXPECT_EQ(mesh.number_of_removed_pieces, 3u);
      EXPECT_EQ(mesh.triangles.size(), 12u);
      EXPECT_EQ(mesh.points.size(), 8u);
      EXPECT_EQ(mesh.merged_vertices.size(), 8u);
      EXPECT_GE(mesh.deviation, 1e-6);
      EXPECT_LE(mesh.deviation, 0.02);
      EXPECT_LE(farthest_sample(cube.points, cube.triangles, mesh.points, mesh.triangles), mesh.deviation);
    } else {
      EXPECT_EQ(mesh.number_of_removed_pieces, 0u);
      EXPECT_EQ(mesh.number_of_rods, 1u);
      EXPECT_FALSE(mesh.is_good());
      EXPECT_GT(mesh.sufficient_deviation, 0.02);
      EXPECT_LT(mesh.sufficient_deviation, 1);
      EXPECT_TRUE(IT::straight_mesh(subdivision, cube.points, {}, 10, mesh.sufficient_deviation).is_good());
    }
  }
}

// A hair on a cube, thinner than anything, but long.
TEST(Straight_mesh, cuts_thin_tubes_and_makes_rods_of_wires)
{
  constexpr double thickness = 1e-7;
  Model cube = box(1, 1);
  cube.triangles.erase(cube.triangles.begin() + 2, cube.triangles.begin() + 4); // the upper side
  cube.points.insert(cube.points.end(),
                     {{0.5, 0.5, 1}, {0.5 + thickness, 0.5, 1}, {0.5, 0.5 + thickness, 1}, {0.5, 0.5, 1.2}});
  const Triangles upper{{4, 5, 9}, {4, 9, 8},  {5, 7, 9},  {7, 10, 9},  {7, 6, 10},
                        {6, 4, 8}, {6, 8, 10}, {8, 9, 11}, {9, 10, 11}, {10, 8, 11}};
  cube.triangles.insert(cube.triangles.end(), upper.begin(), upper.end());
  const IT::Common_subdivision subdivision(cube.triangulation());
  EXPECT_LT(IT::straight_mesh(subdivision, cube.points).minimum_angle, 1e-3);
  const IT::Straight_mesh mesh = IT::straight_mesh(subdivision, cube.points, {}, 10, 0.01);
  EXPECT_TRUE(mesh.is_good()) << message(mesh) << mesh.minimum_angle;
  EXPECT_EQ(mesh.number_of_rods, 1u);
  EXPECT_EQ(mesh.surface.number_of_border_edges, 0u);
  EXPECT_EQ(mesh.surface.number_of_components, 2u);
  EXPECT_EQ(mesh.number_of_new_components, 1u);
  EXPECT_GT(mesh.minimum_angle, 25);
  EXPECT_LE(mesh.deviation, 0.01);
  EXPECT_LE(farthest_sample(cube.points, cube.triangles, mesh.points, mesh.triangles), mesh.deviation);
  const double back = farthest_sample(mesh.points, mesh.triangles, cube.points, cube.triangles);
  EXPECT_LE(back, mesh.deviation);
  EXPECT_GT(back, 0.003); // the rod has that thickness
}

// A wire of many short parts, each thinner and shorter than the deviation.
TEST(Straight_mesh, makes_one_rod_of_a_wire_that_came_apart)
{
  constexpr std::uint32_t sides = 12, parts = 30;
  constexpr double radius = 0.01, length = 3, deviation = 0.1;
  Model wire;
  for (std::uint32_t k = 0; k <= parts; ++k)
    for (std::uint32_t i = 0; i < sides; ++i) {
      const double angle = 2 * CGAL_PI * (i + 0.5 * (k % 2)) / sides;
      wire.points.push_back({radius * std::cos(angle), radius * std::sin(angle), length * k / parts});
    }
  for (std::uint32_t k = 0; k <= parts; ++k)
    for (std::uint32_t i = 0; i < sides; ++i) {
      const std::uint32_t v = sides * k + i, w = sides * k + (i + 1) % sides;
      if (k < parts) {
        wire.triangles.push_back({v, w, v + sides});
        wire.triangles.push_back({w, w + sides, v + sides});
      }
      if (i > 0 && i + 1 < sides && (k == 0 || k == parts))
        wire.triangles.push_back(k == 0 ? Triangles::value_type{0, w, v} : Triangles::value_type{sides * k, v, w});
    }
  const IT::Straight_mesh mesh =
    IT::straight_mesh(IT::Common_subdivision(wire.triangulation()), wire.points, {}, 10, deviation);
  EXPECT_TRUE(mesh.is_good()) << message(mesh) << mesh.minimum_angle;
  EXPECT_EQ(mesh.number_of_rods, 1u);
  EXPECT_EQ(mesh.surface.number_of_components, 1u);
  EXPECT_EQ(mesh.number_of_new_components, 0u);
  EXPECT_LE(mesh.deviation, deviation);
  EXPECT_LE(farthest_sample(wire.points, wire.triangles, mesh.points, mesh.triangles), mesh.deviation);
  EXPECT_LE(farthest_sample(mesh.points, mesh.triangles, wire.points, wire.triangles), mesh.deviation);
}

// A block with a sheet of material beside it, or with a gap in it: a polygon along which a segment moves. Films go, and
// the block stays.
TEST(Straight_mesh, leaves_films_out)
{
  for (double end : {2., 0.4, 18., 21.}) // beside the block, in it, or far beside it
    for (double thickness : {1e-7, end > 20 ? 5e-4 : 1e-5}) {
      const double low = 0.5, high = low + thickness;
      Model model;
      for (double z : {0., 1.})
        model.points.insert(
          model.points.end(),
          {{0, 0, z}, {1, 0, z}, {1, low, z}, {end, low, z}, {end, high, z}, {1, high, z}, {1, 1, z}, {0, 1, z}});
      for (std::uint32_t v = 0; v < 8; ++v) {
        const std::uint32_t w = (v + 1) % 8;
        model.triangles.push_back({v, w, w + 8});
        model.triangles.push_back({v, w + 8, v + 8});
      }
      const bool is_gap = end < 1;
      const Triangles side = is_gap ? Triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 7}, {3, 4, 7}, {4, 5, 6}, {4, 6, 7}}
                                    : Triangles{{0, 1, 2}, {0, 2, 5}, {0, 5, 7}, {5, 6, 7}, {2, 3, 4}, {2, 4, 5}};
      for (const auto& [a, b, c] : side) {
        model.triangles.push_back({a, c, b});
        model.triangles.push_back({a + 8, b + 8, c + 8});
      }
      const double deviation = end > 20 ? 0.001 : end > 2 ? 0.05 : 0.01;
      Triangulation t = model.triangulation();
      const std::vector<bool> sharp = IT::sharp_edges(t.input(), model.points, 30);
      const auto is_sharp = boost::make_function_property_map<IT::Edge_index, bool>(
        [&](IT::Edge_index e) { return e.idx() < sharp.size() && sharp[e.idx()]; });
      IT::refine_Delaunay(t, CGAL::parameters::minimum_angle(25)
                               .maximum_edge_length(end > 2 ? 2 : 0.2)
                               .minimum_size(0.02)
                               .edge_is_constrained_map(is_sharp));
      const IT::Straight_mesh mesh = IT::straight_mesh(IT::Common_subdivision(t), model.points, sharp, 10, deviation);
      EXPECT_TRUE(mesh.can_be_filled()) << mesh.folded_edges.size() << ' ' << mesh.crossing_triangles.size();
      EXPECT_TRUE(mesh.is_good()) << message(mesh) << mesh.minimum_angle;
      EXPECT_EQ(mesh.surface.number_of_components, 1u);
      EXPECT_NEAR(mesh.area_of_films, std::abs(end - 1), 0.1 * (std::max)(1., std::abs(end - 1)));
      EXPECT_LE(mesh.deviation, deviation);
      EXPECT_LE(farthest_sample(mesh.points, mesh.triangles, model.points, model.triangles), mesh.deviation);
      double volume = 0;
      for (const auto& [a, b, c] : mesh.triangles)
        volume +=
          IT::internal::scalar_product(mesh.points[a], IT::internal::cross_product(mesh.points[b], mesh.points[c])) / 6;
      EXPECT_NEAR(volume, 1, 6 * deviation);
    }
}

TEST(Straight_mesh, keeps_isolated_vertices)
{
  Model cube = box(1, 1);
  cube.points.push_back({5, 5, 5});
  const IT::Common_subdivision subdivision(cube.triangulation());
  for (double deviation : {0., 0.01}) {
    const IT::Straight_mesh mesh = IT::straight_mesh(subdivision, cube.points, {}, 10, deviation);
    EXPECT_EQ(mesh.points.size(), 9u);
    EXPECT_TRUE(mesh.merged_vertices.empty());
  }
}

TEST(Straight_mesh, tells_crossings_of_the_surface_from_others)
{
  Model cubes = box(1, 1);
  const Model other = box(0.7, 0.7);
  for (const auto& p : other.points)
    cubes.points.push_back({p[0] + 0.5, p[1] + 0.4, p[2] + 0.3});
  for (const auto& t : other.triangles)
    cubes.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
  const IT::Straight_mesh mesh =
    IT::straight_mesh(IT::Common_subdivision(cubes.triangulation()), cubes.points, {}, 10, 0.01);
  EXPECT_GT(mesh.crossing_triangles.size(), 4u);
  EXPECT_EQ(mesh.number_of_new_crossings, 0u);
}

// A small triangle stands in a plane below a low pyramid. It would cross the plane, but not the pyramid.
TEST(Straight_mesh, merges_no_vertices_where_triangles_then_cross)
{
  for (std::uint32_t first : {0u, 1u, 2u}) {
    Model plate = graph(4, [](double, double) { return 0.; });
    const auto extra = std::uint32_t(plate.points.size());
    Triangles::value_type& cut = plate.triangles[12];
    const std::uint32_t a = cut[first], b = cut[(first + 1) % 3], c = cut[(first + 2) % 3];
    const auto p = plate.points[a], q = plate.points[b], r = plate.points[c];
    const double x = 0.97 * p[0] + 0.015 * (q[0] + r[0]), y = 0.97 * p[1] + 0.015 * (q[1] + r[1]);
    plate.points.insert(plate.points.end(), {{x, y, 0.002}, {x - 4e-4, y, -5e-4}, {x + 4e-4, y, -5e-4}, {x, y, 5e-4}});
    cut = {a, b, extra};
    plate.triangles.insert(plate.triangles.end(), {{b, c, extra}, {c, a, extra}, {extra + 1, extra + 2, extra + 3}});
    const IT::Straight_mesh mesh =
      IT::straight_mesh(IT::Common_subdivision(plate.triangulation()), plate.points, {}, 10, 0.02);
    EXPECT_EQ(mesh.merged_vertices.size(), 1u);
    EXPECT_TRUE(mesh.is_good()) << message(mesh) << mesh.minimum_angle;
    EXPECT_TRUE(mesh.crossing_triangles.empty());
  }
}

// The strip between two rectangles vanishes with its region.
TEST(Straight_mesh, numbers_regions_and_lines_that_are_left)
{
  Model sheet;
  for (double x : {0., 1., 1.00001, 2.})
    for (int j = 0; j < 3; ++j)
      sheet.points.push_back({x, j / 2., 0});
  for (std::uint32_t v : {0u, 1u, 3u, 4u, 6u, 7u}) {
    sheet.triangles.push_back({v, v + 3, v + 4});
    sheet.triangles.push_back({v, v + 4, v + 1});
  }
  const Triangulation t = sheet.triangulation();
  std::vector<bool> is_marked;
  for (IT::Edge_index e : t.input().edges()) { // along the strip
    const IT::Halfedge_index h = t.input().halfedge(e);
    const auto [v, w] = std::minmax(t.input().source(h).idx(), t.input().target(h).idx());
    is_marked.push_back(w == v + 1 && v / 3 == w / 3 && (v / 3 == 1 || v / 3 == 2));
  }
  const auto largest = [](const std::vector<std::uint32_t>& numbers) {
    return *std::max_element(numbers.begin(), numbers.end());
  };
  const IT::Common_subdivision subdivision(t);
  const IT::Straight_mesh before = IT::straight_mesh(subdivision, sheet.points, is_marked);
  EXPECT_EQ(before.number_of_regions, 3u);
  EXPECT_EQ(before.number_of_lines, 6u);
  EXPECT_EQ(largest(before.regions), 2u);
  EXPECT_EQ(largest(before.lines), 5u);
  const IT::Straight_mesh mesh = IT::straight_mesh(subdivision, sheet.points, is_marked, 10, 0.001);
  EXPECT_TRUE(mesh.is_good()) << message(mesh) << mesh.minimum_angle;
  EXPECT_EQ(mesh.number_of_regions, 2u);
  EXPECT_EQ(mesh.number_of_lines, 3u);
  EXPECT_EQ(largest(mesh.regions), 1u);
  EXPECT_EQ(largest(mesh.lines), 2u);
}

TEST(Straight_mesh, asks_its_visitor)
{
  Model model = graph(20, [](double x, double y) { return 0.01 * std::sin(40 * x * y); });
  for (auto& p : model.points)
    p[0] *= 0.05; // all triangles are thin
  const Triangulation t = model.triangulation();
  const IT::Common_subdivision subdivision(t);
  std::vector<double> fractions;
  const auto make = [&](const auto& visitor) {
    return IT::straight_mesh(subdivision, model.points, {}, 10, 1e-3, {}, CGAL::parameters::visitor(visitor));
  };
  make([&](double fraction) { return fractions.push_back(fraction), true; });
  EXPECT_GT(fractions.size(), 800u); // once for each thin triangle at least
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_GE(fractions.front(), 0);
  EXPECT_LE(fractions.back(), 1);
  for (std::size_t last : {std::size_t(1), fractions.size() / 2, fractions.size() - 1}) {
    std::size_t number = 0;
    EXPECT_THROW(make([&] { return ++number < last; }), IT::Cancelled_error);
    EXPECT_EQ(number, last);
  }
}

// Edges at a sharp corner are kept but for their ends, which are shorter than any number of double then.
TEST(Straight_mesh, is_refined_for_tiny_deviations)
{
  const Model pyramid{{{0.005, 0.005, 1}, {0, 0, 0}, {0.01, 0, 0}, {0.01, 0.01, 0}, {0, 0.01, 0}},
                      {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {1, 3, 2}, {1, 4, 3}}};
  Triangulation t = pyramid.triangulation();
  IT::refine_Delaunay(t, CGAL::parameters::maximum_deviation(1e-25).maximum_number(10));
  EXPECT_LE(t.connectivity().number_of_vertices(), pyramid.points.size() + 10);
  for (IT::Edge_index e : t.connectivity().edges())
    EXPECT_GT(t.length(e), 1e-6);
  const IT::Common_subdivision subdivision(t);
  EXPECT_EQ(subdivision.intrinsic().number_of_vertices(), t.connectivity().number_of_vertices());
}

// Vertices at the ends of folds that are kept count, too.
TEST(Straight_mesh, has_no_more_vertices_than_are_allowed)
{
  const Model pyramid{{{0.005, 0.005, 1}, {0, 0, 0}, {0.01, 0, 0}, {0.01, 0.01, 0}, {0, 0.01, 0}},
                      {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {1, 3, 2}, {1, 4, 3}}};
  for (std::uint64_t maximum : {0, 1, 2, 3, 10}) {
    Triangulation t = pyramid.triangulation();
    IT::refine_Delaunay(t, CGAL::parameters::maximum_deviation(1e-6).maximum_number(maximum));
    EXPECT_LE(t.connectivity().number_of_vertices(), pyramid.points.size() + maximum);
  }
}

// With no common corner, with one, and with a common edge.
TEST(Straight_mesh, tells_which_triangles_cross)
{
  using Pairs = std::vector<std::array<std::uint32_t, 2>>;
  const auto crossing = [](const Model& model) {
    const IT::Common_subdivision subdivision(model.triangulation());
    return IT::straight_mesh(subdivision, model.points, {}, 10, 1e-3).crossing_triangles;
  };
  for (double x : {0.2, 0.6}) {
    const Model apart{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {x, 0.3, -1}, {x, 0.3, 1}, {x, 1.3, 0}},
                      {{0, 1, 2}, {3, 4, 5}}};
    EXPECT_EQ(crossing(apart), Pairs({{0, 1}}));
    const Model at_corner{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, -1}, {x, 0.3, -1}, {x, 0.3, 1}},
                          {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}};
    EXPECT_EQ(crossing(at_corner), Pairs({{0, 3}}));
  }
  const Model beside{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0.3, -1}, {2, 0.3, 1}, {2, 1.3, 0}}, {{0, 1, 2}, {3, 4, 5}}};
  EXPECT_TRUE(crossing(beside).empty());
  const Model folded{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 0, 3}}};
  EXPECT_EQ(crossing(folded), Pairs({{0, 1}}));
  EXPECT_TRUE(crossing(box(1, 1)).empty());
}

TEST(Straight_mesh, refuses_senseless_deviations)
{
  Triangulation t = box(1, 1).triangulation();
  for (double deviation : {0., -1., std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(IT::refine_Delaunay(t, CGAL::parameters::maximum_deviation(deviation)), IT::Invalid_argument_error);
  Triangulation lengths = Triangulation::from_lengths(t.connectivity(), std::vector<double>(18, 1.));
  EXPECT_THROW(IT::refine_Delaunay(lengths, CGAL::parameters::maximum_deviation(0.1)), IT::Invalid_argument_error);
}

TEST(Straight_mesh, refuses_wrong_numbers_of_points_and_marks)
{
  const Model cube = box(1, 1);
  const IT::Common_subdivision subdivision(cube.triangulation());
  EXPECT_THROW(IT::straight_mesh(subdivision, {}), IT::Invalid_argument_error);
  EXPECT_THROW(IT::straight_mesh(subdivision, cube.points, {true}), IT::Invalid_argument_error);
}
