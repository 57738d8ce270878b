// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// What is thinner than the largest deviation is merged in straight triangles.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_STRAIGHT_THIN_PART_MERGER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_STRAIGHT_THIN_PART_MERGER_H

#include "Straight_map.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Merges vertices: the triangles follow, and those with two equal corners vanish. The map from the surface stays linear
// on each intrinsic face, so its deviation is known as before. An edge is contracted if that enlarges the smallest angle
// around it, if the triangles stay a manifold of the same kind, and if the deviation stays within the bound.
class Thin_part_merger
{
public:
  using Triangle = std::array<std::uint32_t, 3>;

  // \param triangles those with three different corners, by vertices of the triangulation; a triangle is removed by
  //   making its corners equal
  // \param faces those of the triangulation that they are
  // \param is_kept whether a small angle of a triangle is to stay
  Thin_part_merger(Straight_map& map, std::vector<Triangle>& triangles, const std::vector<Face_index>& faces,
                   const std::vector<bool>& is_kept, double thin_angle, double maximum_deviation);

  void operator()();

  // How far the points of the surface are from the triangles whose images lie in twins that were removed, or 0.
  Straight_map::Distance distance_of_cancelled() const;

private:
  using Point = std::array<double, 3>;

  // A triangle that was removed with its twin: a side of others, and the corner opposite to it.
  struct Cancelled
  {
    std::uint32_t a, b, c;
    std::array<Face_index, 2> faces;
    std::optional<std::size_t> next{}; // the one that was removed later, with that side
  };

  static bool is_removed(const Triangle& t) { return t[0] == t[1]; }
  bool is_bad(std::uint32_t t) const;
  bool improve(std::uint32_t t);
  bool contract(std::uint32_t from, std::uint32_t to);
  bool is_contractible(std::uint32_t from, std::uint32_t to);
  bool improves(std::uint32_t from, std::uint32_t to) const;
  bool cancel_twin(std::uint32_t t);
  std::vector<std::uint32_t> neighbors(std::uint32_t v) const;
  double height(const Cancelled& triangle) const;
  bool is_on_border(std::uint32_t v) const;
  std::size_t number_of_triangles_at(std::uint32_t v, std::uint32_t w) const;

  Straight_map& map_;
  std::vector<Triangle>& triangles_;
  const std::vector<Face_index>& faces_;
  const std::vector<bool>& is_kept_;
  const double thin_angle_, maximum_deviation_;
  std::vector<std::vector<std::uint32_t>> at_vertex_; // the triangles
  std::vector<std::uint32_t> to_look_at_;
  std::vector<Cancelled> cancelled_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_STRAIGHT_THIN_PART_MERGER_H
