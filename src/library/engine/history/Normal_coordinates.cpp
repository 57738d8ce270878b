// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Normal_coordinates.

#include <CGAL/Intrinsic_triangulations/internal/engine/history/Normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/errors.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace CGAL::Intrinsic_triangulations::internal {

std::array<Triangle_piece, 3> Normal_coordinates::names(const Delta_complex& complex, const Triangle_piece& piece) const
{
  const Halfedge_index ij = piece.side, jk = complex.next(ij), ki = complex.prev(ij);
  const std::int64_t n_ij = number_of_crossings(complex.edge(ij)), n_ki = number_of_crossings(complex.edge(ki));
  const Triangle_crossings t = triangle_crossings(complex, ij);
  if (piece.gap < t.c_i) // around i
    return {piece, {ki, n_ki - piece.gap}, {}};
  if (piece.gap > n_ij - t.c_j) // around j
    return {piece, {jk, n_ij - piece.gap}, {}};
  if (t.e_i > 0) // in the middle, beside the first segment that leaves i
    return {piece, {jk, t.c_j}, {}};
  if (t.e_j > 0) // the last one that leaves j
    return {piece, {ki, t.c_k + t.e_j}, {}};
  // In the middle, between segments that leave k or beyond all of them.
  std::array<Triangle_piece, 3> result{piece, {}, {}};
  if (piece.gap == t.c_i + t.e_k)
    result[1] = {jk, t.c_j};
  if (piece.gap == t.c_i)
    result[2] = {ki, t.c_k};
  return result;
}

void Normal_coordinates::split_face(const Delta_complex& complex, const Triangle_piece& piece)
{
  const Halfedge_index ij = piece.side, jk = complex.next(ij), ki = complex.prev(ij);
  const Triangle_crossings t = triangle_crossings(complex, ij);
  const std::int64_t n_ij = number_of_crossings(complex.edge(ij)), from_j = n_ij - piece.gap;
  Roundabout r_i = first_after(ij), r_j = first_after(jk), r_k = first_after(ki);
  std::int64_t n_vi, n_vj, n_vk;
  if (piece.gap < t.c_i) {
    n_vi = piece.gap;
    n_vj = t.c_i - piece.gap + t.c_j + t.e_k;
    n_vk = t.c_i - piece.gap + t.c_k + t.e_j;
    r_j.steps += std::uint64_t(t.e_j); // those that leave j come before the new edge
  } else if (from_j < t.c_j) {
    n_vj = from_j;
    n_vi = t.c_j - from_j + t.c_i + t.e_k;
    n_vk = t.c_j - from_j + t.c_k + t.e_i;
    r_k.steps += std::uint64_t(t.e_k);
  } else { // in the middle, with the segments that leave a corner to one side or the other
    const std::int64_t before = piece.gap - t.c_i;
    n_vi = t.c_i + before;
    n_vj = t.c_j + t.e_k - before;
    n_vk = t.c_k + t.e_i + t.e_j;
    r_j.steps += std::uint64_t(t.e_j);
    r_k.steps += std::uint64_t(before);
  }
  if ((std::max)((std::max)(n_vi, n_vj), n_vk) > largest_count)
    throw Integer_overflow_error("an edge crosses more than 2^60 input edges");
  make_room(3);
  append({n_vi, {no_halfedge, r_i.base.idx()}, {0, r_i.steps}});
  append({n_vj, {no_halfedge, r_j.base.idx()}, {0, r_j.steps}});
  append({n_vk, {no_halfedge, r_k.base.idx()}, {0, r_k.steps}});
}

void Normal_coordinates::split_edge(const Delta_complex& complex, Halfedge_index h, Halfedge_index along)
{
  CGAL_precondition(is_original(complex.edge(h)));
  make_room(4); // at most three edges, and a record for the one that is split
  const Halfedge_index g = complex.opposite(h), back(along.idx() ^ 1);
  const Roundabout at_i = roundabout(h), at_j = roundabout(g);
  const auto append_spoke = [&](Halfedge_index side, Halfedge_index first_from_v) {
    if (complex.is_border(side))
      return;
    const Triangle_crossings t = triangle_crossings(complex, side);
    const Roundabout r = first_after(complex.prev(side));
    append({t.c_k + t.e_i + t.e_j, {first_from_v.idx(), r.base.idx()}, {0, r.steps}});
  };
  append({-1, {along.idx(), at_j.base.idx()}, {0, at_j.steps}});
  append_spoke(h, back);
  append_spoke(g, along);
  Record part{-1, {}, {}};
  part.base[h.idx() & 1] = at_i.base.idx();
  part.steps[h.idx() & 1] = at_i.steps;
  part.base[g.idx() & 1] = back.idx();
  set_record(h, part);
}

void Normal_coordinates::unsplit_edge(const Delta_complex& complex, Halfedge_index h, bool is_on_input_edge)
{
  const Halfedge_index g = complex.opposite(h), jv = complex.opposite(complex.continuation(h));
  const Record &near = record(complex.edge(h)), &far = record(complex.edge(jv));
  Record joined = near;
  if (near.crossings >= 0)
    joined.crossings = near.crossings + far.crossings + (is_on_input_edge ? 1 : 0);
  if (joined.crossings > largest_count)
    throw Integer_overflow_error("an edge crosses more than 2^60 input edges");
  joined.base[g.idx() & 1] = far.base[jv.idx() & 1];
  joined.steps[g.idx() & 1] = far.steps[jv.idx() & 1];
  set_record(h, joined);
}

void Normal_coordinates::remove(const Removed_elements& removed)
{
  // A moved edge was never an input edge: as many edges as the input has stay, and all others have records.
  for (Edge_index e : removed.edges) {
    const std::uint32_t i = record_of_[e.idx()];
    records_[i].crossings = first_free_record_;
    first_free_record_ = i;
  }
  remove_entries(record_of_, removed.edges);
}

} // namespace CGAL::Intrinsic_triangulations::internal
