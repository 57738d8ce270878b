// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The halfedges out of each vertex in counterclockwise order.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_HISTORY_ROTATION_SYSTEM_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_HISTORY_ROTATION_SYSTEM_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Large_vector.h>

#include <cstddef>
#include <cstdint>

namespace CGAL::Intrinsic_triangulations::internal {

class Rotation_system
{
public:
  // O(size). Walking around each vertex once takes most of the time.
  explicit Rotation_system(const Delta_complex& complex)
    : begin_(std::size_t(complex.number_of_vertices()) + 1, default_init),
      halfedges_(complex.number_of_halfedges(), default_init), position_(complex.number_of_halfedges(), default_init)
  {
    std::uint32_t end = 0;
    for (Vertex_index v : complex.vertices()) {
      begin_[v.idx()] = end;
      if (!complex.halfedge(v).is_valid())
        continue;
      const Halfedge_index start = complex.opposite(complex.halfedge(v));
      Halfedge_index h = start;
      do {
        position_[h.idx()] = end;
        halfedges_[end++] = h;
        h = complex.next_around_source(h);
      } while (h != start);
    }
    begin_.back() = end;
  }

  // The halfedge of the complex after this many steps. O(1)
  Halfedge_index advanced(const Delta_complex& complex, Halfedge_index h, std::uint64_t steps) const
  {
    const Vertex_index v = complex.source(h);
    const std::uint64_t begin = begin_[v.idx()], degree = begin_[v.idx() + 1] - begin;
    return halfedges_[begin + (position_[h.idx()] - begin + steps) % degree];
  }

private:
  Large_vector<std::uint32_t> begin_; // for each vertex, in ...
  Large_vector<Halfedge_index> halfedges_;
  Large_vector<std::uint32_t> position_; // of each halfedge there
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_HISTORY_ROTATION_SYSTEM_H
