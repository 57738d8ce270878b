// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Conformal metrics against known ones, on copies of surfaces, and with wrong demands.

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/discrete_conformal_metric.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/insert_vertex.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/surface_features.h>

#include <CGAL/number_type_config.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <map>
#include <numeric>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;
using IT::Conformal_boundary;
using IT::Discrete_conformal_metric;
using IT::Vertex_index;
using samples::Indexed_triangles;

Triangulation triangulation_of(const Indexed_triangles& surface)
{
  return Triangulation(IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles), surface.points);
}

// The named parameters, except for progress.
struct Conformal_options
{
  std::vector<std::pair<Vertex_index, double>> angles{};
  Conformal_boundary boundary = Conformal_boundary::FREE;
  std::optional<std::size_t> number_of_cones{};
  double largest_range = 5;
};

Discrete_conformal_metric metric_of(const Triangulation& t, const Conformal_options& options)
{
  return IT::discrete_conformal_metric(t, CGAL::parameters::cone_angles(options.angles)
                                            .conformal_boundary(options.boundary)
                                            .number_of_cones(options.number_of_cones)
                                            .maximum_range(options.largest_range));
}

Discrete_conformal_metric metric_of(const Indexed_triangles& surface, const Conformal_options& options = {})
{
  return metric_of(triangulation_of(surface), options);
}

// Sums of angles around the vertices of the triangulation, by the law of cosines.
std::vector<double> sums_of_angles(const Discrete_conformal_metric& metric)
{
  const IT::Delta_complex& complex = metric.triangulation;
  std::vector<double> sums(complex.number_of_vertices(), 0.);
  for (IT::Halfedge_index h : complex.halfedges()) {
    const auto length = [&](IT::Halfedge_index side) { return metric.lengths[complex.edge(side).idx()]; };
    const double a = length(h), b = length(complex.next(h)), c = length(complex.prev(h));
    sums[complex.target(complex.next(h)).idx()] += std::acos((b * b + c * c - a * a) / (2 * b * c));
  }
  return sums;
}

// Whether opposite angles sum to π at most.
bool is_Delaunay(const Discrete_conformal_metric& metric)
{
  const IT::Delta_complex& complex = metric.triangulation;
  const auto cosine = [&](IT::Halfedge_index h) {
    const auto length = [&](IT::Halfedge_index side) { return metric.lengths[complex.edge(side).idx()]; };
    const double a = length(h), b = length(complex.next(h)), c = length(complex.prev(h));
    return (b * b + c * c - a * a) / (2 * b * c);
  };
  const auto edges = complex.edges();
  return std::all_of(edges.begin(), edges.end(), [&](IT::Edge_index e) {
    return cosine(complex.halfedge(e)) + cosine(complex.opposite(complex.halfedge(e))) > -1e-12;
  });
}

double largest_magnitude(const std::vector<double>& x)
{
  double result = 0;
  for (double y : x)
    result = (std::max)(result, std::abs(y));
  return result;
}

std::string message_of(const Indexed_triangles& surface, const Conformal_options& options)
{
  try {
    metric_of(surface, options);
  } catch (const IT::Invalid_argument_error& error) {
    return error.what();
  }
  return "";
}

Conformal_options with_four_cones(const Indexed_triangles& surface)
{
  const std::uint32_t n = std::uint32_t(surface.points.size());
  Conformal_options options;
  for (std::uint32_t v : {0u, n / 3, n / 2, n - 1})
    options.angles.emplace_back(Vertex_index(v), CGAL_PI);
  return options;
}

TEST(Discrete_conformal_metric, of_a_flat_sheet_with_a_free_border_is_its_own)
{
  // At the border are triangles with obtuse angles: only the double's Delaunay triangulation tells the scale.
  Indexed_triangles sheet = samples::sheared_grid(12, 9, 1.7);
  std::mt19937 random(3);
  for (std::array<double, 3>& p : sheet.points)
    for (int i = 0; i < 2; ++i)
      p[std::size_t(i)] += 0.1 * (double(random()) / 0x1p31 - 1);
  const Discrete_conformal_metric metric = metric_of(sheet);
  EXPECT_LT(largest_magnitude(metric.u), 1e-12);
  EXPECT_LT(metric.residual, 1e-11);
  EXPECT_TRUE(metric.cones.empty());
}

TEST(Discrete_conformal_metric, has_the_cones_that_were_asked_for)
{
  const Indexed_triangles sphere = samples::bumpy_sphere(20, 15, 0.3);
  const Conformal_options options = with_four_cones(sphere);
  const Discrete_conformal_metric metric = metric_of(sphere, options);
  EXPECT_LT(metric.residual, 1e-11);
  EXPECT_LE(metric.steps, 10);
  EXPECT_EQ(metric.cones.size(), 4u);
  EXPECT_TRUE(is_Delaunay(metric));
  const std::vector<double> sums = sums_of_angles(metric);
  for (std::size_t v = 0; v < sums.size(); ++v) {
    const bool is_cone =
      std::any_of(options.angles.begin(), options.angles.end(), [&](const auto& x) { return x.first.idx() == v; });
    EXPECT_NEAR(sums[v], is_cone ? CGAL_PI : 2 * CGAL_PI, 1e-10);
  }
  // Edges that were never flipped have the scaled length.
  Triangulation t = triangulation_of(sphere);
  IT::flip_to_Delaunay(t);
  std::vector<bool> is_flipped(t.connectivity().number_of_edges(), false);
  for (IT::Edge_index e : metric.flips)
    is_flipped[e.idx()] = true;
  std::size_t unflipped = 0;
  for (IT::Edge_index e : t.connectivity().edges())
    if (!is_flipped[e.idx()]) {
      ++unflipped;
      const IT::Halfedge_index h = t.connectivity().halfedge(e);
      const double scale =
        std::exp((metric.u[t.connectivity().source(h).idx()] + metric.u[t.connectivity().target(h).idx()]) / 2);
      EXPECT_NEAR(metric.lengths[e.idx()] / (t.length(e) * scale), 1, 1e-14);
    }
  EXPECT_GT(unflipped, sphere.points.size());
  EXPECT_LT(unflipped, t.connectivity().number_of_edges());
}

TEST(Discrete_conformal_metric, does_not_depend_on_the_triangles)
{
  for (bool is_closed : {true, false}) {
    Indexed_triangles surface = is_closed ? samples::bumpy_sphere(20, 15, 0.3) : samples::bumpy_dome(14, 10, 0.2);
    for (auto& p : surface.points) // so that middles are exact
      for (double& x : p)
        x = std::ldexp(std::round(std::ldexp(x, 30)), -30);
    const Conformal_options options = is_closed ? with_four_cones(surface) : Conformal_options();
    const std::vector<double> u = metric_of(surface, options).u;
    ASSERT_GT(largest_magnitude(u), 0.1);

    Indexed_triangles mirrored = surface;
    for (auto& p : mirrored.points)
      p[0] = -p[0];
    for (auto& t : mirrored.triangles)
      std::swap(t[0], t[1]);
    const std::vector<double> u_of_mirrored = metric_of(mirrored, options).u;

    std::vector<std::uint32_t> number(surface.points.size());
    std::iota(number.begin(), number.end(), 0u);
    std::mt19937 random(11);
    std::shuffle(number.begin(), number.end(), random);
    Indexed_triangles renumbered = surface;
    for (std::size_t v = 0; v < number.size(); ++v)
      renumbered.points[number[v]] = surface.points[v];
    for (auto& t : renumbered.triangles)
      t = {number[t[1]], number[t[2]], number[t[0]]};
    std::shuffle(renumbered.triangles.begin(), renumbered.triangles.end(), random);
    Conformal_options of_renumbered = options;
    for (auto& angle : of_renumbered.angles)
      angle.first = Vertex_index(number[angle.first.idx()]);
    const std::vector<double> u_of_renumbered = metric_of(renumbered, of_renumbered).u;

    // With a vertex in the middle of each edge, where it is flat and needs no scale of its own. On the border, it has
    // one.
    Indexed_triangles subdivided = surface;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t i, std::uint32_t j) {
      const auto [place, is_new] = middles.insert({std::minmax(i, j), std::uint32_t(subdivided.points.size())});
      if (is_new) {
        const auto &p = surface.points[i], &q = surface.points[j];
        subdivided.points.push_back({(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2});
      }
      return place->second;
    };
    subdivided.triangles.clear();
    for (const auto& [i, j, k] : surface.triangles) {
      const std::uint32_t a = middle(i, j), b = middle(j, k), c = middle(k, i);
      for (const std::array<std::uint32_t, 3>& t : {std::array{i, a, c}, {j, b, a}, {k, c, b}, {a, b, c}})
        subdivided.triangles.push_back(t);
    }
    IT::Delta_complex coarse = IT::make_Delta_complex_from_triangles(subdivided.points.size(), subdivided.triangles);
    const std::size_t left = IT::remove_flat_vertices(coarse, subdivided.points).size();
    EXPECT_TRUE(left == surface.points.size() || !is_closed);
    const std::vector<double> u_of_subdivided =
      is_closed ? metric_of(Triangulation(coarse, subdivided.points), options).u : u;

    // The same surface from another triangulation of it: random flips, then lengths alone.
    Triangulation flipped = triangulation_of(surface);
    for (int i = 0; i < 200; ++i) {
      const IT::Edge_index e(std::uint32_t(random() % flipped.connectivity().number_of_edges()));
      if (flipped.connectivity().is_flippable(e))
        flipped.flip(e);
    }
    const std::vector<double> u_of_flipped =
      metric_of(Triangulation::from_lengths(flipped.connectivity(), IT::exact_edge_lengths(flipped)), options).u;
    for (std::size_t v = 0; v < u.size(); ++v) {
      EXPECT_NEAR(u_of_mirrored[v], u[v], 1e-9);
      EXPECT_NEAR(u_of_renumbered[number[v]], u[v], 1e-9);
      EXPECT_NEAR(u_of_flipped[v], u[v], 1e-9);
      EXPECT_NEAR(u_of_subdivided[v], u[v], 1e-9);
    }
  }
}

// A ring in the plane, with n vertices around, which are not quite regular.
Indexed_triangles ring(std::size_t n, double inner, double outer)
{
  Indexed_triangles result;
  const std::size_t rows = std::size_t(std::lround(double(n) * std::log(outer / inner) / 6.283)) + 1;
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t i = 0; i < n; ++i) {
      const double t = double(r) / double(rows - 1), a = 2 * CGAL_PI * (double(i) + 0.5 * double(r % 2)) / double(n),
                   bump = t * (1 - t), radius = inner * std::pow(outer / inner, t + 0.2 * bump * std::sin(3 * a)),
                   angle = a + 0.3 * bump * std::cos(2 * a);
      result.points.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
    }
  const auto vertex = [n](std::size_t r, std::size_t i) { return std::uint32_t(r * n + i % n); };
  for (std::size_t r = 0; r + 1 < rows; ++r)
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t shift = r % 2;
      result.triangles.push_back({vertex(r, i), vertex(r + 1, i + shift), vertex(r, i + 1)});
      result.triangles.push_back({vertex(r, i + 1), vertex(r + 1, i + shift), vertex(r + 1, i + shift + 1)});
    }
  return result;
}

TEST(Discrete_conformal_metric, makes_a_flat_ring_a_cylinder)
{
  // By log z, which scales by 1 / r.
  double last = 0;
  for (std::size_t n : {12, 24, 48}) {
    const Indexed_triangles surface = ring(n, 1, 4);
    Conformal_options options;
    options.boundary = Conformal_boundary::ANGLES;
    const Discrete_conformal_metric metric = metric_of(surface, options);
    EXPECT_LT(metric.residual, 1e-11);
    std::vector<double> difference;
    for (std::size_t v = 0; v < surface.points.size(); ++v)
      difference.push_back(metric.u[v] + std::log(std::hypot(surface.points[v][0], surface.points[v][1])));
    const auto [least, most] = std::minmax_element(difference.begin(), difference.end());
    if (last > 0) {
      EXPECT_LT(*most - *least, last / 3) << "the error falls with the square of the length of edges";
    }
    last = *most - *least;
  }
  EXPECT_LT(last, 0.01);
}

TEST(Discrete_conformal_metric, makes_a_dome_a_convex_polygon)
{
  const Indexed_triangles dome = samples::bumpy_dome(14, 10, 0.2);
  Conformal_options options;
  options.boundary = Conformal_boundary::DISK;
  const Discrete_conformal_metric metric = metric_of(dome, options);
  EXPECT_LT(metric.residual, 1e-11);
  const Triangulation t = triangulation_of(dome);
  const std::vector<double> sums = sums_of_angles(metric);
  double turn = 0;
  for (Vertex_index v : t.connectivity().vertices())
    if (t.connectivity().is_border(t.connectivity().halfedge(v))) {
      const double outer =
        CGAL_PI -
        sums[std::size_t(std::find(metric.vertices.begin(), metric.vertices.end(), v) - metric.vertices.begin())] / 2;
      EXPECT_GT(outer, 0);
      turn += outer;
    }
  EXPECT_NEAR(turn, 2 * CGAL_PI, 1e-10);
}

TEST(Discrete_conformal_metric, has_the_angles_of_the_border_that_were_asked_for)
{
  // A square: cones inside are chosen only if the angles need them.
  const Indexed_triangles dome = samples::bumpy_dome(14, 10, 0.2);
  const Triangulation t = triangulation_of(dome);
  std::vector<Vertex_index> border;
  for (Vertex_index v : t.connectivity().vertices())
    if (t.connectivity().is_border(t.connectivity().halfedge(v)))
      border.push_back(v);
  for (double angle : {CGAL_PI / 2, 2.}) {
    std::vector<std::pair<Vertex_index, double>> angles;
    for (std::size_t i = 0; i < 4; ++i)
      angles.emplace_back(border[i * border.size() / 4], angle);
    const Discrete_conformal_metric metric =
      IT::discrete_conformal_metric(t, CGAL::parameters::boundary_angles(angles));
    EXPECT_LT(metric.residual, 1e-10);
    EXPECT_EQ(metric.cones.size(), angle == 2. ? 1u : 0u);
    const std::vector<double> sums = sums_of_angles(metric);
    for (std::size_t v = 0; v < sums.size(); ++v)
      for (const auto& [corner, wanted] : angles)
        if (metric.vertices[v] == corner) {
          EXPECT_NEAR(sums[v], 2 * wanted, 1e-9); // of both copies
        }
    EXPECT_THROW(IT::discrete_conformal_metric(
                   t, CGAL::parameters::boundary_angles(std::vector<std::pair<Vertex_index, double>>{{border[0], 2.}})
                        .number_of_cones(0)),
                 IT::Invalid_argument_error);
  }
}

TEST(Discrete_conformal_metric, finds_each_component_by_itself)
{
  const Indexed_triangles sphere = samples::bumpy_sphere(12, 9, 0.3), torus = samples::torus(12, 8),
                          dome = samples::bumpy_dome(8, 6, 0.2);
  Indexed_triangles all;
  all.points.push_back({9, 9, 9}); // without a face
  std::vector<double> expected{0};
  for (const Indexed_triangles& part : {sphere, torus, dome}) {
    const std::uint32_t first = std::uint32_t(all.points.size());
    all.points.insert(all.points.end(), part.points.begin(), part.points.end());
    for (const auto& t : part.triangles)
      all.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    const std::vector<double> u = metric_of(part).u;
    expected.insert(expected.end(), u.begin(), u.end());
  }
  const Discrete_conformal_metric metric = metric_of(all);
  EXPECT_LT(metric.residual, 1e-11);
  for (std::size_t v = 0; v < expected.size(); ++v)
    EXPECT_NEAR(metric.u[v], expected[v], 1e-9);
}

TEST(Discrete_conformal_metric, takes_time_in_proportion_to_components)
{
  Indexed_triangles all;
  const Indexed_triangles part = samples::prism(3);
  for (int i = 0; i < 4000; ++i) {
    const std::uint32_t first = std::uint32_t(all.points.size());
    all.points.insert(all.points.end(), part.points.begin(), part.points.end());
    for (const auto& t : part.triangles)
      all.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  const std::clock_t start = std::clock();
  const Discrete_conformal_metric metric = metric_of(all);
  EXPECT_LT(double(std::clock() - start) / CLOCKS_PER_SEC, 20); // else minutes
  EXPECT_LT(metric.residual, 1e-11);
  EXPECT_GE(metric.cones.size(), 4000u);
}

TEST(Discrete_conformal_metric, chooses_cones_until_the_range_is_small)
{
  const Indexed_triangles sphere = samples::bumpy_sphere(20, 15, 0.3);
  Conformal_options options;
  options.largest_range = 1.5;
  const Discrete_conformal_metric metric = metric_of(sphere, options);
  EXPECT_LT(metric.residual, 1e-11);
  EXPECT_LT(metric.range_of_u, 2.5);
  EXPECT_GE(metric.cones.size(), 3u);
  for (Vertex_index v : metric.cones)
    EXPECT_EQ(metric.u[v.idx()], 0);
  options.number_of_cones = 7;
  EXPECT_EQ(metric_of(sphere, options).cones.size(), 7u);
  options.number_of_cones = 0;
  EXPECT_NE(message_of(sphere, options).find("Gauss and Bonnet"), std::string::npos);
}

TEST(Discrete_conformal_metric, wrong_demands_are_named)
{
  const Indexed_triangles sphere = samples::bumpy_sphere(12, 9, 0.3), dome = samples::bumpy_dome(8, 6, 0.2);
  Conformal_options options = with_four_cones(sphere);
  options.angles.back().second += 0.25;
  EXPECT_NE(message_of(sphere, options).find("smaller by 0.2"), std::string::npos) << message_of(sphere, options);
  options = with_four_cones(sphere);
  options.angles.back().second = 0;
  EXPECT_NE(message_of(sphere, options).find("not positive"), std::string::npos);
  options.angles.back() = options.angles.front();
  EXPECT_NE(message_of(sphere, options).find("two angles"), std::string::npos);
  options.angles.back().first = Vertex_index(100000);
  EXPECT_NE(message_of(sphere, options).find("no vertex 100000"), std::string::npos);
  const Triangulation t = triangulation_of(dome);
  const auto vertices = t.connectivity().vertices();
  const Vertex_index border = *std::find_if(vertices.begin(), vertices.end(), [&](Vertex_index v) {
    return t.connectivity().is_border(t.connectivity().halfedge(v));
  });
  EXPECT_NE(message_of(dome, {{{border, 3}}}).find("is on the border"), std::string::npos);
  const auto given = CGAL::parameters::boundary_angles(std::vector<std::pair<Vertex_index, double>>{{border, 3}});
  EXPECT_THROW(IT::discrete_conformal_metric(t, given.conformal_boundary(Conformal_boundary::DISK)),
               IT::Invalid_argument_error);
  EXPECT_THROW(IT::discrete_conformal_metric(triangulation_of(sphere), given), IT::Invalid_argument_error);
  const Vertex_index inside = *std::find_if(vertices.begin(), vertices.end(), [&](Vertex_index v) {
    return !t.connectivity().is_border(t.connectivity().halfedge(v));
  });
  EXPECT_NE(message_of(dome, {{{inside, 900}}}).find("angles of the free border"), std::string::npos);
  Indexed_triangles isolated = sphere;
  isolated.points.push_back({0, 0, 9});
  options = with_four_cones(isolated);
  EXPECT_NE(message_of(isolated, options).find("no face"), std::string::npos);
  // A metric that needs a range of u beyond that of double, or more digits, is refused with the range and a vertex.
  options = with_four_cones(sphere);
  for (std::size_t i = 0; i < 4; ++i)
    options.angles[i] = {Vertex_index(std::uint32_t(i)), i == 0 ? 4 * CGAL_PI - 3e-13 : 1e-13};
  try {
    const Discrete_conformal_metric metric = metric_of(sphere, options);
    EXPECT_LT(metric.residual, 1e-9);
  } catch (const IT::Numerical_error& error) {
    EXPECT_NE(std::string(error.what()).find("range of u"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("vertex"), std::string::npos) << error.what();
  }
}

TEST(Discrete_conformal_metric, can_be_interrupted)
{
  const Indexed_triangles sphere = samples::bumpy_sphere(20, 15, 0.3);
  for (int last : {0, 1, 10, 1000}) {
    int calls = 0;
    const auto options = CGAL::parameters::cone_angles(with_four_cones(sphere).angles).visitor([&](double fraction) {
      EXPECT_TRUE(fraction >= 0 && fraction <= 1);
      return ++calls <= last;
    });
    EXPECT_THROW(IT::discrete_conformal_metric(triangulation_of(sphere), options), IT::Cancelled_error);
  }
}

TEST(Discrete_conformal_metric, knows_vertices_that_were_inserted_into_a_closed_surface)
{
  Triangulation sphere = triangulation_of(samples::bumpy_sphere(12, 9, 0.3)),
                dome = triangulation_of(samples::bumpy_dome(8, 6, 0.2));
  for (Triangulation* t : {&sphere, &dome})
    IT::insert_vertex(*t, {t->input().halfedge(IT::Face_index(3)), {0.3, 0.3, 0.4}});
  EXPECT_EQ(IT::discrete_conformal_metric(sphere).u.size(), sphere.connectivity().number_of_vertices());
  EXPECT_THROW(IT::discrete_conformal_metric(dome), IT::Invalid_argument_error);
}

} // namespace
