// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// An overlay graph in which segments and crossings come and go.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OVERLAY_DYNAMIC_OVERLAY_GRAPH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OVERLAY_DYNAMIC_OVERLAY_GRAPH_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/internal/config.h>

#include <CGAL/assertions.h>

#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Halfedges 2s and 2s + 1 belong to segment s. What is removed goes on a free list and is
// used again. The vertices of the surface come before the crossings.
class Dynamic_overlay_graph
{
public:
  using size_type = std::uint32_t;
  using Vertex = Overlay::Vertex;
  using Halfedge = Overlay::Halfedge;
  using Segment = Overlay::Segment;

  // The graph of a triangulation over itself.
  explicit Dynamic_overlay_graph(const Delta_complex& input);

  size_type number_of_crossings() const
  {
    return end_of_vertices_ - number_of_original_vertices_ - size_type(free_crossings_.size());
  }
  size_type number_of_segments() const { return size_type(segments_.size() - free_segments_.size()); }
  // All halfedges have smaller numbers, those in use and those that are free.
  size_type end_of_halfedges() const { return size_type(halfedges_.size()); }
  size_type end_of_vertices() const { return end_of_vertices_; }

  Halfedge opposite(Halfedge h) const { return Halfedge(h.idx() ^ 1); }
  Halfedge next(Halfedge h) const { return halfedges_[h.idx()].next; }
  Halfedge prev(Halfedge h) const { return halfedges_[h.idx()].prev; }
  Vertex target(Halfedge h) const { return halfedges_[h.idx()].target; }
  Vertex source(Halfedge h) const { return target(opposite(h)); }
  bool is_crossing(Vertex v) const { return v.idx() >= number_of_original_vertices_; }
  // The part behind the crossing in which h ends, of the same edge: left, and left again.
  Halfedge straight_on(Halfedge h) const
  {
    CGAL_precondition(is_crossing(target(h)));
    return next(opposite(next(h)));
  }
  // The halfedges of the two triangulations that h is part of, or null.
  Halfedge_index intrinsic_halfedge(Halfedge h) const { return directed(segment(h).intrinsic, h); }
  Halfedge_index input_halfedge(Halfedge h) const { return directed(segment(h).input, h); }
  bool is_in_use(Halfedge h) const { return segment(h).intrinsic.is_valid() || segment(h).input.is_valid(); }

  // The parts with which a halfedge of a triangulation begins and ends.
  Halfedge first_part(Halfedge_index h) const { return first_intrinsic_parts_[h.idx()]; }
  Halfedge last_part(Halfedge_index h) const { return opposite(first_intrinsic_parts_[h.idx() ^ 1]); }
  Halfedge first_part_in_input(Halfedge_index h) const { return first_input_parts_[h.idx()]; }

  void set_first_part(Halfedge_index h, Halfedge part) { first_intrinsic_parts_[h.idx()] = part; }

  // Lets `part` be, or no longer be, part of an intrinsic halfedge, too.
  void set_intrinsic_halfedge(Halfedge part, Halfedge_index h)
  {
    segments_[part.idx() >> 1].intrinsic = directed(h, part);
  }

  // Adds a part of an intrinsic halfedge, through one face: from its corner behind `before` to
  // that behind `arriving`.
  Halfedge add_intrinsic_part(Halfedge_index h, Halfedge before, Halfedge arriving);

  // Takes a segment out.
  // \pre something else is left at both ends
  void remove(Halfedge h);

  // Cuts the part h of an input edge in two at a new crossing, the target of h afterwards.
  void split(Halfedge h);

  // Joins the part h of an input edge with the next one.
  // \pre nothing else is left at the crossing in which h ends
  void join(Halfedge h);

private:
  struct Halfedge_record
  {
    Halfedge next, prev;
    Vertex target;
  };
  struct Segment_record
  {
    Halfedge_index intrinsic, input; // that 2s is part of; both null if the segment is free
  };

  const Segment_record& segment(Halfedge h) const { return segments_[h.idx() >> 1]; }

  // What h is part of if 2s is part of `of_first`, and the other way round.
  static Halfedge_index directed(Halfedge_index of_first, Halfedge h)
  {
    return of_first.is_valid() ? Halfedge_index(of_first.idx() ^ (h.idx() & 1)) : of_first;
  }

  void link(Halfedge h, Halfedge next)
  {
    halfedges_[h.idx()].next = next;
    halfedges_[next.idx()].prev = h;
  }

  Vertex new_crossing();

  Halfedge new_segment(Vertex source, Vertex target);

  void release(Halfedge h);

  size_type number_of_original_vertices_;
  size_type end_of_vertices_;
  std::vector<Halfedge_record> halfedges_;
  std::vector<Segment_record> segments_;
  std::vector<Vertex> free_crossings_;
  std::vector<Segment> free_segments_;
  std::vector<Halfedge> first_intrinsic_parts_; // out of the source of each halfedge
  std::vector<Halfedge> first_input_parts_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/internal/overlay/Dynamic_overlay_graph_impl.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OVERLAY_DYNAMIC_OVERLAY_GRAPH_H
