// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Paths and closed curves as linked lists of halfedges, parts of which are replaced by others.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_LINKED_PATHS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_LINKED_PATHS_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/Index.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Large_vector.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
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
  // The first segment of a path: none after a curve was shrunk to a point.
  Segment_index first(std::size_t p) const { return paths_[p].first; }
  const Segment& operator[](Segment_index s) const { return segments_[s]; }
  // The next segment; none after the last one, also in a closed path.
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

  std::vector<Halfedge_index> halfedges(std::size_t p) const
  {
    std::vector<Halfedge_index> result;
    for (Segment_index s = first(p); s != none; s = following(s))
      result.push_back(segments_[s].halfedge);
    return result;
  }

  // Returns the number of the new path.
  std::size_t add(const std::vector<Halfedge_index>& halfedges, bool is_closed)
  {
    check(halfedges, is_closed);
    make_room(segments_, halfedges.size());
    paths_.push_back({none, is_closed});
    link(std::uint32_t(paths_.size() - 1), none, none, halfedges);
    return paths_.size() - 1;
  }

  // Removes all paths. Never throws.
  void clear()
  {
    for (const Segment& segment : segments_)
      if (segment.is_alive)
        --number_of_uses_[complex_.edge(segment.halfedge).idx()];
    segments_.clear();
    paths_.clear();
  }

  // Replaces two consecutive segments, or a loop if they are the same.
  Replaced replace(Segment_index a, Segment_index b, const std::vector<Halfedge_index>& halfedges)
  {
    make_room(segments_, halfedges.size());
    const std::uint32_t p = segments_[a].path;
    Segment_index before = segments_[a].prev, after = segments_[b].next;
    remove(a);
    if (a != b)
      remove(b);
    if (paths_[p].is_closed) {
      if (before == a || before == b) // nothing is left
        before = after = none;
      paths_[p].first = before;
    }
    return link(p, before, after, halfedges);
  }

  // A segment that was removed no longer uses its edge, but can be revived.
  void remove(Segment_index s)
  {
    segments_[s].is_alive = false;
    --number_of_uses_[complex_.edge(segments_[s].halfedge).idx()];
  }
  void revive(Segment_index s)
  {
    segments_[s].is_alive = true;
    ++number_of_uses_[complex_.edge(segments_[s].halfedge).idx()];
  }

  // Makes a closed path a loop of one segment again, as it was, with a halfedge of the same edge.
  void restore_loop(Segment_index s, Halfedge_index loop)
  {
    Path& path = paths_[segments_[s].path];
    if (path.first != s)
      for (Segment_index i = path.first; i != none && segments_[i].is_alive; i = segments_[i].next)
        remove(i);
    if (!segments_[s].is_alive)
      revive(s);
    segments_[s] = {loop, s, s, segments_[s].path, true, {}};
    path.first = s;
  }

private:
  struct Path
  {
    Segment_index first;
    bool is_closed;
  };

  void check(const std::vector<Halfedge_index>& halfedges, bool is_closed) const
  {
    for (std::size_t i = 0; i < halfedges.size(); ++i) {
      if (!(halfedges[i].idx() < complex_.number_of_halfedges()))
        throw Invalid_argument_error("there is no halfedge " + std::to_string(halfedges[i].idx()));
      const bool is_last = i + 1 == halfedges.size();
      if (is_last && !is_closed)
        break;
      const Halfedge_index following = halfedges[is_last ? 0 : i + 1];
      if (following.idx() < complex_.number_of_halfedges() &&
          complex_.source(following) != complex_.target(halfedges[i]))
        throw Invalid_argument_error("halfedge " + std::to_string(following.idx()) + " does not begin at vertex " +
                                     std::to_string(complex_.target(halfedges[i]).idx()) + ", where halfedge " +
                                     std::to_string(halfedges[i].idx()) + " before it ends");
    }
    if (is_closed && halfedges.empty())
      throw Invalid_argument_error("a closed curve without edges");
  }

  // Links new segments, for which there is room, between two others; in a closed path without others, into a circle.
  Replaced link(std::uint32_t p, Segment_index before, Segment_index after,
                const std::vector<Halfedge_index>& halfedges)
  {
    Segment_index first = none, last = before;
    for (Halfedge_index h : halfedges) {
      const Segment_index s = Segment_index(segments_.size());
      segments_.push_back({h, last, none, p, true, {}});
      ++number_of_uses_[complex_.edge(h).idx()];
      if (last != none)
        segments_[last].next = s;
      if (first == none)
        first = s;
      last = s;
    }
    if (paths_[p].is_closed && before == none && first != none) {
      segments_[first].prev = last;
      segments_[last].next = first;
    } else {
      if (last != none)
        segments_[last].next = after;
      if (after != none)
        segments_[after].prev = last;
    }
    if (before == none)
      paths_[p].first = first != none ? first : after;
    return {first != none ? segments_[first].prev : before, first, last};
  }

  const Delta_complex& complex_;
  std::vector<std::uint32_t> number_of_uses_; // of each edge
  std::vector<Segment> segments_;             // including earlier ones
  std::vector<Path> paths_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_LINKED_PATHS_H
