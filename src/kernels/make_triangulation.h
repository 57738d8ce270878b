// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a surface to its triangulation, in any number type.

#ifndef IDT_KERNELS_MAKE_TRIANGULATION_H
#define IDT_KERNELS_MAKE_TRIANGULATION_H

#include "input/Surface.h"

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/number_conversion.h>
#include <CGAL/Intrinsic_triangulations/rational_metric.h>

#include <array>
#include <utility>
#include <vector>

namespace idt {

namespace IT = CGAL::Intrinsic_triangulations;

// By what is known best: points, exact squared lengths if the traits can use them, or lengths.
template <class Traits>
IT::Intrinsic_triangulation<Traits> make_triangulation(const Surface& surface, const Traits& traits = Traits())
{
  using FT = typename Traits::FT;
  using Triangulation = IT::Intrinsic_triangulation<Traits>;
  if constexpr (Triangulation::uses_exact_geometry)
    if (!surface.squared_lengths.empty())
      return Triangulation::from_metric(surface.connectivity, IT::metric_from_squared_lengths(surface.squared_lengths), traits);
  if (!surface.has_points()) {
    std::vector<FT> lengths;
    lengths.reserve(surface.lengths.size());
    for (double length : surface.lengths)
      lengths.push_back(IT::internal::convert_number<FT>(length));
    return Triangulation::from_lengths(surface.connectivity, std::move(lengths), traits);
  }
  typename Triangulation::Point_vector points;
  points.reserve(surface.points.size());
  for (const std::array<double, 3>& p : surface.points)
    points.push_back({IT::internal::convert_number<FT>(p[0]),
                      IT::internal::convert_number<FT>(p[1]),
                      IT::internal::convert_number<FT>(p[2])});
  return Triangulation(surface.connectivity, std::move(points), traits);
}

} // namespace idt

#endif // IDT_KERNELS_MAKE_TRIANGULATION_H
