// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A surface of the interchange files as a triangulation of this package.

#ifndef IDT_BENCHMARK_SYSTEMS_OWN_TRIANGULATION_H
#define IDT_BENCHMARK_SYSTEMS_OWN_TRIANGULATION_H

#include "Interchange.h"

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace systems {

namespace IT = CGAL::Intrinsic_triangulations;
using Own_triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

// The halfedges of the sides of faces.
inline std::vector<IT::Halfedge_index> halfedges_of_sides(const IT::Delta_complex& complex)
{
  std::vector<IT::Halfedge_index> result;
  for (IT::Face_index f : complex.faces()) {
    IT::Halfedge_index h = complex.halfedge(f);
    for (int i = 0; i < 3; ++i, h = complex.next(h))
      result.push_back(h);
  }
  return result;
}

inline IT::Delta_complex connectivity_of(const Surface& surface)
{
  const Triangles& triangles = surface.triangles;
  if (!surface.is_gluing())
    return IT::make_Delta_complex_from_triangles(surface.points.size(), triangles.corners);
  std::vector<std::array<std::uint32_t, 2>> pairs;
  for (std::size_t side = 0; side < triangles.number_of_sides(); ++side)
    if (triangles.opposite[side] > std::int64_t(side))
      pairs.push_back({std::uint32_t(side), std::uint32_t(triangles.opposite[side])});
  return IT::make_Delta_complex_from_gluing(triangles.corners.size(), pairs);
}

// Nothing is flipped.
inline Own_triangulation make_own_triangulation(const Surface& surface)
{
  IT::Delta_complex complex = connectivity_of(surface);
  if (!surface.is_gluing())
    return Own_triangulation(std::move(complex), surface.points);
  const std::vector<IT::Halfedge_index> halfedges = halfedges_of_sides(complex);
  std::vector<double> lengths(complex.number_of_edges());
  for (std::size_t side = 0; side < halfedges.size(); ++side)
    lengths[complex.edge(halfedges[side]).idx()] = surface.triangles.lengths[side];
  return Own_triangulation::from_lengths(std::move(complex), std::move(lengths));
}

// Without lengths.
inline Triangles triangles_of(const IT::Delta_complex& complex)
{
  const std::vector<IT::Halfedge_index> halfedges = halfedges_of_sides(complex);
  Triangles result;
  result.corners.resize(complex.number_of_faces());
  std::vector<std::int64_t> side_of(complex.number_of_halfedges(), -1);
  for (std::size_t side = 0; side < halfedges.size(); ++side) {
    result.corners[side / 3][side % 3] = complex.source(halfedges[side]).idx();
    side_of[halfedges[side].idx()] = std::int64_t(side);
  }
  for (IT::Halfedge_index h : halfedges)
    result.opposite.push_back(side_of[complex.opposite(h).idx()]);
  return result;
}

} // namespace systems

#endif // IDT_BENCHMARK_SYSTEMS_OWN_TRIANGULATION_H
