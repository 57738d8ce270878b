// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The position of the input triangulation in the current one, by integers alone.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_HISTORY_NORMAL_COORDINATES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_HISTORY_NORMAL_COORDINATES_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Large_vector.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/errors.h>

#include <CGAL/assertions.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL::Intrinsic_triangulations::internal {

// How the input edges run through one triangle (i, j, k) of the current triangulation.
//
// At most one of `e_i`, `e_j`, `e_k` is positive.
struct Triangle_crossings
{
  std::int64_t e_i; // number of segments from corner i to the opposite edge
  std::int64_t e_j; // the same for corner j
  std::int64_t e_k; // the same for corner k
  std::int64_t c_i; // number of segments that cut off corner i
  std::int64_t c_j; // the same for corner j
  std::int64_t c_k; // the same for corner k

  // Computes the numbers from the number of crossings of each edge.
  BOOST_FORCEINLINE Triangle_crossings(std::int64_t n_ij, std::int64_t n_jk, std::int64_t n_ki)
    : c_i(cut_off(n_ij, n_ki, n_jk)), c_j(cut_off(n_jk, n_ij, n_ki)), c_k(cut_off(n_ki, n_jk, n_ij))
  {
    // A segment that crosses a side cuts off one of its ends or comes from the opposite corner.
    e_i = n_jk - c_j - c_k;
    e_j = n_ki - c_k - c_i;
    e_k = n_ij - c_i - c_j;
  }

  // The number between sides crossed a and b times; the third side is crossed c times. If a or b exceeds the sum of the
  // others, the rest comes from a corner.
  static std::int64_t cut_off(std::int64_t a, std::int64_t b, std::int64_t c)
  {
    // Without a branch, which would be unpredictable
    return (std::max)(std::int64_t(0), (std::min)((std::min)(a, b), (a + b - c) >> 1));
  }
};

// An input halfedge: the one that follows `base` after `steps` steps counterclockwise
// around their source.
struct Roundabout
{
  Halfedge_index base; // an input halfedge
  std::uint64_t steps; // counts modulo the degree of the source, which it may exceed
};

// Normal coordinates and roundabouts: integers that determine exactly how the
// edges of the input triangulation run through the current one.
//
// The normal coordinate of an edge is the number of times that input edges cross it, or −1 if it coincides with an
// input edge. The roundabout of a halfedge is the first input halfedge at or after it, counterclockwise around its
// source. A vertex inserted into an input face has none. A flip updates both in O(1), whatever the edge crosses and
// whatever the degrees are, without access to the input. Rounding never affects them.
//
// Memory: 4 bytes an edge, and 32 for each edge that was flipped.
//
// Source: the idea is that of M. Gillespie, N. Sharp, K. Crane, "Integer coordinates for intrinsic geometry processing"
// (2021). There, roundabouts are numbers from zero to the degree; counted from an input halfedge, they need no initial
// numbering.
class Normal_coordinates
{
public:
  // Constructs the coordinates of an empty triangulation.
  Normal_coordinates() = default;
  // Constructs the coordinates of an input triangulation in itself. O(edges), as memory is cleared.
  explicit Normal_coordinates(const Delta_complex& input) : record_of_(input.number_of_edges(), 0)
  {
    records_.reserve(std::size_t(input.number_of_edges()) + 1); // unused pages cost nothing
    records_.push_back(Record{-1, {0, 0}, {0, 0}});
  }

  // Replaces the integers of `e`.
  // \param crossings as `crossings(e)`
  // \param first, second the roundabouts of its halfedges, or null
  void set(Edge_index e, std::int64_t crossings, Halfedge_index first, Halfedge_index second)
  {
    set_record(Halfedge_index(2 * e.idx()), {crossings, {first.idx(), second.idx()}, {0, 0}});
  }

  // The number of times that input edges cross `e`, or −1 if `e` coincides with one.
  std::int64_t crossings(Edge_index e) const { return record(e).crossings; }
  // Whether `e` coincides with an input edge.
  bool is_original(Edge_index e) const { return crossings(e) < 0; }
  // The number of times that input edges cross `e`.
  std::int64_t number_of_crossings(Edge_index e) const { return (std::max)(std::int64_t(0), crossings(e)); }

  // The roundabout of `h`, without `base` if `h` leaves a vertex where no input edge ends.
  Roundabout roundabout(Halfedge_index h) const
  {
    const std::uint32_t i = record_number(h);
    if (i == 0)
      return {h, 0};
    return {Halfedge_index(records_[i].base[h.idx() & 1]), records_[i].steps[h.idx() & 1]};
  }
  // Replaces the roundabout of `h`.
  // \pre `same` is the same input halfedge as `roundabout(h)`, and the edge of `h` was flipped
  void set_roundabout(Halfedge_index h, Halfedge_index same)
  {
    Record& r = records_[record_number(h)];
    r.base[h.idx() & 1] = same.idx();
    r.steps[h.idx() & 1] = 0;
  }

  // How the input edges run through the triangle to the left of `h`, with i and
  // j the source and target of `h`.
  Triangle_crossings triangle_crossings(const Delta_complex& complex, Halfedge_index h) const
  {
    return Triangle_crossings(number_of_crossings(complex.edge(h)), number_of_crossings(complex.edge(complex.next(h))),
                              number_of_crossings(complex.edge(complex.prev(h))));
  }
  // The side whose opposite corner takes the least time to lay out. It lies at the shortest side, so that the relative
  // errors of all sides are small.
  Halfedge_index side_with_most_crossings(const Delta_complex& complex, Face_index f) const
  {
    return side_with_largest(complex, f, [&](Halfedge_index h) { return crossings(complex.edge(h)); });
  }

  // The names of `piece` on all sides of its triangle that it touches, itself first.
  //
  // There are at most three; those that do not exist have no `side`.
  std::array<Triangle_piece, 3> names(const Delta_complex& complex, const Triangle_piece& piece) const;

  // Updates the integers for a new vertex v in a piece of a triangle; to be called before
  // `split_face(piece.side)` of the connectivity. O(1).
  //
  // No input edge ends in the new vertex: the halfedges that leave it have no roundabouts. An exception leaves
  // everything as it was.
  // \exception Integer_overflow_error as `flip()`
  void split_face(const Delta_complex& complex, const Triangle_piece& piece);

  // Updates the integers for a new vertex v on the edge of `h`, which coincides with an input edge; to be called before
  // `split_edge(h)` of the connectivity. O(1).
  //
  // The two parts coincide with that input edge. Its halfedges are the roundabouts of the halfedges that leave v. An
  // exception leaves everything as it was.
  // \param complex the current connectivity
  // \param h a halfedge whose edge `is_original()`
  // \param along the input halfedge along h
  // \exception Integer_overflow_error as `flip()`
  void split_edge(const Delta_complex& complex, Halfedge_index h, Halfedge_index along);

  // Updates the integers when two edges that form a straight line become one; must be called before `unsplit_edge(h)`
  // of the connectivity. O(1).
  //
  // \param complex the current connectivity
  // \param h a halfedge to the vertex that will be removed
  // \param is_on_input_edge whether an input edge runs through that vertex
  // \exception Integer_overflow_error as `flip()`; then nothing is changed
  void unsplit_edge(const Delta_complex& complex, Halfedge_index h, bool is_on_input_edge);
  // Follows the removal of a vertex, after the connectivity. Only descriptors change. O(1). Never throws.
  void remove(const Removed_elements& removed);

  // Updates the integers for the flip of the edge that these halfedges surround; must be called before the flip of the
  // connectivity. O(1).
  //
  // \return the steps of the longer one of the two roundabouts
  // \exception Integer_overflow_error if the count would leave the range of 64 bits;
  //   then nothing is changed
  std::uint64_t flip(const Hinge_halfedges& around)
  {
    const Halfedge_index ki = around.ki, lj = around.lj;
    const std::uint32_t ij = record_number(around.ij), at_jk = record_number(around.jk), at_ki = record_number(ki),
                        at_il = record_number(around.il), at_lj = record_number(lj);
    // After the flip the halfedge ij leads from l to k (see Delta_complex::flip()).
    if ((ij | at_jk | at_ki | at_il | at_lj) == 0) { // two input faces
      set_record(around.ij, {1, {lj.idx(), ki.idx()}, {1, 1}});
      return 1;
    }

    const Record* const records = records_.data();
    const auto number_of_crossings = [records](std::uint32_t i) {
      return (std::max)(std::int64_t(0), records[i].crossings);
    };
    const std::int64_t n_ij = number_of_crossings(ij), n_jk = number_of_crossings(at_jk),
                       n_ki = number_of_crossings(at_ki), n_il = number_of_crossings(at_il),
                       n_lj = number_of_crossings(at_lj);
    // Of the triangles (i, j, k) and (j, i, l)
    const auto cut_off = Triangle_crossings::cut_off;
    const std::int64_t c_i1 = cut_off(n_ij, n_ki, n_jk), c_j1 = cut_off(n_ij, n_jk, n_ki), e_k1 = n_ij - c_i1 - c_j1,
                       c_i2 = cut_off(n_ij, n_il, n_lj), c_j2 = cut_off(n_ij, n_lj, n_il), e_l2 = n_ij - c_i2 - c_j2;

    // Counted from i, the segments that end in k cross ij at the positions after c_i1,
    // those that end in l at the positions after c_i2: one that does both joins k and l.
    const bool joins_k_and_l = (std::max)(c_i1, c_i2) < (std::min)(c_i1 + e_k1, c_i2 + e_l2);
    // A segment that cuts off one corner or leaves another crosses the longer rest of its sides.
    const std::int64_t n = (std::max)(n_jk - c_j1, n_ki - c_i1) + (std::max)(n_lj - c_j2, n_il - c_i2) +
                           (std::max)(std::int64_t(0), c_i1 - c_i2 - e_l2) +
                           (std::max)(std::int64_t(0), c_i2 - c_i1 - e_k1) + (records[ij].crossings < 0 ? 1 : 0);
    const std::int64_t n_kl = joins_k_and_l ? -1 : n;
    if (n_kl > largest_count)
      throw Integer_overflow_error("an edge crosses more than 2^60 input edges");
    Roundabout r_kl = first_after(ki, at_ki), r_lk = first_after(lj, at_lj);
    r_kl.steps += std::uint64_t((std::min)((std::max)(std::int64_t(0), c_i2 - c_i1), e_k1));
    r_lk.steps += std::uint64_t((std::min)((std::max)(std::int64_t(0), c_j1 - c_j2), e_l2));
    set_record(around.ij, {n_kl, {r_lk.base.idx(), r_kl.base.idx()}, {r_lk.steps, r_kl.steps}});
    return (std::max)(r_lk.steps, r_kl.steps);
  }

private:
  static constexpr std::uint32_t no_halfedge = Halfedge_index::null_index();

  // Five counts up to this add up without overflow.
  static constexpr std::int64_t largest_count = std::int64_t(1) << 60;

  // Halfedge 2e + i has the roundabout `base[i]`, `steps[i]`. A flip makes at most as many
  // steps as its vertex has input halfedges: 64 bits are enough for 2^32 flips.
  struct Record
  {
    std::int64_t crossings;
    std::uint32_t base[2];
    std::uint64_t steps[2];
  };

  std::uint32_t record_number(Halfedge_index h) const { return record_of_[h.idx() >> 1]; }
  const Record& record(Edge_index e) const { return records_[record_of_[e.idx()]]; }

  BOOST_FORCEINLINE void set_record(Halfedge_index h, const Record& record)
  {
    const std::uint32_t e = h.idx() >> 1;
    std::uint32_t& i = record_of_[e];
    if (i == 0)
      i = new_record();
    records_[i] = record;
  }

  // Afterwards, this many edges and records can be appended without an exception.
  void make_room(std::size_t number)
  {
    internal::make_room(record_of_, number);
    internal::make_room(records_, number);
  }
  void append(const Record& record)
  {
    record_of_.resize(record_of_.size() + 1, default_init);
    record_of_.back() = new_record();
    records_[record_of_.back()] = record;
  }

  std::uint32_t new_record()
  {
    if (first_free_record_ != 0) {
      const std::uint32_t i = first_free_record_;
      first_free_record_ = std::uint32_t(records_[i].crossings);
      return i;
    }
    records_.resize(records_.size() + 1, default_init);
    return std::uint32_t(records_.size() - 1);
  }

  Roundabout first_after(Halfedge_index h) const { return first_after(h, record_number(h)); }
  // The first input halfedge after h, whose edge has record i, derived from the first one at or after h.
  Roundabout first_after(Halfedge_index h, std::uint32_t i) const
  {
    if (i == 0)
      return {h, 1};
    const Record& r = records_[i];
    const std::uint32_t side = h.idx() & 1;
    return {Halfedge_index(r.base[side]), r.steps[side] + (r.crossings < 0 ? 1 : 0)};
  }

  Large_vector<Record> records_; // the first one belongs to all edges never flipped
  Large_vector<std::uint32_t> record_of_;
  std::uint32_t first_free_record_ =
    0; // of edges that were removed: each has the next one as `crossings`, the last one 0
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_HISTORY_NORMAL_COORDINATES_H
