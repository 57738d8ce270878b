// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The ways from a source inside a face to its corners and across its sides.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_FIRST_WAYS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_FIRST_WAYS_H

#include "Window.h"

#include <CGAL/Intrinsic_triangulations/internal/distances/Laid_out_faces.h>
#include <CGAL/Intrinsic_triangulations/internal/distances/Window_sources.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

struct First_ways
{
  // A way to the vertex where a side begins, from an angle to the left of the side.
  struct To_corner
  {
    std::uint32_t side;
    double angle, distance;
  };

  std::vector<To_corner> to_corners;
  std::vector<std::pair<std::uint32_t, Window>> windows; // across a side of the face, as seen from beyond
};

First_ways first_ways(const Laid_out_faces& faces, const Face_source& source);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_FIRST_WAYS_H
