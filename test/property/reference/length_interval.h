// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An interval around the length of an edge, from the bounds of its layout.

#ifndef IDT_TEST_PROPERTY_REFERENCE_LENGTH_INTERVAL_H
#define IDT_TEST_PROPERTY_REFERENCE_LENGTH_INTERVAL_H

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>
#include "library/engine/decide/Exact_fallback.h"
#include "library/engine/layout/Unfolding.h"
#include "library/engine/layout/metric_images.h"
#include <CGAL/Intrinsic_triangulations/internal/system/Standard_arithmetic.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cmath>
#include <limits>

// In the unit of the input.
template <class Triangulation>
CGAL::Interval_nt<> length_interval(const Triangulation& triangulation, CGAL::Intrinsic_triangulations::Edge_index e)
{
  using namespace CGAL::Intrinsic_triangulations::internal;
  const Standard_arithmetic arithmetic;
  const Exact_engine& geometry = engine(triangulation);
  const int unit = geometry.metric().unit_exponent();
  const Surface_lease surface = geometry.input_surface();
  Double_double_metric metric(*surface);
  const Bounded_double_double l =
    sqrt(Unfolding<Double_double_metric>(geometry.connectivity(), geometry.correspondence(), metric).squared_length(e));
  double low, high;
  if (l.error() < 0x1p-60 * l.hi()) {
    low = high = l.hi();
    while (low - l.hi() > l.lo() - 1.01 * l.error())
      low = std::nextafter(low, 0.);
    while (high - l.hi() < l.lo() + 1.01 * l.error())
      high = std::nextafter(high, 2 * high);
  } else {
    Exact_fallback fallback(geometry.connectivity(), geometry.correspondence(), *surface);
    const Mpfr_interval m = sqrt(fallback.squared_length(e, 128));
    low = m.lower_double();
    high = m.upper_double();
  }
  // Where the scaling is not exact, it is wrong by less than the next double.
  low = std::ldexp(low, unit);
  high = std::ldexp(high, unit);
  if (low >= (std::numeric_limits<double>::min)())
    return {low, high};
  return {(std::max)(0., std::nextafter(low, 0.)), std::nextafter(high, 1.)};
}

#endif // IDT_TEST_PROPERTY_REFERENCE_LENGTH_INTERVAL_H
