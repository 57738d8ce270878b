// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What double-doubles leave open: multiple precision, and proofs that a number is zero.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_LATE_STAGES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_LATE_STAGES_H

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Stage_counts.h>
#include <CGAL/Intrinsic_triangulations/Unfolding.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/corner_signs.h>
#include <CGAL/Intrinsic_triangulations/internal/metric_images.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// Two corners, named by the halfedges that they are opposite to.
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

template <class Metric>
struct Opposite_corners
{
  typename Unfolding<Metric>::Corner k, l;
};

template <class Metric>
Opposite_corners<Metric> unfolded_corners(const Delta_complex& complex,
                                          const Correspondence& correspondence,
                                          const Two_corners& corners, Metric& metric)
{
  const Unfolding<Metric> unfolding(complex, correspondence, metric);
  return {unfolding.opposite_corner(corners.opposite_to_k),
          unfolding.opposite_corner(corners.opposite_to_l)};
}

class Late_stages
{
public:
  Late_stages(const Delta_complex& complex, const Correspondence& correspondence,
              Input_surface& surface)
    : complex_(complex), correspondence_(correspondence), surface_(surface)
  {}

  struct Decision
  {
    Sign sign;
    Stage stage;
  };

  // The sign of the sum of the cotangents of two corners.
  //
  // A tie is more likely than a difference below 2^-80, and its proof is cheap while there are
  // few roots. With many it is the last resort.
  Decision sign_of_cotangents(const Two_corners& corners) const
  {
    if (const std::optional<Sign> sign = rational_sign(corners))
      return {*sign, Stage::ALGEBRAIC};
    if (const std::optional<Sign> tie = proven_tie(corners, few_roots))
      return {*tie, Stage::ALGEBRAIC};
    for (long precision = 128; precision <= 2048; precision *= 4)
      if (const auto sign = approximate_sign(corners, precision); is_certain(sign))
        return {get_certain(sign), Stage::MULTIPRECISION};
    if (const std::optional<Sign> tie = proven_tie(corners, Root_mask().size()))
      return {*tie, Stage::ALGEBRAIC};
    for (long precision = 8192; precision <= largest_precision; precision *= 2)
      if (const auto sign = approximate_sign(corners, precision); is_certain(sign))
        return {get_certain(sign), Stage::MULTIPRECISION};
    throw Undecided_error(name(corners) + ": the sum of their angles differs from pi by less than 2^-" +
                          std::to_string(largest_precision) +
                          " and cannot be proven to be pi: too many independent square roots");
  }

  // The sign of the area of the face of h.
  Sign sign_of_area(Halfedge_index h) const
  {
    for (long precision = 128; precision <= largest_precision; precision *= 4) {
      const Uncertain<Sign> sign = corner(h, precision).four_areas.sign();
      if (is_certain(sign))
        return get_certain(sign);
      if (precision == 2048 && has_area_zero(h))
        return ZERO;
    }
    throw Undecided_error("face " + std::to_string(complex_.face(h).idx()) +
                          ": the sign of its area cannot be decided");
  }

  bool has_length_zero(Edge_index e) const
  {
    try {
      Square_root_basis basis;
      Multiquadratic_metric field(surface_, {basis});
      return Unfolding<Multiquadratic_metric>(complex_, correspondence_, field)
        .squared_length(e)
        .is_zero();
    } catch (const Too_many_roots&) {
      throw Undecided_error("edge " + std::to_string(e.idx()) +
                            ": whether its length is zero cannot be proven: too many "
                            "independent square roots");
    }
  }

  Mpfr_interval squared_length(Edge_index e, long precision) const
  {
    Mpfr_metric metric(surface_, {precision});
    return Unfolding<Mpfr_metric>(complex_, correspondence_, metric).squared_length(e);
  }

  // The length of e, within one unit in the last place. An interval around a double is two units
  // in its last place wide, however high the precision: then the middle is taken.
  double length(Edge_index e) const
  {
    for (long precision = 128; precision <= 2 * largest_precision; precision *= 2) {
      const Mpfr_interval l = sqrt(squared_length(e, precision));
      const double low = l.lower_double(), high = l.upper_double();
      const double next = std::nextafter(low, high);
      if (high <= next)
        return mpfr_get_d(l.lower(), MPFR_RNDN);
      if (high <= std::nextafter(next, high))
        return next;
    }
    throw Undecided_error("edge " + std::to_string(e.idx()) + ": its length cannot be computed");
  }

  // The middle of an interval around evaluate(corner opposite to h) that is narrow enough, as
  // is_narrow(width, magnitude) says.
  template <class Evaluate, class IsNarrow>
  double number_of_corner(Halfedge_index h, const Evaluate& evaluate,
                          const IsNarrow& is_narrow) const
  {
    for (long precision = 128; precision <= 2 * largest_precision; precision *= 2) {
      const Mpfr_interval x = evaluate(corner(h, precision));
      const double low = x.lower_double(), high = x.upper_double();
      const double magnitude = (std::max)(std::abs(low), std::abs(high));
      if (magnitude < std::numeric_limits<double>::infinity() && is_narrow(high - low, magnitude))
        return low + (high - low) / 2;
    }
    throw Undecided_error("face " + std::to_string(complex_.face(h).idx()) +
                          ": its angles cannot be computed");
  }

private:
  static constexpr long largest_precision = 1l << 16;
  static constexpr std::size_t few_roots = 4;

  Unfolding<Mpfr_metric>::Corner corner(Halfedge_index h, long precision) const
  {
    Mpfr_metric metric(surface_, {precision});
    return Unfolding<Mpfr_metric>(complex_, correspondence_, metric).opposite_corner(h);
  }

  Opposite_corners<Mpfr_metric> approximate_corners(const Two_corners& corners, long precision) const
  {
    Mpfr_metric metric(surface_, {precision});
    return unfolded_corners(complex_, correspondence_, corners, metric);
  }

  Uncertain<Sign> approximate_sign(const Two_corners& corners, long precision) const
  {
    const auto approximate = approximate_corners(corners, precision);
    return internal::sign_of_cotangents(approximate.k, approximate.l);
  }

  // The sign if all roots are rational.
  std::optional<Sign> rational_sign(const Two_corners& corners) const
  {
    try {
      Rational_metric<Rational_image> metric(surface_, {});
      const auto exact = unfolded_corners(complex_, correspondence_, corners, metric);
      const Sign sign = sign_of(exact.k.p * exact.l.four_areas + exact.l.p * exact.k.four_areas);
      return sign != ZERO ? sign : sign_of_tie(sign_of(exact.k.p), sign_of(exact.l.p));
    } catch (const Too_many_roots&) {
      return std::nullopt;
    }
  }
  static Sign sign_of(const Rational& x) { return static_cast<Sign>(x.sign()); }

  // The sign if the edge is proven to be a tie; none says nothing.
  std::optional<Sign> proven_tie(const Two_corners& corners, std::size_t maximum_number_of_roots) const
  {
    try {
      Square_root_basis basis(maximum_number_of_roots);
      Multiquadratic_metric field(surface_, {basis});
      const auto exact = unfolded_corners(complex_, correspondence_, corners, field);
      if (!(exact.k.p * exact.l.four_areas + exact.l.p * exact.k.four_areas).is_zero())
        return std::nullopt;
      // Angles that sum to π, unless both areas are zero.
      return !exact.k.four_areas.is_zero() || exact.k.p.is_zero() || exact.l.p.is_zero()
               ? ZERO
               : sign_between_faces_without_area(corners);
    } catch (const Too_many_roots&) {
      return std::nullopt;
    }
  }

  // The signs of the scalar products tell which of the angles are π.
  Sign sign_between_faces_without_area(const Two_corners& corners) const
  {
    for (long precision = 128; precision <= largest_precision; precision *= 2) {
      const auto approximate = approximate_corners(corners, precision);
      const Uncertain<Sign> k = approximate.k.p.sign(), l = approximate.l.p.sign();
      if (is_certain(k) && is_certain(l))
        return sign_of_tie(get_certain(k), get_certain(l));
    }
    throw Undecided_error(name(corners) + ": their angles are too near to pi/2");
  }

  std::string name(const Two_corners& corners) const
  {
    const auto vertex = [this](Halfedge_index h) {
      return std::to_string(complex_.target(complex_.next(h)).idx());
    };
    return "the corners at vertices " + vertex(corners.opposite_to_k) + " and " +
           vertex(corners.opposite_to_l);
  }

  // A proof that the area of the face of h is zero; `false` proves nothing.
  bool has_area_zero(Halfedge_index h) const
  {
    try {
      Square_root_basis basis;
      Multiquadratic_metric field(surface_, {basis});
      return Unfolding<Multiquadratic_metric>(complex_, correspondence_, field)
        .opposite_corner(h)
        .four_areas.is_zero();
    } catch (const Too_many_roots&) {
      return false;
    }
  }

  const Delta_complex& complex_;
  const Correspondence& correspondence_;
  Input_surface& surface_;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_LATE_STAGES_H
