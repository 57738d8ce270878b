// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sources of `idt distance`: vertices, points, edges and curves.

#ifndef IDT_DISTANCE_SOURCES_H
#define IDT_DISTANCE_SOURCES_H

#include "input/place_files.h"

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Geodesic_source.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Surface_with_barriers.h>
#include <CGAL/Intrinsic_triangulations/Tufted_cover.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace idt {

// As the user names them.
struct Named_sources
{
  std::vector<std::uint64_t> vertices;
  std::string points_path, edges_path, curve_path;

  bool has_files() const { return !points_path.empty() || !edges_path.empty() || !curve_path.empty(); }
};

// On a surface: first the vertices, then the points, all edges together, and the curves.
struct Placed_sources
{
  std::vector<CGAL::Intrinsic_triangulations::Geodesic_source> sources;
  std::vector<std::array<double, 3>> points, curves; // in space, if the surface is; the latter with NaN before each
  double largest_snap = -1; // the largest distance of a point in space from the surface; negative without such points
};

// \param points of the vertices of `triangulation.input()`; empty if there are only lengths
// \exception Usage_error if there is no such vertex or edge, or points in space are given without points
// \exception Invalid_surface_error, Invalid_point_error if a file cannot be read, or does not fit the surface
Placed_sources place_sources(const Named_sources& named,
                             const CGAL::Intrinsic_triangulations::Intrinsic_triangulation<
                               CGAL::Intrinsic_triangulations::Filtered_edge_length_traits>& triangulation,
                             const std::vector<std::array<double, 3>>& points);

// \param points, triangles of the input; no points if there are only lengths
Placed_sources place_sources(const Named_sources& named, const CGAL::Intrinsic_triangulations::Tufted_cover& cover,
                             const std::vector<std::array<double, 3>>& points,
                             const std::vector<std::array<std::uint32_t, 3>>& triangles);

// Cuts the surface open along edges and curves.
// \param points of it; there have to be some
// \param largest_snap grows to that of the barriers
// \exception Usage_error also if there are only lengths
CGAL::Intrinsic_triangulations::Surface_with_barriers
place_barriers(const Named_sources& named,
               const CGAL::Intrinsic_triangulations::Intrinsic_triangulation<
                 CGAL::Intrinsic_triangulations::Filtered_edge_length_traits>& triangulation,
               const std::vector<std::array<double, 3>>& points, double& largest_snap);

} // namespace idt

#endif // IDT_DISTANCE_SOURCES_H
