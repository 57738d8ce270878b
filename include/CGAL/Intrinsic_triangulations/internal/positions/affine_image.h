// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A point of a face of the overlay, carried from one triangulation to the other.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_AFFINE_IMAGE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_AFFINE_IMAGE_H

#include <CGAL/Intrinsic_triangulations/internal/measures/triangle_formulas_3.h>
#include <CGAL/Intrinsic_triangulations/internal/positions/overlay_layers.h>

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace CGAL::Intrinsic_triangulations::internal {

// A corner of a face of the overlay in a face of either triangulation.
struct Corner_in_both
{
  Coordinates from;
  Coordinates to;
};

// A face is the intersection of two triangles: it has at most six corners.
using Corners_in_both = boost::container::static_vector<Corner_in_both, 6>;

template <class From, class To>
Corners_in_both corners_in_both(const From& from, Halfedge_index from_first, const To& to, Halfedge_index to_first,
                                Overlay::Face f)
{
  Corners_in_both corners;
  const Overlay::Halfedge first = from.overlay.halfedge(f);
  Overlay::Halfedge h = first;
  do {
    corners.push_back({corner_coordinates(from, h, from_first), corner_coordinates(to, h, to_first)});
    h = from.overlay.next(h);
  } while (h != first);
  return corners;
}

// ad − bc; exact except for one rounding of each product's tail.
inline double determinant(double a, double b, double c, double d)
{
  double ad, ad_tail, bc, bc_tail;
  two_product(a, d, ad, ad_tail);
  two_product(b, c, bc, bc_tail);
  return (ad - bc) + (ad_tail - bc_tail);
}

// The point of the segment from a to b that is nearest to p, as a fraction in [0, 1].
inline double fraction_between(const Coordinates& a, const Coordinates& b, const Coordinates& p)
{
  const double square = squared_distance_3(a, b);
  double along = 0;
  for (int i = 0; i < 3; ++i)
    along += (p[i] - a[i]) * (b[i] - a[i]);
  return square > 0 ? (std::min)(1., (std::max)(0., along / square)) : 0;
}

inline Coordinates between(const Coordinates& a, const Coordinates& b, double t)
{
  return {(1 - t) * a[0] + t * b[0], (1 - t) * a[1] + t * b[1], (1 - t) * a[2] + t * b[2]};
}

// Writes p as a convex combination of corners, so the error of the result is that of the corners, however thin the face
// is. If rounding has moved p outside, the nearest point of the boundary is used.
inline Coordinates affine_image(const Corners_in_both& corners, const Coordinates& p)
{
  const auto cross = [&](std::size_t i, std::size_t j) {
    const Coordinates &a = corners[i].from, &b = corners[j].from;
    return determinant(a[1] - p[1], a[2] - p[2], b[1] - p[1], b[2] - p[2]);
  };
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const double w_0 = cross(i, i + 1), w_i = cross(i + 1, 0), w_j = cross(0, i);
    const double sum = w_0 + w_i + w_j;
    if (w_0 < 0 || w_i < 0 || w_j < 0 || sum <= 0)
      continue;
    Coordinates result;
    for (int k = 0; k < 3; ++k)
      result[k] = (w_0 * corners[0].to[k] + w_i * corners[i].to[k] + w_j * corners[i + 1].to[k]) / sum;
    return result;
  }
  double smallest = std::numeric_limits<double>::infinity();
  Coordinates result{};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Corner_in_both &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const double t = fraction_between(a.from, b.from, p);
    const Coordinates nearest = between(a.from, b.from, t);
    const double distance = squared_distance_3(nearest, p);
    if (distance < smallest) {
      smallest = distance;
      result = between(a.to, b.to, t);
    }
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_AFFINE_IMAGE_H
