// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Lines where distances have given values, or where the nearest source changes.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_TRACE_LINES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_TRACE_LINES_H

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/distances/Laid_out_faces.h>
#include <CGAL/Intrinsic_triangulations/internal/distances/Wave.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>

#include <array>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// All lengths in the unit of the faces.
struct Wanted_lines
{
  std::vector<double> levels;  // ascending; none for the borders of the cells
  double chord_tolerance;      // positive
  double search_tolerance = 0; // of the waves, as a fraction of each side
};

struct Traced_line
{
  std::vector<Surface_point> points; // on the input, each chord in the face of its first point
  std::uint32_t level = 0;           // its number
  std::array<std::uint32_t, 2> cells{};
};

// \param subdivision of the triangulation that was laid out
// \exception Invalid_argument_error if too many triangles are needed
std::vector<Traced_line> trace_lines(const Common_subdivision& subdivision, const Laid_out_faces& faces,
                                     const Waves& waves, const Wanted_lines& wanted, const Interruption& interruption);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_TRACE_LINES_H
