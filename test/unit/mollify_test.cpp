// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "samples/sample_gluings.h"
#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/mollify.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

// Whether each corner has the margin, in the arithmetic of double.
bool has_margin(const IT::Delta_complex& complex, const std::vector<double>& lengths, double delta)
{
  const auto length = [&](IT::Halfedge_index h) { return lengths[complex.edge(h).idx()]; };
  for (IT::Halfedge_index h : complex.halfedges())
    if (!complex.is_border(h) && !(length(complex.next(h)) + length(complex.prev(h)) >= length(h) + delta))
      return false;
  return true;
}

IT::Delta_complex one_triangle()
{
  return IT::make_Delta_complex_from_triangles(3, std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}});
}

struct Case
{
  IT::Delta_complex complex;
  std::vector<double> lengths;
};

Case sample(const std::string& name)
{
  const auto surface = std::get<samples::Indexed_triangles>(samples::make_sample(name));
  Case result;
  result.complex = IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles);
  for (IT::Edge_index e : result.complex.edges()) {
    const IT::Halfedge_index h = result.complex.halfedge(e);
    const auto &p = surface.points[result.complex.source(h).idx()], &q = surface.points[result.complex.target(h).idx()];
    result.lengths.push_back(std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]));
  }
  return result;
}

IT::Mollification_report mollify(const IT::Delta_complex& complex, std::vector<double>& lengths, double delta,
                                 bool is_local)
{
  return (is_local ? IT::mollify_lengths_locally : IT::mollify_lengths)(complex, lengths, delta);
}

} // namespace

TEST(Mollify, leaves_good_triangles_alone)
{
  for (const bool is_local : {false, true}) {
    std::vector<double> lengths = {3, 4, 5};
    const IT::Mollification_report report = mollify(one_triangle(), lengths, 1e-3, is_local);
    EXPECT_EQ(lengths, (std::vector<double>{3, 4, 5}));
    EXPECT_EQ(report.epsilon, 0);
    EXPECT_EQ(report.number_of_changed_edges, 0u);
    EXPECT_EQ(report.largest_relative_change, 0);
    EXPECT_DOUBLE_EQ(report.delta, 4e-3);
  }
}

TEST(Mollify, global_adds_the_smallest_epsilon)
{
  // The deficit of the flat corner is delta: one half of the mean length, 8/3.
  std::vector<double> lengths = {2, 2, 4};
  const IT::Mollification_report report = IT::mollify_lengths(one_triangle(), lengths, 0.5);
  EXPECT_DOUBLE_EQ(report.epsilon, 4. / 3);
  EXPECT_EQ(report.number_of_changed_edges, 3u);
  EXPECT_DOUBLE_EQ(report.largest_relative_change, 2. / 3);
  EXPECT_DOUBLE_EQ(lengths[2], 4 + 4. / 3);
}

TEST(Mollify, local_raises_the_shorter_side_first)
{
  std::vector<double> lengths = {1, 3, 4}; // delta = 0.25 * 8/3 = 2/3
  const IT::Mollification_report report = IT::mollify_lengths_locally(one_triangle(), lengths, 0.25);
  EXPECT_DOUBLE_EQ(lengths[0], 1 + 2. / 3);
  EXPECT_EQ(lengths[1], 3);
  EXPECT_EQ(lengths[2], 4);
  EXPECT_EQ(report.number_of_changed_edges, 1u);
  EXPECT_DOUBLE_EQ(report.epsilon, 2. / 3);
  EXPECT_DOUBLE_EQ(report.largest_relative_change, 2. / 3);
}

TEST(Mollify, repairs_lengths_that_no_triangle_has)
{
  for (const bool is_local : {false, true})
    for (const double delta : {0., 1e-6, 0.1, 1., 10.}) {
      std::vector<double> lengths = {1, 1, 7};
      const IT::Mollification_report report = mollify(one_triangle(), lengths, delta, is_local);
      EXPECT_TRUE(has_margin(one_triangle(), lengths, report.delta)) << delta;
    }
}

TEST(Mollify, accepts_an_edge_of_length_zero)
{
  for (const bool is_local : {false, true}) {
    std::vector<double> lengths = {0, 1, 1};
    const IT::Mollification_report report = mollify(one_triangle(), lengths, 0.1, is_local);
    EXPECT_TRUE(has_margin(one_triangle(), lengths, report.delta));
    EXPECT_TRUE(std::isinf(report.largest_relative_change));
  }
}

TEST(Mollify, reaches_the_margin_on_every_gluing)
{
  std::mt19937_64 random(5);
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const auto surface = samples::random_gluing(2 + 2 * (seed % 4), seed, seed % 2 == 0);
    const IT::Delta_complex complex = IT::make_Delta_complex_from_gluing(surface.number_of_faces, surface.glued_sides);
    for (const double delta : {0., 1e-9, 0.01, 0.7, 3.})
      for (const bool is_local : {false, true}) {
        std::vector<double> lengths;
        for (std::size_t e = 0; e < complex.number_of_edges(); ++e)
          lengths.push_back(std::ldexp(double(random() >> 11), -53 - int(random() % 12)));
        const std::vector<double> old = lengths;
        const IT::Mollification_report report = mollify(complex, lengths, delta, is_local);
        EXPECT_TRUE(has_margin(complex, lengths, report.delta)) << seed << ' ' << delta;
        const double longest = *std::max_element(old.begin(), old.end());
        for (std::size_t e = 0; e < old.size(); ++e) {
          EXPECT_GE(lengths[e], old[e]);
          // No edge is raised beyond what the scheme allows.
          if (is_local) {
            EXPECT_LE(lengths[e], (std::max)(longest, report.delta) * (1 + 1e-14));
          }
        }
      }
  }
}

TEST(Mollify, local_changes_fewer_edges_than_global)
{
  const std::pair<const char*, double> cases[] = {{"cap", 1e-2}, {"disk-with-spike", 0.5}, {"bad-torus", 0.2}};
  for (const auto& [name, delta] : cases) {
    Case global = sample(name), local = global;
    const IT::Mollification_report of_global = IT::mollify_lengths(global.complex, global.lengths, delta);
    const IT::Mollification_report of_local = IT::mollify_lengths_locally(local.complex, local.lengths, delta);
    EXPECT_TRUE(has_margin(global.complex, global.lengths, of_global.delta)) << name;
    EXPECT_TRUE(has_margin(local.complex, local.lengths, of_local.delta)) << name;
    EXPECT_EQ(of_global.number_of_changed_edges, global.lengths.size()) << name;
    EXPECT_LT(of_local.number_of_changed_edges, local.lengths.size()) << name;
  }
}

TEST(Mollify, refuses_what_is_no_length)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity, -1.}) {
    std::vector<double> lengths = {1, bad, bad};
    try {
      IT::mollify_lengths_locally(one_triangle(), lengths, 0.1);
      FAIL() << bad;
    } catch (const IT::Invalid_surface_error& error) {
      EXPECT_EQ(error.element(), 1u);
      EXPECT_EQ(error.count(), 2u);
    }
    std::vector<double> good = {1, 1, 1};
    EXPECT_THROW(IT::mollify_lengths(one_triangle(), good, bad), IT::Invalid_surface_error);
  }
}
