// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Straight triangles: what is thinner than the largest deviation is merged, left out, or replaced by rods.

#include "straight_models.h"

using namespace straight_models;

namespace {

// A polygon along which a segment moves.
Model prism(const std::vector<std::array<double, 2>>& polygon, const Triangles& inside)
{
  Model result;
  const auto n = std::uint32_t(polygon.size());
  for (double z : {0., 1.})
    for (const auto& [x, y] : polygon)
      result.points.push_back({x, y, z});
  for (std::uint32_t v = 0; v < n; ++v) {
    const std::uint32_t w = (v + 1) % n;
    result.triangles.push_back({v, w, w + n});
    result.triangles.push_back({v, w + n, v + n});
  }
  for (const auto& [a, b, c] : inside) {
    result.triangles.push_back({a, c, b});
    result.triangles.push_back({a + n, b + n, c + n});
  }
  return result;
}

// Films of this area go, and a block stays, with a cavity where its volume is below 1.
void check_films(const Model& model, double longest, double deviation, double area, double expected_volume = 1)
{
  Triangulation t = model.triangulation();
  const std::vector<bool> sharp = IT::sharp_edges(t.input(), model.points, 30);
  const auto is_sharp = boost::make_function_property_map<IT::Edge_index, bool>(
    [&](IT::Edge_index e) { return e.idx() < sharp.size() && sharp[e.idx()]; });
  IT::refine_Delaunay(
    t, CGAL::parameters::minimum_angle(25).maximum_edge_length(longest).minimum_size(0.02).edge_is_constrained_map(
         is_sharp));
  const IT::Straight_mesh mesh = IT::straight_mesh(IT::Common_subdivision(t), model.points, sharp, 10, deviation);
  EXPECT_TRUE(mesh.can_be_filled()) << mesh.folded_edges.size() << ' ' << mesh.crossing_triangles.size();
  EXPECT_TRUE(mesh.is_good()) << message(mesh) << mesh.minimum_angle;
  EXPECT_EQ(mesh.surface.number_of_components, expected_volume < 1 ? 2u : 1u);
  EXPECT_NEAR(mesh.area_of_films, area, 0.1 * (std::max)(1., area));
  EXPECT_LE(mesh.deviation, deviation);
  EXPECT_LE(farthest_sample(mesh.points, mesh.triangles, model.points, model.triangles), mesh.deviation);
  double volume = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    volume +=
      IT::internal::scalar_product(mesh.points[a], IT::internal::cross_product(mesh.points[b], mesh.points[c])) / 6;
  EXPECT_NEAR(volume, expected_volume, 6 * deviation);
}

} // namespace

// A vertex just beside another one, as CAD programs leave them.
TEST(Straight_thin_parts, merges_what_is_thinner_than_the_deviation)
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
TEST(Straight_thin_parts, bends_long_sides_to_corners_near_them)
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
TEST(Straight_thin_parts, leaves_patches_along_others)
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
TEST(Straight_thin_parts, leaves_out_pieces_along_others)
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
TEST(Straight_thin_parts, cuts_thin_tubes_and_makes_rods_of_wires)
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
TEST(Straight_thin_parts, makes_one_rod_of_a_wire_that_came_apart)
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

// A block with a sheet of material beside it, or with a gap in it.
TEST(Straight_thin_parts, leaves_films_out)
{
  for (double end : {2., 0.4, 18., 21.}) // beside the block, in it, or far beside it
    for (double thickness : {1e-7, end > 20 ? 5e-4 : 1e-5}) {
      const double low = 0.5, high = low + thickness;
      const bool is_gap = end < 1;
      check_films(prism({{0, 0}, {1, 0}, {1, low}, {end, low}, {end, high}, {1, high}, {1, 1}, {0, 1}},
                        is_gap ? Triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 7}, {3, 4, 7}, {4, 5, 6}, {4, 6, 7}}
                               : Triangles{{0, 1, 2}, {0, 2, 5}, {0, 5, 7}, {5, 6, 7}, {2, 3, 4}, {2, 4, 5}}),
                  end > 2 ? 2 : 0.2,
                  end > 20  ? 0.001
                  : end > 2 ? 0.05
                            : 0.01,
                  std::abs(end - 1));
    }
}

// Thin cavities, and thick ones.
TEST(Straight_thin_parts, leaves_thin_cavities_out)
{
  for (double thickness : {1e-7, 1e-4, 0.2}) {
    Model model = box(1, 1);
    const Model cavity = box(0.5, thickness);
    for (const auto& [x, y, z] : cavity.points)
      model.points.push_back({x / 2 + 0.25, y + 0.25, z + 0.5});
    for (const auto& [a, b, c] : cavity.triangles)
      model.triangles.push_back({a + 8, c + 8, b + 8});
    const bool is_thin = thickness < 0.01;
    check_films(model, 0.3, 0.01, is_thin ? 0.25 : 0, is_thin ? 1 : 0.95);
  }
}

// Beside a block, a bent sheet that has more facets on one side than on the other.
TEST(Straight_thin_parts, leaves_bent_films_out)
{
  constexpr std::uint32_t n = 10;
  constexpr double radius = 2, thickness = 5e-3;
  std::vector<std::array<double, 2>> points{{0, 0}, {1, 0}};
  const auto add = [&](double r, double angle) {
    points.push_back({1 + r * std::sin(angle), 0.5 + radius - r * std::cos(angle)});
  };
  for (std::uint32_t k = 0; k <= 2 * n; ++k)
    add(radius, double(k) / (2 * n));
  for (std::uint32_t k = 0; k <= n; ++k)
    add(radius - thickness, 1 - double(k) / n);
  points.insert(points.end(), {{1, 1}, {0, 1}});
  const auto outer = [](std::uint32_t k) { return 2 + k; };
  const auto inner = [](std::uint32_t k) { return 3 * n + 3 - k; };
  const std::uint32_t last = 3 * n + 5;
  Triangles inside{{0, 1, outer(0)}, {0, outer(0), inner(0)}, {0, inner(0), last}, {inner(0), last - 1, last}};
  for (std::uint32_t k = 0; k < n; ++k) {
    inside.push_back({outer(2 * k), outer(2 * k + 1), inner(k)});
    inside.push_back({outer(2 * k + 1), inner(k + 1), inner(k)});
    inside.push_back({outer(2 * k + 1), outer(2 * k + 2), inner(k + 1)});
  }
  check_films(prism(points, inside), 0.2, 0.01, radius);
}
