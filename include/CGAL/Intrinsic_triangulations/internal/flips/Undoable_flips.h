// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Flips that can be undone.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPS_UNDOABLE_FLIPS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPS_UNDOABLE_FLIPS_H

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/flips/Whole_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Large_vector.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// Notes what is changed. Afterwards connectivity, integers and stored numbers are those that they were, to the last bit.
//
// \pre nothing else changes the triangulation, and there is no journal of flips
template <class Traits>
class Undoable_flips
{
  using Whole = Whole_triangulation<Traits>;

public:
  using Triangulation = Intrinsic_triangulation<Traits>;

  explicit Undoable_flips(Triangulation& triangulation) : whole_(triangulation) {}

  Triangulation& triangulation() const { return whole_.triangulation(); }

  // How much was changed.
  std::size_t size() const { return changes_.size(); }

  // Undoes changes until it was only so much. Never throws.
  void undo(std::size_t size)
  {
    for (; changes_.size() > size; changes_.pop_back()) {
      const Change& change = changes_.back();
      if (change.is_flip) {
        const Hinge_halfedges now = whole_.connectivity().hinge(whole_.connectivity().edge(change.side));
        whole_.flip_back({now.ij, now.lj, now.jk, now.ji, now.ki, now.il}, change.before);
      } else {
        whole_.put_back(change.side, change.before.ijk);
      }
    }
  }

  // As `flip()` and `recompute()` of a triangulation. An exception leaves everything as it was but for better numbers.
  bool flip(Edge_index e)
  {
    if (!whole_.is_convex(e, [this](Face_index f) { recompute(f); }))
      return false;
    make_room(changes_, 1);
    const Hinge_halfedges around = whole_.connectivity().hinge(e);
    const Change change{around.ij, true, whole_.replaced(around)};
    if (whole_.flip_not_Delaunay(around) != Triangulation::Flip_outcome::FLIPPED)
      return false;
    changes_.push_back(change);
    return true;
  }
  void recompute(Face_index f)
  {
    const Halfedge_index h = whole_.connectivity().halfedge(f);
    make_room(changes_, 1);
    changes_.push_back({h, false, {whole_.numbers_of_face(h), {}, {}}});
    whole_.recompute(f);
  }

private:
  struct Change
  {
    Halfedge_index side; // of the edge that was flipped, or of the face whose numbers were replaced
    bool is_flip;
    typename Whole::Replaced before;
  };

  Whole whole_;
  std::vector<Change> changes_;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPS_UNDOABLE_FLIPS_H
