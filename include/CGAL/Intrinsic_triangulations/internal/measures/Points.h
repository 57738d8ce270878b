// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The places of vertices in space; for headers that compute with them in their definitions alone.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_POINTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_POINTS_H

#include <CGAL/Intrinsic_triangulations/internal/system/Large_vector.h>

#include <array>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

using Points = Large_vector<std::array<double, 3>>;

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_POINTS_H
