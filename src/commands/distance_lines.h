// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The lines of `idt distance`: at given distances, and between the cells of the sources.

#ifndef IDT_DISTANCE_LINES_H
#define IDT_DISTANCE_LINES_H

#include "view/View.h"

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Geodesic_source.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/isolines.h>

#include <CLI/CLI.hpp>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace idt {

// As the user names them.
struct Line_options
{
  std::vector<double> distances;
  std::optional<double> step, chord_tolerance;
  std::string lines_path, borders_path;

  void add_options(CLI::App& command);

  bool has_isolines() const { return !distances.empty() || step; }
  bool are_wanted() const { return has_isolines() || !borders_path.empty(); }

  // \exception Usage_error if they make no sense
  void check(bool are_signed, bool has_view) const;
};

struct Distance_lines
{
  std::optional<CGAL::Intrinsic_triangulations::Surface_lines> isolines, borders;
  CGAL::Intrinsic_triangulations::Delta_complex input; // where they lie, if there are any

  // Gives isolines to the right of a curve a negative distance.
  void set_signs(const std::vector<std::vector<CGAL::Intrinsic_triangulations::Surface_point>>& curve);

  // Drops isolines that have the opposite of a wanted distance.
  // \param of_vertices their distances, for the message
  // \exception Usage_error if no line has one of the wanted distances
  void keep_wanted(const Line_options& options, bool are_signed, const std::vector<double>& of_vertices);

  // Adds them to the view. \param points of the vertices of the input
  void show(View& view, const std::vector<std::array<double, 3>>& points) const;

  // \param points likewise; empty if the surface is given by lengths
  // \exception Output_error as write_file()
  void write(const Line_options& options, const std::vector<std::array<double, 3>>& points) const;

  // Why there are no lines of a kind that was wanted.
  std::vector<std::string> warnings() const;

  // What there is, for the report: "5 isolines, 3 borders".
  std::string text() const;
};

// On the input of the triangulation, without signs.
// \param tolerance as of the distances
// \param largest the largest distance of a vertex
// \exception Usage_error if there are too many
Distance_lines find_lines(const Line_options& options,
                          const CGAL::Intrinsic_triangulations::Intrinsic_triangulation<
                            CGAL::Intrinsic_triangulations::Filtered_edge_length_traits>& triangulation,
                          const std::vector<CGAL::Intrinsic_triangulations::Geodesic_source>& sources, double tolerance,
                          double largest);

} // namespace idt

#endif // IDT_DISTANCE_LINES_H
