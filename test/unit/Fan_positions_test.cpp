// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Quotients of halfedges around a vertex against products of the ratios between them.

#include "library/engine/layout/Fan_positions.h"
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <gtest/gtest.h>

#include <array>
#include <complex>
#include <cstddef>
#include <new>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Delta_complex;
using IT::Halfedge_index;
using IT::internal::Double_double_disk;
using IT::internal::Fan_positions;

// Nine triangles around vertex 0, or eight that leave a gap.
Delta_complex wheel(std::size_t number_of_triangles)
{
  std::vector<std::array<std::size_t, 3>> triangles;
  for (std::size_t i = 0; i < number_of_triangles; ++i)
    triangles.push_back({0, 1 + i, 1 + (i + 1) % 9});
  return IT::make_Delta_complex_from_triangles(10, triangles);
}

Double_double_disk corner_ratio(Halfedge_index h) { return {{0.7 + 0.01 * double(h.idx())}, {0.5}}; }
std::complex<double> rounded(const Double_double_disk& z) { return {z.x().hi(), z.y().hi()}; }

// All pairs of halfedges out of vertex 0, both ways round if there is no gap.
void expect_products(const Delta_complex& wheel, Fan_positions& fans)
{
  Halfedge_index first = wheel.opposite(wheel.halfedge(IT::Vertex_index(0)));
  while (!wheel.is_border(wheel.opposite(first)) && first.idx() != 0)
    first = wheel.next(wheel.opposite(first));
  std::vector<Halfedge_index> around;
  for (Halfedge_index h = first;;) {
    around.push_back(h);
    if (wheel.is_border(h) || (h = wheel.next_around_source(h)) == first)
      break;
  }
  const bool is_closed = !wheel.is_border(around.back());
  ASSERT_EQ(around.size(), 9u);
  for (std::size_t i = 0; i < around.size(); ++i) {
    std::complex<double> product = 1;
    for (std::size_t n = 1; n <= around.size() && (is_closed || i + n < around.size()); ++n) {
      product *= rounded(corner_ratio(around[(i + n - 1) % 9]));
      const Halfedge_index from = around[i], to = around[(i + n) % 9];
      const Double_double_disk left = fans.ratio(wheel, from, to, true, corner_ratio),
                               right = fans.ratio(wheel, to, from, false, corner_ratio);
      EXPECT_LT(std::abs(rounded(left) - product), 1e-14 * std::abs(product));
      EXPECT_LT(std::abs(rounded(right) * product - 1.), 1e-14);
      EXPECT_LT(left.radius(), 0x1p-90 * left.modulus());
      EXPECT_LT(right.radius(), 0x1p-90 * right.modulus());
    }
  }
}

TEST(Fan_positions, around_an_inner_vertex)
{
  Fan_positions fans;
  expect_products(wheel(9), fans);
}

TEST(Fan_positions, around_a_vertex_on_the_border)
{
  Fan_positions fans;
  expect_products(wheel(8), fans);
}

TEST(Fan_positions, half_a_fan_is_forgotten)
{
  const Delta_complex complex = wheel(9);
  Fan_positions fans;
  const Halfedge_index h = complex.opposite(complex.halfedge(IT::Vertex_index(0)));
  int number = 0;
  EXPECT_THROW(fans.ratio(complex, h, complex.next_around_source(h), true,
                          [&](Halfedge_index g) {
                            if (++number == 5)
                              throw std::bad_alloc();
                            return corner_ratio(g);
                          }),
               std::bad_alloc);
  expect_products(complex, fans);
}

} // namespace
