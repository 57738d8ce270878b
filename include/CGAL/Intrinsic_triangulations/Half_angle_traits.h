// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The metric as the paper has it: lengths, and tangents of half angles.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_HALF_ANGLE_TRAITS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_HALF_ANGLE_TRAITS_H

#include <CGAL/Intrinsic_triangulations/internal/measures/hinge_formulas.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/number_kinds.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/rounded_sqrt.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/triangle_formulas_3.h>

#include <CGAL/Uncertain.h>
#include <CGAL/number_type_basic.h>

#include <array>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsTraits
///
/// \brief the metric of a triangulation as edge lengths alone, with the formulas of the paper.
///
/// Each edge stores its length. Every test computes two tangents of half angles, every
/// flip two more: six square roots for a test and a flip. With an exact number type, the
/// square roots of each flip contain those of earlier flips. This class is meant for
/// comparison; `Edge_length_traits` is faster and more accurate.
///
/// \tparam FT_ as for `Edge_length_traits`
///
/// \cgalModels{IntrinsicTriangulationTraits}
///
/// Source: Fisher, Springborn, Schroeder, Bobenko (2006), section 2.2.
template <class FT_>
class Half_angle_traits
{
public:
  /// the number type
  using FT = internal::Number_type_with_roots<FT_>;
  /// length
  using Edge_data = FT;
  /// nothing is stored for a face
  struct Face_data
  {};
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

  /// returns `tan(α/2) = √(((a − b + c)(a + b − c)) / ((a + b + c)(−a + b + c)))` of the
  /// angle α opposite to side a of a triangle with sides a, b, c (section 2.2).
  static FT tan_half_angle(const FT& a, const FT& b, const FT& c)
  {
    return internal::sqrt_of_non_negative(FT(((a - b + c) * (a + b - c)) / ((a + b + c) * (b + c - a))));
  }

  /// returns `cot α = (1 − t²) / (2 t)` for `t = tan(α/2)` (section 2.2).
  static FT cotangent(const FT& t) { return (FT(1) - t * t) / (t + t); }

  /// makes the data of an edge from its end points or its length.
  struct Construct_edge_data
  {
    /// makes the edge from p to q.
    Edge_data operator()(const Point_data& p, const Point_data& q) const
    {
      return internal::rounded_sqrt(internal::squared_distance_3(p, q));
    }
    /// makes the edge of this length.
    Edge_data from_length(const FT& length) const { return length; }
  };

  /// makes the data of a face, which are empty.
  struct Construct_face_data
  {
    /// makes the face with these corners.
    Face_data operator()(const Point_data&, const Point_data&, const Point_data&) const { return {}; }
    /// makes the face with sides of these lengths.
    Face_data from_lengths(const FT&, const FT&, const FT&) const { return {}; }
  };

  /// decides `cot k + cot l >= 0` from the two cotangents. For a face of zero area, the result depends on the number
  /// type's division by zero.
  struct Is_locally_Delaunay
  {
    /// decides by the sum of the cotangents.
    Boolean operator()(const Hinge_data& h) const
    {
      return cotangent(tan_half_angle(h.ij, h.jk, h.ki)) + cotangent(tan_half_angle(h.ij, h.il, h.lj)) >= FT(0);
    }
  };

  /// computes the length of the other diagonal from the half angles at i (section 2.2):
  /// `tan((α + δ)/2) = (tan(α/2) + tan(δ/2)) / (1 − tan(α/2) tan(δ/2))`,
  /// `cos(α + δ) = (1 − t²) / (1 + t²)`, `kl² = ki² + il² − 2 ki il cos(α + δ)`,
  /// and decides whether the angles at i and at j are less than π.
  struct Construct_flipped_hinge
  {
    /// computes `f`, and returns whether the hinge is strictly convex.
    Boolean operator()(const Hinge_data& h, Flipped_hinge_data& f) const
    {
      const FT at_i = tan_half_angle(h.jk, h.ij, h.ki);
      const FT at_i_below = tan_half_angle(h.lj, h.ij, h.il);
      const FT at_j = tan_half_angle(h.ki, h.ij, h.jk);
      const FT at_j_below = tan_half_angle(h.il, h.ij, h.lj);
      const FT denominator = FT(1) - at_i * at_i_below;
      const Boolean is_convex_at_i = denominator > FT(0), is_convex_at_j = at_j * at_j_below < FT(1),
                    is_regular = denominator != FT(0);
      const Boolean is_convex = is_convex_at_i & is_convex_at_j;
      if (!possibly(is_convex) || !certainly(is_regular))
        return is_convex & is_regular;
      const FT t = (at_i + at_i_below) / denominator;
      const FT cosine = (FT(1) - t * t) / (FT(1) + t * t);
      const FT squared = h.ki * h.ki + h.il * h.il - FT(2) * h.ki * h.il * cosine;
      f.kl = internal::sqrt_of_non_negative(squared);
      const Boolean has_length = f.kl > FT(0);
      return is_convex & has_length;
    }
  };

  /// gives the squared length of an edge.
  struct Compute_squared_length
  {
    /// returns the squared length.
    FT operator()(const Edge_data& e) const { return e * e; }
  };
  /// gives the length of an edge.
  struct Compute_length
  {
    /// returns the length.
    FT operator()(const Edge_data& e) const { return e; }
  };
  /// gives the area of a face by Heron's formula.
  struct Compute_area
  {
    /// returns the area.
    FT operator()(const Face_data&, const Edge_data& ij, const Edge_data& jk, const Edge_data& ki) const
    {
      return internal::sqrt_of_non_negative(squared_four_areas_from_lengths(ij, jk, ki)) / FT(4);
    }
  };
  /// gives the cotangent of the corner opposite to edge ij in the face ijk.
  /// \pre the area is not zero
  struct Compute_cotangent
  {
    /// returns the cotangent.
    FT operator()(const Face_data&, const Edge_data& ij, const Edge_data& jk, const Edge_data& ki) const
    {
      return cotangent(tan_half_angle(ij, jk, ki));
    }
  };

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

#endif // CGAL_INTRINSIC_TRIANGULATIONS_HALF_ANGLE_TRAITS_H
