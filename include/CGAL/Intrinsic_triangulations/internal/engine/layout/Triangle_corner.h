// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A triangle relative to one of its corners.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_TRIANGLE_CORNER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_TRIANGLE_CORNER_H

namespace CGAL::Intrinsic_triangulations::internal {

// The measures of a triangle relative to one of its corners.
//
// The cotangent of the angle is `p / four_areas`.
// \tparam Real a ring
template <class Real>
struct Triangle_corner
{
  Real p;          // twice the scalar product of its sides
  Real four_areas; // four times the area
  Real s_first;    // squared length of the side clockwise
  Real s_second;   // squared length of the side counterclockwise
  Real s_opposite; // squared length of the opposite side
};

// The corners opposite to an edge, k to its left and l to its right.
template <class Real>
struct Opposite_corners
{
  Triangle_corner<Real> k; // to the left
  Triangle_corner<Real> l; // to the right
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_TRIANGLE_CORNER_H
