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
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Triangles by vertices of the triangulation. A removed one has equal corners.
struct Straight_triangles
{
  using Triangle = std::array<std::uint32_t, 3>;

  std::vector<Triangle> triangles;
  std::vector<Face_index> faces; // of the triangulation: where a triangle belongs
  std::vector<bool> is_kept;     // whether a small angle is to stay
  std::vector<std::array<std::uint32_t, 2>> marked_edges;
  std::vector<bool> is_fixed; // whether a vertex must not move, or empty
};

// Improves thin triangles, as long as no point of the surface moves farther than the bound:
// - It contracts edges. As vertices are merged, the map from the surface stays linear on each intrinsic face, so its
//   deviation is known as before.
// - It cuts caps: the longest side of a triangle is bent to the corner near it, which the triangle beyond follows.
// - Where four triangles meet at an edge, as around a thin tube, it separates the two sheets.
// - It removes pieces that then lie beside others.
//
// From the second on, each triangle has a bound for how far the points have moved whose images it has, and each later
// step adds its own distance.
class Thin_part_merger
{
public:
  using Triangle = Straight_triangles::Triangle;

  Thin_part_merger(Straight_map& map, Straight_triangles& mesh, double thin_angle, double maximum_deviation);

  // \return the largest distance of a point of the surface from its image
  Straight_map::Distance operator()();
  std::size_t number_of_removed_pieces() const { return number_of_removed_pieces_; }
  // A deviation with which other pieces would be removed, or 0.
  double sufficient_deviation() const { return sufficient_deviation_; }
  // How many edges of the border were replaced by two.
  std::size_t number_of_bent_border_edges() const { return number_of_bent_border_edges_; }

private:
  using Point = std::array<double, 3>;
  using Side = std::pair<std::uint32_t, std::uint32_t>;

  static bool is_removed(const Triangle& t) { return t[0] == t[1]; }
  bool is_bad(std::uint32_t t) const;
  bool improve(std::uint32_t t);

  Straight_map::Distance largest_distance() const;
  bool contract(std::uint32_t from, std::uint32_t to);
  bool is_contractible(std::uint32_t from, std::uint32_t to);
  bool improves(std::uint32_t from, std::uint32_t to) const;

  bool cut_cap(std::uint32_t t);

  bool separate(std::uint32_t v, std::uint32_t w);
  void separate_fans(std::uint32_t v);
  void move_to_copy(std::uint32_t v, const std::vector<std::uint32_t>& triangles);

  std::vector<std::vector<std::uint32_t>> bad_pieces() const;
  void remove_pieces();
  void merge_removed_vertices();
  bool is_near_others(const std::array<Point, 3>& corners, const std::vector<std::uint32_t>& others, double distance,
                      int depth) const;

  double moved(std::uint32_t t) const;
  void set_moved(std::uint32_t t, double distance) { moved_[t] = distance; }
  void hand_on(std::uint32_t t, std::uint32_t v, std::uint32_t w);

  double length(std::uint32_t v, std::uint32_t w) const;
  std::vector<std::uint32_t> neighbors(std::uint32_t v) const;
  std::vector<std::uint32_t> triangles_at(std::uint32_t v, std::uint32_t w) const;
  std::size_t number_of_triangles_at(std::uint32_t v, std::uint32_t w) const { return triangles_at(v, w).size(); }
  bool is_on_border(std::uint32_t v) const;
  bool is_fixed(std::uint32_t v) const { return v < mesh_.is_fixed.size() && mesh_.is_fixed[v]; }
  void replace(std::uint32_t t, const Triangle& corners);
  void look_at(std::uint32_t v);

  Straight_map& map_;
  Straight_triangles& mesh_;
  const double thin_angle_, maximum_deviation_;
  std::vector<std::vector<std::uint32_t>> at_vertex_; // the triangles
  std::vector<std::vector<std::uint32_t>> marked_;    // the vertices at the other ends of marked edges
  std::vector<double> moved_;                         // of a triangle, if it is not what the map says
  // Faces whose images lie on an edge of a triangle, which has taken them from one that vanished.
  std::unordered_map<std::uint32_t, std::vector<Face_index>> taken_;
  std::vector<std::uint32_t> to_look_at_;
  Straight_map::Distance removed_; // of pieces that were removed
  std::vector<std::uint32_t> removed_vertices_;
  double sufficient_deviation_ = 0;
  std::size_t number_of_removed_pieces_ = 0, number_of_bent_border_edges_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_STRAIGHT_THIN_PART_MERGER_H
