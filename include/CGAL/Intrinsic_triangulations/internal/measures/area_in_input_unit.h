// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Areas in the unit of the input, or a clear error.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_AREA_IN_INPUT_UNIT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_AREA_IN_INPUT_UNIT_H

#include <CGAL/Intrinsic_triangulations/internal/Index.h>
#include <CGAL/Intrinsic_triangulations/errors.h>

#include <cmath>
#include <limits>
#include <string>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// Lengths of 1e-160 or 1e160 are well within the range of double, but their squares are not.
inline double area_in_input_unit(double area, int unit_exponent, Face_index f)
{
  using Limits = std::numeric_limits<double>;
  const double result = std::ldexp(area, 2 * unit_exponent);
  if (result > (Limits::max)() || (result < (Limits::min)() && area >= (Limits::min)()))
    throw Invalid_surface_error(
      Invalid_surface_error::Defect::OUT_OF_RANGE, f.idx(), 1,
      "face " + std::to_string(f.idx()) +
        ": its area leaves the range of double; scale the surface, or remove the face if that does not help");
  return result;
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_AREA_IN_INPUT_UNIT_H
