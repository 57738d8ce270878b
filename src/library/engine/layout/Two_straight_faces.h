// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Lengths, areas and cotangents of triangles in space, two at a time.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_TWO_STRAIGHT_FACES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_TWO_STRAIGHT_FACES_H

#include <CGAL/Intrinsic_triangulations/Index.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/With_error.h>
#include "../../arithmetic/Split_double_double.h"
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Two_doubles.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/triangle_formulas_3.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL::Intrinsic_triangulations::internal {

// The corners i, j and k of a face.
using Three_corners = std::array<Vertex_index, 3>;

// As a Triangle_corner at k, but each number has one bound on its error, found from lengths and area alone: without a
// running error, both faces are computed in the same operations.
class Two_straight_faces
{
  using Pair = Split_double_double<Two_doubles>;
  using Two_vectors = Split_vector<Two_doubles>;

public:
  struct Numbers
  {
    std::array<Bounded_double_double, 3> lengths;    // of ij, jk and ki
    std::array<Bounded_double_double, 3> cotangents; // opposite to them
    Bounded_double_double twice_area;
  };

  Two_straight_faces(const Points& points, const Three_corners& f, const Three_corners& g)
  {
    const auto vectors = [&](std::size_t from, std::size_t to) {
      return two_split_vectors(points[f[from].idx()], points[f[to].idx()], points[g[from].idx()], points[g[to].idx()]);
    };
    const Two_vectors ij = vectors(0, 1), kj = vectors(2, 1), ki = vectors(2, 0);
    const Pair s_ij = split_scalar_product(ij, ij), s_jk = split_scalar_product(kj, kj),
               s_ki = split_scalar_product(ki, ki), p = split_scalar_product(ki, kj);
    Pair square = split_squared_area(ki, kj);
    square.hi = max_of(square.hi, Two_doubles(1e-200)); // a root of zero would be divided by
    const Pair area = square_root(square);
    const Two_doubles reciprocal = Two_doubles(1.) / area.hi;
    lengths_ = {square_root(s_ij), square_root(s_jk), square_root(s_ki)};
    cotangents_ = {quotient(p, area, reciprocal), quotient(s_ki - p, area, reciprocal),
                   quotient(s_jk - p, area, reciprocal)};
    twice_area_ = area;
    squares_ = s_jk.hi + s_ki.hi;
    shortest_ = min_of(s_ij.hi, min_of(s_jk.hi, s_ki.hi));
  }

  // The numbers of the first or the second face. Returns whether they are far from underflow, and the face far from
  // flat, as the bounds require.
  bool get(bool is_second, Numbers& numbers) const
  {
    const auto one = [&](const Two_doubles& both) { return is_second ? both.second() : both.first(); };
    const double squares = one(squares_), area = one(twice_area_.hi);
    if (!(one(shortest_) > 1e-60 && squares < 1e60 && area > 0x1p-40 * squares))
      return false;
    const auto bounded = [&](const Pair& x, double error) {
      return Bounded_double_double(one(x.hi), one(x.lo), error);
    };
    for (std::size_t c = 0; c < 3; ++c) {
      numbers.lengths[c] = bounded(lengths_[c], unit * one(lengths_[c].hi));
      // Errors of scalar products, and of twice the area, are at most `unit` times the sum of both squares.
      numbers.cotangents[c] = bounded(cotangents_[c], unit * squares / area * (1 + std::abs(one(cotangents_[c].hi))));
    }
    numbers.twice_area = bounded(twice_area_, unit * squares);
    return true;
  }

private:
  static constexpr double unit = 0x1p-97;

  std::array<Pair, 3> lengths_, cotangents_;
  Pair twice_area_;
  Two_doubles squares_, shortest_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_TWO_STRAIGHT_FACES_H
