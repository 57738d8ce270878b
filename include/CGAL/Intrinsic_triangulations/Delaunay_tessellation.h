// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// What all Delaunay triangulations of a surface have in common: the cells between edges that are no ties.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DELAUNAY_TESSELLATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DELAUNAY_TESSELLATION_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Disjoint_sets.h>

#include <CGAL/enum.h>

#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsRef
///
/// \brief the cells of a Delaunay triangulation without its ties, the edges whose opposite angles sum to exactly π.
///
/// The faces of a cell have a common empty circumcircle. A surface has many Delaunay triangulations if it has ties, but
/// only one Delaunay tessellation (Indermitte, Liebling, Troyanov, Clémençon 2001; Bobenko, Springborn 2007), so the
/// cells do not depend on the order of the input. Their numbers, which follow the faces, do.
class Delaunay_tessellation
{
public:
  /// \brief finds the cells, by exact decisions.
  /// \tparam Triangulation an `Intrinsic_triangulation`
  /// \param triangulation a Delaunay triangulation that keeps its input
  /// \pre `triangulation.keeps_input()`
  /// \exception Undecided_error as `sign_of_cotangent_weight()`
  template <class Triangulation>
  explicit Delaunay_tessellation(const Triangulation& triangulation)
    : is_tie_(triangulation.connectivity().number_of_edges(), false)
  {
    const Delta_complex& complex = triangulation.connectivity();
    internal::Disjoint_sets sets(complex.number_of_faces());
    for (Edge_index e : complex.edges()) {
      if (!complex.is_flippable(e) || triangulation.sign_of_cotangent_weight(e) != ZERO)
        continue;
      is_tie_[e.idx()] = true;
      const Halfedge_index h = complex.halfedge(e);
      sets.unite(complex.face(h).idx(), complex.face(complex.opposite(h)).idx());
    }
    number_of_cells_ = sets.number(cells_);
  }

  /// returns the number of cells.
  std::size_t number_of_cells() const { return number_of_cells_; }
  /// returns the number of the cell that `f` is part of.
  std::size_t cell(Face_index f) const { return cells_[f.idx()]; }
  /// returns whether `e` is a tie, inside a cell.
  bool is_tie(Edge_index e) const { return is_tie_[e.idx()]; }

private:
  std::vector<bool> is_tie_;
  std::vector<std::size_t> cells_;
  std::size_t number_of_cells_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DELAUNAY_TESSELLATION_H
