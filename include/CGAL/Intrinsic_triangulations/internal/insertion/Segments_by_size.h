// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The edges that refinement must not flip.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_SEGMENTS_BY_SIZE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_SEGMENTS_BY_SIZE_H

#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>

#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Those of the border, those that are given, and sharp ones. Which edges are
// sharp depends on the smallest size.
class Segments_by_size
{
public:
  // \param always the edges of the border and those that are given, of the current triangulation
  // \param sharp_edge_angle in degrees, or none
  // \exception Invalid_argument_error if the angle is out of range, or the surface has no points
  Segments_by_size(const Exact_engine& engine, std::vector<bool> always, const std::optional<double>& sharp_edge_angle);

  bool depend_on_size() const { return angle_.has_value(); }
  // For each edge of the triangulation for which this was made.
  // \param size in the unit of the input
  // \exception Invalid_argument_error if a sharp edge of the input was flipped
  std::vector<bool> operator()(const Exact_engine& engine, double size) const;

private:
  std::vector<bool> always_;
  std::optional<double> angle_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_SEGMENTS_BY_SIZE_H
