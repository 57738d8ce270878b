// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The results of simplification for partly flat, symmetric and hard surfaces, and the images of points.

#include "evaluation_data.h"
#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/polygon_soup.h>
#include <CGAL/Intrinsic_triangulations/shortest_path.h>
#include <CGAL/Intrinsic_triangulations/simplify_surface.h>
#include <CGAL/Intrinsic_triangulations/verify_Delaunay.h>

#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <random>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
namespace np = CGAL::parameters;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;
using samples::Indexed_triangles;

Triangulation triangulation_of(const Indexed_triangles& surface)
{
  return Triangulation(IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles), surface.points);
}

IT::Simplified_surface simplified(const Indexed_triangles& surface, double change = 0.05)
{
  Triangulation fine = triangulation_of(surface);
  return IT::simplify_surface(fine, np::maximum_change(change));
}

template <class Descriptor>
auto as_map(const std::vector<bool>& marks)
{
  return boost::make_function_property_map<Descriptor, bool>([&](Descriptor d) { return bool(marks[d.idx()]); });
}

// The surface of a box, with n by n squares a side.
Indexed_triangles box(std::uint32_t n, const std::array<double, 3>& size = {1, 1, 1})
{
  Indexed_triangles result;
  std::map<std::array<double, 3>, std::uint32_t> numbers;
  const auto vertex = [&](std::array<double, 3> p) {
    for (std::size_t i = 0; i < 3; ++i)
      p[i] *= size[i] / n;
    const auto [place, is_new] = numbers.insert({p, std::uint32_t(result.points.size())});
    if (is_new)
      result.points.push_back(p);
    return place->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (double level : {0., double(n)})
      for (double u = 0; u < n; ++u)
        for (double w = 0; w < n; ++w) {
          std::array<std::uint32_t, 4> corners{};
          for (std::size_t c = 0; c < 4; ++c) {
            std::array<double, 3> p{};
            p[axis] = level;
            p[(axis + 1) % 3] = u + (c == 1 || c == 2);
            p[(axis + 2) % 3] = w + (c >= 2);
            corners[level == 0 ? 3 - c : c] = vertex(p);
          }
          result.triangles.push_back({corners[0], corners[1], corners[2]});
          result.triangles.push_back({corners[0], corners[2], corners[3]});
        }
  return result;
}

void expect_nearly_isometric(const IT::Simplified_surface& result)
{
  EXPECT_GE(result.shrink, 1 - 1e-12);
  EXPECT_LE(result.stretch, 1 + 1e-12);
}

TEST(Simplify_surface, a_box_keeps_its_corners_alone)
{
  for (const auto& size : {std::array<double, 3>{1, 1, 1}, {1, 0.6, 2}, {1, 0.7, 2}, {0.3, 0.6, 0.7}}) {
    const Indexed_triangles surface = box(10, size);
    ASSERT_EQ(surface.points.size(), 602u);
    const IT::Simplified_surface result = simplified(surface);
    EXPECT_EQ(result.kept.size(), 8u);
    EXPECT_EQ(result.reasons.by_bound, 8u);
    expect_nearly_isometric(result);
  }
}

TEST(Simplify_surface, flat_and_developable_surfaces_stay_what_they_are)
{
  const IT::Simplified_surface grid = simplified(samples::random_diagonal_grid(20, 15));
  EXPECT_EQ(grid.kept.size(), 4u);
  expect_nearly_isometric(grid);
  const IT::Simplified_surface prism = simplified(samples::prism(80));
  EXPECT_GE(prism.kept.size(), 3u);
  const IT::Simplified_surface pillow = simplified(samples::pillow(60, 1), 0);
  expect_nearly_isometric(pillow);
  const IT::Simplified_surface sheared = simplified(samples::sheared_grid(12, 12, 5));
  EXPECT_EQ(sheared.kept.size(), 4u);
  expect_nearly_isometric(sheared);
  // A flat torus of 25 vertices: no vertex of it has curvature, and some have to be left.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  const auto vertex = [](std::uint32_t i, std::uint32_t j) { return 5 * (i % 5) + j % 5; };
  for (std::uint32_t i = 0; i < 5; ++i)
    for (std::uint32_t j = 0; j < 5; ++j) {
      triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  const IT::Delta_complex complex = IT::make_Delta_complex_from_triangles(25, triangles);
  std::vector<double> lengths;
  for (IT::Edge_index e : complex.edges()) {
    const auto v = complex.source(complex.halfedge(e)).idx(), w = complex.target(complex.halfedge(e)).idx();
    lengths.push_back(v / 5 == w / 5 ? 3 : v % 5 == w % 5 ? 4 : 5);
  }
  Triangulation torus = Triangulation::from_lengths(complex, lengths);
  const IT::Simplified_surface flat_torus = IT::simplify_surface(torus, np::maximum_change(0.));
  EXPECT_LE(flat_torus.kept.size(), 4u);
  expect_nearly_isometric(flat_torus);
}

TEST(Simplify_surface, no_change_keeps_all_but_flat_vertices)
{
  const Indexed_triangles sphere = samples::bumpy_sphere(18, 12, 0.1);
  EXPECT_EQ(simplified(sphere, 0).kept.size(), sphere.points.size());
  EXPECT_EQ(simplified(box(4), 0).kept.size(), 8u);
}

TEST(Simplify_surface, larger_changes_leave_fewer_vertices_within_their_bound)
{
  const Indexed_triangles surface = samples::bumpy_sphere(30, 20, 0.1);
  std::size_t last = surface.points.size() + 1;
  double shrink = 1, stretch = 1;
  for (double change : {0., 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1., 3.}) {
    const IT::Simplified_surface result = simplified(surface, change);
    EXPECT_LE(result.kept.size(), last);
    EXPECT_LE(result.shrink, shrink);
    EXPECT_GE(result.stretch, stretch);
    EXPECT_GE(result.shrink, 1 / (1 + change) - 2e-12);
    EXPECT_LE(result.stretch, 1 + change + 2e-12);
    last = result.kept.size();
    shrink = result.shrink;
    stretch = result.stretch;
  }
  EXPECT_LT(last, surface.points.size() / 10);
}

TEST(Simplify_surface, a_number_of_vertices_is_reached_exactly)
{
  Triangulation fine = triangulation_of(samples::bumpy_sphere(30, 20, 0.1));
  const IT::Simplified_surface result = IT::simplify_surface(fine, np::number_of_vertices(100));
  EXPECT_EQ(result.kept.size(), 100u);
  EXPECT_GT(result.reasons.by_number, 0u);
  EXPECT_TRUE(std::isfinite(result.stretch));
  EXPECT_GT(result.shrink, 0);
}

TEST(Simplify_surface, given_vertices_are_kept)
{
  Triangulation fine = triangulation_of(box(6));
  std::vector<bool> is_kept;
  for (IT::Vertex_index v : fine.connectivity().vertices())
    is_kept.push_back(v.idx() % 7 == 0);
  const IT::Simplified_surface result =
    IT::simplify_surface(fine, np::vertex_is_constrained_map(as_map<IT::Vertex_index>(is_kept)));
  for (std::uint32_t v = 0; v < fine.connectivity().number_of_vertices(); v += 7)
    EXPECT_EQ(std::count(result.kept.begin(), result.kept.end(), IT::Vertex_index(v)), 1) << v;
}

// Lines of constrained edges stay straight, with the points on them.
TEST(Simplify_surface, sharp_edges_are_kept_as_lines)
{
  const Indexed_triangles surface = box(6, {1, 0.7, 2});
  Triangulation fine = triangulation_of(surface);
  const IT::Simplified_surface result = IT::simplify_surface(fine, np::sharp_angle(30));
  EXPECT_EQ(result.kept.size(), 8u);
  EXPECT_EQ(std::count(result.is_constrained.begin(), result.is_constrained.end(), true), 12);
  expect_nearly_isometric(result);
  double total = 0;
  for (IT::Edge_index e : result.map.coarse().edges())
    if (result.is_constrained[e.idx()])
      total += result.triangulation.input_metric().lengths()[e.idx()];
  EXPECT_NEAR(std::ldexp(total, 1), 2 * 4 * (1 + 0.7 + 2), 1e-9);
}

// The rim of a curved surface, between two faces.
TEST(Simplify_surface, curved_lines_become_straight_within_the_bound)
{
  const Indexed_triangles surface = samples::Schwarz_lantern(24, 8);
  Triangulation fine = triangulation_of(surface);
  std::vector<bool> is_line(fine.connectivity().number_of_edges());
  std::size_t number = 0;
  for (IT::Edge_index e : fine.connectivity().edges()) {
    const auto h = fine.connectivity().halfedge(e);
    const double z = surface.points[fine.connectivity().source(h).idx()][2],
                 other = surface.points[fine.connectivity().target(h).idx()][2];
    is_line[e.idx()] = std::abs(z - other) < 1e-9 && !fine.connectivity().is_border(e);
    number += is_line[e.idx()];
  }
  ASSERT_GT(number, 24u);
  const IT::Simplified_surface result =
    IT::simplify_surface(fine, np::maximum_change(0.5).edge_is_constrained_map(as_map<IT::Edge_index>(is_line)));
  EXPECT_LT(result.kept.size(), surface.points.size());
  const std::size_t left = std::size_t(std::count(result.is_constrained.begin(), result.is_constrained.end(), true));
  EXPECT_GT(left, 0u);
  EXPECT_LT(left, number);
}

// ------------------------------------------------------------------------------------ invariance

Indexed_triangles renumbered(const Indexed_triangles& surface, std::vector<std::uint32_t>& number_of)
{
  std::mt19937 random(7);
  number_of.resize(surface.points.size());
  std::iota(number_of.begin(), number_of.end(), 0u);
  std::shuffle(number_of.begin(), number_of.end(), random);
  Indexed_triangles result = surface;
  for (std::size_t v = 0; v < number_of.size(); ++v)
    result.points[number_of[v]] = surface.points[v];
  for (auto& t : result.triangles) {
    t = {number_of[t[0]], number_of[t[1]], number_of[t[2]]};
    std::rotate(t.begin(), t.begin() + random() % 3, t.end());
  }
  std::shuffle(result.triangles.begin(), result.triangles.end(), random);
  return result;
}

std::vector<std::uint32_t> kept(const IT::Simplified_surface& result)
{
  std::vector<std::uint32_t> numbers;
  for (IT::Vertex_index v : result.kept)
    numbers.push_back(v.idx());
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

TEST(Simplify_surface, numbers_units_and_orientation_do_not_matter)
{
  for (const Indexed_triangles& surface : {samples::bumpy_sphere(30, 20, 0.1), samples::bumpy_dome(20, 12, 0.1)}) {
    const std::vector<std::uint32_t> expected = kept(simplified(surface));
    Indexed_triangles large = surface, mirrored = surface;
    for (auto& p : large.points)
      for (double& x : p)
        x *= 0x1p40;
    EXPECT_EQ(kept(simplified(large)), expected);
    for (auto& p : mirrored.points)
      p[0] = -p[0];
    for (auto& t : mirrored.triangles)
      std::swap(t[0], t[1]);
    EXPECT_EQ(kept(simplified(mirrored)), expected);
    std::vector<std::uint32_t> number_of;
    const std::vector<std::uint32_t> found = kept(simplified(renumbered(surface, number_of)));
    std::vector<std::uint32_t> wanted;
    for (std::uint32_t v : expected)
      wanted.push_back(number_of[v]);
    std::sort(wanted.begin(), wanted.end());
    EXPECT_EQ(found, wanted);
  }
}

// ------------------------------------------------------------------------------------ points

TEST(Simplification_map, points_go_there_and_come_back)
{
  for (const Indexed_triangles& surface : {samples::bumpy_sphere(24, 16, 0.1), samples::bumpy_dome(16, 10, 0.05)}) {
    const IT::Simplified_surface result = simplified(surface, 0.3);
    const IT::Delta_complex& fine = result.map.fine();
    std::mt19937 random(3);
    std::uniform_real_distribution<double> weight(0.1, 1);
    std::vector<IT::Surface_point> points;
    for (IT::Face_index f : fine.faces()) {
      std::array<double, 3> b{weight(random), weight(random), weight(random)};
      const double sum = b[0] + b[1] + b[2];
      points.push_back({fine.next(fine.halfedge(f)), {b[0] / sum, b[1] / sum, b[2] / sum}});
    }
    const std::vector<IT::Surface_point> there = result.map.to_coarse(points), back = result.map.to_fine(there);
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (double x : there[i].coordinates)
        EXPECT_GE(x, 0);
      ASSERT_EQ(fine.face(back[i].halfedge), fine.face(points[i].halfedge));
      const auto coordinates = IT::coordinates_from(fine, back[i], points[i].halfedge);
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(coordinates[k], points[i].coordinates[k], 1e-9);
    }
    for (std::size_t v = 0; v < result.kept.size(); ++v) {
      const IT::Surface_point& place = result.places[result.kept[v].idx()];
      EXPECT_EQ(place.dimension(), 0);
    }
  }
}

TEST(Simplification_map, faces_cover_the_coarse_surface_once)
{
  const IT::Simplified_surface result = simplified(samples::bumpy_sphere(24, 16, 0.1), 0.3);
  const IT::Delta_complex& fine = result.map.fine();
  const IT::Delta_complex& coarse = result.map.coarse();
  EXPECT_TRUE(coarse.is_valid());
  EXPECT_EQ(int(coarse.number_of_vertices()) - int(coarse.number_of_edges()) + int(coarse.number_of_faces()), 2);
  // Random points of the coarse surface are distributed over the fine faces as their areas.
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<IT::Surface_point> points;
  for (IT::Face_index f : coarse.faces())
    for (int i = 0; i < 1000; ++i) {
      const double a = std::sqrt(unit(random)), b = unit(random);
      points.push_back({coarse.halfedge(f), {1 - a, a * (1 - b), a * b}});
    }
  const std::vector<IT::Surface_point> on_fine = result.map.to_fine(points), back = result.map.to_coarse(on_fine);
  std::vector<int> hits(fine.number_of_faces());
  for (std::size_t i = 0; i < points.size(); ++i) {
    ++hits[fine.face(on_fine[i].halfedge).idx()];
    EXPECT_EQ(coarse.face(back[i].halfedge), coarse.face(points[i].halfedge));
  }
  EXPECT_LT(std::count(hits.begin(), hits.end(), 0), std::ptrdiff_t(hits.size() / 100));
}

TEST(Simplification_map, edges_come_back_as_polylines)
{
  const IT::Simplified_surface result = simplified(samples::bumpy_sphere(24, 16, 0.1), 0.3);
  const IT::Delta_complex& fine = result.map.fine();
  const IT::Delta_complex& coarse = result.map.coarse();
  std::vector<IT::Simplification_map::Line_part> lines;
  for (IT::Edge_index e : coarse.edges()) {
    const auto h = coarse.halfedge(e);
    lines.push_back({IT::Surface_point{h, {1, 0, 0}}, IT::Surface_point{h, {0, 1, 0}}});
  }
  const std::vector<IT::Simplification_map::Line> found = result.map.lines_to_fine(lines);
  Triangulation again = triangulation_of(samples::bumpy_sphere(24, 16, 0.1));
  IT::flip_to_Delaunay(again);
  const auto length = [&](IT::Halfedge_index h) { return again.length(fine.edge(h)); };
  for (IT::Edge_index e : coarse.edges()) {
    const IT::Simplification_map::Line& line = found[e.idx()];
    ASSERT_FALSE(line.empty());
    double total = 0;
    for (const auto& [from, to] : line) {
      ASSERT_EQ(from.halfedge, to.halfedge);
      const double a = length(from.halfedge), b = length(fine.next(from.halfedge)),
                   c = length(fine.prev(from.halfedge));
      std::array<double, 3> d;
      for (std::size_t k = 0; k < 3; ++k)
        d[k] = to.coordinates[k] - from.coordinates[k];
      total += std::sqrt((std::max)(0., -(a * a * d[0] * d[1] + b * b * d[1] * d[2] + c * c * d[2] * d[0])));
    }
    // A curve on the fine surface whose image is the edge.
    const double image = result.triangulation.input_metric().lengths()[e.idx()] *
                         std::ldexp(1, result.triangulation.input_metric().unit_exponent());
    EXPECT_GE(image, result.shrink * total * (1 - 1e-9));
    EXPECT_LE(image, result.stretch * total * (1 + 1e-9));
  }
}

TEST(Simplification_map, points_that_do_not_exist_are_refused)
{
  const IT::Simplified_surface result = simplified(box(3));
  EXPECT_THROW(result.map.to_coarse({{IT::Halfedge_index(100000), {1, 0, 0}}}), IT::Invalid_point_error);
  EXPECT_THROW(result.map.to_coarse({{IT::Halfedge_index(0), {0, 0, 0}}}), IT::Invalid_point_error);
  EXPECT_THROW(result.map.to_fine({{IT::Halfedge_index(0), {1, -1, 0}}}), IT::Invalid_point_error);
}

// ------------------------------------------------------------------------------------ hard surfaces

void expect_bound(Triangulation fine, double change)
{
  const IT::Simplified_surface result = IT::simplify_surface(fine, np::maximum_change(change));
  EXPECT_GE(result.shrink, 1 / (1 + change) - 1e-12);
  EXPECT_LE(result.shrink, 1);
  EXPECT_GE(result.stretch, 1);
  EXPECT_LE(result.stretch, 1 + change + 1e-12);
  EXPECT_TRUE(result.map.coarse().is_valid());
  for (const IT::Surface_point& place : result.places)
    if (place.halfedge.is_valid())
      for (double x : place.coordinates)
        EXPECT_TRUE(x >= 0 && x <= 1) << x;
}

Indexed_triangles wheel(std::uint32_t n, double height)
{
  Indexed_triangles result;
  result.points.push_back({0, 0, height});
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * 3.14159265358979323846 * i / n;
    result.points.push_back({std::cos(angle), std::sin(angle), 0});
    result.triangles.push_back({0, 1 + i, 1 + (i + 1) % n});
  }
  return result;
}

TEST(Simplify_surface, hard_surfaces_end_with_a_bound)
{
  for (double change : {0.01, 1.}) {
    for (double bulge : {0., 1e-17, 1e-10, 1e-3})
      expect_bound(triangulation_of(samples::cap(bulge)), change);
    for (double scale : {1e-12, 1e-9, 1e-6})
      expect_bound(triangulation_of(samples::sliver_sheet(10, scale, scale)), change);
    expect_bound(triangulation_of(samples::strip(200, 10, 1)), change);
    expect_bound(triangulation_of(samples::strip(200, 10, 1e-9)), change);
    expect_bound(triangulation_of(samples::helical_tube(60, 30)), change);
    expect_bound(triangulation_of(samples::helical_tube(60, 1e5)), change);
    expect_bound(triangulation_of(samples::pillow(60, 1e-12)), change);
    expect_bound(triangulation_of(wheel(300, 0)), change);
    expect_bound(triangulation_of(wheel(300, 0.3)), change);
    expect_bound(triangulation_of(wheel(2000, 0.3)), change);
    for (std::uint64_t seed = 1; seed < 20; ++seed) {
      const samples::Glued_triangles gluing = samples::random_gluing(1 + seed * 3, seed, seed % 2 == 0);
      const IT::Delta_complex complex = IT::make_Delta_complex_from_gluing(gluing.number_of_faces, gluing.glued_sides);
      expect_bound(Triangulation::from_lengths(complex, std::vector<double>(complex.number_of_edges(), 1.)), change);
    }
  }
}

// Two vertices of a curved surface are next to each other: the faces between them are far too thin for their lengths to
// be described by doubles. All others are simplified as ever.
TEST(Simplify_surface, faces_thinner_than_doubles_stay_as_they_are)
{
  for (double gap : {1e-9, 1e-13, 1e-16}) {
    Indexed_triangles surface = samples::bumpy_sphere(30, 20, 0.1);
    for (auto& p : surface.points)
      p[0] += 1e-3; // so that the gap is not lost beside a coordinate
    std::size_t t = 0;
    while (std::abs(surface.points[surface.triangles[t][0]][2]) > 0.1)
      ++t;
    const std::uint32_t a = surface.triangles[t][0], b = surface.triangles[t][1], c = surface.triangles[t][2],
                        d = std::uint32_t(surface.points.size());
    std::array<double, 3> p = surface.points[a];
    for (std::size_t i = 0; i < 3; ++i)
      p[i] += gap * (0.5 * (surface.points[b][i] + surface.points[c][i]) - p[i]);
    surface.points.push_back(p);
    surface.triangles[t] = {a, b, d};
    surface.triangles.push_back({b, c, d});
    surface.triangles.push_back({c, a, d});
    if (surface.points[a] == p)
      continue; // rounded away
    SCOPED_TRACE(gap);
    const IT::Simplified_surface result = simplified(surface);
    EXPECT_LT(result.kept.size(), surface.points.size() / 2);
    EXPECT_GE(result.shrink, 1 / 1.05 - 1e-9);
    EXPECT_LE(result.stretch, 1.05 + 1e-9);
    Triangulation fine = triangulation_of(surface);
    IT::flip_to_Delaunay(fine);
    const IT::Vertex_index source = result.kept[0];
    const auto exact = IT::geodesic_distances(fine, std::vector<IT::Vertex_index>{source}, np::tolerance(0.)).distances,
               found = IT::geodesic_distances(result.triangulation, std::vector<IT::Vertex_index>{IT::Vertex_index(0)},
                                              np::tolerance(0.))
                         .distances;
    for (std::size_t v = 1; v < found.size(); ++v) {
      const double factor = found[v] / exact[result.kept[v].idx()];
      EXPECT_GE(factor, result.shrink * (1 - 1e-9)) << v;
      EXPECT_LE(factor, result.stretch * (1 + 1e-9)) << v;
    }
  }
}

TEST(Simplify_surface, what_cannot_be_done_is_an_error)
{
  const IT::Delta_complex complex =
    IT::make_Delta_complex_from_triangles(3, std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}});
  Triangulation tiny = Triangulation::from_lengths(complex, std::vector<double>{3e-320, 4e-320, 5e-320});
  EXPECT_THROW(IT::simplify_surface(tiny), IT::Invalid_surface_error);
  Triangulation fine = triangulation_of(box(2));
  EXPECT_THROW(IT::simplify_surface(fine, np::maximum_change(-1)), IT::Invalid_argument_error);
  EXPECT_THROW(IT::simplify_surface(fine, np::maximum_change(std::nan(""))), IT::Invalid_argument_error);
  Triangulation large = triangulation_of(samples::bumpy_sphere(60, 40, 0.1));
  EXPECT_THROW(IT::simplify_surface(large, np::maximum_change(-1)), IT::Invalid_argument_error);
  EXPECT_FALSE(IT::is_Delaunay(large)) << "flipped for an argument that is refused";
  EXPECT_THROW(IT::simplify_surface(large, np::visitor([] { return false; })), IT::Cancelled_error);
}

TEST(Simplify_surface, evaluation_meshes_leave_few_vertices)
{
  const auto folder = evaluation_data();
  if (folder.empty())
    GTEST_SKIP() << "the evaluation meshes are not there";
  const auto part_left = [&](const char* name, double change) {
    Indexed_triangles surface;
    IT::read_triangles((folder / name).string(), surface.points, surface.triangles);
    return double(simplified(surface, change).kept.size()) / double(surface.points.size());
  };
  EXPECT_LE(part_left("good/oded_spot.off", 0.05), 0.085);
  EXPECT_LE(part_left("good/psb_210.off", 0.05), 0.1);
  EXPECT_LE(part_left("good/manifoldlib_Generic_Twin_7081_1_t0_right.off", 0.05), 0.2);
}

} // namespace
