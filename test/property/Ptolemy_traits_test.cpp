// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// λ-lengths: identities and the flip algorithm against rational numbers.

#include "property/flip_test_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Ptolemy_traits.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Exact = CGAL::Gmpq;
template <class FT>
using Triangulation = IT::Intrinsic_triangulation<IT::Ptolemy_traits<FT>>;

struct Five
{
  Exact ij, jk, ki, il, lj;
};

template <class FT>
bool is_Delaunay(const Five& f)
{
  using Traits = IT::Ptolemy_traits<FT>;
  const auto edge = [](const Exact& x) {
    return typename Traits::Construct_edge_data().from_length(FT(CGAL::to_double(x)));
  };
  const auto ij = edge(f.ij), jk = edge(f.jk), ki = edge(f.ki), il = edge(f.il), lj = edge(f.lj);
  const typename Traits::Face_data face{};
  return typename Traits::Is_locally_Delaunay()({ij, jk, ki, il, lj, face, face});
}

Exact flipped(const Five& f)
{
  using Traits = IT::Ptolemy_traits<Exact>;
  const Traits::Face_data face{};
  Traits::Flipped_hinge_data result;
  EXPECT_TRUE(Traits::Construct_flipped_hinge()({f.ij, f.jk, f.ki, f.il, f.lj, face, face}, result));
  return result.kl;
}

// The sum of the two cotangents, up to a positive factor: the oracle for triangles that obey the triangle inequality.
// By squared areas, without roots.
int sign_of_cotangents(const Five& f)
{
  const auto square = [](const Exact& x) { return x * x; };
  const auto squared_area = [&](const Exact& a, const Exact& b, const Exact& c) -> Exact {
    return (a + b + c) * (a + b - c) * (a - b + c) * (b + c - a);
  };
  const Exact p = square(f.jk) + square(f.ki) - square(f.ij), q = square(f.il) + square(f.lj) - square(f.ij);
  const Exact a = squared_area(f.ij, f.jk, f.ki), b = squared_area(f.ij, f.il, f.lj);
  // p / √a + q / √b
  const int sign_p = CGAL::sign(p), sign_q = CGAL::sign(q);
  if (sign_p == sign_q || sign_q == 0)
    return sign_p;
  if (sign_p == 0)
    return sign_q;
  return CGAL::sign(Exact(square(p) * b - square(q) * a)) * sign_p;
}

TEST(Ptolemy_traits, identities_hold_in_rational_numbers)
{
  std::mt19937 random(1);
  int euclidean = 0, number_of_Delaunay = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto length = [&] { return Exact(int(random() % 1000) + 1, int(random() % 16) + 16); };
    const Five f{length(), length(), length(), length(), length()};
    const Exact kl = flipped(f);
    EXPECT_EQ(flipped({kl, f.il, f.ki, f.jk, f.lj}), f.ij) << "a second flip undoes the first";
    const std::array<Exact, 4> w{length(), length(), length(), length()}; // of i, j, k and l
    const Five scaled{f.ij * w[0] * w[1], f.jk * w[1] * w[2], f.ki * w[2] * w[0], f.il * w[0] * w[3],
                      f.lj * w[3] * w[1]};
    EXPECT_EQ(flipped(scaled), kl * w[2] * w[3]) << "flips commute with scaling";
    const Five g{Exact(CGAL::to_double(f.ij)), Exact(CGAL::to_double(f.jk)), Exact(CGAL::to_double(f.ki)),
                 Exact(CGAL::to_double(f.il)), Exact(CGAL::to_double(f.lj))};
    EXPECT_EQ(is_Delaunay<double>(g), is_Delaunay<Exact>(g));
    EXPECT_TRUE(is_Delaunay<Exact>(g) || is_Delaunay<Exact>({flipped(g), g.il, g.ki, g.jk, g.lj}))
      << "one of the two diagonals is Delaunay";
    const auto is_triangle = [](const Exact& a, const Exact& b, const Exact& c) {
      return a < b + c && b < a + c && c < a + b;
    };
    if (!is_triangle(g.ij, g.jk, g.ki) || !is_triangle(g.ij, g.il, g.lj))
      continue;
    ++euclidean;
    number_of_Delaunay += is_Delaunay<double>(g);
    EXPECT_EQ(is_Delaunay<double>(g), sign_of_cotangents(g) >= 0);
  }
  EXPECT_GT(euclidean, 300);
  EXPECT_GT(number_of_Delaunay, 100);
  EXPECT_LT(number_of_Delaunay, euclidean - 50);
}

TEST(Ptolemy_traits, ties_and_near_ties_are_decided_exactly)
{
  // A rectangle of 3 by 4 with diagonals of 5, and the same with one length off by the last bit.
  const Five rectangle{Exact(5), Exact(3), Exact(4), Exact(3), Exact(4)};
  EXPECT_TRUE(is_Delaunay<double>(rectangle));
  Five longer = rectangle, shorter = rectangle;
  longer.ij = Exact(std::nextafter(5., 6.));
  shorter.ij = Exact(std::nextafter(5., 4.));
  EXPECT_FALSE(is_Delaunay<double>(longer));
  EXPECT_TRUE(is_Delaunay<double>(shorter));
  // Products of these leave the range of double.
  for (Exact* x : {&longer.ij, &longer.jk, &longer.ki, &longer.il, &longer.lj})
    *x = *x * Exact(std::ldexp(1., -300));
  EXPECT_FALSE(is_Delaunay<double>(longer));
}

// A surface with the λ-lengths of a wild conformal factor: faces need not obey the triangle inequality.
std::vector<double> scaled_lengths(const test_surfaces::Surface& surface, const IT::Delta_complex& complex,
                                   double range)
{
  std::mt19937 random(7);
  std::vector<double> factors(complex.number_of_vertices());
  for (double& w : factors)
    w = std::exp(range * (double(random()) / 0x1p31 - 1));
  std::vector<double> lengths;
  for (IT::Edge_index e : complex.edges()) {
    const std::size_t i = complex.source(complex.halfedge(e)).idx(), j = complex.target(complex.halfedge(e)).idx();
    double l = 0;
    for (std::size_t k = 0; k < 3 && !surface.points.empty(); ++k)
      l = std::hypot(l, double(surface.points[i][k]) - double(surface.points[j][k]));
    lengths.push_back((surface.points.empty() ? double(surface.lengths[e.idx()]) : l) * (factors[i] * factors[j]));
  }
  return lengths;
}

TEST(Ptolemy_traits, doubles_flip_as_rational_numbers_do)
{
  std::size_t flips = 0;
  for (const test_surfaces::Surface& surface : test_surfaces::generic_surfaces(true)) {
    for (double range : {0.1, 1., 4.}) {
      const std::vector<double> lengths = scaled_lengths(surface, surface.connectivity, range);
      auto t = Triangulation<double>::from_lengths(surface.connectivity, lengths);
      auto exact =
        Triangulation<Exact>::from_lengths(surface.connectivity, std::vector<Exact>(lengths.begin(), lengths.end()));
      const IT::Flip_report report = IT::flip_to_Delaunay(t), of_exact = IT::flip_to_Delaunay(exact);
      EXPECT_EQ(report.status, IT::Flip_status::DELAUNAY) << surface.name;
      EXPECT_EQ(report.flips, of_exact.flips) << surface.name;
      EXPECT_TRUE(t.connectivity() == exact.connectivity()) << surface.name;
      flips += report.flips;
      for (IT::Edge_index e : t.connectivity().edges()) {
        EXPECT_TRUE(exact.is_locally_Delaunay(e)) << surface.name;
        const double relative = CGAL::to_double(Exact(t.length(e)) / exact.length(e)) - 1;
        EXPECT_LE(std::abs(relative), (std::max)(t.edge_data(e).relative_error, 0x1p-53)) << surface.name;
      }
      auto intervals = Triangulation<CGAL::Interval_nt<>>::from_lengths(
        surface.connectivity, std::vector<CGAL::Interval_nt<>>(lengths.begin(), lengths.end()));
      if (IT::flip_to_Delaunay(intervals).status == IT::Flip_status::DELAUNAY) {
        EXPECT_TRUE(intervals.connectivity() == exact.connectivity()) << surface.name;
      }
    }
  }
  EXPECT_GT(flips, 500u);
}

TEST(Ptolemy_traits, a_doubled_surface_has_a_symmetric_tessellation)
{
  // Two copies of a strip of triangles, glued along the border: 2 n triangles, of which 3 f + i is glued to 3 (n + f) +
  // 2 - i.
  std::mt19937 random(5);
  for (int trial = 0; trial < 20; ++trial) {
    const std::size_t n = 12;
    std::vector<std::array<std::size_t, 2>> glued;
    for (std::size_t f = 0; f < n; ++f) {
      glued.push_back({3 * f, 3 * (n + f) + 2});
      const auto glue_both = [&](std::size_t a, std::size_t b) {
        glued.push_back({a, b});
        glued.push_back({3 * n + a / 3 * 3 + 2 - a % 3, 3 * n + b / 3 * 3 + 2 - b % 3});
      };
      if (f + 1 < n)
        glue_both(3 * f + 1, 3 * (f + 1) + 2);
    }
    glued.push_back({2, 3 * n});
    glued.push_back({3 * (n - 1) + 1, 3 * (2 * n - 1) + 1});
    const IT::Delta_complex complex = IT::make_Delta_complex_from_gluing(2 * n, glued);
    std::vector<double> lengths(complex.number_of_edges());
    const auto side = [&](std::size_t s) {
      IT::Halfedge_index h = complex.halfedge(IT::Face_index(std::uint32_t(s / 3)));
      for (std::size_t i = 0; i < s % 3; ++i)
        h = complex.next(h);
      return complex.edge(h).idx();
    };
    for (std::size_t s = 0; s < 3 * n; ++s)
      lengths[side(s)] = lengths[side(3 * n + s / 3 * 3 + 2 - s % 3)] = std::exp(3 * double(random()) / 0x1p32);
    auto t = Triangulation<double>::from_lengths(complex, lengths);
    auto exact = Triangulation<Exact>::from_lengths(complex, std::vector<Exact>(lengths.begin(), lengths.end()));
    EXPECT_GT(IT::flip_to_Delaunay(t).flips, 0u);
    IT::flip_to_Delaunay(exact);
    ASSERT_TRUE(t.connectivity() == exact.connectivity());
    // Edges that are no ties come in pairs of equal length, or cross the mirror: then they have an equal angle
    // criterion, so all numbers of the hinges occur as often as those of the mirrored ones.
    std::map<std::pair<std::size_t, Exact>, int> seen;
    std::map<std::size_t, std::size_t> mirrored;
    for (std::size_t s = 0; s < 3 * n; ++s) {
      const auto source = [&](std::size_t k) {
        IT::Halfedge_index h = complex.halfedge(IT::Face_index(std::uint32_t(k / 3)));
        for (std::size_t i = 0; i < k % 3; ++i)
          h = complex.next(h);
        return std::array<std::size_t, 2>{complex.source(h).idx(), complex.target(h).idx()};
      };
      const auto a = source(s), b = source(3 * n + s / 3 * 3 + 2 - s % 3);
      mirrored[a[0]] = b[1];
      mirrored[b[1]] = a[0];
    }
    const auto key = [&](std::size_t i, std::size_t j) {
      return (std::min)(i, j) * complex.number_of_vertices() + (std::max)(i, j);
    };
    for (IT::Edge_index e : exact.connectivity().edges()) {
      const IT::Hinge_halfedges h = exact.connectivity().hinge(e);
      const auto l = [&](IT::Halfedge_index side_of) { return exact.length(exact.connectivity().edge(side_of)); };
      const bool is_tie = Exact(l(h.ij) * l(h.ij) * (l(h.jk) * l(h.ki) + l(h.il) * l(h.lj))) ==
                          Exact((l(h.jk) * l(h.il) + l(h.ki) * l(h.lj)) * (l(h.ki) * l(h.il) + l(h.jk) * l(h.lj)));
      if (is_tie)
        continue;
      const std::size_t i = exact.connectivity().source(h.ij).idx(), j = exact.connectivity().target(h.ij).idx();
      ++seen[{key(i, j), l(h.ij)}];
      --seen[{key(mirrored[i], mirrored[j]), l(h.ij)}];
    }
    for (const auto& edge : seen)
      EXPECT_EQ(edge.second, 0);
  }
}

TEST(Ptolemy_traits, long_chains_of_flips_need_no_stack)
{
  // A length that depends on many flips, whose error bound has been renewed many times, and is exact.
  using IT::internal::Ptolemy_length;
  Ptolemy_length one{1, 0, nullptr}, x{1, 0, nullptr};
  for (int i = 0; i < 300000; ++i)
    x = IT::internal::flipped_length({x, one, x, x, one}); // (1 · x + x · 1) / x = 2
  EXPECT_EQ(x.value, 2);
}

} // namespace
