// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// On which side of a curve vertices lie: the signs of distances.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SIDES_OF_CURVE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SIDES_OF_CURVE_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>

#include <CGAL/enum.h>

#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief returns for each vertex whether it lies to the left (`POSITIVE`) or to the right (`NEGATIVE`) of a curve, or
/// on it (`ZERO`).
///
/// The curve has to separate: it is closed, or leads from border to border, there is something on either side, and no way
/// leads from its left to its right side around it. Other components of the surface count as left.
///
/// \param input the surface
/// \param curve points of it, two consecutive ones in the face of the first. Its segments do not cross
/// \exception Invalid_surface_error if two edges join the same vertices, which corners of triangles do not tell apart
/// \exception Invalid_argument_error if the curve does not separate, so that the sides have no meaning
/// \exception Invalid_point_error if a point does not lie on the surface, or two consecutive ones do not lie in the face
///   of the first, or segments cross
///
/// O(size), and in a face with k points mostly O(k log k).
std::vector<Sign> sides_of_curve(const Delta_complex& input, const std::vector<Surface_point>& curve);

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief as above, for points: whether each lies to the left or to the right of a curve. Points on the curve count as
/// either.
/// \param input, curve as above
/// \param points points of the input
std::vector<Sign> sides_of_curve(const Delta_complex& input, const std::vector<Surface_point>& curve,
                                 const std::vector<Surface_point>& points);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SIDES_OF_CURVE_H
