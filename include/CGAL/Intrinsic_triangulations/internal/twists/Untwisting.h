// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// What was untwisted.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TWISTS_UNTWISTING_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TWISTS_UNTWISTING_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/twists/Crossing_counts.h>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsTwists
/// \brief consecutive flips within one tube.
struct Twist
{
  Halfedge_index loop; ///< a side of the tube, with the tube to its left
  Integer
    power; ///< the number of flips; positive if they turn the far side to the right, as `Crossing_counts::twist()` explains
};

/// \ingroup PkgIntrinsicTriangulationsTwists
/// \brief what `untwist()` did.
struct Untwisting
{
  std::vector<Twist> twists;         ///< in order; each tube is one of the triangulation that those before leave
  Integer number_of_flips = 0;       ///< of all twists together
  std::uint64_t number_of_steps = 0; ///< of those flips, how many were made one by one
  Crossing_counts crossings;         ///< how often each edge crosses edges of the complex that was given
  bool is_complete = true;           ///< `false` if the visitor ended it: then some tubes are left as they were
};

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TWISTS_UNTWISTING_H
