// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Whether three points are on a line: an exact test that nearly always takes a few operations.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_ARE_COLLINEAR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_ARE_COLLINEAR_H

#include <array>

namespace CGAL::Intrinsic_triangulations::internal {

// Decided exactly. \pre the coordinates are finite
bool are_collinear(const std::array<double, 3>& p, const std::array<double, 3>& q, const std::array<double, 3>& r);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_ARE_COLLINEAR_H
