// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The rows of the vertices of a triangulation in matrices and lists.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MATRICES_ROW_OF_VERTEX_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MATRICES_ROW_OF_VERTEX_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Index.h>

#include <cstddef>

namespace CGAL::Intrinsic_triangulations::internal {

// The row of each vertex, here one of its own, and how much a face counts.
class Row_of_vertex
{
public:
  explicit Row_of_vertex(const Delta_complex& complex) : number_of_rows_(complex.number_of_vertices()) {}
  std::size_t number_of_rows() const { return number_of_rows_; }
  Vertex_index::size_type operator()(Vertex_index v) const { return v.idx(); }
  Vertex_index::size_type of_input(Vertex_index v) const { return v.idx(); }
  bool is_cut() const { return false; }
  // Calls visit(row, row, length) for each edge without faces.
  template <class Visit>
  void for_each_flat_edge(const Visit&) const
  {}
  double share(Face_index) const { return 1; }

private:
  std::size_t number_of_rows_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MATRICES_ROW_OF_VERTEX_H
