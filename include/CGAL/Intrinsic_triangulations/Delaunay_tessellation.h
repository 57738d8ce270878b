// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The Delaunay tessellation: what all Delaunay triangulations of a surface have in common.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DELAUNAY_TESSELLATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DELAUNAY_TESSELLATION_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>

#include <CGAL/assertions.h>

#include <boost/pending/disjoint_sets.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsRef
///
/// \brief the cells that are left of a Delaunay triangulation when all ties are removed:
/// all edges whose opposite angles sum to exactly π.
///
/// The faces of a cell have a common empty circumcircle. A surface has many Delaunay
/// triangulations if it has ties, but only one Delaunay tessellation (Indermitte,
/// Liebling, Troyanov, Clémençon 2001; Bobenko, Springborn 2007), so the cells do not
/// depend on the order of the input; their numbers do, which follow the faces.
class Delaunay_tessellation
{
public:
  /// \brief finds the cells, by exact decisions.
  /// \tparam Triangulation an `Intrinsic_triangulation`
  /// \param triangulation a Delaunay triangulation that keeps its input
  /// \pre `triangulation.keeps_input()`
  /// \exception Undecided_error as `sign_of_cotangents()` of `Exact_geometry`
  template <class Triangulation>
  explicit Delaunay_tessellation(const Triangulation& triangulation)
    : is_tie_(triangulation.connectivity().number_of_edges(), false),
      cells_(triangulation.connectivity().number_of_faces())
  {
    const Delta_complex& complex = triangulation.connectivity();
    const std::size_t number_of_faces = complex.number_of_faces();
    std::vector<std::uint32_t> rank(number_of_faces), parent(number_of_faces);
    boost::disjoint_sets<std::uint32_t*, std::uint32_t*> sets(rank.data(), parent.data());
    for (std::uint32_t f = 0; f < number_of_faces; ++f)
      sets.make_set(f);
    for (Edge_index e : complex.edges()) {
      if (!complex.is_flippable(e) || triangulation.sign_of_cotangent_weight(e) != ZERO)
        continue;
      is_tie_[e.idx()] = true;
      const Halfedge_index h = complex.halfedge(e);
      sets.union_set(complex.face(h).idx(), complex.face(complex.opposite(h)).idx());
    }
    std::vector<std::size_t> number_of(number_of_faces, number_of_faces);
    for (std::uint32_t f = 0; f < number_of_faces; ++f) {
      std::size_t& number = number_of[sets.find_set(f)];
      if (number == number_of_faces)
        number = number_of_cells_++;
      cells_[f] = number;
    }
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

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DELAUNAY_TESSELLATION_H
