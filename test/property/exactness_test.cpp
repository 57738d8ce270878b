// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The exact traits make the same decisions, and report the same numbers, as a reference that computes differently with
// 510 digits.

#include "reference/compare_with_reference.h"

#include "samples/sample_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Gluing = samples::Glued_triangles;
using reference::compare;
using reference::Comparison;
using reference::Comparison_options;
using samples::Indexed_triangles;

template <class Surface>
Comparison expect_agreement(const Surface& surface, const Comparison_options& options = {})
{
  Comparison c;
  try {
    c = compare(surface, options);
  } catch (const std::exception& error) {
    ADD_FAILURE() << error.what();
    return c;
  }
  EXPECT_TRUE(c.agrees()) << c.message();
  // There is a wide gap between values taken for zero and all others.
  EXPECT_LT(c.largest_tie_sine, -400);
  EXPECT_GT(c.smallest_sine, -250);
  return c;
}

Indexed_triangles scaled(Indexed_triangles surface, int exponent)
{
  for (std::array<double, 3>& p : surface.points)
    for (double& x : p)
      x = std::ldexp(x, exponent);
  return surface;
}

Gluing scaled(Gluing gluing, int exponent)
{
  for (double& length : gluing.side_lengths)
    length = std::ldexp(length, exponent);
  return gluing;
}

Indexed_triangles stretched(Indexed_triangles surface, double x, double y, double z)
{
  for (std::array<double, 3>& p : surface.points)
    p = {x * p[0], y * p[1], z * p[2]};
  return surface;
}

// Shuffles the faces and turns each of them.
Indexed_triangles shuffled(Indexed_triangles surface, unsigned seed)
{
  std::mt19937 random(seed);
  std::shuffle(surface.triangles.begin(), surface.triangles.end(), random);
  for (auto& triangle : surface.triangles)
    std::rotate(triangle.begin(), triangle.begin() + random() % 3, triangle.end());
  return surface;
}

// A zigzag of strips whose widths are square roots. Only the first and the last fold line have
// vertices at heights 0 and 1: these form a rectangle across all strips, and with it a tie.
Indexed_triangles folded_strips(std::uint32_t number_of_strips, double height = 10000)
{
  Indexed_triangles surface;
  std::vector<std::vector<std::uint32_t>> lines;
  double x = 0;
  for (std::uint32_t k = 0; k <= number_of_strips; ++k) {
    x += k;
    lines.emplace_back();
    for (double z : {-height, 0., 1., height})
      if (k == 0 || k == number_of_strips || std::abs(z) == height) {
        lines.back().push_back(std::uint32_t(surface.points.size()));
        surface.points.push_back({x, double(k % 2), z});
      }
  }
  for (std::uint32_t k = 0; k < number_of_strips; ++k) {
    const std::vector<std::uint32_t>&left = lines[k], &right = lines[k + 1];
    std::size_t a = 0, b = 0;
    while (a + 1 < left.size() || b + 1 < right.size())
      if (b + 1 == right.size() ||
          (a + 1 < left.size() && surface.points[left[a + 1]][2] <= surface.points[right[b + 1]][2])) {
        surface.triangles.push_back({left[a], right[b], left[a + 1]});
        ++a;
      } else {
        surface.triangles.push_back({left[a], right[b], right[b + 1]});
        ++b;
      }
  }
  return surface;
}

// A gluing with lengths that are drawn for each edge.
template <class Draw>
Gluing with_lengths(Gluing gluing, Draw draw)
{
  const reference::Sides sides = reference::sides_of_gluing(gluing.number_of_faces, gluing.glued_sides);
  std::vector<double> length(sides.number_of_sides());
  for (double& x : length)
    x = draw();
  for (std::size_t side = 0; side < gluing.side_lengths.size(); ++side)
    gluing.side_lengths[side] = length[sides.edge[side]];
  return gluing;
}

std::string named(const char* what, double x) { return std::string(what) + " " + std::to_string(x); }

TEST(Exactness, PrismsWhoseFansAreAllTies)
{
  for (std::size_t n : {3, 4, 5, 6, 7, 8, 9, 12, 15, 16, 24, 31, 32, 60})
    for (std::uint64_t seed : {0, 1, 2}) {
      SCOPED_TRACE(named("prism", double(n)));
      expect_agreement(samples::prism(n, seed));
    }
}

// A bump on a grid, whose heights fall to far below the last place of the other coordinates: nearly all edges are
// nearly ties.
TEST(Exactness, BumpsOnGrids)
{
  const std::uint32_t n = 14;
  for (const double steepness : {0.5, 2., 4.}) {
    SCOPED_TRACE(named("bump", steepness));
    Indexed_triangles surface;
    for (std::uint32_t i = 0; i < n; ++i)
      for (std::uint32_t j = 0; j < n; ++j) {
        const double x = i * 10. / n - 5, y = j * 10. / n - 5;
        surface.points.push_back({x, y, 3.1 * std::exp(-steepness * (x * x + y * y))});
      }
    for (std::uint32_t i = 0; i + 1 < n; ++i)
      for (std::uint32_t j = 0; j + 1 < n; ++j) {
        const std::uint32_t a = i * n + j, b = a + n;
        surface.triangles.push_back({a, b, b + 1});
        surface.triangles.push_back({a, b + 1, a + 1});
      }
    EXPECT_GT(expect_agreement(surface).flips, n * n / 4);
  }
}

TEST(Exactness, CapsOfAnyHeight)
{
  for (std::uint64_t seed : {0, 1, 2, 3}) {
    for (int k = 1; k <= 20; ++k) {
      SCOPED_TRACE(k);
      expect_agreement(samples::cap(std::pow(10., -k), seed));
    }
    expect_agreement(samples::cap(1e-100, seed));
    expect_agreement(samples::cap(0, seed));
  }
}

TEST(Exactness, SliverSheets)
{
  for (double x : {1e-3, 1e-6, 1e-9, 1e-12})
    for (double z : {0., 1e-3, 1e-9, 1e-12}) {
      SCOPED_TRACE(named("x", std::log10(x)));
      SCOPED_TRACE(named("z", z));
      expect_agreement(samples::sliver_sheet(14, x, z));
    }
}

TEST(Exactness, HelicalTubes)
{
  for (double pitch : {1e-3, 1., 30., 1e3, 1e5, 1e6, 1e7})
    for (std::size_t n : {4, 5, 30}) {
      SCOPED_TRACE(named("pitch", pitch));
      expect_agreement(samples::helical_tube(n, pitch));
    }
}

TEST(Exactness, GridsOfTies)
{
  for (std::uint64_t seed : {0, 1, 2})
    expect_agreement(samples::random_diagonal_grid(12, 12, seed + 1, seed));
  const Comparison c = expect_agreement(samples::random_diagonal_grid(15, 10));
  EXPECT_EQ(c.flips, 0u);
  EXPECT_EQ(c.ties, 150u);
}

TEST(Exactness, ShearedGrids)
{
  for (double shear : {1., 2., 3., 5., 0.3, 7.7})
    expect_agreement(samples::sheared_grid(8, 8, shear));
  expect_agreement(samples::sheared_grid(3, 3, 1e6));
  expect_agreement(samples::sheared_grid(2, 2, 1e15));
}

TEST(Exactness, LongChainsOfFlips)
{
  expect_agreement(samples::strip(60, 20));
  expect_agreement(samples::strip(60, 20, 1e-5));
  expect_agreement(samples::pillow(40));
  expect_agreement(samples::pillow(40, 1e-8));
}

// Every one of the 5 million flips and each length at the end. It takes some minutes: `scripts/test --all` runs it.
TEST(Exactness, DISABLED_FiveMillionFlips)
{
  Comparison_options options;
  options.run_reference = false;
  options.compare_numbers = false;
  const Comparison c = compare(samples::pillow(3000), options);
  EXPECT_TRUE(c.agrees()) << c.message();
  EXPECT_GT(c.flips, 4500000u);
  RecordProperty("worst_length_in_ulp", std::to_string(c.worst_length));
  RecordProperty("largest_tie_sine", std::to_string(c.largest_tie_sine));
  RecordProperty("smallest_sine", std::to_string(c.smallest_sine));
}

TEST(Exactness, RoundSurfaces)
{
  for (std::size_t n : {1, 4, 16, 64})
    expect_agreement(samples::Schwarz_lantern(8, n));
  expect_agreement(samples::latitude_longitude_sphere(3, 2));
  expect_agreement(samples::latitude_longitude_sphere(24, 12));
  expect_agreement(samples::torus(20, 10));
  expect_agreement(samples::bad_torus(20, 20));
  expect_agreement(samples::bumpy_sphere(20, 11));
  expect_agreement(samples::disk_with_spike(12, 9));
}

TEST(Exactness, RandomGluings)
{
  for (std::uint64_t seed = 0; seed < 4000 && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    const std::size_t n = 1 + seed % 17;
    const bool with_boundary = n % 2 == 1 || seed % 3 == 0;
    expect_agreement(samples::random_gluing(n, seed, with_boundary, seed % 2 == 0));
  }
}

// Terraces, ramps and walls over a sheared grid with small integers: most edges are flat, ties abound, and flips run
// through faces in one plane and across folds. Half of them are rotated, so that almost everything is nearly but not
// exactly flat.
TEST(Exactness, RandomTerraces)
{
  for (std::uint64_t seed = 0; seed < 300 && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const std::size_t n = 3 + seed % 5;
    Indexed_triangles surface = samples::random_diagonal_grid(n, n, seed + 1, 0);
    const double shear = double(random() % 4), stretch = double(1 + random() % 3);
    std::vector<double> height(n + 1);
    for (double& z : height)
      z = double(random() % 3);
    for (std::array<double, 3>& p : surface.points) {
      const double z = height[std::size_t(p[0])] + (random() % 8 == 0 ? 1 : 0);
      p = {p[0] * stretch + shear * p[1], p[1], z};
    }
    if (seed % 2 == 1) {
      const double c = std::cos(double(seed)), s = std::sin(double(seed));
      for (std::array<double, 3>& p : surface.points) {
        p = {c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]};
        p = {p[0], c * p[1] - s * p[2], s * p[1] + c * p[2]};
      }
    }
    expect_agreement(surface);
  }
}

// All triangles are nearly equilateral, so that tests are close calls.
TEST(Exactness, RandomGluingsWithNearTies)
{
  for (std::uint64_t seed = 0; seed < 1000 && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const double epsilon = std::pow(10., -1 - double(seed % 16));
    expect_agreement(with_lengths(samples::random_gluing(2 + 2 * (seed % 6), seed, seed % 3 == 0), [&] {
      return 1 + epsilon * std::uniform_real_distribution<double>(0, 0.9)(random);
    }));
  }
}

// Lengths m, ..., 2 m: ties abound, and the triangle m, m, 2 m has no area. If everything collapses, the package and
// the reference both report that vertices coincide.
TEST(Exactness, RandomGluingsWithIntegerLengths)
{
  int collapsed = 0;
  for (std::uint64_t seed = 0; seed < 3000 && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const std::uint64_t m = 1 + seed % 5;
    const Gluing gluing = with_lengths(samples::random_gluing(2 + 2 * (seed % 6), seed, seed % 3 == 0),
                                       [&] { return double(m + random() % (m + 1)); });
    try {
      const Comparison c = compare(gluing);
      EXPECT_TRUE(c.agrees()) << c.message();
    } catch (const IT::Invalid_surface_error& error) {
      ++collapsed;
      EXPECT_EQ(error.defect(), IT::Invalid_surface_error::Defect::ZERO_LENGTH_EDGE);
      reference::Reference_triangulation<> own(reference::sides_of_gluing(gluing.number_of_faces, gluing.glued_sides),
                                               gluing.side_lengths);
      EXPECT_THROW(own.make_Delaunay(), reference::Coincident_vertices);
    }
  }
  EXPECT_GT(collapsed, 0);
  EXPECT_LT(collapsed, 300);
}

TEST(Exactness, TinyGluings)
{
  expect_agreement(samples::self_glued_triangle());
  expect_agreement(samples::self_glued_sphere());
  expect_agreement(samples::self_glued_sphere(1, 1e8, 1));
  expect_agreement(samples::self_glued_sphere(0.5 + 1e-9, 0.5 + 1e-16, 1));
  expect_agreement(samples::one_vertex_torus(3, 4, 5));
  expect_agreement(samples::one_vertex_torus(1, 1, 1.9999999999999998));
  for (double shear : {1., 10., 100., 123.456})
    expect_agreement(samples::sheared_one_vertex_torus(shear));
}

// The flat torus of a lattice of rectangles.
TEST(Exactness, TiesInGluings)
{
  const Comparison c = expect_agreement(samples::one_vertex_torus(3, 4, 5));
  EXPECT_EQ(c.ties, 1u);
  EXPECT_EQ(c.tessellation.size(), 2u);
}

TEST(Exactness, TiesWithManyIndependentRoots)
{
  for (std::uint32_t n : {2, 4, 8, 12, 16, 20, 24, 40, 60}) {
    SCOPED_TRACE(n);
    EXPECT_EQ(expect_agreement(folded_strips(n)).ties, 1u);
  }
}

TEST(Exactness, IsFreeOfScale)
{
  const std::vector<Indexed_triangles> surfaces = {samples::prism(12, 1), samples::cap(1e-10, 1),
                                                   samples::cap(0),       samples::helical_tube(12, 1e5),
                                                   samples::torus(8, 6),  samples::sliver_sheet(6, 1e-9, 1e-9)};
  for (const Indexed_triangles& surface : surfaces) {
    reference::Exact_triangulation plain = reference::exact_triangulation(surface);
    IT::flip_to_Delaunay(plain);
    for (int k = -300; k <= 300; k += 25) {
      SCOPED_TRACE(k);
      reference::Exact_triangulation other = reference::exact_triangulation(scaled(surface, k));
      IT::flip_to_Delaunay(other);
      EXPECT_TRUE(plain.connectivity() == other.connectivity());
      for (IT::Edge_index e : plain.connectivity().edges())
        EXPECT_EQ(std::ldexp(plain.length(e), k), other.length(e));
    }
    for (int k : {-300, 300}) {
      SCOPED_TRACE(k);
      expect_agreement(scaled(surface, k));
    }
  }
  for (std::uint64_t seed = 0; seed < 20; ++seed)
    for (int k : {-300, -77, 300})
      expect_agreement(scaled(samples::random_gluing(8, seed), k));
}

// Beyond the range in which coordinates keep all their digits an error must say so.
TEST(Exactness, ExtremeScalesAreExactOrRefused)
{
  std::size_t refused = 0;
  for (const Indexed_triangles& surface : {samples::prism(5), samples::cap(1e-10, 1), samples::torus(5, 4)}) {
    reference::Exact_triangulation plain = reference::exact_triangulation(surface);
    IT::flip_to_Delaunay(plain);
    for (int k : {-1000, -900, -700, -500, 500, 700, 900, 1000}) {
      SCOPED_TRACE(k);
      try {
        reference::Exact_triangulation other = reference::exact_triangulation(scaled(surface, k));
        IT::flip_to_Delaunay(other);
        EXPECT_TRUE(plain.connectivity() == other.connectivity());
      } catch (const IT::Invalid_surface_error& error) {
        EXPECT_EQ(error.defect(), IT::Invalid_surface_error::Defect::OUT_OF_RANGE) << error.what();
        ++refused;
      }
    }
  }
  EXPECT_EQ(refused, 0u);
}

TEST(Exactness, ConstrainedEdgesStay)
{
  const std::vector<Indexed_triangles> surfaces = {samples::prism(12),          samples::bad_torus(12, 12),
                                                   samples::cap(1e-12),         samples::cap(0),
                                                   samples::sheared_grid(6, 6), samples::helical_tube(20)};
  std::mt19937 random(5);
  for (const Indexed_triangles& surface : surfaces)
    for (unsigned denominator : {1u, 2u, 5u, 20u}) {
      Comparison_options options;
      const std::size_t n = reference::exact_triangulation(surface).connectivity().number_of_edges();
      for (std::size_t e = 0; e < n; ++e)
        options.is_constrained.push_back(random() % denominator == 0);
      const Comparison c = expect_agreement(surface, options);
      if (denominator == 1) {
        EXPECT_EQ(c.flips, 0u);
      }
    }
}

TEST(Exactness, TheTessellationDoesNotDependOnTheOrder)
{
  const std::vector<Indexed_triangles> surfaces = {samples::prism(16),
                                                   samples::prism(16, 3),
                                                   samples::torus(10, 8),
                                                   samples::random_diagonal_grid(8, 8),
                                                   samples::cap(1e-14),
                                                   samples::cap(0),
                                                   samples::sheared_grid(6, 6, 3),
                                                   samples::sliver_sheet(8),
                                                   samples::helical_tube(20)};
  for (const Indexed_triangles& surface : surfaces) {
    const Comparison plain = expect_agreement(surface);
    for (unsigned seed = 1; seed <= 4; ++seed)
      EXPECT_TRUE(expect_agreement(shuffled(surface, seed)).tessellation == plain.tessellation);
  }
}

TEST(Exactness, IsolatedVerticesAndComponents)
{
  Indexed_triangles two = samples::prism(5);
  const Indexed_triangles other = scaled(samples::torus(5, 4), -30);
  two.points.push_back({1e20, 0, 0});
  const std::uint32_t shift = std::uint32_t(two.points.size());
  two.points.insert(two.points.end(), other.points.begin(), other.points.end());
  for (const auto& t : other.triangles)
    two.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  two.points.push_back({0, 0, 0});
  expect_agreement(two);
}

TEST(Exactness, NeedlesAndTinyFeatures)
{
  for (double z : {1., 1e-20, 1e-60, 1e-100}) {
    SCOPED_TRACE(z);
    expect_agreement(stretched(samples::torus(6, 5), 1, 1, z));
    expect_agreement(stretched(samples::bad_torus(6, 6), 1, z, 1));
    expect_agreement(stretched(samples::prism(7), 1, z, z));
  }
  // far from the origin, where a coordinate keeps few digits
  for (double offset : {1e3, 1e8, 1e14}) {
    Indexed_triangles surface = samples::bumpy_sphere(12, 7);
    for (auto& p : surface.points)
      p[0] += offset;
    const Comparison c = compare(surface);
    EXPECT_TRUE(c.agrees()) << c.message();
  }
}

} // namespace
