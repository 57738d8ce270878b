// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The sides of triangles, those of one edge together, and the triangles that edges with two faces join. Side 3f + i
// runs from corner i of face f to corner i + 1.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GLUING_SIDES_BY_EDGE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GLUING_SIDES_BY_EDGE_H

#include <CGAL/Intrinsic_triangulations/internal/connectivity/Delta_complex_builder.h>
#include <CGAL/Intrinsic_triangulations/Large_vector.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

class Sides_by_edge
{
public:
  using Side = Side_at_edge;

  // \param cuts pairs of sides that are one edge each, even if others have the same ends
  Sides_by_edge(std::size_t number_of_vertices, const std::vector<Index_triangle>& triangles,
                const std::vector<std::array<std::uint32_t, 2>>& cuts = {})
    : bucket_begin_(number_of_vertices + 2, 0), sides_(3 * triangles.size() - 2 * cuts.size(), default_init)
  {
    std::vector<bool> is_cut(cuts.empty() ? 0 : 3 * triangles.size(), false);
    for (const auto& pair : cuts)
      for (const std::uint32_t s : pair) {
        const std::uint32_t v = triangles[s / 3][s % 3], w = triangles[s / 3][(s + 1) % 3];
        cuts_.push_back({(std::min)(v, w), {(std::max)(v, w), 2 * s + (v > w ? 1 : 0)}});
        is_cut[s] = true;
      }
    for_each_side(triangles, is_cut,
                  [&](std::uint32_t v, std::uint32_t w, std::uint32_t) { ++bucket_begin_[(std::min)(v, w) + 2]; });
    for (std::size_t v = 2; v < bucket_begin_.size(); ++v)
      bucket_begin_[v] += bucket_begin_[v - 1];
    for_each_side(triangles, is_cut, [&](std::uint32_t v, std::uint32_t w, std::uint32_t s) {
      sides_[bucket_begin_[(std::min)(v, w) + 1]++] = {(std::max)(v, w), 2 * s + (v > w ? 1 : 0)};
    });
    for (std::size_t v = 0; v < number_of_vertices; ++v)
      sort_bucket(sides_.data() + bucket_begin_[v], sides_.data() + bucket_begin_[v + 1]);
  }

  // Calls function(smaller end, first side, end) for each edge; its sides are in the order of their numbers.
  template <class Function>
  void for_each_edge(const Function& function) const
  {
    for (std::uint32_t v = 0; v + 2 < bucket_begin_.size(); ++v)
      for (std::uint32_t i = bucket_begin_[v], j = i; i < bucket_begin_[v + 1]; i = j) {
        while (j < bucket_begin_[v + 1] && sides_[j].larger_end == sides_[i].larger_end)
          ++j;
        function(v, sides_.data() + i, sides_.data() + j);
      }
    for (std::size_t i = 0; i < cuts_.size(); i += 2) {
      const std::array<Side, 2> both{cuts_[i].second, cuts_[i + 1].second};
      function(cuts_[i].first, both.data(), both.data() + 2);
    }
  }

private:
  template <class Function>
  static void for_each_side(const std::vector<Index_triangle>& triangles, const std::vector<bool>& is_omitted,
                            const Function& function)
  {
    std::uint32_t s = 0;
    for (const Index_triangle& t : triangles)
      for (int i = 0; i < 3; ++i, ++s)
        if (is_omitted.empty() || !is_omitted[s])
          function(t[i], t[i == 2 ? 0 : i + 1], s);
  }

  static bool precedes(const Side& a, const Side& b)
  {
    return a.larger_end != b.larger_end ? a.larger_end < b.larger_end : a.side_and_direction < b.side_and_direction;
  }

  static void sort_bucket(Side* begin, Side* end)
  {
    constexpr std::ptrdiff_t few = 24; // for so few, insertion sort is faster
    if (end - begin > few)
      return std::sort(begin, end, precedes);
    for (Side* i = begin; i < end; ++i) {
      const Side side = *i;
      Side* j = i;
      for (; j > begin && precedes(side, j[-1]); --j)
        *j = j[-1];
      *j = side;
    }
  }

  Large_vector<std::uint32_t> bucket_begin_; // of each vertex, and the end of the last
  Large_vector<Side> sides_;
  std::vector<std::pair<std::uint32_t, Side>> cuts_; // smaller end, and side; two for each
};

// A piece consists of faces joined by edges with two faces. They are turned to agree with the first one, as far as
// possible: the search is breadth-first, so that faces that disagree lie far from the first one and the line between
// them is short.
class Triangle_pieces
{
  using Index = std::uint32_t;
  static constexpr Index none = (std::numeric_limits<Index>::max)();

public:
  struct Piece
  {
    bool is_closed = true; // each of its edges has two faces
    Index conflict = none; // a side at which two of its faces disagree

    bool is_orientable() const { return conflict == none; }
  };
  std::vector<Piece> pieces; // in the order of their first faces
  Large_vector<Index> piece_of;
  std::vector<bool> is_turned; // of each face

  Triangle_pieces(const Sides_by_edge& sides, std::size_t number_of_faces)
    : piece_of(number_of_faces, none), is_turned(number_of_faces, false)
  {
    // For each side, twice the number of the other side of its edge, plus 1 if both run in the same direction.
    Large_vector<Index> neighbor(3 * number_of_faces, none);
    sides.for_each_edge([&](Index, const Sides_by_edge::Side* begin, const Sides_by_edge::Side* end) {
      if (end - begin != 2)
        return;
      const Index disagree = begin[0].runs_to_smaller_end() == begin[1].runs_to_smaller_end();
      neighbor[begin[0].side()] = 2 * begin[1].side() + disagree;
      neighbor[begin[1].side()] = 2 * begin[0].side() + disagree;
    });
    std::vector<Index> faces;
    for (Index first = 0; first < number_of_faces; ++first) {
      if (piece_of[first] != none)
        continue;
      Piece piece;
      piece_of[first] = Index(pieces.size());
      faces.assign(1, first);
      for (std::size_t i = 0; i < faces.size(); ++i)
        for (Index s = 3 * faces[i]; s < 3 * faces[i] + 3; ++s) {
          if (neighbor[s] == none) {
            piece.is_closed = false;
            continue;
          }
          const Index g = neighbor[s] / 6;
          const bool wanted = is_turned[faces[i]] != ((neighbor[s] & 1) != 0);
          if (piece_of[g] == none) {
            piece_of[g] = Index(pieces.size());
            is_turned[g] = wanted;
            faces.push_back(g);
          } else if (is_turned[g] != wanted) {
            piece.conflict = s;
          }
        }
      pieces.push_back(piece);
    }
  }
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GLUING_SIDES_BY_EDGE_H
