// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Vertices on the border, where the angles opposite to it are obtuse.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_WITHOUT_OBTUSE_BORDER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_WITHOUT_OBTUSE_BORDER_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/numbers/Accurate_shapes.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>
#include <CGAL/Intrinsic_triangulations/internal/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/refine_Delaunay.h>

#include <cstdint>
#include <optional>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

template <class Traits>
bool has_obtuse_border(const Intrinsic_triangulation<Traits>& triangulation)
{
  const Delta_complex& complex = triangulation.connectivity();
  const Accurate_shapes<Traits> shapes(triangulation);
  for (Halfedge_index h : complex.halfedges())
    if (!complex.is_border(h) && complex.is_border(complex.opposite(h)) && shapes.has_area(complex.face(h)) &&
        shapes.cotangent(h) < 0)
      return true;
  return false;
}

// A copy in which the border has so many vertices that no angle opposite to it is obtuse; nothing, if there is none
// before. A needle on the border asks for as many as it is longer than wide: beyond some for each vertex, its angles
// stay obtuse.
// \exception Cancelled_error
template <class Traits>
std::optional<Intrinsic_triangulation<Traits>>
without_obtuse_border(const Intrinsic_triangulation<Traits>& triangulation, const Interruption& interruption)
{
  if (!has_obtuse_border(triangulation))
    return std::nullopt;
  std::optional<Intrinsic_triangulation<Traits>> result(triangulation);
  const auto ask = [&interruption] {
    interruption.check();
    return true;
  };
  const std::uint64_t most = 10 * std::uint64_t(triangulation.connectivity().number_of_vertices()) + 1000;
  refine_Delaunay(*result,
                  parameters::minimum_angle(0.).splits_encroached_edges(true).maximum_number(most).visitor(ask));
  return result;
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_WITHOUT_OBTUSE_BORDER_H
