// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The metric of ideal hyperbolic triangles: λ-lengths, flipped by Ptolemy's formula.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_PTOLEMY_TRAITS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_PTOLEMY_TRAITS_H

#include <CGAL/Intrinsic_triangulations/internal/arithmetic/rounded_sqrt.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/Ptolemy_length.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/hinge_formulas.h>

#include <CGAL/number_type_basic.h>
#include <CGAL/tags.h>

#include <array>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// The numbers of `Ptolemy_traits`: those of the user, or doubles with what their exact values follow from.
template <class FT>
struct Ptolemy_numbers
{
  using Edge_data = FT;
  using Boolean = typename Real_embeddable_traits<FT>::Boolean;
  using Is_exact = typename Algebraic_structure_traits<FT>::Is_exact;

  static Edge_data from_length(const FT& length) { return length; }
  static const FT& length(const Edge_data& e) { return e; }
  template <class Hinge>
  static Boolean is_Delaunay(const Hinge& h)
  {
    return h.ij * h.ij * (h.jk * h.ki + h.il * h.lj) <= (h.jk * h.il + h.ki * h.lj) * (h.ki * h.il + h.jk * h.lj);
  }
  template <class Hinge>
  static Edge_data flipped(const Hinge& h)
  {
    return (h.jk * h.il + h.ki * h.lj) / h.ij;
  }
};

template <>
struct Ptolemy_numbers<double>
{
  using Edge_data = Ptolemy_length;
  using Boolean = bool;
  using Is_exact = Tag_true;

  static Edge_data from_length(double length) { return {length, 0, nullptr}; }
  static double length(const Edge_data& e) { return e.value; }
  template <class Hinge>
  static bool is_Delaunay(const Hinge& h)
  {
    const double ij = h.ij.value, jk = h.jk.value, ki = h.ki.value, il = h.il.value, lj = h.lj.value;
    const double left = ij * ij * (jk * ki + il * lj), right = (jk * il + ki * lj) * (ki * il + jk * lj);
    // All terms are positive, so relative errors add up, and each side has six operations at most.
    const double error = 2 * h.ij.relative_error +
                         2.1 * (h.jk.relative_error + h.ki.relative_error + h.il.relative_error + h.lj.relative_error) +
                         16 * 0x1p-53;
    const bool is_in_range = left > 0x1p-900 && left < 0x1p900 && right > 0x1p-900 && right < 0x1p900;
    const double difference = right - left;
    if (is_in_range && !(difference <= error * (left + right) && -difference <= error * (left + right)))
      return difference > 0;
    return is_Delaunay_exactly({h.ij, h.jk, h.ki, h.il, h.lj});
  }
  template <class Hinge>
  static Edge_data flipped(const Hinge& h)
  {
    return flipped_length({h.ij, h.jk, h.ki, h.il, h.lj});
  }
};

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsTraits
///
/// \brief the metric of a triangulation as λ-lengths of ideal hyperbolic triangles with horocycles at their corners.
///
/// Each edge stores its λ-length, a face nothing: any three positive numbers are the λ-lengths of a triangle, so
/// lengths that violate the triangle inequality are accepted. A flip is Ptolemy's formula, `λ_kl = (λ_jk λ_il + λ_ki
/// λ_lj) / λ_ij`. An edge is Delaunay if `λ_ij² (λ_jk λ_ki + λ_il λ_lj) <= (λ_jk λ_il + λ_ki λ_lj) (λ_ki λ_il + λ_jk
/// λ_lj)`: for triangles that obey the triangle inequality, this is the criterion of opposite angles. Neither has a
/// root or a difference, so rational numbers are closed under flips, and nothing cancels in floating point.
/// `flip_to_Delaunay()` finds the ideal Delaunay triangulation. Only areas need roots.
///
/// A triangulation with these traits is constructed by `Intrinsic_triangulation::from_lengths()`, not from points.
///
/// \tparam FT_ a model of `Field` and `RealEmbeddable`. With `double`, decisions are exact for the doubles given as
///   lengths: where error bounds do not decide, rational numbers do, which are computed when they are needed. With an
///   exact number type decisions are exact; an interval that cannot decide gives an uncertain answer
///
/// \cgalModels{IntrinsicTriangulationTraits}
///
/// Sources: R. Penner, "The decorated Teichmüller space of punctured surfaces" (1987); B. Springborn, "Ideal hyperbolic
/// polyhedra and discrete uniformization" (2020).
template <class FT_>
class Ptolemy_traits
{
  using Numbers = internal::Ptolemy_numbers<FT_>;

public:
  /// the number type
  using FT = FT_;
  /// the λ-length
  using Edge_data = typename Numbers::Edge_data;
  /// a face has no number of its own
  struct Face_data
  {};
  /// `bool`, or `CGAL::Uncertain<bool>` for an interval type
  using Boolean = typename Numbers::Boolean;
  /// the data around an edge
  using Hinge_data = Hinge<Edge_data, Face_data>;
  /// the data of the other diagonal
  using Flipped_hinge_data = Flipped_hinge<Edge_data, Face_data>;
  /// no triangulation with these traits is constructed from points
  using Point_data = std::array<FT, 3>;
  /// whether decisions are exact
  using Has_exact_decisions = typename Numbers::Is_exact;
  /// any three positive λ-lengths are those of a face
  using Has_Euclidean_faces = Tag_false;
  /// no decision needs the input
  using Uses_exact_geometry = Tag_false;

  /// makes the data of an edge.
  struct Construct_edge_data
  {
    /// makes the edge of this λ-length.
    Edge_data from_length(const FT& length) const { return Numbers::from_length(length); }
  };
  /// makes the data of a face.
  struct Construct_face_data
  {
    /// makes the face with sides of these λ-lengths.
    Face_data from_lengths(const FT&, const FT&, const FT&) const { return {}; }
  };
  /// decides whether the edge of a hinge is Delaunay. A tie is.
  struct Is_locally_Delaunay
  {
    /// decides by the inequality above.
    Boolean operator()(const Hinge_data& h) const { return Numbers::is_Delaunay(h); }
  };
  /// computes the flipped hinge, which always exists.
  struct Construct_flipped_hinge
  {
    /// computes `f` by Ptolemy's formula; returns `true`.
    Boolean operator()(const Hinge_data& h, Flipped_hinge_data& f) const
    {
      f.kl = Numbers::flipped(h);
      return true;
    }
  };
  /// gives the squared λ-length of an edge.
  struct Compute_squared_length
  {
    /// returns the square.
    FT operator()(const Edge_data& e) const { return Numbers::length(e) * Numbers::length(e); }
  };
  /// gives the λ-length of an edge; with `double`, rounded in each flip.
  struct Compute_length
  {
    /// returns the λ-length.
    FT operator()(const Edge_data& e) const { return Numbers::length(e); }
  };
  /// gives the area of the Euclidean triangle whose sides are as long as the λ-lengths. The number type has square
  /// roots.
  /// \pre the λ-lengths obey the triangle inequality
  struct Compute_area
  {
    /// returns the area.
    FT operator()(const Face_data&, const Edge_data& ij, const Edge_data& jk, const Edge_data& ki) const
    {
      return internal::rounded_sqrt(squared_four_areas_from_lengths(FT(Numbers::length(ij)), FT(Numbers::length(jk)),
                                                                    FT(Numbers::length(ki)))) /
             FT(4);
    }
  };
  /// gives the cotangent of the corner opposite to ij of that triangle.
  /// \pre the area is not zero
  struct Compute_cotangent
  {
    /// returns the cotangent.
    FT operator()(const Face_data& f, const Edge_data& ij, const Edge_data& jk, const Edge_data& ki) const
    {
      const Compute_squared_length squared;
      return twice_scalar_product(squared(jk), squared(ki), squared(ij)) / (FT(4) * Compute_area()(f, ij, jk, ki));
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

#endif // CGAL_INTRINSIC_TRIANGULATIONS_PTOLEMY_TRAITS_H
