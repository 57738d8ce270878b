// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The halfedges out of each vertex in counterclockwise order.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ROTATION_SYSTEM_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ROTATION_SYSTEM_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/Large_vector.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// They are counted from the one that has the border to its right, or the one of smallest index.
class Rotation_system
{
public:
  Rotation_system() = default;
  // O(size). Each vertex is walked around once: that is what takes the time.
  explicit Rotation_system(const Delta_complex& complex)
    : begin_(std::size_t(complex.number_of_vertices()) + 1, default_init),
      halfedges_(complex.number_of_halfedges(), default_init)
  {
    std::uint32_t end = 0;
    for (Vertex_index v : complex.vertices()) {
      const std::uint32_t begin = begin_[v.idx()] = end;
      if (!complex.halfedge(v).is_valid())
        continue;
      const Halfedge_index start = complex.opposite(complex.halfedge(v));
      std::uint32_t smallest = begin;
      Halfedge_index h = start;
      do {
        if (h < halfedges_[smallest] || end == begin)
          smallest = end;
        halfedges_[end++] = h;
        h = complex.next_around_source(h);
      } while (h != start);
      if (!complex.is_border(complex.opposite(start)))
        std::rotate(halfedges_.begin() + begin, halfedges_.begin() + smallest, halfedges_.begin() + end);
    }
    begin_.back() = end;
  }

  std::uint32_t degree(Vertex_index v) const { return begin_[v.idx() + 1] - begin_[v.idx()]; }

  // \pre i is less than the degree
  Halfedge_index halfedge(Vertex_index v, std::uint32_t i) const { return halfedges_[begin_[v.idx()] + i]; }

private:
  Large_vector<std::uint32_t> begin_; // for each vertex, in ...
  Large_vector<Halfedge_index> halfedges_;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ROTATION_SYSTEM_H
