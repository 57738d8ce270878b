// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The factors by which the removal of a vertex and the rounding of lengths change lengths on a surface: proven, in
// intervals. doc/simplification.md has the mathematics.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_SIMPLIFICATION_FAN_PROOF_H
#define CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_SIMPLIFICATION_FAN_PROOF_H

#include "Fan.h"

#include <array>

namespace CGAL::Intrinsic_triangulations::internal {

// All functions round upward during the call.

// The change by replacing a triangle whose sides are within one unit in the last place of these doubles by one with
// these sides, or by the reverse. Infinite if nothing is known.
Squared_change change_by_rounding(const std::array<double, 3>& sides);

// One change after another.
Squared_change product(const Squared_change& a, const Squared_change& b);

// Proves that the fan, with its vertex at the place, is mapped one to one to the triangulation.
//
// The proof is about triangles with exactly the given lengths.
// \param changes for each triangle
// \return whether this is proven and no squared change exceeds `limit`
bool prove_removal(const Fan& fan, const Fan_triangulation& triangulation, double limit,
                   Fan_array<Squared_change>& changes);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_SIMPLIFICATION_FAN_PROOF_H
