// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Adding, replacing and removing the segments of paths.

#include <CGAL/Intrinsic_triangulations/internal/geodesics/Linked_paths.h>
#include <CGAL/Intrinsic_triangulations/Large_vector.h>
#include <CGAL/Intrinsic_triangulations/errors.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

std::vector<Halfedge_index> Linked_paths::halfedges(std::size_t p) const
{
  std::vector<Halfedge_index> result;
  for (Segment_index s = first(p); s != none; s = following(s))
    result.push_back(segments_[s].halfedge);
  return result;
}

std::size_t Linked_paths::add(const std::vector<Halfedge_index>& halfedges, bool is_closed)
{
  check(halfedges, is_closed);
  make_room(segments_, halfedges.size());
  paths_.push_back({none, is_closed});
  link(std::uint32_t(paths_.size() - 1), none, none, halfedges);
  return paths_.size() - 1;
}

void Linked_paths::clear()
{
  for (const Segment& segment : segments_)
    if (segment.is_alive)
      --number_of_uses_[complex_.edge(segment.halfedge).idx()];
  segments_.clear();
  paths_.clear();
}

Linked_paths::Replaced Linked_paths::replace(Segment_index a, Segment_index b,
                                             const std::vector<Halfedge_index>& halfedges)
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

void Linked_paths::remove(Segment_index s)
{
  segments_[s].is_alive = false;
  --number_of_uses_[complex_.edge(segments_[s].halfedge).idx()];
}

void Linked_paths::revive(Segment_index s)
{
  segments_[s].is_alive = true;
  ++number_of_uses_[complex_.edge(segments_[s].halfedge).idx()];
}

void Linked_paths::restore_loop(Segment_index s, Halfedge_index loop)
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

void Linked_paths::check(const std::vector<Halfedge_index>& halfedges, bool is_closed) const
{
  for (std::size_t i = 0; i < halfedges.size(); ++i) {
    if (!(halfedges[i].idx() < complex_.number_of_halfedges()))
      throw Invalid_argument_error("there is no halfedge " + std::to_string(halfedges[i].idx()));
    const bool is_last = i + 1 == halfedges.size();
    if (is_last && !is_closed)
      break;
    const Halfedge_index following = halfedges[is_last ? 0 : i + 1];
    if (following.idx() < complex_.number_of_halfedges() && complex_.source(following) != complex_.target(halfedges[i]))
      throw Invalid_argument_error("halfedge " + std::to_string(following.idx()) + " does not begin at vertex " +
                                   std::to_string(complex_.target(halfedges[i]).idx()) + ", where halfedge " +
                                   std::to_string(halfedges[i].idx()) + " before it ends");
  }
  if (is_closed && halfedges.empty())
    throw Invalid_argument_error("a closed curve without edges");
}

Linked_paths::Replaced Linked_paths::link(std::uint32_t p, Segment_index before, Segment_index after,
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

} // namespace CGAL::Intrinsic_triangulations::internal
