// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Triangles given by lengths, laid out in the plane side by side: in doubles or in intervals.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_SIMPLIFICATION_FLAT_LAYOUT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_SIMPLIFICATION_FLAT_LAYOUT_H

#include "../arithmetic/Planar_vector.h"

#include <CGAL/number_type_basic.h>
#include <CGAL/number_utils.h>

#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

template <class FT>
FT determinant(const Planar_vector<FT>& p, const Planar_vector<FT>& q)
{
  return p.x() * q.y() - p.y() * q.x();
}

// The third corner of a triangle to the left of its side from p to q.
// \param side, from_p, from_q the lengths of that side and of the other two
// \param four_areas four times the area
template <class FT>
Planar_vector<FT> third_corner(const Planar_vector<FT>& p, const Planar_vector<FT>& q, double side, double from_p,
                               double from_q, const FT& four_areas)
{
  const FT s = CGAL::square(FT(side)), twice = s + s;
  const FT along = (CGAL::square(FT(from_p)) + s - CGAL::square(FT(from_q))) / twice;
  return p + (q - p) * Planar_vector<FT>(along, four_areas / twice);
}

// The squared factors, the smaller one first, by which the linear map of a triangle changes lengths if one side keeps
// its own: the eigenvalues of 1 + M, where M is the change of the metric relative to it. Here, M has a closed form
// without cancellation.
// \param s, t, c the squared lengths of the three sides \param q the square of four times the area
// \param d, e the changes of s and t
template <class FT>
std::pair<FT, FT> squared_factors(const FT& s, const FT& t, const FT& c, const FT& q, const FT& d, const FT& e)
{
  const FT half = ((t + c - s) * d + (s + c - t) * e) / q,
           root = CGAL::sqrt(CGAL::square(half) + CGAL::square(d - e) / q);
  return {FT(1) + half - root, FT(1) + half + root};
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_SIMPLIFICATION_FLAT_LAYOUT_H
