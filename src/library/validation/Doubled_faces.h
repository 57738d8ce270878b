// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Which of the triangles that have the same corners belong to a surface.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_DOUBLED_FACES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_DOUBLED_FACES_H

#include "../gluing/Sides_by_edge.h"
#include <CGAL/Intrinsic_triangulations/internal/system/Disjoint_sets.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// A face that occurs several times is either superfluous or the wall between two rooms, which belongs to both. Its
// edges tell: an even number of other faces meets the edges of a wall, an odd number those of a superfluous face.
//
// - A part joined by edges may occur several times as a whole; then each of its faces counts correspondingly less.
// - Two such faces that alone meet at an edge decide together: so a wall or fin of many faces is kept or dropped as
//   one, and a face given too often next to a wall differs from it.
// - If edges do not tell, a face follows the faces that meet it at edges of walls only, as between many rooms.
class Doubled_faces
{
  using Index = std::uint32_t;

public:
  // \pre no triangle names a vertex twice
  Doubled_faces(std::size_t number_of_vertices, const std::vector<Index_triangle>& triangles)
    : triangles_(triangles), is_kept_(triangles.size(), true)
  {
    find_classes();
    if (begin_.size() - 1 == triangles.size())
      return;
    std::vector<Index_triangle> firsts;
    for (Index c = 0; c + 1 < begin_.size(); ++c)
      firsts.push_back(triangles[order_[begin_[c]]]);
    const Sides_by_edge sides(number_of_vertices, firsts);
    find_numbers(sides);
    look_at_edges(sides);
    decide();
    keep();
  }

  bool is_kept(std::size_t face) const { return is_kept_[face]; }

private:
  // The doubled classes at an edge with three or more of them, and whether the number of other faces is odd.
  struct Edge
  {
    std::vector<Index> classes;
    bool is_odd;
  };

  static Index_triangle sorted(Index_triangle t)
  {
    std::sort(t.begin(), t.end());
    return t;
  }

  // The faces of a class have the same corners.
  void find_classes()
  {
    std::vector<std::pair<Index_triangle, Index>> all;
    all.reserve(triangles_.size());
    for (Index f = 0; f < triangles_.size(); ++f)
      all.emplace_back(sorted(triangles_[f]), f);
    std::sort(all.begin(), all.end());
    for (Index i = 0; i < all.size(); ++i) {
      if (i == 0 || all[i].first != all[i - 1].first)
        begin_.push_back(i);
      order_.push_back(all[i].second);
    }
    begin_.push_back(Index(all.size()));
  }

  std::size_t number_of_classes() const { return begin_.size() - 1; }

  void find_numbers(const Sides_by_edge& sides)
  {
    Disjoint_sets parts(number_of_classes());
    sides.for_each_edge([&](Index, const Side_at_edge* begin, const Side_at_edge* end) {
      for (const Side_at_edge* s = begin + 1; s < end; ++s)
        parts.unite(begin->face(), s->face());
    });
    std::vector<Index> divisor(number_of_classes(), 0);
    for (Index c = 0; c < number_of_classes(); ++c)
      divisor[parts.find(c)] = std::gcd(divisor[parts.find(c)], begin_[c + 1] - begin_[c]);
    for (Index c = 0; c < number_of_classes(); ++c)
      is_doubled_.push_back(begin_[c + 1] - begin_[c] > divisor[parts.find(c)]);
  }

  void look_at_edges(const Sides_by_edge& sides)
  {
    votes_.assign(number_of_classes(), 0);
    groups_ = Disjoint_sets(2 * number_of_classes());
    std::vector<std::pair<Index, bool>> votes; // class, whether it is a wall
    sides.for_each_edge([&](Index, const Side_at_edge* begin, const Side_at_edge* end) {
      std::vector<Index> doubled;
      for (const Side_at_edge* s = begin; s < end; ++s)
        if (is_doubled_[s->face()])
          doubled.push_back(s->face());
      const std::size_t others = std::size_t(end - begin) - doubled.size();
      if (doubled.size() == 1 && others > 0)
        votes.emplace_back(doubled[0], others % 2 == 0);
      else if (doubled.size() == 2)
        tie(doubled[0], doubled[1], others % 2 == 1);
      else if (doubled.size() > 2)
        edges_.push_back({std::move(doubled), others % 2 == 1});
    });
    for (const auto& [c, is_wall] : votes)
      vote(c, is_wall);
  }

  // Class c is node 2c. Node 2c + 1 is joined with the classes that are kept twice if and only if class c is not.
  void tie(Index c, Index d, bool do_differ)
  {
    if (groups_.find(2 * c) == groups_.find(2 * d + !do_differ))
      return;
    groups_.unite(2 * c, 2 * d + do_differ);
    groups_.unite(2 * c + 1, 2 * d + !do_differ);
  }
  void vote(Index c, bool is_wall)
  {
    const Index root = groups_.find(2 * c);
    votes_[root / 2] += is_wall != (root % 2 == 1) ? 1 : -1;
  }
  bool is_decided(Index c) { return votes_[groups_.find(2 * c) / 2] != 0; }
  bool is_wall(Index c)
  {
    const Index root = groups_.find(2 * c);
    return root % 2 == 0 ? votes_[root / 2] > 0 : votes_[root / 2] < 0;
  }

  // Propagates decisions to adjacent classes.
  void decide()
  {
    for (bool is_changed = true; is_changed;) {
      std::vector<std::pair<Index, bool>> votes;
      std::vector<Edge> left;
      for (Edge& edge : edges_) {
        bool is_odd = edge.is_odd;
        std::size_t walls = 0, decided = 0;
        Index open = 0;
        for (Index c : edge.classes) {
          if (!is_decided(c)) {
            open = c;
            continue;
          }
          ++decided;
          walls += is_wall(c);
          is_odd = is_odd != !is_wall(c);
        }
        if (decided == edge.classes.size())
          continue;
        if (decided + 1 == edge.classes.size())
          votes.emplace_back(open, !is_odd);
        else if (decided > 0)
          for (Index c : edge.classes)
            if (!is_decided(c))
              votes.emplace_back(c, 2 * walls > decided);
        left.push_back(std::move(edge));
      }
      edges_ = std::move(left);
      is_changed = !votes.empty();
      const std::vector<int> before = votes_;
      for (const auto& [c, is_wall] : votes)
        vote(c, is_wall);
      is_changed = votes_ != before;
    }
  }

  // The first face of a wall, and the first face with the opposite orientation.
  void keep()
  {
    for (Index c = 0; c < number_of_classes(); ++c) {
      if (begin_[c + 1] - begin_[c] == 1)
        continue;
      std::size_t second = begin_[c];
      if (is_doubled_[c] && is_wall(c)) {
        second = begin_[c] + 1;
        for (Index i = begin_[c] + 1; i < begin_[c + 1]; ++i)
          if (is_turned(order_[i]) != is_turned(order_[begin_[c]])) {
            second = i;
            break;
          }
      }
      for (Index i = begin_[c] + 1; i < begin_[c + 1]; ++i)
        is_kept_[order_[i]] = i == second;
    }
  }
  bool is_turned(Index face) const
  {
    const auto& [a, b, c] = triangles_[face];
    return (a < b) + (b < c) + (c < a) == 1;
  }

  const std::vector<Index_triangle>& triangles_;
  std::vector<bool> is_kept_;
  std::vector<Index> order_, begin_; // of the faces, by classes; where each class begins, and the end
  std::vector<bool> is_doubled_;     // of each class
  Disjoint_sets groups_{0};
  std::vector<int> votes_; // of each group, for 2c where c is a class
  std::vector<Edge> edges_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_DOUBLED_FACES_H
