// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The edges of a surface in space that an engineer means by its edges: where its sides meet at an angle.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SHARP_EDGES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SHARP_EDGES_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/config.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsInsertion
/// \brief returns the spacing of the coordinates: a unit in the last place of the largest one, as a `float` if all of
/// them are floats, as in STL files, and as a `double` otherwise.
/// \param points the points
/// \return the spacing in the unit of the points; 0 if all coordinates are 0
///
/// \pre the coordinates are finite
double coordinate_spacing(const std::vector<std::array<double, 3>>& points);

/// \ingroup PkgIntrinsicTriangulationsInsertion
/// \brief finds the edges at which the directions of the two faces differ by more than an angle, to be constrained in
/// `refine_Delaunay()`.
///
/// The direction of a face is that of its normal. The normal of a face that is thinner than `minimum_size`, or than
/// four times `coordinate_spacing()`, is meaningless. Such a face takes the direction of the face beyond its longest
/// side, which may be as thin itself. So a sliver between two sides of a part has one sharp edge and not two.
///
/// Sharp edges with common vertices make chains; those whose edges have a total length below `minimum_size` are
/// dropped.
///
/// \param complex the connectivity
/// \param points the positions of the vertices
/// \param degrees the angle, from 0 to 180 degrees
/// \param minimum_size the height below which a face is thin, in the unit of the points
/// \return for each edge whether it is sharp; border edges are not
///
/// \pre there is one point for each vertex, and the coordinates are finite
///
/// O(n log n) for n edges of thin faces, otherwise linear. Directions and lengths are rounded.
std::vector<bool> sharp_edges(const Delta_complex& complex, const std::vector<std::array<double, 3>>& points,
                              double degrees, double minimum_size = 0);

} // namespace Intrinsic_triangulations
} // namespace CGAL

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/internal/validation/sharp_edges_impl.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SHARP_EDGES_H
