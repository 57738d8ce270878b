// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// All faces of a triangulation, laid out in the plane relative to each of their sides.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_LAID_OUT_FACES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_LAID_OUT_FACES_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/distances/Places.h>
#include <CGAL/Intrinsic_triangulations/internal/numbers/Accurate_shapes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Several vertices may have the same row, as in a cover.
class Laid_out_faces
{
public:
  static constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();

  // A side runs from (0, 0) to (length, 0), with the face to its left. The three sides of a face are consecutive.
  struct Side
  {
    std::uint32_t opposite = none; // none on the border
    std::uint32_t vertex, row;     // where it begins
    std::uint32_t narrow = none;   // twice the number of its edge if it is narrow, plus 1 if it runs backward
    double length, apex_x, apex_y, angle;
  };

  // \tparam Row gives the row of a vertex, as Row_of_vertex
  template <class Traits, class Row>
  Laid_out_faces(const Intrinsic_triangulation<Traits>& triangulation, const Row& row)
    : places_(triangulation, row), angle_sums_(triangulation.connectivity().number_of_vertices(), 0),
      first_(row.number_of_rows() + 1, 0)
  {
    const Delta_complex& complex = triangulation.connectivity();
    const Accurate_shapes<Traits> shapes(triangulation);
    exponent_ = shapes.exponent();
    std::vector<double> lengths;
    lengths.reserve(complex.number_of_edges());
    for (Edge_index e : complex.edges())
      lengths.push_back(shapes.length(e));
    std::vector<std::uint32_t> side_of(complex.number_of_halfedges(), none);
    sides_.reserve(3 * complex.number_of_faces());
    halfedges_.reserve(3 * complex.number_of_faces());
    for (Face_index f : complex.faces()) {
      const Halfedge_index base = longest_side(complex, row, complex.halfedge(f), lengths);
      const std::array<Halfedge_index, 3> around{base, complex.next(base), complex.prev(base)};
      Corners corners;
      std::array<double, 3> length;
      for (int i = 0; i < 3; ++i) {
        const Vertex_index v = complex.source(around[i]);
        corners[i] = {std::uint32_t(v.idx()), std::uint32_t(row(v))};
        side_of[around[i].idx()] = std::uint32_t(sides_.size() + std::size_t(i));
        halfedges_.push_back(around[i]);
        length[i] = lengths[complex.edge(around[i]).idx()];
      }
      const std::optional<Face_apex> apex = apex_by_lengths(length);
      add_face(corners, length,
               apex                 ? *apex
               : shapes.has_area(f) ? apex_by_cotangents(shapes, complex, base)
                                    : apex_of_flat_face(length));
    }
    for (Halfedge_index h : complex.halfedges())
      if (side_of[h.idx()] != none)
        sides_[side_of[h.idx()]].opposite = side_of[complex.opposite(h).idx()];
    if (row.is_cut())
      join_cut_sides();
    number_narrow_edges();
    index_corners();
    row.for_each_flat_edge(
      [this](std::uint32_t v, std::uint32_t w, double length) { add_flat_edge(v, w, std::ldexp(length, -exponent_)); });
    index_flat_edges();
  }

  std::size_t number_of_rows() const { return first_.size() - 1; }
  const std::vector<Side>& sides() const { return sides_; }
  const Side& side(std::uint32_t i) const { return sides_[i]; }
  // An edge without faces has a side at each end, and a third one that stands for nothing. All come last.
  bool is_flat_edge(std::uint32_t i) const { return i >= halfedges_.size(); }
  // The number of a flat edge, and the side at its other end.
  std::size_t flat_edge(std::uint32_t i) const { return (i - halfedges_.size()) / 3; }
  std::uint32_t other_end(std::uint32_t i) const { return i % 3 == 0 ? i + 1 : i - 1; }
  // The flat edges from the first one at this row on, as (row, side).
  std::vector<std::pair<std::uint32_t, std::uint32_t>>::const_iterator flat_edges_at(std::uint32_t row) const
  {
    return std::lower_bound(flat_edges_.begin(), flat_edges_.end(), std::make_pair(row, std::uint32_t(0)));
  }
  const std::vector<std::pair<std::uint32_t, std::uint32_t>>& flat_edges() const { return flat_edges_; }
  Halfedge_index halfedge(std::uint32_t i) const { return halfedges_[i]; }
  static std::uint32_t next(std::uint32_t i) { return i % 3 == 2 ? i - 2 : i + 1; }
  static std::uint32_t prev(std::uint32_t i) { return i % 3 == 0 ? i + 2 : i - 1; }
  // The next side that begins at the same vertex, to the left or to the right; none beyond a border.
  std::uint32_t left_of(std::uint32_t i) const { return sides_[prev(i)].opposite; }
  std::uint32_t right_of(std::uint32_t i) const { return sides_[i].opposite == none ? none : next(sides_[i].opposite); }
  // For a side where the surface was cut: the next side at the same edge, cyclically; none if it is the only one.
  std::uint32_t beside(std::uint32_t i) const { return beside_.empty() ? none : beside_[i]; }
  std::size_t number_of_narrow_edges() const { return number_of_narrow_edges_; }
  double longest_side() const;
  // The sum of the angles at a vertex; infinite on the border.
  double angle_sum(std::uint32_t vertex) const
  {
    return angle_sums_[vertex] < 0 ? std::numeric_limits<double>::infinity()
                                   : double(angle_sums_[vertex]) / angle_scale;
  }
  // The sides that begin at a row have the numbers corner(i) for i from first_corner(row) to first_corner(row + 1).
  std::uint32_t first_corner(std::uint32_t row) const { return first_[row]; }
  std::uint32_t corner(std::uint32_t i) const { return corners_[i]; }
  // An order independent of numbering: by the positions of the corners of the faces, from the side on.
  bool is_before(std::uint32_t i, std::uint32_t j) const;
  // k such that lengths are in units of 2^k units of the input.
  int exponent() const { return exponent_; }

private:
  using Corners = std::array<std::pair<std::uint32_t, std::uint32_t>, 3>; // vertices, and their rows

  // The longest side of a face; if there are several, the one whose corner comes first.
  template <class Row>
  Halfedge_index longest_side(const Delta_complex& complex, const Row& row, Halfedge_index first,
                              const std::vector<double>& lengths) const
  {
    Halfedge_index result = first;
    for (Halfedge_index h : {complex.next(first), complex.prev(first)}) {
      const double length = lengths[complex.edge(h).idx()], longest = lengths[complex.edge(result).idx()];
      if (length > longest || (length == longest && places_.is_before(std::uint32_t(row(complex.source(h))),
                                                                      std::uint32_t(row(complex.source(result))))))
        result = h;
    }
    return result;
  }

  static Face_apex apex_of_flat_face(const std::array<double, 3>& length);
  void add_face(const Corners& corners, const std::array<double, 3>& length, const Face_apex& apex);
  void join_cut_sides();
  void number_narrow_edges();
  void index_corners();
  void add_flat_edge(std::uint32_t v, std::uint32_t w, double length);
  void index_flat_edges();
  bool has_edges_to_same_row(std::uint32_t begin, std::uint32_t end) const;

  static constexpr double angle_scale = 0x1p50;

  Places places_;
  std::vector<Side> sides_;
  std::vector<Halfedge_index> halfedges_; // of the sides
  std::vector<std::int64_t> angle_sums_;  // by vertex, -1 on the border; sums of integers in any order are equal
  std::vector<std::uint32_t> first_, corners_;
  std::vector<std::uint32_t> beside_; // of the sides, if the surface was cut
  std::vector<std::pair<std::uint32_t, std::uint32_t>> flat_edges_;
  std::size_t number_of_narrow_edges_ = 0;
  int exponent_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_LAID_OUT_FACES_H
