// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Incremental_overlay.h.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OVERLAY_INCREMENTAL_OVERLAY_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OVERLAY_INCREMENTAL_OVERLAY_IMPL_H

#include <CGAL/Intrinsic_triangulations/internal/config.h>
#include <CGAL/Intrinsic_triangulations/internal/overlay/Dynamic_overlay_graph_impl.h>

#include <CGAL/assertions.h>

#include <vector>

namespace CGAL::Intrinsic_triangulations {

CGAL_INTRINSIC_TRIANGULATIONS_INLINE void Incremental_overlay::flip(Edge_index e)
{
  CGAL_precondition(intrinsic_.is_flippable(e));
  take_out(intrinsic_.halfedge(e));
  put_diagonal(intrinsic_.halfedge(e));
  intrinsic_.flip(e);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::vector<Halfedge_index>
Incremental_overlay::crossing_input_halfedges(Halfedge_index h) const
{
  std::vector<Halfedge_index> result;
  for (Halfedge part = first_part(h); is_crossing(target(part)); part = straight_on(part))
    result.push_back(input_halfedge(next(part)));
  return result;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::vector<Halfedge_index>
Incremental_overlay::crossing_intrinsic_halfedges(Halfedge_index h) const
{
  std::vector<Halfedge_index> result;
  for (Halfedge part = first_part_in_input(h); is_crossing(target(part)); part = straight_on(part))
    result.push_back(intrinsic_halfedge(next(part)));
  return result;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE void Incremental_overlay::take_out(Halfedge_index ij)
{
  const Halfedge first = graph_.first_part(ij);
  if (input_halfedge(first).is_valid()) { // only the label changes, from oc to o
    graph_.set_intrinsic_halfedge(first, Halfedge_index());
    return;
  }
  parts_.assign(1, first);
  crossed_.clear(); // the segments that arrive from the right
  while (is_crossing(target(parts_.back()))) {
    crossed_.push_back(graph_.prev(opposite(parts_.back())));
    parts_.push_back(straight_on(parts_.back()));
  }
  for (Halfedge part : parts_)
    graph_.remove(part);
  for (Halfedge h : crossed_)
    graph_.join(h);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE void Incremental_overlay::put_diagonal(Halfedge_index ij)
{
  const Halfedge_index ji = intrinsic_.opposite(ij);
  const Halfedge_index jk = intrinsic_.next(ij), ki = intrinsic_.prev(ij);
  const Halfedge_index il = intrinsic_.next(ji), lj = intrinsic_.prev(ji);

  // The diagonal separates its ends. A chord is crossed exactly if it has one end on the right,
  // between l and k by way of j, and the other on the left, by way of i. Since chords do not
  // meet, the order of their ends is that of the crossings.
  sides_.resize(graph_.end_of_halfedges(), Side::NONE);
  note_chords(right_chords_, lj, jk, Side::RIGHT);
  note_chords(left_chords_, ki, il, Side::LEFT);
  crossed_.clear(); // from right to left
  for (Halfedge h : right_chords_)
    if (sides_[opposite(h).idx()] == Side::LEFT)
      crossed_.push_back(h);

  const Halfedge before_l = before_diagonal(il, Side::LEFT), chord = graph_.next(before_l);
  const Halfedge before_k = before_diagonal(jk, Side::RIGHT);
  if (is_chord(chord) && sides_[opposite(chord).idx()] == Side::NONE) {
    // It leads from l to k, and the diagonal coincides with it: the label becomes oc.
    CGAL_assertion(crossed_.empty() && graph_.next(before_k) == opposite(chord));
    graph_.set_intrinsic_halfedge(chord, ij);
    graph_.set_first_part(ij, chord);
    graph_.set_first_part(ji, opposite(chord));
  } else {
    cross_chords(ij, before_l, before_k);
  }
  for (const std::vector<Halfedge>* chords : {&right_chords_, &left_chords_})
    for (Halfedge h : *chords)
      sides_[h.idx()] = Side::NONE;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE void Incremental_overlay::cross_chords(Halfedge_index ij, Halfedge before_l,
                                                                            Halfedge before_k)
{
  Halfedge before = before_l;
  for (Halfedge chord : crossed_) {
    graph_.split(chord);
    const Halfedge part = graph_.add_intrinsic_part(ij, before, chord);
    if (before == before_l)
      graph_.set_first_part(ij, part);
    before = opposite(graph_.next(part)); // the rest of the chord, towards the crossing
  }
  const Halfedge last = graph_.add_intrinsic_part(ij, before, before_k);
  if (before == before_l)
    graph_.set_first_part(ij, last);
  graph_.set_first_part(intrinsic_.opposite(ij), opposite(last));
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE void
Incremental_overlay::note_chords(std::vector<Halfedge>& chords, Halfedge_index first, Halfedge_index second, Side side)
{
  chords.clear();
  const Halfedge last = graph_.last_part(second);
  for (Halfedge h = graph_.first_part(first); h != last;) {
    h = graph_.next(h);
    for (; is_chord(h); h = graph_.next(opposite(h))) { // clockwise
      chords.push_back(h);
      sides_[h.idx()] = side;
    }
  }
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Incremental_overlay::Halfedge
Incremental_overlay::before_diagonal(Halfedge_index arriving, Side side) const
{
  Halfedge h = graph_.last_part(arriving);
  while (is_chord(graph_.next(h)) && sides_[opposite(graph_.next(h)).idx()] == side)
    h = opposite(graph_.next(h));
  return h;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OVERLAY_INCREMENTAL_OVERLAY_IMPL_H
