// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The shape of an input face from its three points.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_RATIOS_IN_SPACE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_RATIOS_IN_SPACE_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/With_error.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Disk.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Split_double_double.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/rounded_sqrt.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/layout/Metric_frame.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/triangle_formulas_3.h>

#include <optional>

namespace CGAL::Intrinsic_triangulations::internal {

// As Metric_frame::ratios(), in half of the time: one bound for all errors instead of a running one. Nothing without
// points, or where something could underflow, as in faces that are nearly flat.
inline std::optional<Corner_ratios<Double_double_disk>> ratios_in_space(const Delta_complex& input,
                                                                        const Points& points, Halfedge_index ij)
{
  if (points.empty())
    return std::nullopt;
  const auto &p = points[input.source(ij).idx()], &q = points[input.target(ij).idx()],
             &r = points[input.target(input.next(ij)).idx()];
  const Split_vector<double> u = split_vector(p, q), v = split_vector(p, r);
  const Split_double_double<double> s = split_scalar_product(u, u), square = split_squared_area(u, v);
  const double s_v = rough_square(v);
  if (!(s.hi > 1e-100 && s.hi < 1e100 && s_v > 1e-100 && s_v < 1e100 && square.hi > 1e-200))
    return std::nullopt;
  const double reciprocal = 1 / s.hi;
  const Split_double_double<double> x = quotient(split_scalar_product(u, v), s, reciprocal),
                                    y = quotient(square_root(square), s, reciprocal);
  // Products of the vectors are good to 2^-102 of those of their lengths, so that x + iy is good to 2^-99 of its
  // absolute value.
  const double error = 0x1p-97 * rounded_sqrt(s_v * reciprocal);
  const Bounded_double_double at_source(x.hi, x.lo, error), height(y.hi, y.lo, error);
  return Corner_ratios<Double_double_disk>{{at_source, height}, {Bounded_double_double(1) - at_source, -height}};
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_RATIOS_IN_SPACE_H
