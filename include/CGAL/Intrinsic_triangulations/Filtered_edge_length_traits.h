// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Squared lengths and areas in double, each with a bound on its error.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FILTERED_EDGE_LENGTH_TRAITS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FILTERED_EDGE_LENGTH_TRAITS_H

#include <CGAL/Intrinsic_triangulations/hinge_formulas.h>
#include <CGAL/Intrinsic_triangulations/internal/Bounded_double_double.h>
#include <CGAL/Intrinsic_triangulations/internal/triangle_formulas_3.h>

#include <CGAL/Uncertain.h>
#include <CGAL/tags.h>

#include <array>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsTraits
/// \brief a double and an upper bound on its absolute error.
struct Bounded_double
{
  double value;
  double error;
};

/// \ingroup PkgIntrinsicTriangulationsTraits
///
/// \brief the metric of a triangulation in double, with exact decisions.
///
/// Every Delaunay test gives the answer of exact real arithmetic on the piecewise-flat
/// surface that the input defines, however many flips came before. The functors below
/// are the first stage: they keep a running error bound beside each squared length and
/// area and answer where it suffices. Where it does not, `Intrinsic_triangulation` asks
/// its `Exact_geometry`, whose result replaces what is stored.
///
/// Invariants: with u = 2^-53, the error of a squared length s is at least 5 u s, that of
/// an area a (times four) at least 4 u a. They let one factor cover the rounding errors
/// of a test.
///
/// \cgalModels `IntrinsicTriangulationTraits`
class Filtered_edge_length_traits
{
  static constexpr double u = 0x1p-53;
  // Covers underflow; the unit of length is such that ordinary values are far above.
  static constexpr double tiny = 1e-200;
  // A divisor must be known this well, and be this far from underflow.
  static constexpr double smallest_divisor = 1e-100;

public:
  using FT = double;
  /// squared length
  using Edge_data = Bounded_double;
  /// four times the area
  using Face_data = Bounded_double;
  using Boolean = Uncertain<bool>;
  using Hinge_data = Hinge<Edge_data, Face_data>;
  using Flipped_hinge_data = Flipped_hinge<Edge_data, Face_data>;
  using Point_data = std::array<double, 3>;
  using Has_exact_decisions = Tag_true;
  /// undecided tests are passed on to the `Exact_geometry` of the triangulation
  using Uses_exact_geometry = Tag_true;

  struct Construct_edge_data
  {
    // Each difference, square and sum adds at most u, and nothing cancels.
    Edge_data operator()(const Point_data& p, const Point_data& q) const
    {
      const double s = internal::squared_distance_3(p, q);
      return {s, 6 * u * s + tiny};
    }
    Edge_data from_length(double length) const
    {
      const double s = length * length;
      return {s, 5 * u * s + tiny};
    }
  };

  struct Construct_face_data
  {
    // The components of the cross product v × w are wrong by at most 4 u times the sum of
    // the absolute values of their two terms, the vector by at most 4 √2 u |v| |w|; norm
    // and root add less than 3 u a. With a <= 2 |v| |w| <= v² + w², 9 u (v² + w²) covers
    // the error of a = 2 |v × w|.
    Face_data operator()(const Point_data& p, const Point_data& q, const Point_data& r) const
    {
      return {internal::four_areas_3(p, q, r),
              9.5 * u * (internal::squared_distance_3(p, q) + internal::squared_distance_3(p, r)) +
                tiny};
    }
    // Kahan's formula: each factor is right up to 2 u.
    Face_data from_lengths(double ij, double jk, double ki) const
    {
      const double a =
        internal::sqrt_of_non_negative(squared_four_areas_from_lengths(ij, jk, ki));
      return {a, 10 * u * a + tiny};
    }
  };

  /// decides whether the edge of a hinge is Delaunay where the error bounds suffice.
  struct Is_locally_Delaunay
  {
    Boolean operator()(const Hinge_data& h) const
    {
      const double p_k = twice_scalar_product(h.jk.value, h.ki.value, h.ij.value);
      const double p_l = twice_scalar_product(h.il.value, h.lj.value, h.ij.value);
      const double value = p_k * h.jil.value + p_l * h.ijk.value;
      // p is wrong by at most e_p = 1.5 (e + e + e): the sum of the errors, and two roundings
      // of at most u (s + s + s) each. A product p a is wrong by at most
      // |p| e_a + e_p (a + e_a), and its rounding and that of the sum by at most
      // 2 u |p| a <= |p| e_a / 2. All of it is below 1.6 times the following.
      const double e_k = h.jk.error + h.ki.error + h.ij.error;
      const double e_l = h.il.error + h.lj.error + h.ij.error;
      const double bound = 1.6 * (std::abs(p_k) * h.jil.error + std::abs(p_l) * h.ijk.error +
                                  e_k * (h.jil.value + h.jil.error) +
                                  e_l * (h.ijk.value + h.ijk.error)) +
                           tiny;
      if (value > bound)
        return true;
      if (value < -bound)
        return false;
      return Boolean::indeterminate();
    }
  };

  /// computes the flipped hinge. A flipped edge is not Delaunay by an exact decision, so
  /// that the other diagonal exists.
  struct Construct_flipped_hinge
  {
    Boolean operator()(const Hinge_data& h, Flipped_hinge_data& f) const
    {
      const double s = h.ij.value;
      const double x_k = twice_scalar_product(h.ki.value, s, h.jk.value);
      const double x_l = twice_scalar_product(h.il.value, s, h.lj.value);
      const double y_k = twice_scalar_product(h.jk.value, s, h.ki.value);
      const double y_l = twice_scalar_product(h.lj.value, s, h.il.value);
      const double a = h.ijk.value, b = h.jil.value, e_a = h.ijk.error, e_b = h.jil.error;
      const double r = 1 / (s + s);
      const double along = x_k - x_l, across = a + b;
      f.kl.value = (along * along + across * across) * r * 0.5;
      f.ilk.value = (x_k * b + x_l * a) * r;
      f.jkl.value = (y_k * b + y_l * a) * r;
      if (!(s > 1024 * h.ij.error && s > smallest_divisor)) {
        f.kl.error = f.ilk.error = f.jkl.error = std::numeric_limits<double>::infinity();
        return true;
      }
      // As above: e_k bounds the errors of x_k and y_k. 1/s is wrong by less than
      // 2.002 r e_s / s.
      const double e_k = 1.5 * (h.jk.error + h.ki.error + h.ij.error);
      const double e_l = 1.5 * (h.il.error + h.lj.error + h.ij.error);
      const double e_r = 2.01 * h.ij.error * r + 6 * u;
      const double e_along = 1.2 * (e_k + e_l), e_across = 1.3 * (e_a + e_b);
      f.kl.error = 1.01 * ((2 * std::abs(along) + e_along) * e_along +
                           (2 * across + e_across) * e_across) * r * 0.5 +
                   f.kl.value * 1.01 * e_r + tiny;
      const double e_products = e_k * (b + e_b) + e_l * (a + e_a);
      f.ilk.error = 1.01 * (1.5 * (std::abs(x_k) * e_b + std::abs(x_l) * e_a) + e_products) * r +
                    std::abs(f.ilk.value) * 1.01 * e_r + tiny;
      f.jkl.error = 1.01 * (1.5 * (std::abs(y_k) * e_b + std::abs(y_l) * e_a) + e_products) * r +
                    std::abs(f.jkl.value) * 1.01 * e_r + tiny;
      return true;
    }
  };

  /// makes stored data from a number of an exact stage.
  struct Construct_refined_data
  {
    Bounded_double operator()(const internal::Bounded_double_double& x) const
    {
      return {x.hi(), 6 * u * std::abs(x.hi()) + 1.01 * x.error() + tiny};
    }
  };
  /// tells whether a number is known so well that an exact stage need not replace it.
  struct Is_accurate
  {
    bool operator()(const Bounded_double& x) const { return x.error <= 0x1p-34 * x.value; }
  };
  /// tells whether a face is known to have positive area.
  struct Has_positive_area
  {
    bool operator()(const Face_data& f) const { return f.value > f.error; }
  };
  /// gives the stored squared length of an edge, good to the stored bound.
  struct Compute_squared_length
  {
    double operator()(const Edge_data& e) const { return e.value; }
  };
  /// gives the length of an edge from the stored squared length.
  struct Compute_length
  {
    double operator()(const Edge_data& e) const { return std::sqrt(e.value); }
  };
  /// gives the stored area of a face.
  struct Compute_area
  {
    double operator()(const Face_data& f, const Edge_data&, const Edge_data&,
                      const Edge_data&) const
    {
      return f.value / 4;
    }
  };
  /// gives the cotangent opposite to ij in the face ijk from what is stored.
  struct Compute_cotangent
  {
    double operator()(const Face_data& ijk, const Edge_data& ij, const Edge_data& jk,
                      const Edge_data& ki) const
    {
      return twice_scalar_product(jk.value, ki.value, ij.value) / ijk.value;
    }
  };

  /// gives the same cotangent with a bound on its error, which is infinite where the area is
  /// not known well enough. O(1), one division.
  struct Compute_bounded_cotangent
  {
    // With p wrong by e_p <= 1.5 (e + e + e) as in the test and e_a <= a/8, the quotient is wrong
    // by at most 8/7 (e_p + |c| e_a) / a, and its two roundings add 2.01 u |c|, which is below
    // 0.51 |c| e_a / a by the invariant of a.
    Bounded_double operator()(const Face_data& ijk, const Edge_data& ij, const Edge_data& jk,
                              const Edge_data& ki) const
    {
      if (!(ijk.value > 8 * ijk.error))
        return {0, std::numeric_limits<double>::infinity()};
      const double r = 1 / ijk.value;
      const double c = twice_scalar_product(jk.value, ki.value, ij.value) * r;
      return {c, 1.8 * (ij.error + jk.error + ki.error + std::abs(c) * ijk.error) * r};
    }
  };

  Construct_edge_data construct_edge_data_object() const { return {}; }
  Construct_face_data construct_face_data_object() const { return {}; }
  Construct_refined_data construct_refined_data_object() const { return {}; }
  Is_accurate is_accurate_object() const { return {}; }
  Is_locally_Delaunay is_locally_Delaunay_object() const { return {}; }
  Has_positive_area has_positive_area_object() const { return {}; }
  Construct_flipped_hinge construct_flipped_hinge_object() const { return {}; }
  Compute_squared_length compute_squared_length_object() const { return {}; }
  Compute_length compute_length_object() const { return {}; }
  Compute_area compute_area_object() const { return {}; }
  Compute_cotangent compute_cotangent_object() const { return {}; }
  Compute_bounded_cotangent compute_bounded_cotangent_object() const { return {}; }
};

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FILTERED_EDGE_LENGTH_TRAITS_H
