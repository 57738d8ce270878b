// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Straight triangles: their distance from the surface, by sampling; regions, lines and defects.

#include "straight_models.h"

using namespace straight_models;

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
    const auto [v, w] = std::minmax({t.input().source(h).idx(), t.input().target(h).idx()});
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
