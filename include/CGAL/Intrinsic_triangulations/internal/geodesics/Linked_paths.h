// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Paths and closed curves as linked lists of halfedges, parts of which are replaced by others.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_LINKED_PATHS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_LINKED_PATHS_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Index.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// An exception leaves everything unchanged.
class Linked_paths
{
public:
  using Segment_index = std::uint32_t;
  static constexpr Segment_index none = (std::numeric_limits<Segment_index>::max)();

  struct Segment
  {
    Halfedge_index halfedge;
    Segment_index prev, next; // around and around in a closed path
    std::uint32_t path;
    bool is_alive;
    // Whether the angles to the right and to the left of its end are known not to be below π; maintained by the caller
    std::array<bool, 2> is_straight{};
  };
  struct Replaced
  {
    Segment_index before;      // the segment before the new ones, if there is one
    Segment_index first, last; // the new ones, if there are any
  };

  explicit Linked_paths(const Delta_complex& complex) : complex_(complex), number_of_uses_(complex.number_of_edges(), 0)
  {}

  std::size_t size() const { return paths_.size(); }
  bool is_closed(std::size_t p) const { return paths_[p].is_closed; }
  // The first segment of a path; `none` after a curve has shrunk to a point.
  Segment_index first(std::size_t p) const { return paths_[p].first; }
  const Segment& operator[](Segment_index s) const { return segments_[s]; }
  // The next segment; `none` after the last one, even in a closed path.
  Segment_index following(Segment_index s) const
  {
    const Segment_index next = segments_[s].next;
    return next == paths_[segments_[s].path].first ? none : next;
  }
  std::array<bool, 2>& is_straight(Segment_index s) { return segments_[s].is_straight; }

  bool are_consecutive(Segment_index a, Segment_index b) const
  {
    return segments_[a].is_alive && segments_[b].is_alive && segments_[a].next == b;
  }
  bool is_used(Edge_index e) const { return number_of_uses_[e.idx()] != 0; }

  std::vector<Halfedge_index> halfedges(std::size_t p) const;

  // Returns the number of the new path.
  std::size_t add(const std::vector<Halfedge_index>& halfedges, bool is_closed);

  // Removes all paths. Never throws.
  void clear();

  // Replaces two consecutive segments, or a loop if they are the same.
  Replaced replace(Segment_index a, Segment_index b, const std::vector<Halfedge_index>& halfedges);

  // A segment that was removed no longer uses its edge, but can be revived.
  void remove(Segment_index s);
  void revive(Segment_index s);

  // Makes a closed path a loop of one segment again, as it was, with a halfedge of the same edge.
  void restore_loop(Segment_index s, Halfedge_index loop);

private:
  struct Path
  {
    Segment_index first;
    bool is_closed;
  };

  void check(const std::vector<Halfedge_index>& halfedges, bool is_closed) const;

  // Links new segments, for which there is room, between two others; in a closed path without others, into a circle.
  Replaced link(std::uint32_t p, Segment_index before, Segment_index after,
                const std::vector<Halfedge_index>& halfedges);

  const Delta_complex& complex_;
  std::vector<std::uint32_t> number_of_uses_; // for each edge
  std::vector<Segment> segments_;             // including earlier ones
  std::vector<Path> paths_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_LINKED_PATHS_H
