// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Shortest distances on a triangulated surface.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_WINDOW_PROPAGATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_WINDOW_PROPAGATION_H

#include <CGAL/Intrinsic_triangulations/internal/distances/Laid_out_faces.h>
#include <CGAL/Intrinsic_triangulations/internal/distances/Laid_out_points.h>
#include <CGAL/Intrinsic_triangulations/internal/distances/Wave.h>
#include <CGAL/Intrinsic_triangulations/internal/distances/Window_sources.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Each distance is the length of a way on the surface, up to rounding and the tolerance, so no distance is too small.
struct Window_distances
{
  // How the shortest way reaches a row: at the vertex where the side begins, from this angle to the left of it.
  struct Arrival
  {
    std::uint32_t side = Laid_out_faces::none; // none at sources and at unreachable rows
    double angle = 0;
  };

  std::vector<double> distances;      // of the rows, in the unit of the faces; infinite if unreachable
  std::vector<Arrival> arrivals;      // likewise
  std::vector<std::uint32_t> origins; // likewise: the number of the nearest source
  std::uint64_t number_of_steps = 0;
  bool is_complete = true; // whether the maximum number of steps was enough
};

// \param tolerance of the lengths of ways, as a fraction of each edge that they cross
// \param most the maximum number of windows passed on; the others are lost
// \param goals rows: if there are any, windows farther away than all of them are not followed
// \param farthest windows beyond are not followed, either; distances up to this one are found
// \param waves if not null, receives the windows that enter faces
Window_distances propagate_windows(const Laid_out_faces& surface, double tolerance, const Window_sources& sources,
                                   std::uint64_t most, const Interruption& interruption,
                                   const std::vector<std::uint32_t>& goals = {},
                                   double farthest = std::numeric_limits<double>::infinity(),
                                   std::vector<Wave>* waves = nullptr);

// The waves of all faces, up to a distance in the unit of the faces.
Waves find_waves(const Laid_out_faces& surface, double tolerance, const Window_sources& sources, std::uint64_t most,
                 const Interruption& interruption, double farthest);

// The distance of one row from another, and of those on the way, without a tolerance.
// \param rests lower bounds of the distances of rows from the goal, where it is zero; the larger, the fewer windows
Window_distances propagate_windows_to(const Laid_out_faces& surface, std::uint32_t source, std::uint32_t goal,
                                      const std::vector<double>& rests, std::uint64_t most,
                                      const Interruption& interruption);

// The distances of points from the nearest of some of them, without a tolerance, in the unit of the faces.
// \param points on the faces
// \param sources numbers of points
std::vector<double> propagate_windows(const Laid_out_faces& surface, const Laid_out_points& points,
                                      const std::vector<std::uint32_t>& sources, const Interruption& interruption);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_WINDOW_PROPAGATION_H
