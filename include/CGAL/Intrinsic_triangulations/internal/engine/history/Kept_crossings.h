// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The input halfedges that an edge crosses, cached while the edge lives.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_HISTORY_KEPT_CROSSINGS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_HISTORY_KEPT_CROSSINGS_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Index.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Normal_coordinates.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

// The input halfedges that a halfedge crosses from its left to its right, in order from its source.
class Crossed_range
{
public:
  Crossed_range() = default;
  Crossed_range(const Halfedge_index* first, std::size_t size, bool is_reversed)
    : first_(first), size_(size), is_reversed_(is_reversed)
  {}

  std::size_t size() const { return size_; }
  Halfedge_index operator[](std::size_t i) const { return is_reversed_ ? opposite(first_[size_ - 1 - i]) : first_[i]; }
  // As the opposite halfedge crosses them.
  Crossed_range reversed() const { return {first_, size_, !is_reversed_}; }
  Crossed_range prefix(std::size_t n) const { return {is_reversed_ ? first_ + (size_ - n) : first_, n, is_reversed_}; }

  static Halfedge_index opposite(Halfedge_index h) { return Halfedge_index(h.idx() ^ 1); }

private:
  const Halfedge_index* first_ = nullptr; // those of the opposite halfedge if reversed
  std::size_t size_ = 0;
  bool is_reversed_ = false;
};

// A sequence that was found is not searched again. The sequences of the edges made by a flip or a new vertex are slices
// of those of the sides around them, determined by the numbers of segments in the triangles (section 2.3 of the paper).
// If those are not cached, neither are these. Nothing here throws: if memory is short, sequences are not cached.
//
// Queries may cache sequences, too, from several threads at once: nothing is replaced or freed before a change.
class Kept_crossings
{
  using Array = std::unique_ptr<const Halfedge_index[]>;

public:
  // The limit of the cache, in halfedges of 4 bytes, besides a pointer for each edge.
  static constexpr std::size_t largest_total = std::size_t(1) << 25;

  Kept_crossings() = default;
  // Caches are not copied.
  Kept_crossings(const Kept_crossings&) {}
  Kept_crossings(Kept_crossings&& other) noexcept
    : table_(other.table_.exchange(nullptr)), total_(other.total_.exchange(0)), enough_(other.enough_.exchange(0))
  {}
  Kept_crossings& operator=(Kept_crossings other) noexcept;
  ~Kept_crossings() { clear(); }

  bool is_empty() const { return table_.load(std::memory_order_relaxed) == nullptr; }

  // Whether computing all sequences now costs no more than those already computed one by one. True once, for one
  // thread.
  // \param number_of_all() the number of crossings of all edges
  template <class Count>
  bool is_time_for_all(std::size_t number_of_edges, const Count& number_of_all) const
  {
    const std::size_t total = total_.load(std::memory_order_relaxed);
    std::size_t enough = enough_.load(std::memory_order_relaxed);
    if (total <= number_of_edges || total <= enough)
      return false;
    if (enough == 0) {
      const std::size_t found =
        number_of_all() / 16; // finding some one by one takes as long as 16 times as many at once
      if (enough_.compare_exchange_strong(enough, found))
        enough = found;
    }
    return total > enough && enough_.exchange(never) != never;
  }

  // The sequence of h, which crosses n input edges, if it is cached.
  std::optional<Crossed_range> find(Halfedge_index h, std::size_t n) const;

  // Caches the sequence of h.
  void keep(std::size_t number_of_edges, Halfedge_index h, const Crossed_range& crossed) const;
  // Caches the n crossings of the halfedge of e with the even number, if they are given.
  void keep(std::size_t number_of_edges, Edge_index e, std::size_t n, Array array) const;

  // The crossings of the edge that a flip is about to make.
  struct Flipped
  {
    Array array;
    std::size_t number;
    std::int64_t number_before;
  };
  // \param along the input halfedge along ij, if there is one
  Flipped flipped(const Delta_complex& complex, const Normal_coordinates& coordinates, const Hinge_halfedges& around,
                  Halfedge_index along) const;
  // Must be called with the result of flipped() at the flip.
  void flip(Edge_index e, Flipped flipped);
  // Forgets the sequence of e, which crosses this many input edges.
  void forget(Edge_index e, std::int64_t number);

  // Appends three edges from the corners of a triangle to a new vertex in a piece of it. Must be called before the
  // split of the connectivity.
  void split_face(const Delta_complex& complex, const Normal_coordinates& coordinates, const Triangle_piece& piece);
  // Likewise for the split of an edge that coincides with an input edge.
  void split_edge(const Delta_complex& complex, const Normal_coordinates& coordinates, Halfedge_index h);
  // Called before the coordinates are changed.
  void remove(const Normal_coordinates& coordinates, const Removed_elements& removed);

  void clear() noexcept;

private:
  static constexpr std::size_t never = (std::numeric_limits<std::size_t>::max)();

  using Slot = std::atomic<const Halfedge_index*>;
  // One for each edge, for the halfedge with the even number.
  struct Table
  {
    std::size_t size, capacity;
    std::unique_ptr<Slot[]> slots;
  };
  static Table* new_table(std::size_t size, std::size_t capacity);
  // Made by the first thread that caches something. `nullptr` if there is no memory.
  Table* made_table(std::size_t number_of_edges) const;
  bool make_room(std::size_t number_of_edges, std::size_t number);

  // \param get get(i) is one of n halfedges
  template <class Get>
  Array copied(std::size_t n, const Get& get) const
  {
    if (total_ + n > largest_total)
      return nullptr;
    std::unique_ptr<Halfedge_index[]> result(new (std::nothrow) Halfedge_index[n]);
    for (std::size_t i = 0; result && i < n; ++i)
      result[i] = get(i);
    return result;
  }
  Array copied(const Crossed_range& crossed) const;
  // The sequence of the opposite of the given halfedge, which leads to the new vertex.
  void append(const std::optional<Crossed_range>& to_v);

  // The first n crossings of h, if known.
  std::optional<Crossed_range> prefix(const Normal_coordinates& coordinates, Halfedge_index h, std::int64_t n) const;

  // The crossings of a line from the corner k of a triangle to a point that follows the given number of crossings of
  // ij.
  std::optional<Crossed_range> from_opposite_corner(const Delta_complex& complex, const Normal_coordinates& coordinates,
                                                    Halfedge_index ij, std::int64_t gap) const;

  // A line from one point to another: its first crossings, an edge in between if valid, and its crossings seen from its
  // end.
  Array joined(const Crossed_range& from_source, Halfedge_index between, const Crossed_range& from_target) const;

  mutable std::atomic<Table*> table_{nullptr};
  mutable std::atomic<std::size_t> total_{0};
  mutable std::atomic<std::size_t> enough_{0}; // the number that makes it time for all; 0 if not yet known
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_HISTORY_KEPT_CROSSINGS_H
