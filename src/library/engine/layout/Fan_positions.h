// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Fans of input triangles around a vertex, laid out once.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_FAN_POSITIONS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_FAN_POSITIONS_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Index.h>
#include "../../arithmetic/Disk.h"

#include <cstddef>
#include <unordered_map>

namespace CGAL::Intrinsic_triangulations::internal {

// Edges that cross hundreds of input edges do so in fans: in the caps of a prism, or in the sides of a box whose edges
// were divided. So the halfedges around a vertex are laid out once, and a fan of any number of triangles is a quotient
// of two of them. Each vertex has a first halfedge, so that results do not depend on earlier queries.
class Fan_positions
{
  using Vector = Double_double_disk;

public:
  // For shorter ones, products take no longer.
  static constexpr std::size_t long_fan = 8;

  // The ratio of `to` to `from`, which have the same source, counterclockwise or clockwise; that of a full turn if they
  // are equal.
  // \param corner_ratio gives the ratio of the next halfedge counterclockwise to a halfedge
  template <class Corner_ratio>
  Vector ratio(const Delta_complex& input, Halfedge_index from, Halfedge_index to, bool is_counterclockwise,
               const Corner_ratio& corner_ratio)
  {
    if (places_.find(from) == places_.end()) {
      if (places_.size() > most_places)
        clear();
      try {
        lay_out(input, from, corner_ratio);
      } catch (...) { // half of a fan would be taken for the whole fan
        clear();
        throw;
      }
    }
    const Place &a = places_.at(from), &b = places_.at(to);
    Vector numerator = b.position, denominator = a.position;
    if (is_counterclockwise && b.number <= a.number)
      numerator = numerator * whole_turns_.at(input.source(from));
    if (!is_counterclockwise && b.number >= a.number)
      denominator = denominator * whole_turns_.at(input.source(from));
    return times_conjugate(numerator, denominator) / squared_norm(denominator);
  }

private:
  // The place of a halfedge around its source.
  struct Place
  {
    Vector position;
    std::size_t number;
  };
  // Bounds the memory, some 100 bytes for each. Two vertices with more halfedges than that would be laid out
  // alternately.
  static constexpr std::size_t most_places = std::size_t(1) << 21;

  void clear()
  {
    places_.clear();
    whole_turns_.clear();
  }

  template <class Corner_ratio>
  void lay_out(const Delta_complex& input, Halfedge_index h, const Corner_ratio& corner_ratio)
  {
    const Halfedge_index start = input.opposite(input.halfedge(input.source(h)));
    Halfedge_index first = start;
    while (!input.is_border(input.opposite(first)))
      if ((first = input.next(input.opposite(first))) == start)
        break;
    Vector position({1}, {0});
    h = first;
    for (std::size_t number = 0;; ++number) {
      places_.insert({h, {position, number}});
      if (input.is_border(h))
        break;
      position = position * corner_ratio(h);
      h = input.next_around_source(h);
      if (h == first) {
        whole_turns_.insert({input.source(h), position});
        break;
      }
    }
  }

  std::unordered_map<Halfedge_index, Place> places_;
  std::unordered_map<Vertex_index, Vector> whole_turns_; // of vertices that are not on the border
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_FAN_POSITIONS_H
