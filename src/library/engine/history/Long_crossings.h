// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The crossings of all edges, found at once.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_HISTORY_LONG_CROSSINGS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_HISTORY_LONG_CROSSINGS_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Crossed_halfedges.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Input_edge_walk.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Kept_crossings.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The crossings of one edge are found by following the input edges that cross it until they part. For all edges
// together, it is faster to follow each input edge once from end to end. Input edges that leave a corner side by side
// stay together until they part, so large fans come first.
class Long_crossings
{
public:
  Long_crossings(const Delta_complex& complex, const Correspondence& correspondence, const Interruption& interruption)
    : complex_(complex), correspondence_(correspondence), coordinates_(correspondence.coordinates()),
      interruption_(interruption)
  {}

  // The number of crossings of all edges, or a number greater than the limit.
  std::size_t number() const
  {
    auto room = std::int64_t(Kept_crossings::largest_total);
    for (Edge_index e : complex_.edges()) {
      if (number_of_crossings(e) > room)
        return Kept_crossings::largest_total + 1;
      room -= number_of_crossings(e);
    }
    return Kept_crossings::largest_total - std::size_t(room);
  }

  // Caches the crossings of all edges, if one of them crosses many and there is room for all: edges of strongly twisted
  // surfaces may cross far more than could be followed. If memory is short, nothing is cached.
  void keep()
  {
    try {
      find_and_keep();
    } catch (const std::bad_alloc&) {
    }
  }

private:
  // Input halfedges side by side, which cross `across` to its right: number `first` of the fan after the given number
  // of crossings from the source, and so on.
  struct Block
  {
    Halfedge_index across;
    std::int64_t position, first, count;
  };

  void find_and_keep()
  {
    const auto edges = complex_.edges();
    if (number() > Kept_crossings::largest_total || std::none_of(edges.begin(), edges.end(), [&](Edge_index e) {
          return number_of_crossings(e) > std::int64_t(Crossed_halfedges::few);
        }))
      return;
    for (Edge_index e : complex_.edges()) {
      const auto n = std::size_t(number_of_crossings(e));
      crossed_.push_back(n > 0 ? std::make_unique<Halfedge_index[]>(n) : nullptr);
    }
    std::vector<Block> starts;
    for (Halfedge_index h : complex_.halfedges())
      if (!complex_.is_border(h) && number_of_crossings(complex_.edge(h)) > 0) {
        const Triangle_crossings t = coordinates_.triangle_crossings(complex_, h);
        if (t.e_k > 0)
          starts.push_back({h, t.c_i, 0, t.e_k});
      }
    std::stable_sort(starts.begin(), starts.end(), [](const Block& a, const Block& b) { return a.count > b.count; });
    for (const Block& start : starts)
      if (!is_known(start))
        follow(start);
    for (Edge_index e : complex_.edges())
      correspondence_.kept_crossings().keep(complex_.number_of_edges(), e, std::size_t(number_of_crossings(e)),
                                            std::move(crossed_[e.idx()]));
  }

  std::int64_t number_of_crossings(Edge_index e) const { return coordinates_.number_of_crossings(e); }

  // Whether all were followed from their other ends.
  bool is_known(const Block& start) const
  {
    const Edge_index e = complex_.edge(start.across);
    const Halfedge_index* const crossed = crossed_[e.idx()].get();
    const std::int64_t first =
      start.across == complex_.halfedge(e) ? start.position : number_of_crossings(e) - start.position - start.count;
    return std::all_of(crossed + first, crossed + first + start.count, [](Halfedge_index h) { return h.is_valid(); });
  }
  // The input halfedges that come from a corner.
  void follow(const Block& start)
  {
    fan_.clear();
    for_each_start(complex_, correspondence_, complex_.prev(start.across), start.count,
                   [&](Halfedge_index h) { fan_.push_back(h); });
    put(start);
    for (std::size_t step = 1; !blocks_.empty(); ++step) {
      if (step % 1024 == 0)
        interruption_.check();
      const Block block = blocks_.back();
      blocks_.pop_back();
      cross(block);
    }
  }
  void put(const Block& block)
  {
    if (block.count > 0)
      blocks_.push_back(block);
  }

  void cross(const Block& block)
  {
    const Halfedge_index ij = block.across, ji = complex_.opposite(ij);
    const std::int64_t n = number_of_crossings(complex_.edge(ij)), end = block.position + block.count;
    Halfedge_index* const crossed = crossed_[complex_.edge(ij).idx()].get();
    const auto first = fan_.begin() + block.first, last = first + block.count;
    if (ij == complex_.halfedge(complex_.edge(ij)))
      std::copy(first, last, crossed + block.position);
    else
      std::transform(first, last, std::make_reverse_iterator(crossed + (n - block.position)), Crossed_range::opposite);
    // Those before c_i go around i, those from c_i + e_l on around j, and the others end in the third corner.
    const Triangle_crossings t = coordinates_.triangle_crossings(complex_, ji);
    const std::int64_t around_i = (std::min)(end, t.c_j), from_j = (std::max)(block.position, t.c_j + t.e_k);
    put({complex_.next(ji), block.position, block.first, around_i - block.position});
    put({complex_.prev(ji), from_j + number_of_crossings(complex_.edge(complex_.prev(ji))) - n,
         block.first + from_j - block.position, end - from_j});
  }

  const Delta_complex& complex_;
  const Correspondence& correspondence_;
  const Normal_coordinates& coordinates_;
  const Interruption& interruption_;
  std::vector<std::unique_ptr<Halfedge_index[]>> crossed_; // by the halfedges with even numbers
  std::vector<Halfedge_index> fan_;                        // being followed, counterclockwise around their source
  std::vector<Block> blocks_;                              // still to be followed
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_HISTORY_LONG_CROSSINGS_H
