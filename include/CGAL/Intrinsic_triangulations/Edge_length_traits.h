// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The metric as squared lengths and areas: one square root per input face.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EDGE_LENGTH_TRAITS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EDGE_LENGTH_TRAITS_H

#include <CGAL/Intrinsic_triangulations/internal/measures/hinge_formulas.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/number_kinds.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/rounded_sqrt.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/Cotangent_bounds.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/triangle_formulas_3.h>

#include <CGAL/Uncertain.h>
#include <CGAL/number_type_basic.h>

#include <array>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsTraits
///
/// \brief the metric of a triangulation as squared edge lengths and face areas.
///
/// Each edge stores its squared length s, each face four times its area a. There is
/// one square root per input face and none afterwards. A Delaunay test needs neither
/// division nor root, a flip one division. Decisions are exact for an exact number type, and rounded for a
/// floating-point type. An interval that cannot decide gives an uncertain answer, never a guess.
///
/// \tparam FT_ a model of `FieldWithSqrt` and `RealEmbeddable`: `float`, `double`,
///   `long double`, `__float128`, any float of Boost.Multiprecision (`cpp_bin_float_50`,
///   `float128`, `mpfr_float_50`, ...), `Mpfr_float`, `CGAL::Interval_nt<>`, or
///   `CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt::FT`. Other types fail to compile, with a
///   one-sentence message.
///
/// \cgalModels{IntrinsicTriangulationTraits}
///
/// Source: the formulas of `flip_hinge()`; Delaunay criterion of Fisher, Springborn,
/// Schroeder, Bobenko (2006), section 2.1.
template <class FT_>
class Edge_length_traits
{
public:
  /// the number type
  using FT = internal::Number_type_with_roots<FT_>;
  /// squared length
  using Edge_data = FT;
  /// four times the area
  using Face_data = FT;
  /// `bool`, or `CGAL::Uncertain<bool>` for an interval type
  using Boolean = typename Real_embeddable_traits<FT>::Boolean;
  /// the data around an edge
  using Hinge_data = Hinge<Edge_data, Face_data>;
  /// the data of the other diagonal
  using Flipped_hinge_data = Flipped_hinge<Edge_data, Face_data>;
  /// a point in space
  using Point_data = std::array<FT, 3>;
  /// whether decisions are exact
  using Has_exact_decisions = typename Algebraic_structure_traits<FT>::Is_exact;
  /// no decision needs more than the data of the hinge
  using Uses_exact_geometry = Tag_false;

  /// makes the data of an edge from its end points or its length.
  struct Construct_edge_data
  {
    /// \brief makes the edge from `p` to `q`.
    /// \tparam Number `FT`, or two numbers for two edges
    template <class Number>
    Number operator()(const std::array<Number, 3>& p, const std::array<Number, 3>& q) const
    {
      return internal::squared_distance_3(p, q);
    }
    /// makes the edge of this length.
    Edge_data from_length(const FT& length) const { return length * length; }
  };

  /// makes the data of a face from its corners, or from the lengths of its edges.
  struct Construct_face_data
  {
    /// \brief makes the face with these corners.
    /// \tparam Number `FT`, or two numbers for two faces
    template <class Number>
    Number operator()(const std::array<Number, 3>& p, const std::array<Number, 3>& q,
                      const std::array<Number, 3>& r) const
    {
      return internal::four_areas_3(p, q, r);
    }
    /// makes the face with sides of these lengths.
    /// \pre the lengths obey the triangle inequality
    Face_data from_lengths(const FT& ij, const FT& jk, const FT& ki) const
    {
      return internal::sqrt_of_non_negative(squared_four_areas_from_lengths(ij, jk, ki));
    }
  };

  /// decides whether the edge of a hinge is Delaunay: `cot k + cot l >= 0`.
  ///
  /// A tie is Delaunay. If both faces have zero area, the edge is Delaunay unless both
  /// opposite angles are π.
  struct Is_locally_Delaunay
  {
    /// decides by the sign of `Delaunay_value()`.
    Boolean operator()(const Hinge_data& h) const
    {
      const FT p_k = twice_scalar_product(h.jk, h.ki, h.ij);
      const FT p_l = twice_scalar_product(h.il, h.lj, h.ij);
      const FT value = Delaunay_value(p_k, h.ijk, p_l, h.jil);
      if (certainly(value == FT(0)) && certainly(h.ijk == FT(0)) && certainly(h.jil == FT(0))) {
        const Boolean is_k_sharp = p_k >= FT(0), is_l_sharp = p_l >= FT(0);
        return is_k_sharp | is_l_sharp;
      }
      return !(value < FT(0));
    }
  };

  /// computes the flipped hinge and decides whether it exists, that is, whether the
  /// quadrilateral is strictly convex.
  struct Construct_flipped_hinge
  {
    /// computes `f`, and returns whether the hinge is strictly convex.
    Boolean operator()(const Hinge_data& h, Flipped_hinge_data& f) const
    {
      flip_hinge(h.ij, h.jk, h.ki, h.il, h.lj, h.ijk, h.jil, f.kl, f.ilk, f.jkl);
      const Boolean turns_at_i = f.ilk > FT(0), turns_at_j = f.jkl > FT(0), has_length = f.kl > FT(0);
      return turns_at_i & turns_at_j & has_length;
    }
  };

  /// gives the squared length of an edge.
  struct Compute_squared_length
  {
    /// returns the squared length.
    FT operator()(const Edge_data& e) const { return e; }
  };
  /// gives the length of an edge, rounded like the square root of `FT`.
  struct Compute_length
  {
    /// returns the length.
    FT operator()(const Edge_data& e) const { return internal::rounded_sqrt(e); }
  };
  /// gives the area of a face.
  struct Compute_area
  {
    /// returns the area.
    FT operator()(const Face_data& f, const Edge_data&, const Edge_data&, const Edge_data&) const { return f / FT(4); }
  };
  /// gives the cotangent of the corner opposite to edge ij in the face ijk.
  /// \pre the area is not zero
  struct Compute_cotangent
  {
    /// returns the cotangent.
    FT operator()(const Face_data& ijk, const Edge_data& ij, const Edge_data& jk, const Edge_data& ki) const
    {
      return twice_scalar_product(jk, ki, ij) / ijk;
    }
  };

  /// \cond SKIP_IN_MANUAL
  // The test in double is wrong by a few 2^-53 S / a of either cotangent.
  struct Compute_cotangent_bounds_in_double
  {
    std::array<float, 3> operator()(double ijk, double ij, double jk, double ki) const
    {
      return internal::rounded(internal::cotangent_bounds(ij, jk, ki, ijk));
    }
    std::array<internal::Two_doubles, 3> operator()(const internal::Two_doubles& ijk, const internal::Two_doubles& ij,
                                                    const internal::Two_doubles& jk,
                                                    const internal::Two_doubles& ki) const
    {
      return internal::cotangent_bounds(ij, jk, ki, ijk);
    }
  };
  // Results computed in float can be too inaccurate for bounds in float, and other number types are not made for speed.
  using Compute_cotangent_bounds =
    std::conditional_t<std::is_same<FT_, double>::value, Compute_cotangent_bounds_in_double, void>;
  Compute_cotangent_bounds compute_cotangent_bounds_object() const { return Compute_cotangent_bounds(); }
  /// \endcond

  /// \name Functors
  /// @{

  /// returns the functor, which has no state.
  Construct_edge_data construct_edge_data_object() const { return {}; }
  Construct_face_data construct_face_data_object() const { return {}; }
  Is_locally_Delaunay is_locally_Delaunay_object() const { return {}; }
  Construct_flipped_hinge construct_flipped_hinge_object() const { return {}; }
  Compute_squared_length compute_squared_length_object() const { return {}; }
  Compute_length compute_length_object() const { return {}; }
  Compute_area compute_area_object() const { return {}; }
  Compute_cotangent compute_cotangent_object() const { return {}; }
  /// @}
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EDGE_LENGTH_TRAITS_H
