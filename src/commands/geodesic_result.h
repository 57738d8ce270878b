// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What `idt geodesic` finds, and its files.

#ifndef IDT_GEODESIC_RESULT_H
#define IDT_GEODESIC_RESULT_H

#include "input/Surface.h"
#include "input/Triangle_soup.h"

#include <CGAL/Intrinsic_triangulations/Geodesic_path_network.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/shortest_path_on_triangles.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace idt {

// The distance of a given point from the surface.
struct Snap
{
  std::string option;
  double distance;
};

// A point in a face of the input, which the line enters there.
struct Point_in_face
{
  std::size_t face;
  std::array<std::size_t, 3> vertices; // of the face
  std::array<double, 3> coordinates;   // which belong to them
};

struct Geodesic_result
{
  std::string input;
  std::vector<CGAL::Intrinsic_triangulations::Surface_point> points; // of the line, unless it is on any triangles
  std::vector<Point_in_face> line;
  std::vector<std::array<double, 3>> positions; // of its points; empty if the surface is given by lengths
  std::optional<double> initial_length;         // of paths
  std::optional<double> distance;               // if the shortest was asked for
  double length = 0;
  std::uint64_t flips = 0;
  bool is_geodesic = true, is_closed = false;
  std::string status;
  std::optional<CGAL::Intrinsic_triangulations::Vertex_index> vertex; // to which it shrank or at which it ends
  std::vector<Snap> snaps;
  bool is_on_any_triangles = false; // which need not be a surface
  Repairs repairs;
  std::vector<std::string> warnings;
  double seconds = 0;

  bool is_shortest() const { return distance && std::abs(length - *distance) <= 1e-9 * *distance; }
  std::size_t number_of_segments() const { return line.empty() ? 0 : line.size() - 1; }
};

std::vector<Point_in_face> points_in_faces(const CGAL::Intrinsic_triangulations::Delta_complex& input,
                                           const std::vector<CGAL::Intrinsic_triangulations::Surface_point>& points);
std::vector<Point_in_face> points_in_faces(const Triangle_soup& soup,
                                           const CGAL::Intrinsic_triangulations::Path_on_triangles& path);

// \param type ".obj", ".ply", ".vtp" or ".csv"
// \exception Output_error as write_file()
void write_line(const std::string& path, const std::string& type, const Geodesic_result& result);

// \exception Output_error as write_json()
void write_stats(const std::string& path, const Geodesic_result& result);

// For people.
void write_report(std::ostream& os, const Geodesic_result& result);

} // namespace idt

#endif // IDT_GEODESIC_RESULT_H
