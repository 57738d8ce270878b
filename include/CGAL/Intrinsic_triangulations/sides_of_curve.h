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
/// The curve has to separate: its parts are closed, or lead from border to border, there is something on either side,
/// and no way leads from a left to a right side around them. So both rims of a ring, or two circles around the tube of
/// a torus, run in opposite directions. Other components of the surface count as left.
///
/// \param input the surface
/// \param parts points of it, two consecutive ones of a part in the face of the first. Segments do not cross
/// \exception Invalid_surface_error if two edges join the same vertices, which corners of triangles do not tell apart
/// \exception Invalid_argument_error if the curve does not separate, so that the sides have no meaning. If there are
///   several parts, the message names those at fault
/// \exception Invalid_point_error if a point does not lie on the surface, or two consecutive ones do not lie in the
///   face of the first, or segments cross
///
/// O(size), and in a face with k points mostly O(k log k).
std::vector<Sign> sides_of_curve(const Delta_complex& input, const std::vector<std::vector<Surface_point>>& parts);

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief as above, for points: whether each lies to the left or to the right of a curve. Points on the curve count as
/// either.
/// \param input, parts as above
/// \param points points of the input
std::vector<Sign> sides_of_curve(const Delta_complex& input, const std::vector<std::vector<Surface_point>>& parts,
                                 const std::vector<Surface_point>& points);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SIDES_OF_CURVE_H
