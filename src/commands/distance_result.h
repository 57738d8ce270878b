// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What `idt distance` finds, and its files.

#ifndef IDT_DISTANCE_RESULT_H
#define IDT_DISTANCE_RESULT_H

#include "commands/distance_lines.h"
#include "commands/distance_options.h"
#include "output/write_straight_mesh.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/farthest_vertices.h>
#include <CGAL/Intrinsic_triangulations/simplify_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace idt {

struct Distance_result
{
  std::size_t number_of_vertices = 0;
  std::vector<std::array<double, 3>> points; // empty if the surface is given by lengths
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<double> distances; // infinite where no source is connected; for a matrix, row after row
  std::vector<std::uint32_t> nearest_sources;
  std::vector<CGAL::Intrinsic_triangulations::Farthest_vertex> samples;
  Distance_lines lines;
  std::vector<std::array<double, 3>> source_points, source_curves; // as those of Placed_sources
  double largest_snap = -1;                                        // of sources in space, if there are any
  std::vector<Named_values> vectors;                               // other values at each vertex
  std::uint64_t flips = 0;
  std::size_t number_of_inserted_vertices = 0;
  std::optional<double> mean_edge_length; // by heat
  std::size_t number_of_bounded_distances = 0;
  std::size_t nonmanifold_edges = 0;
  std::string cuts; // by repair
  bool is_complete = true;
  std::optional<CGAL::Intrinsic_triangulations::Metric_change> change; // by simplification
  std::size_t number_of_simplified_vertices = 0;
  std::optional<std::array<double, 2>> errors; // the mean and the largest one, as fractions of the exact distance
  std::optional<CGAL::Intrinsic_triangulations::Common_subdivision> subdivision; // for the overlay and the view
  std::vector<std::array<double, 3>> cut_points; // of the vertices of its input, if that was cut along barriers
  CGAL::Intrinsic_triangulations::Element_numbers input_numbers, numbers; // for the view
  Named_values overlay_distances{"distance", {}};
  double read_seconds = 0, triangulation_seconds = 0, distance_seconds = 0;
  std::vector<std::string> warnings;

  std::size_t number_of_unreachable_vertices() const
  {
    return std::size_t(std::count(distances.begin(), distances.end(), std::numeric_limits<double>::infinity()));
  }
  // Of the vertices of the input of the subdivision.
  const std::vector<std::array<double, 3>>& points_below() const { return cut_points.empty() ? points : cut_points; }
  // Whether heat gave more than a few impossible distances. Next to the sources there are always some.
  bool is_far_from_right() const { return number_of_bounded_distances > 3 + number_of_vertices / 100; }
  // The largest distance of vertices that can be reached.
  double largest_distance() const
  {
    double result = 0;
    for (double d : distances)
      if (std::isfinite(d))
        result = (std::max)(result, std::abs(d));
    return result;
  }
};

// \exception Usage_error if the input has only lengths, and a file needs points
// \exception Output_error as write_file()
void write_files(const Distance_options& options, const Distance_result& result);

// For people.
void write_report(std::ostream& os, const Distance_options& options, const Distance_result& result);

} // namespace idt

#endif // IDT_DISTANCE_RESULT_H
