// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Points and curves of the input in the faces of a triangulation.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_CURVE_SOURCES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_CURVE_SOURCES_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Geodesic_source.h>
#include <CGAL/Intrinsic_triangulations/internal/distances/Laid_out_faces.h>
#include <CGAL/Intrinsic_triangulations/internal/distances/Window_sources.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>

#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// \param engine, complex, faces of the same triangulation
// \exception Invalid_point_error if a point does not lie on the surface, or two consecutive ones do not lie in the face
//   of the first
// \exception Invalid_argument_error if an offset is negative or not finite
Window_sources sources_in_faces(const Exact_engine& engine, const Delta_complex& complex, const Laid_out_faces& faces,
                                const std::vector<Geodesic_source>& sources);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_CURVE_SOURCES_H
