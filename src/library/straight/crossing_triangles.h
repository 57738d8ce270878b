// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Finds triangles that cross each other.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_STRAIGHT_CROSSING_TRIANGLES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_STRAIGHT_CROSSING_TRIANGLES_H

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The pairs of triangles that share more than their common corners and edges. Exact. Triangles without area and those
// with the same corners as others are left out.
// \param go_on is called for each triangle
std::vector<std::array<std::uint32_t, 2>> crossing_triangles(const std::vector<std::array<double, 3>>& points,
                                                             const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                                             const std::function<void()>& go_on);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_STRAIGHT_CROSSING_TRIANGLES_H
