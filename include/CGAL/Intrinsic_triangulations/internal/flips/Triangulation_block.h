// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A part of a triangulation that a thread has to itself.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPS_TRIANGULATION_BLOCK_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPS_TRIANGULATION_BLOCK_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>
#include <CGAL/Intrinsic_triangulations/internal/flips/Whole_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/system/for_each_block.h>

#include <CGAL/Uncertain.h>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// Consecutive edges of a triangulation, and what a Delaunay_flipper needs to flip those of them
// whose hinges consist of edges of the block alone.
//
// Blocks that do not overlap may be used by several threads at once. For all that a flip reads
// or writes belongs to the five edges and two faces of its hinge, but for the halfedges of
// the vertices (see Delta_complex). A face of the hinge has three edges of the block. So it is
// no face of a hinge of another block.
//
// What needs a look at the rest of the triangulation is postponed: the exact stages follow
// edges through input faces wherever they lie.
template <class Traits_>
class Triangulation_block
{
public:
  using Triangulation = Intrinsic_triangulation<Traits_>;
  using Traits = Traits_;
  using Boolean = typename Triangulation::Boolean;
  enum class Flip_outcome {
    FLIPPED,
    NOT_CONVEX,
    UNDECIDED,
    POSTPONED
  };
  static constexpr bool is_whole = false;

  // Whether there may be blocks: numbers are of a type that threads need not share.
  static constexpr bool are_possible = is_for_threads<typename Triangulation::Edge_data>;
  using Journals = Exact_engine::Journals; // one for each block

  // \param most the number of blocks, at most
  static Journals journals(Triangulation& triangulation, std::size_t most) { return {triangulation.engine_, most}; }

  Triangulation_block(Triangulation& triangulation, Edge_index::size_type first, Edge_index::size_type last,
                      Journals::Journal& journal)
    : triangulation_(triangulation), first_(first), size_(last - first), journal_(journal)
  {}

  const Delta_complex& connectivity() const { return triangulation_.connectivity(); }

  bool contains_hinge(Edge_index e) const
  {
    const Delta_complex& complex = connectivity();
    const Halfedge_index h = complex.halfedge(e), g = complex.opposite(h);
    return contains(complex.next(h)) && contains(complex.prev(h)) && contains(complex.next(g)) &&
           contains(complex.prev(g));
  }

  bool is_known_Delaunay(Edge_index e) const { return whole().is_known_Delaunay(e); }
  unsigned are_known_Delaunay(Edge_index e) const { return whole().are_known_Delaunay(e); }

  // By what is stored alone.
  Boolean is_locally_Delaunay(Edge_index e) const
  {
    return triangulation_.traits_.is_locally_Delaunay_object()(triangulation_.hinge(connectivity().hinge(e)));
  }
  Boolean test_and_recompute(Edge_index e) const { return is_locally_Delaunay(e); }
  void count_as_tested(std::uint64_t) const {} // all at once, when the blocks are done

  Flip_outcome flip_not_Delaunay(const Hinge_halfedges& around)
  {
    const typename Triangulation::Hinge_data old = triangulation_.hinge(around);
    if constexpr (Triangulation::uses_exact_geometry)
      if (!triangulation_.is_new_edge_known_to_have_length(old))
        return Flip_outcome::POSTPONED;
    switch (triangulation_.flip_hinge(around, old, triangulation_.traits().construct_flipped_hinge_object(),
                                      [&] { journal_.flip(around); })) {
    case Triangulation::Flip_outcome::FLIPPED:
      return Flip_outcome::FLIPPED;
    case Triangulation::Flip_outcome::NOT_CONVEX:
      return Flip_outcome::NOT_CONVEX;
    case Triangulation::Flip_outcome::UNDECIDED:
      break;
    }
    return Flip_outcome::UNDECIDED;
  }

private:
  Whole_triangulation<Traits> whole() const { return Whole_triangulation<Traits>(triangulation_); }

  bool contains(Halfedge_index h) const
  {
    return connectivity().edge(h).idx() - first_ < size_; // the difference is unsigned
  }

  Triangulation& triangulation_;
  Edge_index::size_type first_, size_;
  Journals::Journal& journal_;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPS_TRIANGULATION_BLOCK_H
