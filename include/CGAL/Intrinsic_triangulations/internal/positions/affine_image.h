// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A point of a face of the overlay, carried from one triangulation to the other.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_AFFINE_IMAGE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_AFFINE_IMAGE_H

#include <CGAL/Intrinsic_triangulations/internal/positions/overlay_layers.h>

#include <boost/container/static_vector.hpp>

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
double determinant(double a, double b, double c, double d);

// The point of the segment from a to b that is nearest to p, as a fraction in [0, 1].
double fraction_between(const Coordinates& a, const Coordinates& b, const Coordinates& p);
Coordinates between(const Coordinates& a, const Coordinates& b, double t);

// Writes p as a convex combination of corners, so the error of the result is that of the corners, however thin the face
// is. If rounding has moved p outside, the nearest point of the boundary is used.
Coordinates affine_image(const Corners_in_both& corners, const Coordinates& p);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_AFFINE_IMAGE_H
