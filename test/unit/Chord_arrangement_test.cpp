// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pieces of a disk between two families of chords, against straight chords of a convex polygon.

#include "library/parameterization/Chord_arrangement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace {

using CGAL::Intrinsic_triangulations::internal::Chord_arrangement;
using Chord = Chord_arrangement::Chord;
using Point = std::array<double, 2>;

bool do_cross(const Chord& c, const Chord& d)
{
  const auto [low, high] = std::minmax(c.a, c.b);
  const auto is_inside = [low = low, high = high](std::uint32_t x) { return low < x && x < high; };
  const bool share = c.a == d.a || c.a == d.b || c.b == d.a || c.b == d.b;
  return !share && is_inside(d.a) != is_inside(d.b);
}

Point on_circle(std::uint32_t x, std::uint32_t n)
{
  return {std::cos(6.283185307 * x / n), std::sin(6.283185307 * x / n)};
}

Point crossing(const Point& p, const Point& q, const Point& r, const Point& s)
{
  const auto side = [](const Point& o, const Point& v, const Point& w) {
    return (v[0] - o[0]) * (w[1] - o[1]) - (v[1] - o[1]) * (w[0] - o[0]);
  };
  const double a = side(r, s, p), b = side(r, s, q), t = a / (a - b);
  return {p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])};
}

double area(const std::vector<Point>& polygon)
{
  double result = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    result += (p[0] * q[1] - p[1] * q[0]) / 2;
  }
  return result;
}

TEST(Chord_arrangement, has_the_pieces_of_straight_chords)
{
  std::mt19937 random(5);
  Chord_arrangement arrangement;
  std::size_t all_crossings = 0;
  for (int run = 0; run < 1000; ++run) {
    const std::uint32_t n = std::uint32_t(3 + random() % 80);
    std::array<std::vector<Chord>, 2> families;
    for (std::vector<Chord>& family : families)
      for (unsigned long i = random() % 100; i > 0; --i) {
        const Chord c{std::uint32_t(random() % n), std::uint32_t(random() % n)};
        const std::uint32_t distance = (c.b + n - c.a) % n;
        const auto is_same = [&](const Chord& d) { return std::minmax(c.a, c.b) == std::minmax(d.a, d.b); };
        const auto is_taken = [&](const std::vector<Chord>& f) { return std::any_of(f.begin(), f.end(), is_same); };
        if (distance > 1 && distance < n - 1 && !is_taken(families[0]) && !is_taken(families[1]) &&
            std::none_of(family.begin(), family.end(), [&](const Chord& d) { return do_cross(c, d); }))
          family.push_back(c);
      }
    std::vector<Chord> chords = families[0];
    chords.insert(chords.end(), families[1].begin(), families[1].end());
    std::set<std::array<std::uint32_t, 2>> expected, found;
    for (std::uint32_t i = 0; i < families[0].size(); ++i)
      for (std::uint32_t j = std::uint32_t(families[0].size()); j < chords.size(); ++j)
        if (do_cross(chords[i], chords[j]))
          expected.insert({i, j});
    arrangement.build(n, chords, families[0].size());
    std::vector<Point> points;
    for (std::uint32_t x = 0; x < n; ++x)
      points.push_back(on_circle(x, n));
    for (const auto& x : arrangement.crossings()) {
      found.insert({x.first, x.second});
      points.push_back(crossing(points[chords[x.first].a], points[chords[x.first].b], points[chords[x.second].a],
                                points[chords[x.second].b]));
    }
    EXPECT_EQ(found, expected);
    EXPECT_EQ(found.size(), arrangement.crossings().size());
    all_crossings += found.size();
    std::size_t pieces = 0;
    double sum = 0;
    arrangement.for_each_piece([&](const std::vector<Chord_arrangement::Dart>& piece) {
      std::vector<Point> polygon;
      for (const auto& d : piece)
        polygon.push_back(points[d.source]);
      const double a = area(polygon);
      EXPECT_GT(a, -1e-12); // zero where more than two straight chords meet
      sum += a;
      ++pieces;
    });
    EXPECT_EQ(pieces, 1 + chords.size() + found.size());
    EXPECT_NEAR(sum, area({points.begin(), points.begin() + n}), 1e-12);
  }
  EXPECT_GT(all_crossings, 3000u);
}

TEST(Chord_arrangement, takes_time_for_its_pieces_not_for_pairs_of_chords)
{
  // Around one corner each, without a crossing.
  const std::uint32_t n = 200000;
  std::vector<Chord> chords;
  for (std::uint32_t x = 1; x < n / 4; ++x)
    chords.push_back({n / 4 - x, n / 4 + x});
  const std::size_t first = chords.size();
  for (std::uint32_t x = 1; x < n / 4; ++x)
    chords.push_back({3 * (n / 4) - x, 3 * (n / 4) + x - 1});
  Chord_arrangement arrangement;
  const std::clock_t start = std::clock();
  arrangement.build(n, chords, first);
  std::size_t pieces = 0;
  arrangement.for_each_piece([&](const auto&) { ++pieces; });
  EXPECT_EQ(pieces, chords.size() + 1);
  EXPECT_LT(double(std::clock() - start) / CLOCKS_PER_SEC, 10); // all pairs: minutes
}

} // namespace
