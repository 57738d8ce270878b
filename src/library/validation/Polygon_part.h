// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The polygons that a repair works on.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_POLYGON_PART_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_POLYGON_PART_H

#include <CGAL/Intrinsic_triangulations/internal/connectivity/Delta_complex_builder.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// A polygon of the input, or a part of one that was cut.
struct Polygon_part
{
  std::size_t input;
  std::vector<std::size_t> corners;
};

// The corners of parts that are triangles.
inline std::vector<Index_triangle> index_triangles(const std::vector<Polygon_part>& triangles)
{
  std::vector<Index_triangle> result;
  for (const auto& [input, v] : triangles)
    result.push_back({std::uint32_t(v[0]), std::uint32_t(v[1]), std::uint32_t(v[2])});
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_POLYGON_PART_H
