// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Lengths and cotangents of a triangulation, rounded in the same way whatever was flipped before.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_NUMBERS_ACCURATE_SHAPES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_NUMBERS_ACCURATE_SHAPES_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Engine_numbers.h>
#include <CGAL/Intrinsic_triangulations/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/hinge_formulas.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/triangle_formulas_3.h>
#include <CGAL/Intrinsic_triangulations/internal/numbers/Cotangent_weight.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <optional>

namespace CGAL::Intrinsic_triangulations::internal {

// The apex of a face in units of its longest side: its distances along that side from both ends, and its height. Both
// lengths are stored because in a needle the smaller one would be lost in their difference.
struct Face_apex
{
  double x, rest, height;
};

// The apex from the lengths of the sides of a face, beginning with the longest; nothing if the apex is so low that
// rounding matters.
inline std::optional<Face_apex> apex_by_lengths(const std::array<double, 3>& length)
{
  constexpr double least_height = 0x1p-5;
  const double next = length[1] / length[0], prev = length[2] / length[0];
  const double height = std::sqrt(squared_four_areas_from_lengths(1., next, prev)) / 2;
  if (!(height > least_height))
    return std::nullopt;
  const double x = ((prev - next) * (prev + next) + 1) / 2;
  return Face_apex{x, 1 - x, height};
}

// The same by cotangents.
template <class Shapes>
Face_apex apex_by_cotangents(const Shapes& shapes, const Delta_complex& complex, Halfedge_index base)
{
  const double first = shapes.cotangent(complex.next(base)), second = shapes.cotangent(complex.prev(base)),
               sum = first + second;
  return {first / sum, second / sum, 1 / sum};
}

// As the number type computes them.
template <class Traits>
class Accurate_shapes
{
public:
  explicit Accurate_shapes(const Intrinsic_triangulation<Traits>& triangulation) : triangulation_(triangulation) {}

  // k such that lengths are in units of 2^k units of the input.
  int exponent() const { return 0; }
  double length(Edge_index e) const { return to_double(triangulation_.length(e)); }
  bool has_area(Face_index f) const { return has_positive_area(triangulation_, f); }
  // Opposite to h. \pre its face has an area
  double cotangent(Halfedge_index h) const { return to_double(triangulation_.cotangent(h)); }

private:
  const Intrinsic_triangulation<Traits>& triangulation_;
};

// From the points of the input if they suffice, otherwise from exact geometry. Areas may leave the range of double in
// the unit of the input, so the internal unit is used.
template <>
class Accurate_shapes<Filtered_edge_length_traits>
{
public:
  using Triangulation = Intrinsic_triangulation<Filtered_edge_length_traits>;

  explicit Accurate_shapes(const Triangulation& triangulation)
    : triangulation_(triangulation), complex_(triangulation.connectivity()),
      points_(engine(triangulation).metric().points())
  {}

  int exponent() const { return triangulation_.unit_exponent(); }

  double length(Edge_index e) const
  {
    const Halfedge_index h = complex_.halfedge(e);
    const double square = is_in_space(h) ? squared_distance_3(point(h), point(complex_.opposite(h))) : 0;
    return square > 0x1p-900 ? std::sqrt(square) : std::ldexp(triangulation_.length(e), -exponent());
  }

  bool has_area(Face_index f) const { return has_positive_area(triangulation_, f); }

  double cotangent(Halfedge_index h) const
  {
    const Face_index f = complex_.face(h);
    Engine_numbers::Face_cotangents found;
    Engine_numbers(engine(triangulation_)).find_cotangents(f, found);
    const Halfedge_index first = complex_.halfedge(f);
    const Bounded_double_double& c = found[first == h ? 0 : complex_.next(first) == h ? 1 : 2];
    if (!(c.error() < 0x1p-53 * (1 + std::abs(c.hi()))))
      return triangulation_.cotangent(h);
    return std::abs(c.hi()) > c.error() ? c.hi() : 0;
  }

private:
  // Whether the edge is a straight line between two points of the input.
  bool is_in_space(Halfedge_index h) const
  {
    return complex_.source(h).idx() < points_.size() && complex_.target(h).idx() < points_.size() &&
           triangulation_.is_input_edge(complex_.edge(h));
  }
  const std::array<double, 3>& point(Halfedge_index h) const { return points_[complex_.source(h).idx()]; }

  const Triangulation& triangulation_;
  const Delta_complex& complex_;
  const Input_metric::Point_vector& points_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_NUMBERS_ACCURATE_SHAPES_H
