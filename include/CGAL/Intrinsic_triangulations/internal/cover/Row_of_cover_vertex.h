// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The rows of the vertices of a cover: those of the input.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COVER_ROW_OF_COVER_VERTEX_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COVER_ROW_OF_COVER_VERTEX_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Index.h>
#include <CGAL/Intrinsic_triangulations/Tufted_cover.h>

#include <cstddef>
#include <cstdint>

namespace CGAL::Intrinsic_triangulations::internal {

// The vertices of a cover by the rows of its matrices.
class Row_of_cover_vertex
{
public:
  explicit Row_of_cover_vertex(const Tufted_cover& cover) : cover_(cover) {}
  std::size_t number_of_rows() const { return cover_.representative.size(); }
  std::uint32_t operator()(Vertex_index v) const { return cover_.vertex_of[v.idx()]; }
  // The row of a vertex of the input.
  std::uint32_t of_input(Vertex_index v) const { return cover_.representative[v.idx()]; }
  bool is_cut() const { return cover_.is_cut; }
  template <class Visit>
  void for_each_flat_edge(const Visit& visit) const
  {
    for (const Tufted_cover::Flat_edge& e : cover_.flat_edges)
      visit(e.source, e.target, e.length);
  }
  // The weight of a face, or of each face at an edge: one half if it has a second copy.
  double share(Face_index f) const { return cover_.is_half[f.idx()] ? 0.5 : 1; }
  double share(Edge_index e) const
  {
    const Delta_complex& complex = cover_.triangulation.connectivity();
    const Halfedge_index h = complex.halfedge(e);
    return share(complex.face(complex.is_border(h) ? complex.opposite(h) : h));
  }

private:
  const Tufted_cover& cover_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COVER_ROW_OF_COVER_VERTEX_H
