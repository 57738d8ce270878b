// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// All faces of a triangulation, laid out in the plane relative to each of their sides.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_LAID_OUT_FACES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_LAID_OUT_FACES_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/heat/Places.h>
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

// Several vertices may have the same row, as those of a cover.
class Laid_out_faces
{
public:
  static constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();

  // From (0, 0) to (length, 0), with the face to the left. The three sides of a face are consecutive.
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
      std::array<double, 3> length;
      for (int i = 0; i < 3; ++i) {
        side_of[around[i].idx()] = std::uint32_t(sides_.size() + std::size_t(i));
        halfedges_.push_back(around[i]);
        length[i] = lengths[complex.edge(around[i]).idx()];
      }
      const std::optional<Face_apex> apex = apex_by_lengths(length);
      add_face(complex, row, around, length,
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
  }

  std::size_t number_of_rows() const { return first_.size() - 1; }
  const std::vector<Side>& sides() const { return sides_; }
  const Side& side(std::uint32_t i) const { return sides_[i]; }
  Halfedge_index halfedge(std::uint32_t i) const { return halfedges_[i]; }
  static std::uint32_t next(std::uint32_t i) { return i % 3 == 2 ? i - 2 : i + 1; }
  static std::uint32_t prev(std::uint32_t i) { return i % 3 == 0 ? i + 2 : i - 1; }
  // The next side that begins at the same vertex, to the left or to the right; none beyond a border.
  std::uint32_t left_of(std::uint32_t i) const { return sides_[prev(i)].opposite; }
  std::uint32_t right_of(std::uint32_t i) const { return sides_[i].opposite == none ? none : next(sides_[i].opposite); }
  // Of a side on the border, the next one at the same edge of a surface that was cut there, and after the last one the
  // first; none if there is none.
  std::uint32_t beside(std::uint32_t i) const { return beside_.empty() ? none : beside_[i]; }
  std::size_t number_of_narrow_edges() const { return number_of_narrow_edges_; }
  // Infinite on the border.
  double angle_sum(std::uint32_t vertex) const
  {
    return angle_sums_[vertex] < 0 ? std::numeric_limits<double>::infinity()
                                   : double(angle_sums_[vertex]) / angle_scale;
  }
  // The sides that begin at a row have the numbers corner(i) for i from first_corner(row) to first_corner(row + 1).
  std::uint32_t first_corner(std::uint32_t row) const { return first_[row]; }
  std::uint32_t corner(std::uint32_t i) const { return corners_[i]; }
  // An order independent of numbering: by the positions of the corners of the faces, from the side on.
  bool is_before(std::uint32_t i, std::uint32_t j) const
  {
    for (int corner = 0; corner < 3; ++corner, i = next(i), j = next(j)) {
      const std::uint32_t v = sides_[i].row, w = sides_[j].row;
      if (v != w)
        return places_.is_before(v, w);
    }
    return i < j;
  }
  // k such that lengths are in units of 2^k units of the input.
  int exponent() const { return exponent_; }

private:
  // The one whose corner comes first, if there are several.
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

  static Face_apex apex_of_flat_face(const std::array<double, 3>& length)
  {
    const double sum = length[1] + length[2];
    return {length[2] / sum, length[1] / sum, 0x1p-40};
  }

  template <class Row>
  void add_face(const Delta_complex& complex, const Row& row, const std::array<Halfedge_index, 3>& around,
                const std::array<double, 3>& length, const Face_apex& apex)
  {
    const double x = apex.x * length[0], rest = apex.rest * length[0], height = apex.height * length[0];
    // Of the two sides at each corner.
    const std::array<double, 3> dot{x * length[0], rest * length[0], height * height - x * rest};
    const double cross = height * length[0];
    for (int i = 0; i < 3; ++i) {
      const Vertex_index v = complex.source(around[i]);
      Side side;
      side.vertex = std::uint32_t(v.idx());
      side.row = std::uint32_t(row(v));
      side.length = length[i];
      side.apex_x = dot[i] / length[i];
      side.apex_y = cross / length[i];
      side.angle = std::atan2(cross, dot[i]);
      angle_sums_[v.idx()] += std::int64_t(side.angle * angle_scale);
      sides_.push_back(side);
    }
  }

  void join_cut_sides()
  {
    std::vector<std::array<std::uint32_t, 3>> cut; // two rows, and the side between them
    for (std::uint32_t i = 0; i < sides_.size(); ++i)
      if (sides_[i].opposite == none)
        cut.push_back(
          {(std::min)(sides_[i].row, sides_[next(i)].row), (std::max)(sides_[i].row, sides_[next(i)].row), i});
    std::sort(cut.begin(), cut.end(), [this](const auto& a, const auto& b) {
      return std::make_pair(a[0], a[1]) != std::make_pair(b[0], b[1]) ? a < b : is_before(a[2], b[2]);
    });
    beside_.assign(sides_.size(), none);
    for (std::size_t i = 0, j; i < cut.size(); i = j) {
      for (j = i + 1; j < cut.size() && cut[j][0] == cut[i][0] && cut[j][1] == cut[i][1]; ++j)
        beside_[cut[j - 1][2]] = cut[j][2];
      if (j > i + 1)
        beside_[cut[j - 1][2]] = cut[i][2];
    }
  }

  // Sides along which a face is so thin that ways can circle a needle again and again before they meet a corner.
  void number_narrow_edges()
  {
    for (std::uint32_t i = 0; i < sides_.size(); ++i) {
      if (sides_[i].narrow != none || !(sides_[i].apex_y < sides_[i].length / 16))
        continue;
      const std::uint32_t edge = 2 * std::uint32_t(number_of_narrow_edges_++);
      sides_[i].narrow = edge;
      if (sides_[i].opposite != none)
        sides_[sides_[i].opposite].narrow = edge + 1;
      for (std::uint32_t j = beside(i); j != none && j != i; j = beside(j))
        sides_[j].narrow = edge + (sides_[j].row == sides_[i].row ? 0 : 1);
    }
  }

  void index_corners()
  {
    for (const Side& side : sides_) {
      ++first_[side.row + 1];
      if (side.opposite == none)
        angle_sums_[side.vertex] = angle_sums_[sides_[next(std::uint32_t(&side - sides_.data()))].vertex] = -1;
    }
    for (std::size_t v = 0; v + 1 < first_.size(); ++v)
      first_[v + 1] += first_[v];
    corners_.resize(sides_.size());
    std::vector<std::uint32_t> position(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < sides_.size(); ++i)
      corners_[position[sides_[i].row]++] = std::uint32_t(i);
    // If two ways along edges reach the same row at once, the first one counts.
    for (std::size_t row = 0; row + 1 < first_.size(); ++row) {
      const auto begin = corners_.begin() + first_[row], end = corners_.begin() + first_[row + 1];
      if (end - begin > 16 || has_edges_to_same_row(begin, end))
        std::sort(begin, end, [this](std::uint32_t i, std::uint32_t j) { return is_before(i, j); });
    }
  }

  template <class Corner>
  bool has_edges_to_same_row(Corner begin, Corner end) const
  {
    for (Corner i = begin; i != end; ++i)
      for (Corner j = begin; j != i; ++j)
        if (sides_[prev(*i)].row == sides_[prev(*j)].row)
          return true;
    return std::any_of(begin, end, [this](std::uint32_t side) { return sides_[side].opposite == none; });
  }

  static constexpr double angle_scale = 0x1p50;

  Places places_;
  std::vector<Side> sides_;
  std::vector<Halfedge_index> halfedges_; // of the sides
  std::vector<std::int64_t> angle_sums_;  // by vertex; as integers they are the same in any order, and -1 on the border
  std::vector<std::uint32_t> first_, corners_;
  std::vector<std::uint32_t> beside_; // of the sides, if the surface was cut
  std::size_t number_of_narrow_edges_ = 0;
  int exponent_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_LAID_OUT_FACES_H
