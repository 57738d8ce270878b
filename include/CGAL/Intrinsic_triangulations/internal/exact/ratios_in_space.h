// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The shape of an input face from its three points.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_EXACT_RATIOS_IN_SPACE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_EXACT_RATIOS_IN_SPACE_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Bounded_double_double.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Double_double_disk.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Split_double_double.h>
#include <CGAL/Intrinsic_triangulations/internal/exact/Metric_frame.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/Points.h>

#include <array>
#include <cmath>
#include <optional>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// As Metric_frame::ratios(), in half of the time: one bound for all errors instead of a running one. Nothing without points, or where
// something could underflow, as in faces that are nearly flat.
inline std::optional<Corner_ratios<Double_double_disk>> ratios_in_space(const Delta_complex& input, const Points& points, Halfedge_index ij)
{
  using Number = Split_double_double<double>;
  using Vector = std::array<Number, 3>;
  if (points.empty())
    return std::nullopt;
  const auto &p = points[input.source(ij).idx()], &q = points[input.target(ij).idx()], &r = points[input.target(input.next(ij)).idx()];
  const auto scalar_product = [](const Vector& v, const Vector& w) { return sum(v[0] * w[0], v[1] * w[1], v[2] * w[2]); };
  const Vector u{Number::difference(q[0], p[0]), Number::difference(q[1], p[1]), Number::difference(q[2], p[2])},
    v{Number::difference(r[0], p[0]), Number::difference(r[1], p[1]), Number::difference(r[2], p[2])};
  const Number s = scalar_product(u, u), a = sum(u[1] * v[2], -(u[2] * v[1])), b = sum(u[2] * v[0], -(u[0] * v[2])),
               c = sum(u[0] * v[1], -(u[1] * v[0])), square = sum(a * a, b * b, c * c);
  const double s_v = v[0].hi * v[0].hi + v[1].hi * v[1].hi + v[2].hi * v[2].hi;
  if (!(s.hi > 1e-100 && s.hi < 1e100 && s_v > 1e-100 && s_v < 1e100 && square.hi > 1e-200))
    return std::nullopt;
  const double reciprocal = 1 / s.hi;
  const Number x = quotient(scalar_product(u, v), s, reciprocal), y = quotient(square_root(square), s, reciprocal);
  // Products of the vectors are good to 2^-102 of those of their lengths, so that x + iy is good to 2^-99 of its absolute value.
  const double error = 0x1p-97 * std::sqrt(s_v * reciprocal);
  const Bounded_double_double at_source(x.hi, x.lo, error), height(y.hi, y.lo, error);
  return Corner_ratios<Double_double_disk>{{at_source, height}, {Bounded_double_double(1) - at_source, -height}};
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_EXACT_RATIOS_IN_SPACE_H
