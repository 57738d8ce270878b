// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Where straight ways begin.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_WINDOW_SOURCES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_WINDOW_SOURCES_H

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

struct Row_source
{
  std::uint32_t row;
  double offset = 0; // the distance there
  std::uint32_t number = 0;
  // The segments that begin there: each at a side that begins there, and from this angle to the left of it. Nothing
  // needs to be sent between their perpendiculars.
  std::vector<std::pair<std::uint32_t, double>> segments;
};

// A segment or a point in a face, relative to one of its sides.
struct Face_source
{
  std::uint32_t side;
  std::array<double, 2> from;
  std::array<double, 2> direction{1, 0}; // a unit vector
  double length = 0;
  double offset = 0;
  std::uint32_t number = 0;
  // For a point that joins segments: ways are sent only in directions that have no negative product with these.
  std::vector<std::array<double, 2>> limits;
  bool is_on_side = false; // a point

  bool is_point() const { return length == 0; }
  std::array<double, 2> to() const { return {from[0] + length * direction[0], from[1] + length * direction[1]}; }
};

struct Window_sources
{
  std::vector<Row_source> rows;
  std::vector<Face_source> in_faces;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_WINDOW_SOURCES_H
