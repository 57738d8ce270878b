// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a surface to its triangulation, in any number type.

#ifndef IDT_NUMBER_TYPES_MAKE_TRIANGULATION_H
#define IDT_NUMBER_TYPES_MAKE_TRIANGULATION_H

#include "input/Surface.h"
#include "input/saved_triangulation.h"

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/squared_lengths.h>

#include <type_traits>

namespace idt {

namespace IT = CGAL::Intrinsic_triangulations;

// From the most accurate data: points, exact squared lengths if the traits can use them, or lengths.
template <class Traits>
IT::Intrinsic_triangulation<Traits> make_triangulation(const Surface& surface, const Traits& traits = Traits())
{
  using Triangulation = IT::Intrinsic_triangulation<Traits>;
  if constexpr (Triangulation::uses_exact_geometry)
    if (!surface.squared_lengths.empty())
      return Triangulation::from_metric(surface.connectivity, IT::metric_from_squared_lengths(surface.squared_lengths),
                                        traits);
  if (!surface.has_points())
    return Triangulation::from_lengths(surface.connectivity, surface.lengths, traits);
  return Triangulation(surface.connectivity, surface.points, traits);
}

// The initial triangulation: the saved one, if the traits can be saved.
template <class Traits>
IT::Intrinsic_triangulation<Traits> first_triangulation(const Surface& surface, const Traits& traits = Traits())
{
  if constexpr (std::is_same<Traits, IT::Filtered_edge_length_traits>::value)
    if (surface.saved)
      return surface.saved->triangulation;
  return make_triangulation(surface, traits);
}

} // namespace idt

#endif // IDT_NUMBER_TYPES_MAKE_TRIANGULATION_H
