// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The contents of a file about a triangulation, besides its input.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_SAVED_TRIANGULATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_SAVED_TRIANGULATION_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/internal/system/for_each_block.h>
#include <CGAL/Intrinsic_triangulations/Large_vector.h>

#include <array>
#include <functional>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

class Exact_engine;

struct Saved_triangulation
{
  Delta_complex connectivity;
  Normal_coordinates coordinates;       // of its edges
  std::vector<Surface_point> locations; // of the vertices that follow those of the input
  // The data of Filtered_edge_length_traits, in the unit of the metric: squared lengths; four times areas, and bounds.
  Large_vector<double> squared_lengths;
  Large_vector<std::array<double, 2>> areas;
  std::vector<bool> is_straight; // for each face: whether it was known to be a triangle in space

  // Replaces the triangulation of an engine by this one, which a file claims to derive from the engine's input. All of
  // this is checked, exactly. The numbers stay here.
  // \pre nothing was flipped, and there is an entry for each element
  // \exception Invalid_surface_error if the claim is false; then the engine can only be destroyed
  // \param is_known whether the numbers of a face are known to be right
  void restore(Exact_engine& engine, const Block_runner& run, const std::function<bool(Face_index)>& is_known);
};

// The faces with a useful bound.
std::vector<bool> bounded_faces(const Delta_complex& complex, const std::function<double(Edge_index)>& squared_length,
                                const std::function<double(Face_index)>& error);
// Replaces the numbers of the other faces where they are far from the true ones. Writing a file does the same, so a
// file stays the same when it is read and written again.
void mend_unbounded(const Exact_engine& engine, const std::vector<bool>& are_bounded,
                    Large_vector<double>& squared_lengths, Large_vector<std::array<double, 2>>& areas);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_SAVED_TRIANGULATION_H
