// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// How long edges may be, from place to place.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_EDGE_SIZES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_EDGE_SIZES_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The sizes that are wanted at the vertices of the input, in its unit.
struct Wanted_sizes
{
  std::vector<double> given; // or none
  std::optional<double> normal_angle;
  double sharp_edge_angle = 180;
  double gradation = 0.3;
};

// Combines them, so that none is larger than another one plus a part of the distance along edges of the input.
// \param is_kept edges of the triangulation along which the surface may bend
// \return none if none are wanted
// \exception Invalid_argument_error if a number is out of range, or the surface has no points
std::vector<double> sizes_of_input(const Exact_engine& engine, Wanted_sizes wanted, const std::vector<bool>& is_kept);

// Sizes are linear on the faces of the input, and an edge may be as long as their mean at its ends.
class Edge_sizes
{
public:
  // \param of_input for each vertex of the input, or none
  Edge_sizes(const Exact_engine& engine, std::vector<double> of_input, double maximum_length)
    : engine_(engine), sizes_(std::move(of_input)), maximum_length_(maximum_length)
  {
    add_vertices();
  }

  // Must be called after an insertion.
  void add_vertices();

  double longest_between(Vertex_index v, Vertex_index w) const
  {
    return sizes_.empty() ? maximum_length_ : (std::min)(maximum_length_, (sizes_[v.idx()] + sizes_[w.idx()]) / 2);
  }
  // About how many vertices a large triangle with these corners needs inside.
  double number_of_vertices(const std::array<Vertex_index, 3>& corners, double area) const;
  static double number_of_vertices(double area, double size) { return area / (area_of_vertex * size * size); }

private:
  static constexpr double area_of_vertex = 0.45; // found by refining, in squares of the size

  double at(Vertex_index v) const { return longest_between(v, v); }

  const Exact_engine& engine_;
  std::vector<double> sizes_; // of the vertices of the triangulation
  double maximum_length_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_EDGE_SIZES_H
