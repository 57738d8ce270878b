// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Incremental_overlay.h.

#include <CGAL/Intrinsic_triangulations/Incremental_overlay.h>
#include <CGAL/Intrinsic_triangulations/errors.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

Incremental_overlay::Incremental_overlay(const Delta_complex& input)
  : input_(input), intrinsic_(input), number_of_vertices_(input.number_of_vertices()),
    end_of_crossings_(input.number_of_vertices())
{
  halfedges_.reserve(input.number_of_halfedges());
  for (Halfedge_index h : input.halfedges()) {
    halfedges_.push_back({Halfedge(input.next(h).idx()), Halfedge(input.prev(h).idx()), Vertex(input.target(h).idx())});
    first_input_parts_.push_back(Halfedge(h.idx()));
  }
  for (Edge_index e : input.edges())
    segments_.push_back({input.halfedge(e), input.halfedge(e)});
  first_intrinsic_parts_ = first_input_parts_;
}

void Incremental_overlay::flip(Edge_index e)
{
  CGAL_precondition(intrinsic_.is_flippable(e));
  take_out(intrinsic_.halfedge(e));
  put_diagonal(intrinsic_.halfedge(e));
  intrinsic_.flip(e);
}

std::vector<Halfedge_index> Incremental_overlay::crossing_input_halfedges(Halfedge_index h) const
{
  std::vector<Halfedge_index> result;
  for (Halfedge part = first_part(h); is_crossing(target(part)); part = straight_on(part))
    result.push_back(input_halfedge(next(part)));
  return result;
}

std::vector<Halfedge_index> Incremental_overlay::crossing_intrinsic_halfedges(Halfedge_index h) const
{
  std::vector<Halfedge_index> result;
  for (Halfedge part = first_part_in_input(h); is_crossing(target(part)); part = straight_on(part))
    result.push_back(intrinsic_halfedge(next(part)));
  return result;
}

void Incremental_overlay::take_out(Halfedge_index ij)
{
  const Halfedge first = first_part(ij);
  if (input_halfedge(first).is_valid()) { // only the label changes, from oc to o
    segment(first).intrinsic = Halfedge_index();
    return;
  }
  parts_.assign(1, first);
  crossed_.clear(); // the segments that arrive from the right
  while (is_crossing(target(parts_.back()))) {
    crossed_.push_back(prev(opposite(parts_.back())));
    parts_.push_back(straight_on(parts_.back()));
  }
  for (Halfedge part : parts_)
    remove(part);
  for (Halfedge h : crossed_)
    join(h);
}

void Incremental_overlay::put_diagonal(Halfedge_index ij)
{
  const Halfedge_index ji = intrinsic_.opposite(ij);
  const Halfedge_index jk = intrinsic_.next(ij), ki = intrinsic_.prev(ij);
  const Halfedge_index il = intrinsic_.next(ji), lj = intrinsic_.prev(ji);

  // A chord is crossed if and only if one of its ends is on the right, between l and k by way of j, and the other is on
  // the left, by way of i. Since chords do not meet, crossings have the same order as these ends.
  sides_.resize(halfedges_.size(), Side::NONE);
  note_chords(right_chords_, lj, jk, Side::RIGHT);
  note_chords(left_chords_, ki, il, Side::LEFT);
  crossed_.clear(); // from right to left
  for (Halfedge h : right_chords_)
    if (sides_[opposite(h).idx()] == Side::LEFT)
      crossed_.push_back(h);

  const Halfedge before_l = before_diagonal(il, Side::LEFT), chord = next(before_l);
  const Halfedge before_k = before_diagonal(jk, Side::RIGHT);
  if (is_chord(chord) && sides_[opposite(chord).idx()] == Side::NONE) {
    // It runs from l to k, so the diagonal coincides with it: the label becomes oc.
    CGAL_assertion(crossed_.empty() && next(before_k) == opposite(chord));
    segment(chord).intrinsic = directed(ij, chord);
    first_intrinsic_parts_[ij.idx()] = chord;
    first_intrinsic_parts_[ji.idx()] = opposite(chord);
  } else {
    cross_chords(ij, before_l, before_k);
  }
  for (const std::vector<Halfedge>* chords : {&right_chords_, &left_chords_})
    for (Halfedge h : *chords)
      sides_[h.idx()] = Side::NONE;
}

void Incremental_overlay::cross_chords(Halfedge_index ij, Halfedge before_l, Halfedge before_k)
{
  Halfedge before = before_l;
  for (Halfedge chord : crossed_) {
    split(chord);
    const Halfedge part = add_intrinsic_part(ij, before, chord);
    if (before == before_l)
      first_intrinsic_parts_[ij.idx()] = part;
    before = opposite(next(part)); // the rest of the chord, toward the crossing
  }
  const Halfedge last = add_intrinsic_part(ij, before, before_k);
  if (before == before_l)
    first_intrinsic_parts_[ij.idx()] = last;
  first_intrinsic_parts_[intrinsic_.opposite(ij).idx()] = opposite(last);
}

void Incremental_overlay::note_chords(std::vector<Halfedge>& chords, Halfedge_index first, Halfedge_index second,
                                      Side side)
{
  chords.clear();
  const Halfedge last = last_part(second);
  for (Halfedge h = first_part(first); h != last;) {
    h = next(h);
    for (; is_chord(h); h = next(opposite(h))) { // clockwise
      chords.push_back(h);
      sides_[h.idx()] = side;
    }
  }
}

Incremental_overlay::Halfedge Incremental_overlay::before_diagonal(Halfedge_index arriving, Side side) const
{
  Halfedge h = last_part(arriving);
  while (is_chord(next(h)) && sides_[opposite(next(h)).idx()] == side)
    h = opposite(next(h));
  return h;
}

void Incremental_overlay::link(Halfedge h, Halfedge next)
{
  halfedges_[h.idx()].next = next;
  halfedges_[next.idx()].prev = h;
}

Incremental_overlay::Halfedge Incremental_overlay::add_intrinsic_part(Halfedge_index h, Halfedge before,
                                                                      Halfedge arriving)
{
  const Halfedge part = new_segment(target(before), target(arriving));
  segment(part) = {h, Halfedge_index()};
  const Halfedge after = next(before), leaving = next(arriving);
  link(before, part);
  link(part, leaving);
  link(arriving, opposite(part));
  link(opposite(part), after);
  return part;
}

void Incremental_overlay::remove(Halfedge h)
{
  const Halfedge g = opposite(h);
  CGAL_precondition(next(h) != g && next(g) != h);
  link(prev(h), next(g));
  link(prev(g), next(h));
  release(h);
}

void Incremental_overlay::split(Halfedge h)
{
  const Halfedge g = opposite(h), after = next(h), before = prev(g);
  CGAL_precondition(after != g);
  const Vertex end = target(h), crossing = new_crossing();
  const Halfedge rest = new_segment(crossing, end);
  segment(rest).input = input_halfedge(h);
  halfedges_[h.idx()].target = crossing;
  link(h, rest);
  link(rest, after);
  link(before, opposite(rest));
  link(opposite(rest), g);
  if (!is_crossing(end))
    first_input_parts_[input_halfedge(g).idx()] = opposite(rest);
}

void Incremental_overlay::join(Halfedge h)
{
  const Halfedge g = opposite(h), rest = next(h);
  CGAL_precondition(next(opposite(rest)) == g && input_halfedge(rest) == input_halfedge(h));
  free_crossings_.push_back(target(h));
  halfedges_[h.idx()].target = target(rest);
  link(h, next(rest));
  link(prev(opposite(rest)), g);
  if (!is_crossing(target(h)))
    first_input_parts_[input_halfedge(g).idx()] = g;
  release(rest);
}

Incremental_overlay::Vertex Incremental_overlay::new_crossing()
{
  if (free_crossings_.empty())
    return Vertex(end_of_crossings_++); // there are fewer vertices than halfedges
  const Vertex v = free_crossings_.back();
  free_crossings_.pop_back();
  return v;
}

Incremental_overlay::Halfedge Incremental_overlay::new_segment(Vertex source, Vertex target)
{
  if (free_segments_.empty()) {
    if (segments_.size() >= std::size_t(1) << 31)
      throw Integer_overflow_error("the overlay has 2^31 segments or more: too many edges cross each other");
    free_segments_.push_back(Segment(size_type(segments_.size())));
    segments_.emplace_back();
    halfedges_.resize(2 * segments_.size());
  }
  const Halfedge h(2 * free_segments_.back().idx());
  free_segments_.pop_back();
  halfedges_[h.idx()].target = target;
  halfedges_[h.idx() + 1].target = source;
  return h;
}

void Incremental_overlay::release(Halfedge h)
{
  segment(h) = Segment_record();
  free_segments_.push_back(Segment(h.idx() >> 1));
}

} // namespace CGAL::Intrinsic_triangulations
