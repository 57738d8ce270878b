// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Dynamic_overlay_graph.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OVERLAY_DYNAMIC_OVERLAY_GRAPH_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OVERLAY_DYNAMIC_OVERLAY_GRAPH_IMPL_H

#include <CGAL/Intrinsic_triangulations/internal/config.h>
#include <CGAL/Intrinsic_triangulations/errors.h>

#include <CGAL/assertions.h>

#include <cstddef>

namespace CGAL::Intrinsic_triangulations::internal {

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Dynamic_overlay_graph::Dynamic_overlay_graph(const Delta_complex& input)
  : number_of_original_vertices_(input.number_of_vertices()), end_of_vertices_(input.number_of_vertices())
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

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Dynamic_overlay_graph::Halfedge
Dynamic_overlay_graph::add_intrinsic_part(Halfedge_index h, Halfedge before, Halfedge arriving)
{
  const Halfedge part = new_segment(target(before), target(arriving));
  segments_[part.idx() >> 1] = {h, Halfedge_index()};
  const Halfedge after = next(before), leaving = next(arriving);
  link(before, part);
  link(part, leaving);
  link(arriving, opposite(part));
  link(opposite(part), after);
  return part;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE void Dynamic_overlay_graph::remove(Halfedge h)
{
  const Halfedge g = opposite(h);
  CGAL_precondition(next(h) != g && next(g) != h);
  link(prev(h), next(g));
  link(prev(g), next(h));
  release(h);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE void Dynamic_overlay_graph::split(Halfedge h)
{
  const Halfedge g = opposite(h), after = next(h), before = prev(g);
  CGAL_precondition(after != g);
  const Vertex end = target(h), crossing = new_crossing();
  const Halfedge rest = new_segment(crossing, end);
  segments_[rest.idx() >> 1].input = input_halfedge(h);
  halfedges_[h.idx()].target = crossing;
  link(h, rest);
  link(rest, after);
  link(before, opposite(rest));
  link(opposite(rest), g);
  if (!is_crossing(end))
    first_input_parts_[input_halfedge(g).idx()] = opposite(rest);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE void Dynamic_overlay_graph::join(Halfedge h)
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

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Dynamic_overlay_graph::Vertex Dynamic_overlay_graph::new_crossing()
{
  if (free_crossings_.empty())
    return Vertex(end_of_vertices_++); // there are fewer vertices than halfedges
  const Vertex v = free_crossings_.back();
  free_crossings_.pop_back();
  return v;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Dynamic_overlay_graph::Halfedge Dynamic_overlay_graph::new_segment(Vertex source,
                                                                                                        Vertex target)
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

CGAL_INTRINSIC_TRIANGULATIONS_INLINE void Dynamic_overlay_graph::release(Halfedge h)
{
  segments_[h.idx() >> 1] = Segment_record();
  free_segments_.push_back(Segment(h.idx() >> 1));
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OVERLAY_DYNAMIC_OVERLAY_GRAPH_IMPL_H
