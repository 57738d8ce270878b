// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Caching the input halfedges that edges cross, and updating them at each change.

#include <CGAL/Intrinsic_triangulations/internal/engine/history/Kept_crossings.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <optional>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

Kept_crossings& Kept_crossings::operator=(Kept_crossings other) noexcept
{
  other.table_ = table_.exchange(other.table_);
  other.total_ = total_.exchange(other.total_);
  other.enough_ = enough_.exchange(other.enough_);
  return *this;
}

std::optional<Crossed_range> Kept_crossings::find(Halfedge_index h, std::size_t n) const
{
  const Table* const table = table_.load(std::memory_order_acquire);
  const Halfedge_index* const first = table ? table->slots[h.idx() / 2].load(std::memory_order_acquire) : nullptr;
  return first ? std::make_optional(Crossed_range(first, n, (h.idx() & 1) != 0)) : std::nullopt;
}

void Kept_crossings::keep(std::size_t number_of_edges, Halfedge_index h, const Crossed_range& crossed) const
{
  const Crossed_range of_edge = (h.idx() & 1) != 0 ? crossed.reversed() : crossed;
  keep(number_of_edges, Edge_index(h.idx() / 2), of_edge.size(), copied(of_edge));
}

void Kept_crossings::keep(std::size_t number_of_edges, Edge_index e, std::size_t n, Array array) const
{
  Table* const table = array ? made_table(number_of_edges) : nullptr;
  const Halfedge_index* nothing = nullptr; // unless another thread was faster
  if (table && table->slots[e.idx()].compare_exchange_strong(nothing, array.get(), std::memory_order_acq_rel)) {
    array.release();
    total_ += n;
  }
}

Kept_crossings::Flipped Kept_crossings::flipped(const Delta_complex& complex, const Normal_coordinates& coordinates,
                                                const Hinge_halfedges& around, Halfedge_index along) const
{
  const Triangle_crossings above = coordinates.triangle_crossings(complex, around.ij), // (i, j, k)
    below = coordinates.triangle_crossings(complex, around.ji);                        // (j, i, l)
  // Segments from il through ij to jk, and from lj to ki.
  const std::int64_t to_jk = (std::max)(std::int64_t(0), below.c_j - above.c_i - above.e_k),
                     to_ki = (std::max)(std::int64_t(0), above.c_i - below.c_j - below.e_k);
  const auto first = [&](Halfedge_index h, std::int64_t n) { return prefix(coordinates, h, n); };
  const auto from_l = below.e_j > 0 || to_ki > 0 ? first(around.lj, below.c_k + below.e_j + to_ki)
                                                 : first(complex.opposite(around.il), below.c_k + below.e_i + to_jk);
  const auto from_k =
    above.e_j > 0 ? first(around.ki, above.c_k + above.e_j) : first(complex.opposite(around.jk), above.c_k + above.e_i);
  Flipped result{nullptr, 0, coordinates.number_of_crossings(complex.edge(around.ij))};
  if (from_l && from_k) { // from l to k
    result.array = joined(*from_l, along, *from_k);
    result.number = from_l->size() + (along.is_valid() ? 1 : 0) + from_k->size();
  }
  return result;
}

void Kept_crossings::flip(Edge_index e, Flipped flipped)
{
  forget(e, flipped.number_before);
  if (Table* const table = flipped.array ? table_.load() : nullptr) {
    table->slots[e.idx()] = flipped.array.release();
    total_ += flipped.number;
  }
}

void Kept_crossings::forget(Edge_index e, std::int64_t number)
{
  if (Table* const table = table_)
    if (const Halfedge_index* const kept = table->slots[e.idx()]) { // seldom: an exchange would lock the memory
      table->slots[e.idx()] = nullptr;
      total_ -= std::size_t(number);
      delete[] kept;
    }
}

void Kept_crossings::split_face(const Delta_complex& complex, const Normal_coordinates& coordinates,
                                const Triangle_piece& piece)
{
  const std::size_t number_of_edges = complex.number_of_edges();
  if (!make_room(number_of_edges, 3))
    return;
  const Halfedge_index ij = piece.side;
  const std::int64_t n_ij = coordinates.number_of_crossings(complex.edge(ij));
  append(prefix(coordinates, ij, piece.gap));
  append(prefix(coordinates, complex.opposite(ij), n_ij - piece.gap));
  append(from_opposite_corner(complex, coordinates, ij, piece.gap));
}

void Kept_crossings::split_edge(const Delta_complex& complex, const Normal_coordinates& coordinates, Halfedge_index h)
{
  const std::size_t number_of_edges = complex.number_of_edges();
  if (!make_room(number_of_edges, 3))
    return;
  append(Crossed_range());
  for (Halfedge_index ij : {h, complex.opposite(h)})
    if (!complex.is_border(ij))
      append(from_opposite_corner(complex, coordinates, ij, 0));
}

void Kept_crossings::remove(const Normal_coordinates& coordinates, const Removed_elements& removed)
{
  if (Table* const table = table_)
    for (Edge_index e : removed.edges) {
      forget(e, coordinates.number_of_crossings(e));
      table->slots[e.idx()] = table->slots[--table->size].load();
      table->slots[table->size] = nullptr;
    }
}

void Kept_crossings::clear() noexcept
{
  if (Table* const table = table_.exchange(nullptr)) {
    for (std::size_t e = 0; e < table->size; ++e)
      delete[] table->slots[e].load();
    delete table;
  }
  total_ = 0;
  enough_ = 0;
}

Kept_crossings::Table* Kept_crossings::new_table(std::size_t size, std::size_t capacity)
{
  std::unique_ptr<Slot[]> slots(new (std::nothrow) Slot[capacity]());
  return slots ? new (std::nothrow) Table{size, capacity, std::move(slots)} : nullptr;
}

Kept_crossings::Table* Kept_crossings::made_table(std::size_t number_of_edges) const
{
  if (Table* const table = table_.load(std::memory_order_acquire))
    return table;
  Table *const made = new_table(number_of_edges, number_of_edges), *other = nullptr;
  if (!made || table_.compare_exchange_strong(other, made, std::memory_order_acq_rel))
    return made;
  delete made;
  return other;
}

bool Kept_crossings::make_room(std::size_t number_of_edges, std::size_t number)
{
  Table* table = made_table(number_of_edges);
  if (table && table->capacity - table->size < number) {
    Table* const larger = new_table(table->size, table->size + table->size / 2 + number);
    if (!larger) {
      clear();
      return false;
    }
    for (std::size_t e = 0; e < table->size; ++e)
      larger->slots[e] = table->slots[e].load();
    delete std::exchange(table, larger);
    table_ = table;
  }
  return table != nullptr;
}

Kept_crossings::Array Kept_crossings::copied(const Crossed_range& crossed) const
{
  return copied(crossed.size(), [&](std::size_t i) { return crossed[i]; });
}

void Kept_crossings::append(const std::optional<Crossed_range>& to_v)
{
  Table& table = *table_;
  Array array;
  if (to_v && to_v->size() != 0)
    array = copied(to_v->reversed());
  if (array)
    total_ += to_v->size();
  table.slots[table.size++] = array.release();
}

std::optional<Crossed_range> Kept_crossings::prefix(const Normal_coordinates& coordinates, Halfedge_index h,
                                                    std::int64_t n) const
{
  if (n == 0)
    return Crossed_range();
  const auto all = find(h, std::size_t(coordinates.number_of_crossings(Edge_index(h.idx() / 2))));
  return all ? std::make_optional(all->prefix(std::size_t(n))) : std::nullopt;
}

std::optional<Crossed_range> Kept_crossings::from_opposite_corner(const Delta_complex& complex,
                                                                  const Normal_coordinates& coordinates,
                                                                  Halfedge_index ij, std::int64_t gap) const
{
  const Triangle_crossings t = coordinates.triangle_crossings(complex, ij);
  const std::int64_t from_j = coordinates.number_of_crossings(complex.edge(ij)) - gap;
  std::int64_t along_ki = t.c_k + t.e_j, along_kj = t.c_k + t.e_i;
  if (gap < t.c_i)
    along_ki += t.c_i - gap;
  else if (from_j < t.c_j)
    along_kj += t.c_j - from_j;
  return along_ki > along_kj ? prefix(coordinates, complex.prev(ij), along_ki)
                             : prefix(coordinates, complex.opposite(complex.next(ij)), along_kj);
}

Kept_crossings::Array Kept_crossings::joined(const Crossed_range& from_source, Halfedge_index between,
                                             const Crossed_range& from_target) const
{
  const std::size_t n = from_source.size(), m = n + (between.is_valid() ? 1 : 0), all = m + from_target.size();
  if (all == 0)
    return nullptr;
  const Crossed_range to_target = from_target.reversed();
  return copied(all, [&](std::size_t i) { return i < n ? from_source[i] : i < m ? between : to_target[i - m]; });
}

} // namespace CGAL::Intrinsic_triangulations::internal
