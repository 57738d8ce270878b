// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// From triangles to the surface that covers them.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COVER_COVER_BUILDER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COVER_COVER_BUILDER_H

#include <CGAL/Intrinsic_triangulations/Tufted_cover.h>
#include <CGAL/Intrinsic_triangulations/config.h>
#include <CGAL/Intrinsic_triangulations/internal/cover/Cleaned_triangles.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/Points.h>

#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// As make_tufted_cover().
// \pre the vertices of all triangles exist
Tufted_cover build_cover(const Points& points, const std::vector<Index_triangle>& triangles,
                         const Tufted_cover_options& options);

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/internal/cover/Cover_builder_impl.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COVER_COVER_BUILDER_H
