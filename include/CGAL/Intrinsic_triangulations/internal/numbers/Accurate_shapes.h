// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Lengths and cotangents of a triangulation: the stored numbers where they are good enough, and exact geometry
// elsewhere.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_NUMBERS_ACCURATE_SHAPES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_NUMBERS_ACCURATE_SHAPES_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Engine_numbers.h>

#include <CGAL/Uncertain.h>
#include <CGAL/number_utils.h>

#include <cmath>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// By the number type.
template <class Traits>
class Accurate_shapes
{
public:
  explicit Accurate_shapes(const Intrinsic_triangulation<Traits>& triangulation) : triangulation_(triangulation) {}

  // k such that lengths are in units of 2^k units of the input.
  int exponent() const { return 0; }
  double length(Edge_index e) const { return to_double(triangulation_.length(e)); }
  bool has_area(Face_index f) const { return certainly(triangulation_.area(f) > typename Traits::FT(0)); }
  // Opposite to h. \pre its face has an area
  double cotangent(Halfedge_index h) const { return to_double(triangulation_.cotangent(h)); }

private:
  const Intrinsic_triangulation<Traits>& triangulation_;
};

// Areas may leave the range of double in the unit of the input, so the internal one is used.
template <>
class Accurate_shapes<Filtered_edge_length_traits>
{
  // Far below the error of any method that uses the numbers, and far above that of fresh ones.
  static constexpr double accuracy = 0x1p-42;

public:
  using Triangulation = Intrinsic_triangulation<Filtered_edge_length_traits>;

  explicit Accurate_shapes(const Triangulation& triangulation)
    : triangulation_(triangulation), complex_(triangulation.connectivity())
  {}

  int exponent() const { return triangulation_.unit_exponent(); }

  double length(Edge_index e) const
  {
    const double s = triangulation_.edge_data(e);
    const Halfedge_index h = complex_.halfedge(e);
    for (Halfedge_index side : {h, complex_.opposite(h)})
      if (!complex_.is_border(side) && triangulation_.face_data(complex_.face(side)).error <= accuracy * s)
        return std::sqrt(s);
    return std::ldexp(triangulation_.length(e), -exponent());
  }

  bool has_area(Face_index f) const
  {
    const Bounded_area& area = triangulation_.face_data(f);
    return area.value > area.error || engine(triangulation_).sign_of_area(f) == POSITIVE;
  }

  double cotangent(Halfedge_index h) const
  {
    const auto stored = triangulation_.traits().compute_bounded_cotangent_object()(
      triangulation_.face_data(complex_.face(h)), triangulation_.edge_data(complex_.edge(h)),
      triangulation_.edge_data(complex_.edge(complex_.next(h))),
      triangulation_.edge_data(complex_.edge(complex_.prev(h))));
    return stored.error <= accuracy * (1 + std::abs(stored.value)) ? stored.value : triangulation_.cotangent(h);
  }

private:
  const Triangulation& triangulation_;
  const Delta_complex& complex_;
};

// All of them at once, and so accurate that they are rounded alike whatever was flipped before.
template <class Traits>
class Rounded_shapes : public Accurate_shapes<Traits>
{
public:
  using Accurate_shapes<Traits>::Accurate_shapes;
};

template <>
class Rounded_shapes<Filtered_edge_length_traits> : public Accurate_shapes<Filtered_edge_length_traits>
{
public:
  explicit Rounded_shapes(const Triangulation& triangulation)
    : Accurate_shapes(triangulation), triangulation_(triangulation), numbers_(triangulation.connectivity())
  {
    Engine_numbers(engine(triangulation)).find_numbers(0, triangulation.connectivity().number_of_faces(), numbers_);
  }

  double length(Edge_index e) const
  {
    const double known = numbers_.lengths[e.idx()];
    return std::ldexp(std::isnan(known) ? triangulation_.length(e) : known, -exponent());
  }

  double cotangent(Halfedge_index h) const
  {
    const auto& [hi, lo, error] = numbers_.cotangents[h.idx()];
    return error < 0x1p-53 * (1 + std::abs(hi)) ? (std::abs(hi) > error ? hi : 0) : triangulation_.cotangent(h);
  }

private:
  const Triangulation& triangulation_;
  Rounded_numbers numbers_;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_NUMBERS_ACCURATE_SHAPES_H
