// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Squared lengths and areas in double, with a bound on their errors for each face.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FILTERED_EDGE_LENGTH_TRAITS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FILTERED_EDGE_LENGTH_TRAITS_H

#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/hinge_formulas.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/With_error.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Two_doubles.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/Cotangent_bounds.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/triangle_formulas_3.h>

#include <CGAL/Uncertain.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsTraits
/// \brief a double and an upper bound on its absolute error.
struct Bounded_double
{
  double value; ///< the number
  double error; ///< an upper bound on its absolute error
};

/// \ingroup PkgIntrinsicTriangulationsTraits
/// \brief what `Filtered_edge_length_traits` stores for a face.
struct Bounded_area
{
  double value; ///< four times the area
  double error; ///< more than the error of `value`, and more than the sum of the errors of the
                ///< squared lengths of the three sides
};

/// \cond SKIP_IN_MANUAL
namespace internal {

// The data of two faces.
struct Two_bounded_areas
{
  Two_doubles value, error;
  Bounded_area first() const { return {value.first(), error.first()}; }
  Bounded_area second() const { return {value.second(), error.second()}; }
};

} // namespace internal

inline internal::Two_bounded_areas two(const Bounded_area& a, const Bounded_area& b)
{
  return {{a.value, b.value}, {a.error, b.error}};
}
/// \endcond

/// \ingroup PkgIntrinsicTriangulationsTraits
///
/// \brief the metric of a triangulation in double, with exact decisions.
///
/// Every Delaunay test is exact for the piecewise-flat surface that the input defines, however many flips came before.
/// The functors below are the first stage: they keep a running error bound for each face and answer if it suffices. If
/// it does not, `Intrinsic_triangulation` asks its exact engine, whose result replaces the stored numbers.
///
/// Invariants: let s be the stored squared lengths of the three sides of a face, a the stored
/// value of four times its area, E its error bound, and s*, a* the true numbers. With u = 2^-53,
///
///     (1)  E >= 1.5 (sum of max(|s - s*|, 6 u s))
///     (2)  E >= 1.5 |a - a*|
///     (3)  E >= 12 u (sum of s).
///
/// One bound for a face suffices for its sides as well, because the number computed from them,
/// p = s + s' - s'', collects the errors of all three. The factor 1.5 and (3) let the bound cover
/// rounding, too: since a* <= (sum of s*) / √3, u |a| is less than E / 20, and the error of a
/// computed p is less than E / 1.5 + 2 u (sum of s) <= 0.84 E. Because of the maximum in (1), a side
/// may be replaced by a number with a relative error of 6 u, as it has initially, without
/// looking at the face beyond it.
///
/// \cgalModels{IntrinsicTriangulationTraits}
class Filtered_edge_length_traits
{
  static constexpr double u = 0x1p-53;
  // Covers underflow; in the unit of length, ordinary values are far above this.
  static constexpr double tiny = 1e-200;
  // Covers the underflow of the radicand of an area: with factors up to 2^104 after it, the radicand is wrong by less
  // than 2^-970.
  static constexpr double tiny_root = 1e-140;
  // A divisor must be this far from underflow.
  static constexpr double smallest_divisor = 1e-100;

public:
  /// the number type
  using FT = double;
  /// squared length
  using Edge_data = double;
  /// four times the area, with the error bound
  using Face_data = Bounded_area;
  /// uncertain if the error bounds do not decide
  using Boolean = Uncertain<bool>;
  /// the data around an edge
  using Hinge_data = Hinge<Edge_data, Face_data>;
  /// the data of the other diagonal
  using Flipped_hinge_data = Flipped_hinge<Edge_data, Face_data>;
  /// a point in space
  using Point_data = std::array<double, 3>;
  /// decisions are exact
  using Has_exact_decisions = Tag_true;
  /// undecided tests are passed on to the exact engine of the triangulation
  using Uses_exact_geometry = Tag_true;

  // Each difference, square and sum adds at most u, and nothing cancels: right up to 6 u.
  /// makes the squared length of an edge, with a relative error of at most 6 u.
  using Construct_edge_data = Edge_length_traits<double>::Construct_edge_data;

  /// makes the area of a face with its first error bound.
  struct Construct_face_data
  {
    // The components of the cross product v × w are wrong by at most 4 u times the sum of
    // the absolute values of their two terms, the vector by at most 4 √2 u |v| |w|; norm
    // and root add less than 3 u a. With a <= 2 |v| |w| <= v² + w², 9 u (v² + w²) covers
    // the error of a = 2 |v × w|. Hence (2), and (1) as 1.5 · 6 < 14.
    /// \brief makes the face with these corners.
    /// \tparam Number `double`, or two of them for two faces
    template <class Number>
    auto operator()(const std::array<Number, 3>& p, const std::array<Number, 3>& q,
                    const std::array<Number, 3>& r) const
    {
      using Areas = std::conditional_t<std::is_same<Number, double>::value, Bounded_area, internal::Two_bounded_areas>;
      const Number sum =
        internal::squared_distance_3(p, q) + internal::squared_distance_3(q, r) + internal::squared_distance_3(p, r);
      return Areas{internal::four_areas_3(p, q, r), initial_error(sum)};
    }
    // Kahan's formula: each factor is right up to 2 u, a up to 10 u, and 15 / √3 < 14.
    /// makes the face with sides of these lengths.
    Face_data from_lengths(double ij, double jk, double ki) const
    {
      return {internal::sqrt_of_non_negative(squared_four_areas_from_lengths(ij, jk, ki)),
              initial_error(ij * ij + jk * jk + ki * ki)};
    }

  private:
    template <class N>
    static N initial_error(const N& sum_of_sides)
    {
      return N(14 * u) * sum_of_sides + N(tiny_root);
    }
  };

  /// decides whether the edge of a hinge is Delaunay if the error bounds suffice.
  struct Is_locally_Delaunay
  {
    /// decides, or returns an uncertain value.
    Boolean operator()(const Hinge_data& h) const
    {
      const double p_k = twice_scalar_product(h.jk, h.ki, h.ij);
      const double p_l = twice_scalar_product(h.il, h.lj, h.ij);
      const double a = h.ijk.value, b = h.jil.value, e = h.ijk.error, f = h.jil.error;
      const double value = p_k * b + p_l * a;
      // p_k b is wrong by at most |p_k| f / 1.5 + 0.84 e (b + f / 1.5). Its rounding and that of
      // the sum add 2.01 u |p_k| |b| <= |p_k| f / 9, and the same holds for p_l a: 0.9 times
      // the following covers all of it.
      const double bound = e * (std::abs(p_l) + b + f) + f * (std::abs(p_k) + a + e) + tiny;
      if (!(std::abs(value) > bound))
        return Boolean::indeterminate();
      return value > 0;
    }
  };

  /// decides whether the two faces of a hinge form a strictly convex quadrilateral if the error bounds suffice.
  struct Is_convex
  {
    // At the ends of ij the angles sum to less than π if x_k b + x_l a and y_k b + y_l a are positive: up to a
    // positive factor, these are the sines of the sums. Their errors are bounded as in `Construct_flipped_hinge`.
    /// decides, or returns an uncertain value.
    Boolean operator()(const Hinge_data& h) const
    {
      const double a = h.ijk.value, b = h.jil.value, e = h.ijk.error, f = h.jil.error;
      const double of_areas = 0.84 * (e * b + f * a + 1.4 * e * f);
      const auto is_below_straight = [&](double at_k, double at_l) -> Boolean {
        const double value = at_k * b + at_l * a;
        const double bound = 1.01 * (0.78 * (std::abs(at_k) * f + std::abs(at_l) * e) + of_areas) + tiny;
        if (!(std::abs(value) > bound))
          return Boolean::indeterminate();
        return value > 0;
      };
      return is_below_straight(twice_scalar_product(h.ki, h.ij, h.jk), twice_scalar_product(h.il, h.ij, h.lj)) &
             is_below_straight(twice_scalar_product(h.jk, h.ij, h.ki), twice_scalar_product(h.lj, h.ij, h.il));
    }
  };

  /// computes the flipped hinge. The edge is not Delaunay by an exact decision, so
  /// the other diagonal exists.
  struct Construct_flipped_hinge
  {
    /// computes `flipped` with its error bounds, which may be infinite; returns `true`.
    Boolean operator()(const Hinge_data& h, Flipped_hinge_data& flipped) const
    {
      const double s = h.ij;
      // x and y, and the faces ilk and jkl computed from them
      using Two = internal::Two_doubles;
      const Two at_k = Two(h.ki, h.jk) + Two(s) - Two(h.jk, h.ki);
      const Two at_l = Two(h.il, h.lj) + Two(s) - Two(h.lj, h.il);
      const double a = h.ijk.value, b = h.jil.value, e = h.ijk.error, f = h.jil.error;
      const double r = 1 / (s + s);
      const double along = at_k.first() - at_l.first(), across = a + b;
      const double s_kl = (along * along + across * across) * r * 0.5;
      const Two area = (at_k * b + at_l * a) * r;
      flipped.kl = s_kl;
      flipped.ilk.value = area.first();
      flipped.jkl.value = area.second();
      const double sum = e + f;
      if (!(s > 512 * sum && s > smallest_divisor)) {
        flipped.ilk.error = flipped.jkl.error = std::numeric_limits<double>::infinity();
        return true;
      }
      // The side ij belongs to both faces: it is wrong by at most min(e, f) / 1.5 <= sum / 3, so r relatively by at
      // most 0.67 sum r + 1.01 u. `along` is wrong by at most 0.84 sum and its rounding, together 0.93 sum; `across` by
      // less. Hence s_kl is wrong by at most 0.94 sum r (|along| + |across| + sum) + s_kl (0.68 sum r + 4.1 u). For
      // (1), 1.5 times that and 9 u s_kl are added to the bounds of the two faces to which the other sides belong; 16 u
      // s_kl makes up for the last terms, and for (3).
      const double of_sides =
        sum + sum * r * (1.42 * (std::abs(along) + std::abs(across) + sum) + 1.03 * s_kl) + 16 * u * s_kl;
      // x_k b and x_l a together are wrong by at most 0.78 (|x_k| f + |x_l| e) + 0.84 (e b + f a + 4/3 e f), rounding
      // of product and sum included. For (2), take 1.5 times that, and the part of the area by which r and the last
      // product are wrong.
      const double of_products = e * b + f * a + 1.4 * e * f;
      const Two of_area =
        r * (1.27 * (abs(at_k) * f + abs(at_l) * e + of_products) + 1.03 * abs(area) * sum) + 4 * u * abs(area);
      const Two error = max_of(of_area, of_sides) + tiny;
      flipped.ilk.error = error.first();
      flipped.jkl.error = error.second();
      return true;
    }
  };

  /// \brief bounds the cotangents of a face from below: of the corners opposite to ij, jk and ki.
  ///
  /// If the two bounds of the corners opposite to an edge sum to more than zero, the edge is
  /// Delaunay.
  struct Compute_cotangent_bounds
  {
    /// returns the bounds; −∞ if the area is not known well enough.
    std::array<float, 3> operator()(const Face_data& ijk, const Edge_data& ij, const Edge_data& jk,
                                    const Edge_data& ki) const
    {
      // c = p / a is wrong by at most (0.84 + |c| / 1.5) E / (a - E). With S the sum of the
      // sides, 1 and |c| are at most S / a, so that this is less than 2^-24 S / a.
      if (!(ijk.value > 0x1p25 * ijk.error)) {
        constexpr float unknown = -std::numeric_limits<float>::infinity();
        return {unknown, unknown, unknown};
      }
      return internal::rounded(internal::cotangent_bounds(ij, jk, ki, ijk.value));
    }
    /// \cond SKIP_IN_MANUAL
    std::array<internal::Two_doubles, 3> operator()(const internal::Two_bounded_areas& ijk,
                                                    const internal::Two_doubles& ij, const internal::Two_doubles& jk,
                                                    const internal::Two_doubles& ki) const
    {
      std::array<internal::Two_doubles, 3> bounds = internal::cotangent_bounds(ij, jk, ki, ijk.value);
      const internal::Two_doubles least = 0x1p25 * ijk.error;
      for (internal::Two_doubles& bound : bounds)
        bound = if_greater(ijk.value, least, bound, -std::numeric_limits<double>::infinity());
      return bounds;
    }
    /// \endcond
  };

  /// makes stored data from the numbers of an exact stage.
  struct Construct_refined_data
  {
    /// \brief makes an edge of squared length s.
    /// \tparam Number a number of the exact stage that decided, with `hi()`, the nearest double, and `error()`, a bound
    template <class Number>
    Edge_data operator()(const Number& s) const
    {
      return s.hi();
    }
    /// \brief makes a face from four times its area and the squared lengths of its sides.
    ///
    /// The bound is infinite unless the squared lengths have relative errors of at most 6 u;
    /// they are shared with other faces, so they must not be replaced otherwise.
    template <class Number>
    Face_data operator()(const Number& four_areas, const Number& ij, const Number& jk, const Number& ki) const
    {
      if (!(is_tight(ij) && is_tight(jk) && is_tight(ki)))
        return {four_areas.hi(), std::numeric_limits<double>::infinity()};
      const double of_sides = 13 * u * (ij.hi() + jk.hi() + ki.hi());
      const double of_area = 1.6 * (u * std::abs(four_areas.hi()) + four_areas.error());
      return {four_areas.hi(), (std::max)(of_sides, of_area) + tiny};
    }

  private:
    // The part cut off from hi() is at most u hi().
    template <class Number>
    static bool is_tight(const Number& s)
    {
      return s.error() <= 4.9 * u * s.hi();
    }
  };
  /// decides whether the stored numbers of a face are accurate enough to be kept.
  struct Is_accurate
  {
    /// returns whether the error bound is below 2⁻³⁴ of the area.
    bool operator()(const Face_data& f) const { return f.error <= 0x1p-34 * f.value; }
  };
  /// decides whether a face is known to have positive area.
  struct Has_positive_area
  {
    /// returns whether the area is larger than its error bound.
    bool operator()(const Face_data& f) const { return f.value > f.error; }
  };
  /// gives the stored squared length of an edge, accurate to the stored bound.
  using Compute_squared_length = Edge_length_traits<double>::Compute_squared_length;
  /// gives the length of an edge from the stored squared length.
  using Compute_length = Edge_length_traits<double>::Compute_length;
  /// gives the stored area of a face.
  struct Compute_area
  {
    /// returns the area.
    double operator()(const Face_data& f, const Edge_data&, const Edge_data&, const Edge_data&) const
    {
      return f.value / 4;
    }
  };
  /// gives the cotangent opposite ij in the face ijk from the stored numbers.
  struct Compute_cotangent
  {
    /// returns the cotangent.
    double operator()(const Face_data& ijk, const Edge_data& ij, const Edge_data& jk, const Edge_data& ki) const
    {
      return twice_scalar_product(jk, ki, ij) / ijk.value;
    }
  };

  /// gives the same cotangent with a bound on its error, which is infinite if the area is
  /// not known well enough. O(1), one division.
  struct Compute_bounded_cotangent
  {
    // With E <= a/8, the quotient c is wrong by at most (0.84 + |c| / 1.5) E / (a - E / 1.5), which
    // is less than (0.92 + 0.73 |c|) E / a, and its two roundings add 2.01 u |c|, which is below
    // 0.11 |c| E / a by (3).
    /// returns the cotangent and its bound.
    Bounded_double operator()(const Face_data& ijk, const Edge_data& ij, const Edge_data& jk, const Edge_data& ki) const
    {
      if (!(ijk.value > 8 * ijk.error))
        return {0, std::numeric_limits<double>::infinity()};
      const double r = 1 / ijk.value;
      const double c = twice_scalar_product(jk, ki, ij) * r;
      return {c, (1 + std::abs(c)) * ijk.error * r};
    }
  };

  /// \name Functors
  /// @{

  /// returns the functor, which has no state.
  Construct_edge_data construct_edge_data_object() const { return {}; }
  Construct_face_data construct_face_data_object() const { return {}; }
  Construct_refined_data construct_refined_data_object() const { return {}; }
  Is_accurate is_accurate_object() const { return {}; }
  Is_locally_Delaunay is_locally_Delaunay_object() const { return {}; }
  Is_convex is_convex_object() const { return {}; }
  Has_positive_area has_positive_area_object() const { return {}; }
  Construct_flipped_hinge construct_flipped_hinge_object() const { return {}; }
  Compute_squared_length compute_squared_length_object() const { return {}; }
  Compute_length compute_length_object() const { return {}; }
  Compute_area compute_area_object() const { return {}; }
  Compute_cotangent compute_cotangent_object() const { return {}; }
  Compute_cotangent_bounds compute_cotangent_bounds_object() const { return {}; }
  Compute_bounded_cotangent compute_bounded_cotangent_object() const { return {}; }
  /// @}
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FILTERED_EDGE_LENGTH_TRAITS_H
