// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The triangulation of a convex polygon in space whose smallest triangle is largest.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_CONVEX_POLYGON_TRIANGULATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_CONVEX_POLYGON_TRIANGULATION_H

#include <CGAL/Intrinsic_triangulations/internal/measures/triangle_formulas_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// By dynamic programming over the chains a, a + 1, ..., b of corners, each closed by the
// diagonal from b to a. The faces of an overlay have six corners at most.
class Convex_polygon_triangulation
{
  using Point = std::array<double, 3>;

public:
  explicit Convex_polygon_triangulation(const std::vector<Point>& given) : size_(given.size()), apex_(size_ * size_, 0)
  {
    const std::vector<Point> corners = relative(given);
    const auto twice_area_vector = [&](std::size_t a, std::size_t b, std::size_t c) {
      Point u, v;
      for (std::size_t k = 0; k < 3; ++k) {
        u[k] = corners[b][k] - corners[a][k];
        v[k] = corners[c][k] - corners[a][k];
      }
      return cross_product(u, v);
    };
    Point normal{0, 0, 0};
    for (std::size_t i = 1; i + 1 < size_; ++i) {
      const Point n = twice_area_vector(0, i, i + 1);
      for (std::size_t k = 0; k < 3; ++k)
        normal[k] += n[k];
    }
    // The area of the smallest triangle in the best triangulation of each chain, up to a factor; negative if rounding
    // has turned a triangle over.
    std::vector<double> smallest_area(size_ * size_, std::numeric_limits<double>::infinity());
    for (std::size_t length = 2; length < size_; ++length)
      for (std::size_t a = 0; a + length < size_; ++a) {
        const std::size_t b = a + length;
        double& best = smallest_area[a * size_ + b];
        best = -std::numeric_limits<double>::infinity();
        for (std::size_t apex = a + 1; apex < b; ++apex) {
          const double smallest =
            (std::min)(scalar_product(twice_area_vector(a, apex, b), normal),
                       (std::min)(smallest_area[a * size_ + apex], smallest_area[apex * size_ + b]));
          if (smallest > best || apex == a + 1) {
            best = smallest;
            apex_[a * size_ + b] = apex;
          }
        }
      }
  }

  // Calls `visit(a, apex, b)` for each triangle, a < apex < b: first for the one at the side from the last corner to
  // the first, and for each triangle before the ones beyond its other sides.
  template <class Visit>
  void for_each_triangle(const Visit& visit) const
  {
    for_each_triangle(0, size_ - 1, visit);
  }

private:
  template <class Visit>
  void for_each_triangle(std::size_t a, std::size_t b, const Visit& visit) const
  {
    if (b < a + 2)
      return;
    const std::size_t apex = apex_[a * size_ + b];
    visit(a, apex, b);
    for_each_triangle(a, apex, visit);
    for_each_triangle(apex, b, visit);
  }

  // Relative to the first corner, and to the largest distance, lest products over- or underflow.
  static std::vector<Point> relative(const std::vector<Point>& corners)
  {
    double largest = 0;
    for (const Point& p : corners)
      for (std::size_t k = 0; k < 3; ++k)
        largest = (std::max)(largest, std::abs(p[k] - corners[0][k]));
    std::vector<Point> result(corners.size(), {0, 0, 0});
    if (largest > 0 && std::isfinite(largest))
      for (std::size_t i = 0; i < corners.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
          result[i][k] = (corners[i][k] - corners[0][k]) / largest;
    return result;
  }

  std::size_t size_;
  std::vector<std::size_t> apex_; // of the triangle at the diagonal that closes the chain
};

// Calls `cut(a, b)` for each diagonal between corners a < b. When it is called, the corners from
// a to b are in one piece, which is cut off.
template <class Cut>
void for_each_diagonal(const std::vector<std::array<double, 3>>& corners, const Cut& cut)
{
  if (corners.size() > 3)
    Convex_polygon_triangulation(corners).for_each_triangle([&](std::size_t a, std::size_t, std::size_t b) {
      if (b - a + 1 < corners.size())
        cut(a, b);
    });
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_CONVEX_POLYGON_TRIANGULATION_H
