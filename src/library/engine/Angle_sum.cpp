// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Angle_sum.h.

#include <CGAL/Intrinsic_triangulations/internal/engine/Angle_sum.h>
#include "layout/Unfolding.h"
#include "decide/Ladder.h"
#include "decide/Parallel_folds.h"
#include "layout/metric_images.h"

#include <string>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations::internal {

// The numbers p + i a of the corners have the angles as arguments. So the argument of the product of the first n is the
// sum of n angles, up to multiples of 2π. This is unambiguous if corners are added one by one: a sum below π and an
// angle of at most π add up to less than 2π.
class Angle_sum_signs
{
public:
  Angle_sum_signs(const Exact_engine& engine, const std::vector<Estimated_corner>& corners)
    : complex_(engine.connectivity()), engine_(engine), corners_(corners), surface_(engine.input_surface())
  {}

  // The signs of the sine and of the cosine of the sum of the corners from `first` to before `last`.
  Sign sine(std::size_t first, std::size_t last)
  {
    return sign(first, last, [](const auto& z) { return z.y(); });
  }
  Sign cosine(std::size_t first, std::size_t last)
  {
    return sign(first, last, [](const auto& z) { return z.x(); });
  }

  // Whether the sum is proven to be a multiple of π.
  bool is_level(std::size_t first, std::size_t last)
  {
    const Halfedge_index from = complex_.prev(corners_[first].opposite),
                         to = complex_.opposite(complex_.next(corners_[last - 1].opposite));
    return Parallel_folds(complex_, engine_.correspondence(), *surface_).are_level(from, to);
  }

private:
  template <class Part>
  Sign sign(std::size_t first, std::size_t last, const Part& part)
  {
    const auto evaluate = [&](auto& metric) {
      using Metric = std::decay_t<decltype(metric)>;
      using Vector = typename Metric::Vector;
      const Unfolding<Metric> unfolding(complex_, engine_.correspondence(), metric);
      const auto vector = [&](std::size_t i) {
        const auto corner = unfolding.opposite_corner(corners_[i].opposite);
        return Vector(corner.p, corner.four_areas);
      };
      Vector product = vector(first);
      for (std::size_t i = first + 1; i < last; ++i)
        product = product * vector(i);
      return part(product);
    };
    return exact_sign(*surface_, evaluate, [&] {
      return "the corners at vertex " + std::to_string(complex_.target(complex_.next(corners_[first].opposite)).idx()) +
             ": that the sum of their angles is pi";
    });
  }

  const Delta_complex& complex_;
  const Exact_engine& engine_;
  const std::vector<Estimated_corner>& corners_;
  Surface_lease surface_;
};

Comparison_result compare_angle_sum_with_pi(const Exact_engine& engine, const std::vector<Estimated_corner>& corners)
{
  Angle_sum_signs signs(engine, corners);
  Bounded_angle sum;
  bool is_straight = false; // the sum so far is π
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (is_straight) {
      if (signs.sine(i, i + 1) != ZERO || signs.cosine(i, i + 1) == NEGATIVE)
        return LARGER;
      continue;
    }
    sum += corners[i].angle;
    if (sum.is_above_pi())
      return LARGER;
    if (sum.is_below_pi())
      continue;
    const Sign sine = signs.is_level(0, i + 1) ? ZERO : signs.sine(0, i + 1);
    if (sine == NEGATIVE)
      return LARGER;
    is_straight = sine == ZERO && (sum.is_near_pi() || signs.cosine(0, i + 1) == NEGATIVE);
  }
  return is_straight ? EQUAL : SMALLER;
}

} // namespace CGAL::Intrinsic_triangulations::internal
