// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The overlay of the input triangulation and the intrinsic one, updated with each flip.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INCREMENTAL_OVERLAY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INCREMENTAL_OVERLAY_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/observer.h>

#include <CGAL/assertions.h>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

namespace internal {
class Incremental_overlay_check;
}

/// \ingroup PkgIntrinsicTriangulationsOverlay
///
/// \brief the overlay of an input triangulation and an intrinsic one, updated flip by flip.
///
/// It is the same graph as `Overlay`, updated as in the paper: a flip removes the edge,
/// merges the input segments at its crossings, and decides from the cyclic order along the sides of
/// the quadrilateral alone which segments the other diagonal crosses. It uses neither lengths nor
/// normal coordinates, so the two methods are independent of each other.
/// `Overlay` is cheaper, since most intermediate crossings later disappear. Use this class
/// if you need the overlay after every flip.
///
/// It follows flips, but not the insertion and removal of vertices. After these, construct it again from the
/// connectivity of the triangulation, which is then its `input()`. `Overlay` relates inserted vertices to the first
/// input.
///
/// Memory: 32 bytes a segment, and two `Delta_complex`.
///
/// As a visitor, pass it by `std::ref(overlay)`.
///
/// \cgalModels{IntrinsicTriangulationVisitor}
///
/// Source: Fisher, Springborn, Schroeder, Bobenko (2006), section 2.3 and figure 5.
class Incremental_overlay
{
public:
  /// the type of counts
  using size_type = std::uint32_t;
  /// a vertex of the surface or a crossing
  using Vertex = Overlay::Vertex;
  /// one of the two directions of a segment
  using Halfedge = Overlay::Halfedge;

  /// constructs the overlay of a triangulation and itself: every segment has the label `BOTH`.
  explicit Incremental_overlay(const Delta_complex& input);

  /// \brief flips intrinsic edge `e`, as `Delta_complex::flip()` does.
  ///
  /// O(number of crossings removed and inserted, plus number of input segments that the flip
  /// changes). Segments and crossings that are not affected keep their descriptors; those of
  /// removed ones are reused.
  /// \pre `intrinsic().is_flippable(e)`
  /// \exception Integer_overflow_error if there are 2^31 segments or more; the overlay is then unusable
  void flip(Edge_index e);

  /// \name Visitor
  /// @{
  /// never stops the flips.
  bool go_further(const Progress&) const { return true; }
  /// performs the same flip in the overlay.
  void after_flip(Edge_index e) { flip(e); }
  /// @}

  /// returns the input triangulation.
  const Delta_complex& input() const { return input_; }
  /// returns the current intrinsic triangulation.
  const Delta_complex& intrinsic() const { return intrinsic_; }
  /// returns the number of crossings.
  size_type number_of_crossings() const
  {
    return end_of_crossings_ - number_of_vertices_ - size_type(free_crossings_.size());
  }
  /// returns the number of segments.
  size_type number_of_segments() const { return size_type(segments_.size() - free_segments_.size()); }

  /// \name Along an edge
  /// @{

  /// returns the first part of a halfedge of the intrinsic triangulation, out of its source.
  Halfedge first_part(Halfedge_index h) const { return first_intrinsic_parts_[h.idx()]; }
  /// returns the first part of a halfedge of the input.
  Halfedge first_part_in_input(Halfedge_index h) const { return first_input_parts_[h.idx()]; }
  /// returns the other halfedge of the segment of `h`.
  Halfedge opposite(Halfedge h) const { return Halfedge(h.idx() ^ 1); }
  /// returns the halfedge after `h` around its face; at a crossing it turns left.
  Halfedge next(Halfedge h) const { return halfedges_[h.idx()].next; }
  /// returns the vertex or crossing that `h` points to; the vertices of the surface come before
  /// the crossings.
  Vertex target(Halfedge h) const { return halfedges_[h.idx()].target; }
  /// returns whether `v` is a crossing, not a vertex of the surface.
  bool is_crossing(Vertex v) const { return v.idx() >= number_of_vertices_; }
  /// returns the part that follows `h` in the same edge. \pre `is_crossing(target(h))`
  Halfedge straight_on(Halfedge h) const
  {
    CGAL_precondition(is_crossing(target(h)));
    return next(opposite(next(h))); // left, and left again
  }
  /// returns which of the triangulations `h` is part of.
  Segment_label label(Halfedge h) const
  {
    if (!intrinsic_halfedge(h).is_valid())
      return Segment_label::INPUT;
    return input_halfedge(h).is_valid() ? Segment_label::BOTH : Segment_label::INTRINSIC;
  }
  /// returns the halfedge of the intrinsic triangulation that contains `h`, with the same direction;
  /// the null descriptor if the label is `INPUT`.
  Halfedge_index intrinsic_halfedge(Halfedge h) const { return directed(segment(h).intrinsic, h); }
  /// returns the halfedge of the input that contains `h`, with the same direction; the null
  /// descriptor if the label is `INTRINSIC`.
  Halfedge_index input_halfedge(Halfedge h) const { return directed(segment(h).input, h); }

  /// returns the input halfedges that cross intrinsic halfedge `h` from right to left, in order.
  std::vector<Halfedge_index> crossing_input_halfedges(Halfedge_index h) const;
  /// returns the intrinsic halfedges that cross input halfedge `h` from right to left, in order.
  std::vector<Halfedge_index> crossing_intrinsic_halfedges(Halfedge_index h) const;
  /// @}

private:
  /// \cond SKIP_IN_MANUAL
  friend class internal::Incremental_overlay_check; // of the tests
  /// \endcond

  // Halfedges 2s and 2s + 1 belong to segment s. Removed elements go on a free list and are reused. The vertices of the
  // surface come before the crossings.
  using Segment = Overlay::Segment;
  struct Halfedge_record
  {
    Halfedge next, prev;
    Vertex target;
  };
  struct Segment_record
  {
    Halfedge_index intrinsic, input; // that 2s is part of; both null if the segment is free
  };
  enum class Side : std::uint8_t {
    NONE,
    LEFT,
    RIGHT
  };

  Halfedge prev(Halfedge h) const { return halfedges_[h.idx()].prev; }
  Vertex source(Halfedge h) const { return target(opposite(h)); }
  Halfedge last_part(Halfedge_index h) const { return opposite(first_intrinsic_parts_[h.idx() ^ 1]); }

  const Segment_record& segment(Halfedge h) const { return segments_[h.idx() >> 1]; }
  Segment_record& segment(Halfedge h) { return segments_[h.idx() >> 1]; }
  bool is_in_use(Halfedge h) const { return segment(h).intrinsic.is_valid() || segment(h).input.is_valid(); }
  // The halfedge that h is part of, if 2s is part of `of_first`; and vice versa.
  static Halfedge_index directed(Halfedge_index of_first, Halfedge h)
  {
    return of_first.is_valid() ? Halfedge_index(of_first.idx() ^ (h.idx() & 1)) : of_first;
  }

  // Removes intrinsic edge ij, and merges the segments that it crossed.
  void take_out(Halfedge_index ij);

  // Makes ij, which was removed, the other diagonal of its quadrilateral i, l, j, k, from l to k. The quadrilateral now
  // contains only parts of input edges, called chords: straight lines that do not meet.
  void put_diagonal(Halfedge_index ij);

  // Draws the diagonal from l to k through the chords that it crosses.
  void cross_chords(Halfedge_index ij, Halfedge before_l, Halfedge before_k);

  bool is_chord(Halfedge h) const { return label(h) == Segment_label::INPUT; }

  // Collects the chords that leave two consecutive sides of the quadrilateral, including their common corner but not
  // the two other ends.
  void note_chords(std::vector<Halfedge>& chords, Halfedge_index first, Halfedge_index second, Side side);

  // Among the halfedges that point to the end of a side, the one whose next halfedge is beyond the diagonal: chords to
  // that side come before it.
  Halfedge before_diagonal(Halfedge_index arriving, Side side) const;

  void link(Halfedge h, Halfedge next);

  // Adds a part of an intrinsic halfedge through one face, from the corner after `before` to the corner after
  // `arriving`.
  Halfedge add_intrinsic_part(Halfedge_index h, Halfedge before, Halfedge arriving);

  // Removes a segment. \pre other segments are left at both ends
  void remove(Halfedge h);

  // Cuts the part h of an input edge in two at a new crossing, the target of h afterwards.
  void split(Halfedge h);

  // Joins the part h of an input edge with the next one. \pre no other segment is left at the crossing where h ends
  void join(Halfedge h);

  Vertex new_crossing();
  Halfedge new_segment(Vertex source, Vertex target);
  void release(Halfedge h);

  Delta_complex input_;
  Delta_complex intrinsic_;

  size_type number_of_vertices_; // of the surface
  size_type end_of_crossings_;
  std::vector<Halfedge_record> halfedges_;
  std::vector<Segment_record> segments_;
  std::vector<Vertex> free_crossings_;
  std::vector<Segment> free_segments_;
  std::vector<Halfedge> first_intrinsic_parts_; // out of the source of each halfedge
  std::vector<Halfedge> first_input_parts_;

  // Used only during a flip.
  std::vector<Halfedge> parts_, crossed_, right_chords_, left_chords_;
  std::vector<Side> sides_; // of the sources of chords
};

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INCREMENTAL_OVERLAY_H
