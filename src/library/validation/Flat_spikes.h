// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Removes vertices that leave no room for triangles: those whose angles are all zero, and those that faces without area
// unite.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_FLAT_SPIKES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_FLAT_SPIKES_H

#include "../gluing/Sides_by_edge.h"
#include <CGAL/Intrinsic_triangulations/internal/measures/are_collinear.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Disjoint_sets.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// A part without any area is left as it is. In other parts:
//
// - A vertex that is not on the border, all of whose faces have no area, and at which their angles are zero, is the tip
//   of a spike. It becomes one with its nearest neighbor, which lies on all its edges: only the tip changes.
// - Vertices at the same place become one if they lie on the longest side of two faces without area that meet there.
// - Faces that lose a corner vanish, and so do two without area that come to have the same corners.
class Flat_spikes
{
  using Index = std::uint32_t;
  using Place = std::array<double, 3>;

public:
  // \param triangles are changed: those that vanish have equal corners
  Flat_spikes(const std::vector<Place>& points, std::vector<Index_triangle>& triangles)
    : points_(points), triangles_(triangles), is_changed_(triangles.size(), false)
  {
    for (Index f = 0; f < triangles_.size(); ++f)
      if (is_flat(f))
        flat_.push_back(f);
    if (flat_.empty())
      return;
    leave_parts_without_area();
    while (!flat_.empty() && (merge_coincident() || take_tips())) {
    }
  }

  // The removed tips, and the vertices that were merged with another one at the same place.
  const std::vector<Index>& tips() const { return tips_; }
  const std::vector<std::pair<Index, Index>>& merged() const { return merged_; }

private:
  bool has_vanished(Index f) const
  {
    const auto& [a, b, c] = triangles_[f];
    return a == b || b == c || c == a;
  }
  bool is_flat(Index f) const
  {
    const auto& [a, b, c] = triangles_[f];
    return are_collinear(points_[a], points_[b], points_[c]);
  }

  // On a line, points are in the order of their coordinates.
  bool is_between(Index v, Index w, Index x) const { return (points_[w] < points_[v]) != (points_[x] < points_[v]); }

  template <class Condition>
  void keep_flat(const Condition& is_kept)
  {
    flat_.erase(std::remove_if(flat_.begin(), flat_.end(), [&](Index f) { return !is_kept(f); }), flat_.end());
  }

  void leave_parts_without_area()
  {
    Disjoint_sets parts(points_.size());
    for (const auto& [a, b, c] : triangles_) {
      parts.unite(a, b);
      parts.unite(b, c);
    }
    std::vector<bool> has_area(points_.size(), false);
    auto next = flat_.begin();
    for (Index f = 0; f < triangles_.size(); ++f) {
      if (next != flat_.end() && *next == f)
        ++next;
      else
        has_area[parts.find(triangles_[f][0])] = true;
    }
    keep_flat([&](Index f) { return bool(has_area[parts.find(triangles_[f][0])]); });
  }

  // Replaces each vertex by the last one of the chain to[vertex], to[to[vertex]], ….
  void replace(const std::map<Index, Index>& to)
  {
    for (Index f = 0; f < triangles_.size(); ++f)
      for (Index& v : triangles_[f])
        for (auto it = to.find(v); it != to.end(); it = to.find(v)) {
          v = it->second;
          is_changed_[f] = true;
        }
    keep_flat([&](Index f) { return !has_vanished(f); });
    drop_pairs();
  }

  // Merges vertices across the common longest side of two faces, unless faces with area would come to have the same
  // corners.
  bool merge_coincident()
  {
    std::map<std::pair<Index, Index>, Index> middle; // of longest sides
    std::map<Index, Index> to;
    for (Index f : flat_)
      for (std::size_t i = 0; i < 3; ++i) {
        const Index v = triangles_[f][i], w = triangles_[f][(i + 1) % 3], x = triangles_[f][(i + 2) % 3];
        if (!is_between(v, w, x))
          continue;
        const auto [it, is_new] = middle.emplace(std::minmax(w, x), v);
        const Index u = it->second;
        if (!is_new && u != v && points_[u] == points_[v] && to.count(u) == 0 && to.count(v) == 0)
          to.emplace((std::max)(u, v), (std::min)(u, v));
      }
    if (to.empty())
      return false;
    std::set<Index> targets;
    for (const auto& [v, w] : to)
      targets.insert(w);
    std::map<Index_triangle, Index> becomes; // of faces with an area at these vertices
    for (Index f = 0; f < triangles_.size(); ++f) {
      Index_triangle t = triangles_[f];
      for (Index& v : t)
        if (const auto it = to.find(v); it != to.end())
          v = it->second;
      const bool is_near = std::any_of(t.begin(), t.end(), [&](Index v) { return targets.count(v) != 0; });
      if (!is_near || has_vanished(f) || is_flat(f))
        continue;
      std::sort(t.begin(), t.end());
      if (const auto [it, is_new] = becomes.emplace(t, f); !is_new)
        for (Index g : {f, it->second})
          for (Index v : triangles_[g])
            to.erase(v);
    }
    merged_.insert(merged_.end(), to.begin(), to.end());
    if (!to.empty())
      replace(to);
    return !to.empty();
  }

  bool take_tips()
  {
    std::vector<unsigned char> is_tip(points_.size(), 0);
    for (Index f : flat_)
      for (Index v : triangles_[f])
        is_tip[v] = 1;
    for (Index f = 0; f < triangles_.size(); ++f)
      if (!has_vanished(f) && !std::binary_search(flat_.begin(), flat_.end(), f))
        for (Index v : triangles_[f])
          is_tip[v] = 0;
    for (Index f : flat_)
      for (std::size_t i = 0; i < 3; ++i)
        if (is_between(triangles_[f][i], triangles_[f][(i + 1) % 3], triangles_[f][(i + 2) % 3]))
          is_tip[triangles_[f][i]] = 0;
    std::map<std::pair<Index, Index>, Index> number_of_faces;
    for (Index f : flat_)
      for (std::size_t i = 0; i < 3; ++i)
        ++number_of_faces[std::minmax(triangles_[f][i], triangles_[f][(i + 1) % 3])];
    for (const auto& [ends, n] : number_of_faces)
      if (n == 1)
        is_tip[ends.first] = is_tip[ends.second] = 0; // all faces of a tip are flat
    std::map<Index, Index> nearest;                   // neighbors of tips
    for (Index f : flat_)
      for (std::size_t i = 0; i < 3; ++i) {
        const Index v = triangles_[f][i];
        if (is_tip[v] == 0)
          continue;
        for (std::size_t k = 1; k < 3; ++k) {
          const Index w = triangles_[f][(i + k) % 3];
          const auto [it, is_new] = nearest.emplace(v, w);
          if (!are_in_one_direction(v, w, it->second))
            is_tip[v] = 0; // tips of two spikes
          if (!is_new &&
              (points_[it->second] < points_[v] ? points_[it->second] < points_[w] : points_[w] < points_[it->second]))
            it->second = w;
        }
      }
    // Two neighboring tips are removed one at a time.
    std::map<Index, Index> to;
    for (const auto& [v, w] : nearest)
      if (is_tip[v] == 1 && (is_tip[w] == 0 || (w > v && nearest[w] == v))) {
        to[v] = w;
        tips_.push_back(v);
      }
    if (!to.empty())
      replace(to);
    return !to.empty();
  }

  bool are_in_one_direction(Index v, Index w, Index x) const
  {
    return are_collinear(points_[v], points_[w], points_[x]) && (points_[w] < points_[v]) == (points_[x] < points_[v]);
  }

  void drop_pairs()
  {
    std::map<Index_triangle, Index> seen;
    for (Index f : flat_) {
      Index_triangle key = triangles_[f];
      std::sort(key.begin(), key.end());
      const auto [it, is_new] = seen.emplace(key, f);
      if (is_new || !(is_changed_[f] || is_changed_[it->second]))
        continue;
      for (Index g : {f, it->second})
        triangles_[g][1] = triangles_[g][0];
      seen.erase(it);
    }
    keep_flat([&](Index f) { return !has_vanished(f); });
  }

  const std::vector<Place>& points_;
  std::vector<Index_triangle>& triangles_;
  std::vector<bool> is_changed_; // of each triangle
  std::vector<Index> flat_;      // faces without area that are left, in increasing order
  std::vector<Index> tips_;
  std::vector<std::pair<Index, Index>> merged_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_FLAT_SPIKES_H
