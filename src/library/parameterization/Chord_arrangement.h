// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Two families of chords of a disk, and the pieces into which they divide it: integers only.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_PARAMETERIZATION_CHORD_ARRANGEMENT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_PARAMETERIZATION_CHORD_ARRANGEMENT_H

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Nodes on the circle are numbered counterclockwise, and crossings follow. Chords of one family do not cross each other,
// and two chords cross once at most: if their ends alternate.
class Chord_arrangement
{
public:
  static constexpr std::uint32_t none = std::uint32_t(-1);
  struct Chord
  {
    std::uint32_t a, b;
  };
  struct Crossing
  {
    std::uint32_t first, second; // one chord of each family
  };
  // From a node to the next one on the circle, or on a chord.
  struct Dart
  {
    std::uint32_t source, chord; // none: on the circle
    bool is_forward;             // from a to b
  };

  // \param n the number of nodes on the circle
  // \param chords those of the first family come first
  // O(n + c log c + x log x) for c chords with x crossings.
  void build(std::uint32_t n, std::vector<Chord> chords, std::size_t size_of_first_family);

  const std::vector<Chord>& chords() const { return chords_; }
  const std::vector<Crossing>& crossings() const { return crossings_; }

  // The ends of chords at a node of the circle, counterclockwise, as chords to their other ends: numbers of a range.
  std::uint32_t first_end(std::uint32_t node) const { return first_ends_[node]; }
  Dart end(std::uint32_t i) const { return dart(ends_[i]); }
  // The number of the end where a chord begins, seen from its source.
  std::uint32_t end_at_source(const Dart& d) const { return ranks_[2 * d.chord + (d.is_forward ? 0 : 1)]; }

  // Visits the darts around each piece, counterclockwise.
  template <class Visit>
  void for_each_piece(const Visit& visit)
  {
    std::vector<Dart> piece;
    is_visited_.assign(n_ + 2 * path_.size(), false);
    for (std::uint32_t first = 0; first < is_visited_.size(); ++first) {
      if (is_visited_[first] || is_unused(first))
        continue;
      piece.clear();
      for (std::uint32_t d = first; !is_visited_[d]; d = next(d)) {
        is_visited_[d] = true;
        piece.push_back(dart(d));
      }
      visit(piece);
    }
  }

private:
  // Darts as numbers: on the circle that of the source, then two for each node of a path.
  std::uint32_t forward(std::uint32_t place) const { return n_ + 2 * place; }
  std::uint32_t backward(std::uint32_t place) const { return n_ + 2 * (place - 1) + 1; }
  std::uint32_t place(std::uint32_t d) const { return (d - n_) / 2; }
  bool is_forward(std::uint32_t d) const { return (d - n_) % 2 == 0; }
  bool is_unused(std::uint32_t d) const { return d >= n_ && place(d) + 1 == first_places_[chord_at_[place(d)] + 1]; }
  Dart dart(std::uint32_t d) const;
  std::uint32_t target(std::uint32_t d) const;
  std::uint32_t next(std::uint32_t d) const;
  // Counted around the circle from a on.
  std::uint32_t after(std::uint32_t a, std::uint32_t x) const { return x >= a ? x - a : x + n_ - a; }

  void nest();
  void find_crossings();
  void make_paths();
  void sort_ends();

  std::uint32_t n_ = 0;
  std::vector<Chord> chords_;
  std::size_t size_of_first_family_ = 0;
  std::vector<std::uint32_t> around_node_, around_chord_; // the innermost chord of the first family around each
  std::vector<Crossing> crossings_;
  std::vector<std::uint32_t> path_, chord_at_, first_places_; // the nodes of all chords, from a to b
  std::vector<std::pair<std::uint32_t, std::uint32_t>> places_of_crossing_;
  std::vector<std::uint32_t> ends_, first_ends_, ranks_;
  std::vector<bool> is_visited_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_PARAMETERIZATION_CHORD_ARRANGEMENT_H
