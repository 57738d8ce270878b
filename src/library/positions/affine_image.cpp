// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The image of a point in a face of the overlay, by convex combinations of its corners.

#include <CGAL/Intrinsic_triangulations/internal/positions/affine_image.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/triangle_formulas_3.h>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace CGAL::Intrinsic_triangulations::internal {

double determinant(double a, double b, double c, double d)
{
  double ad, ad_tail, bc, bc_tail;
  two_product(a, d, ad, ad_tail);
  two_product(b, c, bc, bc_tail);
  return (ad - bc) + (ad_tail - bc_tail);
}

double fraction_between(const Coordinates& a, const Coordinates& b, const Coordinates& p)
{
  const double square = squared_distance_3(a, b);
  double along = 0;
  for (int i = 0; i < 3; ++i)
    along += (p[i] - a[i]) * (b[i] - a[i]);
  return square > 0 ? (std::min)(1., (std::max)(0., along / square)) : 0;
}

Coordinates between(const Coordinates& a, const Coordinates& b, double t)
{
  return {(1 - t) * a[0] + t * b[0], (1 - t) * a[1] + t * b[1], (1 - t) * a[2] + t * b[2]};
}

Coordinates affine_image(const Corners_in_both& corners, const Coordinates& p)
{
  const auto cross = [&](std::size_t i, std::size_t j) {
    const Coordinates &a = corners[i].from, &b = corners[j].from;
    return determinant(a[1] - p[1], a[2] - p[2], b[1] - p[1], b[2] - p[2]);
  };
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const double w_0 = cross(i, i + 1), w_i = cross(i + 1, 0), w_j = cross(0, i);
    const double sum = w_0 + w_i + w_j;
    if (w_0 < 0 || w_i < 0 || w_j < 0 || sum <= 0)
      continue;
    Coordinates result;
    for (int k = 0; k < 3; ++k)
      result[k] = (w_0 * corners[0].to[k] + w_i * corners[i].to[k] + w_j * corners[i + 1].to[k]) / sum;
    return result;
  }
  double smallest = std::numeric_limits<double>::infinity();
  Coordinates result{};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Corner_in_both &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const double t = fraction_between(a.from, b.from, p);
    const Coordinates nearest = between(a.from, b.from, t);
    const double distance = squared_distance_3(nearest, p);
    if (distance < smallest) {
      smallest = distance;
      result = between(a.to, b.to, t);
    }
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal
