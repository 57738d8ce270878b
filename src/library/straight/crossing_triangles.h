// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Finds triangles that cross each other.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_STRAIGHT_CROSSING_TRIANGLES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_STRAIGHT_CROSSING_TRIANGLES_H

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>

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

// Whether two triangles are such a pair.
bool do_cross(const std::vector<std::array<double, 3>>& points, const std::array<std::uint32_t, 3>& s,
              const std::array<std::uint32_t, 3>& t);

// Which faces of a triangulation lie where the input itself crosses.
class Surface_crossings
{
public:
  Surface_crossings(const Common_subdivision& subdivision, const std::vector<std::array<double, 3>>& points,
                    const std::function<void()>& go_on);
  // Whether an input face below one of these faces, or its neighbor, crosses one below one of the others.
  bool has(const std::vector<Face_index>& faces, const std::vector<Face_index>& others) const;

private:
  std::vector<std::vector<std::uint32_t>> input_faces_; // below each face, in order
  std::vector<std::vector<std::uint32_t>> crossed_;     // the input faces that an input face or its neighbor crosses
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_STRAIGHT_CROSSING_TRIANGLES_H
