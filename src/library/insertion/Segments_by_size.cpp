// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The edges that refinement must not flip.

#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/Segments_by_size.h>
#include <CGAL/Intrinsic_triangulations/surface_features.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

Segments_by_size::Segments_by_size(const Exact_engine& engine, std::vector<bool> always,
                                   const std::optional<double>& sharp_edge_angle)
  : always_(std::move(always)), angle_(sharp_edge_angle)
{
  if (angle_ && !(*angle_ >= 0 && *angle_ <= 180))
    throw Invalid_argument_error("the angle of sharp edges is between 0 and 180 degrees");
  if (angle_ && engine.metric().points().empty())
    throw Invalid_argument_error("sharp edges need a surface in space, but "
                                 "this one has only edge lengths");
}

std::vector<bool> Segments_by_size::operator()(const Exact_engine& engine, double size) const
{
  std::vector<bool> result = always_;
  if (!angle_)
    return result;
  const Correspondence& correspondence = engine.correspondence();
  const Delta_complex &complex = engine.connectivity(), &input = correspondence.input();
  const auto& metric = engine.metric();
  const std::vector<bool> is_sharp =
    sharp_edges(input, std::vector<std::array<double, 3>>(metric.points().begin(), metric.points().end()), *angle_,
                std::ldexp(size, -metric.unit_exponent()));
  // Vertices on an edge divide it into parts.
  std::vector<std::size_t> missing_parts(is_sharp.begin(), is_sharp.end());
  for (const Surface_point& point : correspondence.locations())
    if (point.dimension() == 1)
      if (const Edge_index e = input.edge(side_of(input, point)); is_sharp[e.idx()])
        ++missing_parts[e.idx()];
  for (Edge_index e : complex.edges())
    if (correspondence.coordinates().is_original(e))
      if (const Edge_index whole = input.edge(correspondence.input_halfedge(complex.halfedge(e)));
          is_sharp[whole.idx()]) {
        result[e.idx()] = true;
        --missing_parts[whole.idx()];
      }
  const auto missing = std::find_if(missing_parts.begin(), missing_parts.end(), [](std::size_t n) { return n != 0; });
  if (missing != missing_parts.end())
    throw Invalid_argument_error("edge " + std::to_string(missing - missing_parts.begin()) +
                                 " of the input is sharp, but was flipped before: refine the input "
                                 "instead");
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal
