// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The order in which an edge crosses input edges: the turns of the strip of input triangles.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_HISTORY_CROSSING_SEQUENCE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_HISTORY_CROSSING_SEQUENCE_H

#include <CGAL/Intrinsic_triangulations/internal/engine/history/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Input_edge_walk.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>

#include <CGAL/assertions.h>

#include <boost/config.hpp>
#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Two neighboring crossings of an edge lie on two sides of one input triangle, which
// share a corner on one side of the edge. On that side the two input segments run next to
// each other until they end in that corner; on the other side they part.
//
// All neighboring pairs are followed at once, as blocks that are split only where the segments part, and to both sides
// in turn, because the side on which a pair ends sooner decides it. If two segments return to the edge, they are
// another pair of its crossings there: the two pairs are linked, so that their continuation is followed once.
//
// If an inserted vertex lies between two segments, their parting says nothing. Then both are followed to their ends,
// which identify them.
class Crossing_sequence
{
public:
  // Far more than meshes need: each pair takes 33 bytes.
  static constexpr std::int64_t largest_number = std::int64_t(1) << 20;

  // The pairs of neighboring crossings of h, in order from its source.
  Crossing_sequence(const Delta_complex& complex, const Correspondence& correspondence, Halfedge_index h,
                    const Interruption& interruption)
    : complex_(complex), correspondence_(correspondence), coordinates_(correspondence.coordinates()), start_(h),
      interruption_(interruption)
  {
    const std::int64_t n = coordinates_.number_of_crossings(complex.edge(h));
    if (n > largest_number)
      throw Undecided_error("edge " + std::to_string(complex.edge(h).idx()) + " crosses " + std::to_string(n) +
                            " input edges, too many to be laid out");
    if (n < 2)
      return;
    turns_.resize(std::size_t(n - 1), UNKNOWN);
    number_of_unknown_ = n - 1;
    Queue left({h, 0, 0, n - 1}), right({complex.opposite(h), 0, 0, n - 1});
    for (std::size_t step = 0; number_of_unknown_ > 0; ++step) {
      if (step % 1024 == 1023)
        interruption.check();
      follow(left, LEFT, [](std::int64_t pair) { return pair; });
      follow(right, RIGHT, [n](std::int64_t pair) { return n - 2 - pair; });
    }
  }

  // Whether the input edges crossed at positions `pair` and `pair + 1` share their end on
  // the left.
  bool turns_left(std::size_t pair) const { return turns_[pair] == LEFT; }

private:
  enum Turn : std::uint8_t {
    UNKNOWN,
    LEFT,
    RIGHT
  };
  static Turn reversed(Turn turn) { return turn == LEFT ? RIGHT : LEFT; }

  // Another pair of the same two segments; it turns the other way if they run in the other direction there.
  struct Link
  {
    std::int64_t pair = -1;
    bool is_reversed = false;
  };

  // Pairs of neighboring segments that cross `halfedge` into its face: those at positions lower and lower + 1 and so
  // on from its source are the pairs first, ..., first + count - 1, seen from where the block comes from.
  struct Block
  {
    Halfedge_index halfedge;
    std::int64_t lower;
    std::int64_t first;
    std::int64_t count;
  };

  // Usually of one block.
  class Queue
  {
  public:
    explicit Queue(const Block& block) { push_back(block); }
    bool empty() const { return first_ == blocks_.size(); }
    void push_back(const Block& block) { blocks_.push_back(block); }
    Block pop_front()
    {
      const Block result = blocks_[first_++];
      if (2 * first_ >= blocks_.size()) {
        blocks_.erase(blocks_.begin(), blocks_.begin() + std::ptrdiff_t(first_));
        first_ = 0;
      }
      return result;
    }

  private:
    boost::container::small_vector<Block, 4> blocks_;
    std::size_t first_ = 0; // earlier ones are done
  };

  template <class Number_of>
  void decide(std::int64_t first, std::int64_t count, Turn turn, const Number_of& number_of)
  {
    for (std::int64_t pair = first; pair < first + count; ++pair)
      decide(number_of(pair), turn);
  }

  void decide(std::int64_t pair, Turn turn)
  {
    note(pair, turn);
    while (!to_pass_on_.empty()) {
      const std::size_t known = std::size_t(to_pass_on_.back());
      to_pass_on_.pop_back();
      for (const Link& link : links_[known])
        if (link.pair >= 0)
          note(link.pair, link.is_reversed ? reversed(turns_[known]) : turns_[known]);
    }
  }

  BOOST_NOINLINE void decide_by_ends(std::int64_t pair)
  {
    const auto crossed = [&](std::int64_t position) {
      return crossed_input_halfedge(complex_, correspondence_, start_, position, interruption_);
    };
    const Delta_complex& input = correspondence_.input();
    decide(pair, crossed(pair + 1) == input.opposite(input.prev(crossed(pair))) ? LEFT : RIGHT);
  }

  void note(std::int64_t pair, Turn turn)
  {
    if (turns_[std::size_t(pair)] != UNKNOWN)
      return;
    turns_[std::size_t(pair)] = turn;
    --number_of_unknown_;
    if (!links_.empty())
      to_pass_on_.push_back(pair);
  }

  // The strip that leaves `pair` to the side `side` comes to `other` from the side `other_side`.
  void link(std::int64_t pair, Turn side, std::int64_t other, Turn other_side)
  {
    if (links_.empty())
      links_.resize(turns_.size());
    const bool is_reversed = side == other_side;
    links_[std::size_t(pair)][side - LEFT] = {other, is_reversed};
    links_[std::size_t(other)][other_side - LEFT] = {pair, is_reversed};
    const auto pass_on = [&](std::int64_t from, std::int64_t to) {
      const Turn turn = turns_[std::size_t(from)];
      if (turn != UNKNOWN)
        decide(to, is_reversed ? reversed(turn) : turn);
    };
    pass_on(pair, other);
    pass_on(other, pair);
  }

  // Queues a block to cross its halfedge, or links its pairs if the halfedge belongs to the edge itself.
  template <class Number_of>
  void put(Queue& queue, const Block& block, Turn here, const Number_of& number_of)
  {
    if (complex_.edge(block.halfedge) != complex_.edge(start_)) {
      queue.push_back(block);
      return;
    }
    const bool comes_from_right = block.halfedge == start_;
    const std::int64_t last = std::int64_t(turns_.size()) - 1;
    for (std::int64_t i = 0; i < block.count; ++i) {
      const std::int64_t position = block.lower + i;
      link(number_of(block.first + i), here, comes_from_right ? position : last - position,
           comes_from_right ? RIGHT : LEFT);
    }
  }

  // Takes one step with the first block of a queue.
  template <class Number_of>
  void follow(Queue& queue, Turn here, const Number_of& number_of)
  {
    if (queue.empty())
      return;
    Block block = queue.pop_front();
    const auto is_known = [&](std::int64_t pair) { return turns_[std::size_t(number_of(pair))] != UNKNOWN; };
    while (block.count > 0 && is_known(block.first)) {
      ++block.first;
      ++block.lower;
      --block.count;
    }
    while (block.count > 0 && is_known(block.first + block.count - 1))
      --block.count;
    if (block.count == 0)
      return;

    // Positions before c_i cut corner i off, the next e_k end in k, the others cut j off.
    const Triangle_crossings t = coordinates_.triangle_crossings(complex_, block.halfedge);
    const std::int64_t to_k = t.c_i, to_j = t.c_i + t.e_k;
    const std::int64_t end = block.lower + block.count + 1; // past the last position
    const Turn there = reversed(here);
    const auto part = [&](std::int64_t begin_of_next) { // the pair across a boundary parts
      if (begin_of_next > block.lower && begin_of_next < end)
        decide(block.first + begin_of_next - 1 - block.lower, 1, there, number_of);
    };
    if (correspondence_.is_inserted(complex_.target(complex_.next(block.halfedge)))) { // nothing ends in k
      if (to_k > block.lower && to_k < end)
        decide_by_ends(number_of(block.first + to_k - 1 - block.lower));
    } else {
      part(to_k);
      part(to_j);
    }
    const auto piece = [&](std::int64_t begin, std::int64_t behind) {
      begin = (std::max)(begin, block.lower);
      behind = (std::min)(behind, end);
      return Block{block.halfedge, begin, block.first + begin - block.lower, behind - begin - 1};
    };
    const Block ends = piece(to_k, to_j);
    if (ends.count > 0)
      decide(ends.first, ends.count, here, number_of);
    Block around_i = piece(block.lower, to_k);
    if (around_i.count > 0) {
      around_i.halfedge = complex_.opposite(complex_.prev(block.halfedge));
      put(queue, around_i, here, number_of);
    }
    Block around_j = piece(to_j, end);
    if (around_j.count > 0) {
      // Segments that cut corner j off keep their distance from j.
      const Halfedge_index jk = complex_.next(block.halfedge);
      around_j.lower += coordinates_.number_of_crossings(complex_.edge(jk)) -
                        coordinates_.number_of_crossings(complex_.edge(block.halfedge));
      around_j.halfedge = complex_.opposite(jk);
      put(queue, around_j, here, number_of);
    }
  }

  const Delta_complex& complex_;
  const Correspondence& correspondence_;
  const Normal_coordinates& coordinates_;
  Halfedge_index start_;
  const Interruption& interruption_;
  boost::container::small_vector<Turn, 64>
    turns_; // for most edges without an allocation, which takes as long as finding a few of them
  std::vector<std::array<Link, 2>> links_; // to the left and to the right; empty until needed
  std::vector<std::int64_t> to_pass_on_;
  std::int64_t number_of_unknown_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_HISTORY_CROSSING_SEQUENCE_H
