// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The stages after double-doubles: multiple precision, and proofs that a number is zero.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_DECIDE_EXACT_FALLBACK_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_DECIDE_EXACT_FALLBACK_H

#include <CGAL/Intrinsic_triangulations/internal/engine/history/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include "../layout/Unfolding.h"
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/squared_lengths.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Crossed_halfedges.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Input_edge_walk.h>
#include "Ladder.h"
#include "Parallel_folds.h"
#include "Mirror_symmetry.h"
#include "corner_signs.h"
#include "../layout/metric_images.h"

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

// Two corners, named by the opposite halfedges.
struct Two_corners
{
  Halfedge_index opposite_to_k, opposite_to_l;
};

// The corners opposite to an edge, k to its left and l to its right.
inline Two_corners corners_beside(const Delta_complex& complex, Edge_index e)
{
  const Halfedge_index h = complex.halfedge(e);
  return {h, complex.opposite(h)};
}

// Whether two corners lie opposite to one edge.
inline bool is_hinge(const Delta_complex& complex, const Two_corners& corners)
{
  return complex.opposite(corners.opposite_to_k) == corners.opposite_to_l;
}

template <class Metric>
internal::Opposite_corners<typename Metric::Real> unfolded_corners(const Unfolding<Metric>& unfolding,
                                                                   const Two_corners& corners)
{
  return {unfolding.opposite_corner(corners.opposite_to_k), unfolding.opposite_corner(corners.opposite_to_l)};
}

class Exact_fallback
{
public:
  Exact_fallback(const Delta_complex& complex, const Correspondence& correspondence, Input_surface& surface)
    : complex_(complex), correspondence_(correspondence), surface_(surface)
  {}

  // The sign of the sum of the cotangents of two corners. Most areas are known from their layouts before.
  Exact_decision sign_of_cotangents(const Two_corners& corners, const Opposite_corners<Bounded_double_double>& known)
  {
    const auto sum = [&](auto& metric) {
      const auto c = unfolded_corners(unfolding(metric), corners);
      return c.k.p * c.l.four_areas + c.l.p * c.k.four_areas;
    };
    const Exact_number number(surface_, sum, [&] { return may_be_rational(corners.opposite_to_k); });
    const auto has_positive_area = [this](Halfedge_index h, const auto& corner) {
      return certainly(corner.four_areas.sign() == POSITIVE) || sign_of_area(h) == POSITIVE;
    };
    const auto has_parallel_folds = [&] { return is_level(corners) || is_trapezoid(corners); };
    const auto is_symmetric = [&] {
      return is_hinge(complex_, corners) &&
             Mirror_symmetry(complex_, correspondence_, surface_)(complex_.edge(corners.opposite_to_k)) &&
             has_positive_area(corners.opposite_to_k, known.k) && has_positive_area(corners.opposite_to_l, known.l);
    };
    const auto what = [&] { return name(corners) + ": that the sum of their angles is pi"; };
    const Exact_decision decision = sign_by_exact_stages(number, {has_parallel_folds, is_symmetric}, what);
    if (decision.sign != ZERO || has_positive_area(corners.opposite_to_k, known.k))
      return decision;
    // Both areas are zero: the signs of the scalar products tell which of the angles are π.
    return {sign_of_tie(sign_of_scalar_product(corners.opposite_to_k), sign_of_scalar_product(corners.opposite_to_l)),
            decision.stage, decision.is_rational};
  }

  // The sign of the area of the face of h.
  Sign sign_of_area(Halfedge_index h) { return sign_of_corner(h, true); }

  // The sign of the scalar product of the two sides that meet in the corner opposite to h.
  Sign sign_of_scalar_product(Halfedge_index h) { return sign_of_corner(h, false); }

  bool has_length_zero(Edge_index e)
  {
    const auto squared_length = [&](auto& metric) { return unfolding(metric).squared_length(e); };
    const auto what = [&] { return "edge " + std::to_string(e.idx()) + ": that its length is zero"; };
    return sign_by_exact_stages(Exact_number(surface_, squared_length), {}, what).sign == ZERO;
  }

  Mpfr_interval squared_length(Edge_index e, long precision)
  {
    Mpfr_metric& metric = surface_.mpfr_metric(precision);
    return unfolding(metric).squared_length(e);
  }

  // The length of e, rounded as rounded() rounds a number with a bound. Roots that agree with the middle of two doubles
  // for many digits, which no known input has, err by one unit in the last place.
  double length(Edge_index e)
  {
    constexpr long largest_precision = 1 << 14;
    for (long precision = 128;; precision = doubled(precision)) {
      Mpfr_interval l = sqrt(squared_length(e, precision));
      l = l + ldexp(l, -75);
      const double low = mpfr_get_d(l.lower(), MPFR_RNDN), high = mpfr_get_d(l.upper(), MPFR_RNDN);
      if (low == high || (precision > largest_precision && high <= std::nextafter(low, high)))
        return low;
    }
  }

  // As narrowed() of evaluate(corner opposite to h).
  // \pre the face of h has positive area, or evaluate() does not divide by it
  template <class Evaluate, class IsNarrow>
  double number_of_corner(Halfedge_index h, const Evaluate& evaluate, const IsNarrow& is_narrow)
  {
    return narrowed([&](Mpfr_metric& metric) { return evaluate(unfolding(metric).opposite_corner(h)); }, is_narrow,
                    complex_.face(h), 128);
  }

  // \pre the face of h has positive area
  template <class IsNarrow>
  double cotangent(Halfedge_index h, const IsNarrow& is_narrow)
  {
    return number_of_corner(
      h, [](const auto& corner) { return corner.p / corner.four_areas; }, is_narrow);
  }

  // The exponent of a power of two by which numbers of the corner are scaled into the range of double, however small
  // the face: the larger one becomes about 1.
  // \pre the face of h has positive area
  long scale_of_corner(Halfedge_index h)
  {
    constexpr long largest_width = 64; // of an interval, in powers of two
    for (long precision = 128;; precision = doubled(precision)) {
      Mpfr_metric& metric = surface_.mpfr_metric(precision);
      const auto c = unfolding(metric).opposite_corner(h);
      if (!is_certain(c.four_areas.sign()))
        continue;
      long least = long(mpfr_get_exp(c.four_areas.lower())), most = long(mpfr_get_exp(c.four_areas.upper()));
      for (mpfr_srcptr end : {c.p.lower(), c.p.upper()})
        if (!mpfr_zero_p(end))
          most = (std::max)(most, mpfr_regular_p(end) ? long(mpfr_get_exp(end)) : most + 2 * largest_width);
      if (is_certain(c.p.sign()) && get_certain(c.p.sign()) != ZERO)
        least = (std::max)(least, long(mpfr_get_exp(get_certain(c.p.sign()) == POSITIVE ? c.p.lower() : c.p.upper())));
      if (most - least <= largest_width)
        return -most;
    }
  }

  // The sum of the cotangents of two corners to the last places, however small, and with the right sign.
  // \pre both faces have positive area, and the sum is not zero
  double sum_of_cotangents(const Two_corners& corners)
  {
    const auto sum = [&](Mpfr_metric& metric) {
      const auto c = unfolded_corners(unfolding(metric), corners);
      return c.k.p / c.k.four_areas + c.l.p / c.l.four_areas;
    };
    return narrowed(
      sum, [](double width, double magnitude) { return width <= 0x1p-50 * magnitude; },
      complex_.face(corners.opposite_to_k), 256);
  }

private:
  // Whether two corners at one vertex are proven to form an angle of π, or of 0.
  bool is_level(const Two_corners& corners)
  {
    for (const auto& [g, h] : {std::pair(corners.opposite_to_k, corners.opposite_to_l),
                               std::pair(corners.opposite_to_l, corners.opposite_to_k)})
      if (complex_.opposite(complex_.next(g)) == complex_.prev(h))
        return Parallel_folds(complex_, correspondence_, surface_)
          .are_level(complex_.prev(g), complex_.opposite(complex_.next(h)));
    return false;
  }

  bool is_trapezoid(const Two_corners& corners)
  {
    return is_hinge(complex_, corners) &&
           Parallel_folds(complex_, correspondence_, surface_).is_trapezoid(complex_.edge(corners.opposite_to_k));
  }

  static constexpr double smallest = 0x1p-1074;

  static bool is_tiny(const Mpfr_interval& x)
  {
    return is_certain(x.sign()) && x.lower_double() >= -smallest && x.upper_double() <= smallest;
  }

  // The middle of an interval around evaluate(metric) that is narrow enough by is_narrow(width, magnitude), or as
  // narrow as intervals around subnormal numbers can be. Numbers too small for a double are rounded away from zero.
  // \param f the face of the number
  // \param precision the precision of the first attempt
  // \exception Invalid_surface_error if the number leaves the range of double
  template <class Evaluate, class IsNarrow>
  double narrowed(const Evaluate& evaluate, const IsNarrow& is_narrow, Face_index f, long precision)
  {
    for (;; precision = doubled(precision)) {
      Mpfr_metric& metric = surface_.mpfr_metric(precision);
      const Mpfr_interval x = evaluate(metric);
      if (is_tiny(x))
        return int(get_certain(x.sign())) * smallest;
      const double low = x.lower_double(), high = x.upper_double();
      const double magnitude = (std::max)(std::abs(low), std::abs(high));
      // If the sign is open, the middle could be zero.
      const bool is_as_narrow_as_can_be = high - low <= 2 * smallest && is_certain(x.sign());
      if (magnitude < std::numeric_limits<double>::infinity() &&
          (is_narrow(high - low, magnitude) || is_as_narrow_as_can_be))
        return low + (high - low) / 2;
      require_range(x, f);
    }
  }

  static void require_range(const Mpfr_interval& x, Face_index f)
  {
    const double largest = (std::numeric_limits<double>::max)();
    if (x.lower_double() >= largest || x.upper_double() <= -largest)
      throw Invalid_surface_error(Invalid_surface_error::Defect::OUT_OF_RANGE, f.idx(), 1,
                                  "face " + std::to_string(f.idx()) +
                                    " is so thin that a cotangent leaves the range of double: remove it, or mollify "
                                    "the lengths first");
  }

  template <class Metric>
  Unfolding<Metric> unfolding(Metric& metric)
  {
    return Unfolding<Metric>(complex_, correspondence_, metric);
  }

  // Whether the area of the input face next to the corner is rational. If it is not, an attempt to lay the corner out in
  // rationals would end there.
  bool may_be_rational(Halfedge_index opposite_to_corner) const
  {
    const Face_index f = uncrossed_input_face(complex_, correspondence_, complex_.prev(opposite_to_corner));
    return is_square(squared_four_areas(surface_.metric(), surface_.connectivity(), f));
  }

  Sign sign_of_corner(Halfedge_index h, bool of_area)
  {
    const auto value = [&](auto& metric) {
      const auto corner = unfolding(metric).opposite_corner(h);
      return of_area ? corner.four_areas : corner.p;
    };
    return exact_sign(surface_, value, [&] {
      return "face " + std::to_string(complex_.face(h).idx()) + ": that its " + (of_area ? "area" : "scalar product") +
             " is zero";
    });
  }

  std::string name(const Two_corners& corners) const
  {
    const auto vertex = [this](Halfedge_index h) { return std::to_string(complex_.target(complex_.next(h)).idx()); };
    return "the corners at vertices " + vertex(corners.opposite_to_k) + " and " + vertex(corners.opposite_to_l);
  }

  const Delta_complex& complex_;
  const Correspondence& correspondence_;
  Input_surface& surface_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_DECIDE_EXACT_FALLBACK_H
