// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Twists skip exactly the flips that would be made one by one.

#include "samples/sample_exact_gluings.h"
#include "samples/sample_gluings.h"

#include <CGAL/Intrinsic_triangulations/internal/engine/history/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Delaunay_tessellation.h>
#include <CGAL/Intrinsic_triangulations/verify_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/untwist.h>

#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Edge_index;
using IT::Exact_gluing;
using IT::Integer;
using IT::Rational;
using IT::Untwisting;

const Integer trillion("1000000000000");

struct Edge_flags
{
  using key_type = Edge_index;
  using value_type = bool;
  using reference = bool;
  using category = boost::readable_property_map_tag;
  friend bool get(const Edge_flags& map, Edge_index e) { return (*map.flags)[e.idx()]; }
  const std::vector<bool>* flags;
};

auto fast_triangulation(const Exact_gluing& gluing)
{
  return IT::intrinsic_Delaunay_triangulation(gluing, CGAL::parameters::fast_forward(true));
}

std::vector<Rational> sorted(std::vector<Rational> numbers)
{
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

std::vector<Rational> squares_of(const Exact_gluing& gluing)
{
  return gluing.lengths.empty() ? gluing.squared_lengths : IT::squared_lengths(gluing.lengths);
}

// The squared lengths after untwist(), in order.
std::vector<Rational> untwisted(Exact_gluing gluing)
{
  std::vector<Rational> squares = squares_of(gluing);
  EXPECT_TRUE(IT::untwist(gluing.complex, squares).is_complete);
  EXPECT_TRUE(gluing.complex.is_valid(true));
  return sorted(std::move(squares));
}

// The common part of two Delaunay triangulations of a surface: the edges that are not ties, with their numbers of
// crossings and their lengths.
using Edges = std::vector<std::tuple<Integer, double>>;

Edges edges_of(const IT::Gluing_triangulation<IT::Filtered_edge_length_traits>& result)
{
  const auto& triangulation = result.triangulation;
  const IT::Delaunay_tessellation tessellation(triangulation);
  Edges edges;
  for (Edge_index e : triangulation.connectivity().edges())
    if (!tessellation.is_tie(e))
      edges.emplace_back(result.untwisting.crossings.crossings(e), triangulation.length(e));
  std::sort(edges.begin(), edges.end());
  return edges;
}

void expect_same(const Edges& a, const Edges& b)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(std::get<0>(a[i]), std::get<0>(b[i]));
    EXPECT_NEAR(std::get<1>(a[i]), std::get<1>(b[i]),
                1e-14 * std::get<1>(b[i])); // both within one unit in the last place
  }
}

// Compares the two ways, and the counts with those of the integers that know the positions of crossings. Returns the
// number of flips.
Integer compare(const Exact_gluing& gluing)
{
  const auto plain = IT::intrinsic_Delaunay_triangulation(gluing), fast = fast_triangulation(gluing);
  EXPECT_EQ(plain.report.status, IT::Flip_status::DELAUNAY);
  EXPECT_EQ(fast.report.status, IT::Flip_status::DELAUNAY);
  EXPECT_TRUE(fast.triangulation.connectivity().is_valid(true));
  EXPECT_TRUE(IT::verify_Delaunay(fast.triangulation).is_Delaunay());
  expect_same(edges_of(plain), edges_of(fast));
  const IT::internal::Normal_coordinates& coordinates =
    IT::internal::engine(plain.triangulation).correspondence().coordinates();
  for (Edge_index e : gluing.complex.edges())
    EXPECT_EQ(plain.untwisting.crossings.crossings(e), coordinates.crossings(e));
  return Integer(plain.report.flips);
}

// A random gluing with tubes at its loops, by the circumference times a fraction; whether this is a tie or not.
Exact_gluing random_tubes(std::uint64_t seed, int largest_twist, std::size_t& number_of_tubes)
{
  std::mt19937_64 random(seed);
  const auto below = [&random](std::uint64_t n) { return random() % n; };
  const bool has_border = below(2) == 0;
  const std::size_t faces = has_border ? 1 + below(5) : 2 + 2 * below(3);
  const samples::Glued_triangles skeleton = samples::random_gluing(faces, seed, has_border, true);
  samples::Tubed_triangles triangles{faces, skeleton.glued_sides, {}};
  for (double length : skeleton.side_lengths)
    triangles.squared_side_lengths.push_back(Rational(std::round(length * length * 64)) / 64);
  const IT::Delta_complex complex = triangles.gluing().complex;
  std::vector<bool> is_loop, is_glued(3 * faces, false);
  for (IT::Face_index f : complex.faces()) {
    IT::Halfedge_index h = complex.halfedge(f);
    for (int i = 0; i < 3; ++i, h = complex.next(h))
      is_loop.push_back(complex.is_loop(complex.edge(h)));
  }
  const auto shear = [&] {
    const std::uint64_t denominator = 1 + below(4);
    return Rational(std::int64_t(below(2 * largest_twist + 1)) - largest_twist) +
           Rational(below(denominator), denominator);
  };
  const auto height = [&] { return Rational(1 + below(40), 1 + below(40)); };
  for (std::size_t pair = 0; pair < skeleton.glued_sides.size(); ++pair) {
    is_glued[skeleton.glued_sides[pair][0]] = is_glued[skeleton.glued_sides[pair][1]] = true;
    for (int n = int(below(3)); is_loop[skeleton.glued_sides[pair][0]] && n > 0; --n, ++number_of_tubes)
      triangles.insert_tube(pair, height(), shear());
  }
  for (std::uint32_t side = 0; side < 3 * faces; ++side)
    if (!is_glued[side] && is_loop[side] && below(2) == 0) {
      triangles.append_tube(side, height(), shear());
      ++number_of_tubes;
    }
  return triangles.gluing();
}

} // namespace

TEST(Untwist, reduces_the_lattice_of_a_torus)
{
  const std::vector<Rational> square{1, 1, 2};
  for (const Integer& shear :
       std::vector<Integer>{trillion, trillion + 1, -trillion, trillion * 5 + 3, 0, 1, -1, 2, -2, 3, 7}) {
    EXPECT_EQ(untwisted(samples::sheared_one_vertex_torus(shear)), square) << shear;
  }
  for (std::size_t n = 2; n <= 60; ++n)
    EXPECT_EQ(untwisted(samples::Fibonacci_torus(n)), square) << n;

  // Whichever of the sides is the first
  const std::array<Integer, 2> u{1, 0}, v{trillion, 1}, w{-trillion - 1, -1};
  for (const auto& [first, second] : std::vector<std::pair<std::array<Integer, 2>, std::array<Integer, 2>>>{
         {u, v}, {v, u}, {u, w}, {w, u}, {v, w}, {w, v}})
    EXPECT_EQ(untwisted(samples::lattice_torus(first, second)), square) << first[0] << ' ' << second[0];

  // A shear by one is one flip, as long as there is no tie.
  Exact_gluing torus = samples::lattice_torus({Integer(3), Integer(0)}, {3 * trillion + 1, Integer(1)});
  const Untwisting untwisting = IT::untwist(torus.complex, torus.squared_lengths);
  EXPECT_EQ(sorted(torus.squared_lengths), (std::vector<Rational>{2, 5, 5}));
  ASSERT_GE(untwisting.twists.size(), 1u);
  EXPECT_EQ(abs(untwisting.twists[0].power), trillion + 1);
  EXPECT_LE(untwisting.number_of_steps, 3 * untwisting.twists.size());
}

TEST(Untwist, finds_the_Delaunay_triangulation_of_sheared_surfaces)
{
  const auto torus = fast_triangulation(samples::sheared_one_vertex_torus(trillion));
  EXPECT_EQ(torus.report.status, IT::Flip_status::DELAUNAY);
  EXPECT_EQ(torus.report.flips, 0u);
  EXPECT_TRUE(IT::verify_Delaunay(torus.triangulation).is_Delaunay());
  // The input edges (1, 0), (n, 1) and (n + 1, 1) cross (1, 0), (0, 1) and (±1, 1), which edges of the square torus
  // are.
  std::vector<Integer> counts;
  for (Edge_index e : torus.triangulation.connectivity().edges())
    counts.push_back(torus.untwisting.crossings.crossings(e));
  std::sort(counts.begin(), counts.end());
  EXPECT_EQ(counts[0], -1);
  // The segment (0, 1) is crossed |det((n, 1), (0, 1))| − 1 and |det((n + 1, 1), (0, 1))| − 1 times, and once less by
  // (1, 0) than its determinant.
  EXPECT_EQ(counts[2], (trillion - 1) + trillion);

  const auto plain = IT::intrinsic_Delaunay_triangulation(samples::sheared_genus_two(0, 0));
  const auto genus_two = fast_triangulation(samples::sheared_genus_two(trillion, -trillion));
  EXPECT_EQ(genus_two.triangulation.connectivity().number_of_vertices(), 1u);
  EXPECT_EQ(genus_two.report.status, IT::Flip_status::DELAUNAY);
  EXPECT_TRUE(IT::verify_Delaunay(genus_two.triangulation).is_Delaunay());
  Edges a = edges_of(plain), b = edges_of(genus_two);
  ASSERT_EQ(a.size(), b.size());
  for (Edges* edges : {&a, &b})
    std::sort(edges->begin(), edges->end(),
              [](const auto& x, const auto& y) { return std::get<1>(x) < std::get<1>(y); });
  for (std::size_t i = 0; i < a.size(); ++i)
    EXPECT_NEAR(std::get<1>(a[i]), std::get<1>(b[i]), 1e-14);
}

TEST(Untwist, lengths_that_are_doubles)
{
  // Flips one by one would lay out edges that cross up to 200,000 others, thousands of times.
  const samples::Glued_triangles sheared = samples::sheared_one_vertex_torus(1e5);
  Exact_gluing gluing;
  gluing.complex = IT::make_Delta_complex_from_gluing(sheared.number_of_faces, sheared.glued_sides);
  gluing.lengths = {sheared.side_lengths[0], sheared.side_lengths[1], sheared.side_lengths[2]};
  const auto result = fast_triangulation(gluing);
  EXPECT_EQ(result.report.status, IT::Flip_status::DELAUNAY);
  EXPECT_TRUE(IT::verify_Delaunay(result.triangulation).is_Delaunay());
  EXPECT_GT(result.untwisting.number_of_flips, 99990);
  for (Edge_index e : gluing.complex.edges())
    EXPECT_NEAR(result.triangulation.length(e), 1, 0.5);
}

TEST(Untwist, is_what_flips_do_one_by_one)
{
  std::size_t number_of_tubes = 0;
  Integer flips = 0, skipped = 0;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    SCOPED_TRACE(seed);
    const Exact_gluing gluing = random_tubes(seed, seed % 10 == 0 ? 1000 : 20, number_of_tubes);
    flips += compare(gluing);
    Exact_gluing copy = gluing;
    skipped += IT::untwist(copy.complex, copy.squared_lengths).number_of_flips;
  }
  EXPECT_GT(number_of_tubes, 100u);
  EXPECT_GT(skipped, 2000);
  EXPECT_GE(flips, skipped);
}

TEST(Untwist, the_order_of_flips_of_a_torus_does_not_matter)
{
  std::mt19937_64 random(1);
  for (int i = 0; i < 200; ++i) {
    const auto coordinate = [&] { return Integer(std::int64_t(random() % 41) - 20); };
    std::array<Integer, 2> u{coordinate(), coordinate()}, v{coordinate(), coordinate()};
    if (u[0] * v[1] != u[1] * v[0]) {
      SCOPED_TRACE(i);
      compare(samples::lattice_torus(u, v));
    }
  }
}

TEST(Untwist, leaps_are_flips)
{
  std::mt19937_64 random(2);
  for (int i = 0; i < 300; ++i) {
    // A torus after some flips, and a tube in it
    IT::Delta_complex complex = samples::lattice_torus({Integer(1), Integer(0)}, {Integer(0), Integer(1)}).complex;
    IT::Crossing_counts counts(complex);
    IT::internal::Normal_coordinates coordinates(complex);
    const auto flip = [&](IT::Delta_complex& c, IT::Crossing_counts& n, Edge_index e) {
      n.flip(c, e);
      coordinates.flip(c.hinge(e));
      c.flip(e);
      EXPECT_EQ(n.crossings(e), coordinates.crossings(e));
    };
    for (std::uint64_t n = random() % 12; n > 0; --n)
      flip(complex, counts, Edge_index(random() % 3));
    const IT::Halfedge_index loop(random() % 6);
    ASSERT_TRUE(IT::is_tube(complex, loop));
    const int power = 4 * (int(random() % 41) - 20);
    IT::Crossing_counts leapt = counts;
    leapt.twist(complex, IT::tube(complex, loop), power);
    IT::Delta_complex flipped = complex;
    for (int k = 0; k < std::abs(power); ++k)
      flip(flipped, counts, power > 0 ? IT::tube(flipped, loop).right : IT::tube(flipped, loop).left);
    for (Edge_index e : complex.edges())
      EXPECT_EQ(leapt.crossings(e), counts.crossings(e)) << i << ": " << power;
    for (IT::Halfedge_index h : complex.halfedges()) {
      EXPECT_EQ(flipped.next(h), complex.next(h));
      EXPECT_EQ(flipped.face(h), complex.face(h));
      EXPECT_EQ(flipped.target(h), complex.target(h));
    }
  }
}

TEST(Untwist, leaves_ties_alone)
{
  // A rectangle has two diagonals of the same length: nothing to do.
  Exact_gluing torus = samples::lattice_torus({Integer(2), Integer(0)}, {Integer(0), Integer(1)});
  const std::vector<Rational> before = torus.squared_lengths;
  EXPECT_EQ(IT::untwist(torus.complex, torus.squared_lengths).number_of_flips, 0);
  EXPECT_EQ(torus.squared_lengths, before);

  // Crosswise edges of the same length lean to both sides.
  torus = samples::lattice_torus({Integer(2), Integer(0)}, {Integer(-1), Integer(5)});
  EXPECT_EQ(IT::untwist(torus.complex, torus.squared_lengths).number_of_flips, 0);
}

TEST(Untwist, leaves_constrained_edges_alone)
{
  const Exact_gluing gluing = samples::sheared_genus_two(trillion, 1000);
  std::vector<bool> flags(gluing.complex.number_of_edges(), false);
  std::size_t constrained = 0; // that across the tube of length 10^12
  for (Edge_index e : gluing.complex.edges())
    if (gluing.squared_lengths[e.idx()] == trillion * trillion + 1)
      flags[constrained = e.idx()] = true;
  ASSERT_EQ(std::count(flags.begin(), flags.end(), true), 1);
  std::vector<Edge_index> edges;
  const Edge_flags is_constrained{&flags};
  Exact_gluing copy = gluing;
  const Untwisting untwisting =
    IT::untwist(copy.complex, copy.squared_lengths, CGAL::parameters::edge_is_constrained_map(is_constrained));
  EXPECT_EQ(copy.squared_lengths[constrained], gluing.squared_lengths[constrained]);
  EXPECT_GE(untwisting.number_of_flips, 999);
  EXPECT_LE(untwisting.number_of_flips, 1001);
  EXPECT_TRUE(untwisting.crossings.is_original(Edge_index(std::uint32_t(constrained))));
}

TEST(Untwist, leaves_what_is_no_flat_tube_alone)
{
  // Loops of different lengths, and no area
  samples::Tubed_triangles tube;
  tube.number_of_faces = 2;
  tube.glued_sides = {{1, 4}, {2, 5}};
  const Rational below(1), above(9, 8), slant = Rational(400), other = Rational(401);
  for (const auto& [lower, upper, right, left] : std::vector<std::array<Rational, 4>>{
         {below, above, slant, other}, {Rational(4), Rational(4), Rational(10000), Rational(102 * 102)}}) {
    tube.squared_side_lengths = {lower, right, left, upper, right, left};
    Exact_gluing gluing = tube.gluing();
    const std::vector<Rational> before = gluing.squared_lengths;
    EXPECT_EQ(IT::untwist(gluing.complex, gluing.squared_lengths).number_of_flips, 0);
    EXPECT_EQ(gluing.squared_lengths, before);
  }
  // Lengths that are not those of a surface are returned as they are, for others to report.
  for (const int number : {-5, 0, 9}) {
    Exact_gluing torus = samples::sheared_one_vertex_torus(Integer(0));
    torus.squared_lengths[1] = number;
    EXPECT_EQ(IT::untwist(torus.complex, torus.squared_lengths).number_of_flips, 0);
    EXPECT_THROW(fast_triangulation(torus), IT::Invalid_surface_error);
  }
  Exact_gluing torus = samples::sheared_one_vertex_torus(Integer(0));
  torus.squared_lengths.pop_back();
  EXPECT_THROW(IT::untwist(torus.complex, torus.squared_lengths), IT::Invalid_surface_error);
}

TEST(Untwist, tubes_beside_faces_of_area_zero)
{
  // Triangles with sides 1, 1 and 2, the short ones of which are glued, close a tube of length 2 at one end or at both.
  for (const bool has_border : {true, false}) {
    samples::Tubed_triangles triangles{1, {{0, 1}}, {1, 1, 4}};
    const std::uint32_t top = triangles.append_tube(2, Rational(1), Rational(-50, 3));
    if (!has_border) {
      const auto side = std::uint32_t(3 * triangles.number_of_faces++);
      triangles.squared_side_lengths.insert(triangles.squared_side_lengths.end(), {1, 1, 4});
      triangles.glued_sides.push_back({side, side + 1});
      triangles.glued_sides.push_back({side + 2, top});
    }
    EXPECT_GT(compare(triangles.gluing()), 10);
  }
}

TEST(Untwist, numbers_of_ten_thousand_digits)
{
  const Integer huge = pow(Integer(10), 10000);
  const auto result = fast_triangulation(samples::sheared_one_vertex_torus(huge));
  EXPECT_EQ(result.report.status, IT::Flip_status::DELAUNAY);
  EXPECT_EQ(result.untwisting.number_of_flips, huge);
  EXPECT_EQ(untwisted(samples::Fibonacci_torus(5000)), (std::vector<Rational>{1, 1, 2}));
}

TEST(Untwist, is_ended_by_a_visitor)
{
  struct Impatient_visitor
  {
    int patience;
    bool go_further(const IT::Progress&) { return patience-- > 0; }
  };
  for (int patience : {0, 1, 2, 5}) {
    Impatient_visitor visitor;
    visitor.patience = patience;
    Exact_gluing torus = samples::Fibonacci_torus(60);
    const Untwisting untwisting =
      IT::untwist(torus.complex, torus.squared_lengths, CGAL::parameters::visitor(std::ref(visitor)));
    EXPECT_FALSE(untwisting.is_complete);
    EXPECT_EQ(untwisting.twists.size(), std::size_t(patience));
    // The rest is the same torus.
    EXPECT_EQ(untwisted(torus), (std::vector<Rational>{1, 1, 2}));
    visitor.patience = patience;
    EXPECT_THROW(IT::intrinsic_Delaunay_triangulation(samples::Fibonacci_torus(60),
                                                      CGAL::parameters::fast_forward(true).visitor(std::ref(visitor))),
                 IT::Cancelled_error);
  }
}

TEST(Untwist, is_repeated_by_its_twists)
{
  const Exact_gluing gluing = samples::sheared_genus_two(100, -57);
  Exact_gluing fast = gluing, slow = gluing;
  const Untwisting untwisting = IT::untwist(fast.complex, fast.squared_lengths);
  IT::Crossing_counts crossings(slow.complex);
  for (const IT::Twist& twist : untwisting.twists)
    for (Integer k = abs(twist.power); k > 0; --k) {
      const IT::Tube tube = IT::tube(slow.complex, twist.loop);
      const Edge_index e = twist.power > 0 ? tube.right : tube.left;
      crossings.flip(slow.complex, e);
      slow.complex.flip(e);
    }
  for (IT::Halfedge_index h : fast.complex.halfedges())
    EXPECT_EQ(fast.complex.next(h), slow.complex.next(h));
  for (Edge_index e : fast.complex.edges())
    EXPECT_EQ(untwisting.crossings.crossings(e), crossings.crossings(e));
}
